"""A region all of whose poses are known: its edge between decided cells, the curves in the drives' plane."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.bound import farthest
from linkwright.studies.workspace.border import border, polygons
from linkwright.studies.workspace.cells import decided
from linkwright.studies.workspace.certificate import Contradiction, RegionCertificate, certified
from linkwright.studies.workspace.curves import Segments, smooth, traced
from linkwright.studies.workspace.mesh import Mesh, found_pits, mesh
from linkwright.studies.workspace.missing_curves import Square, missed, missed_anywhere
from linkwright.studies.workspace.path_similarity import alike
from linkwright.studies.workspace.places import ModePlaces
from linkwright.studies.workspace.pose_counts import DrivePaths, contradiction

Array = NDArray[np.float64]

MESHES = (96, 192, 384)
"""Steps of the meshes on which the curves are looked for, until two find the same."""
RINGS = (2,)
"""Where a curve can't be followed, the mesh is finer so many triangles around: once, as the region's edge doesn't hang
on it."""
ROUGH = 64.0
"""Pieces of curves that may be off by more chords are left out, to be found from the poses turned round."""
LOOKS = 48
"""The region's extent is looked at on so many values of each drive."""
SKEW = np.array([1.0176, 1.0393])
"""The square is off the middle by so much, so that edges along axes are on no side of a cell, ..."""
WIDER = 1.0625
"""... and this much wider than the region can be."""
SPOTS, SPOT, VAGUE = 200, 1e-7, 0.2
"""In so many squares, of this share of the side, platforms are looked at beforehand: no more than a share of them may
hold poses that can't be told apart."""
WITHIN = 8.0
"""The edge is drawn to so small a share of the width that is open along it, or to half of the chord tolerance."""


@dataclass(frozen=True)
class Enclosed:
    """A region's ``shape``, the curves that may bound it, found on a mesh of some ``steps``, by how much its edge may
    be off where it couldn't be drawn to the chord tolerance (m), and its certificate."""

    shape: Any
    segments: tuple[Segments, ...]
    mesh: Mesh
    steps: int
    rough: float
    certificate: RegionCertificate


def enclosed(places: ModePlaces, chord: float) -> Enclosed | None:
    """The region of a mode; ``None`` where lengths bound no square in which it lies, or nothing is reached."""
    square = _square(places)
    if square is None:
        return None
    try:
        if _vague(places, *square[:2]):
            return None
        cells = decided(places, *square)
    except NotImplementedError:  # a dyad whose closed form has functions without enclosure
        return None
    # Drawn so that the area lies well within its bounds too, whose difference is some width along the edge.
    (low, high), along = cells.area, float(cells.edge.size.sum())
    near = min(chord / 2, (high - low) / (WITHIN * along)) if along else chord / 2
    a, b, off = border(places.depth, cells.edge, near)
    shape = polygons(places.depth, a, b, near)
    segments, made, steps, faults = _curves(places, shape, square, chord)
    certificate = certified(places, cells, shape, chord)
    certificate = replace(certificate, faults=(*certificate.faults, *faults))
    return Enclosed(shape, tuple(segments), made, steps, float(off.max(initial=0.0)), certificate)


def _square(places: ModePlaces) -> Square | None:
    """Corner and side of a square in which the region lies, for its links are no longer; and about its extent (m)."""
    sheet, box = places.sheet, places.box
    graph = sheet.compiled.graph
    travels = {}
    for k, drive in enumerate(graph.drives):
        if not places.inverse.turns(drive):
            joint = graph.structure.topology.drivable_joints(drive)[0].joint
            travels[joint] = max(abs(box.low[k]), abs(box.high[k]))
    parameters = dict(zip(graph.parameters, sheet.parameters.tolist(), strict=True))
    bound = farthest(graph, sheet.point, parameters, travels)
    axes = [np.linspace(low, high, LOOKS + 1) for low, high in zip(box.low, box.high, strict=True)]
    at = sheet.place(np.stack(np.meshgrid(*axes)).reshape(2, -1))[0]
    at = at[:, np.isfinite(at).all(axis=0)]
    if not np.isfinite(bound) or not at.size:
        return None
    extent = float(np.ptp(at, axis=1).max())
    half = bound * WIDER
    return -half * SKEW, 2 * half, max(extent, 1e-9 * half)


def _vague(places: ModePlaces, corner: Array, side: float) -> bool:
    """Whether poses of platforms can't be told apart in many places, as those of parallelograms, whose polynomials have
    double zeros everywhere."""
    at = corner[:, None] + side * np.random.default_rng(0).uniform(0.3, 0.7, (2, SPOTS))
    of, branch = np.tile(np.arange(SPOTS), len(places.branches)), np.repeat(np.arange(len(places.branches)), SPOTS)
    rooms, which = places.rooms(at[:, of], np.full(of.size, SPOT * side), branch)
    low, high = rooms.bounds
    vague = ((low <= 0) & (high >= 0)).any(axis=0)
    return np.unique(of[which[vague]]).size > VAGUE * np.unique(of[which]).size


def _curves(
    places: ModePlaces, shape: Any, square: Square, chord: float
) -> tuple[list[Segments], Mesh, int, list[Contradiction]]:
    """The curves of a mode in the drives' plane; those that meshes miss, from the poses turned round; and what still
    contradicts them."""
    sheet, box = places.sheet, places.box
    pits = found_pits(sheet, box)
    rough = traced(sheet, mesh(sheet, box, MESHES[0], pits), levels=1)
    for steps in MESHES[1:]:
        made = mesh(sheet, box, steps, pits)
        pieces = traced(sheet, made, rings=RINGS)
        if alike(rough, pieces, box.size / steps):
            break
        rough = pieces
    segments = [one.within(ROUGH * chord) for one in smooth(sheet, pieces, chord)]
    segments += missed(places, _rings(shape), square[2], segments, chord)
    wrong = contradiction(places, DrivePaths.of(sheet, segments), chord)
    if wrong:
        segments += missed_anywhere(places, square, segments, chord)
        wrong = contradiction(places, DrivePaths.of(sheet, segments), chord)
    return segments, made, steps, [Contradiction("count", wrong.length, wrong.at)] if wrong else []


def _rings(shape: Any) -> tuple[Array, Array, Array]:
    """A shape's edge by its pieces: their ends (2, n) both, and by how much each is off."""
    import shapely

    rings = [shapely.get_coordinates(ring).T for ring in shapely.get_parts(shapely.boundary(shape))]
    a, b = (
        np.concatenate([np.empty((2, 0)), *(ring[:, some] for ring in rings)], axis=1)
        for some in (slice(-1), slice(1, None))
    )
    return a, b, np.zeros(a.shape[1])
