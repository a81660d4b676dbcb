"""Count, mean, deviation and extremes of each output at each pose, over samples.

Inside an atom: sums of d and d^2, d = y - shift, the shift being the first finite value (Chan, Golub, LeVeque,
"Algorithms for computing the sample variance", The American Statistician 37 (1983) 242-247, sec. 3). As the shift is
one of the n values, (shift - mean)^2 is at most n times the variance, which bounds what the difference
sum(d^2) - sum(d)^2/n can lose. Between atoms: their pairwise formula (2.1), with the mean kept as shift + offset, so
that the difference of two means keeps its digits where deviations are far below the mean.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks import moments_code
from linkwright.blocks.reductions import Array
from linkwright.blocks.work import Arrays
from linkwright.data_classes import dataclass

STRIP = 1 << 15
"""Values of a strip: its temporaries stay in the cache."""


@dataclass(frozen=True)
class Moments:
    """Count, mean, deviation and extremes over samples; ``fast`` takes the compiled twin, to the same bits.

    Figures, each (outputs, poses): ``count`` of finite values and of those ``missing``; ``mean``; ``deviation``, of the
    sample (n - 1); ``least`` and ``largest`` with the number of the first sample that has them, ``least_at`` and
    ``largest_at`` (-1 for none). NaN stands where no (for the deviation: less than two) finite values are.
    """

    fast: bool = False

    def tally(self, outputs: int, poses: int) -> MomentsTally:
        """A fresh tally."""
        return MomentsTally(outputs, poses, self.fast)

    def fold(self, state: Arrays, later: Arrays) -> Arrays:
        """The state of both."""
        a, b = state, later
        count = a["count"] + b["count"]
        n = np.maximum(count, 1)
        shift = np.where(a["count"] > 0, a["shift"], b["shift"])
        before = np.where(a["count"] > 0, a["offset"], b["offset"])
        delta = np.where((a["count"] > 0) & (b["count"] > 0), (b["shift"] - shift) + (b["offset"] - before), 0.0)
        folded: Arrays = {
            "count": count,
            "missing": a["missing"] + b["missing"],
            "shift": shift,
            "offset": before + delta * (b["count"] / n),
            "squares": a["squares"] + b["squares"] + delta * delta * (a["count"] / n) * b["count"],
        }
        for key, better in (("least", b["least"] < a["least"]), ("largest", b["largest"] > a["largest"])):
            folded[key] = np.where(better, b[key], a[key])
            folded[f"{key}_at"] = np.where(better, b[f"{key}_at"], a[f"{key}_at"])
        return folded

    def result(self, state: Arrays) -> Arrays:
        """The figures."""
        count = state["count"]
        some = count > 0
        variance = state["squares"] / np.maximum(count - 1, 1)
        return {
            "count": count,
            "missing": state["missing"],
            "mean": np.where(some, state["shift"] + state["offset"], np.nan),
            "deviation": np.where(count > 1, np.sqrt(variance), np.nan),
            "least": np.where(some, state["least"], np.nan),
            "least_at": state["least_at"],
            "largest": np.where(some, state["largest"], np.nan),
            "largest_at": state["largest_at"],
        }


class MomentsTally:
    """Sums over the samples of one atom: strictly sample after sample, each pose on its own."""

    def __init__(self, outputs: int, poses: int, fast: bool) -> None:
        shape = (outputs, poses)
        self.count, self.missing = np.zeros(shape, np.int64), np.zeros(shape, np.int64)
        self.shift, self.sum, self.square = np.zeros(shape), np.zeros(shape), np.zeros(shape)
        self.least, self.least_at = np.full(shape, np.inf), np.full(shape, -1, np.int64)
        self.largest, self.largest_at = np.full(shape, -np.inf), np.full(shape, -1, np.int64)
        self._fast = fast

    def add(self, y: Array, first: int) -> None:
        """Count in ``y`` (outputs, samples, poses), whose first sample has the number ``first``."""
        if self._fast:
            moments_code.add(y, first, self._arrays())
            return
        strip = max(STRIP // max(self.count.size, 1), 1)
        for start in range(0, y.shape[1], strip):
            self._add(np.asarray(y[:, start : start + strip], dtype=np.float64), first + start)

    def _arrays(self) -> tuple[NDArray[np.float64] | NDArray[np.int64], ...]:
        sums = self.count, self.missing, self.shift, self.sum, self.square
        return *sums, self.least, self.least_at, self.largest, self.largest_at

    def _add(self, y: Array, first: int) -> None:
        finite = np.isfinite(y)
        found = finite.sum(axis=1)
        fresh = (self.count == 0) & (found > 0)
        if fresh.any():
            self.shift = np.where(fresh, values_at_samples(y, finite.argmax(axis=1)), self.shift)
        d = np.empty((y.shape[0], y.shape[1] + 1, y.shape[2]))
        d[:, 1:] = np.where(finite, y, self.shift[:, None]) - self.shift[:, None]
        d[:, 0] = self.sum
        self.sum = total(d)
        np.multiply(d[:, 1:], d[:, 1:], out=d[:, 1:])
        d[:, 0] = self.square
        self.square = total(d)
        self.count = self.count + found
        self.missing = self.missing + (y.shape[1] - found)
        self._extremes(y, finite, first)

    def _extremes(self, y: Array, finite: NDArray[np.bool_], first: int) -> None:
        where = np.where(finite, y, np.inf).argmin(axis=1)
        value = np.where(finite.any(axis=1), values_at_samples(y, where), np.inf)
        better = value < self.least
        self.least, self.least_at = np.where(better, value, self.least), np.where(better, where + first, self.least_at)
        where = np.where(finite, y, -np.inf).argmax(axis=1)
        value = np.where(finite.any(axis=1), values_at_samples(y, where), -np.inf)
        better = value > self.largest
        self.largest = np.where(better, value, self.largest)
        self.largest_at = np.where(better, where + first, self.largest_at)

    def state(self) -> Arrays:
        """What was counted; ``squares`` is the sum of squared deviations from the mean."""
        n = np.maximum(self.count, 1)
        offset = self.sum / n
        squares = np.maximum(self.square - self.sum * offset, 0.0)
        return {
            "count": self.count,
            "missing": self.missing,
            "shift": self.shift,
            "offset": offset,
            "squares": squares,
            "least": self.least,
            "least_at": self.least_at,
            "largest": self.largest,
            "largest_at": self.largest_at,
        }


def values_at_samples(y: Array, index: NDArray[np.int64]) -> Array:
    """The values of each output and pose at its own sample."""
    return np.take_along_axis(y, index[:, None], axis=1)[:, 0]


def total(d: Array) -> Array:
    """The sum over samples, one after the other: over a lone column NumPy's own sum would go pairwise."""
    if d.shape[2] > 1:
        return np.asarray(np.add.reduce(d, axis=1))
    return np.add.accumulate(d, axis=1)[:, -1].copy()
