"""Required and largest figures of a workspace study as a table and in its pictures."""

from __future__ import annotations

from typing import Any

from linkwright.findings import Said, Text
from linkwright.presentation.blocks import Table
from linkwright.studies.workspace.fits_outcome import Required
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.overlay import Overlay


def fit_tables(outcome: WorkspaceOutcome) -> list[Table]:
    """Each figure in each region."""
    part: Required = outcome.parts["fits"]
    names = [*outcome.options.for_]
    own = ("size", "centre", "fits", "margin", "scale")
    heads: list[Text] = [Said("fits.column.figure"), *names, Said("workspace.column.mode")]
    heads += [*(Said(f"fits.column.{c}") for c in own), Said("workspace.column.unit")]
    rows = [
        [
            entry["figure"],
            *(f"{entry[name]:.6g}" for name in names),
            entry["mode"] or Said("workspace.one-mode"),
            *_cells(entry),
            entry["unit"],
        ]
        for entry in part.as_dict()
    ]
    return [Table("workspace-fits", Said("fits.table"), heads, rows)]


def _cells(entry: dict[str, Any]) -> list[Text]:
    x, y = entry["centre"]
    cells: list[Text] = [Said(f"fits.{entry['shape']}", **entry), f"{x:.6g}, {y:.6g}"]
    if entry["largest"]:
        return [*cells, Said("fits.largest"), "-", "-"]
    scale = f"{100 * entry['scale']:.4g} %"
    return [*cells, Said("fits.yes" if entry["fits"] else "fits.no"), f"{entry['margin']:.4g}", scale]


def fit_overlays(outcome: WorkspaceOutcome, index: int) -> list[Overlay]:
    """The figures at their best places in one workspace."""
    part: Required = outcome.parts["fits"]
    placed = part.within(index).values()
    lines = {kind: [p.outline for p in placed if p.kept == kept] for kind, kept in (("fits", True), ("misses", False))}
    return [Overlay(kind, some, Said(f"fits.kind.{kind}")) for kind, some in lines.items() if some]
