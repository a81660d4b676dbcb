"""Where a joint with clearance may lose contact: its reaction all but vanishes, or turns over at once.

With contact kept, the clearance acts as a massless link; where the link's force all but vanishes, or turns over, it
isn't held (Wu and Earles 1977; docs/theory.md). Found by roots of exact rates, not read off samples.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray

from linkwright.results import Run
from linkwright.results.stationary import Rows, bracketed, stationary

Array = NDArray[np.float64]
Span = tuple[float, float, str]
Forces = Callable[[Array], tuple[Array, Array]]
"""The force at one contact and its rate at some times: (components, times) each."""

LIGHT, TURNED, AT_ONCE = "light", "turned", "at-once"


def lost_contact_spans(run: Run, forces: Forces, least: float) -> list[Span]:
    """The spans (s) in which a force (N) is smaller than ``least``, and the jumps in which it turns over.

    The cause is ``turned`` where the force points more than 90 deg away from where it did once it is back, ``at-once``
    where it does so in a jump of a load, else ``light``.
    """

    def beyond(t: Array) -> tuple[Array, Array]:
        """How much larger than the least force, squared, with its rate: (times,) each."""
        force, rate = forces(t)
        return np.nan_to_num((force**2).sum(axis=0), nan=np.inf) - least**2, 2 * (force * rate).sum(axis=0)

    def rows(t: Array) -> tuple[Array, Array]:
        value, rate = beyond(t)
        return value[None, :], rate[None, :]

    turning = stationary(rows, run.start, run.stop, run.grid)[0]
    edges = np.unique(np.concatenate([[run.start, run.stop], turning, run.breaks, run.jumps.ravel()]))
    value = beyond(edges)[0]
    passing = np.flatnonzero(np.sign(value[:-1]) * np.sign(value[1:]) < 0)

    def root(t: Array, _: Rows) -> Array:
        return beyond(t)[0]

    roots = bracketed(root, np.zeros(passing.size, dtype=np.intp), edges[passing], edges[passing + 1])
    found = [(a, b) for a, b in _below(np.union1d(edges, roots), beyond) if b > a]
    spans = [(a, b, TURNED if _turned(forces, a, b) else LIGHT) for a, b in found]
    for before, after in run.jumps.tolist():
        if _turned(forces, before, after) and not any(a <= after and before <= b for a, b in found):
            spans.append((before, after, AT_ONCE))
    return sorted(spans)


def _below(times: Array, beyond: Forces) -> list[tuple[float, float]]:
    """The spans between neighbouring times in which the force is below the least, joined."""
    inside = beyond((times[:-1] + times[1:]) / 2)[0] < 0
    found: list[tuple[float, float]] = []
    for a, b, below in zip(times[:-1].tolist(), times[1:].tolist(), inside, strict=True):
        if below and found and found[-1][1] == a:
            found[-1] = (found[-1][0], b)
        elif below:
            found.append((a, b))
    return found


def _turned(forces: Forces, before: float, after: float) -> bool:
    """Whether a force points more than 90 deg away from where it did."""
    force, _ = forces(np.array([before, after]))
    return bool(force[:, 0] @ force[:, 1] < 0)


def merge_spans(spans: Iterable[Span]) -> list[Span]:
    """The spans of several contacts in the order of time, those that overlap as one; that something turns counts more
    than that it is light."""
    found: list[Span] = []
    for start, stop, cause in sorted(spans):
        if found and start <= found[-1][1]:
            before, end, known = found[-1]
            found[-1] = before, max(stop, end), cause if known == LIGHT else known
        else:
            found.append((start, stop, cause))
    return found
