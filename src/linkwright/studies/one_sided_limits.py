"""Both sides of what may make curves of many samples jump: extremes may lie right there, or between it and the next
place of a shared grid."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Node
from linkwright.results.batch_run import Bunch, Who
from linkwright.results.batch_windows import Spans
from linkwright.results.discontinuities import ASIDE
from linkwright.results.stationary import NOISE, bracketed

Array = NDArray[np.float64]
Candidates = tuple[Who, Array, Array]
"""Samples, times (s) and values."""

APART = 3 * ASIDE[0]
"""Sides that are no further apart, over the run's length, have no bracket between them."""


@dataclass(frozen=True, eq=False)
class Sides:
    """Places of samples, ascending, among the ends of the grid's cells that they lie in: sample, time (s), the place of
    the grid that it is or -1, and whether a bracket goes on to the next one."""

    who: Who
    t: Array
    place: Who
    open: NDArray[np.bool_]

    def candidates(self, bunch: Bunch, curves: Sequence[Node]) -> dict[Node, Candidates]:
        """Those among which the extremes of curves are."""
        own, found = self.place < 0, {}
        who, t = self.who[own], self.t[own]
        for curve, beside in zip(curves, bunch.all_rates(curves, who, t), strict=True):
            grid = bunch.on_grid(curve)
            value, rate = (row[self.who, self.place] for row in grid)
            value[own], rate[own] = beside
            clear = np.abs(rate) > NOISE * np.abs(grid[1]).max(axis=1)[self.who]
            turns = np.flatnonzero(self.open[:-1] & clear[:-1] & clear[1:] & ((rate[:-1] > 0) != (rate[1:] > 0)))
            inner = self.who[turns], _roots(bunch, curve, self.who[turns], self.t[turns], self.t[turns + 1])
            found[curve] = (
                np.concatenate([who, inner[0]]),
                np.concatenate([t, inner[1]]),
                np.concatenate([value[own], bunch.values(curve, *inner)]),
            )
        return found


def _roots(bunch: Bunch, curve: Node, who: Who, low: Array, high: Array) -> Array:
    """Where a curve turns in brackets."""
    return bracketed(lambda t, row: bunch.rates(curve, row, t)[1], who, low, high) if who.size else low


def sides(bunch: Bunch, nodes: Sequence[Node], gaps: Spans | None) -> Sides | None:
    """Those of the zeros of some expressions and of ``gaps``, and right inside the ends of the runs; ``None`` without
    the former."""
    found = [] if gaps is None else [gaps.flat()]
    aside = ASIDE[0] * bunch.length
    for node in nodes:
        who, t = bunch.crossings(node)
        found.append((who, t - aside[who], t + aside[who]))
    if not any(part[0].size for part in found):
        return None
    found.append((np.arange(bunch.samples), bunch.start + aside, bunch.stop - aside))
    who = np.concatenate([part[0] for part in found] * 2)
    t = np.concatenate([*(part[1] for part in found), *(part[2] for part in found)])
    t = np.clip(t, bunch.start, bunch.stop[who])
    cell = np.clip((t - bunch.start) / bunch.length[who] * bunch.steps, 0, bunch.steps - 1).astype(np.intp)
    whose, which = np.divmod(np.unique(who * bunch.steps + cell), np.intp(bunch.steps))
    place = np.concatenate([np.full(who.size, -1, dtype=np.intp), which, which + 1])
    cell = np.concatenate([cell, which, which])
    t = np.concatenate([t, bunch.t[whose, which], bunch.t[whose, which + 1]])
    who = np.concatenate([who, whose, whose])
    order = np.lexsort((t, cell, who))
    who, t, cell, place = who[order], t[order], cell[order], place[order]
    goes = (who[1:] == who[:-1]) & (cell[1:] == cell[:-1]) & (t[1:] - t[:-1] > APART * bunch.length[who[1:]])
    return Sides(who, t, place, np.append(goes, False))
