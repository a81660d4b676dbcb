"""The measures of a run: named scalars, each with the grade of its search."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Node, parse
from linkwright.expressions.units import ANGLE, TIME, Dimension, unit
from linkwright.findings import Finding
from linkwright.measures.found import Found, MeasureResult, Unmeasured
from linkwright.measures.grades import SAMPLED, Grade, Kind
from linkwright.measures.probe import Probe, Search, inner
from linkwright.measures.rules import RULES, Reducer
from linkwright.model.mechanism import Measure
from linkwright.model.places import FIGURES, figure, measured
from linkwright.model.quantities import Quantities
from linkwright.results import Run
from linkwright.results.windows import Interval, intervals, passing

Array = NDArray[np.float64]


def bound(quantities: Quantities, name: str) -> dict[str, Node]:
    """The expression of a measure by its name, and that which places it by ``NAME where``, bound to SI."""
    measure = quantities.mechanism.measures[name]
    kind = None if measure.reduction in FIGURES else quantities.dimensions.resolve(measured(name))
    trees = {name: quantities.bind(measure.signal, kind)}
    if (when := measure.instant) and when.expression:
        trees[f"{name} where"] = quantities.dimensions.bind(parse(when.expression), None)
    return trees


def instants(run: Run, measure: Measure, tree: Node, spans: list[Interval]) -> Array:
    """The times (s) in a window at which an expression that places a value is zero, of angles modulo whole turns."""
    assert measure.instant is not None
    turning = run.compiled.quantities.dimensions.dimension(parse(measure.instant.expression)) == ANGLE
    return passing(run, tree, spans, turning)


@dataclass
class Measurer:
    """The measures of some names over a run."""

    run: Run
    names: Sequence[str]
    findings: list[Finding] = field(default_factory=list)
    _noticed: list[float] = field(default_factory=list)
    _probes: dict[tuple[str, str | None], Probe] = field(default_factory=dict)

    def __post_init__(self) -> None:
        quantities = self.run.compiled.quantities
        self.mechanism = quantities.mechanism
        self.measures = {name: self.mechanism.measures[name] for name in self.names}
        self.trees: dict[str, Node] = {}
        for name in self.measures:
            self.trees |= bound(quantities, name)

    @cached_property
    def search(self) -> Search:
        """What all expressions do over the run, searched for together."""
        return Search(self.run, list(self.trees.values()), self._noticed)

    def look_at(self, times: Sequence[float]) -> None:
        """Search again, closely at some times (s), and forget what was found."""
        self._noticed += times
        self.findings.clear()
        self._probes.clear()
        del self.search

    def probe(self, key: str, window: str | None) -> Probe:
        """An expression over a window."""
        if (key, window) not in self._probes:
            self._probes[key, window] = Probe(self.search, self.trees[key], intervals(self.run, window))
        return self._probes[key, window]

    def all(self) -> list[MeasureResult]:
        """Every measure, in the order of the names."""
        return [self.one(name, measure) for name, measure in self.measures.items()]

    def one(self, name: str, measure: Measure) -> MeasureResult:
        """One measure; what it lacks is a finding."""
        quantities = self.run.compiled.quantities
        dimension = quantities.dimensions.resolve(figure(name, measure))
        text, size = quantities.unit_of(dimension) if measure.unit is None else (measure.unit, unit(measure.unit)[0])
        found: tuple[Found, ...] = ()
        try:
            found = self.found(name, measure)
        except Unmeasured as why:
            self._flag(why.code, name, why.time)
        if far := [one for one in found if one.unbounded]:
            self._flag("measure.unbounded", name, far[0].time)
        if measure.wrap is not None:
            low, high = (quantities.value(edge, dimension) for edge in measure.wrap)
            found = tuple(
                one if one.unbounded else replace(one, value=low + (one.value - low) % (high - low)) for one in found
            )
        requirement, verdict = self.verdict(name, dimension, found)
        return MeasureResult(name, measure, dimension, text, size, found, requirement, verdict)

    def found(self, name: str, measure: Measure) -> tuple[Found, ...]:
        """The numbers of a measure. Raises :class:`Unmeasured` where it has none."""
        probe = self.probe(name, measure.window)
        if not probe.intervals:
            raise Unmeasured("measure.nothing")
        if measure.value is not None:
            return (self.placed(name, measure, probe),)
        self._whole(probe)
        reducer = Reducer(probe, measure)
        found = RULES[measure.reduction](reducer)
        if any(np.isnan(one.value) for one in found):
            raise Unmeasured("measure.not-finite")
        if not reducer.settled:
            self._flag("measure.unsettled", name, None, "warning")
        return found

    def placed(self, name: str, measure: Measure, probe: Probe) -> Found:
        """A value at the place that `where` names."""
        time, grade = self.instant(name, measure, probe.intervals)
        value, side = float(probe.values(np.array([time]))[0]), ""
        for place in probe.limits:
            if abs(place.time - time) <= probe.near:
                if place.before.value != place.after.value:
                    raise Unmeasured("measure.two-values", time)
                value, side = place.after.value, "after"
        if np.isnan(value):
            raise Unmeasured("measure.not-finite", time)
        return Found("", value, time, side, grade)

    def instant(self, name: str, measure: Measure, spans: list[Interval]) -> tuple[float, Grade]:
        """The time (s) of a value, and how sure it is."""
        when, key = measure.instant, f"{name} where"
        assert when is not None
        if when.kind == "zero":
            times = instants(self.run, measure, self.trees[key], spans)
            if not times.size:
                raise Unmeasured("measure.no-instant")
            return float(times[0]), SAMPLED
        if when.expression:
            where = self.probe(key, measure.window)
            self._whole(where)
            peak = where.top() if when.kind == "max" else where.bottom()
            return peak.time, Grade(Kind.SEARCHED, self.search.turned.width)
        edge, side = (spans[0][0], 1) if when.kind == "start" else (spans[-1][1], 0)
        return inner(self.run, edge, side), SAMPLED

    def _whole(self, probe: Probe) -> None:
        """Refuse an expression that has no value somewhere, or of which it isn't known whether it is bounded."""
        if not probe.finite():
            raise Unmeasured("measure.not-finite")
        if undecided := probe.undecided():
            raise Unmeasured("measure.undecided", undecided[0])

    def _flag(self, code: str, name: str, time: float | None, severity: str = "error") -> None:
        text, second = self.run.compiled.quantities.unit_of(TIME)
        data = {"name": name, "signal": self.measures[name].subject, "width": f"{self.search.turned.width:.3g} s"}
        data["time"] = "-" if time is None else f"{time / second:.6g} {text}"
        self.findings.append(Finding(code, ("measures", name), data, severity=severity))

    def verdict(self, name: str, dimension: Dimension, found: tuple[Found, ...]) -> tuple[str | None, bool | None]:
        """The requirement on a measure and whether it is met; one that couldn't be measured is not met, an unbounded
        one where the requirement bounds that side."""
        requirement = self.mechanism.require.get(name)
        if requirement is None:
            return None, None
        quantities = self.run.compiled.quantities
        low = -np.inf if requirement.low is None else quantities.value(requirement.low, dimension)
        high = np.inf if requirement.high is None else quantities.value(requirement.high, dimension)
        return str(requirement.raw), bool(found) and all(low <= f.value <= high for f in found)


def measure_all(run: Run, names: Sequence[str] | None = None) -> tuple[list[MeasureResult], list[Finding]]:
    """All measures of a run's mechanism or those of some names, and what is to be known of them: errors for those
    without a value, warnings for searches that ended at their finest grid."""
    measurer = Measurer(run, [*run.compiled.mechanism.measures] if names is None else names)
    return measurer.all(), measurer.findings
