"""The part of the drives' plane in which a mode can be assembled, as triangles with exact corners on its rim."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.studies.workspace.sheet import Sheet

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

RIM = 1e-14
"""The reach at which the rim is drawn, just inside where two modes meet: its root is 1e-7 of the group's size."""
HALVINGS = 60


@dataclass(frozen=True)
class Box:
    """The ranges of both drives, SI; ``turns`` says of which the range is a whole turn, so that its ends are one."""

    low: tuple[float, float]
    high: tuple[float, float]
    turns: tuple[bool, bool] = (False, False)

    @property
    def size(self) -> Array:
        """Their widths: (2,)."""
        return np.subtract(self.high, self.low)


@dataclass(frozen=True)
class Mesh:
    """``q`` (2, corners) are drive values, ``triangles`` (triangles, 3) corners of each; ``rim`` (segments, 2) are
    pairs of corners on the rim, where two modes meet, ``limit`` such on the end of a drive's range."""

    q: Array
    triangles: Rows
    rim: Rows
    limit: Rows


def mesh(sheet: Sheet, box: Box, steps: int) -> Mesh:
    """The mesh on ``steps`` equal steps of each drive, cut at the rim."""
    axes = [np.linspace(a, b, steps + 1) for a, b in zip(box.low, box.high, strict=True)]
    q = np.stack(np.meshgrid(*axes, indexing="ij")).reshape(2, -1)
    corner = np.arange((steps + 1) ** 2).reshape(steps + 1, -1)
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]))
    squares = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    inside = sheet.place(q)[1] > RIM
    q, triangles, rim = _cut(sheet, q, squares, inside)
    return Mesh(q, triangles, rim, _limits(q, triangles, rim, box))


def _cut(sheet: Sheet, q: Array, triangles: Rows, inside: NDArray[np.bool_]) -> tuple[Array, Rows, Rows]:
    """The parts of triangles inside, with new corners on the rim."""
    count = inside[triangles].sum(axis=1)
    whole, partly = triangles[count == 3], triangles[(count > 0) & (count < 3)]
    edges = np.concatenate([partly[:, [0, 1]], partly[:, [1, 2]], partly[:, [2, 0]]])
    crossed = inside[edges[:, 0]] != inside[edges[:, 1]]
    pairs, where = np.unique(np.sort(edges[crossed], axis=1), axis=0, return_inverse=True)
    kept = inside[pairs]
    a = q[:, np.where(kept[:, 0], pairs[:, 0], pairs[:, 1])]
    b = q[:, np.where(kept[:, 0], pairs[:, 1], pairs[:, 0])]
    share = halved(lambda s: sheet.place(a + s * (b - a))[1] > RIM, len(pairs))
    corners = np.concatenate([q, a + share * (b - a)], axis=1)
    new = np.full(len(edges), -1)
    new[crossed] = q.shape[1] + where.ravel()
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


def _limits(q: Array, triangles: Rows, rim: Rows, box: Box) -> Rows:
    """The sides of triangles that lie on the end of a drive's range."""
    sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    found = [np.empty((0, 2), dtype=np.intp)]
    for k in (0, 1):
        ends = () if box.turns[k] else (box.low[k], box.high[k])
        found += [sides[(q[k][sides] == end).all(axis=1)] for end in ends]
    return np.unique(np.concatenate(found), axis=0)


def halved(holds: Callable[[Array], NDArray[np.bool_]], count: int) -> Array:
    """The largest shares in 0 .. 1 at which something holds that does at 0 and doesn't at 1: (count,)."""
    low, high = np.zeros(count), np.ones(count)
    for _ in range(HALVINGS if count else 0):
        middle = (low + high) / 2
        yes = holds(middle)
        low, high = np.where(yes, middle, low), np.where(yes, high, middle)
    return low
