"""Plans: which values the samples of a sweep take. Each gives any unit of samples by itself, and always the same.

A plan is a class under ``@register``, named as in the file. Sources: Latin hypercube, McKay, Beckman and Conover,
Technometrics 21 (1979) 239-245; Sobol' points with the direction numbers of Joe and Kuo, SIAM J. Sci. Comput. 30
(2008) 2635-2654, randomised by a linear matrix scramble and a digital shift (Matousek, J. Complexity 14 (1998)
527-556), as SciPy has them.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from functools import cached_property
from math import prod
from threading import Lock
from typing import Any, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks import UNIT, generator
from linkwright.notation.registry import Registry
from linkwright.studies.distributions import ParameterSpread

Array = NDArray[np.float64]

MOST = 10**10
TINY = 2.0**-54
"""Shares of 0, which random numbers may be, are taken as this."""


class Draws(Protocol):
    """The samples of a study by a plan."""

    @property
    def name(self) -> str:
        """The plan's."""

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters that they have values of."""

    @property
    def samples(self) -> int:
        """How many samples there are."""

    @property
    def independent(self) -> bool:
        """Whether shares of samples have the confidence interval of independent ones (or a narrower one)."""

    def values(self, unit: int) -> Array:
        """The values of a unit's samples in SI, a function of the unit alone: (names, samples of the unit)."""


class Plan:
    """Base of the plans, over the spreads of the varied parameters in their order."""

    name: ClassVar[str]
    most: ClassVar[int] = MOST
    """The most samples."""
    chosen: ClassVar[bool] = True
    """Whether the number of samples is free, and distributions can be sampled."""
    independent: ClassVar[bool] = False
    """Whether shares of samples have the confidence interval of independent ones (or a narrower one)."""

    def __init__(self, spreads: Sequence[ParameterSpread], samples: int, seed: int, names: Sequence[str] = ()) -> None:
        self.spreads, self.samples, self.seed = tuple(spreads), self.count(spreads, samples), seed
        self.names = tuple(names)

    @classmethod
    def count(cls, spreads: Sequence[ParameterSpread], samples: int) -> int:
        """How many samples there are."""
        return samples

    def size(self, unit: int) -> int:
        """How many samples a unit has."""
        return min(self.samples - unit * UNIT, UNIT)

    @property
    def axes(self) -> tuple[Array, ...] | None:
        """The values (SI) that each parameter takes where the samples are all combinations of these, the last parameter
        changing fastest; else ``None``."""
        return None

    @abstractmethod
    def shares(self, unit: int) -> Array:
        """Shares in (0, 1) of a unit's samples: (names, samples of the unit, or more)."""

    def values(self, unit: int) -> Array:
        """The values of a unit's samples in SI: (names, samples of the unit)."""
        shares = self.shares(unit)[:, : self.size(unit)]
        return np.stack([spread.quantile(u) for spread, u in zip(self.spreads, shares, strict=True)])


PLANS: Registry[type[Plan]] = Registry()


def register(cls: type[Plan]) -> type[Plan]:
    """Register a plan under its name; a second one of the same name is an error."""
    PLANS[cls.name] = cls
    return cls


@register
class Grid(Plan):
    """Every combination of all points (full factorial), the last parameter changing fastest."""

    name = "grid"
    chosen = False

    @classmethod
    def count(cls, spreads: Sequence[ParameterSpread], samples: int) -> int:
        return prod(spread.points.size for spread in spreads if spread.points is not None)

    @property
    def axes(self) -> tuple[Array, ...]:
        return tuple(spread.points for spread in self.spreads if spread.points is not None)

    def shares(self, unit: int) -> Array:
        raise NotImplementedError

    def values(self, unit: int) -> Array:
        """Sample k has the digits of k in the mixed radix of the numbers of points."""
        rest = unit * UNIT + np.arange(self.size(unit), dtype=np.int64)
        rows: list[Array] = []
        for spread in reversed(self.spreads):
            assert spread.points is not None
            rest, digit = np.divmod(rest, spread.points.size)
            rows.append(spread.points[digit])
        return np.stack(rows[::-1])


@register
class Latin(Plan):
    """Latin hypercube: of n equal slices of each parameter's probability, every one has one sample."""

    name = "latin"
    most = 10**7  # the permutations are held in memory
    independent = True

    @cached_property
    def _slices(self) -> NDArray[np.int32]:
        def shuffled(i: int) -> NDArray[np.int32]:
            stream = np.random.SeedSequence(self.seed, spawn_key=(i, 0))  # apart from those of the units: (unit,)
            return np.random.Generator(np.random.PCG64(stream)).permutation(np.arange(self.samples, dtype=np.int32))

        return np.stack([shuffled(i) for i in range(len(self.spreads))])

    def shares(self, unit: int) -> Array:
        within = generator(self.seed, unit).random((UNIT, len(self.spreads))).T
        slices = self._slices[:, unit * UNIT : (unit + 1) * UNIT]
        shares = (slices + within[:, : slices.shape[1]]) / self.samples
        return np.asarray(np.clip(shares, TINY, 1 - TINY))


@register
class Random(Plan):
    """Independent samples."""

    name = "random"
    independent = True

    def shares(self, unit: int) -> Array:
        return np.asarray(np.maximum(generator(self.seed, unit).random((UNIT, len(self.spreads))).T, TINY))


@register
class Sobol(Plan):
    """Sobol' points, scrambled with the seed."""

    name = "sobol"
    BITS = 32
    most = 2**BITS

    def __init__(self, spreads: Sequence[ParameterSpread], samples: int, seed: int, names: Sequence[str] = ()) -> None:
        super().__init__(spreads, samples, seed, names)
        self._lock = Lock()
        self._engine: Any = None

    def shares(self, unit: int) -> Array:
        with self._lock:
            if self._engine is None or self._engine.num_generated > unit * UNIT:
                from scipy.stats import qmc

                self._engine = qmc.Sobol(len(self.spreads), scramble=True, bits=self.BITS, rng=self.seed)
            if skipped := unit * UNIT - self._engine.num_generated:
                self._engine.fast_forward(skipped)
            points = self._engine.random(UNIT)
        return np.asarray(points.T + 0.5 ** (self.BITS + 1))  # the middles of the cells: never 0
