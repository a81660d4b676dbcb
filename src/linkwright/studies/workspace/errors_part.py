"""The working point's errors over each region of a study, and what tolerances leave of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import isfinite
from typing import TYPE_CHECKING, Any

from linkwright.model import units as u
from linkwright.studies.workspace.causes import Causes
from linkwright.studies.workspace.guaranteed import Guaranteed
from linkwright.studies.workspace.mapped_regions import RegionMaps, part_of

if TYPE_CHECKING:
    from linkwright.studies.workspace.outcome import WorkspaceOutcome


@dataclass(frozen=True)
class RegionErrors(RegionMaps):
    """One region's errors, and the part of it that is sure; by what ``causes`` them."""

    causes: Causes
    sure: Guaranteed

    @property
    def contributors(self) -> list[str]:
        """What deviates, and joints with clearance, by name."""
        return self.causes.names


@dataclass(eq=False)
class ErrorsPart:
    """The errors of all regions; ``limit`` (m) of the point's error, where one is asked for."""

    outcome: WorkspaceOutcome
    steps: int
    shown: Sequence[str]
    levels: Mapping[str, tuple[float, ...]]
    limit: float | None = None
    regions: list[RegionErrors] = field(default_factory=list)

    def as_dict(self) -> list[dict[str, Any]]:
        """An entry for each region."""
        return [self._entry(one) for one in self.regions]

    def _entry(self, one: RegionErrors) -> dict[str, Any]:
        unit, size = self.outcome.compiled.quantities.unit_of(u.LENGTH)
        region = one.reached.shape
        inward = [way / size if isfinite(way) else None for way in (one.sure.least, one.sure.most)]
        entry = {
            **one.head(self.outcome),
            "steps": self.steps,
            "contributors": one.contributors,
            "clearances": {joint: clearance / size for joint, clearance in one.causes.clearances.items()},
            "maps": one.told(self.outcome),
            "unit": unit,
            "guaranteed": {**part_of(one.sure.shape, region, size), "inward": inward},
        }
        if self.limit is not None:
            entry["precise"] = {"limit": self.limit / size, **part_of(one.sure.precise, region, size)}
        return entry
