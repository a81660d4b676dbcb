"""What has no region with an exact boundary: points that run away, and pins that meet where no mesh can go around."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.findings import Finding, Joined
from linkwright.graph.rows import Determinant
from linkwright.kernels import KERNELS, Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.studies.workspace.assembly_signs import combinations
from linkwright.studies.workspace.mesh import SMALL, DriveBox, found_pits
from linkwright.studies.workspace.sheet import ModeSheet

if TYPE_CHECKING:
    from linkwright.studies.workspace.options import WorkspaceOptions

Array = NDArray[np.float64]

STEPS = 24
MANY = 8
"""The outer pins of groups meet in fewer separate places than this; else they do along a curve."""
PARALLEL = 1e-6
"""Two guides are parallel below this sine of their angle."""
EDGE = 1e-6
"""A place within this share of a range from its end lies on it."""


def unfit(compiled: Compiled, options: WorkspaceOptions, path: tuple[str, ...]) -> Iterator[Finding]:
    """What stands against a workspace of two drives, for any combination of values."""
    if len(compiled.graph.drives) != 2:
        return
    box = options.box(compiled)
    first, second = compiled.graph.drives
    signs = combinations(compiled, options.modes)
    sheet = ModeSheet(compiled, options.point, (first, second), signs[0])
    inner = EDGE * box.size  # exactly where pins meet nothing is known
    grid = [np.linspace(a, b, STEPS + 1) for a, b in zip(box.low + inner, box.high - inner, strict=True)]
    q = np.stack(np.meshgrid(*grid, indexing="ij"))
    for values in options.values(compiled):
        sheet.parameters = Varied(compiled, tuple(values)).parameters(np.array([*values.values()])[:, None])[:, 0]
        if (where := _parallel(sheet, q)) is not None:
            yield Finding(
                "workspace.unbounded", (*path, "drives"), {"name": options.point, **_drive_values(compiled, where)}
            )
            return
        if (where := _meeting_drives(sheet, box, q)) is not None:
            yield Finding("workspace.pins-meet", (*path, "drives"), _drive_values(compiled, where))
            return


def _parallel(sheet: ModeSheet, q: Array) -> Array | None:
    """Drive values (2,) near which the guides of a group become parallel, so that its links run away."""
    slides = [Determinant(group.label) for group in sheet.compiled.structure.groups if group.modes == 1]
    if not slides:
        return None
    program = sheet.compiled.graph.program(slides)
    with np.errstate(all="ignore"):
        rows = KERNELS[sheet.kernel](program).run(sheet.inputs(q.reshape(2, -1)), sheet.parameters)
    for row in rows[np.isfinite(rows).any(axis=1)]:
        if np.nanmin(row) < PARALLEL and np.nanmax(row) > -PARALLEL:
            return np.asarray(q.reshape(2, -1)[:, np.nanargmin(np.abs(row))])
    return None


def _meeting_drives(sheet: ModeSheet, box: DriveBox, q: Array) -> Array | None:
    """Drive values (2,) at which outer pins of a group meet at an end of a range, or along a curve."""
    look = sheet.look(q.reshape(2, -1))
    with np.errstate(all="ignore"):
        size = np.where(look.reach > 0, look.closure**2 / look.reach, np.inf).reshape(q.shape[1:])
    padded = np.pad(size, 1, constant_values=np.inf)
    around = np.lib.stride_tricks.sliding_window_view(padded, (3, 3))
    low = (size <= around.min(axis=(2, 3))) & (size < SMALL)
    held = ~np.array(box.turns)
    edges = np.zeros(low.shape, dtype=bool)
    edges[[0, -1], :] |= held[0]
    edges[:, [0, -1]] |= held[1]
    if low.sum() <= MANY and not (low & edges).any():
        return None
    corners = q[:, low & edges & (size < EDGE**1.5)]
    if corners.size:
        return np.asarray(corners[:, 0])
    pits = found_pits(sheet, box)
    share = (pits - np.array(box.low)[:, None]) / box.size[:, None]
    within = ((share > -EDGE) & (share < 1 + EDGE)).all(axis=0)
    pits, share = pits[:, within], share[:, within]
    ends = (held[:, None] & (np.abs(share - np.round(share)) < EDGE)).any(axis=0)
    chosen = pits[:, ends] if pits.shape[1] <= MANY else pits
    return chosen[:, 0] if chosen.size else None


def _drive_values(compiled: Compiled, where: Array) -> Mapping[str, Any]:
    at = []
    for drive, value in zip(compiled.graph.drives, where.tolist(), strict=True):
        unit, size = compiled.quantities.drive_unit(drive)
        at.append(f"{drive} = {value / size:.4g} {unit}")
    return {"at": Joined(at)}
