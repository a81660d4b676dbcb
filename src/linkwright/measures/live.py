"""What a page needs to take measures itself, from samples of a run that it computes whenever a dimension moves.

Each measure says which rows of a program it needs with their rates; what its window, its numbers and its requirement
are; or why it can't be taken so. :meth:`LiveMeasure.figures` takes it from samples as the page does, which is what
``web/src/measures/`` is held to. Values of the verified report remain those of :mod:`linkwright.measures.measure`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from math import isfinite, nan
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import (
    FUNCTIONS,
    Binary,
    Call,
    Name,
    Negative,
    Node,
    Number,
    is_signal,
    nodes,
    signals_in,
)
from linkwright.expressions.units import ANGLE, Dimension
from linkwright.graph.graph import Graph
from linkwright.graph.rows import ExpressionRow, Named
from linkwright.kernels import Compiled
from linkwright.measures.bound_measure import BoundMeasure, bound_measures
from linkwright.reductions import Interpolant, OnSamples, SampledFigures
from linkwright.reductions.interpolant import continuous, whole_turns
from linkwright.reductions.samples import sound, stretches, wrapped
from linkwright.results import Run

Array = NDArray[np.float64]
Rows = Callable[[Named], tuple[Sequence[float], Sequence[float]]]
"""Values and rates of a row on the samples."""

NO_RULE, NEEDS_TIME, NEEDS_TABLE = "measure.live.rule", "measure.live.time", "measure.live.table"
"""Why a measure isn't live: its reduction has no rule on samples; the program lacks the time, or a table, as input."""

BESIDE = 1e-10
"""A kink is sampled this share of the run before and after it."""


@dataclass(frozen=True)
class LiveRow:
    """A row that a measure looks at; whether it ``jumps`` by whole turns, which are to be counted, and whether it is an
    ``angle``, of which zero is any number of whole turns."""

    row: Named
    jumps: bool = False
    angle: bool = False


@dataclass(frozen=True)
class LiveNumber:
    """A number (SI): its nominal ``value``, and the row that gives it where it depends on parameters."""

    value: float
    row: Named | None = None

    def on(self, rows: Rows) -> float:
        """The number on samples: it is the same on all."""
        return self.value if self.row is None else float(rows(self.row)[0][0])


@dataclass(frozen=True)
class LiveWindow:
    """The row of a window's signal, ``None`` for the time, and the ends between which it lies; with ``turning``, also
    any whole turns from there."""

    row: LiveRow | None
    ends: tuple[LiveNumber, LiveNumber]
    turning: bool


@dataclass(frozen=True)
class LiveRequirement:
    """A requirement as it is written, and its ends (SI), ``None`` on a side without one."""

    text: str
    low: LiveNumber | None
    high: LiveNumber | None

    def met(self, figures: SampledFigures | None, rows: Rows) -> bool:
        """Whether the figures meet it; a measure without figures doesn't."""
        low = -np.inf if self.low is None else self.low.on(rows)
        high = np.inf if self.high is None else self.high.on(rows)
        return figures is not None and all(low <= one.value <= high for one in figures.values())


@dataclass(frozen=True)
class LiveMeasure:
    """A measure as a page takes it, or the ``reason`` (a key of the catalogue) why it can't.

    ``rows`` are by the keys of its rule; ``watched`` are angles that jump by whole turns within its expressions: where
    one does so, the measure isn't available. ``unit`` is the one in which it is shown, ``size`` that unit in SI.
    """

    measure: BoundMeasure
    unit: str
    size: float
    reason: str | None = None
    rows: Mapping[str, LiveRow] | None = None
    watched: tuple[Named, ...] = ()
    window: LiveWindow | None = None
    numbers: Mapping[str, LiveNumber] | None = None
    words: Mapping[str, str] | None = None
    wrap: tuple[LiveNumber, LiveNumber] | None = None
    requirement: LiveRequirement | None = None

    @property
    def name(self) -> str:
        """As the file has it."""
        return self.measure.name

    @property
    def dimension(self) -> Dimension:
        """That of its figures."""
        return self.measure.dimension

    @property
    def needed(self) -> list[Named]:
        """All rows that it needs of a program with rates."""
        rows = [one.row for one in (self.rows or {}).values()]
        if self.window is not None and self.window.row is not None:
            rows.append(self.window.row.row)
        ends = [] if self.requirement is None else [self.requirement.low, self.requirement.high]
        ends += [*(self.numbers or {}).values(), *(self.wrap or ()), *(self.window.ends if self.window else ())]
        return [*rows, *self.watched, *(end.row for end in ends if end is not None and end.row is not None)]

    def figures(self, t: Sequence[float], rows: Rows) -> SampledFigures | None:
        """Its figures (SI) from samples at times ``t`` (s); ``None`` where it isn't available: fewer than two samples,
        nothing in its window, or a pose there without values."""
        if self.reason is not None or len(t) < 2:
            return None
        for named in self.watched:
            values, rates = rows(named)
            if any(turns != 0 for turns in whole_turns(t, values, rates)):
                return None
        samples = self._samples(t, rows)
        if samples is None:
            return None
        figures = sound(self.measure.kind.sampled(samples))
        if figures is not None and self.wrap is not None:
            low, high = (end.on(rows) for end in self.wrap)
            if not (isfinite(low) and isfinite(high) and low < high):
                return None
            figures = {key: one._replace(value=wrapped(one.value, low, high)) for key, one in figures.items()}
        return figures

    def _samples(self, t: Sequence[float], rows: Rows) -> OnSamples | None:
        """What its rule looks at; ``None`` where it lacks something."""
        where: list[tuple[float, float]] | None = [(float(t[0]), float(t[-1]))]
        if (window := self.window) is not None:
            course = None if window.row is None else _course(t, window.row, rows)
            low, high = (end.on(rows) for end in window.ends)
            where = stretches(t, course, low, high, window.turning)
        courses = {key: _course(t, row, rows) for key, row in (self.rows or {}).items()}
        if not where or not all(course.known(a, b) for course in courses.values() for a, b in where):
            return None
        angles = frozenset(key for key, row in (self.rows or {}).items() if row.angle)
        numbers = {key: number.on(rows) for key, number in (self.numbers or {}).items()}
        if not all(isfinite(number) for number in numbers.values()):
            return None
        return OnSamples(courses, where, angles, numbers, self.words or {})

    def data(self, index: Mapping[Named, int]) -> dict[str, Any]:
        """All of it to be written as JSON, rows by their numbers in a program."""

        def number(one: LiveNumber | None) -> Any:
            return one and {
                "value": one.value if isfinite(one.value) else None,
                "row": None if one.row is None else index[one.row],
            }

        def row(one: LiveRow | None) -> Any:
            return one and {"row": index[one.row], "jumps": one.jumps, "angle": one.angle}

        wrap, window, requirement = self.wrap, self.window, self.requirement
        return {
            "name": self.name,
            "reduction": self.measure.entry.reduction,
            "labels": list(self.measure.kind.labels),
            "dimension": [float(power) for power in self.dimension],
            "unit": self.unit,
            "size": self.size,
            "reason": self.reason,
            "rows": {key: row(one) for key, one in (self.rows or {}).items()},
            "watched": [index[one] for one in self.watched],
            "window": window
            and {"row": row(window.row), "ends": [number(end) for end in window.ends], "turning": window.turning},
            "numbers": {key: number(one) for key, one in (self.numbers or {}).items()},
            "words": dict(self.words or {}),
            "wrap": wrap and [number(end) for end in wrap],
            "requirement": requirement
            and {"text": requirement.text, "low": number(requirement.low), "high": number(requirement.high)},
        }


def live_measures(compiled: Compiled, measures: Sequence[BoundMeasure] | None = None) -> list[LiveMeasure]:
    """The mechanism's measures, or the given ones, as a page takes them."""
    every = bound_measures(compiled.quantities) if measures is None else measures
    return [_Reader(compiled, measure).read() for measure in every]


def live_rows(measures: Iterable[LiveMeasure]) -> list[Named]:
    """The rows that some measures need, each once: those of a program with rates."""
    return list(dict.fromkeys(row for measure in measures for row in measure.needed))


def sampled_times(run: Run, steps: int) -> Array:
    """Times (s) at which a page samples a run: equal steps, both sides of jumps of loads, kinks of forces, and ends of
    windows in time, as far as these are no more than the steps. No feature that stays in its place then lies between
    samples."""
    quantities, length = run.compiled.quantities, run.stop - run.start
    windows = (quantities.window(name) for name in quantities.mechanism.windows)
    ends = [quantities.value(end, window.dimension) for window in windows if window.node is None for end in window.ends]
    sides = np.concatenate([run.jumps.ravel(), run.breaks - BESIDE * length, run.breaks + BESIDE * length])
    t = np.union1d(np.linspace(run.start, run.stop, steps + 1), ends)
    # A break is sampled beside it, where rates are those of its sides, and not between them.
    if sides.size <= steps:
        apart = np.abs(t[:, None] - run.breaks).min(axis=1, initial=np.inf) > BESIDE * length
        t = np.union1d(t[apart | (t == run.start) | (t == run.stop)], sides)
        for before, after in run.jumps:
            t = t[(t <= before) | (t >= after)]
    return np.asarray(t[(t >= run.start) & (t <= run.stop)])


def _course(t: Sequence[float], row: LiveRow, rows: Rows) -> Interpolant:
    """A row between samples."""
    values, rates = rows(row.row)
    return Interpolant(t, continuous(t, values, rates) if row.jumps else values, rates)


@dataclass(frozen=True)
class _Reader:
    """What a page needs of one measure."""

    compiled: Compiled
    measure: BoundMeasure

    @property
    def graph(self) -> Graph:
        return self.compiled.graph

    def read(self) -> LiveMeasure:
        measure, quantities = self.measure, self.compiled.quantities
        unit, size = measure.unit(quantities)
        inputs = measure.kind.sampled_inputs(measure.entry)
        requirement = self.requirement()
        if inputs is None:
            return LiveMeasure(measure, unit, size, NO_RULE, requirement=requirement)
        trees = {key: self.tree(key, expression) for key, expression in inputs.rows.items()}
        looked_at = [*trees.values(), *(measure.window.nodes if measure.window is not None else ())]
        if (reason := self.reason(looked_at)) is not None:
            return LiveMeasure(measure, unit, size, reason, requirement=requirement)
        stated, kind = measure.entry.wrap, measure.dimension
        wrap = None if stated is None else (self.number(stated[0], kind), self.number(stated[1], kind))
        return LiveMeasure(
            measure,
            unit,
            size,
            None,
            {key: self.row(tree, self.dimension(inputs.rows[key])) for key, tree in trees.items()},
            self.watched(looked_at),
            self.window(),
            {
                key: self.number(expression, self.dimension(measure.entry.signal))
                for key, expression in inputs.numbers.items()
            },
            inputs.words,
            wrap,
            requirement,
        )

    def tree(self, key: str, expression: Expression) -> Node:
        """An expression bound to SI; those that the exact measure has, as it has them."""
        own = self.measure.entry.also.get(key) if key else self.measure.entry.signal
        if own is not None and own.text == expression.text:
            return self.measure.trees[key]
        return self.compiled.quantities.dimensions.bind(expression.node, None)

    def dimension(self, expression: Expression) -> Dimension:
        return self.compiled.quantities.dimensions.dimension(expression.node)

    def reason(self, trees: Sequence[Node]) -> str | None:
        """Why the program can't have these expressions."""
        parts = [part for tree in trees for part in nodes(tree)]
        if not self.graph.actions.timed and any(isinstance(part, Name) and part.text == "t" for part in parts):
            return NEEDS_TIME
        known = {(one.table, one.argument, one.integral) for one in self.graph.actions.lookups}
        calls = [part for part in parts if isinstance(part, Call) and part.attribute is None]
        asked = [call for call in calls if call.name not in FUNCTIONS]
        return NEEDS_TABLE if any((call.name, call.args[0], False) not in known for call in asked) else None

    def row(self, tree: Node, dimension: Dimension) -> LiveRow:
        named = self.named(tree)
        changes = [whole_change(tree, angle, self.canonical) for angle in self.angles([tree])]
        return LiveRow(named, any(change != 0 and is_whole(change) for change in changes), dimension == ANGLE)

    def named(self, tree: Node) -> Named:
        """The row of an expression: of a signal alone that of the signal, which plots have too."""
        return self.canonical(tree) if isinstance(tree, Name | Call) and is_signal(tree) else ExpressionRow(tree)

    def canonical(self, node: Name | Call) -> str:
        return self.compiled.quantities.signals.find(node).text

    def angles(self, trees: Iterable[Node]) -> list[str]:
        """The angles in some expressions that jump by whole turns."""
        return [name for name in dict.fromkeys(map(self.canonical, signals_in(*trees))) if self.graph.wrapped(name)]

    def watched(self, trees: Sequence[Node]) -> tuple[Named, ...]:
        """The angles whose whole turns alter an expression by something else than whole turns."""
        found = []
        for angle in self.angles(trees):
            changes = [whole_change(tree, angle, self.canonical) for tree in trees]
            if not all(map(is_whole, changes)):
                found.append(angle)
        return tuple(found)

    def number(self, expression: Expression, dimension: Dimension) -> LiveNumber:
        quantities = self.compiled.quantities
        tree, value = quantities.bind(expression, dimension), quantities.value(expression, dimension)
        free = any(isinstance(part, Name) and part.text != "pi" for part in nodes(tree))
        return LiveNumber(value, ExpressionRow(tree) if free else None)

    def window(self) -> LiveWindow | None:
        window = self.measure.window
        if window is None:
            return None
        row = None if window.node is None else self.row(window.node, window.dimension)
        low, high = (self.number(end, window.dimension) for end in window.ends)
        return LiveWindow(row, (low, high), window.node is not None and window.turning)

    def requirement(self) -> LiveRequirement | None:
        stated = self.measure.requirement
        if stated is None:
            return None
        low, high = (
            None if end is None else self.number(end, self.measure.dimension) for end in (stated.low, stated.high)
        )
        return LiveRequirement(str(stated.raw), low, high)


def whole_change(node: Node, angle: str, canonical: Callable[[Name | Call], str]) -> float:
    """By how many turns an expression changes where an angle in it changes by one; NaN where that isn't always the
    same."""
    if isinstance(node, Name | Call) and is_signal(node):
        return float(canonical(node) == angle)
    if isinstance(node, Negative):
        return -whole_change(node.of, angle, canonical)
    if isinstance(node, Call):
        changes = [whole_change(argument, angle, canonical) for argument in node.args]
        if all(change == 0 for change in changes):
            return 0.0
        return 0.0 if node.name in ("sin", "cos", "tan") and is_whole(changes[0]) else nan
    if isinstance(node, Binary):
        left, right = (whole_change(part, angle, canonical) for part in (node.left, node.right))
        if node.op in "+-":
            return left + right if node.op == "+" else left - right
        if left == right == 0:
            return 0.0
        if isinstance(node.right, Number) and node.op in "*/":
            return left * node.right.value if node.op == "*" else left / (node.right.value or nan)
        if isinstance(node.left, Number) and node.op == "*":
            return right * node.left.value
        return nan
    return 0.0


def is_whole(change: float) -> bool:
    """Whether a change is one of whole turns."""
    return isfinite(change) and change == round(change)
