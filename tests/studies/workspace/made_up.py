"""Regions made up of shapes: depths of places and their cells, without any mechanism; and mechanisms' places."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from helpers.reach.mechanisms import Mechanism
from linkwright.studies.workspace.cells import Cells, Decided, decided, merge_cells
from linkwright.studies.workspace.curves import Segments
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.places import KnownPoses, ModePlaces
from linkwright.studies.workspace.region_enclosure import _square, enclosed
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Depth = Callable[[Array], Array]
MM = 1e-3
CHORD = 1e-7


def disc(x: float, y: float, radius: float) -> Depth:
    """How deep a place lies in a disc."""
    return lambda at: radius - np.hypot(at[0] - x, at[1] - y)


def either(*depths: Depth) -> Depth:
    """What lies in one of some regions."""
    return lambda at: np.max([depth(at) for depth in depths], axis=0)


def both(*depths: Depth) -> Depth:
    """What lies in all of some regions."""
    return lambda at: np.min([depth(at) for depth in depths], axis=0)


def without(one: Depth, other: Depth) -> Depth:
    """What lies in one region and not in the other."""
    return lambda at: np.minimum(one(at), -other(at))


def above(foot: tuple[float, float], angle: float) -> Depth:
    """The half of the plane to the left of a line in a direction (rad)."""
    x, y = foot
    return lambda at: (at[1] - y) * np.cos(angle) - (at[0] - x) * np.sin(angle)


def edge_cells(depth: Depth, level: int = 6, corner: tuple[float, float] = (-2.03, -2.07), side: float = 4.1) -> Cells:
    """Cells of one level along the edge of a region whose depth is no more than the distance from it."""
    axis = np.arange(2**level)
    cells = Cells(np.array(corner), side, np.stack(np.meshgrid(axis, axis)).reshape(2, -1), np.full(4**level, level))
    return cells.subset(np.abs(depth(cells.middle)) < 0.75 * cells.size)


def coarser(cells: Cells, left: float) -> Cells:
    """The same with those to the left of some x as large again: cells of two sizes."""
    wide = cells.middle[0] < left
    number = np.unique(cells.number[:, wide] // 2, axis=1)
    large = Cells(cells.corner, cells.side, number, np.full(number.shape[1], int(cells.level.max()) - 1))
    small = cells.subset(~wide)
    covered = np.isin(small.number[0] // 2 * 2**20 + small.number[1] // 2, number[0] * 2**20 + number[1])
    return merge_cells([large, small.subset(~covered)])


def box_of(mechanism: Mechanism) -> DriveBox:
    """The ranges of its drives (SI), whole turns begun askew."""
    (low, high), (down, up) = mechanism.spans
    turns = [bool(one) for one in _turning(mechanism)]
    sizes = [1.0 if turn else MM for turn in turns]
    whole = [
        turn and span[1] - span[0] >= 2 * np.pi * (1 - 1e-12) for turn, span in zip(turns, mechanism.spans, strict=True)
    ]
    return DriveBox((low * sizes[0], down * sizes[1]), (high * sizes[0], up * sizes[1]), (whole[0], whole[1])).askew()


def _turning(mechanism: Mechanism) -> list[bool]:
    compiled = compiled_from(document(mechanism))
    return [bool(compiled.mechanism.prescribed(drive).turns) for drive in compiled.graph.drives]


def document(mechanism: Mechanism) -> dict[str, Any]:
    """The model file of a mechanism, begun where it closes."""
    spans = np.array(mechanism.spans)[:, :, None]
    q = np.random.default_rng(3).uniform(spans[:, 0], spans[:, 1], (2, 4000))
    return mechanism.document(q[:, np.isfinite(mechanism.placed(q, 0).real)][:, 0])


def places_of(mechanism: Mechanism, mode: int) -> ModePlaces:
    """The places that a mode (left, right) reaches."""
    compiled = compiled_from(document(mechanism))
    first, second = compiled.graph.drives
    branches = (1.0 - 2.0 * mode,) * len(compiled.graph.branched)
    poses = KnownPoses.of(compiled, "P")
    assert poses is not None
    return ModePlaces(poses, ModeSheet(compiled, "P", (first, second), branches), box_of(mechanism))


def decided_of(places: ModePlaces) -> Decided:
    """Its cells."""
    square = _square(places)
    assert square is not None
    return decided(places, *square)


@dataclass(frozen=True)
class Drawn:
    """A mechanism's first mode with its region and its curves."""

    places: ModePlaces
    shape: Any
    segments: list[Segments]


def drawn(mechanism: Mechanism) -> Drawn:
    """The first mode of a mechanism, studied to the tolerance ``CHORD``."""
    places = places_of(mechanism, 0)
    found = enclosed(places, CHORD)
    assert found is not None and found.certificate.certified
    return Drawn(places, found.shape, list(found.segments))
