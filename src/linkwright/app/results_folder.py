"""A folder of results: one run at a time writes to it, replaces what linkwright wrote before, and nothing else.

1. A run locks the folder and looks for files in its way that linkwright didn't write, or that were changed since. It
   refuses to overwrite them, unless forced, and then has changed nothing.
2. What linkwright wrote before is set aside into ``outdated``: that of the same kind of command, and all that comes
   from another model or another version of it. So whatever happens next, nothing old looks current.
3. Each file is entered in the manifest before it is written.
4. Nothing is written or moved through a link that stands in the folder.
5. When the run is done, its outdated files are removed; after one that failed or was interrupted they stay.
"""

from __future__ import annotations

import os
import platform
import shutil
from codecs import BOM_UTF8
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path
from types import TracebackType

from linkwright.app.csv_heads import PROGRAMS, worded
from linkwright.app.manifest import NAME, OUTDATED, CommandFiles, Entry, Manifest, Model, State, read_manifest
from linkwright.blocks.lock import Lock
from linkwright.findings import Finding, Joined, ModelError
from linkwright.model.origin import Origin
from linkwright.model.output_files import make_folder, write_aside
from linkwright.words import language, say

LOCK = ".linkwright.lock"
STUDIES = "studies"
"""The kind of all commands that perform studies."""


class ResultsFolder:
    """The results folder of one run, for a ``with``; ``kind`` is :data:`STUDIES` or an export's name.

    Entering it locks the folder, :meth:`begin` prepares it, :meth:`done` says that all is written; left without that,
    the run has failed. Raises :class:`ModelError` for a folder in use and for files in the way, OSError where it can't
    be written to. With ``comments``, CSV files begin with comments that name their origin; with ``excel``, with the
    mark of UTF-8, without which Excel reads them as in the system's encoding.
    """

    def __init__(
        self,
        path: Path,
        origin: Origin,
        kind: str = STUDIES,
        *,
        force: bool = False,
        comments: bool = False,
        excel: bool = False,
    ) -> None:
        self.path, self._origin, self._force, self._commented, self._excel = path, origin, force, comments, excel
        self._kind, self._lock = kind, Lock(path / LOCK)
        self._manifest = Manifest(model=Model.of(origin))
        self._part = CommandFiles(state="running", date=origin.date)
        self._begun = self._refused = self._made = False

    @property
    def outdated(self) -> Path | None:
        """Where the files of the last run that was done are, if they aren't current any more."""
        return self.path / OUTDATED if self._part.outdated else None

    def __enter__(self) -> ResultsFolder:
        self._made = not self.path.exists()
        self.path.mkdir(parents=True, exist_ok=True)
        if not self._lock.acquire():
            raise ModelError([self._busy()])
        self._manifest = read_manifest(self.path) or self._manifest
        return self

    def _busy(self) -> Finding:
        manifest = read_manifest(self.path)
        running = [part for part in manifest.written.values() if part.state == "running"] if manifest else []
        if manifest is None or not running:  # it has only just begun
            return Finding("folder.busy", data={"folder": str(self.path)})
        part = running[-1]
        data = {"model": manifest.model.file or "-", "date": part.date, "process": part.process, "host": part.host}
        return Finding("folder.busy-with", data={"folder": str(self.path), **data})

    def begin(self, names: Iterable[str] = ()) -> None:
        """Set aside what was written before; ``names`` are those of the files that may be written.

        Raises :class:`ModelError`, and leaves everything as it is, where foreign files stand in their way.
        """
        manifest, model = self._manifest, Model.of(self._origin)
        before = manifest.written.get(self._kind)
        for part in manifest.written.values():
            part.files = [entry for entry in part.files if entry.unchanged(self.path)]
        old = {kind: part for kind, part in manifest.written.items() if kind == self._kind or manifest.model != model}
        self._refuse([*names, NAME], [entry for part in old.values() for entry in part.files])
        self._begun = True
        for kind, part in manifest.written.items():
            if kind in old:
                self._set_aside(part)
            elif part.state == "running":  # it was killed: the folder's lock is free
                part.state = "failed"
        if before is not None:
            self._part.outdated, self._part.resumable = before.outdated, before.resumable
        self._part.process, self._part.host = os.getpid(), platform.node()
        manifest.model = model
        manifest.written.pop(self._kind, None)
        manifest.written[self._kind] = self._part
        manifest.write(self.path)

    def _refuse(self, names: Iterable[str], old: list[Entry]) -> None:
        """Raise :class:`ModelError` for files that would be overwritten, though linkwright didn't write them; ``old``
        ones are about to be moved."""
        parts = self._manifest.written.values()
        names = [*names, *([OUTDATED] if (self.path / OUTDATED).is_symlink() else [])]
        own = {name for part in parts for name in (*part.resumable, *(entry.name for entry in part.files))}
        own = {name for name in own if not (self.path / name).is_symlink()}
        own |= {NAME} if read_manifest(self.path) else set()
        aside = self.path / OUTDATED
        there = {entry.name for part in parts for entry in part.outdated if entry.unchanged(aside)}
        foreign = [name for name in dict.fromkeys(names) if name not in own and os.path.lexists(self.path / name)]
        foreign += [f"{OUTDATED}/{e.name}" for e in old if e.name not in there and os.path.lexists(aside / e.name)]
        if foreign and not self._force:
            self._refused = True
            data = {"folder": str(self.path), "files": Joined(foreign)}
            raise ModelError([Finding("folder.foreign", data=data)])
        for path in (self.path / name for name in foreign):
            if path.is_symlink():
                path.unlink()

    def _set_aside(self, part: CommandFiles) -> None:
        """Move files of a run that was done to ``outdated``; remove those of one that wasn't."""
        if part.state == "done" and part.files:
            self._clear(part)
            part.outdated = part.files
            self._manifest.write(self.path)  # whatever stops it here, they are known in both places
            make_folder(self.path / OUTDATED)
            for entry in part.files:
                (self.path / entry.name).replace(self.path / OUTDATED / entry.name)
        else:
            for entry in part.files:
                _remove(self.path / entry.name)
        part.files, part.state = [], "outdated"

    def _clear(self, part: CommandFiles, name: str | None = None) -> None:
        """Remove what was set aside, all or of one name, but what was changed since."""
        for entry in part.outdated:
            if name in (None, entry.name) and entry.unchanged(self.path / OUTDATED):
                _remove(self.path / OUTDATED / entry.name)
        part.outdated = [entry for entry in part.outdated if name not in (None, entry.name)]
        with suppress(OSError):
            (self.path / OUTDATED).rmdir()

    def keep(self, path: Path, study: str) -> None:
        """A study is about to make a file from which it can go on. Raises :class:`ModelError`."""
        self._part.resumable[path.name] = study
        try:
            self._clear(self._part, path.name)  # a store may be large
            self._manifest.write(self.path)
        except OSError as error:
            from linkwright.blocks.checkpoint import unsaved

            raise unsaved(self.path, error) from None

    def write(self, name: str, content: str | bytes) -> None:
        """Write a file, whole or not at all."""
        if self._excel and language() != PROGRAMS and name.endswith(".csv") and isinstance(content, str):
            content = worded(name, content)
        data = content.encode() if isinstance(content, str) else content
        if self._commented and name.endswith(".csv"):
            data = self._comments().encode() + data
        if self._excel and name.endswith(".csv"):
            data = BOM_UTF8 + data.removeprefix(BOM_UTF8)
        for part in self._manifest.written.values():  # two exports may write files of one name
            part.files = [entry for entry in part.files if entry.name != name]
        self._part.files.append(Entry.of(name, data))
        self._manifest.write(self.path)
        write_aside(self.path / name, data)

    def _comments(self) -> str:
        origin = self._origin
        return say(
            "csv.comments", file=origin.file or "-", sha256=origin.sha256, date=origin.date, version=origin.version
        )

    def done(self, studies: Iterable[str] = (), stores: Iterable[str] = (), state: State = "done") -> None:
        """All is written. Nothing is left from which the ``studies`` would go on, but ``stores`` that they filled; in
        another ``state`` than "done" the run ends without being complete."""
        performed, filled = set(studies), set(stores)
        self._end(state)
        if state == "done":
            for name in [name for name, study in self._part.resumable.items() if study in performed]:
                del self._part.resumable[name]
                if name not in filled:
                    _remove(self.path / name)
            self._part.files += [Entry.of_folder(self.path / name) for name in sorted(filled)]
            self._clear(self._part)
        self._manifest.write(self.path)

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        try:
            if self._part.state == "running" and not self._refused:
                with suppress(OSError, ModelError):
                    if not self._begun:
                        self.begin()
                    self._fail("interrupted" if isinstance(error, KeyboardInterrupt) else "failed")
        finally:
            self._lock.release()
            if self._made:
                with suppress(OSError):  # where nothing was written, nothing is left
                    self.path.rmdir()

    def _end(self, state: State) -> None:
        self._part.state, self._part.process, self._part.host = state, None, None

    def _fail(self, state: State) -> None:
        self._part.files = [entry for entry in self._part.files if entry.unchanged(self.path)]
        part = self._part
        part.resumable = {n: study for n, study in part.resumable.items() if os.path.lexists(self.path / n)}
        self._end(state)
        if self._manifest.empty:
            (self.path / NAME).unlink(missing_ok=True)
        else:
            self._manifest.write(self.path)


def outdate(path: Path, origin: Origin, kind: str = STUDIES) -> Path | None:
    """Nothing can be made of a model: what linkwright wrote to the folder from another one, or before this one was
    changed, is no longer current. Gives where it is set aside, where there was such."""
    manifest = read_manifest(path)
    if manifest is None or manifest.model == Model.of(origin):
        return None
    try:
        with ResultsFolder(path, origin, kind) as folder:
            pass
    except (ModelError, OSError):  # it is in use, or can't be changed
        return None
    return folder.outdated


def _remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)
