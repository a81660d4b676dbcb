"""The target ``motor-expressions``: the motion laws of drives as text for the motors of CAD simulators."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from linkwright.exports.followed import duration
from linkwright.exports.motors.law import functions, law_of
from linkwright.exports.motors.write import expressions, sheet, values
from linkwright.exports.registry import Exported, register
from linkwright.expressions.fields import Expression, Frozen
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.units import TIME
from linkwright.findings import Finding
from linkwright.formulas.motor import MotorProgram, motor, unit_of
from linkwright.formulas.pieces import MOST, FormulaPiece, TooManyError, Unfolding
from linkwright.kernels import Compiled
from linkwright.studies import RunContext
from linkwright.words import say

PROVEN = 1e-9
"""How far a text may be off its law, over the largest value of the law."""


class MotorOptions(Frozen):
    """How the texts are written, and over which time."""

    dialect: Literal["creo", "radians"] = "creo"
    duration: Annotated[Expression | None, Quantity(TIME)] = None
    samples: int = Field(360, ge=1, le=100_000)


@register
class MotorExpressions:
    """The motion laws of drives as piecewise text in t, and as tables."""

    redundant = True  # laws of drives alone
    name = "motor-expressions"
    example = "{dialect: creo}"
    options = MotorOptions

    def check(self, compiled: Compiled, options: MotorOptions) -> list[Finding]:
        """A duration without a value."""
        return duration(compiled, None, self.name, options.duration)[1]

    def export(self, compiled: Compiled, options: MotorOptions, site: RunContext) -> Exported:
        """The texts, each held to its drive's law."""
        stop, findings = duration(compiled, site.document, self.name, options.duration)
        if stop is None:
            return Exported(failures=findings or [Finding("export.no-duration", data={"export": self.name})])
        t = np.linspace(0.0, stop, options.samples + 1)
        table, motors, warnings = values(compiled, t), dict[str, MotorProgram](), list[Finding]()
        for drive in compiled.mechanism.movers:
            if (law := law_of(compiled, drive)) is None:
                warnings.append(
                    Finding(
                        "export.no-formula", compiled.mechanism.path_of(drive), {"drive": drive}, severity="warning"
                    )
                )
                continue
            unfolding = Unfolding(stop, compiled.quantities.parameters, functions(compiled, law, site.folder))
            try:
                motors[drive] = _motor(compiled, drive, unfolding.pieces(law), options.dialect, stop)
            except TooManyError:
                data = {"drive": drive, "limit": MOST}
                warnings.append(
                    Finding("export.too-many-pieces", compiled.mechanism.path_of(drive), data, severity="warning")
                )
        if failures := _unproven(compiled, motors, t):
            return Exported(failures=failures, warnings=warnings)
        files = {
            "motors.txt": sheet(compiled, motors, options.dialect, stop),
            "motors.csv": expressions(motors),
            "motion.csv": table,
        }
        summary = {
            "dialect": options.dialect,
            "duration": stop,
            "motors": {drive: _summary(made) for drive, made in motors.items()},
            "max_error": max((made.error * made.size for made in motors.values()), default=0.0),
        }
        told = [
            say("motors.told", drive=drive, count=len(made.rows), error=f"{made.error:.1e}", unit=made.unit)
            for drive, made in motors.items()
        ]
        return Exported(files, summary, told, [], warnings)


def _motor(compiled: Compiled, drive: str, pieces: Sequence[FormulaPiece], dialect: str, stop: float) -> MotorProgram:
    unit, motion = unit_of(compiled.quantities, compiled.quantities.drive_dimension(drive)), compiled.laws[drive]
    return motor(pieces, unit, lambda t: motion(t).d[0], dialect, stop)


def _summary(made: MotorProgram) -> dict[str, object]:
    pieces = [{"domain": domain, "text": row.text} for domain, row in zip(made.domains, made.rows, strict=True)]
    return {"unit": made.unit, "pieces": pieces, "max_error": made.error}


def _unproven(compiled: Compiled, motors: dict[str, MotorProgram], t: np.typing.NDArray[np.float64]) -> list[Finding]:
    """A failure for each drive whose text isn't its law."""
    found = []
    for drive, made in motors.items():
        largest = float(np.abs(compiled.laws[drive](t).d[0]).max()) / made.size
        if not made.error <= PROVEN * max(largest, 1.0):
            data = {"name": drive, "error": f"{made.error:.1e}", "unit": made.unit}
            found.append(Finding("export.unproven", compiled.mechanism.path_of(drive), data))
    return found
