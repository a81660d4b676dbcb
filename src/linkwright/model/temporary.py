"""Folders for files that don't outlast their use."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from linkwright.findings import Finding, ModelError, reason


@contextmanager
def temporary_folder() -> Iterator[Path]:
    """A folder of the process, removed at the end. Raises :class:`ModelError` where the system has no place for it."""
    try:
        made = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
    except OSError as error:
        raise ModelError([Finding("file.no-temporary", data={"reason": reason(error)})]) from None
    with made as name:
        yield Path(name)
