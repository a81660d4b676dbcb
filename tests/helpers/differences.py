"""Derivatives by central differences of eighth order: accurate to about 1e-11 for rates of order one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

OFFSETS = np.array([-4, -3, -2, -1, 1, 2, 3, 4])
WEIGHTS = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 4 / 5, -1 / 5, 4 / 105, -1 / 280])


def derivative(f: Callable[[float], Any], t: float, h: float) -> Array:
    """df/dt at t from eight values with step h (Fornberg 1988, table 1)."""
    values = np.array([np.asarray(f(t + k * h), dtype=float) for k in OFFSETS])
    return np.tensordot(WEIGHTS, values, axes=1) / h


def derivatives(f: Callable[[Array], Array], t: Array, h: float) -> Array:
    """The same for a function of an array of times whose last axis is time."""
    at = (t[:, None] + h * OFFSETS).ravel()
    values = f(at)
    return values.reshape(*values.shape[:-1], t.size, OFFSETS.size) @ WEIGHTS / h


def misfit(
    f: Callable[[Array], Array], exact: Array, t: Array, steps: tuple[float, ...] = (4e-3, 1e-3, 2.5e-4)
) -> Array:
    """How far ``exact`` is from the differences of f, at the step that suits each entry best."""
    return np.asarray(np.min([np.abs(derivatives(f, t, h) - exact) for h in steps], axis=0))
