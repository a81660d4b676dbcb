"""Turning points and zeros of functions of time between places at which they need not be continuous.

Exact rates are evaluated on a grid; a change of their sign between two points of one piece brackets a turning point.
The grid is doubled until the number of brackets, or the extremes, stay the same. Further times (near singular poses, on
both sides of places) belong to the grid at every level.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.results.stationary import STILL, Rows, roots

Array = NDArray[np.float64]
Rates = Callable[[Array], tuple[Array, Array]]
"""Values and rates of rows at times: (rows, times) each."""

FIRST_STEPS, MAX_STEPS = 1 << 8, 1 << 15
FINEST = 1 << 18
"""The finest grid of runs that need a fine one from the start."""
GAIN = 1e-15
"""A rate counts where over the width around it it makes more than this share of the value there ..."""
USUAL = 0.9
"""... or of the magnitude below which this share of the values lies."""
MANY = 1 << 12
"""Of a row whose turning points have not settled on the finest grid no more than so many are located: the highest and
the lowest."""
SETTLED = 1e-12
"""Extremes that change by less than this share of the range have stood still."""
INSIDE = np.array([0.05, 0.25, 0.5, 0.75, 0.95])
"""Where each piece is looked at besides, as shares of it."""


@dataclass(frozen=True)
class RunPieces:
    """A run ``start`` .. ``stop`` (s) cut at places; ``before`` and ``after`` are the sides of the cuts, ascending.

    ``more`` are further times to look at.
    """

    start: float
    stop: float
    before: Array
    after: Array
    more: Array

    def grid(self, steps: int) -> Array:
        """Equal steps, the further times, the sides, and a few times inside each piece, however short it is."""
        # A few interior times for each piece between two cuts, so that short pieces are not missed by the equal
        # steps.
        lows, highs = np.append(self.start, self.after), np.append(self.before, self.stop)
        inner = lows[:, None] + np.maximum(highs - lows, 0.0)[:, None] * INSIDE
        t = np.union1d(np.linspace(self.start, self.stop, steps + 1), np.concatenate([self.more, inner.ravel()]))
        # Remove times inside the gap of a cut, between its last time before and its first time after.
        i = np.searchsorted(self.after, t)
        last = np.minimum(i, self.after.size - 1)
        if self.after.size:
            t = t[(i == self.after.size) | (t <= self.before[last])]
        t = np.union1d(t, np.concatenate([self.before, self.after]))
        return t[(t >= self.start) & (t <= self.stop)]

    def number(self, t: Array) -> Rows:
        """The piece to which each time belongs."""
        return np.searchsorted(self.after, t, side="right")


@dataclass(frozen=True)
class TurningTimes:
    """The times (s, ascending) at which each row turns, whether its search has stood still, and the width (s) of the
    steps on which it ended."""

    times: list[Array]
    settled: list[bool]
    width: float


def turning(rates: Rates, pieces: RunPieces, steps: int, still: Array | float = 0.0) -> TurningTimes:
    """The turning points of rows between the cuts.

    ``still`` (rows,) is a size to which round-off is compared where a row is smaller itself.
    """
    steps, most = _first(steps)
    counts: list[list[int]] = []
    levels: list[list[Array]] = []
    while True:
        # Look on this grid for sign changes of the rate; keep the brackets of the last two grids.
        t = pieces.grid(steps)
        levels = [*levels[-1:], _turns(t, *rates(t), pieces.number(t), still)]
        counts.append([len(found) for found in levels[-1]])
        # A row has settled when its number of brackets stayed the same on three grids.
        standing = [len(counts) > 2 and len({c[row] for c in counts[-3:]}) == 1 for row in range(len(counts[0]))]
        if all(standing) or steps >= most:
            break
        steps *= 2
    # Rows that never settle, such as oscillations near a singular pose, keep their highest and lowest brackets only.
    levels = [
        [b if s else _outermost(rates, row, b) for row, (b, s) in enumerate(zip(level, standing, strict=True))]
        for level in levels
    ]
    # Locate the turning points by root finding on the exact rates.
    times = roots(lambda at: rates(at)[1], levels[-1])
    # A row with unstable counts is accepted after all if the extremes of the last two grids agree.
    if not all(standing):
        before = roots(lambda at: rates(at)[1], levels[0])
        standing = [s or _same(rates, row, before[row], times[row]) for row, s in enumerate(standing)]
    return TurningTimes(times, standing, (pieces.stop - pieces.start) / steps)


def zeros(rates: Rates, pieces: RunPieces, turning_points: TurningTimes, steps: int) -> list[Array]:
    """The zeros of each row at which it changes sign, from its turning points: between two of them there is one at
    most."""
    found = []
    grid = pieces.grid(_first(steps)[0])
    # Between two neighbouring turning points a row is monotone, so it has at most one zero there.
    t = np.union1d(grid, np.concatenate([*turning_points.times, grid[:0]]))
    values, number = rates(t)[0], pieces.number(t)
    exact = []
    for row in values:
        known = ~np.isnan(row) & (row != 0)
        at, sign, piece = t[known], np.sign(row[known]), number[known]
        change = np.flatnonzero((sign[:-1] != sign[1:]) & (piece[:-1] == piece[1:]))
        found.append(np.stack([at[change], at[change + 1]], axis=1))
        # Values that are exactly zero are zeros themselves, unless the row is zero nearly everywhere.
        exact.append(t[row == 0] if np.count_nonzero(row == 0) <= row.size // 2 else t[:0])
    crossed = roots(lambda at: rates(at)[0], found)
    return [np.union1d(r, e) if e.size else r for r, e in zip(crossed, exact, strict=True)]


def _first(steps: int) -> tuple[int, int]:
    first = min(max(steps, FIRST_STEPS), FINEST // 4)
    return first, max(MAX_STEPS, 4 * first)


def _turns(t: Array, values: Array, slopes: Array, number: Rows, still: Array | float) -> list[Array]:
    """Brackets (n, 2) in which each row's rate clearly changes sign inside one piece."""
    width = np.gradient(t) if t.size > 1 else np.ones(1)
    floors = np.broadcast_to(still, len(values))
    found = []
    for value, slope, floor in zip(values, slopes, floors, strict=True):
        known = np.isfinite(value) & np.isfinite(slope)
        at, size, rate, piece = t[known], np.abs(value[known]), slope[known], number[known]
        # Skip rows that only vary by round-off.
        if not at.size or not np.abs(rate).max() * (t[-1] - t[0]) > STILL * max(size.max(), floor):
            found.append(np.empty((0, 2)))
            continue
        # A rate has a reliable sign only if it changes the value by more than round-off over the local step.
        usual = max(float(np.quantile(size, USUAL)), floor)
        clear = np.abs(rate) * width[known] > GAIN * np.maximum(size, usual)
        at, sign, piece = at[clear], np.sign(rate[clear]), piece[clear]
        # A sign change counts only between neighbours in the same piece, not across a cut.
        change = np.flatnonzero((sign[:-1] != sign[1:]) & (piece[:-1] == piece[1:]))
        found.append(np.stack([at[change], at[change + 1]], axis=1))
    return found


def _outermost(rates: Rates, row: int, brackets: Array) -> Array:
    """The :data:`MANY` brackets in which a row is highest and lowest; all of them where they are fewer."""
    if len(brackets) <= MANY:
        return brackets
    order = np.argsort(rates(brackets.mean(axis=1))[0][row])
    return np.asarray(brackets[np.sort(np.concatenate([order[: MANY // 2], order[-MANY // 2 :]]))])


def _same(rates: Rates, row: int, before: Array, now: Array) -> bool:
    """Whether turning points of two levels have the same extremes."""
    if not before.size or not now.size:
        return not before.size and not now.size
    ends = []
    for times in (before, now):
        value = rates(times)[0][row]
        ends.append((float(np.nanmin(value)), float(np.nanmax(value))))
    (a, b), (c, d) = ends
    return max(abs(a - c), abs(b - d)) <= SETTLED * max(abs(c), abs(d))
