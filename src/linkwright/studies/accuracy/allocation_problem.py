r"""What allocation is asked: contributors with their cost laws, and targets with the coefficients that lead to them.

With half-widths :math:`d`, coefficients :math:`c`, :math:`\sigma_i = k_i d_i` and correlations :math:`\rho`, each row
of coefficients of a target :math:`T` asks for

    rss:    sum_ij c_i c_j k_i k_j rho_ij d_i d_j <= (T / sigmas)^2
    worst:  sum_i |c_i| d_i <= T
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.accuracy.costs import CostLaw, Stepped

Array = NDArray[np.float64]

SLACK = 1e-9
"""How far a target may be exceeded, relatively: what rounding errors of an optimum on its border make."""


@dataclass(frozen=True, eq=False)
class Item:
    """A contributor: its half-width ``now`` and ``spread``, sigma over half-width. One with a ``law`` is allotted a
    half-width between ``low`` and ``high``; ``choices`` are the labels and half-widths to which it may be rounded."""

    name: str
    now: float
    spread: float
    law: CostLaw | None = None
    low: float = 0.0
    high: float = np.inf
    choices: tuple[tuple[str, float], ...] = ()
    unit: str = ""
    size: float = 1.0


@dataclass(frozen=True, eq=False)
class Demand:
    """A target: an output's half-width ``wanted``, by the ``method`` ``rss`` or ``worst``, of ``coefficients`` (rows,
    items), each row of which must keep it."""

    name: str
    wanted: float
    coefficients: Array
    method: str = "rss"
    unit: str = ""
    size: float = 1.0


@dataclass(frozen=True, eq=False)
class Problem:
    """Items with the correlations (items, items) of their deviations, and what is wanted; all in SI."""

    items: Sequence[Item]
    demands: Sequence[Demand]
    correlation: Array
    sigmas: float = 3.0

    @cached_property
    def free(self) -> list[int]:
        """Which items are allotted something."""
        return [i for i, item in enumerate(self.items) if item.law is not None]

    @cached_property
    def laws(self) -> list[CostLaw]:
        """Their laws."""
        return [item.law for item in self.items if item.law is not None]

    @cached_property
    def now(self) -> Array:
        """The stated half-widths: (items,)."""
        return np.array([item.now for item in self.items])

    @cached_property
    def half_width_limits(self) -> tuple[Array, Array]:
        """The least and the largest half-widths of the free items."""
        return np.array([self.items[i].low for i in self.free]), np.array([self.items[i].high for i in self.free])

    @cached_property
    def owner(self) -> NDArray[np.int64]:
        """To which demand each row belongs: (rows,)."""
        return np.repeat(np.arange(len(self.demands)), [d.coefficients.shape[0] for d in self.demands])

    @cached_property
    def squared(self) -> NDArray[np.bool_]:
        """Whether a row's use is a square (rss): (rows,)."""
        return np.array([d.method == "rss" for d in self.demands])[self.owner]

    @cached_property
    def weights(self) -> Array:
        """Coefficients over what is wanted: (rows, items); of rss times ``sigmas`` and spread, of worst positive."""
        spread, rows = np.array([item.spread for item in self.items]), []
        for demand in self.demands:
            c = demand.coefficients / demand.wanted
            rows.append(c * spread * self.sigmas if demand.method == "rss" else np.abs(c))
        return np.concatenate(rows)

    def full(self, halves: Array) -> Array:
        """All half-widths from those of the free items."""
        every = self.now.copy()
        every[self.free] = halves
        return every

    def target_use(self, halves: Array) -> Array:
        """How much of its target each row uses: (rows,), 1 being all of it; of rss the square."""
        part = self.weights * self.full(halves)
        return np.asarray(np.where(self.squared, ((part @ self.correlation) * part).sum(axis=1), part.sum(axis=1)))

    def slopes(self, halves: Array) -> Array:
        """The derivatives of the uses by the free items: (rows, free)."""
        part = self.weights * self.full(halves)
        slopes = np.where(self.squared[:, None], 2 * self.weights * (part @ self.correlation), self.weights)
        return np.asarray(slopes[:, self.free])

    def shares(self, halves: Array) -> Array:
        """The largest half-width of each demand over what is wanted: (demands,)."""
        uses = self.target_use(halves)
        shares = np.where(self.squared, np.sqrt(np.maximum(uses, 0)), uses)
        return np.array([shares[self.owner == k].max() for k in range(len(self.demands))])

    def meets_targets(self, halves: Array) -> bool:
        """Whether all rows keep their targets."""
        return bool(self.target_use(halves).max() <= 1 + SLACK)

    def cost(self, halves: Array) -> float:
        """The cost of the free items."""
        return float(sum(law.cost(half) for law, half in zip(self.laws, halves, strict=True)))

    def hull(self, halves: Array) -> float:
        """The same with the convex hulls of stepped laws: less than any choice of processes costs."""
        return float(sum(hull(law, half) for law, half in zip(self.laws, halves, strict=True)))


def hull(law: CostLaw, half: float) -> float:
    """The cost of a half-width by the convex hull of a stepped law; by any other law the cost itself."""
    if not isinstance(law, Stepped):
        return law.cost(half)
    intercepts, slopes = law.pieces
    return float(max([law.costs.min(), *(intercepts + slopes * half)]))
