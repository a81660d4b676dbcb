"""The edge of a region, traced through the cells that are open: where the depth of a place is zero.

The open cells are cut into triangles about their middles, so that neighbours of any sizes share their corners; the edge
enters and leaves each triangle once, where the depth changes its sign on two of its sides. The pieces are then halved
until they lie within the chord tolerance of the edge.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.results.stationary import bracketed
from linkwright.studies.workspace.cells import DEEPEST, Cells, cut_sides, key, known_corners, merge_cells
from linkwright.studies.workspace.curves import beside
from linkwright.studies.workspace.maps import crossings
from linkwright.studies.workspace.shapes import without_slivers

Array = NDArray[np.float64]
Rows = NDArray[np.intp]
Depth = Callable[[Array], Array]

NEAR = 1e-2
"""Places on the edge are found to this share of the chord tolerance."""
ROUNDS = 30
"""Pieces are halved at most so many times."""
WAYS = ((-0.03, 0.03), (-0.3, 0.3), (-0.9, 0.9))
"""The edge is looked for on the normal through a piece's middle, these shares of its length away."""
LOOKS = (0.5,), (0.25, 0.75)
"""Pieces are straight if the edge passes these shares of their lengths near by; the middle it may pass by accident."""
TURNS, CUTS = 5, 2
"""Around pieces that can't be followed cells are cut on so often, each time halved so many times, ..."""
LONG, SOME, AROUND, MOST = 8.0, 100, 3.0, 200
"""... if they are longer than so many chords, and no more than some; within so many lengths, and so many cells."""


def border(depth: Depth, cells: Cells, chord: float) -> tuple[Array, Array, Array]:
    """Pieces of the edge by their ends (2, n) both, and by how much (m) each may be off, (n,): 0 but for those that
    couldn't be followed. Around such pieces, as at sharp corners, the cells are cut on."""
    for turn in range(TURNS):
        a, b, lost = _traced(depth, cells, chord)
        long = np.hypot(*(b - a)) * lost
        if long.max(initial=0.0) <= LONG * chord or turn == TURNS - 1 or np.count_nonzero(long > LONG * chord) > SOME:
            break
        near = np.zeros(cells.level.size, dtype=bool)
        for k in np.argsort(-long)[: np.count_nonzero(long > LONG * chord)]:
            if np.count_nonzero(near) > MOST:
                break
            away = np.abs(cells.middle - (a[:, k] + b[:, k])[:, None] / 2).max(axis=0)
            near |= (away < AROUND * long[k] + cells.size) & (cells.size > long[k] / 8) & (cells.level < DEEPEST + 4)
        if not near.any():
            break
        parts = cells.subset(near)
        for _ in range(CUTS):
            parts = parts.quarters()
        cells = merge_cells([cells.subset(~near), parts])
    return a, b, long


def _traced(depth: Depth, cells: Cells, chord: float) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Pieces of the edge, and which of them couldn't be followed."""
    corners, triangles, cell = triangulated(cells)
    pairs, ends, of = crossings(triangles, np.where(depth(corners) > 0, 1.0, -1.0))
    ends = _join_through_cells(ends, cell[of], np.asarray(np.isin(pairs, triangles[:, 0]).any(axis=1)))
    used, ends = np.unique(ends, return_inverse=True)
    start, way = corners[:, pairs[used, 0]], corners[:, pairs[used, 1]] - corners[:, pairs[used, 0]]

    def along(share: Array, rows: Rows) -> Array:
        return depth(start[:, rows] + share * way[:, rows])

    count = used.size
    near = NEAR * chord / np.hypot(*way)
    share = bracketed(along, np.arange(count), np.zeros(count), np.ones(count), near=near)
    a, b = (start + share * way)[:, ends.reshape(-1, 2)].transpose(2, 0, 1)
    long = (a != b).any(axis=0)
    return halve_pieces(depth, a[:, long], b[:, long], chord)


def _join_through_cells(ends: Rows, cell: Rows, inner: NDArray[np.bool_]) -> Rows:
    """Pieces (n, 2) of lines by their ends, each in a cell (n,): one piece from side to side of each cell that one line
    passes, where ``inner`` says which ends lie within cells."""
    count = int(cell.max(initial=-1)) + 1
    outer = ~inner[ends]
    number = np.zeros(count, dtype=int)
    np.add.at(number, cell, outer.sum(axis=1))
    once = number[cell] == 2
    row, side = np.nonzero(outer & once[:, None])
    order = np.argsort(cell[row], kind="stable")
    return np.concatenate([ends[~once], ends[row, side][order].reshape(-1, 2)])


def halve_pieces(depth: Depth, a: Array, b: Array, chord: float) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Pieces halved until the middle of each way lies within ``chord`` (m) of its chord; which of them can't be."""
    done = [(a[:, :0], b[:, :0], np.empty(0, dtype=bool))]
    for turn in range(ROUNDS):
        if not a.shape[1]:
            break
        straight = _straight(depth, a, b, chord)
        done.append((a[:, straight], b[:, straight], np.zeros(int(straight.sum()), dtype=bool)))
        a, b = a[:, ~straight], b[:, ~straight]
        middle, found = beside(depth, a, b, ways=WAYS, near=NEAR * chord)
        lost = ~found | (turn == ROUNDS - 1)
        done.append((a[:, lost], b[:, lost], np.ones(int(lost.sum()), dtype=bool)))
        a, b = (
            np.concatenate([a[:, ~lost], middle[:, ~lost]], axis=1),
            np.concatenate([middle[:, ~lost], b[:, ~lost]], axis=1),
        )
    first, last, lost = (np.concatenate(part, axis=-1) for part in zip(*done, strict=True))
    return first, last, lost


def _straight(depth: Depth, a: Array, b: Array, near: float) -> NDArray[np.bool_]:
    """Whether the edge passes pieces at less than ``near`` (m) to either side, or they are as short."""
    way = b - a
    length = np.hypot(*way)
    across = near * np.stack([-way[1], way[0]]) / length
    found = np.ones(length.size, dtype=bool)
    for shares in LOOKS:
        rest = np.flatnonzero(found & (length > near))
        for share in shares:
            at, aside = a[:, rest] + share * way[:, rest], across[:, rest]
            found[rest] &= (depth(at + aside) > 0) != (depth(at - aside) > 0)
    return found


def triangulated(cells: Cells) -> tuple[Array, Rows, Rows]:
    """Corners (2, n) and triangles (triangles, 3) of cells, and the cell of each (triangles,): each about its middle,
    which comes first, its sides cut at all corners of its neighbours."""
    deepest = int(cells.level.max(initial=0)) + 1
    first, last, cell, _ = cut_sides(cells, deepest, known_corners(cells, deepest))
    unit = 2 ** (deepest - cells.level)
    centre = (cells.number * unit + unit // 2)[:, cell]
    every = np.stack([key(centre), key(first), key(last)], axis=1)
    keys, triangles = np.unique(every, return_inverse=True)
    corner = cells.corner[:, None] + np.stack([keys >> 32, keys & 0xFFFFFFFF]) * (cells.side / 2.0**deepest)
    return corner, triangles.reshape(every.shape), cell


def polygons(depth: Depth, a: Array, b: Array, chord: float) -> Any:
    """The region inside of an edge given by its pieces: a Shapely polygon or several. What is narrower than a few
    chords is left out: there pieces cross."""
    import shapely

    lines = shapely.linestrings(np.stack([a, b]).transpose(2, 0, 1))
    faces, *wrong = shapely.polygonize_full(lines)
    if all(shapely.is_empty(part) for part in wrong):
        with contextlib.suppress(shapely.GEOSException):  # faces that overlap, as their sides cross
            return _reached(depth, faces, chord)
    return _reached(depth, _noded(lines), chord)


def _noded(lines: Any) -> Any:
    """The faces between lines that cross."""
    import shapely

    return shapely.polygonize(shapely.get_parts(shapely.unary_union(lines)))


def _reached(depth: Depth, faces: Any, chord: float) -> Any:
    """The faces that are reached, together."""
    import shapely

    every = shapely.get_parts(faces)
    if not len(every):
        return shapely.Polygon()
    shape = shapely.simplify(shapely.union_all(every[depth(_deep(every)) > 0]), chord)
    return without_slivers(shape, chord)


def _deep(faces: Any) -> Array:
    """A place deep in each polygon, (2, n): not in a crevice that chords have closed. One without holes
    holds a circle whose radius is its area over its perimeter (Bonnesen); these places are half as far from its edge.
    """
    import shapely

    within = shapely.buffer(faces, -shapely.area(faces) / (2 * shapely.length(faces)), quad_segs=1)
    middles = shapely.point_on_surface(np.where(shapely.is_empty(within), faces, within))
    return np.asarray(shapely.get_coordinates(middles).T)
