"""How long a signal dwells: the longest time in which it stays within a band."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from math import isinf
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression
from linkwright.expressions.typed_fields import Quantity, Sign
from linkwright.expressions.units import TIME
from linkwright.expressions.written import Fault
from linkwright.reductions.derivative import Derivative
from linkwright.reductions.entry import SIGNAL, Measure, of_signal
from linkwright.reductions.figures import FoundFigure
from linkwright.reductions.interpolant import Interpolant
from linkwright.reductions.kind import MeasureKind, register
from linkwright.reductions.protocols import InRun, WithDeviations
from linkwright.reductions.samples import OnSamples, SampledFigure, SampledFigures, SampledInputs

Array = NDArray[np.float64]
Stretch = tuple[float, float]

ON = 1e-9
"""Values nearer than this share of a band's width to an edge of it lie on it."""
LEVELS, ZOOMS = 33, 8
"""How many places of the band are looked at together, and how often closer around the best of them."""


class DwellEntry(Measure):
    """How long a signal stays in a band."""

    reduction = "dwell"
    dimension = TIME
    dwell: Annotated[Expression, SIGNAL]
    within: Annotated[Expression, Quantity(of_signal, Sign.POSITIVE, "within")]

    @classmethod
    def key_faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
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

    def run_figures(self, run: InRun) -> tuple[FoundFigure, ...]:
        start, stop = _longest(run)
        return (run.graded_figure("", stop - start, start),)

    def sampled_inputs(self, measure: DwellEntry) -> SampledInputs:
        return SampledInputs({"": measure.signal}, {"within": measure.within})

    def sampled(self, samples: OnSamples) -> SampledFigures:
        """The same search on the cubics."""
        found = [OnCubics.over(samples.signal, a, b).longest(samples.numbers["within"]) for a, b in samples.stretches]
        start, stop = max(found, key=lambda stretch: stretch[1] - stretch[0])
        return {"": SampledFigure(stop - start, start)}

    def derivative(self, found: WithDeviations) -> list[Derivative]:
        """Where a turning point inside lies on the band's edge, the edge goes with it, and so do the stretch's ends;
        where the signal passes through, it is as fast at either end, so that the band's place doesn't matter.
        """
        run = found.nominal_run
        width, wider = found.number(run.measure.within)
        start, stop = _longest(run)
        inside = [t for t in run.stationary if start < t < stop and not found.same(t, start)]
        here = found.values_at([start, stop, *(t for t in inside if not found.same(t, stop))])
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


def _longest(run: InRun) -> Stretch:
    """The longest stretch of time (s) over all intervals."""
    width, found = run.number(run.measure.within), list[Stretch]()
    for a, b in run.intervals:
        turning = np.array([a, *(t for t in run.stationary if a < t < b), b])
        found.append(TurningCourse(run.values, turning).longest(width))
    return max(found, key=lambda stretch: stretch[1] - stretch[0])


@dataclass
class TurningCourse:
    """A signal between its turning points: ``turning`` (s, ascending, both ends included), monotone in between."""

    value: Callable[[Array], Array]
    turning: Array

    @cached_property
    def heights(self) -> Array:
        return self.value(self.turning)

    def longest(self, width: float) -> Stretch:
        """The longest stretch of time (s) in which the signal varies by ``width`` at most; the first of equals.

        Where it is longest, its band begins or ends at a turning point or an end of the run inside the stretch, or
        the signal passes through the band, as fast where it leaves as where it came in.
        """
        found = [*self._around(width), *self._passing(width)]
        most = max(b - a for a, b in found)
        return min(stretch for stretch in found if stretch[1] - stretch[0] >= most * (1 - 1e-9))

    def _around(self, width: float) -> list[Stretch]:
        """The stretches whose band begins or ends at a turning point."""
        y, last = self.heights, self.turning.size - 1
        exits = []
        for i in range(last + 1):
            top = y[i] > y[i + 1] if i < last else y[i] > y[i - 1]
            low, high = (y[i] - width, y[i]) if top else (y[i], y[i] + width)
            exits += [self._exit(i, step, low, high) for step in (-1, 1)]
        times = self._when(*(np.array(column) for column in zip(*exits, strict=True)))
        return list(zip(times[::2].tolist(), times[1::2].tolist(), strict=True))

    def _exit(self, i: int, step: int, low: float, high: float) -> tuple[int, float]:
        """From the turning point i on, the piece on which the signal leaves the band, and the level there."""
        y, slack = self.heights, 1e-13 * float(np.abs(self.heights).max())
        while 0 <= i + step < y.size and low - slack <= y[i + step] <= high + slack:
            i += step
        if not 0 <= i + step < y.size:
            return min(i, y.size - 2), np.inf * step  # the run ends first
        return min(i, i + step), low if y[i + step] < low else high

    def _passing(self, width: float) -> list[Stretch]:
        """The longest stretch of each way through a band of which neither edge is a turning point inside."""
        found: list[Stretch] = []
        for sign in (1.0, -1.0):
            ways = np.array(list(self._ways(sign * self.heights, width))).reshape(-1, 4)
            if not ways.size:
                continue
            first, last = ways[:, :2].astype(int).T
            low, high = ways[:, 2], ways[:, 3]
            for _ in range(ZOOMS):
                levels = np.linspace(low, high, LEVELS, axis=1)
                came = self._when(np.repeat(first, LEVELS), sign * levels.ravel()).reshape(levels.shape)
                left = self._when(np.repeat(last, LEVELS), sign * (levels + width).ravel()).reshape(levels.shape)
                best, rows = (left - came).argmax(axis=1), np.arange(first.size)
                low, high = levels[rows, np.maximum(best - 1, 0)], levels[rows, np.minimum(best + 1, LEVELS - 1)]
            found += zip(came[rows, best].tolist(), left[rows, best].tolist(), strict=True)
        return found

    def _ways(self, y: Array, width: float) -> list[tuple[float, ...]]:
        """Pairs of rising pieces between which the signal can stay in a band, with the range of its lower edge."""
        ways: list[tuple[float, ...]] = []
        for i in np.flatnonzero(y[:-1] < y[1:]):
            least, most = np.inf, -np.inf
            for j in range(int(i), y.size - 1):
                if j > i:
                    least, most = min(least, y[j]), max(most, y[j])
                if most - least > width:
                    break
                low, high = max(y[i], y[j] - width, most - width), min(y[i + 1], y[j + 1] - width, least)
                if y[j] < y[j + 1] and low < high:
                    ways.append((float(i), j, low, high))
        return ways

    def _when(self, piece: Array, level: Array) -> Array:
        """The times (s) at which the signal has some levels, each on a stated piece; its ends for -inf and inf."""
        from scipy.optimize.elementwise import find_root

        ends, y = (np.stack([v[piece], v[piece + 1]]) for v in (self.turning, self.heights))
        outside = np.isinf(level)
        beyond = np.where(level > 0, ends[1], ends[0])
        level = np.clip(level, y.min(axis=0), y.max(axis=0))
        found = find_root(lambda t, wanted: self.value(t) - wanted, tuple(ends), args=(level,))
        # A level that is that of an end but for round-off has no bracket.
        end = ends[np.abs(y - level).argmin(axis=0), np.arange(level.size)]
        return np.asarray(np.where(outside, beyond, np.where(found.success, found.x, end)))


@dataclass
class OnCubics(TurningCourse):
    """The same between samples."""

    signal: Interpolant
    known: Array

    @classmethod
    def over(cls, signal: Interpolant, a: float, b: float) -> OnCubics:
        """From a to b (s)."""
        times, values = signal.turning(a, b)
        return cls(np.vectorize(signal.value), np.array(times), signal, np.array(values))

    @cached_property
    def heights(self) -> Array:
        return self.known

    def _when(self, piece: Array, level: Array) -> Array:
        found = []
        for i, wanted in zip(piece.tolist(), level.tolist(), strict=True):
            a, b = self.turning[i : i + 2].tolist()
            found.append((b if wanted > 0 else a) if isinf(wanted) else self.signal.when(a, b, wanted))
        return np.array(found)
