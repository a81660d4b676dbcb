"""Tables as CSV text: heads with units, numbers with all their digits, blank cells where there is none."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterable
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright import escape

EMPTY = '""'
"""A row of one blank cell: a line with nothing in it is no row."""

ROWS = 1 << 10
"""So many rows are put into text at once."""


def head(name: str, unit: str) -> str:
    """A column's head: its name and unit."""
    return f"{name} [{unit}]" if unit else name


def cell(value: float | int) -> str:
    """A number."""
    return repr(value) if isfinite(value) else ""


def numbers_text(header: list[str], columns: Iterable[NDArray[Any]]) -> str:
    """A table of numbers alone, from its columns; a cell is blank where a number isn't finite."""
    every = [*columns]
    parts = [_written(header, ())]
    # A number as a text takes ten times its memory: a part of the rows at a time.
    for first in range(0, len(every[0]) if every else 0, ROWS):
        some = (_cells(column[first : first + ROWS]) for column in every)
        rows = (",".join(row) or EMPTY for row in zip(*some, strict=True))  # numbers need no quotes
        parts.append("".join(f"{row}\n" for row in rows))
    return "".join(parts)


def table_text(header: list[str], rows: Iterable[list[str]]) -> str:
    """The whole table; no cell but a number begins as a formula does."""
    return _written(header, (map(escape.cell, row) for row in rows))


def with_heads(text: str, renamed: Callable[[str], str]) -> str:
    """The text of a table with other heads."""
    first, _, rest = text.partition("\n")
    heads = next(csv.reader([first]), [])
    return _written([renamed(head) for head in heads], ()) + rest


def _written(header: list[str], rows: Iterable[Iterable[Any]]) -> str:
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(map(escape.cell, header))
    writer.writerows(rows)
    return stream.getvalue()


def _cells(column: NDArray[Any]) -> list[str]:
    """The numbers of a column as :func:`cell` has them."""
    known, texts = np.isfinite(column), [*map(repr, column.tolist())]
    return texts if known.all() else [text if there else "" for text, there in zip(texts, known, strict=True)]
