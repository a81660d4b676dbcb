"""The whole turns of angles of many samples at once: each angle runs on without jumps from t = 0."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels.external_inputs import MAX_STEPS
from linkwright.kernels.registry import Kernel
from linkwright.notation.angles import MAX_TURN, whole_turns, wrapped

Array = NDArray[np.float64]
FIRST_STEPS = 32
HELD = 1 << 17
"""Poses of which the angles are held at once."""

Motion = Callable[[Array, Array], Array]
"""The inputs of the motion for parameters (parameters, samples) at times (times,) or (samples, times)."""


def turns_of(kernel: Kernel, start_angle: Any, x: Array, t: Array, p: Array, motion: Motion) -> Array:
    """The whole turns of an angle that a kernel gives with its rate, (samples, times): NaN where it can't be followed.

    ``start_angle`` (rad; None, a number or (samples,)) is the angle near which it starts; ``t`` is (times,) or
    (samples, times). Every sample is followed on a grid of its own, fine enough for it.
    """
    angle = kernel.over(x, p)[0]
    near = np.full(angle.shape, np.nan)
    start_angle = None if start_angle is None else np.broadcast_to(start_angle, p.shape[1])
    todo, steps = np.arange(p.shape[1]), FIRST_STEPS
    while todo.size:
        height, left = max(1, HELD // (steps + 1)), []
        for first in range(0, todo.size, height):
            some = todo[first : first + height]
            times = t if t.ndim == 1 else t[some]
            grid = np.fmax.reduce(times, axis=-1, initial=0.0, keepdims=True) * np.linspace(0.0, 1.0, steps + 1)
            raw, rate = kernel.over(motion(p[:, some], grid), p[:, some])
            path, largest = _path(raw, rate, grid)
            if start_angle is not None:
                path += 2 * np.pi * whole_turns(path[:, :1], start_angle[some, None])
            near[some] = _between(path, rate, grid, times)
            left.append(some[largest > MAX_TURN] if steps < MAX_STEPS else some[:0])
        todo, steps = np.concatenate(left), 2 * steps
    return whole_turns(angle, near)


def _path(angle: Array, rate: Array, grid: Array) -> tuple[Array, Array]:
    """Angles without jumps, NaN after the first one that isn't known; the largest turn of each sample."""
    path = angle.copy()
    with np.errstate(invalid="ignore"):  # a rate is infinite in a dead centre
        turned = np.diff(grid) * (rate[:, 1:] + rate[:, :-1]) / 2
        path[:, 1:] = angle[:, :1] + np.cumsum(turned + wrapped(np.diff(angle) - turned), axis=1)
    return path, np.fmax.reduce(np.abs(turned), axis=1, initial=0.0)


def _between(path: Array, rate: Array, grid: Array, t: Array) -> Array:
    """The angles at times between, from the grid's last ones before."""
    step = np.maximum(grid[..., 1:2], np.finfo(float).tiny)
    k = np.broadcast_to(np.clip(np.nan_to_num(t // step), 0, grid.shape[-1] - 1).astype(int), (len(path), t.shape[-1]))
    here, slope = np.take_along_axis(path, k, axis=1), np.take_along_axis(rate, k, axis=1)
    with np.errstate(invalid="ignore"):
        return np.asarray(here + slope * (t - step * k))
