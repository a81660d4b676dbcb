"""How long a signal dwells: the longest time in which it stays within a band."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from linkwright.expressions.fields import Expression
from linkwright.expressions.typed_fields import Quantity, Sign
from linkwright.expressions.units import TIME
from linkwright.expressions.written import Fault
from linkwright.reductions.derivative import Derivative
from linkwright.reductions.entry import SIGNAL, Measure, of_signal
from linkwright.reductions.figures import Found
from linkwright.reductions.kind import MeasureKind, register
from linkwright.reductions.protocols import InRun, WithDeviations

Array = NDArray[np.float64]

ON = 1e-9
"""Values nearer than this share of a band's width to an edge of it lie on it."""


class DwellEntry(Measure):
    """How long a signal stays in a band."""

    reduction = "dwell"
    dimension = TIME
    dwell: Annotated[Expression, SIGNAL] = Field(
        description="the longest time in which this signal expression stays in a band; with within"
    )
    within: Annotated[Expression, Quantity(of_signal, Sign.POSITIVE, "within")] = Field(
        description="the whole width of the band of a dwell"
    )

    @classmethod
    def apart(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if ("dwell" in given) != ("within" in given):
            yield "measure.within", {}

    @property
    def subject(self) -> str:
        """The signal and the band, for the reader."""
        return f"{self.dwell.text} within {self.within.text}"


@register
class Dwell(MeasureKind):
    """The longest time in which a signal stays within a band, placed where that begins."""

    entry = DwellEntry
    differentiable = True

    def found(self, run: InRun) -> tuple[Found, ...]:
        start, stop = run.longest(run.number(run.measure.within))
        return (run.found("", stop - start, start),)

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        """Where a turning point inside lies on the band's edge, the edge goes with it, and so do the stretch's ends;
        where the signal passes through, it is as fast at either end, so that the band's place doesn't matter.
        """
        run = found.here
        width, wider = found.number(run.measure.within)
        start, stop = run.longest(run.number(run.measure.within))
        inside = [t for t in run.stationary if start < t < stop and not found.same(t, start)]
        here = found.at([start, stop, *(t for t in inside if not found.same(t, stop))])
        value, rate, slope = here.value[0], here.rate[0], here.slope[0]
        ends = [found.moves(start), found.moves(stop)]
        low, lower = _edge(value, slope, ends, width, wider)
        change = np.zeros(found.count)
        for i, sign in ((0, -1.0), (1, 1.0)):
            at_end = ends[i]
            level = lower if abs(value[i] - low) < abs(value[i] - low - width) else lower + wider
            change = change + sign * (at_end if at_end is not None else (level - slope[:, i]) / rate[i])
        return [Derivative.smooth(change, start)]


def _edge(value: Array, slope: Array, ends: list[Array | None], width: float, wider: Array) -> tuple[float, Array]:
    """The band's lower edge and its derivative: from the place that holds the band, a turning point inside or an end
    of the window; from the begin where there is none."""
    low, high = value.min(), value.max()
    holding = [*range(2, value.size), *(i for i in (0, 1) if ends[i] is not None)]
    for i in holding:
        if abs(value[i] - low) <= ON * width and high - low <= width * (1 + ON):
            return low, slope[:, i]
        if abs(value[i] - high) <= ON * width:
            return high - width, slope[:, i] - wider
    return (low, slope[:, 0]) if value[0] == low else (value[0] - width, slope[:, 0] - wider)
