"""Where results come from: the model file and its content, the tables beside it, the date, the version."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Mapping
from dataclasses import field
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import Any

from linkwright import _version
from linkwright.data_classes import dataclass
from linkwright.findings import ModelError
from linkwright.model.input_files import read_beside
from linkwright.model.mechanism import Mechanism, scopes

DIGITS = 12
"""So many hex digits of a hash are shown to people."""


def now() -> str:
    """The date and time with its zone, in ISO 8601; that of ``SOURCE_DATE_EPOCH`` (s since 1970, UTC) where it is set,
    so that two runs write the same bytes."""
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    moment = datetime.fromtimestamp(int(epoch), UTC) if epoch.isdecimal() else datetime.now().astimezone()
    return moment.isoformat(timespec="seconds")


def hashed(content: bytes) -> str:
    """The SHA-256 of some content, in hex."""
    return sha256(content).hexdigest()


@dataclass(frozen=True)
class Origin:
    """A model ``file``: its name in one line (``None`` for a document made in Python), the SHA-256 of its content in
    hex (of a document the text that it would be saved as), those of the ``tables`` beside it by file name."""

    file: str | None
    sha256: str
    tables: Mapping[str, str] = field(default_factory=dict)
    date: str = field(default_factory=now)
    version: str = _version.__version__

    @property
    def short(self) -> str:
        """The hash as it is shown to people."""
        return self.sha256[:DIGITS]

    @property
    def minute(self) -> str:
        """The date and time as they are shown to people: to the minute, with the zone."""
        return f"{self.date[:10]} {self.date[11:16]} {self.date[19:]}".strip()

    def as_dict(self) -> dict[str, Any]:
        """Plain data for the summary."""
        return {"model": {"file": self.file, "sha256": self.sha256}, "date": self.date}


def table_hashes(mechanism: Mechanism, folder: Path | None) -> dict[str, str]:
    """The hashes of a mechanism's tables by file name, of those that can be read; also of those in sub-assemblies."""
    files = (table_files(part, folder) for _, part in scopes(mechanism))
    return {name: hashed(content) for found in files for name, content in found.items()}


def table_files(mechanism: Mechanism, folder: Path | None) -> dict[str, bytes]:
    """The content of a mechanism's table files by name, of those that can be read: the examination tells of others
    that are used."""
    found = {}
    for name in sorted({table.file for table in mechanism.tables.values() if table.file is not None}):
        with contextlib.suppress(ModelError):
            found[name] = read_beside(name, folder, ("tables",))
    return found
