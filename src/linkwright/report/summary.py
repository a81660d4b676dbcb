"""A cycle as plain data: its part of ``summary.json``."""

from __future__ import annotations

from typing import Any

from linkwright.expressions.units import TIME
from linkwright.measures import Grade
from linkwright.results import Certificate, Result
from linkwright.studies import CycleOutcome, MeasureResult


def cycle_entry(outcome: CycleOutcome) -> dict[str, Any]:
    """The run, its measures (in the file's units) and its certificate."""
    run = outcome.result.run
    time_unit, second = run.compiled.quantities.unit_of(TIME)
    return {
        "run": {
            "start": run.start / second,
            "stop": run.stop / second,
            "unit": time_unit,
            "rows": run.t.size,
            "kernel": run.compiled.kernel,
        },
        "measures": {m.name: measure_entry(m, second, time_unit) for m in outcome.measures},
        "certificate": certificate_entry(outcome.result, second, time_unit),
    }


def measure_entry(m: MeasureResult, second: float, time_unit: str) -> dict[str, Any]:
    """One measure: ``value`` (or ``min`` and ``max``) and ``unit``, where it happens, and its verdict."""
    entry: dict[str, Any] = {(f.label or "value"): None if f.unbounded else f.value / m.size for f in m.found}
    entry["unit"] = m.unit

    def put(key: str, each: dict[str, Any]) -> None:
        """What is known of a measure's numbers: of the only one itself, of several by their labels."""
        if each:
            entry[key] = each.get("", each)

    put("at", {f.label: f.time / second for f in m.found if f.time is not None})
    if "at" in entry:
        entry["at_unit"] = time_unit
    far = [f for f in m.found if f.unbounded]
    put("unbounded", {f.label: {"side": f.side, "t": (f.time or 0.0) / second, "to": _sign(f.value)} for f in far})
    put("approached", {f.label: f.side for f in m.found if f.side and not f.unbounded})
    put("grade", {f.label: grade_entry(f.grade, second) for f in m.found})
    if m.requirement is not None:
        entry |= {"require": m.requirement, "met": m.verdict}
    return entry


def _sign(value: float) -> str:
    return "+infinity" if value > 0 else "-infinity"


def grade_entry(grade: Grade, second: float) -> dict[str, Any]:
    """How sure a number is: ``kind``, and of a searched one the ``width`` below which features may be missed and
    why it isn't enclosed, where that was tried."""
    entry: dict[str, Any] = {"kind": grade.kind.value}
    if grade.width is not None:
        entry["width"] = grade.width / second
    return entry | ({"not_enclosed": grade.reason} if grade.reason else {})


def certificate_entry(result: Result, second: float, time_unit: str) -> dict[str, Any] | None:
    """The certificate's figures; ``None`` where the motion can't be followed."""
    c: Certificate | None = result.certificate
    if c is None:
        return None
    entry: dict[str, Any] = {
        "closure": c.closure,
        "equilibrium": c.equilibrium,
        "power": c.power,
        "work": c.work,
        "measures": c.measures,
    }
    entry |= {"mobility": c.mobility, "gruebler": c.gruebler, "rank": c.rank, "loops": c.loops}
    if c.nearest is not None:
        entry["smallest_determinant"] = c.nearest.determinant
        entry["smallest_determinant_at"] = {
            "group": c.nearest.group,
            "time": c.nearest.time / second,
            "unit": time_unit,
        }
    if c.changes:
        entry["branch_changes"] = {group: [time / second for time in times] for group, times in c.changes.items()}
    if c.followed:
        entry["followed"] = {group: {"steps": n, "correction": worst} for group, (n, worst) in c.followed.items()}
    branches = {group: str(rule) for group, rule in c.branches.items()}
    return entry | {"branches": branches, "poses": c.poses, "kernel": c.kernel, "kernel_reason": str(c.choice.reason)}
