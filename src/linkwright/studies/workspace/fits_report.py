"""Required and largest figures of a workspace study as a table and in its pictures."""

from __future__ import annotations

from typing import Any

from linkwright.findings import Said
from linkwright.presentation.blocks import Table, table
from linkwright.presentation.cells import Cell, NumberCell, Unit, numbers, percent
from linkwright.studies.workspace.fits_outcome import Required
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.overlay import Overlay
from linkwright.studies.workspace.region_columns import region_cells, region_heads


def fit_tables(outcome: WorkspaceOutcome) -> list[Table]:
    """Each figure in each region."""
    part: Required = outcome.parts["fits"]
    own = ("size", "centre", "fits", "margin", "scale", Said("workspace.column.unit"))
    rows = [
        [entry["figure"], *region_cells(outcome, entry), *_cells(entry), Unit(entry["unit"])]
        for entry in part.as_dict()
    ]
    return [table("fits", "fits", ("figure", *region_heads(outcome), *own), rows)]


def _cells(entry: dict[str, Any]) -> list[Cell]:
    centre = numbers(entry["centre"], 6, apart=", ")
    fits = "largest" if entry["largest"] else "yes" if entry["fits"] else "no"
    margin, scale = (None, None) if entry["largest"] else (entry["margin"], entry["scale"])
    return [
        Said(f"fits.{entry['shape']}", **entry),
        centre,
        Said(f"fits.{fits}"),
        NumberCell(margin, 4),
        percent(scale),
    ]


def fit_overlays(outcome: WorkspaceOutcome, index: int) -> list[Overlay]:
    """The figures at their best places in one workspace."""
    part: Required = outcome.parts["fits"]
    placed = part.within(index).values()
    lines = {
        kind: [p.outline for p in placed if p.passed == kept] for kind, kept in (("fits", True), ("misses", False))
    }
    return [Overlay(kind, some, Said(f"fits.kind.{kind}")) for kind, some in lines.items() if some]
