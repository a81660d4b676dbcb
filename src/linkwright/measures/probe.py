"""An expression over the intervals of a window: its extremes, one-sided limits included, and its integrals."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Node
from linkwright.measures.means import MeanValue, StretchEnd, mean
from linkwright.measures.places import BreakPlaces, Hard, vague
from linkwright.measures.round_off import reachable, vanishing
from linkwright.measures.search import RunPieces, turning
from linkwright.measures.sides import Side, Sides
from linkwright.notation import Jet
from linkwright.notation.angles import whole_turns
from linkwright.reductions import Peak
from linkwright.results import Run
from linkwright.results.discontinuities import ASIDE
from linkwright.results.windows import Interval

Array = NDArray[np.float64]
Rows = dict[str, tuple[Array, Array]]
"""Values and rates of signals, (times,) each, by name."""


SAME = 1e-6
"""Values on a cut and beside it that differ by less than this share are those of a kink."""
EQUAL = 1e-13
"""Values that differ by less than this share are equal but for round-off."""
SMOOTH = 0.01
"""A step towards a cut is along the rate where the one before it strays from that by no more than this share."""
ZERO_STEPS = 1 << 11
"""What is zero but for round-off is that on a grid of at least so many steps."""
FEW = 1 << 10
"""So many times are few: making a program costs more than computing all signals there."""
KEPT = 256
"""For so many sets of few times signals are kept."""
BEYOND = 1e-6
"""Nearer to a pole than this share of the run, values may overflow."""


@dataclass(frozen=True)
class OneSidedLimits:
    """A place at which an expression has limits from before and after, as a break function vanishes there."""

    time: float
    before: Side
    after: Side


class Search:
    """What expressions (bound to SI) do over a run, evaluated together, closely at ``noticed`` times (s) too. What it
    gives of one of them doesn't depend on the others."""

    def __init__(self, run: Run, trees: Sequence[Node], noticed: Mapping[Node, Sequence[float]] | None = None) -> None:
        self.run, self.trees = run, [*dict.fromkeys(trees)]
        self.signals = run.signals_of(self.trees)
        self.places = BreakPlaces(run, self.trees, noticed or {})
        pieces = [self.places.pieces[tree] for tree in self.trees]
        self._zero = self._vanishing_all(pieces)
        """Which expressions are no more than round-off at every time."""
        self.turning_points = turning(lambda t: run.all_rates(self.trees, t), pieces, run.grid, skip=self._zero)
        self._vague = vague(run, self.trees, np.linspace(run.start, run.stop, 257))
        self._limits: dict[Node, list[OneSidedLimits]] = {}
        self._rows: dict[bytes, Rows] = {}

    def _vanishing_all(self, pieces: Sequence[RunPieces]) -> list[bool]:
        """Which expressions vanish on their own grids: on a coarse one first, which clears most of them."""
        zero = vanishing(self.run, self.trees, self.run.t)
        for i, (tree, one) in enumerate(zip(self.trees, pieces, strict=True)):
            zero[i] = zero[i] and vanishing(self.run, [tree], one.grid(max(self.run.grid, ZERO_STEPS)))[0]
        return zero

    def rows(self, t: Array) -> Rows:
        """The signals of all expressions with their rates at few times; kept, as many measures ask for the same ones,
        such as both ends of the run."""
        key = t.tobytes()
        if key not in self._rows:
            if len(self._rows) >= KEPT:
                self._rows.clear()
            rates = zip(*self.run.possible_rates(self.signals, t), strict=True) if self.signals else ()
            self._rows[key] = dict(zip(self.signals, rates, strict=True))
        return self._rows[key]

    def stationary(self, node: Node) -> Array:
        """The times (s) at which an expression turns or may have a kink, ascending."""
        pieces = self.places.pieces[node]
        return np.union1d(self.turning_points.times[self.trees.index(node)], (pieces.before + pieces.after) / 2)

    def outermost(self, node: Node) -> Array:
        """The times (s) of an expression's smallest and largest value on the last grid."""
        return self.turning_points.outermost[self.trees.index(node)]

    def width(self, node: Node) -> float:
        """The width (s) of the steps on which an expression's search ended, or its round-off was looked at."""
        if self.is_zero(node):
            return (self.run.stop - self.run.start) / max(self.run.grid, ZERO_STEPS)
        return self.turning_points.widths[self.trees.index(node)]

    def is_zero(self, node: Node) -> bool:
        """Whether an expression is no more than round-off of the terms that cancel in it, at every time."""
        return self._zero[self.trees.index(node)]

    def settled(self, node: Node) -> bool:
        """Whether nothing more was found on the last, finer grids."""
        i = self.trees.index(node)
        return self._zero[i] or (self.places.settled[node] and (self.turning_points.settled[i] or self._vague[i]))

    def limits(self, node: Node) -> list[OneSidedLimits]:
        """The places at which an expression may have other values on both sides, or none."""
        if node not in self._limits:
            found = [] if self.is_zero(node) else self._vanishing(node) + self._passed(node)
            self._limits[node] = sorted(found, key=lambda place: place.time)
        return self._limits[node]

    def _vanishing(self, node: Node) -> list[OneSidedLimits]:
        # Places at which the same break functions vanish share their series; take them together.
        groups: dict[tuple[object, ...], list[Hard]] = {}
        for hard in self.places.hard[node]:
            groups.setdefault(hard.features, []).append(hard)
        found = []
        for some in groups.values():
            sides = Sides(self.run, node, some[0].features)
            times = np.array([hard.time for hard in some])
            for hard, before, after in zip(some, sides.limits_at(times, -1), sides.limits_at(times, 1), strict=True):
                if before[1] or after[1]:
                    found.append(OneSidedLimits(hard.time, before[0], after[0]))
        return found

    def passage_error(self, node: Node) -> float:
        """How far an expression's limits in the bands of change points are from its closed forms, where both are good:
        the digits that these lose near by."""
        run, worst = self.run, 0.0
        names = run.signals_of([node])
        for passage in run.compiled.passages.every if names else ():
            t = passage.compared
            t = t[(t >= run.start) & (t <= run.stop)]
            closed = run.compiled.closed_form_rows(names, t, rates=True).reshape(len(names), 2, t.size)
            limits = run.possible_rates(names, t)
            for row, name in enumerate(names):
                if run.compiled.graph.wrapped(name):
                    closed[row, 0] += 2 * np.pi * whole_turns(closed[row, 0], limits[0][row])
            both = (
                run.combine(node, t, dict(zip(names, zip(*rows, strict=True), strict=True))).d[0]
                for rows in (limits, (closed[:, 0], closed[:, 1]))
            )
            off = np.abs(np.subtract(*both))
            worst = max(worst, float(off[np.isfinite(off)].max(initial=0.0)))
        return worst

    def _passed(self, node: Node) -> list[OneSidedLimits]:
        """Change points through which the run is carried, where forces may grow without bound."""
        times = np.array([p.time for p in self.run.compiled.passages.every])
        inside = times[(times >= self.run.start) & (times <= self.run.stop)]
        if not inside.size:
            return []
        # Only where the expression really has no value there.
        unknown = ~np.isfinite(np.asarray(self.run.jets(node, inside).d[0]))
        sides = Sides(self.run, node, ())
        return [
            OneSidedLimits(float(t), sides.compared(float(t), -1), sides.compared(float(t), 1)) for t in inside[unknown]
        ]


@dataclass
class Probe:
    """An expression over the intervals of a window."""

    search: Search
    node: Node
    intervals: list[Interval]
    ahead: tuple[Array, Array, Array] | None = None
    """Times (s, ascending) at which values and rates are known, computed for many probes at once."""
    _means: dict[tuple[int, int], MeanValue] = field(default_factory=dict)

    @property
    def run(self) -> Run:
        """The run."""
        return self.search.run

    @property
    def stationary(self) -> Array:
        """The times (s) at which the expression turns or may have a kink, over the whole run."""
        return self.search.stationary(self.node)

    @property
    def pieces(self) -> RunPieces:
        """The run between the cuts of the expression."""
        return self.search.places.pieces[self.node]

    def values(self, t: Array) -> Array:
        """The expression at times, SI; zero where it is no more than round-off all along."""
        return np.asarray(self.jets(t).d[0])

    def jets(self, t: Array) -> Jet:
        """The expression with its rate; at few times by the program of all expressions, which is made already."""
        if self.search.is_zero(self.node):
            return Jet([np.zeros_like(t), np.zeros_like(t)])
        if self.ahead is not None:
            known, *ahead = self.ahead
            at = np.minimum(np.searchsorted(known, t), known.size - 1)
            if known.size and np.array_equal(known[at], t):
                return Jet([row[at] for row in ahead])
        if t.size > FEW:
            return self.run.jets(self.node, t)
        # The program of all signals exists already, which for few times is faster than making a new one.
        return self.run.combine(self.node, t, self.search.rows(t))

    @cached_property
    def near(self) -> float:
        """Times this near (s) are one place."""
        return 2 * ASIDE[0] * (self.run.stop - self.run.start)

    @cached_property
    def limits(self) -> list[OneSidedLimits]:
        """Places with one-sided limits inside or at an end of an interval."""
        every = self.search.limits(self.node)
        return [p for p in every if any(a - self.near <= p.time <= b + self.near for a, b in self.intervals)]

    @cached_property
    def peaks(self) -> list[Peak]:
        """Among which the extremes are: turning points, cuts, ends of the window, limits towards places."""
        run = self.run
        sharp = 4 * float(np.finfo(float).eps) * max(abs(run.start), abs(run.stop))
        found = self._peaks_at(self._candidates) + self._beside()
        for place in self.limits:
            # Limits from both sides of each place, as far as that side lies in an interval.
            for name, side, sign in (("before", place.before, -1), ("after", place.after, 1)):
                if any(
                    place.time - a > sharp if sign < 0 else b - place.time > sharp
                    for a, b in self._intervals_at(place.time)
                ):
                    found.append(Peak(side.value, place.time, name))
                # Where cancellation spoils values near a removable singularity, take the germ's values.
                for a, b in self._intervals_at(place.time) if side.removable else ():
                    s, values = side.near(place.time - a if sign < 0 else b - place.time)
                    t = place.time + sign * s
                    found += [Peak(v, at, "") for v, at in zip(values.tolist(), t.tolist(), strict=True)]
        # No value that was looked at lies outside of what is reported, but by round-off.
        known = [peak.value for peak in found if not np.isnan(peak.value)] or [0.0]
        low, high = min(known), max(known)
        slack = EQUAL * max((abs(value) for value in known if np.isfinite(value)), default=0.0)
        found += [peak for peak in self._peaks_at(self._seen) if not low - slack <= peak.value <= high + slack]
        # No limit or series leads out of what the functions of the expression can give at all.
        low, high = self._reachable
        return [peak._replace(value=float(np.clip(peak.value, low, high))) for peak in found]

    @cached_property
    def _reachable(self) -> tuple[float, float]:
        return reachable(self.run, self.node)

    def _peaks_at(self, times: Array) -> list[Peak]:
        return [Peak(value, time, "") for value, time in zip(self.values(times).tolist(), times.tolist(), strict=True)]

    @cached_property
    def _candidates(self) -> Array:
        """The times (s) of candidates: turning points and cuts inside the intervals, and the ends of these."""
        run, pieces = self.run, self.pieces
        inside = self._inside(np.concatenate([self.stationary, (pieces.before + pieces.after) / 2]))
        # Ends of the intervals, moved off jumps to the inner side.
        ends = [edge for a, b in self.intervals for edge in (inner(run, a, 1), inner(run, b, 0))]
        # Drop times near singular places: there the one-sided limits or germs stand for the values.
        return self._away(np.unique(np.concatenate([inside, ends])))

    @cached_property
    def _seen(self) -> Array:
        """The run's own samples (s), and where the outermost values of the search's grid are, as far as they count."""
        seen = self._inside(np.concatenate([self.run.t, self.search.outermost(self.node)]))
        return np.setdiff1d(self._away(seen), self._candidates)

    def _inside(self, t: Array) -> Array:
        """The times inside the intervals; of a jump, a turning point only has a side."""
        t = t[np.logical_or.reduce([(a < t) & (t < b) for a, b in self.intervals])]
        for before, after in self.run.jumps:
            t = t[~((before < t) & (t < after))]
        return t

    @cached_property
    def _sides(self) -> list[tuple[str, Array, Array]]:
        """The sides of cuts that count: which side, the times (s) there, and the middles of their cuts."""
        pieces, found = self.pieces, []
        centres = (pieces.before + pieces.after) / 2
        for name, sides in (("before", pieces.before), ("after", pieces.after)):
            kept = np.logical_or.reduce([(a < sides) & (sides < b) for a, b in self.intervals])
            kept &= np.isin(sides, self._away(sides))
            found.append((name, sides[kept], centres[kept]))
        return found

    @property
    def times(self) -> Array:
        """All times (s) at which the extremes ask for values, ascending."""
        sides = [part for _, *two in self._sides for part in two]
        return np.unique(np.concatenate([self._candidates, self._seen, *sides]))

    def _beside(self) -> list[Peak]:
        """Both sides of cuts at which the expression jumps: where it goes towards each, along its rate there."""
        found = []
        for name, t, centre in self._sides:
            if t.size:
                jet = self.jets(t)
                # Extrapolate along the rate to the cut, where a rate further on shows that it is smooth there: a
                # difference to the value in its middle is a jump.
                here, step = np.asarray(jet.d[0]), np.asarray(jet.d[1]) * (centre - t)
                with np.errstate(all="ignore"):
                    before = np.clip(2 * t - centre, self.run.start, self.run.stop)
                    straight = np.abs(here - self.values(before) - step) <= SMOOTH * np.abs(step)
                values = np.where(straight, here + step, here)
                there = self.values(centre)
                jumps = ~(np.abs(values - there) <= SAME * np.abs(values))
                for low, high in self.run.jumps:  # of a load's jump the middle doesn't count
                    jumps |= (centre > low) & (centre < high)
                found += [
                    Peak(v, at, name) for v, at in zip(values[jumps].tolist(), centre[jumps].tolist(), strict=True)
                ]
        return found

    def _intervals_at(self, time: float) -> list[Interval]:
        """The intervals in which a time lies, or at whose ends it is."""
        return [(a, b) for a, b in self.intervals if a - self.near <= time <= b + self.near]

    def _away(self, t: Array) -> Array:
        """The times at which the expression's values count: not at places with limits, nor where germs are better."""
        for place in self.limits:
            before, after = place.before.removable, place.after.removable
            off = t - place.time
            t = t[(off < -max(before, self.near)) | (off > max(after, self.near))]
        return t

    @property
    def candidates(self) -> tuple[Array, Array]:
        """Times and values among which the extremes are."""
        peaks = sorted((peak.time, peak.value) for peak in self.peaks)
        return np.array([time for time, _ in peaks]), np.array([value for _, value in peaks])

    def counting(self, t: Array) -> NDArray[np.bool_]:
        """Which times lie in the intervals, on a side of each jump, where the expression's values count."""
        inside = np.logical_or.reduce([(t >= a) & (t <= b) for a, b in self.intervals])
        for before, after in self.run.jumps:
            inside &= (t <= before) | (t >= after)
        return np.asarray(inside & np.isin(t, self._away(t)))

    def finite(self) -> bool:
        """Whether the expression has a value all over the intervals, but for places where it is unbounded."""
        pieces = self.pieces
        # Check on the grid and a few times of each interval, off the cuts and off unbounded places.
        t = pieces.grid(self.run.grid)
        t = t[~np.isin(t, np.concatenate([pieces.before, pieces.after]))]
        for a, b in self.intervals:
            t = np.concatenate([t, np.linspace(a, b, 9)])
        t = t[np.logical_or.reduce([(t >= a) & (t <= b) for a, b in self.intervals])]
        for place in self.search.limits(self.node):
            t = t[np.abs(t - place.time) > BEYOND * (self.run.stop - self.run.start)]
        return bool(np.isfinite(self.values(t)).all())

    def undecided(self) -> list[float]:
        """The times (s) at which it isn't known whether the expression is bounded."""
        return [peak.time for peak in self.peaks if np.isnan(peak.value)]

    def length(self) -> float:
        """How long the intervals are together (s)."""
        return sum(b - a for a, b in self.intervals)

    def top(self) -> Peak:
        """The largest value, the first of equals."""
        return max(self.peaks, key=lambda peak: (peak.value, -peak.time))

    def bottom(self) -> Peak:
        """The smallest value, the first of equals."""
        return min(self.peaks, key=lambda peak: (peak.value, peak.time))

    def mean(self, power: int = 1, rule: int = 0) -> MeanValue:
        """The mean of a power over the intervals, by one of two rules on nodes of its own."""
        if (power, rule) not in self._means:
            self._means[power, rule] = self._mean(power, rule)
        return self._means[power, rule]

    def _mean(self, power: int, rule: int) -> MeanValue:
        # Close to singular places the integral comes from the series, elsewhere from quadrature on panels.
        with np.errstate(invalid="ignore"):  # poles of both signs have no mean
            beside = sum(edge.integral(power) for stretch in self.stretches for edge in stretch)
        return mean(self.values, self._panels(), beside, self.length(), power, self.run.grid // 4, rule)

    def _panels(self) -> Callable[[int], list[Array]]:
        """The edges of panels on each stretch between places with one-sided limits, by the number of panels a run."""
        run, pieces = self.run, self.pieces
        # Panels also end at turning points, breaks and cuts, where the integrand is less smooth.
        turning = np.concatenate([self.stationary, run.breaks, (pieces.before + pieces.after) / 2, pieces.more])

        def edges(panels: int) -> list[Array]:
            found = []
            for a, b in self.stretches:
                count = max(4, int(np.ceil(panels * (b.time - a.time) / (run.stop - run.start))))
                inside = turning[(a.time + a.width < turning) & (turning < b.time - b.width)]
                t = np.linspace(a.time + a.width, b.time - b.width, count + 1)
                found.append(np.union1d(t, inside))
            return found

        return edges

    @cached_property
    def stretches(self) -> list[tuple[StretchEnd, StretchEnd]]:
        """The intervals cut at places with one-sided limits, the ends with what lies between them and the panels."""
        found = []
        for a, b in self.intervals:
            # Cut each interval at its places with one-sided limits; a place at an end of the interval counts for that
            # end.
            inner_places = [p for p in self.limits if a - self.near <= p.time <= b + self.near]
            marks: list[tuple[float, Side | None, Side | None]] = [(a, None, None)]
            for p in inner_places:
                if abs(p.time - a) <= self.near:
                    marks[0] = (a, None, p.after)
                elif abs(p.time - b) > self.near:
                    marks.append((p.time, p.before, p.after))
            last = next((p.before for p in inner_places if abs(p.time - b) <= self.near), None)
            marks.append((b, last, None))
            for (low, _, after), (high, before, _) in pairwise(marks):
                found.append((StretchEnd.beside(low, after, high - low), StretchEnd.beside(high, before, high - low)))
        return found


def inner(run: Run, edge: float, side: int) -> float:
    """An end of an interval, moved off a jump there to the interval's side (0 before, 1 after)."""
    return next((float(pair[side]) for pair in run.jumps if pair[0] <= edge <= pair[1]), edge)
