"""Tables as CSV text: heads with units, numbers with all their digits, blank cells where there is none."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from math import isfinite

from linkwright import escape


def head(name: str, unit: str) -> str:
    """A column's head: its name and unit."""
    return f"{name} [{unit}]" if unit else name


def cell(value: float | int) -> str:
    """A number."""
    return repr(value) if isfinite(value) else ""


def table_text(header: list[str], rows: Iterable[list[str]]) -> str:
    """The whole table; no cell but a number begins as a formula does."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(map(escape.cell, header))
    writer.writerows(map(escape.cell, row) for row in rows)
    return stream.getvalue()
