"""The state of an interrupted study in one file: written aside and renamed, so it is the old one or the new one."""

from __future__ import annotations

import errno
import hashlib
import io
import json
import re
import zipfile
from collections.abc import Mapping
from dataclasses import field
from pathlib import Path

import numpy as np

from linkwright import _version
from linkwright.blocks.work import Arrays
from linkwright.data_classes import dataclass
from linkwright.findings import Finding, Joined, ModelError, reason
from linkwright.model.input_files import read_at_most
from linkwright.model.output_files import refuse_link, write_aside

FORMAT = 2
"""The version of what stands in the file."""
_HEAD = re.compile(rb"linkwright blocks (\d+) ([0-9a-f]{64})")
"""The first line: the format's version, the SHA-256 of what follows the line."""


@dataclass(frozen=True)
class Saved:
    """What a checkpoint holds: the next atom, and the arrays of the state."""

    next: int
    arrays: Arrays


@dataclass(frozen=True)
class Checkpoint:
    """The file of a study's state. ``key`` is the work's: the state of another work isn't taken for its own. Nor is one
    that other ``versions`` computed: of linkwright, which is always among them, or of what else decides on the bits of
    the results, by name.

    ``anew`` passes over whatever the file holds: the study starts from the beginning and writes over it.
    """

    path: Path
    key: str
    anew: bool = False
    versions: Mapping[str, str] = field(default_factory=dict)

    @property
    def all_versions(self) -> dict[str, str]:
        """The versions, with that of linkwright."""
        return {"linkwright": _version.__version__, **self.versions}

    def read(self) -> Saved | None:
        """What the file holds; ``None`` where there is none yet.

        Raises :class:`~linkwright.findings.ModelError` for a damaged file, for that of another work or of other
        versions, and for a link.
        """
        if self.anew:
            return None
        refuse_link(self.path)
        if not self.path.exists():
            return None
        try:
            content = read_at_most(self.path)
        except OSError as error:
            data = {"file": str(self.path), "reason": reason(error)}
            raise ModelError([Finding("file.unreadable", (), data)]) from None
        head, _, body = content.partition(b"\n")
        found = _HEAD.fullmatch(head)
        if found is None or found[2] != hashlib.sha256(body).hexdigest().encode():
            raise ModelError([Finding("blocks.corrupt", (), {"file": str(self.path)})])
        if int(found[1]) != FORMAT:
            raise self._other({"format": found[1].decode()}, {"format": str(FORMAT)})
        try:
            with np.load(io.BytesIO(body), allow_pickle=False) as stored:
                arrays = dict(stored)
            key, following = str(arrays.pop("key")), int(arrays.pop("next"))
            versions = dict(json.loads(str(arrays.pop("versions"))))
        except (ValueError, KeyError, EOFError, AttributeError, zipfile.BadZipFile):
            raise ModelError([Finding("blocks.corrupt", (), {"file": str(self.path)})]) from None
        if key != self.key:
            raise ModelError([Finding("blocks.other-work", (), {"file": str(self.path)})])
        if versions != self.all_versions:
            raise self._other(versions, self.all_versions)
        return Saved(following, arrays)

    def _other(self, theirs: Mapping[str, str], ours: Mapping[str, str]) -> ModelError:
        """The refusal of a state that other versions have computed: of both those that differ."""
        names = [name for name in {**ours, **theirs} if theirs.get(name) != ours.get(name)]
        told = [Joined(f"{name} {of.get(name, '-')}" for name in names) for of in (theirs, ours)]
        return ModelError(
            [Finding("blocks.other-version", (), {"file": str(self.path), "theirs": told[0], "ours": told[1]})]
        )

    def write(self, following: int, arrays: Arrays) -> None:
        """Replace the file: ``following`` is the next atom.

        Raises :class:`~linkwright.findings.ModelError` where it can't; the old file then stands.
        """
        stream = io.BytesIO()
        own = {"key": self.key, "next": following, "versions": json.dumps(self.all_versions)}
        np.savez(stream, **{name: np.array(value) for name, value in own.items()}, **arrays)  # type: ignore[arg-type]
        body = stream.getvalue()
        head = f"linkwright blocks {FORMAT} {hashlib.sha256(body).hexdigest()}\n"
        try:
            write_aside(self.path, head.encode() + body, durable=True)
        except OSError as error:
            raise unsaved(self.path, error) from None


def unsaved(path: Path, error: OSError) -> ModelError:
    """What to say where something can't be written."""
    full = error.errno in (errno.ENOSPC, errno.EDQUOT)
    data = {"file": str(path), "reason": reason(error)}
    return ModelError([Finding("blocks.no-space" if full else "blocks.unwritable", (), data)])
