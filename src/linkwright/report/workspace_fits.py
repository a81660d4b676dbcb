"""Required and largest figures of a workspace study as a table and in its pictures."""

from __future__ import annotations

from typing import Any

from linkwright.report.data import Grid
from linkwright.report.overlay import Overlay
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.required import Required
from linkwright.words import say


def fit_tables(outcome: WorkspaceOutcome) -> list[Grid]:
    """Each figure in each region."""
    part: Required = outcome.parts["fits"]
    names = [*outcome.options.for_]
    own = ("size", "centre", "fits", "margin", "scale")
    heads = [say("fits.column.figure"), *names, say("workspace.column.mode"), *(say(f"fits.column.{c}") for c in own)]
    rows = [
        [
            entry["figure"],
            *(f"{entry[name]:.6g}" for name in names),
            entry["mode"] or say("workspace.one-mode"),
            *_cells(entry),
            entry["unit"],
        ]
        for entry in part.as_dict()
    ]
    heads.append(say("workspace.column.unit"))
    return [{"name": "workspace-fits", "title": say("fits.table"), "heads": heads, "rows": rows}]


def _cells(entry: dict[str, Any]) -> list[str]:
    x, y = entry["centre"]
    cells = [say(f"fits.{entry['shape']}", **entry), f"{x:.6g}, {y:.6g}"]
    if entry["largest"]:
        return [*cells, say("fits.largest"), "-", "-"]
    scale = f"{100 * entry['scale']:.4g} %"
    return [*cells, say("fits.yes" if entry["fits"] else "fits.no"), f"{entry['margin']:.4g}", scale]


def fit_overlays(outcome: WorkspaceOutcome, index: int) -> list[Overlay]:
    """The figures at their best places in one workspace."""
    part: Required = outcome.parts["fits"]
    placed = part.within(index).values()
    lines = {kind: [p.outline for p in placed if p.kept == kept] for kind, kept in (("fits", True), ("misses", False))}
    return [Overlay(kind, some, say(f"fits.kind.{kind}")) for kind, some in lines.items() if some]
