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

from linkwright.kernels.newton import quotients

Array = NDArray[np.float64]

BENT = 0.25
"""The most by which slopes may change, relative to themselves, from a foretold pose to its root. The theorem needs less
than 1/2 as a bound along the whole way; half of that leaves room for a change that is measured at its ends."""


SMALL = 4
"""Up to so many equations determinants of many poses are faster by minors, over all poses at once."""


def signs(slopes: Array) -> Array:
    """The sign of the determinant of each pose's slopes, (poses,) of (poses, n, n); NaN where they are unknown."""
    n = slopes.shape[1]
    if n <= SMALL:
        with np.errstate(invalid="ignore", over="ignore"):
            return np.asarray(np.sign(_determinant(slopes.transpose(1, 2, 0), list(range(n)))))
    known = np.isfinite(slopes).all(axis=(1, 2))
    found = np.full(len(slopes), np.nan)
    found[known] = np.linalg.slogdet(slopes[known])[0]
    return found


def _determinant(slopes: Array, columns: list[int]) -> Array:
    """The determinant of the last rows of (n, n, poses) and some columns, as many, by its minors: (poses,)."""
    row = slopes[len(slopes) - len(columns)]
    if len(columns) == 1:
        return np.asarray(row[columns[0]])
    total = np.zeros(row.shape[1:])
    for k, column in enumerate(columns):
        total += (-1.0) ** k * row[column] * _determinant(slopes, columns[:k] + columns[k + 1 :])
    return total


def bending(foretold: Array, solved: Array, size: Array) -> Array:
    """How much slopes (poses, n, n) change from foretold poses to solved ones, relative to those foretold: the largest
    sum of a row of A⁻¹(B - A), with coordinates in units of ``size`` (n, poses). Infinite where A is singular."""
    change = quotients(foretold, solved - foretold)
    shares = np.abs(change * size.T[:, None, :] / size.T[:, :, None]).sum(axis=2).max(axis=1)
    return np.asarray(np.where(np.isfinite(shares), shares, np.inf))
