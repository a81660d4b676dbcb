"""The functions that a drive's law may call by name, each as formulas between knots."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from math import floor
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Node, Number, parse
from linkwright.formulas.terms import plain, plus, power, times
from linkwright.laws import Motion, TableLaw
from linkwright.notation import Jet

Array = NDArray[np.float64]

ROUND_OFF = 1e-15
"""What a coefficient contributes to a value at most where it is left out, over the largest value."""


class PiecewiseFunction(Protocol):
    """A function of one argument, given by a formula between each two knots, in SI."""

    knots: Array
    period: float | None

    def at(self, x: Jet) -> Jet:
        """The value; NaN where it has none."""

    def formula(self, now: float, x: Node) -> Node:
        """Its formula in the tree ``x``, in the neighbourhood of the argument ``now``."""


class OfTable:
    """A table: polynomials between the knots of its spline."""

    def __init__(self, table: TableLaw) -> None:
        self.table, self.period, self.at = table, table.period, table.or_nan
        self.knots, rows = table.powers()
        parts = np.abs(rows) * np.diff(self.knots)[:, None] ** np.arange(rows.shape[1])
        self._rows = np.where(parts > ROUND_OFF * np.abs(table.y).max(), rows, 0.0)

    def formula(self, now: float, x: Node) -> Node:
        start = float(self.knots[0])
        whole = 0.0 if self.period is None else floor((now - start) / self.period) * self.period
        i = min(max(bisect_right(self.knots, now - whole) - 1, 0), len(self._rows) - 1)
        return polynomial(self._rows[i], plus(x, Number(-float(self.knots[i]) - whole)))


class OfMotion:
    """A motion law: the formulas of its segments."""

    def __init__(self, motion: Motion) -> None:
        self.motion, self.at = motion, motion.on
        self.period = None if motion.beyond == "hold" else motion.period
        pieces = motion.pieces("x")
        self.knots = np.array([*(start for start, _, _ in pieces), motion.period])
        self._trees = [parse(text) for _, _, text in pieces]

    def formula(self, now: float, x: Node) -> Node:
        motion, whole = self.motion, 0
        if motion.beyond == "hold" and not 0 < now < motion.period:
            return Number(float(motion.at(now)))
        if motion.beyond != "hold":
            whole = floor(now / motion.period)
        local = now - whole * motion.period
        i = min(max(bisect_right(self.knots, local) - 1, 0), len(self._trees) - 1)
        made = plain(self._trees[i], {"x": plus(x, Number(-whole * motion.period))})
        return plus(Number(whole * motion.advance if motion.beyond == "advance" else 0.0), made)


def polynomial(coefficients: Sequence[float] | Array, of: Node) -> Node:
    """A polynomial, lowest power first."""
    total: Node = Number(float(coefficients[0]))
    for k, c in enumerate(coefficients[1:], start=1):
        total = plus(total, times(Number(float(c)), power(of, Number(float(k)))))
    return total
