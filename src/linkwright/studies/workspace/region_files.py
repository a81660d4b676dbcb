"""What an interrupted workspace study resumes from: each region in a file of its own as soon as it is found.

The files lie in the folder :data:`FOLDER` of the results. A file is named by the hash of all that its region depends
on: the mechanism with its tables, the options of the study but those that only choose or use regions, the drives'
ranges, the mode, the values of all parameters. So another region is never taken for it, and one that a changed file
still asks for needn't be found again. It holds the versions of linkwright and of the libraries that compute it.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks import Checkpoint
from linkwright.blocks.checkpoint import unsaved
from linkwright.blocks.packing import UnpackError, pack, unpack
from linkwright.data_classes import dataclass
from linkwright.findings import Finding, ModelError
from linkwright.kernels.versions import versions
from linkwright.model.origin import table_hashes
from linkwright.model.output_files import make_folder
from linkwright.studies.run_context import RunContext
from linkwright.studies.workspace.assembly_signs import Signs
from linkwright.studies.workspace.options import PATH, SECTIONS
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Work = tuple[Signs, Array]
"""A region to be found: the mode's signs, and all parameters (SI)."""
Found = tuple[Any, list[Finding]]
"""What comes of it: a region or a curve, ``None`` where there is none; warnings."""

STUDY = PATH[-1]
FOLDER = f"{STUDY}.parts"
FORMAT = "1"
"""Of what stands in a file."""
KERNEL = "numpy"
"""The one that evaluates what regions are found by."""
DIGITS = 24
"""Hex digits of a hash in a file's name; the file holds all of them."""
APART = ("for_", "modes", *SECTIONS)
"""Options of the study that don't change a region."""
NOTED = ("blocks.corrupt", "blocks.other-work", "file.irregular", "file.link", "file.unreadable")
"""Faults of a file that cost no more than the time to find its region again."""


def resumable(
    find: Callable[[Work], Found], sheet: Callable[[Work], ModeSheet], outcome: WorkspaceOutcome, site: RunContext
) -> Callable[[Work], Found]:
    """``find``, but that regions which lie in the site's folder are taken from there, and others written to it as soon
    as they are found. Without a folder, ``find`` itself.

    Raises :class:`ModelError` where the folder can't be made; so does what it gives for files that can't be written.
    """
    if site.out is None:
        return find
    folder = site.out / FOLDER
    try:
        site.out.mkdir(parents=True, exist_ok=True)
        site.keep(folder, STUDY)
        make_folder(folder)
    except OSError as error:
        raise unsaved(folder, error) from None
    import shapely

    found = {**versions(KERNEL, "shapely"), "geos": shapely.geos_version_string, "regions": FORMAT}
    return RegionFiles(folder, common(outcome), found, site.fresh, find, sheet if outcome.box else None)


def common(outcome: WorkspaceOutcome) -> str:
    """What all regions of a study depend on, as text."""
    compiled = outcome.compiled
    tables = table_hashes(compiled.mechanism, compiled.folder)
    mechanism = compiled.mechanism.model_dump(mode="json", exclude={"studies", "exports", "note"})
    options = outcome.options.model_dump(mode="json", exclude=set(APART))
    box = asdict(outcome.box) if outcome.box else None
    uses = repr(compiled.quantities.uses)
    return json.dumps([mechanism, tables, uses, options, box], sort_keys=True)


@dataclass(frozen=True)
class RegionFiles:
    """Finds regions by their files, else by ``find``; several threads may call it at a time. ``sheet`` makes the sheet
    of a region, which isn't kept; ``fresh`` passes over all files that are there."""

    folder: Path
    common: str
    versions: dict[str, str]
    fresh: bool
    find: Callable[[Work], Found]
    sheet: Callable[[Work], ModeSheet] | None

    def __call__(self, work: Work) -> Found:
        """What comes of a work. It is what its file holds even where it was found just now: so a study goes on with the
        same bits, whether or not it was interrupted before."""
        outside = {"sheet": self.sheet(work)} if self.sheet is not None else {}
        file = self._file(work)
        notes = []
        try:
            if (saved := file.read()) is not None:
                return _unpacked(saved.arrays, outside)
        except (ModelError, UnpackError) as fault:
            if isinstance(fault, ModelError) and any(finding.code not in NOTED for finding in fault.findings):
                raise
            notes = [Finding("workspace.part-damaged", PATH, {"file": str(file.path)}, severity="note")]
        arrays = pack(self.find(work), {ModeSheet: "sheet"})
        replace(file, anew=True).write(1, arrays)
        found, warnings = _unpacked(arrays, outside)
        return found, [*warnings, *notes]

    def _file(self, work: Work) -> Checkpoint:
        signs, parameters = work
        content = [self.common.encode(), np.array(signs, dtype="<f8").tobytes(), parameters.astype("<f8").tobytes()]
        key = hashlib.sha256(b"\n".join(content)).hexdigest()
        return Checkpoint(self.folder / f"{key[:DIGITS]}.region", key, self.fresh, self.versions)


def _unpacked(arrays: dict[str, NDArray[Any]], outside: dict[str, ModeSheet]) -> Found:
    found, warnings = unpack(arrays, "linkwright", outside)
    return found, warnings
