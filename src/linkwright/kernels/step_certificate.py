"""Which assembly mode a solved pose of a higher group has, and whether Newton can have met no other root than the one
that was foretold.

Two signs of it are taken, both from the slopes of the closures. Where two modes meet the determinant of the slopes
vanishes, so along a motion that passes no such place it keeps its sign, and two roots that meet in a fold have opposite
ones: the sign tells the mode of a pose without its path. And by the theorem of Newton and Kantorovich a start has
one root near by if the slopes change little, relative to themselves, over the step that leads there (Ortega and
Rheinboldt, Iterative Solution of Nonlinear Equations, 1970, 12.6).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BENT = 0.25
"""The most by which slopes may change, relative to themselves, from a foretold pose to its root. The theorem needs less
than 1/2 as a bound along the whole way; half of that leaves room for a change that is measured at its ends."""


def signs(slopes: Array) -> Array:
    """The sign of the determinant of each pose's slopes, (poses,) of (poses, n, n); NaN where they are unknown."""
    known = np.isfinite(slopes).all(axis=(1, 2))
    found = np.full(len(slopes), np.nan)
    found[known] = np.linalg.slogdet(slopes[known])[0]
    return found


def bending(foretold: Array, solved: Array, size: Array) -> Array:
    """How much slopes (poses, n, n) change from foretold poses to solved ones, relative to those foretold: the largest
    sum of a row of A⁻¹(B - A), with coordinates in units of ``size`` (n, poses). Infinite where A is singular."""
    found = np.full(len(foretold), np.inf)
    known = np.asarray(np.isfinite(foretold).all(axis=(1, 2)) & np.isfinite(solved).all(axis=(1, 2)))
    known[known] = np.linalg.slogdet(foretold[known])[0] != 0
    units = size.T[known]
    change = np.linalg.solve(foretold[known], solved[known] - foretold[known])
    found[known] = np.abs(change * units[:, None, :] / units[:, :, None]).sum(axis=2).max(axis=1)
    return found
