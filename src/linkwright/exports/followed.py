"""The motion that an export covers: that of the file's cycle, or as long as the target's options say."""

from __future__ import annotations

from linkwright.exports.numbers import positive
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.model.document import Document
from linkwright.results import Run
from linkwright.studies.assembly_checks import unassembled
from linkwright.studies.change_point_carry import carry_through_change_points
from linkwright.studies.cycle.options import CycleOptions, span


def cycle_of(document: Document | None) -> CycleOptions | None:
    """The options of the file's cycle, which are sound; None where it has none."""
    given = None if document is None else document.studies.get("cycle")
    return None if given is None or document is None else CycleOptions.model_validate(given, context=document.studies)


def duration(
    compiled: Compiled, document: Document | None, to: str, given: Expression | None
) -> tuple[float | None, list[Finding]]:
    """How long the motion lasts (s): as ``given`` under the target's ``duration``, else as the file's cycle; None where
    neither says so."""
    if given is None:
        cycle = cycle_of(document)
        return (None, []) if cycle is None else span(compiled, cycle)
    seconds, findings = positive(compiled, to, "duration", given, u.TIME, 0.0)
    return (None if findings else seconds), findings


def follow_motion(compiled: Compiled, document: Document | None, stop: float, steps: int) -> tuple[Run, list[Finding]]:
    """The motion to ``stop`` (s), carried through change points where the file's cycle is, and why it can't be
    followed."""
    run, kept = Run(compiled, 0.0, stop, steps), list[Finding]()
    cycle = cycle_of(document)
    if cycle is not None and cycle.through == "keep":
        run, kept = carry_through_change_points(run)
    return run, kept or unassembled(run)
