"""Solutions of a closure from many starts at once: for groups whose modes can't be counted beforehand."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.notation.angles import wrapped

Array = NDArray[np.float64]
Closure = Callable[[Array], tuple[Array, Array]]
"""Of unknowns (unknowns, starts): what is missed (starts, equations), its slopes (starts, equations, unknowns)."""

STARTS, BATCHES = 256, 8
NEW = 1e-4
"""A solution farther than this share of the spread from all others is a new one."""


def many_starts(closure: Closure, turning: NDArray[np.bool_], size: float, tolerance: float) -> list[list[float]]:
    """Solutions from starts all round and within a size (m), the same ones always, until two batches bring nothing new.

    ``turning`` tells which unknowns are angles (rad); they come out in -pi..pi.
    """
    spread = np.where(turning, np.pi, size)
    random, idle = np.random.default_rng(1), 0
    found = np.empty((0, spread.size))
    for _ in range(BATCHES):
        starts = random.uniform(-1.0, 1.0, (spread.size, STARTS)) * spread[:, None]
        before = len(found)
        for u in levenberg(closure, starts, tolerance).T:
            u[turning] = wrapped(u[turning])
            if not (np.abs((u - found) / spread).max(axis=1) < NEW).any():
                found = np.vstack([found, u])
        idle = idle + 1 if len(found) == before else 0
        if idle == 2:
            break
    return [[float(q) for q in u] for u in found]


def levenberg(closure: Closure, u: Array, tolerance: float) -> Array:
    """Levenberg-Marquardt on many starts at once: the columns of ``u`` (unknowns, starts) that close."""
    gap, slope = closure(u)
    damping = np.full(u.shape[1], 1e-2)
    scale = np.maximum(np.abs(slope).max(axis=(1, 2)), 1e-300) ** 2
    for _ in range(80):
        square = slope.transpose(0, 2, 1) @ slope + (damping * scale)[:, None, None] * np.eye(u.shape[0])
        right = (slope.transpose(0, 2, 1) @ gap[:, :, None])[:, :, 0]
        there = u - np.linalg.solve(square, right[:, :, None])[:, :, 0].T
        gap_there, slope_there = closure(there)
        better = (gap_there**2).sum(axis=1) < (gap**2).sum(axis=1)
        u = np.where(better, there, u)
        gap, slope = np.where(better[:, None], gap_there, gap), np.where(better[:, None, None], slope_there, slope)
        damping = np.clip(np.where(better, damping / 10, damping * 10), 1e-14, 1e8)
        if (np.abs(gap).max(axis=1) < tolerance).all():
            break
    return u[:, np.abs(gap).max(axis=1) < tolerance]
