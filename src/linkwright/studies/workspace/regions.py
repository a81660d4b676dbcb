"""The region that the working point of a sheet reaches: a polygon whose edges lie on the paths of the curves.

The paths cut the plane into faces. As the jacobian is regular away from them, all of a face is reached or none of it:
one place tells. Whether it is reached is found by Newton's method from the drive values that come nearest.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.studies.workspace.alike import alike
from linkwright.studies.workspace.curves import Segments, Traced, smooth, traced
from linkwright.studies.workspace.mesh import RIM, Box, Mesh, found_pits, mesh
from linkwright.studies.workspace.sheet import Sheet

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

SNAP = 1e-10
"""Ends of pieces nearer than this share of the extent are one."""
WELD = 1e-7
"""So are such of which one meets no other: the rim is drawn to this, and its places on both sides of a seam differ."""
SLIVER = 4.0
"""A face narrower than so many chords is a sliver."""
STARTS = 12
NEWTON = 40
DAMPS = np.array([1.0]), 3.0 ** -np.arange(1.0, 8.0)
"""Shares of a step of Newton's method: where the first brings it no nearer, the largest of the others that does."""
DONE = 1e-3
"""What misses by less than this share of what is near enough needn't come nearer."""
CLOSED = 1e-9
"""A place is reached when the working point comes within this share of the extent."""


@dataclass(frozen=True, eq=False)
class Region:
    """What one sheet reaches: ``shape`` is a Shapely polygon or several (m). ``segments`` are the curves that may bound
    it, ``steps`` those of the mesh, ``change`` of the area (share) when they were last doubled: at most so much where
    both meshes have the same curves, each then drawn within its chords."""

    sheet: Sheet
    box: Box
    shape: Any
    segments: tuple[Segments, ...]
    mesh: Mesh
    steps: int
    change: float


def region(
    sheet: Sheet,
    box: Box,
    chord: float,
    first: int = 96,
    most: int = 1536,
    close: float = 1e-6,
    quick: bool = True,
) -> Region:
    """The region of a sheet, on meshes that are doubled until its area changes by less than a share ``close``; if
    ``quick``, on the first two already where both have the same curves."""
    box, last, steps = box.askew(), None, first
    pits = found_pits(sheet, box)

    def filled(made: Mesh, pieces: Traced) -> tuple[Any, tuple[Segments, ...]]:
        segments = smooth(sheet, pieces, chord)
        return reached(sheet, box, made, segments, chord), tuple(segments)

    if quick and 2 * first <= most:
        rough, made = (mesh(sheet, box, n, pits) for n in (first, 2 * first))
        pieces = traced(sheet, made)
        if alike(traced(sheet, rough, levels=1), pieces, box.size / (2 * first)):
            shape, segments = filled(made, pieces)
            change = 2 * chord * shape.length / shape.area if shape.area else 0.0
            return Region(sheet, box, shape, segments, made, 2 * first, change)
    while True:
        made = mesh(sheet, box, steps, pits)
        shape, segments = filled(made, traced(sheet, made))
        area = float(shape.area)
        change = abs(area - last) / area if last is not None and area else np.inf
        if change <= close or 2 * steps > most or not area:
            return Region(sheet, box, shape, segments, made, steps, change)
        last, steps = area, 2 * steps


def reached(sheet: Sheet, box: Box, made: Mesh, segments: Sequence[Segments], chord: float) -> Any:
    """The faces between the curves' paths that are reached, together. Slivers between paths that are one but for their
    chords count as neither; the gaps that they leave are filled."""
    import shapely

    paths = [sheet.place(np.stack([one.a, one.b], axis=1).reshape(2, -1))[0].reshape(2, 2, -1) for one in segments]
    ends = np.concatenate(paths, axis=2)
    # A piece that ends a round-off beyond the rim has no place there.
    ends = ends[:, :, np.isfinite(ends).all(axis=(0, 1)) & (ends[:, 1] != ends[:, 0]).any(axis=0)]
    if not ends.size or not made.q.size:
        return shapely.Polygon()
    size = float(np.ptp(ends, axis=(1, 2)).max())
    ends = _welded(ends, size)
    lines = shapely.linestrings(np.moveaxis(ends, (0, 1, 2), (2, 1, 0)))
    chains = shapely.line_merge(shapely.multilinestrings(lines))  # of few long lines a union is sooner made
    joined = shapely.unary_union(chains, grid_size=SNAP * size)
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(joined)))
    faces = faces[_wide(faces, chord)]
    if not len(faces):
        return shapely.Polygon()
    middles = shapely.get_coordinates(shapely.point_on_surface(faces)).T
    hit = reaches(sheet, box, made, middles, CLOSED * size)[0]
    return _filled(shapely.unary_union(faces[hit]), chord)


def _welded(ends: Array, size: float) -> Array:
    """Pieces (coordinate, end, piece) of which ends that meet no other are moved to the nearest one, if it is near."""
    from scipy.spatial import cKDTree

    places = ends.reshape(2, -1).T.copy()
    tree = cKDTree(places)
    alone = np.flatnonzero(tree.query_ball_point(places, SNAP * size, return_length=True) == 1)
    off, near = tree.query(places[alone], k=2)  # itself, then the nearest
    chosen = off[:, 1] < WELD * size
    alone, near = alone[chosen], near[chosen, 1]
    both = np.isin(near, alone) & (near > alone)  # of two that are alone, the second moves to the first
    places[alone[~both]] = places[near[~both]]
    return np.asarray(places.T.reshape(ends.shape))


def _wide(faces: Any, chord: float) -> NDArray[np.bool_]:
    """Which faces are no slivers."""
    import shapely

    return np.asarray(shapely.area(faces) > SLIVER * chord * shapely.length(faces))


def _filled(shape: Any, chord: float) -> Any:
    """A shape without holes that are slivers."""
    import shapely

    made = []
    for part in shapely.get_parts(shape):
        holes = np.array([shapely.Polygon(ring) for ring in part.interiors], dtype=object)
        kept = holes[_wide(holes, chord)] if holes.size else holes
        made.append(shapely.Polygon(part.exterior, [hole.exterior for hole in kept]))
    return shapely.unary_union(made)


def reaches(sheet: Sheet, box: Box, made: Mesh, places: Array, near: float) -> tuple[NDArray[np.bool_], Array]:
    """Whether the working point comes to places (2, n) within ``near`` (m), and the drive values (2, n) at which."""
    from scipy.spatial import cKDTree

    corners = made.q[:, np.unique(made.triangles)]
    at = sheet.place(corners)[0]
    known = np.isfinite(at).all(axis=0)
    corners, at = corners[:, known], at[:, known]
    count = places.shape[1]
    nearest = cKDTree(at.T).query(places.T, k=min(STARTS, at.shape[1]))[1].reshape(count, -1)
    found, values = np.zeros(count, dtype=bool), np.full((2, count), np.nan)
    for starts in (nearest[:, :1], nearest[:, 1:]):
        rest, tries = np.flatnonzero(~found), starts.shape[1]
        q, ok = solved(sheet, box, corners[:, starts[rest].ravel()], np.repeat(places[:, rest], tries, axis=1), near)
        row, first = np.unique(np.flatnonzero(ok) // max(tries, 1), return_index=True)
        found[rest[row]] = True
        values[:, rest[row]] = q[:, ok][:, first]
    return found, values


def solved(sheet: Sheet, box: Box, q: Array, places: Array, near: float) -> tuple[Array, NDArray[np.bool_]]:
    """Drive values at which the working point is at places (2, n), by damped Newton from ``q``; which were found."""
    low, high = np.array(box.low)[:, None], np.array(box.high)[:, None]
    held = ~np.array(box.turns)[:, None]

    def tried(rows: Rows, step: Array, damp: Array) -> tuple[Array, Array]:
        """Places (2, damps, rows) after parts of a step, and by how much they miss, infinite where out of reach."""
        found = q[:, None, rows] - damp[:, None] * step[:, None]
        found = np.where(held[:, None], np.clip(found, low[:, None], high[:, None]), found)
        at, reach = sheet.place(found.reshape(2, -1))
        off = np.hypot(*(at.reshape(found.shape) - places[:, None, rows]))
        return found, np.where(reach.reshape(off.shape) > RIM, off, np.inf)

    q, miss = q.copy(), np.hypot(*(sheet.place(q)[0] - places))
    rows = np.arange(miss.size)
    for _ in range(NEWTON):
        rows = rows[miss[rows] > DONE * near]
        if not rows.size:
            break
        here = sheet.look(q[:, rows])
        off, j, det = here.at - places[:, rows], here.jacobian, here.determinant
        with np.errstate(all="ignore"):
            step = np.stack([j[1, 1] * off[0] - j[0, 1] * off[1], j[0, 0] * off[1] - j[1, 0] * off[0]]) / det
        step = np.nan_to_num(step, nan=0.0, posinf=0.0, neginf=0.0)
        step *= np.minimum(1.0, 0.3 * box.size.min() / np.maximum(np.abs(step).max(axis=0), 1e-300))
        better = np.zeros(rows.size, dtype=bool)
        for damps in DAMPS:
            rest = np.flatnonzero(~better)
            there, off = tried(rows[rest], step[:, rest], damps)
            nearer = off < miss[rows[rest]]
            first, good = nearer.argmax(axis=0), nearer.any(axis=0)
            chosen = first[good], np.flatnonzero(good)
            q[:, rows[rest[good]]], miss[rows[rest[good]]] = there[:, *chosen], off[chosen]
            better[rest[good]] = True
        rows = rows[better]  # the others are stuck
    return q, miss <= near
