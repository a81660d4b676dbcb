"""The measures of a run: named scalars, each with the grade of its search."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Node
from linkwright.expressions.units import TIME
from linkwright.findings import Finding
from linkwright.measures.bound_measure import BoundMeasure, bound_measures
from linkwright.measures.found import MeasureResult
from linkwright.measures.probe import Probe, Search
from linkwright.measures.signal_in_run import SignalInRun, require_bounded
from linkwright.model.bound_window import BoundWindow
from linkwright.reductions import FoundFigure, Unmeasured
from linkwright.results import Run
from linkwright.results.windows import intervals


@dataclass
class Measurer:
    """Some measures over a run; those of its mechanism by default."""

    run: Run
    measures: Sequence[BoundMeasure] | None = None
    findings: list[Finding] = field(default_factory=list)
    _noticed: dict[Node, list[float]] = field(default_factory=dict)
    _probes: dict[tuple[Node, BoundWindow | None], Probe] = field(default_factory=dict)

    def __post_init__(self) -> None:
        every = bound_measures(self.run.compiled.quantities) if self.measures is None else self.measures
        self.by_name = {measure.name: measure for measure in every}

    @cached_property
    def search(self) -> Search:
        """What all expressions do over the run, searched for together."""
        trees = [tree for measure in self.by_name.values() for tree in measure.trees.values()]
        return Search(self.run, trees, self._noticed)

    def look_at(self, times: Mapping[Node, Sequence[float]]) -> None:
        """Search again, closely at some times (s) of expressions, and forget what was found."""
        for node, some in times.items():
            self._noticed.setdefault(node, []).extend(some)
        self.findings.clear()
        self._probes.clear()
        del self.search

    def probe(self, measure: BoundMeasure, key: str = "") -> Probe:
        """An expression of a measure over its window."""
        tree, window = measure.trees[key], measure.window
        if (tree, window) not in self._probes:
            self._probes[tree, window] = Probe(self.search, tree, intervals(self.run, window))
        return self._probes[tree, window]

    def all(self) -> list[MeasureResult]:
        """Every measure, in their order."""
        return [self.evaluate(measure) for measure in self.by_name.values()]

    def evaluate(self, measure: BoundMeasure) -> MeasureResult:
        """One measure; what it lacks is a finding."""
        quantities, found = self.run.compiled.quantities, tuple[FoundFigure, ...]()
        try:
            found = self.figures_of(measure)
        except Unmeasured as why:
            self._flag(why.code, measure, why.time)
        if far := [one for one in found if one.unbounded]:
            self._flag("measure.unbounded", measure, far[0].time)
        found = tuple(f if f.unbounded else replace(f, value=measure.wrapped(quantities, f.value)) for f in found)
        requirement, verdict = None, None
        if measure.requirement is not None:
            # One that couldn't be measured is not met, an unbounded one where the requirement bounds that side.
            requirement = str(measure.requirement.raw)
            verdict = bool(found) and bool(measure.requirement_met(quantities, [one.value for one in found]))
        unit = measure.unit(quantities)
        return MeasureResult(measure.name, measure.entry, measure.dimension, *unit, found, requirement, verdict)

    def reading(self, measure: BoundMeasure) -> SignalInRun:
        """A measure over its window. Raises :class:`Unmeasured` where nothing of the run lies in that."""
        probe = self.probe(measure)
        if not probe.intervals:
            raise Unmeasured("measure.nothing")
        return SignalInRun(probe, measure.entry, lambda key: self.probe(measure, key))

    def figures_of(self, measure: BoundMeasure) -> tuple[FoundFigure, ...]:
        """The numbers of a measure. Raises :class:`Unmeasured` where it has none."""
        kind, reading = measure.kind, self.reading(measure)
        if kind.everywhere:
            require_bounded(reading.probe)
        found = kind.run_figures(reading)
        if any(np.isnan(one.value) for one in found):
            raise Unmeasured("measure.not-finite")
        if not reading.settled:
            self._flag("measure.unsettled", measure, None, "warning")
        return found

    def _flag(self, code: str, measure: BoundMeasure, time: float | None, severity: str = "error") -> None:
        text, second = self.run.compiled.quantities.unit_of(TIME)
        width = f"{self.search.width(measure.signal):.3g} s"
        data = {"name": measure.name, "signal": measure.entry.subject, "width": width}
        data["time"] = "-" if time is None else f"{time / second:.6g} {text}"
        self.findings.append(Finding(code, measure.path, data, severity=severity))


def measure_all(run: Run, measures: Sequence[BoundMeasure] | None = None) -> tuple[list[MeasureResult], list[Finding]]:
    """All measures of a run's mechanism, or the given ones, and what is to be known of them: errors for those without
    a value, warnings for searches that ended at their finest grid."""
    measurer = Measurer(run, measures)
    return measurer.all(), measurer.findings
