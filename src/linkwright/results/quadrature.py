"""Gauss quadrature in time."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def gauss_points(edges: Array) -> tuple[Array, Array]:
    """Times and weights of 8-point Gauss quadrature on the panels between ascending edges: (8 panels,) each."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    h = np.diff(edges)[:, None]
    return (edges[:-1, None] + h * (nodes + 1) / 2).ravel(), (h * weights / 2).ravel()
