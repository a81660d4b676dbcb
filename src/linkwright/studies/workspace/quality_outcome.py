"""The quality of each region of a study: maps, and the singular positions by kind."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING, Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.findings import CLAUSES, Joined, Said
from linkwright.studies.workspace.mapped_regions import RegionMaps
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.outcome import Reached, Workspace
from linkwright.studies.workspace.quality import Locus, Quality, kinds, quality
from linkwright.studies.workspace.quality_options import QualityOptions
from linkwright.words import in_language

if TYPE_CHECKING:
    from linkwright.studies.workspace.outcome import WorkspaceOutcome

USUAL = ("condition", "transmission")
"""The maps of which there are pictures unless the file says."""
KINDS = ("limit-position", "uncertain")
JOINED = 2e-5
"""Ends of pieces that are nearer than this share of the drives' ranges are on one curve."""


@dataclass(frozen=True)
class Curves:
    """All singular positions of a kind: how many curves in the drives' plane, and how long their paths are (m)."""

    kind: str
    count: int
    length: float


@dataclass(frozen=True)
class RegionQuality(RegionMaps):
    """One region's quality."""

    loci: Sequence[Curves]

    @classmethod
    def of(cls, workspace: Workspace, reached: Reached, found: Quality) -> RegionQuality:
        """From its maps."""
        box = reached.region.box
        loci = [counted(kind, [one for one in found.loci if one.kind == kind], box) for kind in KINDS]
        return cls(workspace, reached, found.maps, found.maps.extremes(), loci)


@dataclass(eq=False)
class QualityPart:
    """The quality of all regions; ``shown`` are the maps of which there are pictures, with lines at ``levels`` (SI)."""

    outcome: WorkspaceOutcome
    steps: int
    shown: Sequence[str]
    levels: Mapping[str, tuple[float, ...]]
    regions: list[RegionQuality] = field(default_factory=list)

    def as_dict(self) -> list[dict[str, Any]]:
        """An entry for each region."""
        size = self.outcome.compiled.quantities.unit_of(u.LENGTH)[1]
        with in_language("en"):  # a value of a file, which stays
            names = {"limit-position": by_drives(self.outcome), "uncertain": str(closures(self.outcome))}
        return [
            {
                **one.head(self.outcome),
                "steps": self.steps,
                "maps": one.map_entries(self.outcome),
                "loci": [
                    {
                        "kind": found.kind,
                        "determinant": names[found.kind],
                        "curves": found.count,
                        "length": found.length / size,
                    }
                    for found in one.loci
                ],
            }
            for one in self.regions
        ]


def by_drives(outcome: WorkspaceOutcome) -> str:
    """The determinant that vanishes in limit positions of the output, as text."""
    return f"d({outcome.point}.x, {outcome.point}.y)/d({', '.join(outcome.compiled.graph.drives)})"


def closures(outcome: WorkspaceOutcome) -> Joined:
    """The closures of which one's determinant vanishes in uncertain positions."""
    return Joined((Said("workspace.closure", group=group.label) for group in outcome.compiled.graph.branched), CLAUSES)


def counted(kind: str, loci: Sequence[Locus], box: DriveBox) -> Curves:
    """The curves of a kind: pieces that meet or cross are one, over the end of a whole turn too."""
    import shapely
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    if not loci:
        return Curves(kind, 0, 0.0)
    drives, at = (np.concatenate([getattr(one, name) for one in loci], axis=2) for name in ("drives", "at"))
    places = (drives - np.reshape(box.low, (2, 1, 1))) / box.size[:, None, None]
    places -= np.where(np.reshape(box.turns, (2, 1)), np.floor(places[:, 0]), 0.0)[:, None]
    lines = shapely.linestrings(np.moveaxis(places, (0, 1, 2), (2, 1, 0)))
    pairs = shapely.STRtree(lines).query(lines, predicate="intersects")
    round_ = np.where(box.turns, 1.0, np.inf)
    ends, own = np.unique(np.round(places.reshape(2, -1).T % round_, 7) % round_, axis=0, return_inverse=True)
    first, last = own.reshape(2, -1)
    near = cKDTree(ends, boxsize=np.where(box.turns, 1.0, 0.0)).query_pairs(JOINED, output_type="ndarray")
    links = np.concatenate([np.stack([first, last], axis=1), first[pairs.T], near])
    joined = coo_array((np.ones(len(links)), links.T), shape=(len(ends), len(ends)))
    length = np.hypot(*(at[:, 1] - at[:, 0]))
    return Curves(kind, int(connected_components(joined, directed=False)[0]), float(np.nansum(length)))


def quality_part(options: QualityOptions, outcome: WorkspaceOutcome) -> QualityPart:
    """The maps of each region."""
    compiled = outcome.compiled
    task = options.task(compiled)[0]
    known = kinds(compiled, task)
    shown = options.shown_maps([name for name in USUAL if name in known])
    part = QualityPart(outcome, options.steps, shown, options.lines(compiled, known))
    assert outcome.box is not None
    for workspace in outcome.workspaces:
        for reached in workspace.regions:
            region = reached.region
            found = quality(region.sheet, outcome.box, task, options.steps, region.segments)
            part.regions.append(RegionQuality.of(workspace, reached, found))
    return part
