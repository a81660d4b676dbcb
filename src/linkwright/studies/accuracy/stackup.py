"""What deviations make together of an output, to first order: worst case, mean, standard deviation, shares.

With the transfer coefficients c the output's deviation is the sum of c d (linear superposition). Its limits are the sum
of each term's (worst case), its variance is c' V c with the deviations' covariance V (root sum square where they are
independent; JCGM 100:2008, 5.2.2).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.studies.accuracy.contributors import Contributors

Array = NDArray[np.float64]


def worst(coefficients: Array, contributors: Contributors) -> tuple[Array, Array]:
    """Least and largest deviation of outputs from coefficients (contributors, ...), within the limits of all
    deviations."""
    shape = (len(contributors), *(1,) * (coefficients.ndim - 1))
    terms = np.stack([coefficients * end.reshape(shape) for end in (contributors.low, contributors.high)])
    return terms.min(axis=0).sum(axis=0), terms.max(axis=0).sum(axis=0)


def larger(sides: Array) -> Array:
    """Of the coefficients on both sides the one of larger magnitude: (contributors, ...)."""
    return np.where(np.abs(sides[:, 0]) > np.abs(sides[:, 1]), sides[:, 0], sides[:, 1])


def spread(coefficients: Array, contributors: Contributors) -> tuple[Array, Array]:
    """Mean and standard deviation of outputs, from (contributors, ...)."""
    mean = np.tensordot(contributors.mean, coefficients, axes=1)
    variance = (coefficients * np.tensordot(contributors.covariance, coefficients, axes=1)).sum(axis=0)
    return mean, np.sqrt(np.maximum(variance, 0.0))


def shares(coefficients: Array, contributors: Contributors) -> Array:
    """Of each contributor, (c sigma)^2 over the sum of all; 0 where nothing spreads: (contributors,)."""
    parts = (coefficients * contributors.sigma) ** 2
    total = parts.sum()
    return np.asarray(parts / total if total > 0 else parts)
