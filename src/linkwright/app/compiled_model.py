"""A model file, document or mechanism as a program, for Python."""

from __future__ import annotations

from pathlib import Path

from linkwright.app.job import read_model
from linkwright.compilation import compile_mechanism, examine
from linkwright.findings import raise_errors
from linkwright.kernels import Compiled
from linkwright.model.mechanism import Mechanism


def compiled(model: str | Path | Mechanism, folder: str | Path | None = None) -> Compiled:
    """The program of a model, ready to run; its studies aren't looked at.

    ``folder`` is where the tables of a document lie; those of a file lie beside it. Raises :class:`ModelError` with all
    findings, of a file with their lines.
    """
    if isinstance(model, Mechanism):
        return compile_mechanism(model, folder)
    read = read_model(model, folder)
    assert read.document is not None
    found, findings = examine(read.document, read.folder)
    raise_errors(read.located(findings))
    assert found is not None
    return found
