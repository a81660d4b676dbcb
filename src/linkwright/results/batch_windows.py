"""Windows of many samples at once: the parts of each one's run that they mean."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Node
from linkwright.graph.rows import WindowRow
from linkwright.model.bound_window import BoundWindow
from linkwright.results.batch_run import Bunch, Who
from linkwright.results.discontinuities import sides
from linkwright.results.windows import passed, stretches_inside

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Spans:
    """Intervals of time (s) of samples, ascending: ``low`` and ``high`` (samples, most), NaN where there are fewer."""

    low: Array
    high: Array

    def flat(self) -> tuple[Who, Array, Array]:
        """All intervals one after another: sample, start, end."""
        who, which = np.nonzero(np.isfinite(self.low))
        return who, self.low[who, which], self.high[who, which]

    def grid(self, t: Array) -> Mask:
        """Which times (samples, times) lie in an interval or at its end."""
        found = np.zeros(t.shape, dtype=bool)
        for low, high in zip(self.low.T, self.high.T, strict=True):
            found |= (t >= low[:, None]) & (t <= high[:, None])
        return found

    def within(self, who: Who, t: Array) -> Mask:
        """Which times of some samples (n,) lie inside an interval."""
        t = t[:, None]
        return np.asarray(((t > self.low[who]) & (t < self.high[who])).any(axis=1))

    def touched(self, who: Who, a: Array, b: Array) -> Mask:
        """Which stretches a .. b of some samples (n,) have a part inside an interval."""
        a, b = a[:, None], b[:, None]
        return np.asarray(((b > self.low[who]) & (a < self.high[who])).any(axis=1))

    @property
    def first(self) -> Array:
        """Where the first interval begins (s), NaN without one."""
        return self.low[:, 0] if self.low.size else np.full(len(self.low), np.nan)

    @property
    def last(self) -> Array:
        """Where the last interval ends (s), NaN without one."""
        if not self.high.size:
            return np.full(len(self.high), np.nan)
        return np.asarray(np.fmax.reduce(self.high, axis=1))


class Windows:
    """What windows mean in a bunch of samples; with ``jumps`` without the moments at which a load jumps."""

    def __init__(self, bunch: Bunch, jumps: bool) -> None:
        self.bunch = bunch
        self.gaps = gaps(bunch) if jumps else None
        self._known: dict[BoundWindow | None, Spans] = {}

    def __getitem__(self, window: BoundWindow | None) -> Spans:
        if window not in self._known:
            found = spans(self.bunch, window)
            self._known[window] = found if self.gaps is None else without(found, self.gaps)
        return self._known[window]


def gaps(bunch: Bunch) -> Spans:
    """From right before to right after each jump of a load, at an end of the window in which it acts."""
    every, actions = np.arange(bunch.samples), bunch.run.compiled.graph.actions
    parts = list[tuple[Who, Array, Array]]()
    for name in actions.windows:
        owner, a, b = spans(bunch, bunch.quantities.window(name)).flat()
        who = np.concatenate([owner, owner, every, every])
        t = np.concatenate([a, b, np.full(bunch.samples, bunch.start), bunch.stop])
        parts += sides(partial(bunch.values, WindowRow(name)), who, t, bunch.start, bunch.stop)
    for node in actions.jumps:
        parts += sides(partial(bunch.values, node), *bunch.crossings(node), bunch.start, bunch.stop)
    who, before, after = (np.concatenate(part) for part in zip(*parts, strict=True))
    order = np.lexsort((before, who))
    return _packed(who[order], before[order], after[order], bunch.samples)


def without(some: Spans, gaps: Spans) -> Spans:
    """Intervals less the gaps in them."""
    samples = len(some.low)
    owner, a, b = some.flat()
    who, before, after = gaps.flat()
    which, low, high = np.arange(owner.size), a, b
    for own, span in each(owner, who, samples):
        own, span = (part[(after[own] > a[span]) & (before[own] < b[span])] for part in (own, span))
        which, low, high = (
            np.append(whole, part)
            for whole, part in (
                (which, span),
                (low, np.minimum(after[own], b[span])),
                (high, np.maximum(before[own], a[span])),
            )
        )
    # The parts of an interval begin at its start and behind each gap, and end before each gap and at its end.
    starts, ends = np.lexsort((low, which)), np.lexsort((high, which))
    whose, low, high = owner[which[starts]], low[starts], high[ends]
    left = low < high
    return _packed(whose[left], low[left], high[left], samples)


def each(owner: Who, who: Who, samples: int) -> Iterator[tuple[Who, Who]]:
    """Pairs of things of samples ``who`` with the intervals of these (``owner``, ascending), as indices into both:
    those with the first interval of a sample, then with the second, and so on."""
    counts = np.bincount(owner, minlength=samples)
    first = np.cumsum(counts) - counts
    for k in range(int(counts.max(initial=0)) if who.size else 0):
        some = np.flatnonzero(counts[who] > k)
        yield some, first[who[some]] + k


def spans(bunch: Bunch, window: BoundWindow | None) -> Spans:
    """The intervals that a window means within each sample's run; the whole run without one."""
    start, stop = np.full(bunch.samples, bunch.start), bunch.stop
    if window is None:
        return _packed(np.arange(bunch.samples), start, stop, bunch.samples)
    edges = [bunch.quantities.value(end, window.dimension) for end in window.ends]
    if window.node is None:
        low, high = np.maximum(edges[0], start), np.minimum(edges[1], stop)
        who = np.flatnonzero(low < high)
        return _packed(who, low[who], high[who], bunch.samples)
    low, high = (np.broadcast_to(edge, bunch.samples) for edge in edges)
    return _within(bunch, window.node, low, high, window.turning)


def _within(bunch: Bunch, node: Node, low: Array, high: Array, turning: bool) -> Spans:
    """Where an expression lies in low .. high (samples,); of an angle, in that range or any whole turns from it."""

    def beyond(edge: Array) -> tuple[Who, Array]:
        return bunch.crossings(
            node, lambda values, who: passed(values, edge[:, None] if who is None else edge[who], turning)
        )

    every = np.arange(bunch.samples)
    parts = [(every, np.full(bunch.samples, bunch.start)), (every, bunch.stop), beyond(low), beyond(high)]
    who, t = (np.concatenate(part) for part in zip(*parts, strict=True))
    return _packed(*stretches_inside(partial(bunch.values, node), who, t, low, high, turning), bunch.samples)


def _packed(who: Who, low: Array, high: Array, samples: int) -> Spans:
    """Intervals, ascending by sample and time, as one row of each sample."""
    counts = np.bincount(who, minlength=samples)
    which = np.arange(who.size) - np.repeat(np.cumsum(counts) - counts, counts)
    ends = np.full((2, samples, int(counts.max(initial=0))), np.nan)
    ends[0, who, which], ends[1, who, which] = low, high
    return Spans(*ends)
