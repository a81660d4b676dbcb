"""How a deviation is distributed between its limits; each gives mean, standard deviation and quantiles.

A distribution is a function under ``@register``; its name is the one in the file. Each has its middle in the middle of
the limits.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.notation.registry import Registry

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Deviation:
    """A random deviation, in the unit of its limits: ``quantile`` gives its value at shares in (0, 1), in arrays of any
    shape."""

    mean: float
    sigma: float
    quantile: Callable[[Array], Array]


@dataclass(frozen=True)
class Distribution:
    """Makes a deviation from lower limit, upper limit and standard deviation. ``free`` says that the latter is for the
    user to choose; else it follows from the limits."""

    make: Callable[[float, float, float], Deviation]
    free: bool


DISTRIBUTIONS: Registry[Distribution] = Registry()


def register(name: str, free: bool) -> Callable[[Callable[[float, float, float], Deviation]], None]:
    """Register a distribution under its name; a second one of the same name is an error."""

    def add(make: Callable[[float, float, float], Deviation]) -> None:
        DISTRIBUTIONS[name] = Distribution(make, free)

    return add


@register("normal", free=True)
def _normal(low: float, high: float, sigma: float) -> Deviation:
    """Not cut: a share of the parts is beyond the limits."""
    from scipy.special import ndtri

    middle = (low + high) / 2
    return Deviation(middle, sigma, lambda u: middle + sigma * ndtri(u))


@register("uniform", free=False)
def _uniform(low: float, high: float, _: float) -> Deviation:
    return Deviation((low + high) / 2, (high - low) / 12**0.5, lambda u: low + (high - low) * u)


@register("triangular", free=False)
def _triangular(low: float, high: float, _: float) -> Deviation:
    half = (high - low) / 2

    def quantile(u: Array) -> Array:
        return np.where(u < 0.5, low + half * np.sqrt(2 * u), high - half * np.sqrt(2 * (1 - u)))

    return Deviation((low + high) / 2, half / 6**0.5, quantile)


@register("truncated", free=True)
def _truncated(low: float, high: float, sigma: float) -> Deviation:
    """The normal one cut at the limits; ``sigma`` is that before the cut.

    With a = (high - low) / (2 sigma), its variance is sigma^2 (1 - 2 a phi(a) / (2 Phi(a) - 1)) (Johnson, Kotz,
    Balakrishnan, Continuous Univariate Distributions 1, 2nd ed. 1994, 13.10.1).
    """
    from scipy.special import erf, gammainc, ndtr, ndtri

    middle, a = (low + high) / 2, (high - low) / (2 * sigma)
    # The variance is sigma^2 P(3/2, a^2/2) / P(1/2, a^2/2): the same without loss of digits where a is small.
    true = sigma * float(np.sqrt(gammainc(1.5, a * a / 2) / erf(a / 2**0.5)))
    below, share = float(ndtr(-a)), float(erf(a / 2**0.5))

    def quantile(u: Array) -> Array:
        # From the nearer tail, where there are digits.
        side = np.where(u < 0.5, 1.0, -1.0)
        rank = below + share * np.minimum(u, 1 - u)
        return np.asarray(np.clip(middle + side * sigma * ndtri(rank), low, high))

    return Deviation(middle, true, quantile)
