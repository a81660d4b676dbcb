"""The region that the working point of a sheet reaches: a polygon whose edges lie within a chord of the true ones."""

from __future__ import annotations

from typing import Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.studies.workspace.certificate import SEARCHED, UNPROVEN, RegionCertificate
from linkwright.studies.workspace.curves import Segments
from linkwright.studies.workspace.mesh import DriveBox, Mesh
from linkwright.studies.workspace.places import KnownPoses, ModePlaces
from linkwright.studies.workspace.region_enclosure import enclosed
from linkwright.studies.workspace.region_search import searched
from linkwright.studies.workspace.sheet import ModeSheet


@dataclass(frozen=True, eq=False)
class Region:
    """What one sheet reaches: ``shape`` is a Shapely polygon or several (m). ``segments`` are the curves that may bound
    it, ``mesh`` the one on which they were found, of some ``steps``; ``rough`` is by how much its edge may be off where
    that couldn't be drawn to the chord tolerance (m). ``certificate`` says what is proven."""

    sheet: ModeSheet
    box: DriveBox
    shape: Any
    segments: tuple[Segments, ...]
    mesh: Mesh
    steps: int
    rough: float
    certificate: RegionCertificate = UNPROVEN


def region(sheet: ModeSheet, box: DriveBox, chord: float) -> Region:
    """The region of a sheet: enclosed where all poses that come to a place are known, else searched for."""
    box = box.askew()
    poses = KnownPoses.of(sheet.compiled, sheet.point)
    found = None if poses is None else enclosed(ModePlaces(poses, sheet, box), chord)
    if found is not None:
        return Region(sheet, box, found.shape, found.segments, found.mesh, found.steps, found.rough, found.certificate)
    other = searched(sheet, box, chord)
    rough = max((float(np.nan_to_num(one.off).max(initial=0.0)) for one in other.segments), default=0.0)
    certificate = RegionCertificate(SEARCHED, faults=other.faults)
    return Region(sheet, box, other.shape, other.segments, other.mesh, other.steps, rough, certificate)
