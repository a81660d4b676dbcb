"""Measures: named scalars of a run, root-found and integrated, never read off samples."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from linkwright.model.check import WHERE
from linkwright.model.expressions import Node, parse
from linkwright.model.findings import Finding
from linkwright.model.mechanism import REDUCTIONS, Measure
from linkwright.model.places import FIGURES, figure, measured
from linkwright.model.quantities import Quantities
from linkwright.model.units import Dimension, unit
from linkwright.results import Run
from linkwright.results.quadrature import gauss_points
from linkwright.results.stationary import crossings, stationary
from linkwright.results.windows import Interval, intervals
from linkwright.studies.dwells import Course
from linkwright.studies.paths import narrowest

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Found:
    """One number of a measure: its label ("" or min, max), value in SI, and the time (s) where it happens."""

    label: str
    value: float
    time: float | None


NOTHING = Found("", float("nan"), None)


@dataclass(frozen=True)
class MeasureResult:
    """A measure's numbers; ``unit`` is the one it is shown in, ``size`` that unit in SI."""

    name: str
    measure: Measure
    dimension: Dimension
    unit: str
    size: float
    found: tuple[Found, ...]
    requirement: str | None = None
    verdict: bool | None = None

    def shown(self, label: str = "") -> float:
        """A number in the measure's unit. Raises KeyError where the measure has none of that label."""
        values = {f.label: f.value for f in self.found}
        return values[label] / self.size


@dataclass
class Probe:
    """An expression over the intervals of a window: its extremes, its integrals."""

    run: Run
    node: Node
    intervals: list[Interval]
    stationary: Array

    def values(self, t: Array) -> Array:
        return np.asarray(self.run.jets(self.node, t).d[0])

    @cached_property
    def candidates(self) -> tuple[Array, Array]:
        """Times and values among which the extremes are: stationary points, window ends, both sides of jumps."""
        sides = self.run.jumps
        beside = self.run.sides if self.run.may_jump(self.node) else ()
        inside = [t for t in (*self.stationary, *beside) if any(a < t < b for a, b in self.intervals)]
        # Of a jump, a stationary point or an end of the window only has a side, the inner one.
        for before, after in sides:
            inside = [t for t in inside if not before < t < after]
        ends = [edge for a, b in self.intervals for edge in (_inner(self.run, a, 1), _inner(self.run, b, 0))]
        times = np.array(sorted([*inside, *ends]))
        return times, self.values(times)

    def finite(self) -> bool:
        """Whether the expression has a value all over the intervals."""
        times = [np.linspace(a, b, self.share(self.run.grid, a, b) + 1) for a, b in self.intervals]
        times += [t[(t >= a) & (t <= b)] for t in self.far() for a, b in self.intervals]
        passed = [p.time for p in self.run.compiled.passages.every]  # forces may grow without bound there
        times.append(np.array([t for t in passed if any(a <= t <= b for a, b in self.intervals)]))
        return bool(np.isfinite(self.values(np.concatenate(times))).all())

    def far(self) -> list[Array]:
        """Where the instant centres in the expression may pass through infinity, as they do between two poses."""
        run = self.run
        signals = [run.compiled.graph.signal(name) for name in run.signals_of([self.node])]
        pairs = {frozenset(signal.owners): signal.owners for signal in signals if signal.kind == "pole"}

        def turning(t: Array, links: tuple[str, ...]) -> Array:
            a, b = run.compiled.evaluate([f"{link}.omega" for link in links], t)
            return np.asarray(a - b)

        return [crossings(partial(turning, links=ab), run.start, run.stop, run.grid) for ab in pairs.values()]

    def length(self) -> float:
        """How long the intervals are together (s)."""
        return sum(b - a for a, b in self.intervals)

    def share(self, steps: int, a: float, b: float) -> int:
        """An interval's share of a number of steps over the run, four at least."""
        return max(4, int(np.ceil(steps * (b - a) / (self.run.stop - self.run.start))))

    def top(self) -> Found:
        times, values = self.candidates
        i = int(np.argmax(values))
        return Found("max", float(values[i]), float(times[i]))

    def bottom(self) -> Found:
        times, values = self.candidates
        i = int(np.argmin(values))
        return Found("min", float(values[i]), float(times[i]))

    def mean(self, power: int = 1) -> float:
        """The mean of a power over the intervals, by Gauss quadrature on panels doubled until it stands still."""
        panels, last = max(16, self.run.grid // 4), np.inf
        while True:
            total = 0.0
            for a, b in self.intervals:
                turning = np.concatenate([self.stationary, self.run.breaks])
                edges = np.union1d(
                    np.linspace(a, b, self.share(panels, a, b) + 1), turning[(a < turning) & (turning < b)]
                )
                t, weight = gauss_points(edges)
                total += float((self.values(t) ** power) @ weight)
            mean = total / self.length()
            if abs(mean - last) <= 1e-12 * abs(mean) or panels >= 1 << 14:
                return mean
            panels, last = panels * 2, mean

    def strip(self, point: str) -> tuple[float, complex, Array]:
        """The narrowest strip that holds a point's path, as :func:`narrowest` gives it."""

        def plane(*names: str) -> Callable[[Array], NDArray[np.complex128]]:
            def along(t: Array) -> NDArray[np.complex128]:
                x, y = self.run.evaluate([f"{point}.{name}" for name in names], t)
                return np.asarray(x + 1j * y)

            return along

        return narrowest(plane("x", "y"), plane("vx", "vy"), self.intervals, max(self.run.grid, 100))

    def dwell(self, measure: Measure) -> tuple[float, float]:
        """The longest stretch in the measure's band: its begin and end (s)."""
        quantities, found = self.run.compiled.quantities, []
        assert measure.within is not None
        width = quantities.value(measure.within, quantities.dimensions.dimension(measure.signal.node))
        for a, b in self.intervals:
            turning = np.array([a, *(t for t in self.stationary if a < t < b), b])
            found.append(Course(self.values, turning).longest(width))
        return max(found, key=lambda stretch: stretch[1] - stretch[0])


def _inner(run: Run, edge: float, side: int) -> float:
    """An end of an interval, moved off a jump there to the interval's side (0 before, 1 after)."""
    return next((float(pair[side]) for pair in run.jumps if pair[0] <= edge <= pair[1]), edge)


def _plain(found: Found) -> tuple[Found, ...]:
    return (Found("", found.value, found.time),)


def _lasting(start: float, stop: float) -> Found:
    return Found("", stop - start, start)


# One rule per reduction of the file format; "value" has its place from `where` and is taken apart from these.
RULES: dict[str, Callable[[Probe, Measure], tuple[Found, ...]]] = {
    "span": lambda p, _: (Found("", p.top().value - p.bottom().value, None),),
    "max": lambda p, _: _plain(p.top()),
    "min": lambda p, _: _plain(p.bottom()),
    "extremes": lambda p, _: (p.bottom(), p.top()),
    "mean": lambda p, _: (Found("", p.mean(), None),),
    "rms": lambda p, _: (Found("", float(np.sqrt(p.mean(2))), None),),
    "path": lambda p, _: (Found("", p.mean() * p.length(), None),),
    "straightness": lambda p, m: (Found("", p.strip(str(m.point))[0], None),),
    "dwell": lambda p, m: (_lasting(*p.dwell(m)),),
}
assert {*RULES, "value"} == set(REDUCTIONS)


def bound(quantities: Quantities, name: str) -> dict[str, Node]:
    """The expression of a measure by its name, and that which places it by ``NAME where``, bound to SI."""
    measure = quantities.mechanism.measures[name]
    kind = None if measure.reduction in FIGURES else quantities.dimensions.resolve(measured(name))
    trees = {name: quantities.bind(measure.signal, kind)}
    if measure.where and (match := WHERE.match(measure.where)) and match[2]:
        trees[f"{name} where"] = quantities.dimensions.bind(parse(match[2]), None)
    return trees


@dataclass
class Measurer:
    """The measures of some names over a run."""

    run: Run
    names: Sequence[str]
    findings: list[Finding] = field(default_factory=list)

    def __post_init__(self) -> None:
        quantities = self.run.compiled.quantities
        self.mechanism = quantities.mechanism
        self.measures = {name: self.mechanism.measures[name] for name in self.names}
        self.trees: dict[str, Node] = {}
        for name in self.measures:
            self.trees |= bound(quantities, name)

    def all(self) -> list[MeasureResult]:
        if not self.trees:
            return []
        turning = dict(zip(self.trees, self.turning(), strict=True))
        return [self.one(name, measure, turning) for name, measure in self.measures.items()]

    def turning(self) -> list[Array]:
        """The stationary times of every expression, all searched for together."""
        run, trees = self.run, list(self.trees.values())
        return stationary(partial(run.all_rates, trees), run.start, run.stop, run.grid, run.sides)

    def one(self, name: str, measure: Measure, turning: dict[str, Array]) -> MeasureResult:
        quantities = self.run.compiled.quantities
        dimension = quantities.dimensions.resolve(figure(name, measure))
        text, size = quantities.unit_of(dimension) if measure.unit is None else (measure.unit, unit(measure.unit)[0])
        spans = intervals(self.run, measure.window)
        found: tuple[Found, ...] = ()
        if not spans:
            self.findings.append(Finding("measure.nothing", ("measures", name), {"name": name}))
        elif measure.value is not None:
            found = self.placed(name, measure, spans, turning)
        else:
            probe = Probe(self.run, self.trees[name], spans, turning[name])
            found = RULES[measure.reduction](probe, measure) if probe.finite() else (NOTHING,)
        if not all(np.isfinite(f.value) for f in found):
            self.findings.append(Finding("measure.not-finite", ("measures", name), {"name": name}))
            found = ()
        if measure.wrap is not None:
            low, high = (quantities.value(edge, dimension) for edge in measure.wrap)
            found = tuple(Found(f.label, low + (f.value - low) % (high - low), f.time) for f in found)
        requirement, verdict = self.verdict(name, dimension, found)
        return MeasureResult(name, measure, dimension, text, size, found, requirement, verdict)

    def placed(
        self, name: str, measure: Measure, spans: list[Interval], turning: dict[str, Array]
    ) -> tuple[Found, ...]:
        """A value at the place that `where` names."""
        match = WHERE.match(measure.where or "")
        assert match is not None
        if match[1]:
            probe = Probe(self.run, self.trees[f"{name} where"], spans, turning[f"{name} where"])
            if not probe.finite():
                return (NOTHING,)
            time = (probe.top() if match[1] == "max" else probe.bottom()).time
            assert time is not None
        else:
            time = _inner(self.run, spans[0][0], 1) if match[3] else _inner(self.run, spans[-1][1], 0)
        value = float(self.run.jets(self.trees[name], np.array([time])).d[0][0])
        return (Found("", value, time),)

    def verdict(self, name: str, dimension: Dimension, found: tuple[Found, ...]) -> tuple[str | None, bool | None]:
        """The requirement on a measure and whether it is met; one that couldn't be measured is not met."""
        requirement = self.mechanism.require.get(name)
        if requirement is None:
            return None, None
        quantities = self.run.compiled.quantities
        low = -np.inf if requirement.low is None else quantities.value(requirement.low, dimension)
        high = np.inf if requirement.high is None else quantities.value(requirement.high, dimension)
        return str(requirement.raw), bool(found) and all(low <= f.value <= high for f in found)


def measure_all(run: Run, names: Sequence[str] | None = None) -> tuple[list[MeasureResult], list[Finding]]:
    """All measures of a run's mechanism or those of some names, and which of them have no value."""
    measurer = Measurer(run, [*run.compiled.mechanism.measures] if names is None else names)
    return measurer.all(), measurer.findings
