"""The folder in which compiled kernels are kept, so that the next process need not compile them again.

A kernel's folder is named after the content of its source and all else that its machine code depends on. It is made
aside and renamed when it is whole; a list of checksums inside is looked at before anything is loaded, so that a
damaged one is made anew. The folder may be removed at any time.
"""

from __future__ import annotations

import contextlib
import hashlib
import importlib.util
import json
import os
import platform
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from types import ModuleType

MOST = 400
"""The most kernels kept; those not used for the longest time go first."""
SUMS = "checksums.json"


def folder() -> Path:
    """``LINKWRIGHT_CACHE``, or the system's place for caches."""
    told = os.environ.get("LINKWRIGHT_CACHE")
    if told:
        return Path(told)
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return base / "linkwright"


def kept(source: str, about: str) -> Path:
    """Where the kernel of a source lies or will lie; ``about`` is what else its machine code depends on."""
    text = "\0".join([source, about, platform.machine(), sys.version])
    return folder() / "kernels" / hashlib.sha256(text.encode()).hexdigest()[:40]


def load(source: str, about: str, read: Callable[[Path, str], ModuleType]) -> ModuleType:
    """The module of a source: the kept one, else compiled by ``read`` (a module's path, its name) and kept.

    Where nothing can be kept (no space, no right to write) it is compiled all the same.
    """
    place = kept(source, about)
    if _sound(place):
        with contextlib.suppress(OSError):
            os.utime(place)
        return read(place / "kernel.py", _name(place))
    shutil.rmtree(place, ignore_errors=True)
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        aside = Path(tempfile.mkdtemp(prefix="new-", dir=place.parent))
    except OSError:
        with tempfile.TemporaryDirectory() as name:
            return _made(Path(name), source, read, _name(place))
    try:
        module = _made(aside, source, read, _name(place))
        with contextlib.suppress(OSError):  # another process may have been first, or the disk is full
            _write_sums(aside)
            aside.rename(place)
            _prune(place.parent)
        return module
    finally:
        shutil.rmtree(aside, ignore_errors=True)


def module_at(path: Path, name: str) -> ModuleType:
    """The module of a file, made known under a name: its machine code is bound to it."""
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _name(place: Path) -> str:
    return f"linkwright_kernel_{place.name}"


def _made(where: Path, source: str, read: Callable[[Path, str], ModuleType], name: str) -> ModuleType:
    path = where / "kernel.py"
    try:
        path.write_text(source, encoding="utf-8")
        return read(path, name)
    except OSError:  # no room for the source or for its machine code: nothing is kept
        module = sys.modules[name] = ModuleType(name)
        module.__dict__["CACHE"] = False
        exec(compile(source, "<kernel>", "exec"), module.__dict__)
        return module


def _files(place: Path) -> dict[str, str]:
    return {
        path.relative_to(place).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(place.rglob("*"))
        if path.is_file() and path.name != SUMS and path.suffix != ".pyc"
    }


def _write_sums(place: Path) -> None:
    (place / SUMS).write_text(json.dumps(_files(place)), encoding="utf-8")


def _sound(place: Path) -> bool:
    """Whether a kept kernel is whole, to the last byte."""
    try:
        told = json.loads((place / SUMS).read_text(encoding="utf-8"))
        return bool(told) and told == _files(place)
    except (OSError, ValueError):
        return False


def _prune(kernels: Path) -> None:
    places = sorted((place for place in kernels.iterdir() if place.is_dir()), key=lambda place: place.stat().st_mtime)
    for place in places[: max(0, len(places) - MOST)]:
        shutil.rmtree(place, ignore_errors=True)
