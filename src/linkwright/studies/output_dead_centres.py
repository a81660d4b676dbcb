"""Drives whose law is prescribed on an output: where they stand at a dead centre against it."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwright.findings import Finding, Joined
from linkwright.graph.rows import OutputLever
from linkwright.results import Run
from linkwright.results.claims import SINGULAR
from linkwright.results.stationary import crossings, stationary
from linkwright.studies.assembly_checks import drive_value

Array = NDArray[np.float64]


def powerless(run: Run) -> list[Finding]:
    """A finding for each instant at which the drives with outputs can't move them.

    There the drives' rates vanish while the outputs move: the determinant of the one over the other is zero.
    """
    outputs = [name for name, drive in run.compiled.mechanism.drives.items() if drive.output]
    if not outputs:
        return []
    row = [OutputLever()]

    def lever(t: Array) -> Array:
        return np.asarray(run.compiled.evaluate(row, t)[0])

    t = np.union1d(
        np.linspace(run.start, run.stop, run.grid + 1),
        stationary(partial(run.compiled.rates, row), run.start, run.stop, run.grid)[0],
    )
    size = np.abs(lever(t))
    low = t[~(size > SINGULAR * float(np.median(size)))]
    times = np.union1d(crossings(lever, run.start, run.stop, run.grid), low)
    # At a dead centre of the output through which the run is carried the rate of the drive over it has a pole.
    times = times[run.compiled.passages.outside(times)]
    last, found = -np.inf, []
    for time in times.tolist():
        if time - last > 2 * (run.stop - run.start) / run.grid:
            data = {"motors": Joined(outputs), "time": f"{time:.6g}"} | drive_value(run, time)
            found.append(Finding("motion.dead-centre", ("drives", outputs[0]), data))
        last = time
    return found
