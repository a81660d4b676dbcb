"""Derivatives of the measures that have several places: how straight a path is, how long a signal dwells."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwright.measures.paths import around
from linkwright.measures.rules import dwelling
from linkwright.model.mechanism import Measure
from linkwright.studies.accuracy.derivative import Derivative

if TYPE_CHECKING:
    from linkwright.studies.accuracy.derivatives import Derivatives

Array = NDArray[np.float64]

ON = 1e-9
"""Points nearer than this share of a path's extent to a side of its strip lie on it; so do values with a band."""


def straightness(found: Derivatives, name: str, measure: Measure) -> list[Derivative]:
    """Of the width of the narrowest strip around a path.

    The path lies on one side with two points, on the other with one between these. The strip turns so that it stays on
    all three: the width changes by the third point's motion across less that of the place opposite, on the chord of
    the two. (Without a chord the width is stationary in the strip's direction.)
    """
    window, point = measure.window, str(measure.point)
    _, across, times = around(found.run, point, found.probe(name, window).intervals)
    names = [f"{point}.{axis}" for axis in ("x", "y", "vx", "vy")]
    values, slopes = found.slopes.tangents.evaluate(names, times)
    place, speed, moved = values[0] + 1j * values[1], values[2] + 1j * values[3], slopes[0] + 1j * slopes[1]
    for i, time in enumerate(times):
        if (moves := found.moves(window, float(time))) is not None:
            moved[:, i] += speed[i] * moves
    high, along, shift = ((z * across.conjugate()) for z in (place, place * 1j, moved))
    sides = [_side(sign * high.real, along.real) for sign in (1.0, -1.0)]
    (top, bottom), change = sides, np.zeros(found.slopes.count)
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


def dwell(found: Derivatives, name: str, measure: Measure) -> list[Derivative]:
    """Of the longest time in a band of a signal.

    Where a turning point inside lies on the band's edge, the edge goes with it, and so do the stretch's ends; where
    the signal passes through, it is as fast at either end, so that the band's place doesn't matter.
    """
    probe, slopes, quantities = found.probe(name, measure.window), found.slopes, found.run.compiled.quantities
    assert measure.within is not None
    kind = quantities.dimensions.dimension(measure.signal.node)
    width, wider = slopes.constant(measure.within, kind)
    start, stop = dwelling(probe, measure)
    inside = [t for t in probe.stationary if start < t < stop and not found.edges.same(t, start)]
    times = np.array([start, stop, *(t for t in inside if not found.edges.same(t, stop))])
    here = slopes.at([probe.node], times)
    value, rate, slope = here.value[0], here.rate[0], here.slope[0]
    ends = [found.moves(measure.window, float(time)) for time in times[:2]]
    low, lower = _edge(value, slope, ends, width, wider)
    change = np.zeros(slopes.count)
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
