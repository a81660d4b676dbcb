"""A region whose poses aren't known in closed form: the faces between its curves' paths, each looked at in one place.

The paths cut the plane into faces. As the jacobian is regular away from them, all of a face is reached or none of it:
one place tells. Whether it is reached is found by Newton's method from the drive values that come nearest. Nothing says
that no curve was missed: what hints at that is told as a fault.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.workspace.certificate import Contradiction
from linkwright.studies.workspace.curves import Segments, Traced, smooth, traced
from linkwright.studies.workspace.mesh import DriveBox, Mesh, found_pits, mesh
from linkwright.studies.workspace.path_similarity import alike
from linkwright.studies.workspace.shapes import without_slivers
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.solving import reaches

Array = NDArray[np.float64]

CLOSE = 1e-6
"""Meshes are doubled until the area changes by less than this share, or that which the chords leave open."""
MESHES = ((96, 1536, True), (192, 1536, False), (96, 96, False), (80, 80, False), (112, 112, False))
"""First and last steps of meshes, and whether the same curves on two are enough; others are tried where one finds
faults."""
SNAP = 1e-8
"""Ends of pieces nearer than this share of the extent are one: curves end no more exactly on each other."""
WELD = 1e-7
"""So are such of which one meets no other: the rim is drawn to this, and its places on both sides of a seam differ."""
SLIVER = 4.0
"""A face narrower than so many chords is a sliver."""
LOOSE = ("cut", "dangle", "ring")
LONG = 1e-6
"""Lines that bound no face are faults where they are longer than this share of the extent."""
ROUGH = 2000
"""Curves of which more pieces can't be followed make no region: as where two pins of a group meet all along a curve of
drives' values, so that its links may point anywhere."""
ROUNDS = 8
"""Slivers beside slivers are looked at so often."""
CLOSED = 1e-9
"""A place is reached when the working point comes within this share of the extent."""


@dataclass(frozen=True)
class MeshRegion:
    """A region's ``shape`` and curves on a mesh of some ``steps``; ``change`` of its area (share) when these were last
    doubled: at most so much where both meshes have the same curves, each then drawn within its chords."""

    shape: Any
    segments: tuple[Segments, ...]
    mesh: Mesh
    steps: int
    change: float
    faults: tuple[Contradiction, ...]


def searched(sheet: ModeSheet, box: DriveBox, chord: float) -> MeshRegion:
    """The region of a sheet, on the meshes that find the least faults."""
    tried: list[MeshRegion] = []
    for first, most, quick in MESHES:
        tried.append(_on_meshes(sheet, box, chord, first, most, quick))
        if not tried[-1].faults or any(fault.kind == "rough" for fault in tried[-1].faults):
            return tried[-1]
    return min(tried, key=lambda one: sum(fault.size for fault in one.faults))


def _on_meshes(sheet: ModeSheet, box: DriveBox, chord: float, first: int, most: int, quick: bool) -> MeshRegion:
    """On meshes that are doubled until its area changes by little; if ``quick``, on the first two already where both
    have the same curves."""
    import shapely

    last, steps, close = None, first, max(CLOSE, 10 * chord / sheet.compiled.graph.size)
    pits = found_pits(sheet, box)

    def made_of(made: Mesh, pieces: Traced, steps: int, last: float | None = None) -> MeshRegion:
        segments = smooth(sheet, pieces, chord)
        if fault := _rough(sheet, segments):
            return MeshRegion(shapely.Polygon(), tuple(segments), made, steps, np.inf, (fault,))
        shape, faults = reached(sheet, box, made, segments, chord)
        area = float(shape.area)
        change = abs(area - last) / area if last is not None and area else np.inf
        return MeshRegion(shape, tuple(segments), made, steps, change, tuple(faults))

    if quick and 2 * first <= most:
        rough, made = (mesh(sheet, box, n, pits) for n in (first, 2 * first))
        pieces = traced(sheet, made)
        if alike(traced(sheet, rough, levels=1), pieces, box.size / (2 * first)):
            found = made_of(made, pieces, 2 * first)
            area = float(found.shape.area)
            return replace(found, change=2 * chord * found.shape.length / area if area else 0.0)
    while True:
        made = mesh(sheet, box, steps, pits)
        found = made_of(made, traced(sheet, made), steps, last)
        area = float(found.shape.area)
        if found.change <= close or not area:
            return found
        if 2 * steps > most:
            x, y = found.shape.centroid.coords[0]
            return replace(found, faults=(*found.faults, Contradiction("unsettled", found.change, (x, y))))
        last, steps = area, 2 * steps


def _rough(sheet: ModeSheet, segments: Sequence[Segments]) -> Contradiction | None:
    """A fault where very many pieces can't be followed."""
    rough = np.concatenate([one.a[:, ~(one.off == 0)] for one in segments], axis=1)
    if rough.shape[1] <= ROUGH:
        return None
    at = sheet.place(rough)[0]
    x, y = np.nan_to_num(at[:, np.isfinite(at).all(axis=0)][:, :1]).sum(axis=1).tolist()
    return Contradiction("rough", float(rough.shape[1]), (x, y))


def reached(
    sheet: ModeSheet, box: DriveBox, made: Mesh, segments: Sequence[Segments], chord: float
) -> tuple[Any, list[Contradiction]]:
    """The faces between the curves' paths that are reached, together, and what doesn't fit. Slivers between paths that
    are one but for their chords go with the face with which they share most of their edge."""
    import shapely

    paths = [sheet.place(np.stack([one.a, one.b], axis=1).reshape(2, -1))[0].reshape(2, 2, -1) for one in segments]
    ends = np.concatenate(paths, axis=2)
    known = np.asarray(np.isfinite(ends).all(axis=(0, 1)))
    faults = _nowhere(segments, ends, known)
    ends = ends[:, :, known & (ends[:, 1] != ends[:, 0]).any(axis=0)]
    if not ends.size or not made.q.size:
        return shapely.Polygon(), faults
    size = float(np.ptp(ends, axis=(1, 2)).max())
    ends = _welded(ends, size)
    lines = shapely.linestrings(np.moveaxis(ends, (0, 1, 2), (2, 1, 0)))
    chains = shapely.line_merge(shapely.multilinestrings(lines))  # of few long lines a union is sooner made
    joined = shapely.unary_union(chains, grid_size=SNAP * size)
    faces, *loose = shapely.polygonize_full(shapely.get_parts(joined))
    faults += [fault for part, kind in zip(loose, LOOSE, strict=True) for fault in _loose(part, kind, size)]
    faces = shapely.get_parts(faces)
    wide = np.asarray(shapely.area(faces) > SLIVER * chord * shapely.length(faces))
    if not wide.any():
        return shapely.Polygon(), faults
    middles = shapely.get_coordinates(shapely.point_on_surface(faces[wide])).T
    hit = np.zeros(len(faces), dtype=int)
    hit[wide] = np.where(reaches(sheet, box, made, middles, CLOSED * size)[0], 1, -1)
    return without_slivers(shapely.union_all(faces[_with_slivers(faces, hit) > 0]), chord), faults


def _nowhere(segments: Sequence[Segments], ends: Array, known: NDArray[np.bool_]) -> list[Contradiction]:
    """Pieces an end of which has no place: a round-off beyond the rim they are no longer than that."""
    which = np.concatenate([np.isfinite(one.off) & (one.off == 0) for one in segments])
    lost = ~known & ~which
    if not lost.any():
        return []
    at = ends[:, :, lost].reshape(2, -1)
    at = at[:, np.isfinite(at).all(axis=0)]
    x, y = at.mean(axis=1).tolist() if at.size else (0.0, 0.0)
    return [Contradiction("nowhere", float(lost.sum()), (x, y))]


def _loose(lines: Any, kind: str, size: float) -> list[Contradiction]:
    """Lines that bound no face, if they are long."""
    import shapely

    long = float(shapely.length(lines))
    if not long > LONG * size:
        return []
    x, y = lines.centroid.coords[0]
    return [Contradiction(kind, long, (x, y))]


def _with_slivers(faces: Any, hit: NDArray[np.int_]) -> NDArray[np.int_]:
    """Faces of which 1 is reached and -1 is not; the others, 0, as the neighbour with the longest common edge."""
    import shapely

    tree, hit = shapely.STRtree(faces), hit.copy()
    for _ in range(ROUNDS):
        open_ = np.flatnonzero(hit == 0)
        if not open_.size:
            break
        one, other = tree.query(faces[open_], predicate="intersects")
        one = open_[one]
        kept = (hit[other] != 0) & (one != other)
        one, other = one[kept], other[kept]
        if not one.size:
            break
        edges = shapely.length(shapely.intersection(shapely.boundary(faces[one]), shapely.boundary(faces[other])))
        order = np.lexsort((edges, one))
        last = order[np.flatnonzero(np.diff(one[order], append=-1))]
        hit[one[last]] = hit[other[last]]
    return hit


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
