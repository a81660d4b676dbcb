"""Sweeps: one drive of a mechanism moves through its values at unit speed while all others hold still."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels import Compiled
from linkwright.kernels.continuation import Continuation
from linkwright.kernels.followers import recomposed
from linkwright.kernels.law import DriveLaw
from linkwright.kernels.laws import constant_acceleration, values_at
from linkwright.notation.angles import whole_turns
from linkwright.results import Run
from linkwright.structure import Group

Array = NDArray[np.float64]

NEAR = 1e-6
"""The share of a sweep at its end in which a slide that runs away leaves few digits."""
FAR = 1e4
"""A slide that is out so many times the mechanism's size where its path ends has run away."""
FOLD = 2e-4, 0.01
"""Signals at an end where a higher group folds come from poses between these shares of the sweep away from it ..."""
FOLD_POINTS, FOLD_DEGREE = 24, 10
"""... by polynomials of this degree."""
EDGE = 0.02
"""How far a search looks past an end at which the motion may go on, so that a root right there is found."""


class _BothWays(Continuation):
    """A higher group followed from the start pose up and down: below it stand the poses of the same sweep run
    backwards."""

    def __init__(self, up: Continuation, down: Compiled, place: int) -> None:
        self.__dict__.update(up.__dict__)
        self.down, self.place = down, place

    def solve(self, x: Array, t: Array, p: Array, at: Any) -> Array:
        found = np.empty((self.n, t.size))
        below = t < 0
        if not below.all():
            found[:, ~below] = super().solve(x[:, ~below], t[~below], p, at)
        if below.any():
            found[:, below] = self.down.inputs(-t[below], higher_groups=self.place + 1)[self.rows]
        return found

    def followed_ends(self) -> tuple[tuple[float, bool], ...]:
        """How far the higher group could be followed down and up so far, infinite where it could all the way; and
        whether a slide ran away there."""
        paths = self.down.followers[self.place].path, self.path
        return tuple(
            (sign * np.inf, False) if path.end is None else (sign * path.end, self.out(path.u[-1]) > FAR)
            for sign, path in zip((-1.0, 1.0), paths, strict=True)
        )

    def out(self, u: Array) -> float:
        """How far the slides are out, over the mechanism's size."""
        return float(np.abs(u * self.slides / self.scale).max())


def sweeping(compiled: Compiled, drive: str) -> Compiled:
    """The mechanism with one drive at unit speed (1 rad/s or 1 m/s), at its start value at time 0; others rest."""
    values = values_at(compiled.laws, 0.0)

    def laws(speed: float) -> dict[str, DriveLaw]:
        alone = {name: constant_acceleration(value, speed * (name == drive)) for name, value in values.items()}
        return recomposed(compiled.laws, alone)

    up = replace(compiled, laws=laws(1.0))
    if up.followers:
        down = replace(compiled, laws=laws(-1.0))
        up.followers = [_BothWays(follower, down, i) for i, follower in enumerate(up.followers)]
    return up


def higher_group_ends(compiled: Compiled, low: float, high: float) -> list[tuple[tuple[float, bool], ...]]:
    """How far down and up each higher group of a sweep can be followed between two times; see
    ``_BothWays.followed_ends``."""
    for end in (low, high):
        compiled.inputs(np.array([end]))
    return [follower.followed_ends() for follower in compiled.followers if isinstance(follower, _BothWays)]


class Stop(NamedTuple):
    """Why a mechanism stops at an end of a sweep: the dyad whose two modes meet there, or a slide that runs away."""

    dyad: Group | None = None
    pole: bool = False


class Sweep(Run):
    """A stretch of a sweep. Its times are the drive's value less that at the start of the motion (rad or m).

    ``stops`` says why the mechanism stops at the low and high end, where it does. Towards such an end rates grow like
    1/sqrt, so equal shares of the sweep are taken in the cosine of an angle, over which everything is smooth.
    """

    def __init__(
        self, compiled: Compiled, drive: str, start: float, stop: float, steps: int, stops: tuple[Stop | None, ...]
    ) -> None:
        super().__init__(compiled, start, stop, steps)
        self.drive, self.stops = drive, stops
        self.dead = tuple(end is not None for end in stops)
        self.origin = values_at(compiled.laws, 0.0)[drive]

    def on(self, steps: int) -> Sweep:
        """The same stretch on other steps."""
        return Sweep(self.compiled, self.drive, self.start, self.stop, steps, self.stops)

    def place(self, share: Array) -> tuple[Array, Array]:
        length = self.stop - self.start
        if not any(self.dead):
            return super().place(share)
        if all(self.dead):
            way, slope = (1 - np.cos(np.pi * share)) / 2, np.pi / 2 * np.sin(np.pi * share)
        elif self.dead[0]:
            way, slope = 1 - np.cos(np.pi / 2 * share), np.pi / 2 * np.sin(np.pi / 2 * share)
        else:
            way, slope = np.sin(np.pi / 2 * share), np.pi / 2 * np.cos(np.pi / 2 * share)
        return self.start + length * way, length * slope

    @property
    def looked(self) -> tuple[float, float]:
        """The shares between which a search looks: a little past an end that isn't dead."""
        low, high = (0.0 if dead else EDGE for dead in self.dead)
        return -low, 1.0 + high

    def regular(self, t: Array) -> NDArray[np.bool_]:
        """Which times are away from ends at which a slide runs away: what hangs on it has few digits left there."""
        tiny, kept = NEAR * (self.stop - self.start), np.full(t.shape, True)
        for edge, end in zip((self.start, self.stop), self.stops, strict=True):
            if end is not None and end.pole:
                kept &= np.abs(t - edge) > tiny
        return kept

    def settled(self, names: Sequence[str], side: int) -> Array:
        """Signals at the low (0) or high (1) end. Where a dyad's two modes meet their mean is taken: one of them is
        off by the root of the round-off, the other by as much the other way."""
        time = np.array([(self.start, self.stop)[side]])
        values, end, assembly = self.evaluate(names, time), self.stops[side], self.compiled.assembly
        if end is not None and not end.pole and (end.dyad is None or self.compiled.followers):
            return self._folded(names, side, values)
        if end is None or end.dyad is None:
            return values
        branches = {**assembly.branches, end.dyad: -assembly.branches[end.dyad]}
        other = replace(self.compiled, assembly=replace(assembly, branches=branches)).evaluate(names, time)
        turning = [self.compiled.graph.wrapped(name) for name in names]
        other[turning] += 2 * np.pi * whole_turns(other[turning], values[turning])
        return np.asarray((values + other) / 2)

    def _folded(self, names: Sequence[str], side: int, known: Array) -> Array:
        """Signals at an end where a higher group folds, which is known to some 1e-9 of the sweep: signals lose the root
        of that. Over a coordinate that moves on at the end, the drive's value has its extreme there, and all signals
        are smooth; ``known`` where none does so."""
        length, inward = self.stop - self.start, 1.0 - 2.0 * side
        edge = (self.start, self.stop)[side]
        # Chebyshev points of the root of the distance from the end, away from where the group loses digits.
        low, high = (np.sqrt(share * length) for share in FOLD)
        points = np.cos(np.pi * (np.arange(FOLD_POINTS) + 0.5) / FOLD_POINTS)
        distance = ((high + low) / 2 - (high - low) / 2 * points) ** 2
        t = np.asarray(edge + inward * distance)
        poses, rows = self.compiled.evaluate(self.compiled.graph.pose_rows, t), self.evaluate(names, t)
        sizes = np.tile([self.compiled.assembly.size()] * 2 + [1.0] * 2, len(poses) // 4)
        guide = poses[int(np.argmax(np.abs(poses[:, 1] - poses[:, 0]) / sizes))]
        steps = np.sign(np.diff(guide))
        if not np.isfinite(rows).all() or steps[0] == 0 or (steps != steps[0]).any():
            return known
        # Where the distance has its minimum over the guiding coordinate the mechanism folds.
        share = (guide - guide[0]) / (guide[-1] - guide[0])
        slope = np.polynomial.Chebyshev.fit(share, distance, FOLD_DEGREE).deriv()
        roots = np.asarray(slope.roots(), dtype=np.complex128)
        near_end = (np.abs(roots.imag) < 1e-6) & (roots.real > -1.0) & (roots.real <= share[1])
        bottom = roots.real[near_end]
        if not bottom.size:
            return known
        limits = [np.polynomial.Chebyshev.fit(share, row, FOLD_DEGREE)(bottom.max()) for row in rows]
        return np.array(limits)[:, None]

    def _track(self, name: str) -> tuple[Array, Array]:
        """Angles are those of the motion's start where the sweep holds it, not those of the sweep's own start."""
        grid, angle = super()._track(name)
        if grid.size and self.start <= 0.0 <= self.stop:
            here = float(self.compiled.evaluate([name], np.zeros(1))[0, 0])
            angle = angle - 2 * np.pi * np.round((np.interp(0.0, grid, angle) - here) / (2 * np.pi))
        return grid, angle
