"""Margins to singularity: how far from a singular pose each group is, from 0 where it is singular to 1 at best."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.rows import Determinant, Span, determinants, spans
from linkwright.results.large_groups import rows_with_rates
from linkwright.results.run import Run
from linkwright.results.stationary import magnitude, stationary

Array = NDArray[np.float64]

LEAST_MARGIN = 1e-3
"""The smallest margin to singularity that excuses lost digits."""


@dataclass(frozen=True)
class Nearest:
    """The group nearest to a singular pose: its margin (0 singular, 1 best) and the time (s)."""

    group: str
    determinant: float
    time: float


def margins(run: Run, t: Array) -> Array:
    """The margin of each row of :func:`rows` at times ``t`` (s): (rows, times); 0 where it is undefined, since exactly
    singular."""
    if not (every := rows(run)):
        return np.empty((0, t.size))
    values, _ = rows_with_rates(run.compiled, every, t, rates=False)
    return np.nan_to_num(np.abs(values) / _largest(run)[:, None], nan=0.0)


def rows(run: Run) -> list[Determinant | Span]:
    """The determinants of all groups, and the spans of those whose pose is vague where a distance vanishes."""
    structure = run.compiled.structure
    return [*determinants(structure), *spans(structure)]


def nearest(run: Run) -> Nearest | None:
    """The smallest margin to singularity of a group over the run, root-found between the samples.

    The bands about change points through which a group is carried are left out: its determinant is zero there.
    """
    return run.cached(nearest, lambda: _nearest(run))


def _largest(run: Run) -> Array:
    """What each row is measured against: determinants are normalised, spans count over their largest in the run."""
    return run.cached(_largest, lambda: _largest_at_samples(run))


def _largest_at_samples(run: Run) -> Array:
    spanning = spans(run.compiled.structure)
    largest = np.ones(len(rows(run)))
    if spanning:
        largest[-len(spanning) :] = np.nanmax(run.compiled.evaluate(spanning, run.t), axis=1)
    return largest


def _nearest(run: Run) -> Nearest | None:
    every = rows(run)

    def rates(t: Array) -> tuple[Array, Array]:
        values, slopes = magnitude(*rows_with_rates(run.compiled, every, t))
        return values / _largest(run)[:, None], slopes / _largest(run)[:, None]

    found = []
    turning = stationary(rates, run.start, run.stop, run.grid) if every else []
    looked = np.unique(np.concatenate([[run.start, run.stop], *turning]))
    for row, own, margin in zip(every, turning, margins(run, looked), strict=True):
        times = np.concatenate([own, [run.start, run.stop]])
        times = times[run.compiled.passages.outside(times, row.group)]
        if times.size:
            values = margin[np.searchsorted(looked, times)]
            found.append(Nearest(row.group, float(values.min()), float(times[values.argmin()])))
    return min(found, key=lambda near: near.determinant, default=None)
