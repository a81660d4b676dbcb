"""The value of a signal at one instant: at an extreme of another one, where one reaches a level, at start or end."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from math import floor, pi
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator, Field

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression, FrozenDict, fault, parse_text
from linkwright.expressions.typed_fields import Named
from linkwright.expressions.written import Fault, short_text
from linkwright.findings import Said
from linkwright.reductions.derivative import Derivative
from linkwright.reductions.entry import SIGNAL, Measure
from linkwright.reductions.figures import Figures, FoundFigure, Unmeasured
from linkwright.reductions.grades import SAMPLED, Grade
from linkwright.reductions.interpolant import turned_levels
from linkwright.reductions.kind import MeasureKind, register
from linkwright.reductions.protocols import InRun, InSamples, WithDeviations
from linkwright.reductions.samples import OnSamples, SampledFigure, SampledFigures, SampledInputs

Array = NDArray[np.float64]

_INSTANT = re.compile(
    r"^\s*(?:(?P<extreme>max|min)\s+(?P<of>\S.*)|(?P<end>start|end)|(?P<signal>[^=]+)=(?P<level>[^=]+))\s*$", re.S
)
_SIGNS = {"max": 1.0, "min": -1.0}
ON = 1e-12
"""An end of the window is a zero where the expression is no larger than this share of its size."""


@dataclass(frozen=True)
class Instant:
    """When a value is taken: at the ``max`` or ``min`` of an expression, at ``start`` or ``end``, or where an
    expression (a signal less its level) is ``zero``."""

    kind: str
    expression: str = ""

    @classmethod
    def read(cls, text: str) -> Instant | None:
        """As a file writes it: ``max E.x``, ``min E.x``, ``start``, ``end``, ``motor.angle = 24 deg``."""
        match = _INSTANT.match(text)
        if match is None:
            return None
        if match["extreme"]:
            return cls(match["extreme"], match["of"])
        return cls(match["end"]) if match["end"] else cls("zero", f"({match['signal']}) - ({match['level'].strip()})")


def _where(raw: Any) -> str:
    text = short_text(raw)
    instant = Instant.read(text)
    if instant is None:
        raise fault("measure.bad-where", given=text[:60])
    if instant.expression:
        parse_text(instant.expression)
    return text


def _expressions(text: str) -> list[tuple[int, int]]:
    """Where the expressions of an instant stand in its text."""
    match = _INSTANT.match(text)
    return [match.span(key) for key in ("of", "signal", "level") if match and match[key]]


class ValueEntry(Measure):
    """The value of a signal at one instant."""

    reduction = "value"
    value: Annotated[Expression, SIGNAL]
    where: Annotated[str, BeforeValidator(_where), Named(parts=_expressions)] = Field(
        examples=["max E.x", "min E.x", "motor.angle = 24 deg", "start", "end"]
    )

    @classmethod
    def key_faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if ("value" in given) != ("where" in given):
            yield "measure.where", {}

    @property
    def instant(self) -> Instant:
        """When the value is taken."""
        instant = Instant.read(self.where)
        assert instant is not None
        return instant

    @property
    def also(self) -> Mapping[str, Expression]:
        """The expression that places the value."""
        expression = self.instant.expression
        return FrozenDict({"where": Expression(expression)} if expression else {})

    @property
    def description(self) -> Said:
        """What is asked for, for the reader."""
        instant = self.instant
        key = "measure.text.where" if instant.kind == "zero" else f"measure.text.where.{instant.kind}"
        return Said(key, signal=self.subject, where=self.where, of=instant.expression)


@register
class Value(MeasureKind):
    """A value at one instant. The place moves by the implicit function theorem."""

    entry = ValueEntry
    everywhere = False
    differentiable = True
    bounded = True

    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        time, grade = _instant(run)
        peak = run.value_at(time)
        place = peak.time if run.measure.also else _edge(run)  # an end was moved off a jump there
        return (FoundFigure("", peak.value, place, peak.side, grade),)

    def needed_extremes(self, measure: ValueEntry) -> Sequence[tuple[str, float]] | None:
        kind = measure.instant.kind
        return None if kind == "zero" else [("where", _SIGNS[kind])] if measure.also else ()

    def figures(self, samples: InSamples) -> dict[str, Figures]:
        kind = samples.measure.instant.kind
        times = (
            samples.extreme(_SIGNS[kind], "where").times if samples.measure.also else samples.window_ends[kind == "end"]
        )
        return {"": Figures(samples.values(times), times)}

    def sampled_inputs(self, measure: ValueEntry) -> SampledInputs:
        return SampledInputs({"": measure.signal, **measure.also}, words={"at": measure.instant.kind})

    def sampled(self, samples: OnSamples) -> SampledFigures | None:
        kind = samples.words["at"]
        if kind == "zero":
            times = _zeros(samples)
            time = min(times) if times else None
        elif kind in _SIGNS:
            time = samples.rows["where"].extreme(samples.stretches, _SIGNS[kind])[1]
        else:
            time = samples.stretches[0][0] if kind == "start" else samples.stretches[-1][1]
        return None if time is None else {"": SampledFigure(samples.signal.value(time), time)}

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        time, moves = _moving(found)
        here = found.values_at([time])
        return [Derivative.smooth(here.slope[0, :, 0] + here.rate[0, 0] * moves, time)]


def _instant(run: InRun) -> tuple[float, Grade]:
    """The time (s) of a value, and how sure it is."""
    kind = run.measure.instant.kind
    if kind == "zero":
        times = run.zeros("where")
        if not times.size:
            raise Unmeasured("measure.no-instant")
        return float(times[0]), SAMPLED
    if run.measure.also:
        other = run.other("where")
        return (other.top() if kind == "max" else other.bottom()).time, run.searched
    return run.inner(_edge(run), int(kind == "start")), SAMPLED


def _zeros(samples: OnSamples) -> list[float]:
    """The times (s) at which the other expression is zero on samples, of an angle modulo whole turns."""
    other, found = samples.rows["where"], list[float]()
    turning = "where" in samples.angles
    for a, b in samples.stretches:
        _, values = other.marks(a, b)
        least, most = min(values), max(values)
        ends = ((a, values[0]), (b, values[-1]))
        if turning:
            levels = turned_levels(0.0, least, most)
            on = [time for time, end in ends if abs(end - 2 * pi * floor(end / (2 * pi) + 0.5)) <= 2 * ON]
        else:
            levels = [0.0]
            on = [time for time, end in ends if abs(end) <= ON * max(-least, most)]
        found += on
        for level in levels:
            found += other.crossings(level, a, b)
    return found


def _edge(run: InRun) -> float:
    """The end of the intervals (s) at which a value is taken."""
    return run.intervals[-1][1] if run.measure.instant.kind == "end" else run.intervals[0][0]


def _moving(found: WithDeviations) -> tuple[float, Array]:
    """The time (s) of a value and its derivative."""
    run, kind = found.nominal_run, found.nominal_run.measure.instant.kind
    time, _ = _instant(run)
    if kind == "zero":
        here = found.values_at([time], "where")
        return time, np.asarray(-here.slope[0, :, 0] / here.rate[0, 0])
    if not run.measure.also:  # the end itself, on whichever side of a jump
        time = _edge(run)
    moves = found.moves(time)
    return time, found.turns(time, "where") if moves is None else moves
