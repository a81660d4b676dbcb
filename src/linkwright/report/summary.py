"""The summary of a run as plain data: what ``summary.json`` holds."""

from __future__ import annotations

from typing import Any

import linkwright
from linkwright.model.findings import Finding
from linkwright.model.mechanism import Document
from linkwright.model.units import TIME
from linkwright.results import Certificate, Result
from linkwright.studies import CycleOutcome, MeasureResult


def summary(document: Document, outcome: CycleOutcome | None, findings: list[Finding]) -> dict[str, Any]:
    """Name, verdict, measures (in the file's units), certificate, and all findings of the file and its run."""
    data: dict[str, Any] = {"linkwright": linkwright.__version__, "name": document.name, "done": False}
    if outcome is not None:
        quantities = outcome.result.run.compiled.quantities
        time_unit, second = quantities.unit_of(TIME)
        run = outcome.result.run
        data["done"] = outcome.done
        data["run"] = {
            "start": run.start / second,
            "stop": run.stop / second,
            "unit": time_unit,
            "rows": run.t.size,
            "kernel": run.compiled.kernel,
        }
        data["measures"] = {m.name: measure_entry(m, second, time_unit) for m in outcome.measures}
        data["certificate"] = certificate_entry(outcome.result, second, time_unit)
    data["findings"] = [finding.as_dict() for finding in findings]
    return data


def measure_entry(m: MeasureResult, second: float, time_unit: str) -> dict[str, Any]:
    """One measure: ``value`` (or ``min`` and ``max``) and ``unit``, where it happens, and its verdict."""
    entry: dict[str, Any] = {(f.label or "value"): f.value / m.size for f in m.found}
    entry["unit"] = m.unit
    places = {f.label: f.time / second for f in m.found if f.time is not None}
    if places:
        entry["at"] = places.get("", places)
        entry["at_unit"] = time_unit
    if m.requirement is not None:
        entry |= {"require": m.requirement, "met": m.verdict}
    return entry


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
    return entry | {"branches": c.branches, "poses": c.poses, "kernel": c.kernel}
