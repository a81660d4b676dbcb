"""The folder in which compiled kernels are kept, so that the next process need not compile them again.

A kernel's folder is named after the content of its source and all else that its machine code depends on. It is made
aside and renamed when it is whole; a list of checksums of all files inside is looked at before anything is loaded, so
that a damaged one is made anew. The source itself is executed as it was given, never as a file has it. What others may
write is not used at all: loading machine code is to execute it. The folder may be removed at any time.
"""

from __future__ import annotations

import contextlib
import hashlib
import importlib.util
import json
import os
import platform
import shutil
import stat
import sys
import tempfile
from collections.abc import Callable
from importlib.abc import ExecutionLoader
from pathlib import Path
from types import ModuleType

from linkwright.findings import ModelError
from linkwright.model.temporary import temporary_folder

MOST = 400
"""The most kernels kept; those not used for the longest time go first."""
SUMS = "checksums.json"
Read = Callable[[str, Path | None, str], ModuleType]


def folder() -> Path | None:
    """``LINKWRIGHT_CACHE``, or the system's place for caches; ``None`` for a user without a home."""
    if told := os.environ.get("LINKWRIGHT_CACHE"):
        return Path(told)
    variable, *inside = {"win32": ("LOCALAPPDATA", "AppData", "Local"), "darwin": ("", "Library", "Caches")}.get(
        sys.platform, ("XDG_CACHE_HOME", ".cache")
    )
    try:
        return Path(os.environ.get(variable) or Path.home().joinpath(*inside)) / "linkwright"
    except RuntimeError:  # neither HOME nor an entry among the system's users
        return None


def name_of(source: str, about: str) -> str:
    """The name of a source's kernel; ``about`` is what else its machine code depends on."""
    text = "\0".join([source, about, platform.machine(), sys.version])
    return hashlib.sha256(text.encode()).hexdigest()[:40]


def is_cached(source: str, about: str) -> bool:
    """Whether the kernel of a source lies there."""
    base = folder()
    return base is not None and (base / "kernels" / name_of(source, about)).is_dir()


def load(source: str, about: str, read: Read) -> ModuleType:
    """The module of a source: the kept one, else compiled by ``read`` (source, a module's path, its name) and kept.

    Where nothing can be kept (no space, no right to write, a folder that others may write to) it is compiled all the
    same.
    """
    name = name_of(source, about)
    module_name = f"linkwright_kernel_{name}"
    kernels = _kernels()
    if kernels is None:
        return _unkept(source, read, module_name)
    place = kernels / name
    if _sound(place):
        with contextlib.suppress(OSError):
            os.utime(place)
        return read(source, place / "kernel.py", module_name)
    _remove(place)
    try:
        aside = Path(tempfile.mkdtemp(prefix="new-", dir=kernels))
    except OSError:
        return _unkept(source, read, module_name)
    try:
        module = _uncached_module(aside, source, read, module_name)
        with contextlib.suppress(OSError):  # another process may have been first, or the disk is full
            _write_sums(aside)
            for file in aside.rglob("*"):
                _close(file)
            aside.rename(place)
            _prune(kernels)
        return module
    finally:
        shutil.rmtree(aside, ignore_errors=True)


def module_at(source: str, path: Path | None, name: str) -> ModuleType:
    """The module of a source, made known under a name; its machine code is bound to the file at ``path``, where there
    is one. No ``.pyc`` is read or written."""
    loader = _Text(source, str(path or f"<{name}>"))
    spec = importlib.util.spec_from_loader(name, loader, origin=loader.path)
    assert spec is not None
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    module.__dict__.update({"CACHE": False} if path is None else {"__file__": loader.path})
    loader.exec_module(module)
    return module


class _Text(ExecutionLoader):
    """A module from its text, as that of a file."""

    def __init__(self, source: str, path: str) -> None:
        self.source, self.path = source, path

    def get_source(self, fullname: str) -> str:
        return self.source

    def get_filename(self, fullname: str) -> str:
        return self.path


def _kernels() -> Path | None:
    """The folder of kernels, made where there is none; ``None`` where there can't be one that is the user's alone."""
    base = folder()
    if base is None:
        return None
    try:
        base.mkdir(parents=True, exist_ok=True, mode=0o700)
        (base / "kernels").mkdir(exist_ok=True, mode=0o700)
        if not os.environ.get("LINKWRIGHT_CACHE"):  # a folder of the user's choice stays as it is
            _close(base)
            _close(base / "kernels")
        above = [place.stat().st_mode for place in base.resolve().parents]
    except OSError:
        return None
    replaceable = any(mode & stat.S_IWOTH and not mode & stat.S_ISVTX for mode in above)
    alone = _is_private(base) and _is_private(base / "kernels") and not (replaceable and os.name == "posix")
    return base / "kernels" if alone else None


def _is_private(place: Path) -> bool:
    """Whether a file or folder is the user's, no link, and not for others to write."""
    found = place.lstat()
    if stat.S_ISLNK(found.st_mode):
        return False
    return os.name != "posix" or (found.st_uid == os.geteuid() and not found.st_mode & (stat.S_IWGRP | stat.S_IWOTH))


def _close(place: Path) -> None:
    """Leave others no right to write to what is the user's: a process's mask may give it to them."""
    found = place.lstat()
    if os.name == "posix" and found.st_uid == os.geteuid() and not stat.S_ISLNK(found.st_mode):
        place.chmod(stat.S_IMODE(found.st_mode) & ~(stat.S_IWGRP | stat.S_IWOTH))


def _unkept(source: str, read: Read, name: str) -> ModuleType:
    """A module compiled in a folder for the while, or from its text alone."""
    try:
        with temporary_folder() as where:
            return _uncached_module(where, source, read, name)
    except ModelError:  # no folder for temporary files either
        return read(source, None, name)


def _uncached_module(where: Path, source: str, read: Read, name: str) -> ModuleType:
    path = where / "kernel.py"
    try:
        path.write_text(source, encoding="utf-8")
        return read(source, path, name)
    except OSError:  # no room for the source or for its machine code
        return read(source, None, name)


def _files(place: Path) -> dict[str, str]:
    return {
        path.relative_to(place).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(place.rglob("*"))
        if path.is_file() and path.name != SUMS
    }


def _write_sums(place: Path) -> None:
    (place / SUMS).write_text(json.dumps(_files(place)), encoding="utf-8")


def _sound(place: Path) -> bool:
    """Whether a kept kernel is whole, to the last byte, and nothing in it can be another user's."""
    try:
        if not all(map(_is_private, (place, *place.rglob("*")))):
            return False
        told = json.loads((place / SUMS).read_text(encoding="utf-8"))
        return bool(told) and told == _files(place)
    except (OSError, ValueError):
        return False


def _remove(place: Path) -> None:
    """Remove what stands in a kernel's place, never what a link leads to."""
    if place.is_symlink() or place.is_file():
        with contextlib.suppress(OSError):
            place.unlink()
    else:
        shutil.rmtree(place, ignore_errors=True)


def _prune(kernels: Path) -> None:
    places = sorted((place for place in kernels.iterdir() if place.is_dir()), key=lambda place: place.stat().st_mtime)
    for place in places[: max(0, len(places) - MOST)]:
        _remove(place)
