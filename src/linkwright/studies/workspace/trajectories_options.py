"""The section ``trajectories`` of a workspace study's options: which drive is held, at which values."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any

from pydantic import Field

from linkwright.elements.fields import DriveName
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.typed_fields import Context, of_drive
from linkwright.expressions.units import ANGLE, LENGTH
from linkwright.expressions.written import Fault
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.model.mechanism import Mechanism
from linkwright.studies.numbers import constant
from linkwright.studies.workspace.path_options import positive

if TYPE_CHECKING:
    from linkwright.studies.workspace.options import WorkspaceOptions

PATH = ("studies", "workspace", "trajectories")
MOST = 720
"""The most values of the held drive."""


def _held_drive_name(c: Context) -> str:
    """The drive that is held, where there are two."""
    return held_drive(c.mechanism, c.entry.hold) if len(c.mechanism.drives) == 2 else ""


class TrajectoriesAsked(Frozen):
    """Trajectories of the working point at constant values of one of two drives."""

    hold: DriveName | None = None
    steps: int | None = Field(None, ge=1, le=MOST)
    every: Annotated[Expression | None, of_drive(ANGLE, LENGTH, _held_drive_name)] = Field(None, examples=["10 deg"])
    chord: float = Field(2e-4, ge=1e-6, le=1e-2)

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if "steps" in given and "every" in given:
            yield "workspace.hold-steps", {}

    def check(self, compiled: Compiled, options: WorkspaceOptions) -> Iterator[Finding]:
        """What is wrong with the drive and its steps."""
        drives = compiled.graph.drives
        if len(drives) != 2:
            yield Finding("workspace.two-drives", PATH, {"section": PATH[-1]})
            return
        if self.every is not None and self.hold in (None, *drives):
            yield from self._step(compiled, options, self.every)

    def _step(self, compiled: Compiled, options: WorkspaceOptions, every: Expression) -> Iterator[Finding]:
        """What is wrong with the step of the held drive."""
        drive, at = held_drive(compiled.mechanism, self.hold), (*PATH, "every")
        dimension = compiled.quantities.drive_dimension(drive)
        if wrong := positive(compiled, every, dimension, at):
            yield from wrong
            return
        ends, step = (
            options.range_and_faults(compiled, drive)[0],
            constant(compiled.quantities, every, dimension, at)[0],
        )
        if ends is not None and step is not None and (count := (ends[1] - ends[0]) / step) > MOST:
            data = {"drive": drive, "count": f"{count:.6g}", "limit": MOST}
            yield Finding("workspace.hold-many", at, data)


def held_drive(mechanism: Mechanism, named: str | None) -> str:
    """The drive that is held: the named one; else, of a motor of constant speed and a servo, the servo; else the
    second."""
    laws = mechanism.drives.items()
    servos = [drive for drive, law in laws if law.speed is None or law.acceleration is not None]
    return named or (servos[0] if len(servos) == 1 else [*mechanism.drives][-1])
