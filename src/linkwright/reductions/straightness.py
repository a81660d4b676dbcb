"""How straight a point's path is: the width of the narrowest strip that holds it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import sqrt
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Ref
from linkwright.expressions.units import LENGTH
from linkwright.notation.hull import hull
from linkwright.reductions.derivative import Derivative
from linkwright.reductions.entry import OfPath
from linkwright.reductions.figures import FoundFigure
from linkwright.reductions.interpolant import Interpolant
from linkwright.reductions.kind import MeasureKind, register
from linkwright.reductions.protocols import InRun, WithDeviations
from linkwright.reductions.samples import OnSamples, SampledFigure, SampledFigures, SampledInputs

Array = NDArray[np.float64]
Path = NDArray[np.complex128]
Point = tuple[float, float]

ON = 1e-9
"""Points nearer than this share of a path's extent to a side of its strip lie on it."""
ROUNDS = 60
"""The most rounds in which outermost points are added."""


class StraightnessEntry(OfPath):
    """How straight a point's path is."""

    reduction = "straightness"
    dimension = LENGTH
    along = ("{0}.x", LENGTH)
    straightness: Annotated[Name, Ref("point")]


@register
class Straightness(MeasureKind):
    """The distance of the two closest parallel lines that hold a path (ISO 1101; minimum zone, ISO 12780-1)."""

    entry = StraightnessEntry
    differentiable = True

    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        return (run.graded_figure("", _of_run(run)[0]),)

    def sampled_inputs(self, measure: StraightnessEntry) -> SampledInputs:
        return SampledInputs({axis: Expression(f"{measure.point}.{axis}") for axis in ("x", "y")})

    def sampled(self, samples: OnSamples) -> SampledFigures:
        """The same bounds: the path across a strip is a cubic too, whose turning points are known."""
        x, y = samples.rows["x"], samples.rows["y"]
        marks = [time for a, b in samples.stretches for time in x.marks(a, b)[0]]
        points = corners([(x.value(time), y.value(time)) for time in marks])
        origin = points[0]
        extent = max(max(abs(p[0] - origin[0]), abs(p[1] - origin[1])) for p in points)
        best = float(np.inf) if extent > 0 else 0.0
        for _ in range(ROUNDS if extent > 0 else 0):
            least, a, b = narrow(points)
            height = Interpolant.mixed(x, y, a, b)
            (top, first), (bottom, last) = (height.extreme(samples.stretches, sign) for sign in (1.0, -1.0))
            best = min(best, top - bottom)
            if best - least <= 1e-12 * best + 1e-15 * extent:
                break
            points = corners([*points, *((x.value(time), y.value(time)) for time in (first, last))])
        return {"": SampledFigure(best)}

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        """The path lies on one side with two points, on the other with one between these. The strip turns so that it
        stays on all three: the width changes by the third point's motion across less that of the place opposite, on the
        chord of the two. (Without a chord the width is stationary in the strip's direction.)
        """
        point = found.nominal_run.measure.point
        _, across, times = _of_run(found.nominal_run)
        if not times.size:  # the point stands still, wherever the deviations put it
            return [Derivative.smooth(np.zeros(found.count))]
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


def _of_run(run: InRun) -> tuple[float, complex, Array]:
    """The narrowest strip that holds the path over the window."""

    def plane(*axes: str) -> Callable[[Array], Path]:
        def along(t: Array) -> Path:
            x, y = run.signals([f"{run.measure.point}.{axis}" for axis in axes], t)
            return np.asarray(x + 1j * y)

        return along

    return narrowest(plane("x", "y"), plane("vx", "vy"), run.grid, run.turning)


def narrowest(
    place: Callable[[Array], Path],
    speed: Callable[[Array], Path],
    grid: Array,
    turning: Callable[[Callable[[Array], tuple[Array, Array]]], Array],
) -> tuple[float, complex, Array]:
    """The narrowest strip that holds a path: its width, the unit vector across it, the times at which the path is
    outermost in that direction and its opposite, with the ends.

    ``place`` gives x + iy of the point at times, ``speed`` its velocity so; ``grid`` are times to begin with;
    ``turning`` gives the times at which a value turns, from it and its rate, with the ends. The narrowest strip of some
    points of the path is a lower bound, the whole path's extent across that strip an upper one; the path's outermost
    points join the others until the two bounds meet.
    """
    points = hull(place(grid))
    extent = float(np.abs(points - points[0]).max())
    best, held = (np.inf if extent > 0 else 0.0), (1j, np.empty(0))
    for _ in range(ROUNDS if extent > 0 else 0):
        least, across = strip(points)
        times = turning(partial(_height, place, speed, across))
        found = place(times)
        heights = (found * across.conjugate()).real
        if np.ptp(heights) < best:
            best, held = float(np.ptp(heights)), (across, times)
        if best - least <= 1e-12 * best + 1e-15 * extent:
            break
        points = hull(np.concatenate([points, found[[heights.argmin(), heights.argmax()]]]))
    return best, *held


def _height(
    place: Callable[[Array], Path], speed: Callable[[Array], Path], across: complex, t: Array
) -> tuple[Array, Array]:
    """How far a path lies across, and its rate."""
    return (place(t) * across.conjugate()).real, (speed(t) * across.conjugate()).real


def strip(corners: Path) -> tuple[float, complex]:
    """The width of the narrowest strip around a convex polygon, and the unit vector across it.

    One side of it lies on an edge of the polygon (Houle and Toussaint 1988).
    """
    edges = np.roll(corners, -1) - corners
    across = 1j * edges / np.abs(edges)
    widths = ((corners[None] - corners[:, None]) * across.conjugate()[:, None]).real.max(axis=1)
    i = int(widths.argmin())
    return float(widths[i]), complex(across[i])


def corners(points: Sequence[Point]) -> list[Point]:
    """:func:`linkwright.notation.hull.hull` in plain numbers, as pages have it."""
    ordered = sorted(set(points))
    sides: list[Point] = []
    for row in (ordered, ordered[::-1]):
        side: list[Point] = []
        for p in row:
            while len(side) > 1 and _left(side[-2], side[-1], p) <= 0:
                side.pop()
            side.append(p)
        sides += side[:-1]
    return sides or ordered


def _left(a: Point, b: Point, c: Point) -> float:
    """How far c lies to the left of the way from a to b, times the length of that."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def narrow(points: Sequence[Point]) -> tuple[float, float, float]:
    """:func:`strip` in plain numbers: the width, and the unit vector across it."""
    x, y = np.array(points).T
    best = (np.inf, 0.0, 1.0)
    for i, p in enumerate(points):
        q = points[(i + 1) % len(points)]
        along, up = q[0] - p[0], q[1] - p[1]
        length = sqrt(along * along + up * up)
        a, b = -up / length, along / length
        width = float(((x - p[0]) * a + (y - p[1]) * b).max())
        if width < best[0]:
            best = (width, a, b)
    return best
