"""How the parts of a workspace study are written, beside its regions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.findings import Text
from linkwright.presentation.blocks import Chart, Table
from linkwright.studies.workspace import maps_report as maps
from linkwright.studies.workspace.fits_report import fit_overlays, fit_tables
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.overlay import Overlay
from linkwright.studies.workspace.path_files import drives_yaml, laws_csv
from linkwright.studies.workspace.paths_report import path_charts, path_overlays, path_sentences, path_tables
from linkwright.studies.workspace.trajectories_report import (
    trajectories_charts,
    trajectories_csv,
    trajectories_sentences,
    trajectories_svg,
    trajectories_tables,
)


@dataclass(frozen=True)
class SectionDocument:
    """A part's sentences, charts and tables, from the outcome; shapes (Shapely, m) with what is said of them; the
    content of its files by name (or None); what it draws over the picture of the workspace of some index."""

    sentences: Callable[[WorkspaceOutcome], Sequence[Text]] = lambda outcome: ()
    charts: Callable[[WorkspaceOutcome], Sequence[Chart]] = lambda outcome: ()
    tables: Callable[[WorkspaceOutcome], Sequence[Table]] = lambda outcome: ()
    shapes: Callable[[WorkspaceOutcome], Iterable[tuple[Any, dict[str, Any]]]] = lambda outcome: ()
    files: Mapping[str, Callable[[WorkspaceOutcome], Any]] = field(default_factory=dict)
    overlays: Callable[[WorkspaceOutcome, int], Sequence[Overlay]] = lambda outcome, index: ()


WRITTEN: dict[str, SectionDocument] = {
    "trajectories": SectionDocument(
        sentences=trajectories_sentences,
        charts=trajectories_charts,
        tables=trajectories_tables,
        files={"workspace_trajectories.csv": trajectories_csv, "workspace_trajectories.svg": trajectories_svg},
    ),
    "quality": SectionDocument(
        sentences=maps.quality_sentences,
        charts=maps.quality_charts,
        tables=maps.quality_tables,
        files={"workspace_maps.csv": maps.quality_csv, "workspace_maps.svg": maps.quality_svg},
    ),
    "errors": SectionDocument(
        sentences=maps.errors_sentences,
        charts=maps.errors_charts,
        tables=maps.errors_tables,
        shapes=maps.errors_shapes,
        files={"workspace_errors.csv": maps.errors_csv, "workspace_errors.svg": maps.errors_svg},
    ),
    "paths": SectionDocument(
        sentences=path_sentences,
        charts=path_charts,
        tables=path_tables,
        files={"workspace_laws.csv": laws_csv, "workspace_drives.yaml": drives_yaml},
        overlays=path_overlays,
    ),
    "fits": SectionDocument(tables=fit_tables, overlays=fit_overlays),
}
"""By the key of its section in the study's options."""


def _where(key: str, content: Callable[[WorkspaceOutcome], Any]) -> Callable[[WorkspaceOutcome], Any]:
    """A file's text of an outcome that has the part; else there is none."""
    return lambda outcome: content(outcome) if key in outcome.parts else None


FILES = {name: _where(key, content) for key, part in WRITTEN.items() for name, content in part.files.items()}


def section_documents(outcome: WorkspaceOutcome) -> list[SectionDocument]:
    """How the parts that an outcome has are written."""
    return [part for name, part in WRITTEN.items() if name in outcome.parts]
