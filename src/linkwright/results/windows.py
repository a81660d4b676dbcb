"""Windows: the parts of a run that a measure looks at or a load acts in, in time or in the value of a signal."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Node
from linkwright.model.bound_window import BoundWindow
from linkwright.results.stationary import crossings

if TYPE_CHECKING:
    from linkwright.results.run import Run

Array = NDArray[np.float64]
Who = NDArray[np.intp]
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
        return crossings(lambda t: passed(value(t), edge, turning), run.start, run.stop, run.grid)

    t, ends = np.concatenate([[run.start, run.stop], beyond(low), beyond(high)]), (np.full(1, low), np.full(1, high))
    _, begins, stops = stretches_inside(lambda _, t: value(t), np.zeros(t.size, dtype=np.intp), t, *ends, turning)
    return list(zip(begins.tolist(), stops.tolist(), strict=True))


def passed(values: Array, edge: Array | float, turning: bool) -> Array:
    """What changes its sign where values pass an edge; of an angle, that or any whole turns from it."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.sin((values - edge) / 2) if turning else values - edge)


def stretches_inside(
    value: Callable[[Who, Array], Array], who: Who, t: Array, low: Array, high: Array, turning: bool
) -> tuple[Who, Array, Array]:
    """Sample, start and end (s) of all stretches, ascending, on which a value lies in ``low`` .. ``high`` (samples,).
    Between neighbouring times ``t`` (n,) of a sample of ``who`` (n,), which has its ends among them, it passes no edge.
    """
    order = np.lexsort((t, who))
    who, t = who[order], t[order]
    between = (who[1:] == who[:-1]) & (t[1:] > t[:-1])
    who, a, b = who[1:][between], t[:-1][between], t[1:][between]
    # The middle of each piece decides for the whole of it.
    middles = value(who, (a + b) / 2)
    offset = np.mod(middles - low[who], 2 * np.pi) if turning else middles - low[who]
    inside = (offset >= 0) & (offset <= high[who] - low[who])
    who, a, b = who[inside], a[inside], b[inside]
    # Neighbouring pieces inside are one stretch.
    apart = (who[1:] != who[:-1]) | (a[1:] != b[:-1])
    begins, ends = np.append(True, apart)[: who.size], np.append(apart, True)[: who.size]
    return who[begins], a[begins], b[ends]


def passing(run: Run, node: Node, spans: list[Interval], turning: bool) -> Array:
    """The times (s) in some intervals at which an expression is zero, ascending; with ``turning`` also any whole turns
    from it."""

    def value(t: Array) -> Array:
        return passed(np.asarray(run.jets(node, t).d[0]), 0.0, turning)

    ends = np.array([edge for span in spans for edge in span])
    size = float(np.abs(value(np.linspace(run.start, run.stop, 65))).max(initial=0.0))
    at_ends = ends[np.abs(value(ends)) <= 1e-12 * max(size, 1.0 if turning else 0.0)]
    crossed = crossings(value, run.start, run.stop, run.grid)
    inside = [t for t in crossed.tolist() if any(a < t < b for a, b in spans)]
    return np.unique(np.concatenate([at_ends, inside]))
