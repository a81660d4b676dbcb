"""Derivatives of measures by the deviations.

An extreme inside the run has the partial derivative at its place, as its rate is zero there; at the end of a window
that moves, the end's motion adds its term; where several places have the same extreme the derivative is one-sided. A
mean follows from Leibniz' rule for integrals with moving ends. The place of a value moves by the implicit function
theorem.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Node
from linkwright.measures import BoundMeasure, Measurer, Probe, SignalInRun
from linkwright.model.bound_window import BoundWindow
from linkwright.reductions import Derivative, Local
from linkwright.results import Run
from linkwright.results.quadrature import gauss_points
from linkwright.studies.accuracy.law_joints import Joins
from linkwright.studies.accuracy.moving_limits import Edges
from linkwright.studies.accuracy.signal_sensitivities import Slopes

Array = NDArray[np.float64]

TIE = 1e-9
"""Places whose values are nearer than this share of the expression's size have the same extreme."""
APART = 1e-7
"""Slopes that differ by no more than this share are one."""
CLOSE = 1e-11
"""How near two quadratures of the slopes are to be, over their size."""
MOST_PANELS = 1 << 12


class Derivatives:
    """The derivatives of measures of a run; of its mechanism's by default."""

    def __init__(self, run: Run, slopes: Slopes, measures: Sequence[BoundMeasure] | None = None) -> None:
        self.run, self.slopes, self.edges, self.joins = run, slopes, Edges(slopes), Joins(slopes)
        self.measurer = Measurer(run, measures)

    def of(self, name: str) -> list[Derivative]:
        """Those of a measure's figures, in their order."""
        return self.measurer.by_name[name].kind.derivative(self.deviated(name))

    def deviated(self, name: str) -> Deviated:
        """A measure's signal by the deviations."""
        measure = self.measurer.by_name[name]
        return Deviated(self, measure, self.measurer.reading(measure))

    def moves(self, window: BoundWindow | None, time: float) -> Array | None:
        """How a time moves with the deviations that is an end of a window or of a load."""
        end = self.edges.end_slope(window, time)
        return self.edges.jump(time) if end is None else end

    def place(self, tree: Node, time: float, value: float, window: BoundWindow | None) -> Array:
        """The derivative of an expression's extreme at a place, of this value."""
        moves = self.moves(window, time)
        if moves is None and (jumping := self.joins.extreme(tree, time, value)) is not None:
            return jumping
        if moves is None and (kink := self.edges.kink(tree, time)) is not None:
            return kink[0]
        here = self.slopes.at([tree], np.array([self.edges.side(tree, time, value)]))
        slope = here.slope[0, :, 0]
        return slope if moves is None else np.asarray(slope + here.rate[0, 0] * moves)

    def extreme(self, measure: BoundMeasure, sign: float) -> Derivative:
        """That of the largest value, or with the sign -1 of the smallest."""
        probe = self.measurer.probe(measure)
        times, values = probe.candidates
        best = (sign * values).max()
        near = times[sign * values >= best - TIE * np.abs(values).max()]
        slopes = np.stack([self.place(probe.node, float(time), sign * best, measure.window) for time in near])
        apart = [slopes[0]]
        for slope in slopes[1:]:
            if all(np.abs(slope - one).max() > APART * np.abs(slopes).max() for one in apart):
                apart.append(slope)
        return Derivative("max" if sign > 0 else "min", float(near[0]), np.stack(apart), sign)

    def integral(self, measure: BoundMeasure, power: int, key: str = "") -> tuple[float, Array, float, Array]:
        """The integral of a power of one of a measure's expressions over its window with its derivative, and the
        window's length likewise."""
        probe, edges = self.measurer.probe(measure, key), self.edges
        total, slope, length, grows = 0.0, np.zeros(self.slopes.count), probe.length(), np.zeros(self.slopes.count)
        corners = np.concatenate([probe.stationary, self.run.breaks])
        for a, b in probe.intervals:
            inside = corners[(a < corners) & (corners < b)]
            value, part = self._quadrature(probe.node, a, b, inside, power)
            total, slope = total + value, slope + part
            for edge, sign in ((a, -1.0), (b, 1.0)):
                moves = edges.end_slope(measure.window, edge)
                assert moves is not None
                slope = slope + sign * self._power(probe, edge, power) * moves
                grows = grows + sign * moves
            for before, after in self.run.jumps:
                if a < before and after < b and (moves := edges.jump((before + after) / 2)) is not None:
                    step = self._power(probe, before, power) - self._power(probe, after, power)
                    slope = slope + step * moves
            for time, moves in self.joins.every:
                if self.edges.jump(time) is not None:
                    continue  # the jump there is that of a load
                if a < time < b and (sides := self.joins.sides(probe.node, time)) is not None:
                    slope = slope + (sides[0][0] ** power - sides[0][1] ** power) * moves
        return total, slope, length, grows

    def _power(self, probe: Probe, time: float, power: int) -> float:
        return float(probe.values(np.array([time]))[0]) ** power

    def _quadrature(self, tree: Node, a: float, b: float, corners: Array, power: int) -> tuple[float, Array]:
        """The integral of a power and that of its derivative, on panels doubled until both stand still."""
        panels, last = max(16, int(self.run.grid * (b - a) / (self.run.stop - self.run.start)) // 4), None
        while True:
            t, weight = gauss_points(np.union1d(np.linspace(a, b, panels + 1), corners))
            here = self.slopes.at([tree], t, rates=False)
            value, slope = here.value[0], here.slope[0]
            found = float(value**power @ weight), (power * value ** (power - 1) * slope) @ weight
            if last is not None:
                size = np.abs(slope * value ** (power - 1)) @ weight
                if (abs(found[1] - last) <= CLOSE * size).all():
                    return found
            if panels >= MOST_PANELS:
                return found
            panels, last = 2 * panels, found[1]


@dataclass(frozen=True)
class Deviated:
    """One measure, as :class:`~linkwright.reductions.WithDeviations` has it."""

    every: Derivatives
    measure: BoundMeasure
    nominal_run: SignalInRun

    @property
    def count(self) -> int:
        """The number of deviations."""
        count: int = self.every.slopes.count
        return count

    def extreme(self, sign: float) -> Derivative:
        """That of the largest value, or with the sign -1 of the smallest."""
        return self.every.extreme(self.measure, sign)

    def integral(self, power: int, key: str = "") -> tuple[float, Array, float, Array]:
        """That of a power of an expression over the window, and of the window's length."""
        return self.every.integral(self.measure, power, key)

    def values_at(self, times: Sequence[float] | Array, key: str = "", rates: bool = True) -> Local:
        """The signal, or another expression, at times (s)."""
        return self.every.slopes.at([self.measure.trees[key]], np.asarray(times), rates)

    def moves(self, time: float) -> Array | None:
        """How a time moves that is an end of the window or of a load."""
        return self.every.moves(self.measure.window, time)

    def turns(self, time: float, key: str) -> Array:
        """How a time moves at which another expression turns."""
        return self.every.edges.turn(self.measure.trees[key], time)

    def number(self, expression: Expression) -> tuple[float, Array]:
        """An expression of parameters of the kind of the signal, with its derivative."""
        dimensions = self.every.run.compiled.quantities.dimensions
        return self.every.slopes.constant(expression, dimensions.dimension(self.measure.entry.signal.node))

    def signals(self, names: Sequence[str], times: Array) -> tuple[Array, Array]:
        """Signals by their names, and their derivatives."""
        return self.every.slopes.tangents.evaluate(names, times)

    def same(self, a: float, b: float) -> bool:
        """Whether two times are one place."""
        return self.every.edges.same(a, b)
