"""The trajectories of a study's regions at constant values of a drive, told in the file's units."""

from __future__ import annotations

import math
from dataclasses import field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.studies.workspace.outcome import Reached, Workspace
from linkwright.studies.workspace.trajectories import Trajectories, trajectories
from linkwright.studies.workspace.trajectories_options import TrajectoriesAsked, held_drive

if TYPE_CHECKING:
    from linkwright.studies.workspace.outcome import WorkspaceOutcome

Array = NDArray[np.float64]

STEPS = 36
"""Steps of the held drive's range unless the file says."""
ROUND = 1e-9
"""A range that lacks this share of a step has room for it."""


@dataclass(frozen=True)
class RegionTrajectories:
    """One region's trajectories; ``index`` is that of its workspace."""

    index: int
    workspace: Workspace
    reached: Reached
    found: Trajectories


@dataclass(eq=False)
class TrajectoriesPart:
    """The trajectories of all regions, at ``values`` (n,) in rad or m of drive number ``hold``; chords lie within
    ``chord`` (m) of them."""

    outcome: WorkspaceOutcome
    hold: int
    values: Array
    chord: float
    regions: list[RegionTrajectories] = field(default_factory=list)

    @property
    def drives(self) -> tuple[str, str]:
        """The drive that is held, and the one that moves."""
        names = self.outcome.compiled.graph.drives
        return names[self.hold], names[1 - self.hold]

    def as_dict(self) -> list[dict[str, Any]]:
        """An entry for each region."""
        return [self._entry(one) for one in self.regions]

    def _entry(self, one: RegionTrajectories) -> dict[str, Any]:
        quantities = self.outcome.compiled.quantities
        length_unit, length = quantities.unit_of(u.LENGTH)
        held, moving = self.drives
        unit, size = quantities.drive_unit(held)
        values = self.values / size
        return {
            "mode": one.reached.mode,
            **self.outcome.values_in_units(one.workspace),
            "hold": held,
            "moving": moving,
            "values": {"from": float(values[0]), "to": float(values[-1]), "count": int(values.size), "unit": unit},
            "assembled": sum(bool(each.stretches) for each in one.found.each),
            "whole": one.found.full_range_count,
            "stretches": len(one.found.stretches),
            "length": one.found.length / length,
            "unit": length_unit,
            "chord": self.chord / length,
        }


def trajectories_part(options: TrajectoriesAsked, outcome: WorkspaceOutcome) -> TrajectoriesPart:
    """The trajectories in each region."""
    assert outcome.box is not None
    drive = held_drive(outcome.compiled.mechanism, options.hold)
    hold = outcome.compiled.graph.drives.index(drive)
    values, chord = _values(options, outcome, drive), options.chord * outcome.compiled.graph.size
    part = TrajectoriesPart(outcome, hold, values, chord)
    for index, workspace in enumerate(outcome.workspaces):
        for reached in workspace.regions:
            found = trajectories(reached.region.sheet, outcome.box, hold, values, chord)
            part.regions.append(RegionTrajectories(index, workspace, reached, found))
    return part


def _values(options: TrajectoriesAsked, outcome: WorkspaceOutcome, drive: str) -> Array:
    """The values of the held drive (rad or m): (n,), rising; of a whole turn the end is left out."""
    assert outcome.box is not None
    compiled = outcome.compiled
    index = compiled.graph.drives.index(drive)
    low, high, turns = outcome.box.low[index], outcome.box.high[index], outcome.box.turns[index]
    step = (high - low) / (options.steps or STEPS)
    if options.every is not None:
        step = compiled.quantities.value(options.every, compiled.quantities.drive_dimension(drive))
    count = math.floor((high - low) / step + ROUND) + 1
    made = low + step * np.arange(count)
    return np.asarray(made[made < high - ROUND * step] if turns else np.minimum(made, high))
