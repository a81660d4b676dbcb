"""A mechanism written for another tool."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from linkwright.app.job import USUAL, Examined, Writing, read_file, read_model
from linkwright.app.results_folder import ResultsFolder, outdate
from linkwright.app.single_study import examine_one
from linkwright.data_classes import dataclass
from linkwright.exports import TARGETS, Exported
from linkwright.expressions.unknown import near
from linkwright.findings import Finding, Joined, ModelError, raise_errors
from linkwright.model.document import Document
from linkwright.model.origin import Origin
from linkwright.model.yaml_text import read_text
from linkwright.studies import RunContext


@dataclass
class ExportJob:
    """A performed export: what came of it, the folder it was written to; ``outdated`` as :class:`Job` has it."""

    examined: Examined
    to: str
    exported: Exported | None = None
    folder: Path | None = None
    outdated: Path | None = None

    @property
    def found(self) -> list[Finding]:
        """What the target found, with lines of the file."""
        return [] if self.exported is None else self.examined.located(self.exported.failures + self.exported.warnings)

    @property
    def exit_code(self) -> int:
        """The examination's code, else 1 where the export isn't what was asked, else 0."""
        return self.examined.exit_code or (0 if self.exported is not None and self.exported.done else 1)

    @property
    def summary(self) -> dict[str, Any]:
        """The target's summary as plain data, with the names of the files and all findings."""
        exported = self.exported or Exported()
        return {
            "target": self.to,
            "done": self.exit_code == 0,
            **exported.summary,
            "files": [*exported.files],
            "findings": [finding.as_dict() for finding in (*self.examined.findings, *self.found)],
        }


def export(
    model: str | Path | Document,
    to: str,
    out: str | Path | None = None,
    *,
    folder: str | Path | None = None,
    force: bool = False,
    **options: Any,
) -> Exported:
    """Write a mechanism for another tool: ``to`` is a target such as ``mjcf``; with ``out``, a folder, its files are
    written there, over those that linkwright didn't write only with ``force``.

    ``options`` are the target's, in place of those in the file's ``exports``. ``folder`` is where the tables of a
    document lie; those of a file lie beside it. Raises :class:`ModelError` with all findings where the mechanism can't
    be exported at all; what the target found else stands in ``failures`` and ``warnings`` of the result.
    """
    read = read_model(model, folder)
    assert read.document is not None
    examined = examined_for(read.document, read.folder, to, options)
    if read.file is not None:
        examined.read_from(read)
    job = export_of(examined, to) if out is None else export_into(examined, to, Path(out), Writing(force=force))
    raise_errors(job.examined.findings)
    assert job.exported is not None
    return job.exported


def examine_export(
    path: Path, to: str, settings: Sequence[str] = (), given: Mapping[str, Any] | None = None
) -> Examined:
    """Read and compile a model file for one export, with options in place of the file's: ``given``, and ``settings``
    as ``KEY=VALUE`` with a value of YAML."""
    read = read_file(path)
    if read.document is None:
        return read
    try:
        examined = examined_for(read.document, path.parent, to, {**(given or {}), **settings_of(settings)})
    except ModelError as error:
        return Examined(findings=[*error.findings])
    return examined.read_from(read)


def export_of(examined: Examined, to: str, site: RunContext | None = None) -> ExportJob:
    """Perform the export of an examined file; none where something is wrong with it."""
    job = ExportJob(examined, to)
    if examined.exit_code == 0 and examined.compiled is not None and examined.orders:
        (order,) = examined.orders
        here = RunContext(document=examined.document, folder=examined.folder)
        try:
            job.exported = order.target.export(examined.compiled, order.options, site or here)
        except ModelError as error:
            examined.findings += examined.located(error.findings)
    return job


def export_into(examined: Examined, to: str, folder: Path, how: Writing = USUAL) -> ExportJob:
    """Perform the export of an examined file, and write its files to a folder.

    What keeps the folder from being used stands among the findings. Raises OSError where it can't be written to.
    """
    kind = f"export {to}"
    if examined.exit_code or not examined.orders:
        job = export_of(examined, to)
        if examined.content is not None or examined.document is not None:
            job.outdated = outdate(folder, examined.origin, kind)
        return job
    return write_export(examined, to, lambda: export_of(examined, to), examined.origin, folder, how)


def write_export(
    examined: Examined, to: str, make: Callable[[], ExportJob], origin: Origin, folder: Path, how: Writing = USUAL
) -> ExportJob:
    """Write the files of an export, which is made once the folder is taken, as :func:`export_into` does."""
    job = ExportJob(examined, to)
    try:
        with ResultsFolder(
            folder, origin, f"export {to}", force=how.force, comments=how.comments, excel=how.excel
        ) as place:
            job = make()
            if job.exported is not None and job.exported.files:
                place.begin(job.exported.files)
                for name, content in job.exported.files.items():
                    place.write(name, content)
                place.done()
                job.folder = folder
        job.outdated = place.outdated
    except ModelError as error:
        examined.findings += error.findings
    return job


def examined_for(document: Document, folder: Path | None, to: str, given: Mapping[str, Any]) -> Examined:
    """A document compiled for one export, with options in place of its own."""
    if to not in TARGETS:
        return Examined(document, findings=[unknown_target(to)])
    return examine_one(document, folder, to, given, section="exports")


def unknown_target(to: str) -> Finding:
    """The finding where no target has a name."""
    return Finding("export.unknown", (), {"name": to, "near": near(to, TARGETS, listed=True)})


def no_target() -> Finding:
    """The finding where nothing says for which tool."""
    return Finding("export.which", data={"known": Joined(TARGETS)})


def settings_of(settings: Sequence[str]) -> dict[str, Any]:
    """Options from ``KEY=VALUE``."""
    options, findings = {}, []
    for setting in settings:
        key, equals, value = setting.partition("=")
        source = read_text(f"value: {value}".encode())
        if not (equals and key.strip() and isinstance(source.data, dict) and [*source.data] == ["value"]):
            findings.append(Finding("export.setting", (), {"given": setting[:60]}))
        else:
            options[key.strip()] = source.data["value"]
    if findings:
        raise ModelError(findings)
    return options
