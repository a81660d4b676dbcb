"""What deviates: parameters with their tolerances, temperatures; and how their deviations go together."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.units import Dimension

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Contributor:
    """One deviation, all in SI.

    ``direction`` (parameters,) are the derivatives of all parameters, in the order of the graph's, by the deviation;
    it lies within ``low`` .. ``high`` and has ``mean`` and ``sigma``; ``quantile`` gives it at shares in (0, 1), in
    arrays of any shape. ``unit`` is the one it is shown in, ``size`` that unit in SI; ``stated`` is how the file says
    it (``ISO 2768-m``, ``0.05``).
    """

    name: str
    direction: Array
    nominal: float
    low: float
    high: float
    mean: float
    sigma: float
    quantile: Callable[[Array], Array]
    dimension: Dimension
    unit: str
    size: float
    stated: str
    distribution: str


@dataclass(frozen=True, eq=False)
class Contributors:
    """All of them, and the correlation coefficients (Pearson's) of their deviations: (contributors, contributors).
    ``parameters`` is how many the graph has, which nothing else tells where none deviates."""

    every: tuple[Contributor, ...]
    correlation: Array
    parameters: int = 0

    def __len__(self) -> int:
        return len(self.every)

    @property
    def names(self) -> list[str]:
        """Their names."""
        return [one.name for one in self.every]

    @property
    def directions(self) -> Array:
        """(parameters, contributors)."""
        if not self.every:
            return np.empty((self.parameters, 0))
        return np.stack([one.direction for one in self.every], axis=1)

    @property
    def low(self) -> Array:
        """The least deviations: (contributors,)."""
        return np.array([one.low for one in self.every])

    @property
    def high(self) -> Array:
        """The largest deviations: (contributors,)."""
        return np.array([one.high for one in self.every])

    @property
    def mean(self) -> Array:
        """The mean deviations: (contributors,)."""
        return np.array([one.mean for one in self.every])

    @property
    def sigma(self) -> Array:
        """The standard deviations: (contributors,)."""
        return np.array([one.sigma for one in self.every])

    @property
    def covariance(self) -> Array:
        """Of the deviations: (contributors, contributors)."""
        return self.correlation * np.outer(self.sigma, self.sigma)
