"""What a study shows, in words: the blocks of its report by their kind, its tables as texts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from linkwright.presentation.blocks import Bullets, Section, Sentences, StudyReport, Table

Kind = TypeVar("Kind")


def blocks(report: StudyReport, kind: type[Kind]) -> list[Kind]:
    """The blocks of a kind in all sections of a report, those with nothing in them too."""
    return [block for section in report.sections for block in section.blocks if isinstance(block, kind)]


def heads(table: Table) -> list[str]:
    """A table's heads."""
    return [str(head) for head in table.heads]


def rows(table: Table) -> list[list[str]]:
    """A table's rows, each as long as its heads."""
    texts = [[str(cell) for cell in row] for row in table.rows]
    assert all(len(row) == len(table.heads) for row in texts)
    return texts


def tables(made: Sequence[Table]) -> dict[str, list[list[str]]]:
    """The rows of tables by the tables' names."""
    return {table.name: rows(table) for table in made}


def told(section: Section) -> str:
    """The sentences of a section as one text."""
    parts = [block for block in section.blocks if isinstance(block, Sentences | Bullets)]
    return " ".join(str(text) for part in parts for text in part.texts)
