"""How long a signal dwells: the longest time in which it stays within a band."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Stretch = tuple[float, float]

LEVELS, ZOOMS = 33, 8


@dataclass
class Course:
    """A signal between its turning points: ``turning`` (s, ascending, both ends included), monotone in between."""

    value: Callable[[Array], Array]
    turning: Array

    @cached_property
    def heights(self) -> Array:
        return self.value(self.turning)

    def longest(self, width: float) -> Stretch:
        """The longest stretch of time (s) in which the signal varies by ``width`` at most; the first of equals.

        Where it is longest, its band begins or ends at a turning point or an end of the run inside the stretch, or
        the signal passes through the band, as fast where it leaves as where it came in.
        """
        found = [*self._around(width), *self._passing(width)]
        most = max(b - a for a, b in found)
        return min(stretch for stretch in found if stretch[1] - stretch[0] >= most * (1 - 1e-9))

    def _around(self, width: float) -> list[Stretch]:
        """The stretches whose band begins or ends at a turning point."""
        y, last = self.heights, self.turning.size - 1
        exits = []
        for i in range(last + 1):
            top = y[i] > y[i + 1] if i < last else y[i] > y[i - 1]
            low, high = (y[i] - width, y[i]) if top else (y[i], y[i] + width)
            exits += [self._exit(i, step, low, high) for step in (-1, 1)]
        times = self._when(*(np.array(column) for column in zip(*exits, strict=True)))
        return list(zip(times[::2].tolist(), times[1::2].tolist(), strict=True))

    def _exit(self, i: int, step: int, low: float, high: float) -> tuple[int, float]:
        """From the turning point i on, the piece on which the signal leaves the band, and the level there."""
        y, slack = self.heights, 1e-13 * float(np.abs(self.heights).max())
        while 0 <= i + step < y.size and low - slack <= y[i + step] <= high + slack:
            i += step
        if not 0 <= i + step < y.size:
            return min(i, y.size - 2), np.inf * step  # the run ends first
        return min(i, i + step), low if y[i + step] < low else high

    def _passing(self, width: float) -> list[Stretch]:
        """The longest stretch of each way through a band of which neither edge is a turning point inside."""
        found: list[Stretch] = []
        for sign in (1.0, -1.0):
            ways = np.array(list(self._ways(sign * self.heights, width))).reshape(-1, 4)
            if not ways.size:
                continue
            first, last = ways[:, :2].astype(int).T
            low, high = ways[:, 2], ways[:, 3]
            for _ in range(ZOOMS):
                levels = np.linspace(low, high, LEVELS, axis=1)
                came = self._when(np.repeat(first, LEVELS), sign * levels.ravel()).reshape(levels.shape)
                left = self._when(np.repeat(last, LEVELS), sign * (levels + width).ravel()).reshape(levels.shape)
                best, rows = (left - came).argmax(axis=1), np.arange(first.size)
                low, high = levels[rows, np.maximum(best - 1, 0)], levels[rows, np.minimum(best + 1, LEVELS - 1)]
            found += zip(came[rows, best].tolist(), left[rows, best].tolist(), strict=True)
        return found

    def _ways(self, y: Array, width: float) -> list[tuple[float, ...]]:
        """Pairs of rising pieces between which the signal can stay in a band, with the range of its lower edge."""
        ways: list[tuple[float, ...]] = []
        for i in np.flatnonzero(y[:-1] < y[1:]):
            least, most = np.inf, -np.inf
            for j in range(int(i), y.size - 1):
                if j > i:
                    least, most = min(least, y[j]), max(most, y[j])
                if most - least > width:
                    break
                low, high = max(y[i], y[j] - width, most - width), min(y[i + 1], y[j + 1] - width, least)
                if y[j] < y[j + 1] and low < high:
                    ways.append((float(i), j, low, high))
        return ways

    def _when(self, piece: Array, level: Array) -> Array:
        """The times (s) at which the signal has some levels, each on a stated piece; its ends for -inf and inf."""
        from scipy.optimize.elementwise import find_root

        ends, y = (np.stack([v[piece], v[piece + 1]]) for v in (self.turning, self.heights))
        outside = np.isinf(level)
        beyond = np.where(level > 0, ends[1], ends[0])
        level = np.clip(level, y.min(axis=0), y.max(axis=0))
        found = find_root(lambda t, wanted: self.value(t) - wanted, tuple(ends), args=(level,))
        # A level that is that of an end but for round-off has no bracket.
        end = ends[np.abs(y - level).argmin(axis=0), np.arange(level.size)]
        return np.asarray(np.where(outside, beyond, np.where(found.success, found.x, end)))
