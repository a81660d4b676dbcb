"""Random mechanisms as they may be made: samples of the parameters from the contributors' deviations."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels import Compiled
from linkwright.model.sampled import names_in
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.copula import Copula, copula
from linkwright.studies.distributions import ParameterSpread
from linkwright.studies.plans import PLANS

Array = NDArray[np.float64]


class Shift:
    """What deviations do to the parameters: those called ``names``, which are no expressions of others, are shifted by
    the contributors, the others follow (:meth:`Varied.parameters`)."""

    def __init__(self, compiled: Compiled, contributors: Contributors) -> None:
        given = compiled.quantities.mechanism.parameters
        directions = contributors.directions
        rows = [
            i
            for i, name in enumerate(compiled.graph.parameters)
            if directions[i].any() and not names_in(given[name].value.node)
        ]
        self.names = tuple(compiled.graph.parameters[i] for i in rows)
        self._nominal, self._directions = compiled.parameters[rows, None], directions[rows]

    def values(self, deviations: Array) -> Array:
        """Values of the named parameters in SI, (names, samples), from (contributors, samples)."""
        return np.asarray(self._nominal + np.einsum("ij,jn->in", self._directions, deviations))


class Deviations:
    """Samples of the contributors by a plan, correlated as stated."""

    def __init__(self, compiled: Compiled, contributors: Contributors, plan: str, samples: int, seed: int) -> None:
        self.contributors, self.shift = contributors, Shift(compiled, contributors)
        self.plan = PLANS[plan]([ParameterSpread(one.quantile) for one in contributors.every], samples, seed)
        self.name, self.names = plan, self.shift.names
        self.samples, self.independent = self.plan.samples, self.plan.independent

    @cached_property
    def copula(self) -> Copula:
        """How they go together."""
        return copula(self.contributors)

    def deviations(self, unit: int) -> Array:
        """Those of a unit's samples in SI: (contributors, samples of the unit)."""
        shares = self.copula.shares(self.plan.shares(unit)[:, : self.plan.size(unit)])
        return np.stack([one.quantile(u) for one, u in zip(self.contributors.every, shares, strict=True)])

    def values(self, unit: int) -> Array:
        """The values of the parameters of a unit's samples in SI: (names, samples of the unit)."""
        return self.shift.values(self.deviations(unit))
