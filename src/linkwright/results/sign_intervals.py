"""Stretches of a run in which something holds that can only change where some values change their sign."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from linkwright.results.run import Run
from linkwright.results.stationary import crossings

Array = NDArray[np.float64]

CLEAR = 1e-9
"""Places nearer to each other than this share of the run are one; so little of a largest value is none."""


def between_changes(run: Run, rows: Callable[[Array], Array], count: int) -> Array:
    """The start and stop of a run (s), and between them where one of the ``count`` rows of ``rows`` (count, times)
    changes its sign."""
    known: dict[bytes, Array] = {}  # all rows are looked at on the same grid

    def one_of(row: int, t: Array) -> Array:
        if (key := t.tobytes()) not in known:
            known[key] = np.asarray(rows(t))
        return np.asarray(known[key][row])

    cuts = [crossings(partial(one_of, row), run.start, run.stop, run.grid) for row in range(count)]
    edges = np.unique(np.concatenate([[run.start, run.stop], *cuts]))
    return np.asarray(edges[np.append(True, np.diff(edges) > CLEAR * (run.stop - run.start))])


def stretches(edges: Array, holds: NDArray[np.bool_]) -> list[tuple[float, float]]:
    """The stretches between edges (s) in which something ``holds``; neighbours are one."""
    found: list[tuple[float, float]] = []
    for (a, b), here in zip(pairwise(edges.tolist()), holds, strict=True):
        if here:
            found.append((found.pop()[0], b) if found and found[-1][1] == a else (a, b))
    return found
