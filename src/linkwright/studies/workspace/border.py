"""The edge of a region, traced through the cells that are open: where the depth of a place is zero.

The open cells are cut into triangles about their middles, so that neighbours of any sizes share their corners; the edge
enters and leaves each triangle once, where the depth changes its sign on two of its sides. The pieces are then halved
until they lie within the chord tolerance of the edge.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.results.stationary import bracketed
from linkwright.studies.workspace.cells import Cells, cut_sides, key, known_corners
from linkwright.studies.workspace.curves import beside, distance
from linkwright.studies.workspace.maps import crossings
from linkwright.studies.workspace.shapes import without_slivers

Array = NDArray[np.float64]
Rows = NDArray[np.intp]
Depth = Callable[[Array], Array]

NEAR = 1e-2
"""Places on the edge are found to this share of the chord tolerance."""
ROUNDS = 30
"""Pieces are halved at most so many times."""
WAYS = ((-0.03, 0.03), (-0.3, 0.3), (-1.5, 1.5))
"""The edge is looked for on the normal through a piece's middle, these shares of its length away."""
SHARE = 1e-6
"""Pieces shorter than this share of the chord tolerance are halved no more."""


def border(depth: Depth, cells: Cells, chord: float) -> tuple[Array, Array, float]:
    """Pieces of the edge by their ends (2, n) both, and by how much at most (m) one may be off that couldn't be
    followed: 0 where all could."""
    corners, triangles = triangulated(cells)
    values = depth(corners)
    pairs, ends = crossings(triangles, np.where(values > 0, 1.0, -1.0))
    start, way = corners[:, pairs[:, 0]], corners[:, pairs[:, 1]] - corners[:, pairs[:, 0]]

    def along(share: Array, rows: Rows) -> Array:
        return depth(start[:, rows] + share * way[:, rows])

    count = len(pairs)
    near = NEAR * chord / np.hypot(*way)
    share = bracketed(along, np.arange(count), np.zeros(count), np.ones(count), near=near)
    places = start + share * way
    return followed(depth, places[:, ends[:, 0]], places[:, ends[:, 1]], chord)


def followed(depth: Depth, a: Array, b: Array, chord: float) -> tuple[Array, Array, float]:
    """Pieces halved until the middle of each way lies within ``chord`` (m) of its chord."""
    done: list[tuple[Array, Array]] = []
    off = 0.0
    for turn in range(ROUNDS):
        if not a.shape[1]:
            break
        middle, found = beside(depth, a, b, ways=WAYS, near=NEAR * chord)
        away, long = distance(middle, a, b), np.hypot(*(b - a))
        fine = found & (away <= chord) & (turn > 0)
        lost = ~found | (long < SHARE * chord)
        if turn == ROUNDS - 1:
            lost = ~fine
        off = max(off, float(long[lost].max(initial=0.0)))
        rest = ~(fine | lost)
        done.append((a[:, ~rest], b[:, ~rest]))
        a, b = (
            np.concatenate([a[:, rest], middle[:, rest]], axis=1),
            np.concatenate([middle[:, rest], b[:, rest]], axis=1),
        )
    whole = [np.concatenate([a[:, :0], *part], axis=1) for part in zip(*done, strict=True)] if done else [a, b]
    return whole[0], whole[1], off


def triangulated(cells: Cells) -> tuple[Array, Rows]:
    """Corners (2, n) and triangles (triangles, 3) of cells: each about its middle, its sides cut at all corners of its
    neighbours."""
    deepest = int(cells.level.max(initial=0)) + 1
    first, last, cell, _ = cut_sides(cells, deepest, known_corners(cells, deepest))
    unit = 2 ** (deepest - cells.level)
    centre = (cells.number * unit + unit // 2)[:, cell]
    every = np.stack([key(centre), key(first), key(last)], axis=1)
    keys, triangles = np.unique(every, return_inverse=True)
    corner = cells.corner[:, None] + np.stack([keys >> 32, keys & 0xFFFFFFFF]) * (cells.side / 2.0**deepest)
    return corner, triangles.reshape(every.shape)


def polygons(depth: Depth, a: Array, b: Array, chord: float) -> Any:
    """The region inside of an edge given by its pieces: a Shapely polygon or several. What is narrower than a few
    chords is left out: there pieces cross."""
    import shapely

    lines = shapely.linestrings(np.stack([a, b]).transpose(2, 0, 1))
    faces, *wrong = shapely.polygonize_full(lines)
    if any(not shapely.is_empty(part) for part in wrong):
        faces = shapely.polygonize(shapely.get_parts(shapely.unary_union(lines)))
    faces = shapely.get_parts(faces)
    if not len(faces):
        return shapely.Polygon()
    middles = shapely.get_coordinates(shapely.point_on_surface(faces)).T
    shape = shapely.simplify(shapely.union_all(faces[depth(middles) > 0]), chord / 2)
    return without_slivers(shape, chord)
