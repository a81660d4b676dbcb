"""How places in time move with the deviations: ends of windows, jumps of loads, turning points, kinks.

All follow from the implicit function theorem: where s(t, d) = 0 defines t, dt/dd = -(ds/dd)/(ds/dt).
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Node
from linkwright.model.bound_window import BoundWindow
from linkwright.results.discontinuities import zeros
from linkwright.results.windows import intervals
from linkwright.studies.accuracy.signal_sensitivities import Slopes

Array = NDArray[np.float64]

SAME = 1e-9
"""Times closer than this share of the run are one."""
ASIDE = 1e-6
"""How far beside a kink its two sides are looked at, over the run."""
KINK = 1e-3
"""A rate that jumps across a turning point by more than this share of its largest has a kink there."""
STEP = 1e-4
"""The step of the difference of eighth order that gives a rate's own slope in time, over the run."""
OFFSETS = np.array([-4, -3, -2, -1, 1, 2, 3, 4])
WEIGHTS = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 4 / 5, -1 / 5, 4 / 105, -1 / 280])


class Edges:
    """The places of a run at which something begins, ends or turns, and their derivatives by the deviations."""

    def __init__(self, slopes: Slopes) -> None:
        self.slopes, self.run = slopes, slopes.run
        self.length = self.run.stop - self.run.start
        actions, window = self.run.compiled.graph.actions, self.run.compiled.quantities.window
        self._jumping = (*map(window, actions.windows), *actions.jumps)  # where loads begin and end to act
        self._moving: dict[BoundWindow | Node, list[tuple[float, Array]]] = {}

    def same(self, a: float, b: float) -> bool:
        """Whether two times are one place."""
        return abs(a - b) <= SAME * self.length

    def end_slope(self, window: BoundWindow | None, time: float) -> Array | None:
        """The derivative (deviations,) of an end of a window, ``None`` where the time is no end of it."""
        still = np.zeros(self.slopes.count)
        if self.same(time, self.run.start) or self.same(time, self.run.stop):
            return still
        return None if window is None else self._time_slope(window, time)

    def jump(self, time: float) -> Array | None:
        """The derivative of a time at which a load begins or ends to act, ``None`` where there is none."""
        every = (self._time_slope(way, time) for way in self._jumping)
        return next((found for found in every if found is not None), None)

    def side(self, tree: Node, time: float, value: float) -> float:
        """A time, or where a force jumps there the one right beside it at which an expression is nearest to a value."""
        beside = next((pair for pair in self.run.jumps if pair[0] <= time <= pair[1]), None)
        if beside is None:
            return time
        return float(beside[np.argmin(np.abs(self.run.jets(tree, beside).d[0] - value))])

    def _time_slope(self, way: BoundWindow | Node, time: float) -> Array | None:
        """The derivative of a time at which a window ends, or an expression changes its sign."""
        if way not in self._moving:
            self._moving[way] = [*self._window_ends(way)] if isinstance(way, BoundWindow) else [*self._zeros(way)]
        # The two sides of a jump lie up to 1e-8 of the run beside it.
        return next((slope for edge, slope in self._moving[way] if abs(edge - time) <= 3e-8 * self.length), None)

    def _window_ends(self, window: BoundWindow) -> Iterator[tuple[float, Array]]:
        return ((edge, self._slope(window, edge)) for ab in intervals(self.run, window) for edge in ab)

    def _zeros(self, node: Node) -> Iterator[tuple[float, Array]]:
        times = zeros(self.run, node)
        here = self.slopes.at([node], times)
        slope, rate = np.broadcast_arrays(here.slope[0], here.rate[0])
        # Where a motion dwells both vanish: the deviations don't move that time.
        moves = np.divide(-slope, rate, out=np.zeros_like(slope), where=slope != 0.0)
        return zip(times.tolist(), moves.T, strict=True)

    def _slope(self, window: BoundWindow, edge: float) -> Array:
        if self.same(edge, self.run.start) or self.same(edge, self.run.stop):
            return np.zeros(self.slopes.count)
        levels = [self.slopes.constant(end, window.dimension) for end in window.ends]
        if window.node is None:
            return min(levels, key=lambda end: abs(end[0] - edge))[1]
        here = self.slopes.at([window.node], np.array([edge]))
        away = []
        for level, slope in levels:
            off = here.value[0, 0] - level
            away.append((abs(np.sin(off / 2)) if window.turning else abs(off), slope))
        level_slope = min(away, key=lambda side: side[0])[1]
        return np.asarray((level_slope - here.slope[0, :, 0]) / here.rate[0, 0])

    def turn(self, tree: Node, time: float) -> Array:
        """The derivative of a time at which an expression turns: of a smooth one from its rate, else of its kink."""
        if (kink := self.kink(tree, time)) is not None:
            return kink[1]
        here = self.slopes.at([tree], np.array([time]))
        return np.asarray(-here.twist[0, :, 0] / self.bend(tree, time))

    def bend(self, tree: Node, time: float) -> float:
        """The second time derivative of an expression, from its exact rate."""
        step = STEP * self.length
        return float(self.run.all_rates([tree], time + step * OFFSETS)[1][0] @ WEIGHTS / step)

    def kink(self, tree: Node, time: float) -> tuple[Array, Array] | None:
        """At a kink, the derivatives of the value there and of its time; ``None`` where the expression is smooth.

        Both sides have the same value: f(t, d) = g(t, d). Their slopes are taken aside and carried to the kink.
        """
        step = ASIDE * self.length
        if not self.run.start + 2 * step < time < self.run.stop - 2 * step:
            return None
        here = self.slopes.at([tree], time + step * np.array([-2.0, -1.0, 1.0, 2.0]))
        rate, slope = here.rate[0], here.slope[0]
        before, after = 2 * rate[1] - rate[0], 2 * rate[2] - rate[3]
        usual = float(np.abs(self.run.all_rates([tree], self.run.t)[1]).max(initial=0.0))
        if not abs(after - before) > KINK * usual:
            return None
        left, right = 2 * slope[:, 1] - slope[:, 0], 2 * slope[:, 2] - slope[:, 3]
        moves = -(right - left) / (after - before)
        return left + before * moves, moves
