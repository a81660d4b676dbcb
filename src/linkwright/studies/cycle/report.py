"""What a cycle shows: its measures and its verification; and what ``summary.json`` says of it, in the file's units."""

from __future__ import annotations

from functools import partial
from itertools import starmap
from typing import Any

from linkwright.expressions.units import TIME
from linkwright.findings import Joined, Said
from linkwright.measures import BoundMeasure, MeasureResult, bound_measures
from linkwright.model.quantities import Quantities
from linkwright.presentation.blocks import Checks, Measure, Measures, MeasureValue, Section, StudyReport, Table, table
from linkwright.presentation.cells import Cell, NumberCell, Unit
from linkwright.presentation.json_numbers import known
from linkwright.reductions import Grade
from linkwright.results import Certificate, Result
from linkwright.results.certificate import RESIDUALS
from linkwright.studies.cycle.outcome import CycleOutcome
from linkwright.studies.cycle.verification import checks, remarks


def report(outcome: CycleOutcome) -> StudyReport:
    """Measures, then what verifies them."""
    certificate, quantities = outcome.result.certificate, outcome.result.run.compiled.quantities
    time_unit, second = quantities.unit_of(TIME)
    sections = [Section("measures", [Measures([measure(m, second, time_unit) for m in outcome.measures])])]
    entry = cycle_entry(outcome)
    if "overview" in entry:
        sections.append(Section("overview", overview_tables(entry["overview"], time_unit)))
    if certificate is not None:
        near = certificate.nearest
        nearest = f"{near.time / second:.6g} {time_unit}" if near else ""
        sections.append(Section("certificate", [Checks(checks(certificate, nearest), remarks(certificate))]))
    return StudyReport(sections, entry)


def overview_tables(entry: dict[str, Any], time_unit: str) -> list[Table]:
    """The overview of a cycle without measures, from its entry."""

    def place(one: dict[str, Any]) -> list[Cell]:
        return [_number(one["value"]), NumberCell(one["at"], 6)]

    def output(name: str, e: dict[str, Any]) -> list[Cell]:
        low, high = e["min"]["value"], e["max"]["value"]
        span = None if low is None or high is None else high - low
        return [name, *place(e["min"]), *place(e["max"]), _number(span), Unit(e["unit"])]

    drives = [
        [name, Said(f"overview.{key}"), *place(e), _number(e["rms"]), Unit(e["unit"])]
        for name, both in entry["drives"].items()
        for key, e in both.items()
    ]
    reactions = [
        [e["joint"], Joined(e["links"]), *place(e), _number(e["rms"]), Unit(e["unit"])] for e in entry["reactions"]
    ]
    angles = [
        [e["group"], NumberCell(e["least"]), Unit(e["unit"]), NumberCell(e["at"], 6, unknown=Said("limits.everywhere"))]
        for e in entry["transmission"]
    ]
    outputs = starmap(output, entry["outputs"].items())
    made = partial(table, "overview", at_unit=time_unit)
    return [
        made("outputs", ("output", "min", "at", "max", "at", "span", "unit"), outputs),
        made("drives", ("drive", "quantity", "peak", "at", "rms", "unit"), drives),
        made("reactions", ("joint", "links", "peak", "at", "rms", "unit"), reactions),
        made("transmission", ("group", "least", "unit", "at"), angles),
    ]


def _number(value: float | None) -> NumberCell:
    return NumberCell(value, unknown=Said("value.unbounded"))


def measure(m: MeasureResult, second: float, time_unit: str) -> Measure:
    """A measure as it is shown."""
    values = [
        MeasureValue(
            label=Said(f"measure.{f.label}") if f.label else "",
            value=None if f.unbounded else f.value / m.size,
            text=Said("value.unbounded") if f.unbounded else "",
            at="" if f.time is None else _time_phrase(f.side, f"{f.time / second:.6g} {time_unit}"),
            grade=grade_text(f.grade, second, time_unit),
        )
        for f in m.found
    ]
    return Measure(m.name, m.measure.description, values, m.unit, m.requirement, m.verdict)


def untaken(quantities: Quantities) -> Measures:
    """The measures of a file whose motion can't be followed: they have no values, and nothing required is met."""
    return Measures([_untaken(measure, measure.unit(quantities)[0]) for measure in bound_measures(quantities)])


def _untaken(measure: BoundMeasure, unit: str) -> Measure:
    absent, required = Said("measure.untaken"), measure.requirement
    values = [
        MeasureValue(label=Said(f"measure.{label}") if label else "", at="–", grade=absent)
        for label in measure.kind.labels
    ]
    requirement, verdict = (None, None) if required is None else (str(required.raw), False)
    return Measure(measure.name, measure.entry.description, values, unit, requirement, verdict)


def _time_phrase(side: str, time: str) -> Said:
    return Said(f"measure.at.{side}" if side else "measure.at", time=time)


def grade_text(grade: Grade, second: float, time_unit: str) -> Said:
    """How sure a number is, with the width below which a search may miss features."""
    width = "" if grade.width is None else f"{grade.width / second:.2g} {time_unit}"
    return Said(f"grade.{grade.kind.value}", width=width)


def cycle_entry(outcome: CycleOutcome) -> dict[str, Any]:
    """The run, its measures (in the file's units) and its certificate."""
    run = outcome.result.run
    time_unit, second = run.compiled.quantities.unit_of(TIME)
    entry = {
        "run": {
            "start": run.start / second,
            "stop": run.stop / second,
            "unit": time_unit,
            "rows": run.t.size,
            "kernel": run.compiled.kernel,
        },
        "measures": {m.name: measure_entry(m, second, time_unit) for m in outcome.measures},
    }
    if outcome.overview is not None:
        from linkwright.studies.cycle.overview import overview_entry

        entry["overview"] = overview_entry(outcome.overview, run)
    return {**entry, "certificate": certificate_entry(outcome.result, second, time_unit)}


def measure_entry(m: MeasureResult, second: float, time_unit: str) -> dict[str, Any]:
    """One measure: ``value`` (or ``min`` and ``max``) and ``unit``, where it happens, and its verdict."""
    entry: dict[str, Any] = {(f.label or "value"): None if f.unbounded else f.value / m.size for f in m.found}
    entry["unit"] = m.unit

    def put_by_label(key: str, each: dict[str, Any]) -> None:
        """What is known of a measure's numbers: of the only one itself, of several by their labels."""
        if each:
            entry[key] = each.get("", each)

    put_by_label("at", {f.label: f.time / second for f in m.found if f.time is not None})
    if "at" in entry:
        entry["at_unit"] = time_unit
    far = [f for f in m.found if f.unbounded]
    put_by_label(
        "unbounded", {f.label: {"side": f.side, "t": (f.time or 0.0) / second, "to": _sign(f.value)} for f in far}
    )
    put_by_label("approached", {f.label: f.side for f in m.found if f.side and not f.unbounded})
    put_by_label("grade", {f.label: grade_entry(f.grade, second) for f in m.found})
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
    # A figure that isn't a number is null like one of which there is nothing to check; it has its name in the list.
    residuals = {name: c.residuals.get(name) for name in (*RESIDUALS, "measures")}
    entry: dict[str, Any] = {name: None if value is None else known(value) for name, value in residuals.items()}
    if c.unknown:
        entry["not_numbers"] = [*c.unknown]
    entry |= {"mobility": c.mobility, "gruebler": c.gruebler, "rank": c.rank, "loops": c.loops}
    if c.redundant:
        entry["redundant"] = c.redundant
    if c.nearest is not None:
        entry["smallest_determinant"] = known(c.nearest.determinant)
        entry["smallest_determinant_at"] = {
            "group": c.nearest.group,
            "time": c.nearest.time / second,
            "unit": time_unit,
        }
    if c.changes:
        entry["branch_changes"] = {group: [time / second for time in times] for group, times in c.changes.items()}
    if c.followed:
        entry["followed"] = {g: {"steps": n, "correction": known(worst)} for g, (n, worst) in c.followed.items()}
    branches = {group: str(rule) for group, rule in c.branches.items()}
    return entry | {"branches": branches, "poses": c.poses, "kernel": c.kernel, "kernel_reason": str(c.choice.reason)}
