"""How the joins of motion laws move in time with the deviations: where an acceleration, a jerk or a force jumps there,
means and extremes follow."""

from __future__ import annotations

from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Node
from linkwright.kernels.combined import combined
from linkwright.notation.duals import value_of
from linkwright.results.discontinuities import law_joins
from linkwright.results.stationary import crossings
from linkwright.studies.accuracy.signal_sensitivities import Slopes

Array = NDArray[np.float64]

ASIDE = 1e-6
"""How far beside a join its two sides are looked at, over the run."""
NEAR = 3e-8
"""How near to a join, over the run, an extreme lies there."""
JUMP = 1e-8
"""A jump smaller than this share of the largest value is round-off."""


class Joins:
    """The joins of the laws that a run passes."""

    def __init__(self, slopes: Slopes) -> None:
        self.slopes, self.run = slopes, slopes.run
        self.length = self.run.stop - self.run.start

    @cached_property
    def every(self) -> list[tuple[float, Array]]:
        """Their times (s) and the derivatives of these (deviations,), where they move."""
        found: list[tuple[float, Array]] = []
        for node in law_joins(self.run.compiled, self.slopes.joins):
            times = crossings(partial(self._value, node), self.run.start, self.run.stop, self.run.grid)
            if times.size:
                here = self.slopes.at([node], times)
                moves = -here.slope[0] / here.rate[0]
                found += [(float(t), moves[:, i]) for i, t in enumerate(times) if np.any(moves[:, i])]
        return found

    def _value(self, node: Node, t: Array) -> Array:
        names = self.run.signals_of([node])
        rows = {name: (row,) for name, row in zip(names, self.run.evaluate(names, t) if names else (), strict=True)}
        given = {name: value_of(number) for name, number in self.slopes.given.items()}
        return np.asarray(combined(self.run.compiled, node, t, rows, 0, given).d[0])

    def sides(self, tree: Node, time: float) -> tuple[Array, Array] | None:
        """The values of an expression right before and behind a join, and their derivatives by the deviations, (2,) and
        (deviations, 2), at that time; ``None`` where it doesn't jump."""
        step = ASIDE * self.length
        if not self.run.start + 2 * step < time < self.run.stop - 2 * step:
            return None
        here = self.slopes.at([tree], time + step * np.array([-2.0, -1.0, 1.0, 2.0]))
        values, slopes = (2 * row[..., 1:3] - row[..., [0, 3]] for row in (here.value[0], here.slope[0]))
        if not abs(values[1] - values[0]) > JUMP * np.abs(here.value).max():
            return None
        return values, slopes

    def extreme(self, tree: Node, time: float, value: float) -> Array | None:
        """The derivative of an extreme at a join where the expression jumps; ``None`` elsewhere."""
        for at, moves in self.every:
            if abs(at - time) <= NEAR * self.length and (sides := self.sides(tree, at)) is not None:
                values, slopes = sides
                side = int(np.argmin(np.abs(values - value)))
                step = ASIDE * self.length * (1 if side else -1)
                rate = self.slopes.at([tree], np.array([at + step, at + 2 * step])).rate[0]
                return np.asarray(slopes[:, side] + (2 * rate[0] - rate[1]) * moves)
        return None
