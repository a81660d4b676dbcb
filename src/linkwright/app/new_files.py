"""A model file to start from: a copy of one in the gallery."""

from __future__ import annotations

import os
from pathlib import Path

from linkwright import gallery
from linkwright.expressions.unknown import near
from linkwright.findings import Finding, reason
from linkwright.model.output_files import write_aside
from linkwright.words import language

MARK = "\ufeff"
"""The mark of UTF-8 at the beginning of a file, by which Excel knows it."""


def new_table(name: str, file: Path, force: bool = False, *, excel: bool = False) -> list[Finding]:
    """Write a table for a batch of exports, with the parameters of a model of the gallery or of a model file; what
    stands against it, where something does. With ``excel`` it begins with the mark of UTF-8."""
    from linkwright.app.batch import template

    text, findings = template(name, file.parent)
    if [finding.code for finding in findings] == ["batch.model"]:
        return [_unknown(name)]
    return [finding for finding in findings if finding.severity == "error"] or _write(file, MARK * excel + text, force)


def new(name: str, file: Path, force: bool = False) -> list[Finding]:
    """Write a model of the gallery to a file, with comments in the present language; what stands against it, where
    something does."""
    if name not in gallery.names():
        return [_unknown(name)]
    return _write(file, gallery.text(name, language()), force)


def _unknown(name: str) -> Finding:
    return Finding("gallery.unknown", data={"name": name, "near": near(name, gallery.names())})


def _write(file: Path, text: str, force: bool) -> list[Finding]:
    if os.path.lexists(file) and not force:
        return [Finding("file.exists", data={"file": str(file)})]
    try:
        write_aside(file, text)
    except OSError as error:
        return [Finding("file.unwritable", data={"file": str(file), "reason": reason(error)})]
    return []
