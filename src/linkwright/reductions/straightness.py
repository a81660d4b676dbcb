"""How straight a point's path is: the width of the narrowest strip that holds it."""

from __future__ import annotations

from typing import Annotated

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from linkwright.expressions.fields import Name
from linkwright.expressions.typed_fields import Ref
from linkwright.expressions.units import LENGTH
from linkwright.reductions.derivative import Derivative
from linkwright.reductions.entry import OfPath
from linkwright.reductions.figures import Found
from linkwright.reductions.kind import MeasureKind, register
from linkwright.reductions.protocols import InRun, WithDeviations

Array = NDArray[np.float64]

ON = 1e-9
"""Points nearer than this share of a path's extent to a side of its strip lie on it."""


class StraightnessEntry(OfPath):
    """How straight a point's path is."""

    reduction = "straightness"
    dimension = LENGTH
    along = ("{0}.x", LENGTH)
    straightness: Annotated[Name, Ref("point")] = Field(
        description="the distance of the two closest parallel lines that hold this point's path"
    )


@register
class Straightness(MeasureKind):
    """The distance of the two closest parallel lines that hold a path (ISO 1101; minimum zone, ISO 12780-1)."""

    entry = StraightnessEntry
    differentiable = True

    def found(self, run: InRun) -> tuple[Found, ...]:
        return (run.found("", run.strip(run.measure.point)[0]),)

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        """The path lies on one side with two points, on the other with one between these. The strip turns so that it
        stays on all three: the width changes by the third point's motion across less that of the place opposite, on the
        chord of the two. (Without a chord the width is stationary in the strip's direction.)
        """
        point = found.here.measure.point
        _, across, times = found.here.strip(point)
        values, slopes = found.signals([f"{point}.{axis}" for axis in ("x", "y", "vx", "vy")], times)
        place, speed, moved = values[0] + 1j * values[1], values[2] + 1j * values[3], slopes[0] + 1j * slopes[1]
        for i, time in enumerate(times):
            if (moves := found.moves(float(time))) is not None:
                moved[:, i] += speed[i] * moves
        high, along, shift = ((z * across.conjugate()) for z in (place, place * 1j, moved))
        sides = [_side(sign * high.real, along.real) for sign in (1.0, -1.0)]
        (top, bottom), change = sides, np.zeros(found.count)
        for sign, own, other in ((1.0, top, bottom), (-1.0, bottom, top)):
            first, last = own
            reach = along.real[last] - along.real[first]
            share = np.clip((along.real[other[0]] - along.real[first]) / reach, 0.0, 1.0) if reach else 0.0
            change = change + sign * ((1 - share) * shift.real[:, first] + share * shift.real[:, last])
        return [Derivative.smooth(change)]


def _side(height: Array, along: Array) -> tuple[int, int]:
    """The outermost two points that lie on the upper side; the same one twice where there is but one."""
    on = np.flatnonzero(height >= height.max() - ON * np.ptp(along))
    return int(on[along[on].argmin()]), int(on[along[on].argmax()])
