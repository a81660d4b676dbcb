"""A batch of exports: a CSV file with a row for each mechanism, a base model with other values of its parameters.

A batch is handed over as one delivery, so it is written whole or not at all: an index without some of its rows would
look complete. All that is wrong with any row is told at once.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from linkwright import escape, gallery
from linkwright.app.exports import ExportJob, examined_for, export_of, settings_of, unknown_target, write_export
from linkwright.app.job import USUAL, Examined, Writing, read_file
from linkwright.app.results_folder import outdate
from linkwright.compilation import examine
from linkwright.data_classes import dataclass
from linkwright.exports import TARGETS, Exported
from linkwright.expressions.units import UnitError, unit
from linkwright.expressions.unknown import near
from linkwright.expressions.unknown_units import unknown_unit
from linkwright.findings import Finding, ModelError, capped
from linkwright.model import csv_text
from linkwright.model.copies import with_copies
from linkwright.model.csv_file import CsvFile, finite, listed, read_csv
from linkwright.model.document import Document, read_document, replaced
from linkwright.model.input_files import read_at_most
from linkwright.model.origin import Origin, hashed
from linkwright.model.plane import in_plane
from linkwright.model.sampled import names_in
from linkwright.model.sketch import with_sketch
from linkwright.report.batch import BatchRow, batch_page
from linkwright.words import language, say

NAME, MODEL = "name", "model"
BASE = "hinge"
"""The model of the gallery on which a row is based that names none."""
MOST = 1000
"""The most rows."""
TOLD = 50
"""So many findings are told one by one."""
INDEX = "index.html"
_HEAD = re.compile(r"([^\[\]]+?)\s*(?:\[([^\[\]]*)\])?")
_FILE_NAME = re.compile(r"\w(?:[\w .-]{0,58}[\w-])?")


@dataclass(frozen=True)
class BatchColumn:
    """A column of values: the parameter and the unit in its head, which is empty where the model declares it."""

    place: int
    head: str
    name: str
    unit: str


@dataclass
class Base:
    """A model on which rows are based, by the name that the file has for it."""

    name: str
    document: Document | None
    folder: Path | None
    content: bytes
    findings: list[Finding]

    @cached_property
    def parameters(self) -> list[str]:
        """The parameters that a row may give, derived ones too."""
        assert self.document is not None
        return [*with_sketch(in_plane(with_copies(self.document).mechanism).mechanism).parameters]


@dataclass
class Batch:
    """A file of rows as far as it is read; ``findings`` have its lines, and the row's name and the column as path;
    ``unknown`` are the columns for which no model has a parameter."""

    table: CsvFile
    folder: Path
    findings: list[Finding] = field(default_factory=list)
    bases: dict[str, Base] = field(default_factory=dict)
    unknown: set[str] = field(default_factory=set)

    def note(self, code: str, path: tuple[str, ...], at: int, **data: Any) -> None:
        """Add a finding."""
        self.findings.append(Finding(code, path, data, at))

    @cached_property
    def columns(self) -> list[BatchColumn]:
        """The columns of values."""
        found: list[BatchColumn] = []
        for place, head in enumerate(self.table.heads):
            if head in (NAME, MODEL):
                continue
            parts = _HEAD.fullmatch(head)
            name, of = (parts[1], parts[2] or "") if parts else ("", "")
            if parts is None:
                self.note("batch.head", (head[:60],), 1, head=head[:60])
            elif name in [column.name for column in found]:
                self.note("table.column-twice", (head[:60],), 1, name=name[:60], file=self.table.name)
            else:
                try:
                    unit(of)
                except UnitError as error:
                    self.note("units.unknown", (head[:60],), 1, **unknown_unit(of, error))
                else:
                    found.append(BatchColumn(place, head, name, of))
        return found

    def rows(self) -> Iterator[tuple[int, str, str, list[str]]]:
        """Line, name, model and cells of the rows; what is wrong with their form is noted."""
        if NAME not in self.table.heads:
            self.note("batch.no-name", (), 1, known=listed(self.table.heads))
            return
        at = self.table.column(NAME)
        based = [self.table.column(MODEL)] if MODEL in self.table.heads else []
        names: dict[str, int] = {}
        if not self.table.rows:
            self.note("batch.empty", (), 1, file=self.table.name)
        for line, cells in self.table.rows:
            cells = [cell.strip() for cell in cells] + [""] * (len(self.table.heads) - len(cells))
            name = cells[at]
            if any(cells[len(self.table.heads) :]):
                self.note("batch.cells", (name[:60],), line, count=len(cells), heads=len(self.table.heads))
            if not _FILE_NAME.fullmatch(name):
                self.note("batch.name", (NAME,), line, name=name[:60])
            elif (first := names.setdefault(name.casefold(), line)) != line:
                self.note("batch.name-twice", (name, NAME), line, name=name, first=first)
            yield line, name, next((cells[place] for place in based), "") or BASE, cells

    def base(self, name: str, line: int) -> Base:
        """The model of the gallery, or beside the file, that a row names; what is wrong with it is told once."""
        if name not in self.bases:
            made = self.bases[name] = _base(name, self.folder)
            for f in made.findings:
                place = f"{name}:{f.line}" if f.line else name
                self.findings.append(replace(f, path=(place, *f.path), line=line))
        return self.bases[name]

    def check_heads(self) -> None:
        """Note the columns that no model of the file has a parameter for."""
        if any(base.document is None for base in self.bases.values()):
            return
        known = list(dict.fromkeys(name for base in self.bases.values() for name in base.parameters))
        for column in self.columns:
            if known and column.name not in known:
                data = {"name": column.name[:60], "near": near(column.name, [*known, NAME, MODEL])}
                self.note("name.unknown-parameter", (column.head,), 1, **data)
                self.unknown.add(column.name)

    def values(self, line: int, name: str, base: Base, cells: Sequence[str]) -> dict[str, Any]:
        """The parameters that a row gives; blank cells leave them as the model has them."""
        given: dict[str, Any] = {}
        for column in self.columns:
            cell = cells[column.place]
            value = finite(cell)
            if column.name in self.unknown:
                continue
            if cell and base.document is not None and column.name not in base.parameters:
                told = {"name": column.name[:60], "model": base.name[:60]}
                self.note("batch.parameter", (name, column.head), line, **told)
            elif cell and value != value:
                data = {"row": line, "name": column.head[:60], "given": cell[:40]}
                self.note("table.not-number", (name, column.head), line, **data)
            elif cell:
                given[column.name] = f"{value!r} {column.unit}" if column.unit not in ("", "1") else value
        return given


def _base(name: str, folder: Path) -> Base:
    if name in gallery.names():
        content = gallery.text(name, language()).encode()
        document, source = read_document(content)
        return Base(name, document, None, content, source.findings)
    read = read_file(folder / name)
    if read.content is None:
        finding = Finding("batch.model", (), {"name": name[:60], "near": near(name, gallery.names())})
        return Base(name, None, None, b"", [finding])
    return Base(name, read.document, (folder / name).parent, read.content, read.findings)


def template(model: str, folder: Path) -> tuple[str, list[Finding]]:
    """A file with a row of a model's own values to start a batch from, and what is wrong with the model."""
    base = _base(model, folder)
    if base.document is None:
        return "", base.findings
    compiled, findings = examine(base.document, base.folder)
    if compiled is None:
        return "", findings
    quantities, entries = compiled.quantities, with_copies(base.document).mechanism.parameters
    heads, cells = [NAME, MODEL], [f"{Path(model).stem}-1", model]
    for name in entries:
        if not names_in(entries[name].value.node):
            of, size = quantities.unit_of(quantities.dimensions.of(name))
            heads.append(csv_text.head(name, of))
            cells.append(f"{quantities.parameters[name] / size:.12g}")
    return csv_text.table_text(heads, [cells]), []


def export_batch(
    path: Path,
    to: str,
    folder: Path,
    how: Writing = USUAL,
    settings: Sequence[str] = (),
    given: Mapping[str, Any] | None = None,
) -> ExportJob:
    """Export every row of a CSV file and write all files with an index to a folder, or none where something is wrong.

    ``settings`` and ``given`` are options for all rows, as :func:`linkwright.app.examine_export` has them. Raises
    OSError where the folder can't be written to.
    """
    try:
        options = {**(given or {}), **settings_of(settings)}
        if to not in TARGETS:
            raise ModelError([unknown_target(to)])
        batch = Batch(_table(path), path.parent)
        if batch.table.encoding is not None:  # its texts become names of files
            batch.findings.append(Finding("file.read-as", (), {"encoding": batch.table.encoding}, 1, "warning"))
        done = list(_performed(batch, to, options))
    except ModelError as error:
        return ExportJob(Examined(findings=[*error.findings], file=path), to)
    findings = sorted(batch.findings, key=lambda finding: finding.line or 0)
    examined = Examined(findings=capped(findings, TOLD), file=path)
    failures = [failure for row in done for failure in row.exported.failures]
    warnings = [warning for row in done for warning in row.exported.warnings]
    models = {base.name: hashed(base.content) for base in batch.bases.values()}
    origin, kind = Origin(escape.line(path.name), hashed(read_at_most(path)), models), f"export {to}"
    if failures or examined.exit_code:
        job = ExportJob(examined, to, Exported(failures=failures, warnings=warnings))
        job.outdated = outdate(folder, origin, kind)
        return job
    heads = [batch.table.heads[column.place] for column in batch.columns]
    files = {f"{row.name}_{name}": content for row in done for name, content in row.exported.files.items()}
    files[INDEX] = batch_page(path.name, to, heads, done, origin)
    summary = {"rows": {row.name: {"model": row.model, **row.exported.summary} for row in done}}
    sentences = [say("batch.row", name=row.name, text=text) for row in done for text in row.exported.sentences]
    job = ExportJob(examined, to, Exported(files, summary, sentences, [], warnings))
    return write_export(examined, to, lambda: job, origin, folder, how)


def _table(path: Path) -> CsvFile:
    try:
        return read_csv(path.name, path.parent, (), MOST)
    except ModelError as error:  # here the file isn't one that a model names
        codes = {"table.unreadable": "file.unreadable"}
        raise ModelError([replace(f, code=codes.get(f.code, f.code)) for f in error.findings]) from None


def _performed(batch: Batch, to: str, options: Mapping[str, Any]) -> Iterator[BatchRow]:
    """The rows that are sound, exported; findings on others are added to the batch's."""
    rows = [(line, name, batch.base(model, line), cells) for line, name, model, cells in batch.rows()]
    batch.check_heads()
    for line, name, base, cells in rows:
        given = batch.values(line, name, base, cells)
        if base.document is None or any(f.line in (1, line) and f.severity == "error" for f in batch.findings):
            continue

        def placed(findings: Sequence[Finding], name: str = name, line: int = line) -> list[Finding]:
            return [_placed(batch, finding, name, line) for finding in findings]

        try:
            document = replaced(base.document, given)
            title = say("batch.title", model=document.name or base.name, name=name)
            document = document.model_copy(update={"name": title})
            job = export_of(examined_for(document, base.folder, to, options), to)
        except ModelError as error:
            batch.findings += placed(error.findings)
            continue
        batch.findings += placed(job.examined.findings)
        if (exported := job.exported) is not None:
            failures, warnings = placed(exported.failures), placed(exported.warnings)
            shown = [cells[column.place] for column in batch.columns]
            yield BatchRow(name, base.name, shown, replace(exported, failures=failures, warnings=warnings))


def _placed(batch: Batch, finding: Finding, name: str, line: int) -> Finding:
    """A finding on a row's mechanism, in the row; one on a parameter in its column."""
    heads = {("parameters", column.name): column.head for column in batch.columns}
    head = heads.get((str(finding.path[0]), str(finding.path[1]))) if len(finding.path) > 1 else None
    return replace(finding, path=(name, head) if head else (name, *finding.path), line=line)
