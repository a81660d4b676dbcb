"""The kurtosis of each output at each pose, over samples.

Inside an atom: sums of the powers of d = y - shift, the shift being the first finite value, made central. Between
atoms: the pairwise formulas of Pebay, "Formulas for robust, one-pass parallel computation of covariances and
arbitrary-order statistical moments", Sandia report SAND2008-6212 (2008), eqs. (1.5), (1.6).
"""

from __future__ import annotations

import numpy as np

from linkwright.blocks.moments import total, values_at_samples
from linkwright.blocks.reductions import Array
from linkwright.blocks.work import Arrays
from linkwright.data_classes import dataclass


@dataclass(frozen=True)
class Fourth:
    """Figures, each (outputs, poses): ``count`` of finite values, and their ``kurtosis``, the fourth central moment
    over the square of the second one (3 for normal values); NaN where all are the same."""

    def tally(self, outputs: int, poses: int) -> FourthTally:
        """A fresh tally."""
        return FourthTally(outputs, poses)

    def fold(self, state: Arrays, later: Arrays) -> Arrays:
        """The state of both."""
        a, b = state, later
        na, nb = a["count"], b["count"]
        n = np.maximum(na + nb, 1)
        shift = np.where(na > 0, a["shift"], b["shift"])
        before = np.where(na > 0, a["offset"], b["offset"])
        d = np.where((na > 0) & (nb > 0), (b["shift"] - shift) + (b["offset"] - before), 0.0)
        u, v = na / n, nb / n
        return {
            "count": na + nb,
            "shift": shift,
            "offset": before + d * v,
            "second": a["second"] + b["second"] + d**2 * u * nb,
            "third": a["third"] + b["third"] + d**3 * u * nb * (u - v) + 3 * d * (u * b["second"] - v * a["second"]),
            "fourth": a["fourth"]
            + b["fourth"]
            + d**4 * u * nb * (u * u - u * v + v * v)
            + 6 * d**2 * (u * u * b["second"] + v * v * a["second"])
            + 4 * d * (u * b["third"] - v * a["third"]),
        }

    def result(self, state: Arrays) -> Arrays:
        """The figures."""
        with np.errstate(invalid="ignore"):
            kurtosis = np.where(
                state["second"] > 0, state["fourth"] * state["count"] / np.square(state["second"]), np.nan
            )
        return {"count": state["count"], "kurtosis": kurtosis}


class FourthTally:
    """Sums over the samples of one atom, strictly sample after sample."""

    def __init__(self, outputs: int, poses: int) -> None:
        self.count = np.zeros((outputs, poses), np.int64)
        self.shift, self.sums = np.zeros((outputs, poses)), np.zeros((4, outputs, poses))

    def add(self, y: Array, first: int) -> None:
        """Count in ``y`` (outputs, samples, poses)."""
        finite = np.isfinite(y)
        found = finite.sum(axis=1)
        fresh = (self.count == 0) & (found > 0)
        self.shift = np.where(fresh, values_at_samples(y, finite.argmax(axis=1)), self.shift)
        self.count = self.count + found
        d = np.where(finite, y, self.shift[:, None]) - self.shift[:, None]
        power = np.ones_like(d)
        for k, before in enumerate(self.sums):
            power *= d
            self.sums[k] = total(np.concatenate([before[:, None], power], axis=1))

    def state(self) -> Arrays:
        """What was counted; ``second`` to ``fourth`` are the sums of the powers of deviations from the mean."""
        n = np.maximum(self.count, 1)
        s1, s2, s3, s4 = self.sums
        m = s1 / n
        return {
            "count": self.count,
            "shift": self.shift,
            "offset": m,
            "second": np.maximum(s2 - m * s1, 0.0),
            "third": s3 - 3 * m * s2 + 2 * m * m * s1,
            "fourth": np.maximum(s4 - 4 * m * s3 + 6 * m * m * s2 - 3 * m**3 * s1, 0.0),
        }
