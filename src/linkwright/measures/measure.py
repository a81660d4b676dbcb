"""The measures of a run: named scalars, each with the grade of its search."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from linkwright.expressions.language import Node
from linkwright.expressions.units import TIME, Dimension, unit
from linkwright.findings import Finding
from linkwright.measures.found import MeasureResult
from linkwright.measures.probe import Probe, Search
from linkwright.measures.reading import Reading, whole
from linkwright.model.quantities import Quantities
from linkwright.reductions import Found, Measure, Unmeasured, figure, kind_of
from linkwright.results import Run
from linkwright.results.windows import intervals


def bound(quantities: Quantities, name: str) -> dict[str, Node]:
    """The expression of a measure by its name, and others that it needs by ``NAME KEY``, bound to SI."""
    measure, dimensions = quantities.mechanism.measures[name], quantities.dimensions
    kind = dimensions.resolve(figure(name, measure)) if measure.dimension is None else None
    also = {f"{name} {key}": dimensions.bind(expression.node, None) for key, expression in measure.also.items()}
    return {name: quantities.bind(measure.signal, kind), **also}


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

    def reading(self, name: str) -> Reading:
        """A measure over its window. Raises :class:`Unmeasured` where nothing of the run lies in that."""
        measure = self.measures[name]
        probe = self.probe(name, measure.window)
        if not probe.intervals:
            raise Unmeasured("measure.nothing")
        return Reading(probe, measure, lambda key: self.probe(f"{name} {key}", measure.window))

    def found(self, name: str, measure: Measure) -> tuple[Found, ...]:
        """The numbers of a measure. Raises :class:`Unmeasured` where it has none."""
        kind, reading = kind_of(measure), self.reading(name)
        if kind.everywhere:
            whole(reading.probe)
        found = kind.found(reading)
        if any(np.isnan(one.value) for one in found):
            raise Unmeasured("measure.not-finite")
        if not reading.settled:
            self._flag("measure.unsettled", name, None, "warning")
        return found

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
