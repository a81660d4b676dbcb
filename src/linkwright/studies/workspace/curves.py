"""The curves that can bound a workspace, in the plane of the drives' values and as paths of the working point.

There are three kinds: places where the jacobian d(x, y)/d(drives) is singular, places where two assembly modes meet
(the rim of a sheet), and the ends of the drives' ranges. Curves are located on the triangles of a mesh by sign changes
(marching triangles); then their pieces are halved until the path of each lies within a chord tolerance.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.results.stationary import bracketed
from linkwright.studies.workspace.mesh import HALVINGS, RIM, Mesh, halved, numbered, sides_of
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Rows = NDArray[np.intp]
Mask = NDArray[np.bool_]
Ends = tuple[Array, Array]
Traced = Mapping[str, Ends]

ROUNDS = 24
"""Segments are halved at most so many times."""
EVEN = 0.05
"""The middle of a segment's path is no nearer to either end than this share of its chord, or it says little of the way
between."""
CLOSE, ROUGH = 1e-14, 1e-3
"""Zeros are found to the first share of the drives' values, and to the second of where they are looked for."""
WAY = 0.5
"""The rim is looked for no further beside a segment than this share of its length ..."""
RINGS = (2, 3, 4)
MEET = 1e-9
"""Ends of pieces that are nearer than this share of the drives' ranges are one."""
TURNED = 36
"""Where the singular curve ends on the rim is found by so many halvings of a mesh's segment."""
SHORT = 1e-7
"""A piece no longer than this (rad, m) needn't follow the curve."""
LEVELS, MOST = 10, 200_000
"""Triangles are cut into sixteen at most so many times, and no more of them than that; nor are more pieces halved."""
WAYS = ((-0.03, 0.03), (-0.3, 0.3))
"""... and a curve beside its middle these shares of it."""


@dataclass(frozen=True)
class Segments:
    """Pieces of one kind of curve: drive values at the ends of each, (2, segments) both, and how far a piece may lie
    off the true path where it couldn't be refined (m), 0 where it could: (segments,)."""

    kind: str
    a: Array
    b: Array
    off: Array

    def within(self, most: float) -> Segments:
        """The pieces that may be off by no more than ``most`` (m)."""
        near = self.off <= most
        return Segments(self.kind, self.a[:, near], self.b[:, near], self.off[near])


def curves(sheet: ModeSheet, mesh: Mesh, chord: float) -> list[Segments]:
    """All of a sheet's curves, their paths' chords within ``chord`` (m)."""
    return smooth(sheet, traced(sheet, mesh), chord)


def traced(sheet: ModeSheet, mesh: Mesh, levels: int = LEVELS, rings: Sequence[int] = RINGS) -> Traced:
    """All of a sheet's curves by their kinds: pieces as a mesh has them, the singular curve's one in each triangle that
    it passes. Those of the other kinds are cut where it meets them. With fewer ``levels`` of finer triangles, pieces
    near places where it crosses itself may lead astray."""
    # Sort the pairs of corners, so that an edge of the mesh has one name only.
    rim, pits, limit = (np.sort(pairs, axis=1) for pairs in (mesh.rim, mesh.pits, mesh.limit))
    straight = np.concatenate([pits, limit])
    # Retry with a wider neighbourhood of finer triangles until the singular curve has no loose ends.
    for around in rings:
        cuts: dict[tuple[int, int], Array] = {}
        pieces = _passing(sheet, mesh.q, mesh.triangles, (rim, straight), cuts, around, levels)
        if levels < LEVELS or not _loose(sheet, mesh, *pieces):
            break
    others = {"modes": rim, "pins": pits, "limit": limit}
    return {"singular": pieces} | {kind: _stopped(mesh.q, pairs, cuts) for kind, pairs in others.items()}


def smooth(sheet: ModeSheet, pieces: Traced, chord: float) -> list[Segments]:
    """Curves refined until their paths' chords are within ``chord`` (m)."""
    zero = {"singular": lambda q: sheet.look(q).numerator, "modes": lambda q: sheet.place(q)[1] - RIM}
    return [refined(sheet, kind, ends, chord, zero.get(kind)) for kind, ends in pieces.items()]


def _stopped(q: Array, pairs: Rows, cuts: Mapping[tuple[int, int], Array]) -> Ends:
    """Pieces between pairs of corners, with a stop where there is a cut."""
    starts, ends = [], []
    for first, last in pairs.tolist():
        middle = cuts.get((first, last))
        stops = [q[:, first], *([] if middle is None else [middle]), q[:, last]]
        starts += stops[:-1]
        ends += stops[1:]
    return np.array(starts).reshape(-1, 2).T, np.array(ends).reshape(-1, 2).T


def _passing(
    sheet: ModeSheet,
    q: Array,
    triangles: Rows,
    border: tuple[Rows, Rows],
    cuts: dict[tuple[int, int], Array],
    rings: int,
    levels: int,
) -> tuple[Array, Array]:
    """One piece of the singular curve in each triangle that it passes, its ends on the sides; ``cuts`` takes those on
    the rim. Where a piece doesn't follow the curve, as where two branches cross, the triangles around are cut into
    sixteen each."""
    # Marching triangles: a triangle is passed where the numerator of the determinant changes sign among its corners.
    numerator = sheet.look(q).numerator
    # A triangle beside the rim may bulge beyond it, so that a quarter of it lies outside.
    triangles = triangles[np.isfinite(numerator)[triangles].all(axis=1)]
    positive = numerator >= 0
    passed = np.flatnonzero(positive[triangles].any(axis=1) & ~positive[triangles].all(axis=1))
    sides = sides_of(triangles[passed])
    crossed = positive[sides[:, 0]] != positive[sides[:, 1]]
    # Each crossed side once, though two triangles share it; locate the zero on it by root finding.
    pairs, where = numbered(sides[crossed])
    rim, pits = border
    on_rim, on_pit = _among(pairs, rim), _among(pairs, pits)
    places = np.empty((2, len(pairs)))
    a, b = q[:, pairs[:, 0]], q[:, pairs[:, 1]]
    places[:, ~on_rim] = _zeros(sheet, a[:, ~on_rim], b[:, ~on_rim])
    if on_rim.any():
        # On the rim (two modes meet) the side is curved: search along the rim itself.
        path = _along_rim(sheet, a[:, on_rim], b[:, on_rim])
        places[:, on_rim] = path(_turning(sheet, path, positive[pairs[on_rim, 0]]))
    # Remember the crossings on the border: curves of other kinds are cut there.
    stops = on_rim | on_pit
    cuts |= {(i, k): place for (i, k), place in zip(pairs[stops].tolist(), places[:, stops].T, strict=True)}
    # Two of the three sides of a passed triangle are crossed; join their crossings to one piece.
    at = np.full(len(sides), -1)
    at[crossed] = where
    two = np.sort(at.reshape(3, -1), axis=0)[1:]
    a, b = places[:, two[0]], places[:, two[1]]
    # Check that each piece follows the curve; where it does not, refine the triangles around it and recurse.
    long = np.abs(a - b).max(axis=0) > SHORT
    astray = passed[long & ~_can_be_halved(sheet, a, b)] if levels and len(triangles) < MOST else passed[:0]
    if not astray.size:
        return a, b
    held = np.isin(triangles, np.unique(np.concatenate(border))).any(axis=1)
    around = np.zeros(len(triangles), dtype=bool)
    around[astray] = True
    for _ in range(rings):
        around |= np.isin(triangles, np.unique(triangles[around])).any(axis=1)
    around &= ~held
    kept = ~around[passed]
    corners, parts = _quartered(*_quartered(q, triangles[around]))
    inner = _passing(sheet, corners, parts, (rim[:0], rim[:0]), cuts, rings, levels - 1)
    return np.concatenate([a[:, kept], inner[0]], axis=1), np.concatenate([b[:, kept], inner[1]], axis=1)


def _loose(sheet: ModeSheet, mesh: Mesh, a: Array, b: Array) -> bool:
    """Whether some piece of the singular curve ends where no other begins, not on the rim nor on the mesh's border."""
    from scipy.spatial import cKDTree

    low, high = mesh.q.min(axis=1, keepdims=True), mesh.q.max(axis=1, keepdims=True)
    ends = np.concatenate([a, b], axis=1)
    # Scale the drives' plane to the unit square and ignore ends on its border, on the rim and near pits.
    scaled = (ends - low) / (high - low)
    inner = ((scaled > MEET) & (scaled < 1 - MEET)).all(axis=0) & (sheet.place(ends)[1] > 4 * RIM)
    if mesh.pits.size:
        inner &= cKDTree(mesh.q[:, np.unique(mesh.pits)].T).query(ends.T)[0] > 1e-7
    places = scaled[:, inner].T
    # Inside, an even number of ends must meet at each place.
    count = cKDTree(places).query_ball_point(places, MEET, return_length=True) if len(places) else np.empty(0)
    return bool((count % 2).any())


def _can_be_halved(sheet: ModeSheet, a: Array, b: Array) -> Mask:
    """Whether pieces of the singular curve can be halved twice."""

    def f(q: Array) -> Array:
        return sheet.look(q).numerator

    middle, found = beside(f, a, b, rough=True)
    halves = np.concatenate([a, middle], axis=1), np.concatenate([middle, b], axis=1)
    return np.asarray(found & beside(f, *halves, rough=True)[1].reshape(2, -1).all(axis=0))


def _turning(sheet: ModeSheet, path: Callable[..., Array], sign: Mask) -> Array:
    """The shares of paths up to which the numerator has its first sign."""
    return halved(lambda share: (sheet.look(path(share, TURNED)).numerator >= 0) == sign, sign.size, TURNED)


def _zeros(sheet: ModeSheet, a: Array, b: Array) -> Array:
    """The places (2, n) between a and b at which the numerator, of opposite signs there, changes it."""

    def f(share: Array, rows: Rows) -> Array:
        return np.nan_to_num(sheet.look(a[:, rows] + share * (b - a)[:, rows]).numerator, nan=-np.inf)

    rows, whole = np.arange(a.shape[1]), np.ones(a.shape[1])
    return a + bracketed(f, rows, 0 * whole, whole, near=_near(a, b - a)) * (b - a)


def _near(q: Array, way: Array) -> Array:
    """How exactly a share of a way from a place is worth knowing."""
    return np.asarray(np.minimum(CLOSE * np.abs(q).max(axis=0) / np.abs(way).max(axis=0), ROUGH))


def _quartered(q: Array, triangles: Rows) -> tuple[Array, Rows]:
    """Triangles cut into four each by the middles of their sides."""
    pairs, where = numbered(sides_of(triangles))
    x, y, z = q.shape[1] + where.reshape(3, -1)
    a, b, c = triangles.T
    corners = np.concatenate([q, q[:, pairs].mean(axis=2)], axis=1)
    made = np.concatenate([np.stack(three, 1) for three in ((a, x, z), (x, b, y), (z, y, c), (x, y, z))])
    used, own = np.unique(made, return_inverse=True)
    return corners[:, used], own.reshape(made.shape)


def _among(pairs: Rows, known: Rows) -> Mask:
    size = int(max(pairs.max(initial=0), known.max(initial=0))) + 1
    return np.isin(pairs[:, 0] * size + pairs[:, 1], known[:, 0] * size + known[:, 1])


def _along_rim(sheet: ModeSheet, a: Array, b: Array) -> Callable[..., Array]:
    """The rim between two places on it: from the chord across to where the reach is that of the rim."""
    # Unit direction across the chord; the rim lies a little to one side of it.
    across = np.stack([a[1] - b[1], b[0] - a[0]])

    def path(share: Array, times: int = HALVINGS) -> Array:
        q = a + share * (b - a)
        found = q.copy()
        inside = sheet.place(q)[1] > RIM
        # Look on which side the reach passes the value of the rim, and halve down to it there.
        for side in (1.0, -1.0):
            beyond = sheet.place(q + side * WAY * across)[1] > RIM
            turned = (beyond != inside) & (found == q).all(axis=0)
            if turned.any():
                step = side * WAY * across[:, turned]
                found[:, turned] = _to_rim(sheet, q[:, turned], step, inside[turned], times)
        return found

    return path


def _to_rim(sheet: ModeSheet, start: Array, step: Array, inside: Mask, times: int) -> Array:
    """The places on the rim between start and start + step, just inside, by so many halvings."""
    at = halved(lambda share: (sheet.place(start + share * step)[1] > RIM) == inside, inside.size, times)
    return np.asarray(start + np.where(inside, at, at + 2.0**-times) * step)


def refined(sheet: ModeSheet, kind: str, ends: Ends, chord: float, f: Callable[[Array], Array] | None) -> Segments:
    """Segments halved until the middle of each path lies within ``chord`` of its chord; the curve is where ``f`` is 0,
    or straight in the drives' plane."""
    a, b = ends
    done: list[tuple[Array, Array, Array]] = []
    # Each round halves all pieces whose path is not yet close enough to its chord.
    pa, pb = sheet.place(a)[0], sheet.place(b)[0]
    for _ in range(ROUNDS):
        if not a.shape[1] or a.shape[1] > MOST:
            break
        middle, found = ((a + b) / 2, np.full(a.shape[1], True)) if f is None else beside(f, a, b)
        pm = sheet.place(middle)[0]
        found &= np.isfinite(pm).all(axis=0)
        # Accept where the middle lies close to the chord and about halfway; also confirm the middles of both halves.
        off = distance(pm, pa, pb)
        shorter = np.minimum(np.hypot(*(pm - pa)), np.hypot(*(pb - pm)))
        fine = ~found | ((off <= chord) & (shorter >= EVEN * np.hypot(*(pb - pa)) - chord))
        some = found & fine
        fine[some] = _halves(sheet, f, a[:, some], middle[:, some], b[:, some], chord)
        done.append((a[:, fine], b[:, fine], np.where(found[fine], 0.0, np.hypot(*(pb - pa)[:, fine]))))
        rest = ~fine
        a, b = np.concatenate([a[:, rest], middle[:, rest]], 1), np.concatenate([middle[:, rest], b[:, rest]], 1)
        pa, pb = np.concatenate([pa[:, rest], pm[:, rest]], 1), np.concatenate([pm[:, rest], pb[:, rest]], 1)
    if a.shape[1]:
        done.append((a, b, np.hypot(*(pb - pa))))
    if not done:
        return Segments(kind, a, b, np.empty(0))
    return Segments(kind, *(np.concatenate(parts, axis=-1) for parts in zip(*done, strict=True)))


def _halves(
    sheet: ModeSheet, f: Callable[[Array], Array] | None, a: Array, middle: Array, b: Array, chord: float
) -> Mask:
    """Whether the middles of both halves of segments' paths lie within ``chord`` too: a segment that leads from curve
    to curve may pass the middle of its path by accident."""
    first, last = np.concatenate([a, middle], axis=1), np.concatenate([middle, b], axis=1)
    between, found = ((first + last) / 2, True) if f is None else beside(f, first, last)
    pa, pb = (np.tile(sheet.place(q)[0], 2) for q in (a, b))
    return np.asarray((found & (distance(sheet.place(between)[0], pa, pb) <= chord)).reshape(2, -1).all(axis=0))


def beside(
    f: Callable[[Array], Array],
    a: Array,
    b: Array,
    rough: bool = False,
    ways: Sequence[tuple[float, float]] = WAYS,
    near: float | None = None,
) -> tuple[Array, Mask]:
    """The zeros of f on the normals through the middles of segments (``rough``: where a line through two places has
    it); whether there is one nearby."""
    middle, across = (a + b) / 2, np.stack([a[1] - b[1], b[0] - a[0]])

    def across_at(share: Array, rows: Rows) -> Array:
        return f(middle[:, rows] + share * across[:, rows])

    every = np.arange(a.shape[1])
    # The value at the middle; then look to both sides at growing distances for one of opposite sign.
    here = f(middle)
    share, found, end = np.zeros(every.size), here == 0, np.zeros(every.size)
    for both in ways:
        rest = every[~found]
        there = across_at(np.repeat(both, rest.size), np.tile(rest, 2)).reshape(2, -1)
        for way, value in zip(both, there, strict=True):
            fresh = ~found[rest] & (np.sign(here[rest]) * np.sign(value) < 0)
            some, own = rest[fresh], here[rest[fresh]]
            with np.errstate(all="ignore"):  # infinite where nothing is known
                # First guess by linear interpolation between both values.
                ratio = np.nan_to_num(own / (own - value[fresh]), nan=0.5)
            share[some], end[some], found[some] = way * ratio, way, True
    some = np.flatnonzero(end)
    if not rough and some.size:
        # Unless a rough place is enough, locate the zero between them by bracketing.
        low, high = np.minimum(end[some], 0.0), np.maximum(end[some], 0.0)
        way = end[some] * across[:, some]
        close = _near(middle[:, some], way) if near is None else near / np.hypot(*way)
        share[some] = bracketed(across_at, some, low, high, (share[some] - low) / (high - low), close)
    return middle + share * across, found


def distance(p: Array, a: Array, b: Array) -> Array:
    """How far points are from the segments a .. b; all (2, ...)."""
    d, r = b - a, p - a
    square = (d * d).sum(axis=0)
    with np.errstate(all="ignore"):
        share = np.clip(np.where(square > 0, (d * r).sum(axis=0) / square, 0.0), 0.0, 1.0)
    return np.asarray(np.hypot(*(r - share * d)))
