"""A reduction of another package that says no more than it must: the median of a signal over time."""

from __future__ import annotations

from typing import Annotated

import numpy as np
from pydantic import Field

from linkwright.expressions.fields import Expression
from linkwright.reductions import SIGNAL, FoundFigure, InRun, Measure, MeasureKind, register


class MedianEntry(Measure):
    """The median of a signal."""

    reduction = "median"
    median: Annotated[Expression, SIGNAL] = Field(description="half of the time the signal is larger")


@register
class Median(MeasureKind):
    """The median over time, on a grid."""

    entry = MedianEntry

    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        times = [np.linspace(a, b, 1 + int(4e4 * (b - a) / run.length)) for a, b in run.intervals]
        return (run.graded_figure("", float(np.median(run.values(np.concatenate(times))))),)
