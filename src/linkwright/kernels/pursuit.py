"""Following the clusters of many samples at once, each by steps of its own: in the parameters from the nominal start
pose to that of the sample, and in time from pose to pose.

A step foretells the coordinates with the closures' slopes where it begins, and lets Newton correct them; it is taken
only where the correction is small (:data:`CLOSE`), and halved else, so that no sample jumps to another mode. What
becomes of a sample doesn't depend on the others.
"""

from __future__ import annotations

import threading
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.graph import Graph
from linkwright.kernels.follow import CLOSE, PATIENCE, Corrector
from linkwright.kernels.newton import steps
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.structure import Cluster

Array = NDArray[np.float64]
Place = Callable[[NDArray[np.intp], Array], tuple[Array, Array]]
"""Of some samples, each somewhere on its way: the inputs (inputs, samples) and parameters (parameters, samples)."""

STRIDE = 0.5
"""The most that a step may move a coordinate (rad, or lengths over the size)."""
GRID = 128
"""Poses of the grid from which samples go to times of their own."""


class _Joined(Corrector):
    """Newton on one cluster, foretold by the closure's slopes."""

    def __init__(self, graph: Graph, cluster: Cluster, size: float, kernel: str) -> None:
        super().__init__(graph, cluster, size, kernel)
        self.closure: Kernel = KERNELS[kernel](graph.program(graph.closure(cluster)))

    def closed(self, x: Array, p: Array) -> tuple[Array, Array]:
        """What the closures miss, (n, poses), and their slopes, (poses, n, n)."""
        y, n = self.closure.run(x, p), self.n
        return y[:n], y[n:].reshape(n, n, -1).transpose(2, 0, 1)

    def step(self, x: Array, p: Array, slopes: Array) -> tuple[Array, Array]:
        """Put the coordinates into the inputs, which hold those of poses nearby, where the ``slopes`` are known.

        Gives how far off foretold ones are, over what is allowed, (poses,), NaN where there is no solution; and the
        slopes there. Forth and back are looked at, as a step that ends on another mode may look small one way.
        """
        u = x[self.rows]
        missed = self.closed(x, p)[0].T
        guess = u - steps(slopes, missed)
        x[self.rows] = found = self.newton(x, guess, p)
        ending = self.closed(x, p)[1]
        back = found + steps(ending, missed)
        off = np.maximum(self.moved(found - guess, found), self.moved(back - u, found))
        return np.maximum(off / CLOSE, self.moved(found - u, found) / STRIDE), ending


class Pursuit:
    """The clusters of a mechanism, joined: coordinates ``u`` are (coordinates, samples), cluster by cluster."""

    def __init__(self, graph: Graph, clusters: tuple[Cluster, ...], size: float, kernel: str) -> None:
        self.joined = [_Joined(graph, cluster, size, kernel) for cluster in clusters]
        self.rows = [row for joined in self.joined for row in joined.rows]

    def reach(self, place: Place, u: Array, now: Array, targets: Array, least: Array) -> Array:
        """The coordinates at ``targets`` (samples, targets), ascending, from ``u`` (coordinates, samples) at ``now``:
        (coordinates, samples, targets); NaN before ``now``, and from where steps shorter than ``least`` are needed.

        Samples don't wait for each other: one that needs many short steps falls behind.
        """
        samples, count = targets.shape
        found = np.full((len(u), samples, count), np.nan)
        u, now, step = u.copy(), now.copy(), np.full(samples, np.inf)
        ahead = (targets < now[:, None]).sum(axis=1)  # of each sample, the target to go for
        goals = np.hstack([targets, np.full((samples, 1), np.inf)])
        met = todo = np.flatnonzero(np.isfinite(u).all(axis=0))
        slopes = [np.full((samples, joined.n, joined.n), np.nan) for joined in self.joined]
        x, p = place(todo, now[todo])
        x[self.rows] = u[:, todo]
        for joined, known in zip(self.joined, slopes, strict=True):
            known[todo] = joined.closed(x, p)[1]
        while True:
            while (met := met[goals[met, ahead[met]] <= now[met]]).size:
                found[:, met, ahead[met]] = u[:, met]
                ahead[met] += 1
                step[met] = np.inf
            todo = todo[(ahead[todo] < count) & np.isfinite(u[0, todo])]
            if not todo.size:
                return found
            there = np.minimum(now[todo] + step[todo], goals[todo, ahead[todo]])
            x, p = place(todo, there)
            x[self.rows] = u[:, todo]
            off = np.zeros(todo.size)
            ends = []
            for joined, known in zip(self.joined, slopes, strict=True):
                far, ending = joined.step(x, p, known[todo])
                off = np.maximum(off, far)  # keeps NaN
                ends.append(ending)
            good = off < 1
            for known, ending in zip(slopes, ends, strict=True):
                known[todo[good]] = ending[good]
            met, length = todo[good], there - now[todo]
            u[:, met], now[met] = x[self.rows][:, good], there[good]
            step[todo] = length * np.where(good, np.where(off < 1 / 3, 1.5, 1.0), 0.5)
            u[:, todo[~good & (step[todo] < least[todo])]] = np.nan


class Pursued:
    """The coordinates of all clusters of many samples, from the nominal ``start`` pose and parameters on.

    ``drives(p, t, shape)`` gives the inputs without the clusters' coordinates.
    """

    def __init__(self, pursuit: Pursuit, start: Array, nominal: Array, drives: Callable[..., Array]) -> None:
        self.pursuit, self.start, self.nominal, self.drives = pursuit, start, nominal, drives
        self.rows = pursuit.rows
        self.kept = threading.local()

    def coordinates(self, p: Array, t: Array) -> Array:
        """At times ``t`` (times,), from pose to pose, or (samples, times), from a grid: (coordinates, samples, times);
        NaN from where a sample can't be followed, before the start, and at times that are no numbers."""
        t = np.where(np.isfinite(t), t, -1.0)
        return self._kept("poses", (p, t), lambda: self._along(p, t)) if t.ndim == 1 else self._from_grid(p, t)

    def _started(self, p: Array) -> Array:
        """At t = 0, by continuation in the parameters."""

        def place(which: NDArray[np.intp], share: Array) -> tuple[Array, Array]:
            goal, nominal = p[:, which], self.nominal[:, None]
            there = np.where(share < 1, nominal + share * (goal - nominal), goal)
            return self._inputs(there, np.zeros_like(share)), there

        samples = p.shape[1]
        u = np.where(np.isfinite(p).all(axis=0), np.repeat(self.start[:, None], samples, axis=1), np.nan)
        once = np.ones((samples, 1))
        return self.pursuit.reach(place, u, np.zeros(samples), once, np.full(samples, PATIENCE))[..., 0]

    def _inputs(self, p: Array, t: Array) -> Array:
        """The inputs of samples at one time each."""
        return self.drives(p, t[:, None], (t.size, 1))[..., 0]

    def _along(self, p: Array, t: Array) -> Array:
        """From pose to pose; ``t`` is (times,) or (samples, times)."""
        samples = p.shape[1]

        def place(which: NDArray[np.intp], there: Array) -> tuple[Array, Array]:
            return self._inputs(p[:, which], there), p[:, which]

        order = np.argsort(t, axis=-1, kind="stable")
        own = np.broadcast_to(np.take_along_axis(t, order, axis=-1), (samples, t.shape[-1]))
        start = self._kept("start", (p,), lambda: self._started(p))
        least = PATIENCE * own.max(axis=1, initial=0.0)
        found = self.pursuit.reach(place, start, np.zeros(samples), own, least)
        back = np.broadcast_to(np.argsort(order, axis=-1), own.shape)
        return np.take_along_axis(found, back[None], axis=2)

    def _from_grid(self, p: Array, t: Array) -> Array:
        """From the poses of a grid, each sample's as long as its latest time asks for (rounded up to a power of 2)."""
        samples, times = t.shape
        to = t.max(axis=1, initial=0.0)
        span = np.where(to > 0, np.exp2(np.ceil(np.log2(np.maximum(to, np.finfo(float).tiny)))), 0.0)
        step = (span / GRID)[:, None]
        laid = self._kept("grid", (p, span), lambda: self._along(p, step * np.arange(GRID + 1)))
        k = np.clip(np.floor(np.maximum(t, 0.0) / np.maximum(step, np.finfo(float).tiny)), 0, GRID).astype(int)
        u = np.take_along_axis(laid, k[None], axis=2).reshape(len(laid), -1)

        def place(which: NDArray[np.intp], there: Array) -> tuple[Array, Array]:
            own = p[:, which // times]
            return self._inputs(own, there), own

        least = PATIENCE * np.repeat(span, times)
        found = self.pursuit.reach(place, u, (step * k).ravel(), t.reshape(-1, 1), least)
        return found.reshape(-1, samples, times)

    def _kept(self, name: str, about: tuple[Array, ...], make: Callable[[], Array]) -> Array:
        """What was made last in this thread, where it was made of the same."""
        key = tuple(array.tobytes() for array in about)
        if getattr(self.kept, name, (None,))[0] != key:
            setattr(self.kept, name, (key, make()))
        found: Array = getattr(self.kept, name)[1]
        return found
