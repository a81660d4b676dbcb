"""Numerical continuation of the higher groups of many samples at once, each with steps of its own: first in the
parameters, from the nominal start pose to that of the sample, then in time from pose to pose.

A step predicts the coordinates with the closures' slopes at its beginning, and Newton corrects them. It is accepted
only if the correction is small (:data:`CLOSE`) and the pose certified (:mod:`linkwright.kernels.step_certificate`),
else halved, so that no sample jumps to another assembly mode: all have that of the nominal start pose. The result of a
sample doesn't depend on the other samples, to the last bit.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.graph import Graph
from linkwright.kernels.continuation import CLOSE, PATIENCE, Corrector
from linkwright.kernels.continuation_paths import NEAR, STRIDE, Place, SamplePaths
from linkwright.kernels.newton import steps
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.kernels.step_certificate import signs
from linkwright.structure import HigherGroup

Array = NDArray[np.float64]

MOST = 1 << 12
"""Samples of which the paths are held at once."""
FORETOLD = 1e-5
"""A pose that Newton moves by less than this from the interpolation of its path (rad, or over the size) could only be
mistaken for one of the same mode where three poses meet: two that meet have modes of opposite signs."""
HELD = 1 << 14
"""Poses that are solved at once, few enough to stay in cache."""


class _Joined(Corrector):
    """Newton on one higher group, from a prediction by the slopes of its closure equations."""

    def step(self, x: Array, p: Array, slopes: Array) -> tuple[Array, Array]:
        """Put the coordinates into the inputs, which hold those of poses nearby, where the ``slopes`` are known.

        Gives the error of the prediction over the allowed one, (poses,), infinite where the pose isn't certified; and
        the slopes there. The step is checked forward and backward, as one that ends on another mode may look good one
        way.
        """
        # Forward: from the known pose, predict with the slopes there (one Newton step), then let Newton converge.
        u = x[self.rows]
        missed = self.closure_errors(x, p)[0].T
        guess = u - steps(slopes, missed)
        x[self.rows] = found = self.newton(x, guess, p)
        # Backward: from the pose found, predict the old one with the new slopes. Only if both predictions are good is
        # the step certainly on the same assembly mode.
        ending = self.closure_errors(x, p)[1]
        back = found + steps(ending, missed)
        off = np.maximum(self.largest_step(found - guess, found), self.largest_step(back - u, found))
        off[~self.certified(x, guess, found, ending, p)] = np.inf
        # The step also must not move any coordinate by more than the stride, however good the prediction is.
        return np.maximum(off / CLOSE, self.largest_step(found - u, found) / STRIDE), ending


class Pursuit:
    """The higher groups of a mechanism, joined: coordinates ``u`` are (coordinates, samples), higher group by higher
    group."""

    def __init__(self, graph: Graph, higher_groups: tuple[HigherGroup, ...], size: float, kernel: str) -> None:
        self.joined = [_Joined(graph, higher_group, size, kernel) for higher_group in higher_groups]
        self.rows = [row for joined in self.joined for row in joined.rows]
        self.scales = [pair for joined in self.joined for pair in zip(joined.scale, joined.slides, strict=True)]
        rates = [row for higher_group in higher_groups for row in graph.coordinate_rates(higher_group)]
        self.motion: Kernel = KERNELS[kernel](graph.program(rates))

    def begin(self, x: Array, p: Array) -> None:
        """Take the assembly mode of all samples from the nominal start pose, (inputs, 1)."""
        for joined in self.joined:
            joined.sign = float(signs(joined.closure_errors(x, p)[1])[0])

    def solve(self, x: Array, p: Array, near: float) -> tuple[Array, NDArray[np.bool_]]:
        """The coordinates, (coordinates, poses), by Newton from inputs in which starts stand; they replace these. And
        which poses are certified, of those that Newton moved by less than ``near`` by their sign alone."""
        sure = np.ones(x.shape[1], dtype=bool)
        for joined in self.joined:
            start = x[joined.rows]
            x[joined.rows] = found = joined.solver.run(x, p)
            sure &= joined.certified(x, start, found, joined.closure_errors(x, p)[1], p, near)
        return x[self.rows], sure

    def largest_step(self, step: Array, u: Array) -> Array:
        """The largest step of a pose's coordinates, as :meth:`Corrector.largest_step`: (...) of (coordinates, ...)."""
        far = np.zeros(step.shape[1:])
        for part, of, (scale, slides) in zip(np.abs(step), u, self.scales, strict=True):
            part /= np.maximum(scale, np.abs(of)) if slides else scale
            np.maximum(far, part, out=far)  # keeps NaN
        return far

    def advance_to(self, place: Place, u: Array, now: Array, targets: Array, least: Array) -> Array:
        """The coordinates at ``targets`` (samples, targets), ascending, from ``u`` (coordinates, samples) at ``now``:
        (coordinates, samples, targets); NaN before ``now``, and from where steps shorter than ``least`` are needed.

        Samples don't wait for each other: one that needs many short steps falls behind.
        """
        # Each sample has its own time, step length and next target. A step of infinite length aims directly at the
        # target.
        samples, count = targets.shape
        found = np.full((len(u), samples, count), np.nan)
        u, now, step = u.copy(), now.copy(), np.full(samples, np.inf)
        ahead = (targets < now[:, None]).sum(axis=1)  # of each sample, the target to go for
        goals = np.hstack([targets, np.full((samples, 1), np.inf)])
        met = todo = np.flatnonzero(np.isfinite(u).all(axis=0))
        slopes = [np.full((samples, joined.n, joined.n), np.nan) for joined in self.joined]
        # Slopes of the closures at the start: they serve as predictor of the first step.
        x, p = place(todo, now[todo])
        x[self.rows] = u[:, todo]
        for joined, known in zip(self.joined, slopes, strict=True):
            known[todo] = joined.closure_errors(x, p)[1]
        while True:
            # Samples that have arrived at their target note the pose and aim at the next one (several targets may be
            # equal).
            while (met := met[goals[met, ahead[met]] <= now[met]]).size:
                found[:, met, ahead[met]] = u[:, met]
                ahead[met] += 1
                step[met] = np.inf
            # Drop samples that have passed all targets or have got lost (NaN).
            todo = todo[(ahead[todo] < count) & np.isfinite(u[0, todo])]
            if not todo.size:
                return found
            # One step of all remaining samples, higher group by higher group: later groups need the coordinates of
            # earlier ones.
            there = np.minimum(now[todo] + step[todo], goals[todo, ahead[todo]])
            x, p = place(todo, there)
            x[self.rows] = u[:, todo]
            off = np.zeros(todo.size)
            ends = []
            for joined, known in zip(self.joined, slopes, strict=True):
                far, ending = joined.step(x, p, known[todo])
                off = np.maximum(off, far)  # keeps NaN
                ends.append(ending)
            # Accept steps with a small error; on these the slopes at the end serve for the next step. NaN is not
            # good.
            good = off < 1
            for known, ending in zip(slopes, ends, strict=True):
                known[todo[good]] = ending[good]
            met, length = todo[good], there - now[todo]
            u[:, met], now[met] = x[self.rows][:, good], there[good]
            # Adapt the step: longer where the error was under a third, halved where the step was refused; a sample
            # whose step becomes too short has met a singular pose.
            step[todo] = length * np.where(good, np.where(off < 1 / 3, 1.5, 1.0), 0.5)
            u[:, todo[~good & (step[todo] < least[todo])]] = np.nan


@dataclass
class _Company:
    """Samples with their coordinates at t = 0, their numbers by their parameters, and their paths of each span."""

    pursuit: Pursuit
    place: Place
    start: Array
    number: dict[bytes, int]
    laid: dict[float, SamplePaths] = field(default_factory=dict)

    def paths(self, span: float, which: NDArray[np.intp], to: Array) -> SamplePaths:
        """The paths of a span, those of some samples laid as far as ``to``."""
        if span not in self.laid:
            self.laid[span] = SamplePaths(self.pursuit, self.place, self.start, span)
        ends = np.full(self.start.shape[1], -1.0)
        np.maximum.at(ends, which, to)
        self.laid[span].extend(ends)
        return self.laid[span]


class Pursued:
    """The coordinates of all higher groups of many samples, from the nominal ``start`` pose and parameters on.

    ``drives(p, t, shape)`` gives the inputs without the higher groups' coordinates.
    """

    def __init__(self, pursuit: Pursuit, start: Array, nominal: Array, drives: Callable[..., Array]) -> None:
        self.pursuit, self.start, self.nominal, self.drives = pursuit, start, nominal, drives
        self.rows = pursuit.rows
        self.kept = threading.local()
        x = self._inputs(nominal[:, None], np.zeros(1))
        x[self.rows, 0] = start
        pursuit.begin(x, nominal[:, None])

    def coordinates(self, x: Array, p: Array, t: Array) -> Array:
        """At times ``t`` (times,) or (samples, times): (coordinates, samples, times); NaN from where a sample can't be
        followed, before the start, and at times that are no numbers. ``x`` (inputs, samples, times) has the drives'
        rows.

        Paths foretell the poses, and Newton solves them all at once. A sample in which it moves a pose further than
        paths may be off, or doesn't get there, goes on from pose to pose.
        """
        t = np.where(np.isfinite(t), t, -1.0)
        key = p.tobytes(), t.tobytes()
        if getattr(self.kept, "key", None) != key:
            self.kept.poses = self._followed_paths(x, p, np.broadcast_to(t, (p.shape[1], t.shape[-1])))
            self.kept.key = key
        found: Array = self.kept.poses
        return found

    def _followed_paths(self, x: Array, p: Array, t: Array) -> Array:
        """The same, from path to path."""
        found = np.full((len(self.rows), *t.shape), np.nan)
        lost = np.zeros(t.shape, dtype=bool)
        # Paths are laid over spans of a power of two, so that a path does not depend on the exact times that are
        # asked for.
        company, index = self._company(p)
        to = t.max(axis=1, initial=-1.0)
        span = np.where(to > 0, np.exp2(np.ceil(np.log2(np.maximum(to, np.finfo(float).tiny)))), 0.0)
        height = max(1, HELD // max(t.shape[1], 1))
        for scale in np.unique(span[to >= 0]).tolist():
            which = np.flatnonzero(span == scale)
            paths = company.paths(scale, index[which], to[which])
            # Interpolate and correct in blocks of samples that fit into the cache.
            for first in range(0, which.size, height):
                some = which[first : first + height]
                found[:, some], lost[some] = self._between(paths, index[some], x[:, some], p[:, some], t[some])
            # Samples whose interpolation was not good enough are followed again from the last reliable pose, step by
            # step.
            if (left := which[lost[which].any(axis=1)]).size:
                since, u = paths.before(np.where(lost[left], t[left], np.inf).min(axis=1), index[left])
                along = self._along(p[:, left], t[left], u, since)
                found[:, left] = np.where(t[left] < since[:, None], found[:, left], along)
        return found

    def _between(
        self, paths: SamplePaths, some: NDArray[np.intp], x: Array, p: Array, t: Array
    ) -> tuple[Array, NDArray[np.bool_]]:
        """The coordinates of some samples at times ``t`` (samples, times), and which of them aren't sure."""
        guess = paths.foretell(t, some)
        x = x.reshape(len(x), -1)
        x[self.rows] = guess.reshape(len(guess), -1)
        poses, sure = self.pursuit.solve(x, np.repeat(p, t.shape[1], axis=1), FORETOLD)
        found = poses.reshape(guess.shape)
        sure = sure.reshape(t.shape) & (self.pursuit.largest_step(found - guess, found) < NEAR)
        return found, (t >= 0) & (t <= paths.end[some, None]) & ~sure

    def gather(self, p: Array) -> None:
        """Lay the paths of these samples together from now on, in this thread, though they be asked for in parts."""
        if p.shape[1] <= MOST:
            self._company(p)

    def _company(self, p: Array) -> tuple[_Company, NDArray[np.intp]]:
        """The samples that are kept in this thread, with their paths, and the numbers of those asked for among them."""
        columns = [column.tobytes() for column in np.ascontiguousarray(p.T)]
        company: _Company | None = getattr(self.kept, "company", None)
        if company is None or not all(column in company.number for column in columns):
            start = self._started(p)
            number = {column: i for i, column in enumerate(columns)}
            company = self.kept.company = _Company(self.pursuit, self._place(p.copy()), start, number)
        return company, np.array([company.number[column] for column in columns], dtype=np.intp)

    def _place(self, p: Array) -> Place:
        """Samples at a time each."""

        def pose_inputs(which: NDArray[np.intp], t: Array) -> tuple[Array, Array]:
            return self._inputs(p[:, which], t), p[:, which]

        return pose_inputs

    def _started(self, p: Array) -> Array:
        """At t = 0, by continuation in the parameters."""

        def pose_inputs(which: NDArray[np.intp], share: Array) -> tuple[Array, Array]:
            goal, nominal = p[:, which], self.nominal[:, None]
            # The homotopy: parameters move on a straight line from the nominal ones to those of the sample.
            there = np.where(share < 1, nominal + share * (goal - nominal), goal)
            return self._inputs(there, np.zeros_like(share)), there

        samples = p.shape[1]
        u = np.where(np.isfinite(p).all(axis=0), np.repeat(self.start[:, None], samples, axis=1), np.nan)
        once = np.ones((samples, 1))
        return self.pursuit.advance_to(pose_inputs, u, np.zeros(samples), once, np.full(samples, PATIENCE))[..., 0]

    def _inputs(self, p: Array, t: Array) -> Array:
        """The inputs of samples at one time each."""
        return self.drives(p, t[:, None], (t.size, 1))[..., 0]

    def _along(self, p: Array, t: Array, u: Array, since: Array) -> Array:
        """From pose to pose, from coordinates ``u`` (coordinates, samples) at times ``since`` (samples,) on."""
        order = np.argsort(t, axis=1, kind="stable")
        least = PATIENCE * t.max(axis=1, initial=0.0)
        found = self.pursuit.advance_to(self._place(p), u, since, np.take_along_axis(t, order, axis=1), least)
        return np.take_along_axis(found, np.argsort(order, axis=1)[None], axis=2)
