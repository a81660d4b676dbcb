"""Newton stages on arrays of poses, for kernels that have no loop of their own."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.program import ACCEPTED, MOST_STEPS, SOLVED, NewtonStage

Array = NDArray[np.float64]


class ClosureValues(Protocol):
    """A closure's misses and slopes over poses: (n + n * n, poses)."""

    def run(self, x: Array, p: Array) -> Array: ...


def solve(stages: Sequence[NewtonStage], closures: Sequence[ClosureValues], x: Array, p: Array) -> Array:
    """The inputs (inputs, poses) with the rows of all stages solved, NaN where they can't be."""
    if not stages:
        return x
    x = x.copy()
    for stage, closure in zip(stages, closures, strict=True):
        _solve(stage, closure, x, p)
    return x


def _solve(stage: NewtonStage, closure: ClosureValues, x: Array, p: Array) -> None:
    """Solve one stage in place. A pose is left alone once it is solved, so that no other has a say in its digits."""
    rows, n = np.array(stage.rows), len(stage.rows)
    scale = np.array(stage.scale)[:, None]
    sliding = np.array(stage.sliding, dtype=float)[:, None]
    open_, moved = np.arange(x.shape[1]), np.full(x.shape[1], np.inf)
    for _ in range(MOST_STEPS):
        y = closure.run(x[:, open_], p if p.ndim == 1 else p[:, open_])
        gap, slope = y[:n].T, y[n:].reshape(n, n, -1).transpose(2, 0, 1)
        step = steps(slope, gap)
        u = x[np.ix_(rows, open_)] - step
        x[np.ix_(rows, open_)] = u
        moved[open_] = np.abs(step / np.maximum(scale, np.abs(u) * sliding)).max(axis=0)
        open_ = open_[moved[open_] >= SOLVED]  # NaN is as good as solved: it stays
        if not open_.size:
            break
    x[np.ix_(rows, np.flatnonzero(~(moved < ACCEPTED)))] = np.nan


def steps(slope: Array, gap: Array) -> Array:
    """Newton's step at each pose, (n, poses); NaN where the slopes are singular or unknown."""
    return quotients(slope, gap[..., None])[..., 0].T


def quotients(slope: Array, right: Array) -> Array:
    """What times the slopes (poses, n, n) makes the right sides, (poses, n, m) both; NaN where the slopes are singular,
    or something is unknown."""
    found = np.full(right.shape, np.nan)
    known = np.asarray(np.isfinite(slope).all(axis=(1, 2)) & np.isfinite(right).all(axis=(1, 2)))
    try:
        found[known] = np.linalg.solve(slope[known], right[known])
    except np.linalg.LinAlgError:
        known[known] = np.linalg.det(slope[known]) != 0
        found[known] = np.linalg.solve(slope[known], right[known])
    return found
