"""The part of the drives' plane in which a mode can be assembled, as triangles with exact corners on its rim."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

RIM = 1e-14
"""The reach at which the rim is drawn, just inside where two modes meet: its root is 1e-7 of the group's size."""
HALVINGS = 60
SKEW = (0.7548776662, 0.5698402910)
CLEAR = 1e-3
"""A reach above this is far from the rim."""
SMALL, MET = 0.2, 1e-14
"""Where a pit may be near, and where it is: the closure's determinant squared, over the reach."""
LOOKS = 100
POLISH = (1e-3, 1e-4, 1e-5)
"""Then by parabolas through places so far apart, a share of the ranges."""
WAYS = np.array([[i, k] for i in (-1.0, 0.0, 1.0) for k in (-1.0, 0.0, 1.0) if (i, k) != (0.0, 0.0)])
AROUND = 1.5
"""Around a pit the mesh is finer within so many steps ..."""
NARROW = 2e-7
"""... halved until they are no wider than this (rad, m), far over what a pit's place isn't known by."""


@dataclass(frozen=True)
class DriveBox:
    """The ranges of both drives, SI; ``turns`` says of which the range is a whole turn, so that its ends are one."""

    low: tuple[float, float]
    high: tuple[float, float]
    turns: tuple[bool, bool] = (False, False)

    @property
    def size(self) -> Array:
        """Their widths: (2,)."""
        return np.subtract(self.high, self.low)

    def wrapped(self, q: Array) -> Array:
        """Drive values, (2,) or (2, n), whole turns within the ranges."""
        shape = (2,) + (1,) * (q.ndim - 1)
        low, turns = np.reshape(self.low, shape), np.reshape(self.turns, shape)
        return np.where(turns, low + (q - low) % (2 * np.pi), q)

    def askew(self) -> DriveBox:
        """The same ranges, whole turns begun elsewhere: a curve along a round angle is on no line of a mesh."""
        start = [low + SKEW[k] * self.turns[k] for k, low in enumerate(self.low)]
        stop = [high + SKEW[k] * self.turns[k] for k, high in enumerate(self.high)]
        return DriveBox((start[0], start[1]), (stop[0], stop[1]), self.turns)


@dataclass(frozen=True)
class Mesh:
    """``q`` (2, corners) are drive values, ``triangles`` (triangles, 3) corners of each; ``rim`` (segments, 2) are
    pairs of corners on the rim, where two modes meet, ``limit`` such on the end of a drive's range, ``pits`` such
    around places where the two outer pins of a group meet."""

    q: Array
    triangles: Rows
    rim: Rows
    limit: Rows
    pits: Rows


def mesh(sheet: ModeSheet, box: DriveBox, steps: int, pits: Array | None = None) -> Mesh:
    """The mesh on ``steps`` equal steps of each drive, cut at the rim; ``pits`` (2, n) are places where two pins meet
    (see :func:`found_pits`), around which it becomes finer and finer."""
    step = box.size[:, None] / steps
    centres = np.empty((2, 0)) if pits is None else pits
    axes = [np.linspace(a, b, steps + 1) for a, b in zip(box.low, box.high, strict=True)]
    q = np.stack(np.meshgrid(*axes, indexing="ij")).reshape(2, -1)
    squares = halves(steps + 1, steps + 1)

    def away(q: Array) -> Array:
        """How far places are from the nearest pit, in steps."""
        far = np.full(q.shape[1], np.inf)
        for centre in centres.T:
            far = np.minimum(far, np.hypot(*((q - centre[:, None]) / step)))
        return far

    def inside(q: Array) -> NDArray[np.bool_]:
        return (sheet.place(q)[1] > RIM) & (away(q) > AROUND)

    q, triangles, rim = cut_triangles(inside, q, squares)
    limit = _limits(q, triangles, box)
    ring = (np.abs(away(q) - AROUND) < 1e-6)[rim].all(axis=1) if centres.size else np.zeros(len(rim), dtype=bool)
    q, inner, ends = _pitted(q, rim[ring], centres, step)
    return Mesh(q, np.concatenate([triangles, inner]), rim[~ring], limit, ends)


def halves(rows: int, columns: int) -> Rows:
    """The triangles of a grid's squares, two each, by the numbers of its corners."""
    corner = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]))
    return np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def sides_of(triangles: Rows) -> Rows:
    """The three sides of each triangle: all first ones, all second ones, all third ones."""
    return np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])


def numbered(sides: Rows) -> tuple[Rows, Rows]:
    """The different ones of sides (n, 2), the lower corner first, and which of them each is: (n,)."""
    size = int(sides.max(initial=0)) + 1
    number, which = np.unique(sides.min(axis=1) * size + sides.max(axis=1), return_inverse=True)
    return np.stack(np.divmod(number, size), axis=1), which.ravel()


def _pitted(q: Array, ring: Rows, centres: Array, step: Array) -> tuple[Array, Rows, Rows]:
    """Rings around pits, each half as wide as the one before, down to a share of a step that is round-off."""
    used, own = np.unique(ring, return_inverse=True)
    edges = own.reshape(ring.shape)
    if not used.size:
        return q, np.empty((0, 3), dtype=np.intp), ring
    here = q[:, used]
    nearest = np.argmin([np.hypot(*((here - centre[:, None]) / step)) for centre in centres.T], axis=0)
    arms = here - centres[:, nearest]
    rows, made, corners = used, [], [q]
    for level in range(1, int(np.ceil(np.log2(AROUND * step.max() / NARROW))) + 1):
        inner = sum(part.shape[1] for part in corners) + np.arange(used.size)
        corners.append(centres[:, nearest] + arms * 0.5**level)
        (a, b), (c, d) = rows[edges].T, inner[edges].T
        made += [np.stack([a, b, d], 1), np.stack([a, d, c], 1)]
        rows = inner
    return np.concatenate(corners, axis=1), np.concatenate(made), rows[edges]


def found_pits(sheet: ModeSheet, box: DriveBox, steps: int = 48) -> Array:
    """The places in the drives' plane where the two outer pins of a group meet, so that its links may point anywhere:
    (2, n). The closure's determinant is zero there, though the group could reach farther."""
    axes = [np.linspace(a, b, steps + 1) for a, b in zip(box.low, box.high, strict=True)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"))

    def small(q: Array) -> Array:
        """The closure's determinant over what it is near the rim, squared."""
        here = sheet.look(q)
        with np.errstate(all="ignore"):
            return np.where(here.reach > CLEAR, here.closure**2 / here.reach, np.inf)

    size = np.nan_to_num(small(grid.reshape(2, -1)), nan=np.inf).reshape(steps + 1, -1)
    padded = np.pad(size, 1, constant_values=np.inf)
    around = [padded[i : i + steps + 1, k : k + steps + 1] for i in range(3) for k in range(3) if (i, k) != (1, 1)]
    q = grid[:, (size <= np.min(around, axis=0)) & (size < SMALL)]
    best, step = small(q), np.repeat(box.size[:, None] / steps, q.shape[1], axis=1)
    ways = WAYS.T[:, :, None]
    for _ in range(LOOKS if q.size else 0):
        tried = q[:, None] + step[:, None] * ways
        values = small(tried.reshape(2, -1)).reshape(len(WAYS), -1)
        which = values.argmin(axis=0)
        better = values.min(axis=0) < best
        q = np.where(better, tried[:, which, np.arange(which.size)], q)
        best, step = np.minimum(best, values.min(axis=0)), np.where(better, step, step / 2)
    for h in POLISH if q.size else ():
        q = q + h * box.size[:, None] * _lowest(
            best, small((q[:, None] + h * box.size[:, None, None] * ways).reshape(2, -1))
        )
        best = small(q)
    low, turns = np.array(box.low), np.array(box.turns)
    q = np.where(turns[:, None], low[:, None] + np.mod(q - low[:, None], 2 * np.pi), q)
    found: list[Array] = []
    for place in q.T[best < MET]:
        if all(np.abs(place - one).max() > 1e-6 for one in found):
            found.append(place)
    return np.array(found).reshape(-1, 2).T


def _lowest(here: Array, around: Array) -> Array:
    """Where a function is least, (2, n), by the parabolas through its values at places (n,) and one step along all
    :data:`WAYS` (8 n,); in steps, no more than three."""
    v = around.reshape(len(WAYS), -1)
    with np.errstate(all="ignore"):  # infinite where the groups can't be assembled: no step there
        gx, gy = (v[6] - v[1]) / 2, (v[4] - v[3]) / 2
        hxx, hyy, hxy = v[6] + v[1] - 2 * here, v[4] + v[3] - 2 * here, (v[7] + v[0] - v[5] - v[2]) / 4
        found = np.stack([hxy * gy - hyy * gx, hxy * gx - hxx * gy]) / (hxx * hyy - hxy * hxy)
    return np.asarray(np.clip(np.nan_to_num(found, posinf=0.0, neginf=0.0), -3.0, 3.0))


def cut_triangles(within: Callable[[Array], NDArray[np.bool_]], q: Array, triangles: Rows) -> tuple[Array, Rows, Rows]:
    """The parts of triangles inside, with new corners on the rim."""
    inside = within(q)
    count = inside[triangles].sum(axis=1)
    whole, partly = triangles[count == 3], triangles[(count > 0) & (count < 3)]
    edges = sides_of(partly)
    crossed = inside[edges[:, 0]] != inside[edges[:, 1]]
    pairs, where = numbered(edges[crossed])
    kept = inside[pairs]
    a = q[:, np.where(kept[:, 0], pairs[:, 0], pairs[:, 1])]
    b = q[:, np.where(kept[:, 0], pairs[:, 1], pairs[:, 0])]
    share = halved(lambda s: within(a + s * (b - a)), len(pairs))
    corners = np.concatenate([q, a + share * (b - a)], axis=1)
    new = np.full(len(edges), -1)
    new[crossed] = q.shape[1] + where
    sides = new.reshape(3, -1).T
    made, rim = [whole], []
    for k in range(3):
        one = (inside[partly[:, k]]) & (inside[partly].sum(axis=1) == 1)
        near, far = sides[one, k], sides[one, (k + 2) % 3]
        made.append(np.stack([partly[one, k], near, far], 1))
        rim.append(np.stack([near, far], 1))
        two = (~inside[partly[:, k]]) & (inside[partly].sum(axis=1) == 2)
        first, last = sides[two, k], sides[two, (k + 2) % 3]
        after, before = partly[two, (k + 1) % 3], partly[two, (k + 2) % 3]
        made += [np.stack([first, after, before], 1), np.stack([first, before, last], 1)]
        rim.append(np.stack([first, last], 1))
    return corners, np.concatenate(made), np.concatenate(rim)


def _limits(q: Array, triangles: Rows, box: DriveBox) -> Rows:
    """The sides of triangles that lie on the end of a drive's range."""
    found = [np.empty((0, 2), dtype=np.intp)]
    if all(box.turns):
        return found[0]
    sides = np.sort(sides_of(triangles), axis=1)
    for k in (0, 1):
        ends = () if box.turns[k] else (box.low[k], box.high[k])
        found += [sides[(q[k][sides] == end).all(axis=1)] for end in ends]
    return np.unique(np.concatenate(found), axis=0)


def halved(holds: Callable[[Array], NDArray[np.bool_]], count: int, times: int = HALVINGS) -> Array:
    """The largest shares in 0 .. 1 at which something holds that does at 0 and doesn't at 1: (count,)."""
    low, high = np.zeros(count), np.ones(count)
    for _ in range(times if count else 0):
        middle = (low + high) / 2
        yes = holds(middle)
        low, high = np.where(yes, middle, low), np.where(yes, high, middle)
    return low
