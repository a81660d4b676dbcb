"""The manifest of a results folder: what linkwright wrote there, from which model, and whether it is complete."""

from __future__ import annotations

import json
import os
import re
from dataclasses import asdict, field
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, ConfigDict, TypeAdapter, ValidationError

from linkwright import _version
from linkwright.data_classes import dataclass
from linkwright.findings import ModelError
from linkwright.model.input_files import MAX_BYTES, read_at_most
from linkwright.model.origin import Origin, hashed
from linkwright.model.output_files import refuse_link, write_aside
from linkwright.words import say

NAME = "linkwright-manifest.json"
OUTDATED = "outdated"
"""The folder for the last results that no longer are the model's."""
_STATE = re.compile(r"\w+(-[0-9a-f]+\.(samples|signals)|\.zarr|\.zarr\.checkpoint|\.parts)")


def _plain(name: str) -> str:
    """A manifest may have been edited: no name in it leads out of its folder."""
    if name in ("", ".", "..") or set(name) & set('/\\:"\0'):
        raise ValueError("no plain name")
    return name


def _resumable(name: str) -> str:
    if not _STATE.fullmatch(name):
        raise ValueError("no file of an interrupted study")
    return name


_STRICT = ConfigDict(extra="forbid")


@dataclass
class Entry:
    """A file with its size (bytes) and SHA-256; or a folder, such as a Zarr store, with its count of ``files`` and
    the size of all of them."""

    __pydantic_config__ = _STRICT
    name: Annotated[str, AfterValidator(_plain)]
    size: int
    sha256: str | None = None
    files: int | None = None

    @classmethod
    def of(cls, name: str, content: bytes) -> Entry:
        """A file that is about to be written."""
        return cls(name=name, size=len(content), sha256=hashed(content))

    @classmethod
    def of_folder(cls, path: Path) -> Entry:
        """A folder that is complete."""
        files, size = _extent(path)
        return cls(name=path.name, size=size, files=files)

    def unchanged(self, folder: Path) -> bool:
        """Whether it still lies in the folder as it was written."""
        path = folder / self.name
        try:
            if path.is_symlink():
                return False
            if self.files is not None:
                return path.is_dir() and _extent(path) == (self.files, self.size)
            return hashed(read_at_most(path, self.size)) == self.sha256
        except (ModelError, OSError):
            return False


def _extent(path: Path) -> tuple[int, int]:
    """How many files a folder has, and their size."""
    sizes = [Path(top, name).lstat().st_size for top, _, names in os.walk(path) for name in names]
    return len(sizes), sum(sizes)


State = Literal["running", "done", "interrupted", "failed", "outdated"]


@dataclass
class CommandFiles:
    """What one kind of command wrote: the studies, or an export.

    ``outdated`` are the files of the last run that was done, in the folder of that name; ``resumable`` the files from
    which interrupted studies go on, each with its study; ``process`` and ``host`` those of a run under way.
    """

    __pydantic_config__ = _STRICT
    state: State
    linkwright: str = field(default=_version.__version__, kw_only=True)
    date: str
    process: int | None = None
    host: str | None = None
    files: list[Entry] = field(default_factory=list)
    outdated: list[Entry] = field(default_factory=list)
    resumable: dict[Annotated[str, AfterValidator(_resumable)], str] = field(default_factory=dict)


@dataclass
class Model:
    """The model that all files come from: its file, its content and that of its tables as SHA-256."""

    __pydantic_config__ = _STRICT
    file: str | None = field(default=None, kw_only=True)
    sha256: str
    tables: dict[str, str] = field(default_factory=dict)

    @classmethod
    def of(cls, origin: Origin) -> Model:
        """Those of an origin."""
        return cls(file=origin.file, sha256=origin.sha256, tables=dict(origin.tables))


@dataclass
class Manifest:
    """All of it; ``manifest`` is the version of this format."""

    __pydantic_config__ = _STRICT
    manifest: Literal[1] = field(default=1, kw_only=True)
    about: str = field(default="", kw_only=True)
    model: Model
    written: dict[str, CommandFiles] = field(default_factory=dict)

    @property
    def empty(self) -> bool:
        """Whether it names no file."""
        return not any(part.files or part.outdated or part.resumable for part in self.written.values())

    def write(self, folder: Path) -> None:
        """Write it, whole or not at all. Raises OSError."""
        self.about = say("manifest.about")
        written = asdict(self, dict_factory=_known)
        write_aside(folder / NAME, json.dumps(written, indent=2, ensure_ascii=False) + "\n")


def _known(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    return {name: value for name, value in pairs if value is not None}


@cache
def _reader() -> TypeAdapter[Manifest]:
    """What checks a manifest that is read: slow to make, and most folders have none yet."""
    return TypeAdapter(Manifest)


def read_manifest(folder: Path) -> Manifest | None:
    """The manifest of a folder; ``None`` where there is none that can be read."""
    try:
        refuse_link(folder / NAME)
        text = read_at_most(folder / NAME, MAX_BYTES)
        return _reader().validate_json(text)
    except (ModelError, OSError, ValidationError):
        return None
