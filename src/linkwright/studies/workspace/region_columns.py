"""What tables of a workspace study say of the region that a row is about: varied parameters and assembly mode."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from linkwright.findings import Joined, Said, Text
from linkwright.presentation.cells import Cell, NumberCell
from linkwright.studies.workspace.outcome import WorkspaceOutcome


def value_heads(outcome: WorkspaceOutcome) -> list[Text]:
    """Heads of the columns of varied parameters: their names."""
    return [Joined([name]) for name in outcome.options.for_]


def region_heads(outcome: WorkspaceOutcome) -> list[Text]:
    """These, and that of the mode."""
    return [*value_heads(outcome), Said("workspace.column.mode")]


def value_cells(outcome: WorkspaceOutcome, entry: Mapping[str, Any]) -> list[Cell]:
    """The values of the varied parameters in an entry of the summary."""
    return [NumberCell(entry[name], 6) for name in outcome.options.for_]


def region_cells(outcome: WorkspaceOutcome, entry: Mapping[str, Any]) -> list[Cell]:
    """These, and the mode."""
    return [*value_cells(outcome, entry), mode_cell(entry)]


def mode_cell(entry: Mapping[str, Any]) -> Text:
    """The mode of an entry."""
    return entry["mode"] or Said("workspace.one-mode")
