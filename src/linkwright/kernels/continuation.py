"""Numerical continuation of one higher group along a motion: its coordinates at any time, on the branch of the start
pose.

A path of solved poses is built once by a predictor and corrector method: the exact rates predict the next pose, Newton
corrects it, and the step length is adapted so that the corrections stay small. Coordinates at other times start from
the cubic interpolation of this path.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.graph import Graph
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.structure import HigherGroup

Array = NDArray[np.float64]

CLOSE = 1e-2
"""The most that a corrector may move a coordinate (rad, or lengths over the size) on a step of the path."""
PATIENCE = 1e-9
"""A path that needs steps shorter than this share of the time asked for has met a singular pose."""


@dataclass
class HigherGroupPath:
    """Solved poses of one higher group: times, coordinates and their rates; ``end`` where it can't go on."""

    t: list[float] = field(default_factory=list)
    u: list[Array] = field(default_factory=list)
    rate: list[Array] = field(default_factory=list)
    end: float | None = None


class Corrector:
    """Newton on one higher group, from inputs in which the coordinates of earlier higher groups stand already."""

    def __init__(self, graph: Graph, higher_group: HigherGroup, size: float, kernel: str) -> None:
        self.graph, self.higher_group, self.kernel, self.n = graph, higher_group, kernel, len(higher_group.free)
        self.rows = graph.coordinates(higher_group)
        self.scale = np.array(higher_group.units(size))
        self.slides = 1.0 - np.array(higher_group.turning, dtype=float)

    @cached_property
    def solver(self) -> Kernel:
        """What solves the higher group; built when it is asked for, which an examination doesn't."""
        return KERNELS[self.kernel](self.graph.solving(self.higher_group))

    def largest_step(self, step: Array, u: Array) -> Array:
        """The largest step of a pose's coordinates: (poses,), in rad, and of slides over the size or where it is more
        over how far they are out, so that one that runs away doesn't do so in ever smaller steps."""
        # A slide counts relative to its own travel once that exceeds the mechanism's size.
        size = np.maximum(self.scale[:, None], np.abs(u) * self.slides[:, None])
        return np.asarray(np.abs(step / size).max(axis=0))

    def newton(self, x: Array, start: Array, p: Array) -> Array:
        """Newton on all poses at once."""
        x = x.copy()
        x[self.rows] = start
        return self.solver.run(x, p)


class Continuation(Corrector):
    """Supplies the coordinates of one higher group, from inputs in which those of earlier higher groups stand
    already."""

    def __init__(self, graph: Graph, higher_group: HigherGroup, start: list[float], size: float, kernel: str) -> None:
        super().__init__(graph, higher_group, size, kernel)
        self.start = np.array(start)
        self.path = HigherGroupPath()
        self.correction = 0.0  # the most that Newton moved a foretold coordinate (rad, or over the size)

    @cached_property
    def motion(self) -> Kernel:
        """What gives the rates of the coordinates."""
        return KERNELS[self.kernel](self.graph.program(self.graph.coordinate_rates(self.higher_group)))

    def solve(self, x: Array, t: Array, p: Array, at: Callable[[Array], Array]) -> Array:
        """The coordinates at times ``t``: (coordinates, times), NaN past the path's end. ``at`` gives inputs."""
        # Predict from the path, correct with Newton, and keep the largest correction for the certificate.
        start = self.foretell(x, t, p, at)
        found = self.newton(x, start, p)
        self.correction = max(
            self.correction, float(np.nan_to_num(self.largest_step(found - start, found)).max(initial=0.0))
        )
        return found

    def foretell(self, x: Array, t: Array, p: Array, at: Callable[[Array], Array]) -> Array:
        """The same, as they lie between the solved poses of the path."""
        self.extend(float(t.max(initial=0.0)), p, at)
        return self.between(t)

    def extend(self, to: float, p: Array, at: Callable[[Array], Array]) -> None:
        """Continue the path up to a time (s), or to the singular pose that ends it."""
        path = self.path
        if not path.t:
            self.note(0.0, self.start, p, at)
        # Start with 64 steps for the whole span; the loop below adapts the length.
        step = max(to / 64, 1e-12)
        while path.t[-1] < to and path.end is None:
            now, u, rate = path.t[-1], path.u[-1], path.rate[-1]
            there = min(now + step, to)
            # Predictor: follow the tangent, that is the exact rates at the last pose.
            guess = u + (there - now) * rate
            x = at(np.array([there]))
            # Corrector: Newton from the predicted pose.
            found = self.newton(x, guess[:, None], p)[:, 0]
            moved = self.largest_step((found - guess)[:, None], u[:, None])[0]
            # A large correction (or NaN, no solution) could mean another assembly mode: refuse the step and halve it.
            # If that needs steps that are too short, the path ends here at a singular pose.
            if not moved < CLOSE:
                step = (there - now) / 2
                if step < PATIENCE * to:
                    path.end = now
                continue
            # The pose is accepted; where the correction was small the next step may be longer.
            self.note(there, found, p, at)
            self.correction = max(self.correction, float(moved))
            step = (there - now) * (1.5 if moved < CLOSE / 3 else 1.0)

    def note(self, time: float, u: Array, p: Array, at: Callable[[Array], Array]) -> None:
        x = at(np.array([time]))
        x[self.rows, 0] = u
        self.path.t.append(time)
        self.path.u.append(u)
        self.path.rate.append(self.motion.run(x, p)[:, 0])

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
