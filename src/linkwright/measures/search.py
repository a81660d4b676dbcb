"""Turning points and zeros of functions of time between places at which they need not be continuous.

Exact rates are evaluated on a grid; a change of their sign between two points of one piece brackets a turning point.
The grid is doubled until the number of brackets, or the extremes, stay the same. Further times (near singular poses, on
both sides of places) belong to the grid at every level. Rows are evaluated together, yet each is looked at on a grid of
its own and ends on a level of its own, so that what is found of one doesn't depend on the others.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import field

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
    """The times (s, ascending) at which each row turns, whether its search has stood still, the width (s) of the steps
    on which it ended, and the times (s) of its smallest and its largest value on its grid."""

    times: list[Array]
    settled: list[bool]
    widths: list[float]
    outermost: list[Array]


@dataclass
class _RowSearch:
    """The search of one row: the counts of its brackets by level, the brackets of its last two grids."""

    counts: list[int] = field(default_factory=list)
    levels: list[Array] = field(default_factory=list)
    steps: int = 0
    outermost: Array = field(default_factory=lambda: np.empty(0))

    @property
    def stands(self) -> bool:
        """Whether the count has stayed the same on three grids."""
        return len(self.counts) > 2 and len({*self.counts[-3:]}) == 1


def turning(
    rates: Rates, pieces: Sequence[RunPieces], steps: int, still: Array | float = 0.0, skip: Sequence[bool] = ()
) -> TurningTimes:
    """The turning points of rows between the cuts, each row with its own ``pieces``.

    ``still`` (rows,) is a size to which round-off is compared where a row is smaller itself; rows to ``skip`` have
    none.
    """
    steps, most = _first(steps)
    floors = np.broadcast_to(still, len(pieces))
    rows = [_RowSearch() for _ in pieces]
    left = [row for row in range(len(rows)) if not (skip and skip[row])]
    while left:
        # Evaluate all rows on the union of their grids; each is looked at on its own grid alone.
        grids = {id(one): one.grid(steps) for one in (pieces[row] for row in left)}
        t = np.unique(np.concatenate([*grids.values()]))
        values, slopes = rates(t)
        for row in left:
            grid, one = grids[id(pieces[row])], rows[row]
            at = np.searchsorted(t, grid)
            brackets = _turns(grid, values[row, at], slopes[row, at], pieces[row].number(grid), floors[row])
            one.levels, one.steps = [*one.levels[-1:], brackets], steps
            one.counts.append(len(brackets))
            one.outermost = _outermost_times(grid, values[row, at])
        # A row has settled when its number of brackets stayed the same on three grids.
        left = [row for row in left if not rows[row].stands]
        if steps >= most:
            break
        steps *= 2
    # Rows that never settle, such as oscillations near a singular pose, keep their highest and lowest brackets only.
    for row in left:
        rows[row].levels = [_outermost(rates, row, level) for level in rows[row].levels]
    # Locate the turning points by root finding on the exact rates.
    none = np.empty((0, 2))
    times = roots(lambda at: rates(at)[1], [one.levels[-1] if one.levels else none for one in rows])
    # A row with unstable counts is accepted after all if the extremes of the last two grids agree.
    standing = [row not in left for row in range(len(rows))]
    if left:
        before = roots(lambda at: rates(at)[1], [rows[r].levels[0] if r in left else none for r in range(len(rows))])
        for row in left:
            standing[row] = _same(rates, row, before[row], times[row])
    length = pieces[0].stop - pieces[0].start if pieces else 0.0
    widths = [length / max(one.steps, 1) for one in rows]
    return TurningTimes(times, standing, widths, [one.outermost for one in rows])


def zeros(
    rates: Rates,
    pieces: Sequence[RunPieces],
    turning_points: TurningTimes,
    steps: int,
    clear: Callable[[int, Array], NDArray[np.bool_]],
) -> list[Array]:
    """The zeros of each row at which it changes sign, from its turning points: between two of them there is one at
    most. ``clear(row, t)`` tells at which times a row's sign is more than round-off: the others have none."""
    brackets, exact = [], []
    grids = [one.grid(_first(steps)[0]) for one in pieces]
    # Between two neighbouring turning points a row is monotone, so it has at most one zero there.
    own = [np.union1d(grid, times) for grid, times in zip(grids, turning_points.times, strict=True)]
    every = np.unique(np.concatenate([*own, np.empty(0)]))
    values = rates(every)[0] if every.size else np.empty((len(pieces), 0))
    for row, t in enumerate(own):
        value, number = values[row, np.searchsorted(every, t)], pieces[row].number(t)
        known = ~np.isnan(value) & (value != 0)
        sign = np.where(known, np.sign(value), 0.0)
        # Look closely at signs only where one changes: is it more than round-off on both sides?
        known &= _clear(clear, row, t, sign)
        at, sign, piece = t[known], sign[known], number[known]
        change = np.flatnonzero((sign[:-1] != sign[1:]) & (piece[:-1] == piece[1:]))
        brackets.append(np.stack([at[change], at[change + 1]], axis=1))
        # Values that are exactly zero are zeros themselves, unless the row stays zero beside them.
        zero = np.concatenate([[False], value == 0, [False]])
        exact.append(t[zero[1:-1] & ~zero[:-2] & ~zero[2:]])
    crossed = roots(lambda at: rates(at)[0], brackets)
    return [np.union1d(r, e) if e.size else r for r, e in zip(crossed, exact, strict=True)]


def _clear(clear: Callable[[int, Array], NDArray[np.bool_]], row: int, t: Array, sign: Array) -> NDArray[np.bool_]:
    """Which signs of a row count: all, but near changes those alone that are more than round-off."""
    near = np.zeros(t.size, dtype=bool)
    changed = np.flatnonzero(sign[:-1] != sign[1:])
    for beside in range(-2, 4):
        near[np.clip(changed + beside, 0, max(t.size - 1, 0))] = True
    counts = np.ones(t.size, dtype=bool)
    if near.any():
        counts[near] = clear(row, t[near])
    return counts


def _first(steps: int) -> tuple[int, int]:
    first = min(max(steps, FIRST_STEPS), FINEST // 4)
    return first, max(MAX_STEPS, 4 * first)


def _turns(t: Array, value: Array, slope: Array, number: Rows, floor: float) -> Array:
    """Brackets (n, 2) in which a row's rate clearly changes sign inside one piece."""
    width = np.gradient(t) if t.size > 1 else np.ones(1)
    known = np.isfinite(value) & np.isfinite(slope)
    at, size, rate, piece = t[known], np.abs(value[known]), slope[known], number[known]
    # Skip rows that only vary by round-off.
    if not at.size or not np.abs(rate).max() * (t[-1] - t[0]) > STILL * max(size.max(), floor):
        return np.empty((0, 2))
    # A rate has a reliable sign only if it changes the value by more than round-off over the local step.
    usual = max(float(np.quantile(size, USUAL)), floor)
    clear = np.abs(rate) * width[known] > GAIN * np.maximum(size, usual)
    at, sign, piece = at[clear], np.sign(rate[clear]), piece[clear]
    # A sign change counts only between neighbours in the same piece, not across a cut.
    change = np.flatnonzero((sign[:-1] != sign[1:]) & (piece[:-1] == piece[1:]))
    return np.stack([at[change], at[change + 1]], axis=1)


def _outermost_times(t: Array, value: Array) -> Array:
    """The times of the smallest and of the largest finite value."""
    known = np.flatnonzero(np.isfinite(value))
    return t[known[[np.argmin(value[known]), np.argmax(value[known])]]] if known.size else t[:0]


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
