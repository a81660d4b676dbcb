"""Results larger than memory: a Zarr store (format 3), written atom by atom, that xarray reads.

An atom is one chunk of each variable, written before the atom counts as done; a chunk that was written but not yet
counted when a study ended is written again. The count stands beside the store, in ``NAME.checkpoint``. Once all atoms
are written, every chunk has to be there as a whole file. One process at a time fills a store, by a lock beside it.
"""

from __future__ import annotations

import itertools
import math
import re
import stat
import warnings
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from linkwright._machine import needed
from linkwright.blocks.checkpoint import Checkpoint, unsaved
from linkwright.blocks.lock import Lock, shared
from linkwright.blocks.work import UNIT, Arrays, Cut
from linkwright.data_classes import dataclass
from linkwright.findings import Finding, ModelError
from linkwright.model.output_files import refuse_links_in

WHOLE = {"array.write_empty_chunks": True}
"""Zarr leaves out chunks of NaN alone, which then look like those that nobody has written."""
_UNFIT = re.compile(r"[^\w.,@+()-]|^__")


@dataclass(frozen=True)
class Variable:
    """An array of the store: its name, its dimensions (``sample``, ``pose``, both), its unit ("" for none).

    ``coordinate`` says that it tells where the others stand, such as the angles of poses or the samples' dimensions.
    """

    name: str
    dims: tuple[str, ...] = ("sample", "pose")
    unit: str = ""
    coordinate: bool = False


class Stored:
    """A sink that writes each atom's arrays, named as the variables, into a Zarr store at ``path``.

    An atom gives float64 arrays (samples, poses), or (samples,) where the variable has no ``pose``; those over poses
    alone stand in ``fixed`` and are written at the start, as may others be. Where the store is there already, it is
    gone on with, if its checkpoint has the same ``key`` and ``versions``; ``anew`` begins it again and writes over it.
    NaN stands where nothing is written yet. Raises :class:`~linkwright.findings.ModelError` also for links in a
    store and for one that another process fills.
    """

    def __init__(
        self,
        path: Path,
        key: str,
        cut: Cut,
        variables: Sequence[Variable],
        fixed: Mapping[str, ArrayLike] | None = None,
        attributes: Mapping[str, Any] | None = None,
        anew: bool = False,
        versions: Mapping[str, str] | None = None,
    ) -> None:
        self._path, self._cut = path, cut
        self._checkpoint = Checkpoint(path.with_name(f"{path.name}.checkpoint"), key, anew, versions or {})
        self._variables, self._fixed = tuple(variables), dict(fixed or {})
        self._lock: Lock | None = None
        self._reserve()
        refuse_links_in(path)
        zarr = needed("zarr", "cluster")
        saved = self._checkpoint.read()
        if saved is None and path.exists() and not anew:
            raise ModelError([Finding("file.exists", (), {"file": str(path)})])
        self.next = 0 if saved is None else saved.next
        with zarr.config.set(WHOLE):
            self._arrays = self._open_arrays(zarr, saved is not None, dict(attributes or {}))

    def _open_arrays(self, zarr: Any, begun: bool, attributes: dict[str, Any]) -> dict[str, Any]:
        """The arrays, with what is fixed: of the store that is there, or of one made now."""
        there = self._opened(zarr) if begun else None
        if there is None and self.next:
            raise ModelError([Finding("blocks.corrupt", (), {"file": str(self._path)})])
        try:
            if there is None:
                self._checkpoint.write(0, {})
                there = self._created_arrays(zarr, {**self._checkpoint.all_versions, **attributes})
            for name, values in self._fixed.items():
                there[name][...] = np.asarray(values, dtype=np.float64)
        except OSError as error:
            raise unsaved(self._path, error) from None
        return there

    def _reserve(self) -> None:
        """Keep other processes out."""
        if self._lock is None:
            try:
                self._lock = shared(self._path.with_name(f".{self._path.name}.lock"))
            except OSError as error:
                raise unsaved(self._path, error) from None
            if self._lock is None:
                raise ModelError([Finding("blocks.busy", (), {"file": str(self._path)})])

    def close(self) -> None:
        """Let other processes in: nothing is about to be written."""
        self._lock = None

    def _opened(self, zarr: Any) -> dict[str, Any] | None:
        """The arrays of a store that was made whole; ``None`` for another. One of which nothing is counted yet isn't
        made again: whoever fills it writes the same chunks."""
        try:
            group = zarr.open_group(self._path, mode="r+")
            if group.metadata.consolidated_metadata is None:  # what is written last
                return None
            return {v.name: group[stored_name(v.name)] for v in self._variables}
        except (OSError, KeyError, ValueError):
            return None

    def _created_arrays(self, zarr: Any, attributes: dict[str, Any]) -> dict[str, Any]:
        sizes = {"sample": self._cut.samples, "pose": self._cut.poses}
        pieces = self._pieces
        located = " ".join(stored_name(v.name) for v in self._variables if v.coordinate and v.dims != (v.name,))
        group = zarr.open_group(self._path, mode="w", zarr_format=3, attributes=attributes)
        arrays: dict[str, Any] = {}
        for v in self._variables:
            attributes = {"long_name": v.name, "units": v.unit or "1"}
            if located and not v.coordinate:
                attributes["coordinates"] = located
            arrays[v.name] = group.create_array(
                stored_name(v.name),
                shape=tuple(sizes[dim] for dim in v.dims),
                chunks=tuple(pieces[dim] for dim in v.dims),
                dtype="float64",
                fill_value=np.nan,
                compressors=None,  # measured values hardly shrink, and packing them costs more than writing them
                dimension_names=v.dims,
                attributes=attributes,
            )
        with warnings.catch_warnings():  # not in the format's text yet, but what xarray looks for
            warnings.simplefilter("ignore")
            zarr.consolidate_metadata(self._path)
        return arrays

    def take(self, atom: int, result: Arrays) -> None:
        """Write the arrays of atom ``next``."""
        self._reserve()
        at = {"sample": self._cut.sample_slice(atom), "pose": self._cut.pose_slice(atom)}
        for v in self._variables:
            if v.name in self._fixed or ("pose" not in v.dims and self._cut.range(atom)):
                continue
            try:
                self._arrays[v.name][tuple(at[dim] for dim in v.dims)] = result[v.name]
            except OSError as error:
                self._clear(atom)
                raise unsaved(self._path, error) from None
        self.next = atom + 1

    def _clear(self, atom: int) -> None:
        """Take back an atom that couldn't be written whole: the space lets the count be saved."""
        at = {"sample": self._cut.unit(atom), "pose": self._cut.range(atom)}
        for v in self._variables:
            if v.name not in self._fixed and "pose" in v.dims:
                with suppress(OSError):
                    self._chunk(v, [at[dim] for dim in v.dims]).unlink()

    @property
    def _pieces(self) -> dict[str, int]:
        """The length of a chunk in each dimension."""
        return {"sample": max(min(UNIT, self._cut.samples), 1), "pose": self._cut.width}

    def _chunk(self, variable: Variable, at: Sequence[int]) -> Path:
        """The file of a chunk."""
        return Path(self._path, stored_name(variable.name), "c", *map(str, at))

    def save(self) -> None:
        """Count what is written. Once all is, raises :class:`ModelError` where chunks are missing, and counts up to
        the first of them."""
        complete = self.next == self._cut.atoms
        missing, total = self._holes() if complete else ([], 0)
        if missing:
            self.next = min(missing)
        self._checkpoint.write(self.next, {})
        if missing:
            data = {"file": str(self._path), "count": len(missing), "total": total}
            raise ModelError([Finding("blocks.holes", (), data)])
        if complete:
            self.close()

    def _holes(self) -> tuple[list[int], int]:
        """The atoms whose chunks aren't there as whole files, one for each of these, and how many chunks there are.
        Values tell nothing: an atom may well consist of NaN. What is fixed belongs to the first atom."""
        counts, missing, total = {"sample": self._cut.units, "pose": self._cut.ranges}, [], 0
        for v in self._variables:
            size = 8 * math.prod(self._pieces[dim] for dim in v.dims)
            for at in itertools.product(*(range(counts[dim]) for dim in v.dims)):
                total += 1
                if not _is_file_of_size(self._chunk(v, at), size):
                    place = dict(zip(v.dims, at, strict=True))
                    atom = place.get("sample", 0) * self._cut.ranges + place.get("pose", 0)
                    missing.append(0 if v.name in self._fixed else atom)
        return missing, total


def _is_file_of_size(file: Path, size: int) -> bool:
    try:
        found = file.lstat()
    except OSError:
        return False
    return stat.S_ISREG(found.st_mode) and found.st_size == size


def stored_name(name: str) -> str:
    """The name that a variable has in the store: letters of any script and ``.,@+()-_``, others spelled ``_u002f``."""
    return _UNFIT.sub(lambda match: "".join(f"_u{ord(letter):04x}" for letter in match[0]), name.strip())
