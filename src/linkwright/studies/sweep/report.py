"""What a sweep shows, and what ``summary.json`` says of it, in the file's units."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from linkwright.findings import Said, Text
from linkwright.presentation.blocks import Block, Section, Sentences, StudyReport, Table, table
from linkwright.presentation.cells import NumberCell, Numbers, Unit, percent
from linkwright.presentation.json_numbers import known
from linkwright.studies.shares import CONFIDENCE
from linkwright.studies.sweep.charts import charts
from linkwright.studies.sweep.outcome import Statistics, SweepOutcome
from linkwright.words import known as known_text


def sweep_entry(outcome: SweepOutcome) -> dict[str, Any]:
    """What ``summary.json`` says of a sweep."""
    return {
        "sweep": {
            "plan": outcome.plan.name,
            "samples": outcome.samples,
            "seed": outcome.options.seed if outcome.plan.chosen else None,
            "failed": outcome.failed,
            "poses": outcome.t.size,
            "kernel": outcome.kernel,
            "kernel_why": str(outcome.why),
            "vary": {name: _varied(outcome, i) for i, name in enumerate(outcome.names)},
            "measures": {s.column.name: _statistics(s) for s in outcome.measures},
            "require": _shares(outcome),
            "signals": {text: _band(outcome, text) for text in outcome.bands},
            "files": outcome.files,
        }
    }


def _varied(outcome: SweepOutcome, index: int) -> dict[str, Any]:
    quantities = outcome.compiled.quantities
    name = outcome.names[index]
    unit, size = quantities.unit_of(quantities.dimensions.of(name))
    entry: dict[str, Any] = {"unit": unit, "nominal": quantities.parameters[name] / size}
    if outcome.table is not None:
        values = outcome.table.parameters[index]
        entry |= {"min": float(values.min()) / size, "max": float(values.max()) / size}
    return entry


def _statistics(found: Statistics) -> dict[str, Any]:
    size = found.column.size
    entry: dict[str, Any] = {"unit": found.column.unit, "count": found.count}
    entry |= {"mean": known(found.mean / size), "deviation": known(found.deviation / size)}
    entry |= {"min": known(found.least / size), "max": known(found.largest / size)}
    return entry | {"min_sample": found.least_at, "max_sample": found.largest_at}


def _shares(outcome: SweepOutcome) -> dict[str, Any]:
    require = outcome.compiled.mechanism.require
    return {
        name: {
            "require": str(require[name].raw),
            "met": share.met,
            "samples": share.samples,
            "share": share.value,
            "low": share.low,
            "high": share.high,
            "confidence": None if share.low is None else CONFIDENCE,
        }
        for name, share in outcome.shares.items()
    }


def _band(outcome: SweepOutcome, text: str) -> dict[str, Any]:
    band = outcome.bands[text]
    unit, size = outcome.compiled.quantities.unit_of(band.dimension)
    return {
        "unit": unit,
        "min": known(float(np.fmin.reduce(band.least)) / size),
        "max": known(float(np.fmax.reduce(band.largest)) / size),
        "deviation_max": known(float(np.fmax.reduce(band.deviation)) / size),
        "count_min": int(band.count.min()),
    }


def report(outcome: SweepOutcome) -> StudyReport:
    """What was done, what came out, and its charts."""
    drawn, summary = charts(outcome), sweep_entry(outcome)
    blocks: list[Block] = [Sentences([sentence(outcome)]), *tables(outcome, summary["sweep"]), *drawn]
    return StudyReport([Section("sweep", blocks)], summary)


def tables(outcome: SweepOutcome, entry: dict[str, Any]) -> list[Table]:
    """What was varied, measures and their requirements, signals."""
    if not outcome.performed:
        return []

    titles: dict[str, Text] = {found.column.name: found.column.title for found in outcome.measures}

    def numbers(name: str, head: str, *keys: str) -> Table:
        """A table of figures with their units."""
        rows = [
            [titles.get(key, key), *(NumberCell(e.get(k), 6) for k in keys), Unit(e["unit"])]
            for key, e in entry[name].items()
        ]
        return table("sweep", name, (head, *keys, "unit"), rows)

    # Of a grid, whose points have no likelihood, a share of combinations is no yield.
    which = "" if outcome.plan.chosen else "-grid"
    shares = [[name, e["require"], percent(e["share"]), _interval(e)] for name, e in entry["require"].items()]
    return [
        numbers("vary", "parameter", "nominal", "min", "max"),
        numbers("measures", "measure", "mean", "deviation", "min", "max"),
        replace(
            table("sweep", "require", ("measure", "requirement", f"share{which}", "interval"), shares),
            title=Said(f"sweep.table.require{which}"),
        ),
        numbers("signals", "signal", "min", "max", "deviation_max"),
    ]


def sentence(outcome: SweepOutcome) -> Said:
    """What was done."""
    if not outcome.performed:
        return Said("sweep.sentence.none")
    key = "sweep.sentence.failed" if outcome.failed else "sweep.sentence"
    data = {"samples": f"{outcome.samples:,}", "poses": f"{outcome.t.size:,}", "failed": f"{outcome.failed:,}"}
    name = f"sweep.plan.{outcome.plan.name}"
    plan: Text = Said(name) if known_text(name) else outcome.plan.name
    return Said(key, plan=plan, kernel=outcome.kernel, **data)


def _interval(entry: dict[str, Any]) -> Numbers:
    return Numbers([] if entry["low"] is None else [percent(entry["low"]), percent(entry["high"])])
