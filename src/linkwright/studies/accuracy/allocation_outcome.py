"""What an allocation gives: the cheapest tolerances, what each is worth, and the proof that they are."""

from __future__ import annotations

from math import inf

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Allotted:
    """A contributor's half-widths in SI: ``now``, as stated; ``half``, the cheapest, between ``low`` and ``high``;
    ``rounded``, that of the ``grade`` (None where nothing is rounded, or nothing fits).

    ``costs`` are those of the three, infinite where the law has none; ``price`` is what one more m (rad) of half-width
    saves at the optimum. A ``fixed`` one has no cost and keeps its tolerance.
    """

    name: str
    unit: str
    size: float
    now: float
    half: float
    low: float = 0.0
    high: float = inf
    rounded: float | None = None
    grade: str | None = None
    costs: tuple[float, float, float | None] = (0.0, 0.0, None)
    price: float = 0.0
    fixed: bool = False


@dataclass(frozen=True, eq=False)
class AllocatedTarget:
    """A target in SI: the half-width ``wanted`` of an output, what it is ``now``, ``after``, and with ``rounded``
    tolerances; ``price`` is what one more SI unit of it would save. ``coefficients`` (rows, contributors) are those
    used: a row for each pose of a signal, else one; ``row`` is the one that comes closest to the target."""

    name: str
    unit: str
    size: float
    method: str
    wanted: float
    now: float
    after: float
    rounded: float | None
    price: float
    coefficients: Array
    row: int

    @property
    def passed(self) -> bool:
        """Whether the optimum keeps the target."""
        return self.after <= self.wanted * (1 + 1e-8)


@dataclass(frozen=True)
class Optimality:
    """How far the optimum is from the conditions of Karush, Kuhn and Tucker, relative to the cost: the marginal costs
    that the multipliers leave unexplained, the most that a target is exceeded, multipliers of targets with slack."""

    stationarity: float
    feasibility: float
    complementarity: float

    @property
    def worst(self) -> float:
        """The largest of the three."""
        return max(self.stationarity, self.feasibility, self.complementarity)


@dataclass(frozen=True)
class Allocation:
    """The cheapest half-widths.

    ``costs`` are the totals now, at the optimum and rounded; ``bound`` is one that no rounded choice can go below, and
    ``proven`` that ``rounded`` is the cheapest. Where the targets can't be ``reached``, the half-widths are those that
    come closest to them; where they are ``loose``, the largest half-widths keep them.
    """

    items: tuple[Allotted, ...]
    targets: tuple[AllocatedTarget, ...]
    sigmas: float
    costs: tuple[float, float, float | None]
    bound: float | None
    proven: bool
    optimality: Optimality
    reached: bool
    loose: bool

    @property
    def loss(self) -> float | None:
        """What rounding costs."""
        return None if self.costs[2] is None else self.costs[2] - self.costs[1]
