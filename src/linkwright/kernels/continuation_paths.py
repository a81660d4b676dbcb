"""Paths of the higher groups of many samples: poses that each lays by steps of its own, with the rates there, close
enough for their cubic interpolation to foretell every pose between.

A path goes as far as steps of a fair length lead; what needs shorter ones is left to
:mod:`linkwright.kernels.continuation_batch`. Its poses depend on the sample and the span alone, whatever times are
asked for one after the other.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels.continuation import CLOSE, PATIENCE, SURE
from linkwright.kernels.registry import Kernel

Array = NDArray[np.float64]
Index = NDArray[np.intp]
Place = Callable[[Index, Array], tuple[Array, Array]]
"""Of some samples, each somewhere on its way: the inputs (inputs, samples) and parameters (parameters, samples)."""

NEAR = CLOSE / 10
"""The most by which a step of a path may differ from the mean of the rates at its ends, and a pose between from the
interpolation (rad, or lengths over the size)."""
STRIDE = 0.5
"""The most that a step may move a coordinate (rad, or lengths over the size)."""
FIRST, LONGEST, SHORTEST = 2.0**-8, 2.0**-5, 2.0**-24
"""Steps over the span: the first one, and the limits of all."""
RIM = 2.0**-18
"""How far past a path's last pose, over the span, it is looked whether shorter steps lead on."""
GROWTH = (0.02, 3.0), (0.1, 1.7), (0.3, 1.2), (1.0, 1.0)
"""How a step grows while its error, over what is allowed, is under a limit: errors go with the cube of the step."""


class Solver(Protocol):
    """Newton on the higher groups: the inputs' ``rows`` of their coordinates, and the kernel of the rates of these."""

    rows: list[int]
    motion: Kernel

    def solve(self, x: Array, p: Array, near: float) -> tuple[Array, NDArray[np.bool_]]:
        """The coordinates, (coordinates, poses), by Newton from inputs in which starts stand; they replace these. And
        which poses are certified, of those that Newton moved by less than ``near`` by their sign alone."""

    def largest_step(self, step: Array, u: Array) -> Array:
        """The largest step of a pose's coordinates: (...) of (coordinates, ...), in rad or over the size."""

    def advance_to(self, place: Place, u: Array, now: Array, targets: Array, least: Array) -> Array:
        """The coordinates at targets by steps of any length, as ``Pursuit.advance_to`` has them."""


class SamplePaths:
    """The paths from coordinates ``start`` (coordinates, samples) at t = 0; steps are measured by ``span`` (s)."""

    def __init__(self, solver: Solver, place: Place, start: Array, span: float) -> None:
        self.solver, self.place, self.span = solver, place, span
        n, samples = start.shape
        self.t = np.full((samples, 64), np.inf)
        self.u, self.rate = np.full((2, n, samples, 64), np.nan)
        self.last = np.zeros(samples, dtype=np.intp)  # of each sample, its last pose laid
        self.t[:, 0], self.u[..., 0] = 0.0, start
        self.rate[..., 0] = self._solved(np.arange(samples), np.zeros(samples), start)[2]
        self.bend = np.zeros_like(start)  # half the rate of the rates
        self.step = np.full(samples, FIRST * span)
        known = np.isfinite(start).all(axis=0)
        self.end = np.where(known, np.inf, -np.inf)  # from there on no steps lead, however short
        self.open = known & np.isfinite(self.rate[..., 0]).all(axis=0) & (span > 0)

    def _solved(self, which: Index, t: Array, guess: Array) -> tuple[Array, NDArray[np.bool_], Array]:
        """The coordinates of some samples at a time each, which of them are certified, and their rates."""
        x, p = self.place(which, t)
        x[self.solver.rows] = guess
        return *self.solver.solve(x, p, SURE), self.solver.motion.run(x, p)

    def extend(self, to: Array) -> None:
        """Lay the paths past times ``to`` (samples,), as far as they go."""
        # Take steps with all samples that have not reached their time yet; each has its own step length.
        open_ = self.open.copy()
        while True:
            here = self.t[np.arange(len(self.t)), self.last]
            todo = np.flatnonzero(self.open & (here <= to))
            if not todo.size:
                break
            self._advance(todo, here[todo])
        # A path that stopped because its steps became too short: try to get a little past its last pose with steps of
        # any length. If that fails the motion really ends there; else later times are left to step-by-step
        # continuation.
        if (stuck := np.flatnonzero(open_ & ~self.open)).size:
            goal = here[stuck] + RIM * self.span
            least = np.full(stuck.size, PATIENCE * self.span)
            u = self.u[:, stuck, self.last[stuck]]
            reached = self.solver.advance_to(self._place_of(stuck), u, here[stuck], goal[:, None], least)
            self.end[stuck] = np.where(np.isnan(reached[0, :, 0]), goal, np.inf)

    def _place_of(self, some: Index) -> Place:
        """The place of samples that are counted among some."""
        return lambda which, t: self.place(some[which], t)

    def _advance(self, todo: Index, here: Array) -> None:
        """One step of some samples that stand at ``here``, as far as it is good."""
        last, step = self.last[todo], self.step[todo]
        u, rate = self.u[:, todo, last], self.rate[:, todo, last]
        # Predictor of second order: rates and half their rate of change, estimated over the last step.
        there, guess = here + step, u + step * (rate + step * self.bend[:, todo])
        found, sure, ending = self._solved(todo, there, guess)
        moved = self.solver.largest_step
        # Three errors over what is allowed: the correction by Newton, the length of the step, and how far the step
        # differs from the trapezoidal rule. The last one measures the error of the cubic interpolation.
        off = moved(found - guess, found) / CLOSE
        off = np.maximum(off, moved(found - u, found) / STRIDE)
        off = np.maximum(off, moved(found - u - step * (rate + ending) / 2, found) / NEAR)
        off[~sure] = np.inf
        # Append accepted poses to the paths of their samples, with the rates there.
        good = np.flatnonzero(off < 1)
        met, place = todo[good], last[good] + 1
        if place.max(initial=0) >= self.t.shape[1]:
            self._widen()
        self.t[met, place] = there[good]
        self.u[:, met, place], self.rate[:, met, place] = found[:, good], ending[:, good]
        self.bend[:, met] = ((ending - rate) / (2 * step))[:, good]
        self.last[met] = place
        # The error grows with the cube of the step, so the table of growth factors depends on it; refused steps are
        # halved.
        step = step * np.select([off < limit for limit, _ in GROWTH], [growth for _, growth in GROWTH], 0.5)
        self.step[todo] = np.minimum(step, LONGEST * self.span)
        self.open[todo] = step >= SHORTEST * self.span

    def _widen(self) -> None:
        """Make place for as many poses again."""
        self.t = np.concatenate([self.t, np.full_like(self.t, np.inf)], axis=1)
        self.u, self.rate = (np.concatenate([a, np.full_like(a, np.nan)], axis=2) for a in (self.u, self.rate))

    def _before(self, t: Array, which: Index) -> Index:
        """Of some samples, the numbers of the poses laid last before or at times ``t`` (samples, times)."""
        found = np.empty(t.shape, dtype=np.intp)
        for i, own in enumerate(self.t[which]):
            found[i] = own.searchsorted(t[i], side="right")
        found -= 1
        return found

    def before(self, t: Array, which: Index) -> tuple[Array, Array]:
        """The times (samples,) and coordinates (coordinates, samples) of the poses laid last before or at a time of
        some samples."""
        k = self._before(t, which)
        return self.t[which, k], self.u[:, which, k]

    def foretell(self, t: Array, some: Index) -> Array:
        """The coordinates of some samples at times ``t`` (samples, times), by cubic interpolation: (coordinates,
        samples, times), NaN outside of the paths."""
        # For each time, the flat index of the pose before it; the next one in memory is the pose after it.
        a = self._before(t, some)
        np.clip(a, 0, self.t.shape[1] - 2, out=a)
        a += some[:, None] * self.t.shape[1]
        b = a + 1
        since = self.t.ravel()[a]
        h = self.t.ravel()[b] - since
        h[~((t >= 0) & np.isfinite(h))] = np.nan
        # Weights of the cubic Hermite interpolation, from the share s of the interval.
        s = (t - since) / h
        rest = 1.0 - s
        step = s * s * (1.0 + 2.0 * rest)
        first, second = h * s * rest * rest, -h * s * s * rest
        found = np.empty((len(self.u), *t.shape))
        # Coordinate by coordinate, in place: these arrays are large.
        for to, u, rate in zip(found, self.u, self.rate, strict=True):
            start = u.ravel()[a]
            np.subtract(u.ravel()[b], start, out=to)
            to *= step
            to += start
            to += first * rate.ravel()[a]
            to += second * rate.ravel()[b]
        return found
