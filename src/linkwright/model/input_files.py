"""Files that are read, by name: regular ones alone, of bounded size, and never with a wait.

A model names files beside it, and may come from elsewhere: a name may lead to a device that never ends or to a pipe
that nobody fills.
"""

from __future__ import annotations

import os
import stat
import sys
from functools import cache
from pathlib import Path

from linkwright.findings import Finding, ModelError, Term, reason

MAX_BYTES = 20_000_000
"""The most that is read of a file that a model names."""

_FLAGS = sum(getattr(os, name, 0) for name in ("O_NONBLOCK", "O_NOCTTY", "O_BINARY"))
_KINDS = {
    stat.S_IFDIR: "a-folder",
    stat.S_IFIFO: "a-pipe",
    stat.S_IFSOCK: "a-socket",
    stat.S_IFCHR: "a-device",
    stat.S_IFBLK: "a-device",
}


STDIN, STDIN_NAME = Path("-"), Path("stdin.yaml")
"""How a user names standard input, and what it is called in results."""


def read_at_most(path: Path, limit: int = 1 << 40) -> bytes:
    """The content of a regular file, or of one that a link leads to, or of standard input: ``limit`` bytes of it and
    one more, whatever size the system states. Raises :class:`ModelError` for anything but a regular file, OSError where
    the system refuses."""
    if path == STDIN:
        return _standard_input(limit)
    _refuse_irregular(path, path.stat())  # before opening, which some devices answer with a deed
    handle = os.open(path, os.O_RDONLY | _FLAGS)
    try:
        _refuse_irregular(path, os.fstat(handle))
        parts, left = [], limit + 1
        while left and (part := os.read(handle, min(left, 1 << 20))):
            parts.append(part)
            left -= len(part)
    finally:
        os.close(handle)
    return b"".join(parts)


@cache
def _standard_input(limit: int) -> bytes:
    """What stands on standard input, which can be read but once."""
    return sys.stdin.buffer.read(limit + 1)


def _refuse_irregular(path: Path, found: os.stat_result) -> None:
    if not stat.S_ISREG(found.st_mode):
        kind = Term(_KINDS.get(stat.S_IFMT(found.st_mode), "a-device"))
        raise ModelError([Finding("file.irregular", (), {"file": str(path), "kind": kind})])


def read_beside(name: str, folder: Path | None, path: tuple[str | int, ...]) -> bytes:
    """The content of a file that a model names, beside it; ``path`` is the place of its name in the model.

    Raises :class:`ModelError`.
    """
    try:
        content = read_at_most((folder or Path()) / name, MAX_BYTES)
    except ModelError as error:
        raise ModelError([Finding(f.code, path, {**f.data, "file": name}) for f in error.findings]) from None
    except (OSError, ValueError) as error:  # ValueError: a name that no file can have
        raise ModelError([Finding("table.unreadable", path, {"file": name, "reason": reason(error)})]) from None
    if len(content) > MAX_BYTES:
        raise ModelError([Finding("table.too-large", path, {"file": name, "limit": f"{MAX_BYTES:,}"})])
    return content
