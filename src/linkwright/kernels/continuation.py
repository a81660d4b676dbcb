"""Numerical continuation of one higher group along a motion: its coordinates at any time, on the branch of the start
pose.

A path of solved poses is built once by a predictor and corrector method: the exact rates predict the next pose, Newton
corrects it, and the step length is adapted so that the corrections stay small. Coordinates at other times start from
the cubic interpolation of this path.

Each solved pose is certified (:mod:`linkwright.kernels.step_certificate`): it has the assembly mode of the start pose,
and no other root is near enough to have been taken for it. A step that isn't is halved; where that doesn't help the
path ends, and the motion with it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.graph import Graph
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.kernels.step_certificate import BENT, bending, signs
from linkwright.structure import HigherGroup

Array = NDArray[np.float64]

CLOSE = 1e-2
"""The most that a corrector may move a coordinate (rad, or lengths over the size) on a step of the path."""
PATIENCE = 1e-9
"""A path that needs steps shorter than this share of the time asked for has met a singular pose."""
SURE = 1e-7
"""A pose that Newton moves by less (rad, or over the size) can only have been mistaken for one of another mode where
two modes are as near to each other: that is singular by any measure."""


@dataclass
class HigherGroupPath:
    """Solved poses of one higher group: times, coordinates and their rates; ``end`` where it can't go on."""

    t: list[float] = field(default_factory=list)
    u: list[Array] = field(default_factory=list)
    rate: list[Array] = field(default_factory=list)
    end: float | None = None

    def append(self, time: float, u: Array, rate: Array) -> None:
        """One more pose, after all others."""
        self.t.append(time)
        self.u.append(u)
        self.rate.append(rate)

    def join(self, piece: HigherGroupPath, i: int) -> None:
        """Take in a piece that begins at pose ``i``; where it ends before the next one, everything does."""
        after = slice(i + 1, i + 1 if piece.end is None else len(self.t))
        self.t[after], self.u[after], self.rate[after] = piece.t[1:], piece.u[1:], piece.rate[1:]
        self.end = self.end if piece.end is None else piece.end


SIDEWAYS, SIDEWAYS_STEPS = 1e-5, 10
"""Singular values below this share of the largest one belong to the direction in which a double root is double; the
steps that leave that direction out."""
DOUBLE, DOUBLE_STEPS = 1e-6, 40
"""The share below which the smallest singular value at a double root is, and the steps towards it: each halves the
distance, until round-off (of the gaps: the square) stops them."""


class Corrector:
    """Newton on one higher group, from inputs in which the coordinates of earlier higher groups stand already."""

    def __init__(self, graph: Graph, higher_group: HigherGroup, size: float, kernel: str) -> None:
        self.graph, self.higher_group, self.kernel, self.n = graph, higher_group, kernel, len(higher_group.free)
        self.rows = graph.coordinates(higher_group)
        self.scale = np.array(higher_group.units(size))
        self.slides = 1.0 - np.array(higher_group.turning, dtype=float)
        self.sign = np.nan  # that of the determinant of the closures' slopes at the start pose: the assembly mode

    @cached_property
    def solver(self) -> Kernel:
        """What solves the higher group; built when it is asked for, which an examination doesn't."""
        return KERNELS[self.kernel](self.graph.solving(self.higher_group))

    @cached_property
    def closure(self) -> Kernel:
        """What gives the misses of the closures and their slopes."""
        return KERNELS[self.kernel](self.graph.program(self.graph.closure(self.higher_group)))

    def closure_errors(self, x: Array, p: Array) -> tuple[Array, Array]:
        """What the closures miss, (n, poses), and their slopes, (poses, n, n)."""
        y, n = self.closure.run(x, p), self.n
        return y[:n], y[n:].reshape(n, n, -1).transpose(2, 0, 1)

    def slopes(self, x: Array, u: Array, p: Array) -> Array:
        """The slopes of the closures at coordinates ``u`` (n, poses): (poses, n, n)."""
        x = x.copy()
        x[self.rows] = u
        return self.closure_errors(x, p)[1]

    def sizes(self, u: Array) -> Array:
        """What a step of each coordinate is measured by: (coordinates, poses)."""
        # A slide counts relative to its own travel once that exceeds the mechanism's size.
        return np.asarray(np.maximum(self.scale[:, None], np.abs(u) * self.slides[:, None]))

    def largest_step(self, step: Array, u: Array) -> Array:
        """The largest step of a pose's coordinates: (poses,), in rad, and of slides over the size or where it is more
        over how far they are out, so that one that runs away doesn't do so in ever smaller steps."""
        return np.asarray(np.abs(step / self.sizes(u)).max(axis=0))

    def certified(
        self, x: Array, start: Array, found: Array, ending: Array, p: Array, near: float = SURE
    ) -> NDArray[np.bool_]:
        """Which poses ``found`` from a ``start`` (n, poses), with the slopes ``ending`` there, have the mode of the
        start pose and are the only root that can be meant: (poses,). Of those that Newton moved by less than ``near``
        the sign alone is asked."""
        sure = signs(ending) == self.sign
        moved = np.flatnonzero(sure & ~(self.largest_step(found - start, found) < near))
        if moved.size:
            own = p if p.ndim == 1 else p[:, moved]
            beginning = self.slopes(x[:, moved], start[:, moved], own)
            sure[moved] = bending(beginning, ending[moved], self.sizes(found[:, moved])) < BENT
        return np.asarray(sure)

    def has_double_root(self, x: Array, u: Array, p: Array) -> bool:
        """Whether the root nearest to coordinates ``u`` (n,) at one pose (inputs, 1) is a double one.

        There the closures meet, and one direction of the coordinates leaves them met to first order.
        """
        x, u = x.copy(), u.copy()
        for k in range(SIDEWAYS_STEPS + DOUBLE_STEPS):
            x[self.rows, 0] = u
            gaps, slopes = self.closure_errors(x, p)
            if not (np.isfinite(gaps).all() and np.isfinite(slopes).all()):
                return False
            # From another pose a step along the double direction would be far too long: at first it stays out.
            smallest = SIDEWAYS if k < SIDEWAYS_STEPS else None
            columns = slopes[0] * self.scale
            u -= np.linalg.lstsq(columns, gaps[:, 0], rcond=smallest)[0] * self.scale
        values = np.linalg.svd(columns, compute_uv=False)
        return bool(np.abs(gaps[:, 0]).max() <= DOUBLE**2 * values[0] and values[-1] <= DOUBLE * values[0])

    def newton(self, x: Array, start: Array, p: Array) -> Array:
        """Newton on all poses at once."""
        x = x.copy()
        x[self.rows] = start
        return self.solver.run(x, p)


class Continuation(Corrector):
    """Supplies the coordinates of one higher group, from inputs in which those of earlier higher groups stand
    already."""

    def __init__(
        self,
        graph: Graph,
        higher_group: HigherGroup,
        start: list[float],
        size: float,
        kernel: str,
        bands: Sequence[Array] = (),
    ) -> None:
        """``bands`` are the times (s) between which the motion is carried through change points of other groups: poses
        there have few digits, and nothing is asked of them."""
        super().__init__(graph, higher_group, size, kernel)
        self.start = np.array(start)
        self.bands = [(float(low), float(high)) for low, high in bands]
        self.path = HigherGroupPath()
        self.correction = 0.0  # the most that Newton moved a foretold coordinate (rad, or over the size)

    @cached_property
    def motion(self) -> Kernel:
        """What gives the rates of the coordinates."""
        return KERNELS[self.kernel](self.graph.program(self.graph.coordinate_rates(self.higher_group)))

    def solve(self, x: Array, t: Array, p: Array, at: Callable[[Array], Array]) -> Array:
        """The coordinates at times ``t``: (coordinates, times), NaN past the path's end. ``at`` gives inputs."""
        # Predict from the path, correct with Newton.
        start = self.foretell(x, t, p, at)
        found = self.newton(x, start, p)
        # Where a pose isn't certified, lay the path through it by steps that are; where that can't be, it ends.
        doubtful = np.isfinite(start[0]) & ~self.certified(x, start, found, self.slopes(x, found, p), p)
        for low, high in self.bands:
            doubtful &= (t <= low) | (t >= high)
        if doubtful.any():
            for time in np.unique(t[doubtful]).tolist():
                self.lay_through(time, p, at)
            start[:, doubtful] = self.between(t[doubtful])
            found[:, doubtful] = self.newton(x[:, doubtful], start[:, doubtful], p)
            found[:, ~(t <= self.last)] = np.nan
        # Keep the largest correction for the certificate.
        self.correction = max(
            self.correction, float(np.nan_to_num(self.largest_step(found - start, found)).max(initial=0.0))
        )
        return found

    @property
    def last(self) -> float:
        """Up to when the path can be followed, as far as is known."""
        return np.inf if self.path.end is None else self.path.end

    def foretell(self, x: Array, t: Array, p: Array, at: Callable[[Array], Array]) -> Array:
        """The same, as they lie between the solved poses of the path."""
        self.extend(float(t.max(initial=0.0)), p, at)
        return self.between(t)

    def extend(self, to: float, p: Array, at: Callable[[Array], Array]) -> None:
        """Continue the path up to a time (s), or to the singular pose that ends it."""
        if not self.path.t:
            x = at(np.zeros(1))
            self.sign = float(signs(self.slopes(x, self.start[:, None], p))[0])
            self.path.append(0.0, self.start, self.rates(x, self.start, p))
        # Start with 64 steps for the whole span; their length is adapted.
        self.lay(self.path, to, max(to / 64, 1e-12), PATIENCE * to, p, at)

    def lay_through(self, time: float, p: Array, at: Callable[[Array], Array]) -> None:
        """Lay the path through a time between its poses by more of them; it ends where that can't be done."""
        path = self.path
        i = int(np.searchsorted(np.array(path.t), time)) - 1
        if not path.t[0] < time <= path.t[-1] or path.t[i + 1] == time:
            return
        piece = HigherGroupPath([path.t[i]], [path.u[i]], [path.rate[i]])
        self.lay(piece, time, (time - path.t[i]) / 2, PATIENCE * path.t[-1], p, at)
        path.join(piece, i)

    def lay(
        self, path: HigherGroupPath, to: float, step: float, least: float, p: Array, at: Callable[[Array], Array]
    ) -> None:
        """Continue a path up to a time by certified steps, the first of a length, none shorter than ``least`` (s)."""
        while path.t[-1] < to and path.end is None:
            now, u, rate = path.t[-1], path.u[-1], path.rate[-1]
            there, across = self.next_stop(now, min(now + step, to))
            # Predictor: follow the tangent, that is the exact rates at the last pose.
            guess = u + (there - now) * rate
            x = at(np.array([there, (now + there) / 2]))
            # Corrector: Newton from the predicted pose.
            found = self.newton(x[:, :1], guess[:, None], p)[:, 0]
            moved = self.largest_step((found - guess)[:, None], u[:, None])[0]
            # A large correction (or NaN, no solution), or a pose that isn't certified, could mean another assembly
            # mode: refuse the step and halve it. If that needs steps that are too short, the path ends here.
            ending = self.rates(x[:, :1], found, p) if moved < CLOSE else rate
            accepted = moved < CLOSE and (
                self.arrived(x[:, :1], guess, found, p)
                if across
                else self.joined(x, there - now, (u, rate), (found, ending), guess, p)
            )
            if not accepted:
                step = (there - now) / 2
                if step < least:
                    path.end = now
                continue
            # The pose is accepted; where the correction was small the next step may be longer.
            path.append(there, found, ending)
            self.correction = max(self.correction, float(moved))
            step = (there - now) * (1.5 if moved < CLOSE / 3 else 1.0)

    def next_stop(self, now: float, there: float) -> tuple[float, bool]:
        """Where a step that is to lead from one time to another ends, and whether it leads across a band: it stops
        where one begins, and goes over it at once."""
        for low, high in self.bands:
            if now < high and there > low:
                return (low, False) if now < low else (high, True)
        return there, False

    def arrived(self, x: Array, guess: Array, found: Array, p: Array) -> bool:
        """Whether the pose at the end of a step is that which was foretold."""
        pose = found[:, None]
        return bool(self.certified(x, guess[:, None], pose, self.slopes(x, pose, p), p).all())

    def joined(
        self, x: Array, h: float, begin: tuple[Array, Array], end: tuple[Array, Array], guess: Array, p: Array
    ) -> bool:
        """Whether a step of ``h`` (s) follows one root: between poses with their rates, of which the last was foretold
        as ``guess``. It is looked at its end and in its middle, as it is interpolated there; ``x`` has the inputs."""
        (a, da), (b, db) = begin, end
        middle = (a + b) / 2 + h / 8 * (da - db)
        solved = self.newton(x[:, 1:], middle[:, None], p)[:, 0]
        starts, poses = np.stack([guess, middle], axis=1), np.stack([b, solved], axis=1)
        if not self.largest_step(poses - starts, poses).max() < CLOSE:
            return False
        return bool(self.certified(x, starts, poses, self.slopes(x, poses, p), p).all())

    def rates(self, x: Array, u: Array, p: Array) -> Array:
        """The rates of the coordinates ``u`` (n,) at one pose: (n,)."""
        x = x.copy()
        x[self.rows, 0] = u
        return self.motion.run(x, p)[:, 0]

    def between(self, t: Array) -> Array:
        """Cubic interpolation of the path: (coordinates, times)."""
        times, u, rate = np.array(self.path.t), np.array(self.path.u), np.array(self.path.rate)
        if times.size == 1:
            return np.repeat(u.T, t.size, axis=1)
        # Find the interval of the path that holds each time, and the share s of it that has passed.
        i = np.clip(np.searchsorted(times, t) - 1, 0, times.size - 2)
        h = times[i + 1] - times[i]
        s = ((t - times[i]) / h)[:, None]
        h = h[:, None]
        # Cubic Hermite interpolation from coordinates and rates at both ends.
        a, b, da, db = u[i], u[i + 1], rate[i] * h, rate[i + 1] * h
        value = a + s * (da + s * (3 * (b - a) - 2 * da - db + s * (2 * (a - b) + da + db)))
        if self.path.end is not None:
            value[t > self.path.end] = np.nan
        return np.asarray(value.T)
