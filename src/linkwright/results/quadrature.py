"""Gauss quadrature in time."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def gauss_points(edges: Array) -> tuple[Array, Array]:
    """Times and weights of 8-point Gauss quadrature on the panels between ascending edges: (8 panels,) each."""
    return panel_points(edges[:-1], edges[1:])


def panel_points(lows: Array, highs: Array, points: int = 8) -> tuple[Array, Array]:
    """The same on panels given by their ends, those of a panel together, with any number of ``points`` a panel."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    h = (highs - lows)[:, None]
    return (lows[:, None] + h * (nodes + 1) / 2).ravel(), (h * weights / 2).ravel()
