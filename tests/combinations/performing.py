"""How a cell of the matrix is performed, and what it is held to.

A cell is *right* when its file is performed with exit code 0, all checks of its certificate pass, everything written is
whole and finite, and what its column expects besides holds. It is *refused* when a finding says so: with a code that
isn't that of a failed verification, a place in the file, a cause and a fix. Anything else is *wrong*: an exception, a
warning of NumPy or Python, a figure that is none, a failed verification, another figure than expected.
"""

from __future__ import annotations

import json
import tempfile
import traceback
import warnings
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from fuzz_judge import unsound

from linkwright.app.exports import ExportJob, examined_for, export_into
from linkwright.app.job import Job, carry_out, examine_document, summary_text
from linkwright.findings import Finding, ModelError
from linkwright.model.document import parse_document
from linkwright.studies import RunContext

RIGHT, REFUSED, WRONG = "right", "refused", "wrong"
UNPROVEN = ("motion.unproven", "motion.check-fails", "export.unproven", "reactions.unproven")
"""Codes of verifications that fail: figures of a small valid mechanism that aren't true."""
Data = dict[str, Any]


@dataclass
class Cell:
    """What came of a cell: a verdict, the findings of a refusal, what is wrong."""

    verdict: str
    findings: tuple[Finding, ...] = ()
    faults: list[str] = field(default_factory=list)

    @property
    def codes(self) -> tuple[str, ...]:
        """The codes of a refusal, each once."""
        return tuple(dict.fromkeys(finding.code for finding in self.findings))


def judged(perform: Callable[[], Iterable[str]]) -> Cell:
    """What comes of a cell: ``perform`` gives what is wrong with its figures, and raises :class:`RefusedError` where it
    is refused."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            faults = [*perform()]
    except RefusedError as refused:
        return _refused(refused.findings)
    except ModelError as error:
        return _refused(error.findings)
    except Exception:
        return Cell(WRONG, faults=[traceback.format_exc(limit=-3)])
    return Cell(WRONG if faults else RIGHT, faults=faults)


class RefusedError(Exception):
    """A file, or what it asks for, was refused."""

    def __init__(self, findings: Iterable[Finding]) -> None:
        self.findings = tuple(findings)
        super().__init__(*self.findings)


def _refused(findings: Iterable[Finding]) -> Cell:
    """A refusal, held to what one must say."""
    errors = tuple(finding for finding in findings if finding.severity == "error")
    faults = [] if errors else ["refused without a finding"]
    for one in errors:
        if one.code in UNPROVEN:
            faults.append(str(one))
        if not one.path:
            faults.append(f"{one.code} names no place")
        if not (one.what.strip() and one.mend.strip()):
            faults.append(f"{one.code} says no cause or no fix")
    return Cell(WRONG if faults else REFUSED, errors, faults)


def run(data: Data, files: bool = False) -> Job:
    """The studies of a file, performed; with ``files`` they are written and looked through. Raises
    :class:`RefusedError`, and AssertionError for what is written and isn't whole."""
    document = parse_document(data)
    assert document is not None
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "out"
        examined = examine_document(document)
        job = carry_out(examined, RunContext(out=folder if files else None))
        for path in folder.rglob("*") if files else ():
            if path.is_file() and ".zarr" not in str(path):
                faults = [*unsound(path.name, path.read_bytes())]
                assert not faults, faults
    summary = json.loads(summary_text(job.summary))
    if job.exit_code:
        raise RefusedError([*examined.findings, *job.found])
    assert summary["done"], "exit code 0, but the summary says that not all is done"
    if (cycle := job.outcomes.get("cycle")) is not None:
        certificate = cycle.result.certificate
        assert certificate is not None and certificate.sound(), "the certificate has a check that fails"
    return job


def written_for(data: Data, target: str) -> ExportJob:
    """The export of a file, written and looked through. Raises as :func:`run`."""
    document = parse_document(data)
    assert document is not None
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "out"
        job = export_into(examined_for(document, None, target, {}), target, folder)
        json.dumps(job.summary, allow_nan=False)
        if job.exit_code:
            raise RefusedError([*job.examined.findings, *job.found])
        assert job.exported is not None and job.exported.files, "nothing is written"
        for path in folder.rglob("*"):
            if path.is_file():
                faults = [*unsound(path.name, path.read_bytes())]
                assert not faults, faults
    return job
