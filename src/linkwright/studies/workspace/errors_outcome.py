"""The working point's errors over each region of a study, and what tolerances leave of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import field
from math import isfinite
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.findings import ModelError, raise_errors
from linkwright.kernels import Compiled
from linkwright.studies.accuracy.clearance import PATH as CLEARANCES
from linkwright.studies.accuracy.clearance_options import check_clearances
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.workspace.causes import Causes
from linkwright.studies.workspace.errors import KINDS, errors
from linkwright.studies.workspace.errors_options import ErrorsOptions, causes
from linkwright.studies.workspace.guaranteed import Guaranteed, guaranteed
from linkwright.studies.workspace.mapped_regions import RegionMaps, part_of

if TYPE_CHECKING:
    from linkwright.studies.workspace.outcome import Workspace, WorkspaceOutcome

Array = NDArray[np.float64]

USUAL = ("error worst",)
"""The maps of which there are pictures unless the file says."""


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
            "maps": one.map_entries(self.outcome),
            "unit": unit,
            "guaranteed": {**part_of(one.sure.shape, region, size), "inward": inward},
        }
        if self.limit is not None:
            entry["precise"] = {"limit": self.limit / size, **part_of(one.sure.precise, region, size)}
        return entry


def errors_part(options: ErrorsOptions, outcome: WorkspaceOutcome) -> ErrorsPart:
    """The error maps of each region, and its guaranteed part."""
    compiled = outcome.compiled
    limit = None if options.limit is None else compiled.quantities.value(options.limit, u.LENGTH)
    part = ErrorsPart(outcome, options.steps, options.shown_maps(USUAL), options.lines(compiled, KINDS), limit)
    assert outcome.box is not None
    for workspace in outcome.workspaces:
        try:
            who = _causes(options, compiled, workspace)
        except ModelError as error:  # a class may have no tolerance for a length that is varied
            outcome.failures += error.findings
            continue
        for reached in workspace.regions:
            maps = errors(reached.region.sheet, outcome.box, who, options.steps)
            sure = guaranteed(reached.region, who, limit, options.steps)
            part.regions.append(RegionErrors(workspace, reached, maps, maps.extremes(), who, sure))
    return part


def _causes(options: ErrorsOptions, compiled: Compiled, workspace: Workspace) -> Causes:
    """What deviates where parameters have the values of a workspace."""
    stated = options.deviation_options
    assert stated is not None
    if workspace.regions:
        compiled = at_values(compiled, workspace.regions[0].region.sheet.parameters)
        raise_errors([*check_clearances(compiled, stated.clearances, CLEARANCES)])
    return selected_causes(causes(compiled, stated), options.contributors)


def at_values(compiled: Compiled, parameters: Array) -> Compiled:
    """A mechanism whose numbers are read at other values of its parameters; not one to run."""
    other, quantities = copy(compiled), copy(compiled.quantities)
    quantities.parameters = dict(zip(compiled.graph.parameters, parameters.tolist(), strict=True))
    other.quantities = quantities
    return other


def selected_causes(every: Causes, names: Sequence[str] | None) -> Causes:
    """Some of them by name, with the correlations between contributors."""
    if names is None:
        return every
    known = every.contributors
    rows = [i for i, name in enumerate(known.names) if name in names]
    some = Contributors(tuple(known.every[i] for i in rows), known.correlation[np.ix_(rows, rows)], known.parameters)
    return Causes(some, tuple(one for one in every.held if one.joint in names))
