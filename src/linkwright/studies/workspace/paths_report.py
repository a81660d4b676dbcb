"""Wanted paths of a workspace study: tables, pictures, charts of the drives' laws."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import MOST_CHARTS, MOST_POSES, thinned
from linkwright.expressions import units as u
from linkwright.findings import CLAUSES, Joined, Said, Text
from linkwright.presentation.blocks import Chart, Table, table
from linkwright.presentation.cells import UNKNOWN, Cell, NumberCell, numbers, percent
from linkwright.presentation.charts import Axis, Graph, Line
from linkwright.studies.workspace.inverse_kinematics import ServoLaw
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.overlay import Overlay
from linkwright.studies.workspace.path_outcome import Attempt, PathsOutcome
from linkwright.studies.workspace.region_columns import region_cells, region_heads

Array = NDArray[np.float64]

PLACES = 721
"""Places of a path that is drawn."""


def path_sentences(outcome: WorkspaceOutcome) -> list[Text]:
    """Which determinant the tables tell of."""
    laws = [entry for entry in outcome.parts["paths"].as_dict() if entry["followed"]]
    every = dict.fromkeys(entry["determinant_of"] for entry in laws)
    return [Said("paths.sentence", determinant=one) for one in every]


def path_tables(outcome: WorkspaceOutcome) -> list[Table]:
    """Each path in each region; the drives along the best way of each."""
    part: PathsOutcome = outcome.parts["paths"]
    own = ("followed", "duration", "reversals", "limit_positions", "residual", "determinant", "share")
    rows, drives = list[list[Cell]](), list[list[Cell]]()
    for entry in part.as_dict():
        rows.append([entry["path"], *region_cells(outcome, entry), *_path_cells(entry)])
        if entry["followed"] and entry["best"]:
            drives += [[entry["path"], name, *_drive(told)] for name, told in entry["drives"].items()]
    columns = ("path", "drive", "value", "speed", "acceleration", "effort", "power", "work")
    return [
        table("paths", "paths", ("path", *region_heads(outcome), *own), rows),
        table("paths", "drives", columns, drives),
    ]


def _path_cells(entry: dict[str, Any]) -> list[Cell]:
    if not entry["followed"]:
        texts = [_stretch(one, entry["unit"]) for one in entry["stretches"]]
        told = Said("paths.not", stretches=Joined(texts, CLAUSES)) if texts else Said("paths.nothing")
        return [told, *[UNKNOWN] * 6]
    how = "best" if entry["best"] and entry["kept"] else "yes" if entry["kept"] else "reverses"
    return [
        Said(f"paths.{how}"),
        NumberCell(entry["duration"], 6, entry["time_unit"]),
        NumberCell(len(entry["reversals"])),
        NumberCell(len(entry["limit_positions"])),
        NumberCell(entry["residual"], 2, entry["unit"]),
        NumberCell(entry["determinant"], 4),
        percent(entry["servo_share"]),
    ]


def _stretch(one: dict[str, Any], unit: str) -> Said:
    ends = {"start": f"{one['from']:.4g}", "stop": f"{one['to']:.4g}"}
    return Said(f"paths.stretch.{one['why']}", by=f"{one['by']:.4g} {unit}", drive=one["drive"] or "", **ends)


def _drive(told: dict[str, Any]) -> list[Cell]:
    value, work = told["value"], told.get("work")
    largest = (told.get(key, {}) for key in ("speed", "acceleration", "effort", "power"))
    return [
        numbers((value["from"], value["to"]), 6, value["unit"]),
        *(NumberCell(one.get("largest"), 6, one.get("unit", "")) for one in largest),
        numbers((work["given"], work["taken"]), 6, work["unit"], ", ") if work else UNKNOWN,
    ]


def path_overlays(outcome: WorkspaceOutcome, index: int) -> list[Overlay]:
    """The paths over one workspace, and what of them none of its modes can follow."""
    part: PathsOutcome = outcome.parts["paths"]
    found = part.within(index).values()
    blocked = [one.wanted.of(np.linspace(s.start, s.stop, PLACES))[0] for one in found for s in one.way.stretches]
    whole = [one.wanted.of(np.linspace(0.0, 1.0, PLACES))[0] for one in found]
    lines = {"wanted": whole, "blocked": blocked}
    texts = {"wanted": Said("paths.kind.path"), "blocked": Said("paths.kind.blocked")}
    return [Overlay(kind, some, texts[kind]) for kind, some in lines.items() if some]


def path_charts(outcome: WorkspaceOutcome) -> list[Chart]:
    """The laws of both drives along the best way of each path, over the time."""
    part: PathsOutcome = outcome.parts["paths"]
    charts = [chart for one in part.best.values() if one.law is not None for chart in _charts(part, one, one.law)]
    return charts[:MOST_CHARTS]


def _charts(part: PathsOutcome, one: Attempt, law: ServoLaw) -> list[Chart]:
    units = [part.units(name) for name in law.names]
    rows = {key: (law.motor[i], law.servo[i]) for i, key in enumerate(("value", "speed", "acceleration"))}
    if law.efforts is not None and np.abs(law.efforts.effort).max() > 0:
        rows |= {"effort": (law.efforts.effort[0], law.efforts.effort[1])}
        rows |= {"power": (law.efforts.power[0], law.efforts.power[1])}
    some = thinned(law.t.size, MOST_POSES)
    charts = []
    for key, values in rows.items():
        title = Said(f"paths.chart.{key}", path=one.name)
        told = [(name, row[some], *units[k][key]) for k, (name, row) in enumerate(zip(law.names, values, strict=True))]
        for unit in dict.fromkeys(entry[2] for entry in told):
            lines = [(name, row / size) for name, row, its, size in told if its == unit]
            charts.append(_chart(part, law.t[some], title, unit, lines))
    return charts


def _chart(part: PathsOutcome, t: Array, title: Text, unit: str, lines: Sequence[tuple[str, Array]]) -> Chart:
    time_unit, second = part.compiled.quantities.unit_of(u.TIME)

    def graph() -> Graph:
        rows = [Line(name, row, k, dash=k) for k, (name, row) in enumerate(lines)]
        return Graph(Axis(Said("plot.time"), time_unit), t / second, Axis(title, unit), rows)

    return Chart(title, shown=graph)
