"""The reductions of measures: one rule each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from linkwright.measures.dwells import Course
from linkwright.measures.found import Found, Unmeasured
from linkwright.measures.grades import Grade, Kind
from linkwright.measures.means import Mean
from linkwright.measures.paths import around
from linkwright.measures.probe import Peak, Probe
from linkwright.model.mechanism import REDUCTIONS, Measure


@dataclass
class Reducer:
    """One measure over the intervals of its window; ``settled`` until a search or a quadrature has not stood still."""

    probe: Probe
    measure: Measure
    settled: bool = True

    def _found(self, label: str, value: float, time: float | None = None, side: str = "") -> Found:
        search = self.probe.search
        self.settled &= search.settled(self.probe.node)
        return Found(label, value, time, side, Grade(Kind.SEARCHED, search.turned.width))

    def _extreme(self, label: str, peak: Peak) -> Found:
        return self._found(label, *peak)

    def _mean(self, power: int) -> Mean:
        mean = self.probe.mean(power)
        self.settled &= mean.settled
        if not np.isfinite(mean.value):
            place = next(p for p in self.probe.limits if np.isinf([p.before.value, p.after.value]).any())
            raise Unmeasured("measure.diverges", place.time)
        return mean

    def top(self, label: str = "") -> Found:
        """The largest value."""
        return self._extreme(label, self.probe.top())

    def bottom(self, label: str = "") -> Found:
        """The smallest value."""
        return self._extreme(label, self.probe.bottom())

    def span(self) -> Found:
        """The largest less the smallest value."""
        high, low = self.top(), self.bottom()
        for end in (high, low):
            if end.unbounded:
                return replace(end, value=float(np.inf))
        return self._found("", high.value - low.value)

    def mean(self) -> Found:
        """The mean over time."""
        return self._found("", self._mean(1).value)

    def rms(self) -> Found:
        """The root of the mean square."""
        return self._found("", float(np.sqrt(self._mean(2).value)))

    def path(self) -> Found:
        """The mean speed over the time."""
        return self._found("", self._mean(1).value * self.probe.length())

    def straightness(self) -> Found:
        """The width of the narrowest strip around a path."""
        return self._found("", around(self.probe.run, str(self.measure.point), self.probe.intervals)[0])

    def dwell(self) -> Found:
        """The longest stretch in a band."""
        start, stop = dwelling(self.probe, self.measure)
        return self._found("", stop - start, start)


# One rule per reduction of the file format; "value" has its place from `where` and is taken apart from these.
RULES: dict[str, Callable[[Reducer], tuple[Found, ...]]] = {
    "span": lambda r: (r.span(),),
    "max": lambda r: (r.top(),),
    "min": lambda r: (r.bottom(),),
    "extremes": lambda r: (r.bottom("min"), r.top("max")),
    "mean": lambda r: (r.mean(),),
    "rms": lambda r: (r.rms(),),
    "path": lambda r: (r.path(),),
    "straightness": lambda r: (r.straightness(),),
    "dwell": lambda r: (r.dwell(),),
}
assert {*RULES, "value"} == set(REDUCTIONS)


def dwelling(probe: Probe, measure: Measure) -> tuple[float, float]:
    """The longest stretch in the measure's band: its begin and end (s)."""
    quantities, found = probe.run.compiled.quantities, []
    assert measure.within is not None
    width = quantities.value(measure.within, quantities.dimensions.dimension(measure.signal.node))
    for a, b in probe.intervals:
        turning = np.array([a, *(t for t in probe.stationary if a < t < b), b])
        found.append(Course(probe.values, turning).longest(width))
    return max(found, key=lambda stretch: stretch[1] - stretch[0])
