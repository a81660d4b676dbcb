"""CSV files beside a model: the one reader of them, which says everything that is wrong with their text and numbers."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from itertools import islice
from pathlib import Path

from linkwright.data_classes import dataclass
from linkwright.expressions.written import NO_TEXT
from linkwright.findings import Finding, Joined, ModelError, Term, capped
from linkwright.model.encodings import decoded, likely_encoding
from linkwright.model.input_files import read_beside
from linkwright.model.quantities import LARGEST

Path_ = tuple[str | int, ...]

MAX_TOLD = 10
"""So many wrong cells are told one by one."""


def listed(heads: Sequence[str]) -> Joined:
    """The heads of columns, as far as a message has room for them."""
    return Joined(head[:40] for head in heads[:20])


@dataclass(frozen=True)
class CsvFile:
    """``heads`` are the cells of the first line, ``rows`` the others that aren't blank, each with its line in the file;
    ``path`` is the place in the model that names the file; ``encoding`` is the file's where it isn't UTF-8."""

    name: str
    path: Path_
    heads: list[str]
    rows: list[tuple[int, list[str]]]
    encoding: str | None = None

    def column(self, head: str, wanted: str | None = None) -> int:
        """The number of the column with a head; ``wanted`` is what to write there. Raises :class:`ModelError`."""
        count = self.heads.count(head)
        if count > 1:
            raise ModelError([Finding("table.column-twice", self.path, {"name": head[:60], "file": self.name})])
        if count == 0:
            known = listed(self.heads)
            raise ModelError([Finding("table.no-column", self.path, {"name": wanted or head, "known": known})])
        return self.heads.index(head)

    def numbers(self, columns: Sequence[int]) -> list[list[float]]:
        """The numbers in some columns, row by row. Raises :class:`ModelError` with all cells that hold none."""
        made, findings = [], []
        for line, cells in self.rows:
            numbers = []
            for column in columns:
                cell = cells[column].strip() if column < len(cells) else ""
                numbers.append(value := finite(cell))
                if value != value:
                    data = {"row": line, "name": self.heads[column][:60], "given": cell[:40]}
                    findings.append(Finding("table.not-number", self.path, data))
            made.append(numbers)
        if findings:
            raise ModelError(capped(findings, MAX_TOLD, self.path))
        return made


def finite(cell: str) -> float:
    """A cell's number; NaN where it holds none that can be computed with."""
    try:
        value = float(cell)
    except ValueError:
        return float("nan")
    return value if abs(value) < LARGEST else float("nan")


def read_csv(name: str, folder: Path | None, path: Path_, limit: int) -> CsvFile:
    """A CSV file beside the model, of up to ``limit`` rows below its heads. Raises :class:`ModelError`."""
    text, encoding = _decoded(read_beside(name, folder, path), name, path)
    reader = csv.reader(io.StringIO(text, newline=""))
    try:
        lines = ((reader.line_num, cells) for cells in reader if any(map(str.strip, cells)))
        heads, *rows = list(islice(lines, limit + 2)) or [(1, [])]
    except csv.Error as error:
        data = {"file": name, "line": reader.line_num, "reason": str(error)}
        raise ModelError([Finding("table.bad-line", path, data)]) from None
    if len(rows) > limit:
        raise ModelError([Finding("table.long", path, {"limit": limit})])
    found = [cell.strip() for cell in heads[1]]
    if not found:
        raise ModelError([Finding("table.empty", path, {"file": name})])
    if len(found) == 1 and (sign := next((sign for sign in ";\t，；、" if sign in found[0]), None)):
        data = {"file": name, "sign": Term("tab") if sign == "\t" else Term("quoted", text=sign)}
        raise ModelError([Finding("table.separator", path, data)])
    return CsvFile(name, path, found, rows, encoding)


def _decoded(content: bytes, name: str, path: Path_) -> tuple[str, str | None]:
    """The text of a file, and its encoding where it isn't UTF-8: numbers are the same in all that are read, and names
    are compared with the model's."""
    encoding, text = None, ""
    try:
        text = content.decode("utf-8-sig")
        at = len(text[: bad.start()].encode()) if (bad := NO_TEXT.search(text)) else None
    except UnicodeDecodeError as error:
        at = error.start
        if (other := decoded(content, table=True)) and not NO_TEXT.search(other.text):
            text, encoding, at = other.text, other.encoding, None
    if at is None:
        return text, encoding
    data = {"file": name, "at": at, "line": content.count(b"\n", 0, at) + 1}
    if likely := likely_encoding(content):
        raise ModelError([Finding("table.encoding", path, {**data, "encoding": likely})])
    raise ModelError([Finding("table.not-text", path, data)])
