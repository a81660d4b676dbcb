"""Means of curves of many samples, by Gauss quadrature between their corners.

Not one with that of a single run (:mod:`linkwright.measures.means`), which halves each panel until it stands and takes
what lies beside poles from series: here all samples share the panels that the nominal run needs, so that a sample's
mean doesn't depend on the others to the last bit.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Call, Node, nodes
from linkwright.results.batch_run import Bunch, What, Who
from linkwright.results.batch_windows import Spans, each
from linkwright.results.discontinuities import switches
from linkwright.results.quadrature import panel_points
from linkwright.results.stationary import turns

Array = NDArray[np.float64]
Corners = tuple[Who, Array]

FIRST_PANELS, MOST_PANELS = 16, 1 << 10
CLOSE = 1e-12
"""How near two means on panels of which one has twice as many are to be, over the mean magnitude."""


def corners(bunch: Bunch, what: Node, others: Sequence[Node]) -> Corners:
    """Where a curve may have a kink: zeros of what makes one, and of ``others``; turning points where a root does."""
    found = [bunch.crossings(node) for node in dict.fromkeys([*_switches(what), *others])]
    if any(isinstance(node, Call) and node.name in ("hypot", "sqrt") for node in nodes(what)):
        found.append(bunch.turning(what, turns(*bunch.on_grid(what), bunch.length)))
    if not found:
        return np.empty(0, dtype=np.intp), np.empty(0)
    who, t = (np.concatenate(part) for part in zip(*found, strict=True))
    return who, t


def _switches(what: Node) -> Iterator[Node]:
    return (switch for node in nodes(what) for switch in switches(node))


def mean(bunch: Bunch, what: What, spans: Spans, power: int, panels: int, kinks: Corners) -> tuple[Array, Array]:
    """The mean of a power of a curve over its spans on ``panels`` panels a run, and that of its magnitude: (samples,)
    each, NaN without a span."""
    owner, a, b = spans.flat()
    counts = np.maximum(4, np.ceil(panels * (b - a) / bunch.length[owner])).astype(int)
    which = np.repeat(np.arange(owner.size), counts + 1)
    k = np.arange(which.size) - np.repeat(np.cumsum(counts + 1) - counts - 1, counts + 1)
    t = np.where(k == counts[which], b[which], a[which] + (b - a)[which] * (k / counts[which]))
    for span, at in _inside(owner, a, b, kinks, bunch.samples):
        which, t = np.append(which, span), np.append(t, at)
    order = np.lexsort((t, which))
    which, t = which[order], t[order]
    panel = which[1:] == which[:-1]
    times, weights = panel_points(t[:-1][panel], t[1:][panel])
    who = owner[which[1:][panel]]
    shares = (bunch.values(what, np.repeat(who, 8), times) ** power * weights).reshape(-1, 8)
    length = np.bincount(owner, b - a, bunch.samples)
    with np.errstate(invalid="ignore"):
        total, size = (np.bincount(who, part.sum(axis=1), bunch.samples) / length for part in (shares, np.abs(shares)))
    return total, size


def _inside(owner: Who, a: Array, b: Array, kinks: Corners, samples: int) -> Iterator[tuple[Who, Array]]:
    """The corners inside spans, with their spans: those of each sample's first span, then of the second, and so on."""
    who, t = kinks
    for some, span in each(owner, who, samples):
        at = t[some]
        inner = (at > a[span]) & (at < b[span])
        yield span[inner], at[inner]
