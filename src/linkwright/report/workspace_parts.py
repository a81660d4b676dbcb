"""How the parts of a workspace study are written, beside its regions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from linkwright.report import workspace_maps as maps
from linkwright.report.data import Chart, Grid
from linkwright.studies.workspace.outcome import WorkspaceOutcome


@dataclass(frozen=True)
class Written:
    """A part's sentences, charts and tables, from the outcome; shapes (Shapely, m) with what is said of them; the text
    of its files by name (none of those it lacks)."""

    sentences: Callable[[WorkspaceOutcome], Sequence[str]] = lambda outcome: ()
    charts: Callable[[WorkspaceOutcome], Sequence[Chart]] = lambda outcome: ()
    tables: Callable[[WorkspaceOutcome], Sequence[Grid]] = lambda outcome: ()
    shapes: Callable[[WorkspaceOutcome], Iterable[tuple[Any, dict[str, Any]]]] = lambda outcome: ()
    files: Mapping[str, Callable[[WorkspaceOutcome], Any]] = field(default_factory=dict)


WRITTEN: dict[str, Written] = {
    "quality": Written(
        sentences=maps.quality_sentences,
        charts=maps.quality_charts,
        tables=maps.quality_tables,
        files={"workspace_maps.csv": maps.quality_csv, "workspace_maps.svg": maps.quality_svg},
    ),
    "errors": Written(
        sentences=maps.errors_sentences,
        charts=maps.errors_charts,
        tables=maps.errors_tables,
        shapes=maps.errors_shapes,
        files={"workspace_errors.csv": maps.errors_csv, "workspace_errors.svg": maps.errors_svg},
    ),
}
"""By the key of its section in the study's options."""

FILES = {name: content for part in WRITTEN.values() for name, content in part.files.items()}


def written(outcome: WorkspaceOutcome) -> list[Written]:
    """How the parts that an outcome has are written."""
    return [part for name, part in WRITTEN.items() if name in outcome.parts]
