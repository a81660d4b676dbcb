"""What motor and servo give along a motion of both drives: torques, powers and their shares.

The mechanism's own program is fed with values, speeds and accelerations of the drives directly; loads and springs
are supplied as for a run.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.kernels import KERNELS
from linkwright.kernels.external_inputs import Supply
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
NOTHING = 1e-12
"""Work below this share of the kinetic energy is round-off."""
Motion = Callable[[Array], tuple[Array, Array]]


@dataclass(frozen=True, eq=False)
class Efforts:
    """Of motor and servo, (2, samples) each: ``effort`` (N m, or N of a cylinder) and ``power`` (W), positive where the
    drive gives energy. ``work`` (2,) and ``taken`` (2,) are what each gives and takes back (J, both positive);
    ``share`` is the servo's of all that both give, ``None`` where nothing is to be done."""

    effort: Array
    power: Array
    work: Array
    taken: Array
    share: float | None


def efforts(sheet: ModeSheet, names: tuple[str, str], at: Motion, t: Array) -> Efforts:
    """Along a motion: ``at(t)`` gives the drives ``names`` with two rates, (3, 2, n), and the path's u."""
    from scipy.integrate import trapezoid

    compiled = sheet.compiled
    graph = compiled.graph
    kinds = ["torque" if compiled.mechanism.prescribed(name).turns else "force" for name in names]
    rows = [f"{name}.{kind}" for name, kind in zip(names, kinds, strict=True)] + [f"{name}.power" for name in names]
    first = [graph.drives.index(name) * graph.width for name in names]

    def inputs(times: Array) -> Array:
        motion, _ = at(times)
        x = sheet.inputs(np.zeros((2, times.size)))
        for row, drive in zip(first, np.moveaxis(motion, 1, 0), strict=True):
            x[row : row + 3] = drive
        return x

    rows.append("energy.kinetic")
    x = inputs(t)
    Supply(graph, compiled.tables, sheet.kernel).fill(x, t, sheet.parameters, inputs)
    y = KERNELS[sheet.kernel](graph.program(rows)).run(x, sheet.parameters)
    power = y[2:4]
    work, taken = (trapezoid(np.maximum(part, 0.0), t, axis=1) for part in (power, -power))
    whole = float(work.sum())
    some = whole > NOTHING * float(np.abs(y[4]).max())
    return Efforts(y[:2], power, work, taken, float(work[1]) / whole if some else None)
