"""Files and folders that linkwright writes: whole or not at all, and never through a link that stands in their place.

A results folder may come with a model from elsewhere, with links in it that lead to other files of the user.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import stat
from pathlib import Path

from linkwright.findings import Finding, ModelError

NO_LINK = getattr(os, "O_NOFOLLOW", 0)
"""Lets the system itself refuse to open a link."""


def write_aside(path: Path, content: str | bytes, durable: bool = False) -> None:
    """Write to ``path`` whole or not at all, text as UTF-8. A link is replaced; a file's permissions stay. If
    ``durable``, the content is on the disk before it has its name, so that it is whole even where the machine stops."""
    aside = path.with_name(f".{path.name}.{secrets.token_hex(4)}")
    try:
        with aside.open("xb") as stream:
            stream.write(content.encode() if isinstance(content, str) else content)
            if durable:
                stream.flush()
                os.fsync(stream.fileno())
        with contextlib.suppress(FileNotFoundError):
            mode = path.lstat().st_mode
            if stat.S_ISREG(mode):
                aside.chmod(stat.S_IMODE(mode))
        aside.replace(path)
    except BaseException:
        with contextlib.suppress(OSError):
            aside.unlink()
        raise


def refuse_link(*paths: Path) -> None:
    """Raise :class:`ModelError` for each path that is a link, wherever it leads."""
    if links := [path for path in paths if path.is_symlink()]:
        raise ModelError([Finding("file.link", (), {"file": str(path)}) for path in links])


def refuse_links_in(folder: Path) -> None:
    """Raise :class:`ModelError` where a folder is a link or holds one, at any depth; there may be none."""
    refuse_link(folder)
    for top, folders, files in os.walk(folder):
        refuse_link(*(Path(top, name) for name in (*folders, *files)))


def make_folder(folder: Path) -> None:
    """Make a folder inside one of results, where there is none yet. Raises :class:`ModelError` for a link in its place,
    OSError where it can't be made."""
    refuse_link(folder)
    folder.mkdir(exist_ok=True)
