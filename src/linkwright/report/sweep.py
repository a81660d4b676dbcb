"""A sweep as plain data in the file's units, as tables, and as the section of the report."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from linkwright.escape import markup
from linkwright.report.charts import figures
from linkwright.report.data import Grid, SweepData, known
from linkwright.report.sweep_charts import charts
from linkwright.studies import SweepOutcome
from linkwright.studies.shares import CONFIDENCE
from linkwright.studies.sweep_outcome import Statistics
from linkwright.words import say


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


def sweep_tables(outcome: SweepOutcome) -> list[Grid]:
    """The same as tables of text; those with nothing in them are left out."""
    entry = sweep_entry(outcome)["sweep"]
    heads = {
        "vary": ("parameter", "nominal", "min", "max", "unit"),
        "measures": ("measure", "mean", "deviation", "min", "max", "unit"),
        "require": ("measure", "requirement", "share", "interval"),
        "signals": ("signal", "min", "max", "deviation_max", "unit"),
    }
    rows: dict[str, Iterator[list[str]]] = {
        "vary": (
            [name, _number(e["nominal"]), _number(e.get("min")), _number(e.get("max")), e["unit"]]
            for name, e in entry["vary"].items()
        ),
        "measures": (
            [name, *(_number(e[key]) for key in ("mean", "deviation", "min", "max")), e["unit"]]
            for name, e in entry["measures"].items()
        ),
        "require": ([name, e["require"], _percent(e["share"]), _interval(e)] for name, e in entry["require"].items()),
        "signals": (
            [text, *(_number(e[key]) for key in ("min", "max", "deviation_max")), e["unit"]]
            for text, e in entry["signals"].items()
        ),
    }
    grids: list[Grid] = [
        {
            "name": name,
            "title": say(f"sweep.table.{name}"),
            "heads": [say(f"sweep.column.{head}") for head in heads[name]],
            "rows": list(rows[name]),
        }
        for name in heads
    ]
    return [grid for grid in grids if grid["rows"] and outcome.performed]


def sentence(outcome: SweepOutcome) -> str:
    """What was done, in a sentence."""
    if not outcome.performed:
        return say("sweep.sentence.none")
    key = "sweep.sentence.failed" if outcome.failed else "sweep.sentence"
    data = {"samples": f"{outcome.samples:,}", "poses": f"{outcome.t.size:,}", "failed": f"{outcome.failed:,}"}
    return say(key, plan=outcome.plan.name, kernel=outcome.kernel, **data)


def sweep_page(outcome: SweepOutcome) -> dict[str, SweepData]:
    """The report's data of a sweep."""
    return {
        "sweep": {"sentence": sentence(outcome), "tables": sweep_tables(outcome), "charts": charts(outcome)},
    }


def section(data: SweepData, title: str, tables: str) -> str:
    """The report's section on a sweep; ``tables`` is its tables as HTML."""
    drawn = figures(data["charts"])
    note = f'<p class="note">{markup(say("sweep.chart.legend"))}</p>' if drawn else ""
    return (
        f'<section id="sweep"><h2>{markup(title)}</h2><p>{markup(data["sentence"])}</p>{tables}'
        f'{note}<div class="plots">{drawn}</div></section>'
    )


def _number(value: float | None) -> str:
    return "–" if value is None else f"{value:.6g}"


def _percent(share: float) -> str:
    return f"{100 * share:.4g} %"


def _interval(entry: dict[str, Any]) -> str:
    if entry["low"] is None:
        return "–"
    return f"{_percent(entry['low'])} .. {_percent(entry['high'])}"
