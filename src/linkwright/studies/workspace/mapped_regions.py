"""The maps of a region as a part of the study: their least and greatest values, told in the file's units."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite, isinf
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.studies.workspace.maps import Map, MapExtreme, Maps
from linkwright.studies.workspace.outcome import Reached, Workspace
from linkwright.studies.workspace.shapes import figures

if TYPE_CHECKING:
    from linkwright.studies.workspace.outcome import WorkspaceOutcome

Array = NDArray[np.float64]
Ends = Mapping[str, tuple[MapExtreme | None, MapExtreme | None]]
"""The least and the greatest value of each map; none where the mechanism can be assembled nowhere on the grid."""


@dataclass(frozen=True)
class RegionMaps:
    """One region with its maps."""

    workspace: Workspace
    reached: Reached
    maps: Maps
    ends: Ends

    def head(self, outcome: WorkspaceOutcome) -> dict[str, Any]:
        """Mode and values, as the region's own entry has them."""
        return {"mode": self.reached.mode, **outcome.values_in_units(self.workspace)}

    def map_entries(self, outcome: WorkspaceOutcome) -> dict[str, Any]:
        """Of each map its unit, the least and the greatest value."""
        made = {}
        for name, one in self.maps.maps.items():
            least, greatest = (_extreme(outcome, one, extreme) for extreme in self.ends[name])
            made[name] = {"unit": one.unit, "least": least, "greatest": greatest}
        return made


def _extreme(outcome: WorkspaceOutcome, one: Map, found: MapExtreme | None) -> dict[str, Any] | None:
    """A value and where it is; ``None`` as value where it grows without bound."""
    if found is None:
        return None
    assert outcome.box is not None
    size = outcome.compiled.quantities.unit_of(u.LENGTH)[1]
    value = found.value / one.size
    drives = {
        drive: float(q / outcome.compiled.quantities.drive_unit(drive)[1])
        for drive, q in zip(outcome.compiled.graph.drives, outcome.box.wrapped(found.drives), strict=True)
    }
    told = {"value": value if isfinite(value) else None, "at": [float(x) / size for x in found.at], "drives": drives}
    return told | ({"unbounded": True} if isinf(value) else {})


def part_of(shape: Any, region: Any, size: float) -> dict[str, Any]:
    """The figures of a part of a region, in units of ``size`` m: its share too."""
    found = figures(shape)
    return {
        "area": found.area / size**2,
        "share": found.area / region.area if region.area else 0.0,
        "parts": found.parts,
        "holes": found.holes,
        "bounds": [edge / size if isfinite(edge) else None for edge in found.bounds],
    }
