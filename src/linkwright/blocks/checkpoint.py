"""The state of an interrupted study in one file: written aside and renamed, so it is the old one or the new one."""

from __future__ import annotations

import errno
import hashlib
import io
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from linkwright.blocks.work import Arrays
from linkwright.model.document import write_aside
from linkwright.model.findings import Finding, ModelError

FORMAT = b"linkwright blocks 1"
"""Begins the file; then a space, the SHA-256 of what follows the first line, in hex, and the line's end."""


@dataclass(frozen=True)
class Saved:
    """What a checkpoint holds: the next atom, and the arrays of the state."""

    next: int
    arrays: Arrays


@dataclass(frozen=True)
class Checkpoint:
    """The file of a study's state. ``key`` is the work's: the state of another work isn't taken for its own.

    ``anew`` passes over whatever the file holds: the study starts from the beginning and writes over it.
    """

    path: Path
    key: str
    anew: bool = False

    def read(self) -> Saved | None:
        """What the file holds; ``None`` where there is none yet.

        Raises :class:`~linkwright.model.findings.ModelError` for a damaged file and for that of another work.
        """
        if self.anew or not self.path.exists():
            return None
        try:
            content = self.path.read_bytes()
        except OSError as error:
            data = {"file": str(self.path), "reason": error.strerror or str(error)}
            raise ModelError([Finding("file.unreadable", (), data)]) from None
        head, _, body = content.partition(b"\n")
        if head != FORMAT + b" " + hashlib.sha256(body).hexdigest().encode():
            raise ModelError([Finding("blocks.corrupt", (), {"file": str(self.path)})])
        try:
            with np.load(io.BytesIO(body), allow_pickle=False) as stored:
                arrays = dict(stored)
            key, following = str(arrays.pop("key")), int(arrays.pop("next"))
        except (ValueError, KeyError, EOFError, AttributeError, zipfile.BadZipFile):
            raise ModelError([Finding("blocks.corrupt", (), {"file": str(self.path)})]) from None
        if key != self.key:
            raise ModelError([Finding("blocks.other-work", (), {"file": str(self.path)})])
        return Saved(following, arrays)

    def write(self, following: int, arrays: Arrays) -> None:
        """Replace the file: ``following`` is the next atom.

        Raises :class:`~linkwright.model.findings.ModelError` where it can't; the old file then stands.
        """
        stream = io.BytesIO()
        np.savez(stream, key=np.array(self.key), next=np.array(following), **arrays)  # type: ignore[arg-type]
        body = stream.getvalue()
        head = FORMAT + b" " + hashlib.sha256(body).hexdigest().encode()
        try:
            write_aside(self.path, head + b"\n" + body, durable=True)
        except OSError as error:
            raise unsaved(self.path, error) from None


def unsaved(path: Path, error: OSError) -> ModelError:
    """What to say where something can't be written."""
    full = error.errno in (errno.ENOSPC, errno.EDQUOT)
    data = {"file": str(path), "reason": error.strerror or str(error)}
    return ModelError([Finding("blocks.no-space" if full else "blocks.unwritable", (), data)])
