"""A region whose poses are known in closed form: its edge between decided cells, the curves in the drives' plane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.bound import farthest
from linkwright.studies.workspace.alike import alike
from linkwright.studies.workspace.border import border, polygons
from linkwright.studies.workspace.cells import decided
from linkwright.studies.workspace.certificate import Certificate, certified
from linkwright.studies.workspace.curves import Segments, smooth, traced
from linkwright.studies.workspace.mesh import Box, Mesh, found_pits, mesh
from linkwright.studies.workspace.places import Places

Array = NDArray[np.float64]

MESHES = (96, 192, 384)
"""Steps of the meshes on which the curves are looked for, until two find the same."""
RINGS = (2,)
"""Where a curve can't be followed, the mesh is finer so many triangles around: once, as the region's edge doesn't hang
on it."""
LOOKS = 48
"""The region's extent is looked at on so many values of each drive."""
SKEW = np.array([1.0176, 1.0393])
"""The square is off the middle by so much, so that edges along axes are on no side of a cell, ..."""
WIDER = 1.0625
"""... and this much wider than the region can be."""
WITHIN = 8.0
"""The edge is drawn to so small a share of the width that is open along it, or to half of the chord tolerance."""
BESIDE = 1e-6
"""Places of the edge are on a curve within this share of the region's extent."""
INWARD = 0.1
"""The drives' values are those of places so many chords within the edge."""


@dataclass(frozen=True)
class Enclosed:
    """A region's ``shape``, the curves that may bound it, found on a mesh of some ``steps``, by how much its edge may
    be off where it couldn't be drawn to the chord tolerance (m), and its certificate."""

    shape: Any
    segments: tuple[Segments, ...]
    mesh: Mesh
    steps: int
    rough: float
    certificate: Certificate


def enclosed(places: Places, chord: float) -> Enclosed | None:
    """The region of a mode; ``None`` where lengths bound no square in which it lies, or nothing is reached."""
    square = _square(places)
    if square is None:
        return None
    try:
        cells = decided(places, *square)
    except NotImplementedError:  # a dyad whose closed form has functions without enclosure
        return None
    # Drawn so that the area lies well within its bounds too, whose difference is some width along the edge.
    (low, high), along = cells.area, float(cells.edge.size.sum())
    near = min(chord / 2, (high - low) / (WITHIN * along)) if along else chord / 2
    a, b, rough = border(places.depth, cells.edge, near)
    shape = polygons(places.depth, a, b, near)
    segments, made, steps = _curves(places, shape, chord)
    return Enclosed(shape, segments, made, steps, rough, certified(places, cells, shape, chord))


def _square(places: Places) -> tuple[Array, float, float] | None:
    """Corner and side of a square in which the region lies, for its links are no longer; and about its extent (m)."""
    sheet, box = places.sheet, places.box
    graph = sheet.compiled.graph
    travels = {}
    for k, drive in enumerate(graph.drives):
        if not places.inverse.turns(drive):
            joint = graph.structure.topology.driven(drive)[0].joint
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


def _curves(places: Places, shape: Any, chord: float) -> tuple[tuple[Segments, ...], Mesh, int]:
    """The curves of a mode in the drives' plane; pieces of the edge that lie on none, at the drives' values there."""
    sheet, box = places.sheet, places.box
    pits = found_pits(sheet, box)
    rough = traced(sheet, mesh(sheet, box, MESHES[0], pits), levels=1)
    for steps in MESHES[1:]:
        made = mesh(sheet, box, steps, pits)
        pieces = traced(sheet, made, rings=RINGS)
        if alike(rough, pieces, box.size / steps):
            break
        rough = pieces
    segments = smooth(sheet, pieces, chord)
    return (*segments, *_beside(places, shape, segments, chord)), made, steps


def _beside(places: Places, shape: Any, segments: list[Segments], chord: float) -> list[Segments]:
    """Pieces of a region's edge that lie on no curve, as the mesh has missed that: by their kinds."""
    import shapely

    rings = [shapely.get_coordinates(ring).T for ring in shapely.get_parts(shapely.boundary(shape))]
    if not rings:
        return []
    ends = np.concatenate([np.stack([ring[:, :-1], ring[:, 1:]]) for ring in rings], axis=2)
    drives = np.concatenate([np.stack([one.a, one.b]) for one in segments], axis=2)
    paths = places.sheet.place(drives.transpose(1, 0, 2).reshape(2, -1))[0].reshape(2, 2, -1)
    paths = paths[:, :, np.isfinite(paths).all(axis=(0, 1))]
    middles, extent = ends.mean(axis=0), float(np.ptp(ends, axis=(0, 2)).max())
    lost = np.ones(middles.shape[1], dtype=bool)
    if paths.size:
        tree = shapely.STRtree(shapely.linestrings(paths.transpose(2, 1, 0)))
        near = tree.query(shapely.points(middles.T), predicate="dwithin", distance=max(BESIDE * extent, 4 * chord))
        lost[near[0]] = False
    if not lost.any():
        return []
    a, b = ends[:, :, lost]
    values, kinds = _drives(places, np.concatenate([a, b, (a + b) / 2], axis=1), np.tile(b - a, 3), chord)
    first, last, _ = np.split(values, 3, axis=1)
    kind = kinds[-a.shape[1] :]
    known = np.isfinite(first).all(axis=0) & np.isfinite(last).all(axis=0)
    known &= (np.abs(last - first) < box_half(places.box)).all(axis=0)
    return [
        Segments(name, first[:, of], last[:, of], np.zeros(int(of.sum())))
        for name in sorted(set(places.kinds))
        if (of := known & (kind == name)).any()
    ]


def box_half(box: Box) -> Array:
    """Half the ranges of both drives, beyond which two values don't belong to one piece: (2, 1)."""
    return box.size[:, None] / 2


def _drives(places: Places, at: Array, along: Array, chord: float) -> tuple[Array, NDArray[np.str_]]:
    """The drives' values (2, n) at places of the edge, with the region to the left or right of the way ``along`` it,
    and the kinds of curve there."""
    normal = np.stack([-along[1], along[0]]) / np.hypot(*along)
    inside = at + INWARD * chord * normal
    inside = np.where(places.depth(inside) > 0, inside, at - INWARD * chord * normal)
    values, depths = places.drives(inside)
    branch, row = depths.argmax(axis=0), np.arange(at.shape[1])
    functions = places.functions(inside)[branch, :, row]
    return values[branch, :, row].T, np.array(places.kinds)[np.nan_to_num(functions, nan=np.inf).argmin(axis=1)]
