"""Reductions to extremes of a signal: the largest, the smallest, both, and what lies between them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Annotated, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.fields import Expression
from linkwright.reductions.derivative import Derivative
from linkwright.reductions.entry import SIGNAL, Measure
from linkwright.reductions.figures import Figures, FoundFigure
from linkwright.reductions.kind import MeasureKind, register
from linkwright.reductions.protocols import InRun, InSamples, WithDeviations, WithPlay
from linkwright.reductions.samples import OnSamples, SampledFigure, SampledFigures, SampledInputs

Array = NDArray[np.float64]


class _OfExtremes(MeasureKind):
    """A reduction whose figures are extremes: the sign of each by its label."""

    signs: ClassVar[Mapping[str, float]]
    differentiable = True
    bounded = True

    def needed_extremes(self, measure: Any) -> Sequence[tuple[str, float]]:
        return [("", sign) for sign in self.proven]

    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        return tuple(
            run.graded_figure(label, *(run.top() if sign > 0 else run.bottom())) for label, sign in self.signs.items()
        )

    def figures(self, samples: InSamples) -> dict[str, Figures]:
        return {label: samples.extreme(sign) for label, sign in self.signs.items()}

    def sampled_inputs(self, measure: Any) -> SampledInputs:
        return SampledInputs({"": measure.signal})

    def sampled(self, samples: OnSamples) -> SampledFigures:
        """Extremes are samples, turning points of the cubics, or ends of the window."""
        found = {label: samples.signal.extreme(samples.stretches, sign) for label, sign in self.signs.items()}
        return {label: SampledFigure(*one) for label, one in found.items()}

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        return [replace(found.extreme(sign), label=label) for label, sign in self.signs.items()]

    def beyond(self, reported: Mapping[str, float], low: float, high: float) -> float:
        return max(high - reported[label] if sign > 0 else reported[label] - low for label, sign in self.signs.items())


class MaxEntry(Measure):
    """The largest value of a signal."""

    reduction = "max"
    max: Annotated[Expression, SIGNAL]


class MinEntry(Measure):
    """The smallest value of a signal."""

    reduction = "min"
    min: Annotated[Expression, SIGNAL]


class ExtremesEntry(Measure):
    """Both extremes of a signal."""

    reduction = "extremes"
    extremes: Annotated[Expression, SIGNAL]


class SpanEntry(Measure):
    """What lies between the extremes of a signal."""

    reduction = "span"
    span: Annotated[Expression, SIGNAL]


@register
class Span(_OfExtremes):
    """The largest less the smallest value; it has no place."""

    entry = SpanEntry
    proven = (-1.0, 1.0)

    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        high, low = (run.graded_figure("", *peak) for peak in (run.top(), run.bottom()))
        for end in (high, low):
            if end.unbounded:
                return (replace(end, value=float(np.inf)),)
        return (run.graded_figure("", high.value - low.value),)

    def figures(self, samples: InSamples) -> dict[str, Figures]:
        return {"": Figures.anywhere(samples.extreme(1.0).values - samples.extreme(-1.0).values)}

    def sampled(self, samples: OnSamples) -> SampledFigures:
        high, low = (samples.signal.extreme(samples.stretches, sign)[0] for sign in (1.0, -1.0))
        return {"": SampledFigure(high - low)}

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        low, high = (found.extreme(sign) for sign in (-1.0, 1.0))
        pairs = high.places[:, None] - low.places[None]  # a largest value less a smallest is a largest difference
        return [Derivative("", None, pairs.reshape(-1, found.count))]

    def clearance_bounds(self, found: WithPlay) -> list[Array]:
        """The directions at the two extremes are free of each other."""
        low, high = (found.worst(found.deviations.extreme(sign).sides).max(axis=1) for sign in (-1.0, 1.0))
        return [low + high]

    def beyond(self, reported: Mapping[str, float], low: float, high: float) -> float:
        return high - low - reported[""]


@register
class Max(_OfExtremes):
    """The largest value."""

    entry = MaxEntry
    signs = {"": 1.0}
    proven = (1.0,)


@register
class Min(_OfExtremes):
    """The smallest value."""

    entry = MinEntry
    signs = {"": -1.0}
    proven = (-1.0,)


@register
class Extremes(_OfExtremes):
    """The smallest and the largest value."""

    entry = ExtremesEntry
    labels = ("min", "max")
    signs = {"min": -1.0, "max": 1.0}
    proven = (-1.0, 1.0)
