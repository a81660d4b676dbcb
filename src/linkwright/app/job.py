"""From a model file to its results: examine, perform, write."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import field, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

from linkwright import compilation
from linkwright._machine import installed
from linkwright.app.manifest import State
from linkwright.app.results_folder import ResultsFolder, outdate
from linkwright.data_classes import dataclass
from linkwright.escape import json_text, line
from linkwright.exports import Order, Target, read_exports
from linkwright.findings import Finding, Joined, ModelError, raise_errors
from linkwright.kernels import Compiled
from linkwright.model.desugar import with_file_paths
from linkwright.model.document import Document, dump, located
from linkwright.model.input_files import STDIN, STDIN_NAME
from linkwright.model.model_file import read_model_file
from linkwright.model.origin import Origin, hashed, table_hashes
from linkwright.model.plausible import unloaded
from linkwright.model.references import option_faults
from linkwright.model.unused_parameters import unused_parameters
from linkwright.model.walk import Options, option_places
from linkwright.model.yaml_text import Source
from linkwright.presentation.blocks import FileOf
from linkwright.presentation.json_numbers import finite
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.report.summary import drawn, found, summary
from linkwright.studies import NOWHERE, STUDIES, RunContext, Stopped, Study, StudyTask, read_studies
from linkwright.studies.redundant_mechanisms import refused_redundant
from linkwright.studies.registry import OfStructures, Outcomes

CANNOT = ("structure.", "assembly.", "motion.", "measure.nothing", "measure.not-finite", "export.cannot-")
"""Codes that begin so mean a model that can't do what is asked (exit code 1); all others a wrong file (2)."""


@dataclass
class Examined:
    """A model file as far as it can be understood, with everything that is wrong with it."""

    document: Document | None = None
    compiled: Compiled | None = None
    tasks: list[StudyTask] = field(default_factory=list)
    orders: list[Order] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    source: Source = field(default_factory=Source)
    folder: Path | None = None
    """Where the files of its tables lie."""
    file: Path | None = None
    content: bytes | None = None
    """The model file and what it holds; ``None`` for a document made in Python."""

    @cached_property
    def origin(self) -> Origin:
        """Where the results come from; its date is that of the first time it is asked for."""
        content = self.content
        if content is None:
            content = dump(self.document).encode() if self.document is not None else b""
        tables = table_hashes(self.document, self.folder) if self.document is not None else {}
        return Origin(line(self.file.name) if self.file is not None else None, hashed(content), tables)

    def read_from(self, read: Examined) -> Examined:
        """The same, with the file that it was read from, what is remarked on that and the lines of its findings."""
        self.source, self.file, self.content = read.source, read.file, read.content
        self.findings = self.located([*read.findings, *self.findings, *self._unasked()])
        return self

    def _unasked(self) -> Iterable[Finding]:
        """What a file says for nothing: parameters (beside a sketch they are told with what is odd with that), and
        measures of forces where there are none."""
        if self.document is None or self.compiled is None:
            return ()
        q = self.compiled.quantities
        return [*(() if self.document.sketch else unused_parameters(self.document, q)), *unloaded(q)]

    def located(self, findings: Iterable[Finding]) -> list[Finding]:
        """The same findings with their lines in the file."""
        return located(findings if self.document is None else with_file_paths(self.document, findings), self.source)

    @property
    def exit_code(self) -> int:
        """0 where nothing is wrong, 1 where the model can't do what is asked, 2 where the file is wrong."""
        errors = [finding for finding in self.findings if finding.severity == "error"]
        if not errors:
            return 0
        return 1 if all(finding.code.startswith(CANNOT) for finding in errors) else 2


def read_file(path: Path) -> Examined:
    """Read a model file, without looking into what it describes."""
    read = read_model_file(path)
    file, folder = (path, None) if read.content is None else (STDIN_NAME if path == STDIN else path, path.parent)
    return Examined(
        read.document,
        findings=[*read.findings],
        source=read.source,
        folder=folder,
        file=file,
        content=read.content,
    )


def read_model(model: str | Path | Document, folder: str | Path | None) -> Examined:
    """A document, or that of a model file, without looking into what it describes; ``folder`` is where the files lie
    that it names. Raises :class:`ModelError` for a file that holds none."""
    if isinstance(model, Document):
        return Examined(model, folder=Path(folder) if folder else None)
    read = read_file(Path(model))
    raise_errors(read.findings)
    return replace(read, folder=Path(folder)) if folder else read


def examine_file(path: Path) -> Examined:
    """Read and compile a model file; findings carry the lines of the file."""
    read = read_file(path)
    if read.document is None:
        return read
    return examine_document(read.document, path.parent).read_from(read)


def examine_document(
    document: Document, folder: Path | None = None, only: str | None = None, to: str | None = None
) -> Examined:
    """Compile a document and read its studies and exports; with ``only``, that study alone, whether the file asks for
    it or not; with ``to``, that export alone."""
    tasks, findings = read_studies(document.studies if only is None else {only: {}, **document.studies})
    orders, wrong = read_exports(document.exports)
    asked: Options = [(("studies", task.study.name), task.options) for task in tasks]
    asked = [*asked, *((("exports", order.target.name), order.options) for order in orders)]
    tasks = [task for task in tasks if to is None and only in (None, task.study.name)]
    orders = [order for order in orders if only is None and to in (None, order.target.name)]
    examine, beside = _examination(document.studies if only is None else [only], tasks, orders)
    findings += beside
    compiled, faults = examine(document, folder, partial(option_places, options=asked))
    checked = _checked(compiled, tasks, orders)
    findings += [*wrong, *faults, *(finding for i, finding in enumerate(checked) if finding not in checked[:i])]
    return Examined(document, compiled, tasks, orders, findings, folder=folder)


def _examination(
    asked: Collection[str], tasks: list[StudyTask], orders: list[Order]
) -> tuple[Callable[..., tuple[Compiled | None, list[Finding]]], list[Finding]]:
    """How a document is compiled for the studies that it asks for, and what can't stand beside one that brings a way of
    its own."""
    named = [(name, STUDIES[name]) for name in asked if name in STUDIES]
    alone = {name: study for name, study in named if isinstance(study, OfStructures)}
    if not alone:
        return compilation.examine, []
    ((own, study),) = alone.items()
    others = [("studies", task.study.name) for task in tasks if task.study.name != own]
    others += [("exports", order.target.name) for order in orders]
    found = [Finding("study.alone", path, {"study": own, "name": path[1]}) for path in others]
    return (study.examine if not found else _nothing), found


def _nothing(*_: Any) -> tuple[None, list[Finding]]:
    """What compiles no document."""
    return None, []


def _checked(compiled: Compiled | None, tasks: list[StudyTask], orders: list[Order]) -> list[Finding]:
    """What is wrong with the options of studies and exports."""
    if compiled is None:
        return []
    asked: list[tuple[str, Study | Target, Any]] = [("studies", task.study, task.options) for task in tasks]
    asked += [("exports", order.target, order.options) for order in orders]
    checked = []
    for section, owner, options in asked:
        checked += option_faults(compiled.mechanism, options, (section, owner.name))
        checked += owner.check(compiled, options)
        checked += refused_redundant(compiled.structure, owner, (section, owner.name))
    return checked


@dataclass
class Job:
    """A performed model file: outcomes by study name, and the folder they were written to; ``stopped`` is the interrupt
    that ended it, after which the last outcome holds what was done; ``outdated`` is where the results of an earlier run
    lie that are no longer current, while there are no newer ones."""

    examined: Examined
    outcomes: Outcomes = field(default_factory=Outcomes)
    folder: Path | None = None
    stopped: Stopped | None = None
    outdated: Path | None = None
    unwritten: list[Finding] = field(default_factory=list)
    """Of files that aren't written, since a package isn't installed that they need."""

    def __getattr__(self, name: str) -> Any:
        """The outcome of a study by its name; ``None`` where the file doesn't ask for it."""
        if name not in STUDIES:
            raise AttributeError(name)
        return self.outcomes.get(name)

    @property
    def found(self) -> list[Finding]:
        """What the studies found: why a run isn't whole, and warnings."""
        findings = [*found(self.outcomes), *self.unwritten]
        return findings if self.examined.document is None else with_file_paths(self.examined.document, findings)

    @property
    def exit_code(self) -> int:
        """130 where it was interrupted, else the examination's code, else 1 where an outcome isn't what is asked."""
        if self.stopped is not None:
            return 130
        return self.examined.exit_code or (0 if all(o.done for o in self.outcomes.values()) else 1)

    @property
    def summary(self) -> dict[str, Any]:
        """The summary as plain data."""
        document = self.examined.document
        if document is None:
            return {"done": False, "findings": [finding.as_dict() for finding in self.examined.findings]}
        findings = self.examined.located([*self.examined.findings, *self.found])
        return summary(document, self.outcomes, findings, self.examined.origin)


def perform(examined: Examined, site: RunContext = NOWHERE) -> Job:
    """Perform the studies of an examined file where ``site`` says; none where something is wrong with it."""
    site = replace(site, document=examined.document, folder=examined.folder)
    if not examined.tasks and examined.exit_code == 0:
        examined.findings.append(Finding("study.none", ("studies",)))
    job = Job(examined)
    if examined.exit_code == 0 and examined.compiled is not None:
        for task in examined.tasks:
            try:
                job.outcomes[task.study.name] = task.study.run(examined.compiled, task.options, site)
            except ModelError as error:  # a drive's law that gives no number between the samples
                examined.findings += examined.located(error.findings)
            except Stopped as stopped:
                job.outcomes[task.study.name], job.stopped = stopped.outcome, stopped
                break
    return job


@dataclass(frozen=True)
class Writing:
    """How results are written: which kinds of files are asked for besides the usual ones (``netcdf``, ``png``), whether
    foreign files may be overwritten, whether CSV files begin with comments that name their origin (``comments``) and
    with a mark by which Excel reads them as UTF-8 (``excel``)."""

    asked: Collection[str] = ()
    force: bool = False
    comments: bool = False
    excel: bool = False

    def files(self, study: Study) -> dict[str, FileOf]:
        """What a study writes, by name."""
        return {name: file for name, file in study.files.items() if not file.asked or file.option in self.asked}


USUAL = Writing()


def carry_out(examined: Examined, site: RunContext, how: Writing = USUAL) -> Job:
    """Perform the studies of an examined file and write what comes of them to the site's ``out``, if there is one.

    What keeps the folder from being used stands among the findings. Raises OSError where it can't be written to.
    """
    if site.out is None:
        return perform(examined, site)
    if examined.exit_code or not examined.tasks:
        job = perform(examined, site)
        if examined.content is not None or examined.document is not None:
            job.outdated = outdate(site.out, examined.origin)
        return job
    job = Job(examined)
    try:
        with _folder(examined, site.out, how) as folder:
            names = [how.files(task.study) for task in examined.tasks]
            stores = [task.study.stores(task.options) for task in examined.tasks]
            folder.begin([REPORT, SUMMARY, *(name for some in (*names, *stores) for name in some)])
            job = perform(examined, replace(site, keep=folder.keep))
            if job.outcomes:
                _write(job, folder, how)
    except ModelError as error:
        examined.findings += error.findings
        return job
    job.outdated = folder.outdated
    return job


def write(job: Job, folder: Path, how: Writing = USUAL) -> None:
    """Write report.html, summary.json, the studies' own files (cycle.csv, sweep.csv ...), each whole or not at all, and
    the folder's manifest.

    Raises :class:`ModelError` where foreign files stand in their way or another run writes to the folder, OSError where
    it can't be written to.
    """
    with _folder(job.examined, folder, how) as place:
        names = [how.files(STUDIES[study]) for study in job.outcomes]
        place.begin([REPORT, SUMMARY, *(name for some in names for name in some)])
        _write(job, place, how)


REPORT, SUMMARY = "report.html", "summary.json"


def _folder(examined: Examined, path: Path, how: Writing) -> ResultsFolder:
    return ResultsFolder(path, examined.origin, force=how.force, comments=how.comments, excel=how.excel)


def _write(job: Job, folder: ResultsFolder, how: Writing) -> None:
    document = job.examined.document
    due = {study: how.files(STUDIES[study]) for study in job.outcomes}
    lacking = {study: _lacking(files, job.outcomes[study], how) for study, files in due.items()}
    job.unwritten = [finding for study, files in lacking.items() for finding in _unwritten(study, files)]
    if document is not None and drawn(job.outcomes) is not None:
        examined = job.examined
        data = report_data(
            document, job.outcomes, [*examined.findings, *job.unwritten], examined.origin, examined.source
        )
        folder.write(REPORT, page(data))
    for study, outcome in job.outcomes.items():
        for name, file in due[study].items():
            if name not in lacking[study] and (made := file.make(outcome)) is not None:
                folder.write(name, made)
    folder.write(SUMMARY, summary_text(job.summary) + "\n")
    for study, outcome in job.outcomes.items():
        STUDIES[study].settle(outcome)
    stores = [store for outcome in job.outcomes.values() if (store := getattr(outcome, "store", None))]
    state: State = "interrupted" if job.stopped is not None else "failed" if job.examined.exit_code else "done"
    folder.done(job.outcomes, stores, state)
    job.folder = folder.path


def _lacking(files: Mapping[str, FileOf], outcome: Any, how: Writing) -> dict[str, tuple[str, str]]:
    """The usual files of an outcome that aren't written, by name, with the package that isn't installed and its extra.
    One that is asked for is none of them: it ends in an error."""
    needs = {name: file.needs for name, file in files.items() if file.needs and file.option not in how.asked}
    lacking = {name: need for name, need in needs.items() if not installed(need[0])}
    return {name: need for name, need in lacking.items() if files[name].due(outcome)}


def _unwritten(study: str, files: Mapping[str, tuple[str, str]]) -> Iterator[Finding]:
    """What is said of them: one note for each package."""
    for need in dict.fromkeys(files.values()):
        names = Joined(name for name, other in files.items() if other == need)
        data = {"files": names, "package": need[0], "extra": need[1]}
        yield Finding("file.unwritten", ("studies", study), data, severity="note")


def summary_text(data: dict[str, Any]) -> str:
    """The summary as JSON text: what isn't a finite number is ``null`` there, whichever study says it."""
    return json_text(json.dumps(finite(data), indent=2, ensure_ascii=False, allow_nan=False))


def check(model: str | Path | Document, folder: str | Path | None = None) -> list[Finding]:
    """Everything that is wrong with a model file or document; an empty list where nothing is.

    ``folder`` is where the tables of a document lie; those of a file lie beside it.
    """
    return _examined(model, folder).findings


def run(
    model: str | Path | Document,
    out: str | Path | None = None,
    folder: str | Path | None = None,
    *,
    force: bool = False,
) -> Job:
    """Perform the studies of a model file or document; with ``out``, write its results to that folder.

    ``folder`` is where the tables of a document lie; those of a file lie beside it. Files in ``out`` that linkwright
    didn't write are overwritten only with ``force``.

    Raises :class:`ModelError` with all findings where the model can't be run at all; a motion that stops on its
    way is no exception but stands in ``job.cycle.failures``.
    """
    job = carry_out(
        _examined(model, folder), RunContext(out=Path(out) if out is not None else None), Writing(force=force)
    )
    raise_errors(job.examined.findings)
    if job.stopped is not None:
        raise job.stopped
    return job


def _examined(model: str | Path | Document, folder: str | Path | None) -> Examined:
    if isinstance(model, Document):
        return examine_document(model, Path(folder) if folder else None)
    return examine_file(Path(model))
