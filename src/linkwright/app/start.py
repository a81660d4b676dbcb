"""A model file to start from: a copy of one in the gallery."""

from __future__ import annotations

import os
from pathlib import Path

from linkwright import gallery
from linkwright.model.findings import Finding
from linkwright.model.output_files import write_aside
from linkwright.model.unknown import near


def new(name: str, file: Path, force: bool = False) -> list[Finding]:
    """Write a model of the gallery to a file; what stands against it, where something does."""
    if name not in gallery.names():
        return [Finding("gallery.unknown", data={"name": name, "near": near(name, gallery.names())})]
    if os.path.lexists(file) and not force:
        return [Finding("file.exists", data={"file": str(file)})]
    try:
        write_aside(file, gallery.text(name))
    except OSError as error:
        return [Finding("file.unwritable", data={"file": str(file), "reason": error.strerror or str(error)})]
    return []
