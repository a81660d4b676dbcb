"""What happens to signals and dyads over a run: extremes, limit positions, strokes, change points, transmission
angles."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Node
from linkwright.expressions.units import Dimension
from linkwright.graph.rows import Apart, Determinant, change_rows
from linkwright.measures.features import features
from linkwright.measures.probe import OneSidedLimits, Search
from linkwright.results import Run
from linkwright.results.run import BLIND
from linkwright.results.stationary import NOISE, magnitude, stationary
from linkwright.studies.assembly_checks import TOUCH
from linkwright.studies.drive_sweep import NEAR, Sweep

Array = NDArray[np.float64]
Signals = Mapping[str, tuple[Node, Dimension]]
"""Expressions of signals as written, with their trees bound to SI and their dimensions."""

SAME = 1e-9
"""Places closer than this share of the run are one."""
CAP = 1e4
"""Values and rates are looked at up to so many times their usual size."""
NEARER = 1e-10
"""The share of the run inside a dead end at which a signal that grows without limit is over that at ``NEAR`` ..."""
RUNS = 1e3
"""A signal that is so many times its usual size at ``NEAR`` runs away with a slide."""
GROWS = 50.0
"""... by this factor: 1/sqrt(t) grows by 100."""


VAGUE = 1e-5
"""Where the margin of a higher group is below this, the last digits of the dimensions decide where its
links are: what turns there says nothing of the mechanism."""
STANDS = 1e-11
"""A signal that changes by less than this share of its size stays the same but for round-off."""
NEXT = 1e-3
"""An end of a run is near where it is within this share of it."""
BESIDE = 1e-4
"""Limits are taken from values at multiples of this share of the run from a place ..."""
EXTRAPOLATE = np.array([4.0, -6.0, 4.0, -1.0])
"""... with these weights: a cubic through four of them."""
FOLDED = 1e-9
"""Where a higher group folds, values below this share of the usual ones are zero."""
PROPORTIONAL = 0.2
"""A rate at twice a distance over that at once, less than this from 2, is in proportion to the distance."""


@dataclass(frozen=True)
class SignalExtreme:
    """A value (SI; infinite where the signal grows without limit) and the time of the run where it is reached."""

    value: float
    time: float


@dataclass(frozen=True)
class Reversal:
    """A limit position: where a signal's rate passes through zero. ``top`` where it was rising before."""

    value: float
    time: float
    top: bool


@dataclass(frozen=True)
class Strokes:
    """Ways of the drive (rad) for the rising and the falling stroke of an output, and their ratio."""

    rising: float
    falling: float

    @property
    def ratio(self) -> float:
        """The time ratio at constant speed: the slower stroke over the faster one."""
        return max(self.rising, self.falling) / min(self.rising, self.falling)


@dataclass(frozen=True)
class SignalCourse:
    """One signal over a run: its extremes, its limit positions, whole turns, the strokes between two of them."""

    signal: str
    dimension: Dimension
    low: SignalExtreme
    high: SignalExtreme
    reversals: tuple[Reversal, ...]
    turns: int = 0
    strokes: Strokes | None = None

    @property
    def stroke(self) -> float:
        """Largest less smallest value: stroke or swing."""
        return self.high.value - self.low.value


@dataclass(frozen=True)
class Transmission:
    """A dyad's least transmission angle (rad, 0 to a right angle) and its time; none where it stays the same."""

    group: str
    signature: str
    angle: float
    time: float | None


@dataclass(frozen=True)
class ModeChange:
    """A change point: the two assembly modes of a group meet at a time."""

    group: str
    time: float


def turning(
    run: Run, rates: Callable[[Array], tuple[Array, Array]], scales: Sequence[float] | None = None
) -> list[Array]:
    """The times at which each row's rate changes sign, also at ends where the motion may go on, but not where a
    change point may give it a kink; ``scales`` as for :func:`stationary`."""
    low, high = run.looked if isinstance(run, Sweep) else (0.0, 1.0)

    def scaled(share: Array) -> tuple[Array, Array]:
        t, slope = run.place(share)
        values, slopes = rates(t)
        return values, np.where(run.clear(t), slopes * slope, np.nan)

    def capped(share: Array) -> tuple[Array, Array]:
        """What grows without limit towards an end would make all else look like round-off."""
        values, slopes = scaled(share)
        return np.clip(values, -caps[0], caps[0]), np.clip(slopes, -caps[1], caps[1])

    with np.errstate(all="ignore"):
        caps = [CAP * _usual(rows) for rows in scaled(np.linspace(0.0, 1.0, 258)[1:-1])]
        found = stationary(capped, low, high, run.grid, scales)
    tiny = SAME * (run.stop - run.start)
    kept = []
    for shares in found:
        t = run.place(shares)[0]
        inside = t[(t >= run.start - tiny) & (t <= run.stop + tiny) & run.clear(t, 3 * BLIND)]
        if isinstance(run, Sweep):
            inside = inside[run.regular(inside)]
        kept.append(np.unique(np.clip(inside, run.start, run.stop)))
    return kept


def _usual(rows: Array) -> Array:
    """The usual magnitude of each row: (rows, 1)."""
    known = [np.abs(row[np.isfinite(row) & (row != 0)]) for row in rows]
    return np.array([[float(np.median(row)) if row.size else np.inf] for row in known])


def touches(run: Run) -> list[ModeChange]:
    """The change points of a run: where the reach of a group touches zero, or its two outer pins meet; and those
    through which it is carried."""
    rows, passages = change_rows(run.compiled.structure), run.compiled.passages
    if not rows:
        return []
    found = [ModeChange(group, p.time) for p in passages.every for group in p.groups if run.start <= p.time <= run.stop]
    places = turning(run, partial(run.compiled.rates, rows))
    usual = np.abs(run.compiled.evaluate(rows, run.place(np.linspace(0, 1, 65))[0])).max(axis=1)
    for row, times, size in zip(rows, places, usual, strict=True):
        times = times[passages.outside(times, row.group)]
        values = np.abs(run.compiled.evaluate([row], times)[0])
        meet = values <= TOUCH * (size if isinstance(row, Apart) else 1.0)
        found += [ModeChange(row.group, float(time)) for time in times[meet]]
    return sorted(found, key=lambda change: change.time)


def transmission(run: Run, flat: Sequence[tuple[str, float]] = ()) -> list[Transmission]:
    """The least transmission angle of each dyad. ``flat``: groups known to be stretched or folded, and when."""
    groups = run.compiled.structure.groups
    names = [Determinant(group.label) for group in groups]
    if not names:
        return []

    def rates(t: Array) -> tuple[Array, Array]:
        return magnitude(*run.compiled.rates(names, t))

    found = []
    places = [np.concatenate([times, [run.start, run.stop]]) for times in turning(run, rates)]
    every = np.unique(np.concatenate(places))
    values = run.compiled.evaluate(names, every)
    for i, (group, times) in enumerate(zip(groups, places, strict=True)):
        sines = np.minimum(np.abs(values[i, np.searchsorted(every, times)]), 1.0)
        ends = [time for label, time in flat if label == group.label]
        times, sines = np.concatenate([times, ends]), np.concatenate([sines, np.zeros(len(ends))])
        known = np.isfinite(sines)
        times, sines = times[known], sines[known]
        if sines.size:
            least = int(np.argmin(sines))
            moves = np.ptp(sines) > 1e-12
            time = float(times[least]) if moves else None
            found.append(Transmission(group.label, group.signature, float(np.arcsin(sines[least])), time))
    return found


def courses(run: Run, signals: Signals, full: bool = False, forward: bool = True) -> list[SignalCourse]:
    """What each signal does over a run. ``full``: its ends are one pose; ``forward``: the drive's value rises."""
    if not signals:
        return []
    trees = [node for node, _ in signals.values()]
    with np.errstate(all="ignore"):
        # At unit speed of the drive, rates are of the size of what moves.
        size = run.compiled.graph.size
        scales = [size**d.length if d.mass == 0 else 0.0 for _, d in signals.values()]
        places = [_definite(run, times) for times in turning(run, partial(run.all_rates, trees), scales)]
        broken = Search(run, [tree for tree in trees if features(tree, run.compiled.quantities.signals.find)])
        found = []
        for (name, (node, dimension)), times in zip(signals.items(), places, strict=True):
            limits = broken.limits(node) if node in broken.trees else []
            found.append(_Course(run, node, times, full, forward, limits).read(name, dimension))
    return found


def _definite(run: Run, times: Array) -> Array:
    """The times at which no higher group is vague."""
    rows = [Determinant(group.label) for group in run.compiled.structure.higher_groups]
    if not rows or not times.size:
        return times
    return np.asarray(times[(np.abs(run.compiled.evaluate(rows, times)) > VAGUE).all(axis=0)])


@dataclass
class _Course:
    run: Run
    node: Node
    times: Array
    full: bool
    forward: bool
    limits: list[OneSidedLimits]

    def __post_init__(self) -> None:
        near = 1e-10 * (self.run.stop - self.run.start)
        for place in self.limits:
            self.times = self.times[np.abs(self.times - place.time) > near]

    def values(self, t: Array) -> Array:
        return np.array(self.run.jets(self.node, t).d[0])

    @cached_property
    def usual(self) -> float:
        """The largest finite magnitude at a few times all over the run."""
        values = np.abs(self.values(self.run.place(np.linspace(0.0, 1.0, 33))[0]))
        return float(values[np.isfinite(values)].max(initial=0.0))

    def read(self, name: str, dimension: Dimension) -> SignalCourse:
        run = self.run
        inner = self.values(self.times)
        ends = self.values(np.array([run.start, run.stop]))
        if isinstance(run, Sweep):
            for side in (0, 1):
                if run.dead[side]:
                    ends[side] = self.limit(run, side)
        seams, at_seams = self.seams()
        times = np.concatenate([self.times, [run.start, run.stop], seams, *([p.time, p.time] for p in self.limits)])
        sides = [[p.before.value, p.after.value] for p in self.limits]
        values = np.concatenate([inner, ends, at_seams, *sides])
        known = ~np.isnan(values)
        times, values = times[known], values[known]
        if not values.size:
            nowhere = SignalExtreme(float("nan"), run.start)
            return SignalCourse(name, dimension, nowhere, nowhere, ())
        low, high = (int(pick(values)) for pick in (np.argmin, np.argmax))
        reversals = self.reversals(inner) if dimension.time == 0 else ()  # a rate has no limit positions
        if dimension.time == 0 and not isinstance(run, Sweep):
            reversals = self.with_ends(reversals)
        turns = round(float(ends[1] - ends[0]) / (2 * np.pi)) if self.full and np.isfinite(ends).all() else 0
        turns = turns if dimension.angle == 1 and dimension.physical == Dimension() else 0
        return SignalCourse(
            name,
            dimension,
            SignalExtreme(float(values[low]), float(times[low])),
            SignalExtreme(float(values[high]), float(times[high])),
            reversals,
            turns,
            None if turns else self.strokes(reversals),
        )

    def seams(self) -> tuple[Array, Array]:
        """Times of the change points and the limits of the value from both sides, as far as the run goes there."""
        run = self.run
        times, limits = [], []
        for time in run.change_points:
            for side in (-1.0, 1.0):
                t = np.asarray(time + side * BESIDE * (run.stop - run.start) * np.arange(1, EXTRAPOLATE.size + 1))
                if run.start <= t[-1] <= run.stop:
                    times.append(time)
                    values = self.values(t)
                    limit = float(EXTRAPOLATE @ values)
                    limits.append(0.0 if abs(limit) < STANDS * self.usual else limit)
        return np.array(times), np.array(limits)

    def limit(self, run: Sweep, side: int) -> float:
        """The value at a dead end; infinite where it grows without limit towards it."""
        length = run.stop - run.start
        inside = np.array([NEAR, NEARER, *np.linspace(0.1, 0.9, 9)]) * length
        near, nearer, *rest = self.values(run.start + inside if side == 0 else run.stop - inside).tolist()
        usual, stop = max(map(abs, rest)), run.stops[side]
        if abs(nearer) > GROWS * max(abs(near), usual):
            return float(np.copysign(np.inf, nearer))
        if stop is not None and stop.pole:
            return float(np.copysign(np.inf, near)) if abs(near) > RUNS * usual else near
        names = run.signals_of([self.node])
        time = np.array([(run.start, run.stop)[side]])
        rows = {name: (row, np.zeros(1)) for name, row in zip(names, run.settled(names, side), strict=True)}
        value = float(run.combine(self.node, time, rows).d[0][0])
        if stop is not None and stop.dyad is None and abs(value) < FOLDED * usual:
            return 0.0
        return value if np.isfinite(value) else nearer

    def reversals(self, values: Array) -> tuple[Reversal, ...]:
        """Where the signal turns round; once for the two ends of a full turn. Where it stays the same but for round-off
        it doesn't turn."""
        run, length = self.run, self.run.stop - self.run.start
        found: list[Reversal] = []
        for time, value in zip(self.times.tolist(), values.tolist(), strict=True):
            if self.full and run.stop - time < SAME * length and found and found[0].time - run.start < SAME * length:
                continue
            beside = [self.beside(time, side) for side in (-1.0, 1.0)]
            known = [place for place in beside if place is not None]
            aside = self.values(np.array(known)) - value
            if not (np.abs(aside) <= STANDS * self.usual).any():
                before = beside[0] if beside[0] is not None else (run.start + time) / 2
                found.append(Reversal(value, time, float(self.values(np.array([before]))[0]) < value))
        return tuple(found)

    def beside(self, time: float, side: float) -> float | None:
        """A time before (``side`` -1) or after (1) a turning point: half way to the next turning point, change point or
        end; ``None`` where an end is so near that the value hardly changes up to it."""
        run, length = self.run, self.run.stop - self.run.start
        places = np.concatenate([self.times, run.change_points])
        ahead = side * (places - time)
        ahead = ahead[ahead > SAME * length]
        if ahead.size:
            return time + side * float(ahead.min()) / 2
        end = run.start if side < 0 else run.stop
        if abs(end - time) > NEXT * length:
            return (end + time) / 2
        passable = isinstance(run, Sweep) and not run.dead[int(side > 0)]
        return time + side * NEXT * length if passable else None

    def with_ends(self, reversals: tuple[Reversal, ...]) -> tuple[Reversal, ...]:
        """The reversals of a motion with those right at its start and end: there a drive moves, the signal's rate
        vanishes and grows in proportion to the time from there, so that it changes sign. Where the motion ends in the
        pose in which it starts, one of both."""
        run, ends = self.run, []
        for edge, inward in ((run.start, 1.0), (run.stop, -1.0)):
            near = np.asarray(edge + inward * BESIDE * (run.stop - run.start) * np.arange(3))
            jet = run.jets(self.node, near)
            rate = np.asarray(jet.d[1])
            largest = float(np.abs(run.jets(self.node, run.t).d[1]).max(initial=0.0))
            drives = [abs(float(np.broadcast_to(law(near[:1]).d[1], (1,))[0])) for law in run.compiled.laws.values()]
            still = abs(rate[0]) <= NOISE * largest < abs(rate[1]) and max(drives) > 0
            if still and abs(rate[2] / rate[1] - 2.0) < PROPORTIONAL and run.clear(near[:1]).all():
                ends.append(Reversal(float(jet.d[0][0]), edge, bool(inward * rate[1] < 0)))
        tiny = SAME * (run.stop - run.start)
        inner = tuple(r for r in reversals if run.start + tiny < r.time < run.stop - tiny)
        first = tuple(end for end in ends if end.time == run.start)
        last = tuple(end for end in ends if end.time == run.stop and not (first and self.returns()))
        return (*first, *inner, *last)

    def returns(self) -> bool:
        """Whether the motion ends in the pose in which it starts."""
        run = self.run
        poses = run.compiled.evaluate(run.compiled.graph.pose_rows, np.array([run.start, run.stop]))
        return bool(np.abs(poses[:, 1] - poses[:, 0]).max() < 1e-6 * max(run.compiled.assembly.size(), 1.0))

    def strokes(self, reversals: tuple[Reversal, ...]) -> Strokes | None:
        """The two strokes of an output that turns round twice in a full turn of the drive."""
        tops = [r.time for r in reversals if r.top]
        bottoms = [r.time for r in reversals if not r.top]
        if not self.full or len(tops) != 1 or len(bottoms) != 1:
            return None
        up = (tops[0] - bottoms[0]) % (2 * np.pi)
        rising = up if self.forward else 2 * np.pi - up
        return Strokes(rising, 2 * np.pi - rising)
