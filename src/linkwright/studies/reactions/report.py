"""What the reactions of a structure show: tables, plain data in the file's units, a file."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from linkwright.expressions.units import ANGLE, FORCE
from linkwright.findings import Said, Text
from linkwright.model.csv_text import cell, table_text
from linkwright.presentation.blocks import Section, StudyReport, table
from linkwright.presentation.cells import Cell, NumberCell, Unit
from linkwright.studies.reactions.outcome import Reaction, ReactionsOutcome

TINY = 1e-13
"""A value below this share of the largest one is round-off beside zero."""


def reactions_entry(outcome: ReactionsOutcome) -> dict[str, Any]:
    """What ``summary.json`` says of reactions; ``null`` where statics doesn't determine one."""
    unit, size = outcome.compiled.quantities.unit_of(FORCE)
    shown = _Shown(outcome)
    return {
        "reactions": {
            "degree": outcome.states,
            "joints": [shown.reaction(reaction) for reaction in outcome.reactions],
            "bars": {bar.link: {"value": shown.value(bar.force, size), "unit": unit} for bar in outcome.bars},
            "closure": outcome.closure,
            "equilibrium": outcome.equilibrium,
        }
    }


class _Shown:
    """Values in the file's units, round-off as zero."""

    def __init__(self, outcome: ReactionsOutcome) -> None:
        self.quantities = outcome.compiled.quantities
        values = [*(r.value for r in outcome.reactions), *(bar.force for bar in outcome.bars)]
        self.largest = max((abs(value) for value in values if value is not None), default=0.0)

    def value(self, value: float | None, size: float) -> float | None:
        """A value in a unit of this size (SI)."""
        if value is None:
            return None
        return value / size if abs(value) > TINY * self.largest else 0.0

    def reaction(self, found: Reaction) -> dict[str, Any]:
        """One component."""
        unit, size = self.quantities.unit_of(found.dimension)
        degree, one = self.quantities.unit_of(ANGLE)
        name = found.name
        if found.direction is not None:
            name += " " + str(Said("reactions.direction", angle=f"{found.direction / one:.6g}", unit=degree))
        return {"name": name, "joint": found.joint, "value": self.value(found.value, size), "unit": unit}


def report(outcome: ReactionsOutcome) -> StudyReport:
    """Reactions of the joints, forces of the bars, residuals."""
    summary = reactions_entry(outcome)
    entry = summary["reactions"]
    rows = [[r["joint"], r["name"], _number(r["value"]), Unit(r["unit"])] for r in entry["joints"]]
    bars = [
        [link, _number(bar["value"]), Unit(bar["unit"]), _kind(bar["value"])] for link, bar in entry["bars"].items()
    ]
    proof: list[list[Cell]] = [
        [Said(f"reactions.{key}"), NumberCell(entry[key], 1, form="e")] for key in ("closure", "equilibrium")
    ]
    tables = [
        table("reactions", "joints", ("joint", "reaction", "value", "unit"), rows),
        table("reactions", "bars", ("bar", "value", "unit", "kind"), bars),
        table("reactions", "proof", ("check", "residual"), proof if rows else []),
    ]
    return StudyReport([Section("reactions", tables)], summary)


def _number(value: float | None) -> NumberCell:
    return NumberCell(value, unknown=Said("reactions.open"))


def _kind(value: float | None) -> Text:
    if value is None:
        return ""
    return Said("reactions.unloaded" if value == 0 else "reactions.tension" if value > 0 else "reactions.compression")


def reactions_csv(outcome: ReactionsOutcome) -> str:
    """All components with all their digits, blank where statics doesn't determine one."""
    return table_text(["joint", "reaction", "value", "unit"], list(_lines(outcome)))


def _lines(outcome: ReactionsOutcome) -> Iterator[list[str]]:
    entry = reactions_entry(outcome)["reactions"]
    for r in entry["joints"]:
        yield [r["joint"], r["name"], cell(math.nan if r["value"] is None else r["value"]), r["unit"]]
    for link, bar in entry["bars"].items():
        value = math.nan if bar["value"] is None else bar["value"]
        yield ["", str(Said("reactions.bar", link=link)), cell(value), bar["unit"]]
