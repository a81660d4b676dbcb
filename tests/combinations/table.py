"""The matrix: every mechanism by every column, judged; and the page on it, made of what came of each cell.

The outcomes are kept in docs/validation/matrix.json: of each mechanism and column an empty list where the cell is
right, else the codes of the findings that refuse it.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from combinations.columns import COLUMNS
from combinations.mechanisms import MECHANISMS
from combinations.performing import Cell, judged

PAGE = Path(__file__).resolve().parents[2] / "docs" / "validation" / "matrix.md"
KEPT = PAGE.with_suffix(".json")
Outcomes = dict[str, dict[str, list[str]]]
GROUPS = {"study": "Studies", "drive": "Drives", "export": "Exports", "other": "Report, copies, change points"}
MARK = "<!-- {0} -->\n{1}<!-- end of {0} -->\n"


def cell(row: str, name: str) -> Cell:
    """One cell, performed and judged."""
    mechanism = MECHANISMS[row]
    return judged(lambda: COLUMNS[name].perform(mechanism))


def kept() -> Outcomes:
    """The outcomes that are kept."""
    found: Outcomes = json.loads(KEPT.read_text("utf-8")) if KEPT.exists() else {}
    return found


def keep(outcomes: Outcomes) -> None:
    """Keep outcomes: those of all rows and columns that there are, a row a line."""
    rows = []
    for row in (row for row in MECHANISMS if row in outcomes):
        cells = {name: outcomes[row][name] for name in COLUMNS if name in outcomes[row]}
        rows.append(f"  {json.dumps(row)}: {json.dumps(cells)}")
    KEPT.write_text("{\n" + ",\n".join(rows) + "\n}\n", encoding="utf-8")


def codes_of(outcomes: Outcomes) -> list[str]:
    """All codes of refusals, the most frequent first: their numbers in the tables."""
    counts = Counter(code for row in outcomes.values() for codes in row.values() for code in codes)
    return [code for code, _ in sorted(counts.items(), key=lambda pair: (-pair[1], pair[0]))]


def tables(outcomes: Outcomes) -> str:
    """A table for each group of columns: a bullet where a cell is right, numbers of findings where it is refused."""
    numbers = {code: str(number) for number, code in enumerate(codes_of(outcomes), start=1)}
    parts = []
    for group, title in GROUPS.items():
        names = [name for name, column in COLUMNS.items() if column.group == group]
        lines = [f"### {title}\n", f"| mechanism | {' | '.join(names)} |", "|---" * (len(names) + 1) + "|"]
        for row, cells in outcomes.items():
            shown = [", ".join(numbers[code] for code in cells[name]) or "●" for name in names]
            lines.append(f"| {row} | {' | '.join(shown)} |")
        parts.append("\n".join(lines) + "\n")
    return "\n".join(parts)


def legend(outcomes: Outcomes) -> str:
    """The numbers of the tables with their findings."""
    counts = Counter(code for row in outcomes.values() for codes in row.values() for code in codes)
    lines = ["| number | finding | cells |", "|---|---|---|"]
    for number, code in enumerate(codes_of(outcomes), start=1):
        lines.append(f"| {number} | [`{code}`](../findings.md#{code}) | {counts[code]} |")
    return "\n".join(lines) + "\n"


def counts(outcomes: Outcomes) -> str:
    """How many cells were tried, are right and refused: by column, by kind of element, of all."""
    parts = []
    by_column = {name: [row[name] for row in outcomes.values()] for name in COLUMNS}
    by_kind: dict[str, list[list[str]]] = {}
    for row, mechanism in MECHANISMS.items():
        for kind in mechanism.kinds or ("other",):
            by_kind.setdefault(kind, []).extend(outcomes[row].values())
    for head, groups in (("column", by_column), ("kind", by_kind)):
        lines = [f"| {head} | cells | right | refused |", "|---|---|---|---|"]
        lines += [_counted(name, cells) for name, cells in groups.items()]
        if head == "column":
            lines.append(_counted("**all**", [one for cells in groups.values() for one in cells]))
        parts.append("\n".join(lines) + "\n")
    return "\n".join(parts)


def _counted(name: str, cells: Iterable[list[str]]) -> str:
    refused = [bool(codes) for codes in cells]
    return f"| {name} | {len(refused)} | {refused.count(False)} | {refused.count(True)} |"


def page(text: str, outcomes: Outcomes) -> str:
    """The page's text with its tables made of outcomes."""
    made = {"counts": counts(outcomes), "cells": tables(outcomes), "findings": legend(outcomes)}
    for name, table in made.items():
        pattern = re.escape(MARK.format(name, "\0")).replace("\0", ".*?")
        text, found = re.subn(pattern, lambda _, t=table, n=name: MARK.format(n, t), text, flags=re.DOTALL)
        assert found == 1, f"the page has no place for {name}"
    return text
