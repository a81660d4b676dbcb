"""All assembly modes of a model file; it needn't say yet which one it wants."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from linkwright.app.job import Examined, read_file
from linkwright.compilation import examine, prepare
from linkwright.data_classes import dataclass
from linkwright.findings import Finding, ModelError, raise_errors
from linkwright.model.document import Document
from linkwright.report.summary import worded
from linkwright.structure import decompose
from linkwright.studies import STUDIES, read_studies
from linkwright.studies.modes.outcome import ModesOutcome
from linkwright.studies.modes.report import modes_data
from linkwright.studies.modes.study import ModesOptions, find_modes, own_mode
from linkwright.studies.redundant_mechanisms import refused_redundant


@dataclass
class ModesJob:
    """A file's modes, with what is wrong with it; ``outcome`` is ``None`` where an error stops it."""

    examined: Examined
    outcome: ModesOutcome | None = None

    @property
    def exit_code(self) -> int:
        """0 where there are modes, 1 where there is none, 2 where the file is wrong."""
        return self.examined.exit_code

    @property
    def summary(self) -> dict[str, Any]:
        """What was found as plain data."""
        data: dict[str, Any] = {} if self.outcome is None else worded(modes_data(self.outcome))
        return data | {"findings": [finding.as_dict() for finding in self.examined.findings]}


def modes_of_file(path: Path, options: ModesOptions | None = None) -> ModesJob:
    """The modes of a model file, at the time and over the drive that its modes study names unless told otherwise."""
    examined = read_file(path)
    if examined.document is None:
        return ModesJob(examined)
    job = modes_of_document(examined.document, path.parent, options)
    job.examined.source = examined.source
    job.examined.findings = job.examined.located([*examined.findings, *job.examined.findings])
    return job


def modes_of_document(document: Document, folder: Path | None, options: ModesOptions | None = None) -> ModesJob:
    """The modes of a document."""
    tasks, findings = read_studies({k: v for k, v in document.studies.items() if k == "modes"})
    made = prepare(document, folder)
    findings += made.findings
    if [finding.code for finding in findings] in (["model.no-drive"], ["model.no-freedom"]):
        made.structure = decompose(made.mechanism)  # what can't move can be put together all the same
        findings = [] if not made.structure.findings else findings
    findings += refused_redundant(made.structure, STUDIES["modes"], ("studies", "modes"))
    job = ModesJob(Examined(document, findings=findings))
    if job.examined.findings:
        return job
    options = options or next((task.options for task in tasks), ModesOptions())
    try:
        outcome = find_modes(made, options)
    except ModelError as error:
        job.examined.findings += error.findings
        return job
    job.outcome = outcome
    if not outcome.modes:
        job.examined.findings.append(Finding("assembly.no-mode", ("links",)))
    if (compiled := examine(document, folder)[0]) is not None:
        outcome.own = own_mode(compiled, outcome)
    return job


def modes(
    model: str | Path | Document,
    at: str | float | None = None,
    drive: str | None = None,
    folder: str | Path | None = None,
) -> ModesOutcome:
    """Every way to put a mechanism together, and on which circuit each lies.

    ``at`` is the time of the pose, as a file would write it (``"0.2 s"``); the start of the motion by default.
    Circuits are followed over ``drive``, which needn't be named where there is one only. Raises
    :class:`ModelError` where the model is wrong or can't be put together at all.
    """
    options = None
    if at is not None or drive is not None:
        options = ModesOptions.model_validate({"at": at, "drive": drive})
    if isinstance(model, Document):
        job = modes_of_document(model, Path(folder) if folder else None, options)
    else:
        job = modes_of_file(Path(model), options)
    raise_errors(job.examined.findings)
    assert job.outcome is not None
    return job.outcome
