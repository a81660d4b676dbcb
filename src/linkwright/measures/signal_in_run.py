"""What reductions ask of a run: a measure's signal over the intervals of its window."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression
from linkwright.expressions.units import ANGLE
from linkwright.measures.probe import Probe, inner
from linkwright.reductions import FoundFigure, Grade, Measure, Peak, ProofKind, Unmeasured
from linkwright.results.stationary import stationary
from linkwright.results.windows import Interval, passing

Array = NDArray[np.float64]

LEAST = 100
"""The fewest steps of an interval on which curves are looked at."""


@dataclass
class SignalInRun:
    """One measure in a run, as :class:`~linkwright.reductions.InRun` has it. ``probes`` gives its other expressions;
    ``settled`` until a search or a quadrature has not stood still."""

    probe: Probe
    measure: Measure
    probes: Callable[[str], Probe]
    settled: bool = True

    @property
    def intervals(self) -> list[Interval]:
        """Where it is measured."""
        return self.probe.intervals

    @property
    def length(self) -> float:
        """How long the intervals are together (s)."""
        return self.probe.length()

    @property
    def stationary(self) -> Array:
        """The times (s) at which the signal turns or may have a kink."""
        return self.probe.stationary

    @property
    def searched(self) -> Grade:
        """The grade of what the search gives."""
        return Grade(ProofKind.SEARCHED, self.probe.search.width(self.probe.node))

    def values(self, t: Array) -> Array:
        """The signal at times, SI."""
        return self.probe.values(t)

    def value_at(self, time: float) -> Peak:
        """The signal at one time, that of its side where the other has no value."""
        value, side = float(self.probe.values(np.array([time]))[0]), ""
        for place in self.probe.limits:
            if abs(place.time - time) <= self.probe.near:
                if place.before.value != place.after.value:
                    raise Unmeasured("measure.two-values", time)
                value, side = place.after.value, "after"
        if np.isnan(value):
            raise Unmeasured("measure.not-finite", time)
        return Peak(value, time, side)

    def top(self) -> Peak:
        """The largest value."""
        return self.probe.top()

    def bottom(self) -> Peak:
        """The smallest value."""
        return self.probe.bottom()

    def mean(self, power: int = 1, rule: int = 0) -> float:
        """The mean of a power."""
        mean = self.probe.mean(power, rule)
        self.settled &= mean.settled
        if not np.isfinite(mean.value):
            place = next(p for p in self.probe.limits if np.isinf([p.before.value, p.after.value]).any())
            raise Unmeasured("measure.diverges", place.time)
        return mean.value

    def magnitude(self) -> float:
        """The mean of the magnitude."""
        return self.probe.mean().size

    def number(self, expression: Expression) -> float:
        """An expression of parameters of the kind of the signal, SI."""
        quantities = self.probe.run.compiled.quantities
        return quantities.value(expression, quantities.dimensions.dimension(self.measure.signal.node))

    def graded_figure(self, label: str, value: float, time: float | None = None, side: str = "") -> FoundFigure:
        """A figure with the grade of the search."""
        self.settled &= self.probe.search.settled(self.probe.node)
        return FoundFigure(label, value, time, side, self.searched)

    def other(self, key: str) -> SignalInRun:
        """Another expression of the measure."""
        return SignalInRun(require_bounded(self.probes(key)), self.measure, self.probes)

    def zeros(self, key: str) -> Array:
        """The times (s) at which another expression is zero, of an angle modulo whole turns."""
        run, probe = self.probe.run, self.probes(key)
        turning = run.compiled.quantities.dimensions.dimension(self.measure.also[key].node) == ANGLE
        return passing(run, probe.node, probe.intervals, turning)

    def inner(self, edge: float, side: int) -> float:
        """An end of an interval, moved off a jump there."""
        return inner(self.probe.run, edge, side)

    def signals(self, names: Sequence[str], t: Array) -> Array:
        """Signals by their names at times (s)."""
        return self.probe.run.evaluate(names, t)

    @property
    def grid(self) -> Array:
        """Times (s) all over the intervals."""
        return np.concatenate([np.linspace(a, b, self._steps + 1) for a, b in self.intervals])

    def turning(self, curve: Callable[[Array], tuple[Array, Array]]) -> Array:
        """The times (s) at which a curve turns, with the ends of the intervals."""

        def rates(t: Array) -> tuple[Array, Array]:
            value, rate = curve(t)
            return value[None], rate[None]

        found = [[[a], stationary(rates, a, b, self._steps)[0], [b]] for a, b in self.intervals]
        return np.concatenate([part for parts in found for part in parts])

    @property
    def _steps(self) -> int:
        return max(self.probe.run.grid, LEAST)


def require_bounded(probe: Probe) -> Probe:
    """The same. Raises :class:`Unmeasured` for an expression that has no value somewhere, or of which it isn't known
    whether it is bounded."""
    if not probe.finite():
        raise Unmeasured("measure.not-finite")
    if undecided := probe.undecided():
        raise Unmeasured("measure.undecided", undecided[0])
    return probe
