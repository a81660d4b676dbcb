"""A motion over a span of time: signals at any instant, with continuous angles and exact rates."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions import units as u
from linkwright.expressions.language import Call, Name, Node, is_signal, signals_in
from linkwright.expressions.units import Dimension
from linkwright.graph.rows import Named, effort
from linkwright.kernels import Compiled
from linkwright.kernels.combined import combined
from linkwright.notation import Jet, angles
from linkwright.notation.angles import MAX_TURN, whole_turns
from linkwright.results import discontinuities

Array = NDArray[np.float64]
Made = TypeVar("Made")

MAX_GRID = 1 << 18
NARROWEST = 1e-13
"""Steps of an angle narrower than this share of the run aren't halved any more."""
ROUND_OFF = 1e-12
"""What is less than this share of what is usual of its dimension is what is left of zero where terms cancel."""
BLIND = 1e-6
"""The share of the run around a change point in which rates have lost their digits."""
FORCE_SIZES = tuple(one.physical for one in (u.LENGTH, u.SPEED, u.OMEGA, u.FORCE, u.ENERGY))
TOGETHER = 1 << 13
"""Times at which expressions are evaluated at once: what they are made of is a multiple of their values."""
LOOK = 1 << 14
"""Points at which the drives' laws are looked at for short moves and rests."""


class Run:
    """A compiled mechanism over ``start`` .. ``stop`` (s), looked at on ``steps`` equal steps and in between."""

    def __init__(self, compiled: Compiled, start: float, stop: float, steps: int) -> None:
        if not isinstance(compiled, Compiled):
            raise TypeError(f"a Run is made of what linkwright.compile gives, not of {compiled!r}")
        self.compiled, self.start, self.stop, self.steps = compiled, start, stop, steps
        self.rows: dict[Named, tuple[Array, Array]] = {}
        """Rows that were looked at closely: times with all turning points, and values."""
        self.change_points: tuple[float, ...] = ()
        self.lost: set[str] = set()
        """Angles that turn too often to be followed: they are NaN."""
        self._repeating: set[str] = set()
        self._angles: dict[str, tuple[Array, Array]] = {}
        self._firsts: dict[str, tuple[Array, Array]] = {}
        self._usual: dict[Dimension, float] = {}
        self._kept: dict[object, Any] = {}

    def cached(self, key: object, make: Callable[[], Made]) -> Made:
        """What others derive of it, made once for a key."""
        if key not in self._kept:
            self._kept[key] = make()
        made: Made = self._kept[key]
        return made

    @cached_property
    def grid(self) -> int:
        """Steps for searches: the samples, and more where a drive turns far, moves and rests, or a load swings."""
        t = self._looks
        steps = [self.steps]
        for name, rate in self._drive_rates.items():
            if self.compiled.mechanism.prescribed(name).turns:
                steps.append(min(int(self.travel(name) / MAX_TURN) + 1, MAX_GRID))
            # The shortest move or rest is to be seen at some ten points. Where a drive only turns back is no rest.
            moves = rate > 1e-9 * rate.max()
            moves[:-1] |= moves[1:]
            moves[1:] |= moves[:-1]
            changes = np.flatnonzero(np.diff(moves.astype(int)))
            if changes.size:
                shortest = int(np.diff(np.concatenate([[0], changes, [LOOK]])).min(initial=LOOK, where=True))
                steps.append(min(10 * LOOK // max(shortest, 1), LOOK // 2))
        if self.compiled.graph.actions.timed:
            rows = [effort(one) for one in self.compiled.graph.actions.varying]
            signs = np.sign(self.compiled.rates(rows, t)[1])
            steps.append(min(4 * int((signs[:, 1:] != signs[:, :-1]).sum(axis=1).max()), LOOK // 2))
        return max(steps)

    @property
    def _looks(self) -> Array:
        return np.linspace(self.start, self.stop, LOOK + 1)

    @cached_property
    def _drive_rates(self) -> dict[str, Array]:
        """The magnitude of each drive's speed at times all over the run (rad/s, m/s)."""
        t, laws = self._looks, self.compiled.laws
        return {name: np.abs(np.broadcast_to(laws[name](t).d[1], t.shape)) for name in self.compiled.mechanism.movers}

    def travel(self, drive: str) -> float:
        """How far a drive travels over the run, to and fro (rad or m)."""
        return float(np.mean(self._drive_rates[drive])) * (self.stop - self.start)

    @cached_property
    def t(self) -> Array:
        """The sampled times (s), both ends included."""
        return np.linspace(self.start, self.stop, self.steps + 1)

    @cached_property
    def jumps(self) -> Array:
        """The times (s) right before and right after each jump of a load: (jumps, 2)."""
        return discontinuities.jumps(self)

    @cached_property
    def breaks(self) -> Array:
        """The times (s) at which a force may have a jump or a kink, ascending."""
        return discontinuities.breaks(self)

    def may_jump(self, node: Node) -> bool:
        """Whether an expression may jump at a join of a law: positions and velocities don't."""
        signals = (self.compiled.graph.signal(text) for text in self.signals_of([node]))
        return any(not signal.kinematic or signal.dimension.time < -1 for signal in signals)

    def evaluate(self, names: Sequence[str], t: Array) -> Array:
        """The named signals at times ``t`` (s): (names, times), SI, angles continuous over the run; NaN are reactions
        that a redundant mechanism leaves undetermined."""
        y = self.possible_rows(names, t)
        y[self.compiled.undetermined(names)] = np.nan
        return y

    def possible_rows(self, names: Sequence[str], t: Array) -> Array:
        """The same; undetermined reactions with the values of one of the states that statics allows, from which
        determined sums come out."""
        self._begin(names)
        y = self.compiled.possible_rows(names, t)
        for i, name in enumerate(names):
            if self.compiled.graph.wrapped(name):
                y[i] = self._continuous(name, t, y[i])
        return y

    def rates(self, names: Sequence[str], t: Array) -> tuple[Array, Array]:
        """The named signals and their exact time derivatives at times ``t``; NaN as in :meth:`evaluate`."""
        values, slopes = self.possible_rates(names, t)
        undetermined = self.compiled.undetermined(names)
        values[undetermined] = slopes[undetermined] = np.nan
        return values, slopes

    def possible_rates(self, names: Sequence[str], t: Array) -> tuple[Array, Array]:
        """The same, of undetermined reactions as :meth:`possible_rows`."""
        self._begin(names)
        rows = self.compiled.possible_rows(names, t, rates=True)
        values, slopes = rows[:, 0], rows[:, 1]
        for i, name in enumerate(names):
            if self.compiled.graph.wrapped(name):
                values[i] = self._continuous(name, t, values[i])
        return values, slopes

    def jets(self, node: Node, t: Array) -> Jet:
        """An expression of signals with its first time derivative, at times ``t``. The tree is bound to SI."""
        signals = self.signals_of([node])
        values, slopes = self.possible_rates(signals, t) if signals else (np.empty((0, t.size)),) * 2
        return self.combine(node, t, dict(zip(signals, zip(values, slopes, strict=True), strict=True)))

    def all_rates(self, trees: Sequence[Node], t: Array) -> tuple[Array, Array]:
        """Several such expressions and their rates: (trees, times) each."""
        names = self.signals_of(trees)
        values, slopes = np.empty((2, len(trees), t.size))
        for first in range(0, t.size, TOGETHER):
            part = slice(first, first + TOGETHER)
            some = t[part]
            rows = dict(zip(names, zip(*self.possible_rates(names, some), strict=True), strict=True))
            for i, tree in enumerate(trees):
                values[i, part], slopes[i, part] = self.combine(tree, some, rows).d
        return values, slopes

    def combine(self, node: Node, t: Array, rows: dict[str, tuple[Array, Array]]) -> Jet:
        """An expression from rows of signals and rates already at hand."""
        return combined(self.compiled, node, t, rows, 1)

    def canonical(self, node: Name | Call) -> str:
        """The canonical name of a signal."""
        return self.compiled.quantities.signals.find(node).text

    def signals_of(self, trees: Sequence[Node]) -> list[str]:
        """The canonical names of all signals in some expressions."""
        return list(dict.fromkeys(map(self.canonical, signals_in(*trees))))

    def dimension(self, name: str) -> Dimension:
        """The dimension of a signal."""
        return self.compiled.graph.signal(name).dimension

    def usual(self, dimensions: Iterable[Dimension]) -> list[float]:
        """Of each dimension the size (SI) of what cancels in an expression of it: the largest magnitude of the
        mechanism's signals of it at a few times of the run, and of moments, powers and energies at least what its
        forces make of it over its lengths and speeds."""
        asked = [dimension.physical for dimension in dimensions]
        largest = self._largest_signals(asked)
        return [max(size, self._made_by_forces(key)) for size, key in zip(largest, asked, strict=True)]

    def round_off(self, dimension: Dimension) -> float:
        """What is left of zero where terms of a dimension cancel is less than this (SI): the one scale for all that
        compares figures of two computations, or takes one for zero."""
        return ROUND_OFF * self.usual([dimension])[0]

    def _largest_signals(self, asked: Sequence[Dimension]) -> list[float]:
        """Of each dimension the largest magnitude of the signals of it at a few times of the run; 0 without one."""
        if new := {*asked} - self._usual.keys():
            self._usual.update(dict.fromkeys(new, 0.0))
            signals = [s for s in self.compiled.quantities.signals.all() if s.dimension.physical in new]
            t = np.linspace(self.start, self.stop, 17)
            values = np.abs(self.compiled.evaluate([s.text for s in signals], t)) if signals else ()
            for signal, row in zip(signals, values, strict=True):
                key = signal.dimension.physical
                self._usual[key] = max(float(row[np.isfinite(row)].max(initial=0.0)), self._usual[key])
        return [self._usual[dimension] for dimension in asked]

    def _made_by_forces(self, dimension: Dimension) -> float:
        """The size (SI) that forces, inertia forces among them, make of a dimension with the lengths and the angular
        velocities of the mechanism; 0 of one that isn't linear in forces. Where links balance, their inertia forces
        cancel, so that no signal of a force tells of them: these are of the size of energies over lengths."""
        if dimension.mass != 1:
            return 0.0
        length, speed, turning, force, energy = self._largest_signals(FORCE_SIZES)
        if length == 0.0:
            return 0.0
        rate, force = max(turning, speed / length), max(force, energy / length)
        exponent = -(float(dimension.time) + 2.0)  # of the rate: none for a moment, 1 for a power
        if rate == 0.0 and exponent:
            return 0.0
        return float(force * length ** (float(dimension.length) - 1.0) * (rate**exponent if exponent else 1.0))

    def cancelling(self, node: Node) -> float:
        """The size (SI) of what cancels in a signal that is round-off, such as the angle of a level platform; 0 of
        other expressions."""
        if not is_signal(node):
            return 0.0
        (name,) = self.signals_of([node])
        return self.usual([self.dimension(name)])[0]

    def _continuous(self, name: str, t: Array, wrapped: Array) -> Array:
        """Add whole turns so that the angle runs on without jumps from its value at the start of the run."""
        if name not in self._angles:
            self._angles[name] = self._track(name)
        grid, angle = self._angles[name]
        if not grid.size:
            return np.full_like(wrapped, np.nan)
        if name in self._repeating:
            length = grid[-1] - grid[0]
            whole = np.floor((t - grid[0]) / length)
            near = np.interp(t - whole * length, grid, angle) + whole * (angle[-1] - angle[0])
        else:
            near = np.interp(t, grid, angle)
        return wrapped + 2 * np.pi * whole_turns(wrapped, near)

    def place(self, share: Array) -> tuple[Array, Array]:
        """The times at some shares (0..1) of the run, and their slopes: what searches take equal steps of."""
        return self.start + share * (self.stop - self.start), np.full_like(share, self.stop - self.start)

    def clear(self, t: Array, width: float = BLIND) -> NDArray[np.bool_]:
        """Which times are away from the known change points, so that rates have a meaning there."""
        away = np.full(t.shape, True)
        for time in self.change_points:
            away &= np.abs(t - time) > width * (self.stop - self.start)
        return away

    def _track(self, name: str) -> tuple[Array, Array]:
        """The continuous angle on a grid fine enough that no step turns further than :data:`MAX_TURN`; over one turn of
        the drive where a run with very many turns repeats itself."""
        if (grid := self._unwrapped_angle(name, 1.0)) is not None:
            return grid
        if (turn := self._turn_of_drive()) is not None:
            share = turn / (self.stop - self.start)
            if (grid := self._unwrapped_angle(name, share)) is not None:
                self._repeating.add(name)
                return grid
        self.lost.add(name)
        return np.empty(0), np.empty(0)

    def _turn_of_drive(self) -> float | None:
        """How long (s) the only drive that moves takes for a turn, at constant speed; ``None`` otherwise."""
        if self.compiled.followers or self.compiled.passages.every:
            return None
        t, turning = np.linspace(self.start, self.stop, 17), []
        for name, law in self.compiled.laws.items():
            rates = [np.broadcast_to(d, t.shape) for d in law(t).d[1:3]]
            if rates[0].any() or rates[1].any():
                if rates[1].any() or np.ptp(rates[0]) or not self.compiled.mechanism.prescribed(name).turns:
                    return None
                turning.append(2 * np.pi / abs(float(rates[0][0])))
        return turning[0] if len(turning) == 1 and turning[0] < self.stop - self.start else None

    def _begin(self, names: Sequence[str]) -> None:
        """The angles and velocities on the first grid of all angles to be followed: computed at once, as links share
        most of what leads to them."""
        if new := [name for name in names if self.compiled.graph.wrapped(name) and name not in self._angles]:
            grid, _ = self.place(self._shares(1.0))
            rows = self.compiled.evaluate([*new, *map(_rate, new)], grid)
            self._firsts.update((name, (rows[i], rows[len(new) + i])) for i, name in enumerate(new))

    def _shares(self, part: float) -> Array:
        """The grid over the first ``part`` of the run that an angle is followed on first."""
        return np.linspace(0.0, part, max(self.steps, 64) + 1)

    def _unwrapped_angle(self, name: str, part: float) -> tuple[Array, Array] | None:
        """The continuous angle over the first ``part`` of the run, on a grid that is halved where a step turns too far;
        ``None`` where it turns too often."""
        names = [name, _rate(name)]
        share = self._shares(part)
        grid, slope = self.place(share)
        first = self._firsts.pop(name, None) if part == 1.0 else None
        angle, omega = self.compiled.evaluate(names, grid) if first is None else first
        known_before = -1
        while True:
            known = np.isfinite(angle) & np.isfinite(omega) & self.clear(grid)
            share, grid, angle, omega, slope = (row[known] for row in (share, grid, angle, omega, slope))
            if not grid.size:
                return grid, angle
            rate = omega * slope
            far = np.abs(np.diff(share) * (rate[1:] + rate[:-1]) / 2)
            wide = np.flatnonzero((far >= MAX_TURN) & (np.diff(share) > NARROWEST * part))
            if not wide.size or share.size == known_before:  # what lies between can't be followed
                turned, _ = angles.steps(share, angle, rate)
                return grid, np.concatenate([angle[:1], angle[:1] + np.cumsum(turned)])
            if far.sum() / MAX_TURN > MAX_GRID or share.size > MAX_GRID:
                return None
            known_before = share.size
            middle = (share[wide] + share[wide + 1]) / 2
            more, steepness = self.place(middle)
            own = self.compiled.evaluate(names, more)
            order = np.argsort(np.concatenate([share, middle]), kind="stable")
            pairs = ((share, middle), (grid, more), (angle, own[0]), (omega, own[1]), (slope, steepness))
            share, grid, angle, omega, slope = (np.concatenate(pair)[order] for pair in pairs)


def _rate(angle: str) -> str:
    """The signal that is the rate of an angle."""
    return angle.replace(".angle", ".omega")
