"""A reduction of another package: how peaky a signal is, its span over its root mean square."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

import numpy as np
from pydantic import Field

from linkwright.expressions.fields import Expression
from linkwright.expressions.units import PURE
from linkwright.reductions import (
    SIGNAL,
    Derivative,
    Figures,
    FoundFigure,
    InRun,
    InSamples,
    Measure,
    MeasureKind,
    WithDeviations,
    register,
)


class PeakyEntry(Measure):
    """How peaky a signal is."""

    reduction = "peak_to_peak_over_rms"
    dimension = PURE
    peak_to_peak_over_rms: Annotated[Expression, SIGNAL] = Field(description="span over root mean square of a signal")


@register
class Peaky(MeasureKind):
    """The span of a signal over its root mean square."""

    entry = PeakyEntry
    power = 2
    differentiable = True

    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        return (run.graded_figure("", (run.top().value - run.bottom().value) / np.sqrt(run.mean(2))),)

    def needed_extremes(self, measure: Any) -> Sequence[tuple[str, float]]:
        return [("", -1.0), ("", 1.0)]

    def figures(self, samples: InSamples) -> dict[str, Figures]:
        span = samples.extreme(1.0).values - samples.extreme(-1.0).values
        return {"": Figures.anywhere(span / np.sqrt(samples.mean()))}

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        total, slope, length, grows = found.integral(2)
        rms = np.sqrt(total / length)
        widens = (slope - total / length * grows) / length / (2 * rms)
        low, high = (found.extreme(sign).places[0] for sign in (-1.0, 1.0))
        span = found.nominal_run.top().value - found.nominal_run.bottom().value
        return [Derivative.smooth((high - low) / rms - span / rms**2 * widens)]
