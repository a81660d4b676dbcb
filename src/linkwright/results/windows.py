"""Windows: the parts of a run that a measure looks at or a load acts in, in time or in the value of a signal."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Node
from linkwright.model.bound_window import BoundWindow
from linkwright.results.stationary import crossings

if TYPE_CHECKING:
    from linkwright.results.run import Run

Array = NDArray[np.float64]
Interval = tuple[float, float]


def intervals(run: Run, window: BoundWindow | None) -> list[Interval]:
    """The intervals of time (s) that a window means within a run; the whole run without one."""
    if window is None:
        return [(run.start, run.stop)]
    low, high = (run.compiled.quantities.value(end, window.dimension) for end in window.ends)
    if window.node is None:
        low, high = max(low, run.start), min(high, run.stop)
        return [(low, high)] if low < high else []
    return _within(run, window.node, low, high, window.turning)


def _within(run: Run, node: Node, low: float, high: float, turning: bool) -> list[Interval]:
    """Where an expression lies in low .. high; of an angle, in that range or any whole turns from it."""

    def value(t: Array) -> Array:
        return np.asarray(run.jets(node, t).d[0])

    def beyond(edge: float) -> Array:
        """Times at which the signal passes an edge."""
        if turning:
            return crossings(lambda t: np.sin((value(t) - edge) / 2), run.start, run.stop, run.grid)
        return crossings(lambda t: value(t) - edge, run.start, run.stop, run.grid)

    times = np.unique(np.concatenate([[run.start, run.stop], beyond(low), beyond(high)]))
    middles = value((times[:-1] + times[1:]) / 2)
    offset = np.mod(middles - low, 2 * np.pi) if turning else middles - low
    inside = (offset >= 0) & (offset <= high - low)
    found: list[Interval] = []
    for a, b, ok in zip(times[:-1], times[1:], inside, strict=True):
        if not ok:
            continue
        if found and found[-1][1] == a:
            found[-1] = (found[-1][0], float(b))
        else:
            found.append((float(a), float(b)))
    return found


def passing(run: Run, node: Node, spans: list[Interval], turning: bool) -> Array:
    """The times (s) in some intervals at which an expression is zero, ascending; with ``turning`` also any whole turns
    from it."""

    def value(t: Array) -> Array:
        found = np.asarray(run.jets(node, t).d[0])
        return np.sin(found / 2) if turning else found

    ends = np.array([edge for span in spans for edge in span])
    size = float(np.abs(value(np.linspace(run.start, run.stop, 65))).max(initial=0.0))
    at_ends = ends[np.abs(value(ends)) <= 1e-12 * max(size, 1.0 if turning else 0.0)]
    crossed = crossings(value, run.start, run.stop, run.grid)
    inside = [t for t in crossed.tolist() if any(a < t < b for a, b in spans)]
    return np.unique(np.concatenate([at_ends, inside]))
