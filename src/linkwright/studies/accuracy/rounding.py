r"""Half-widths out of standard grades or processes: the cheapest choice that keeps the targets, by branch and bound.

With the multipliers :math:`\mu` of the continuous optimum :math:`d^*`, no choice is cheaper than the least of the
Lagrangian :math:`f(d) + \sum_j \mu_j (g_j(d) - 1)` (weak duality; Boyd and Vandenberghe, 5.1.3). The uses
:math:`g_j = d^T M d` are bounded from below by a sum of terms of one half-width each,

    g(d) >= g(d*) + g'(d*) (d - d*) + sum_i delta_i (d_i - d*_i)^2,   delta = lambda diag(M),

with the least eigenvalue :math:`\lambda` of M scaled to a unit diagonal. Without correlations both sides are equal. So
a bound is a sum of the least terms of what isn't chosen yet.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.accuracy.allocation_problem import SLACK, Problem

Array = NDArray[np.float64]

Options = tuple[tuple[str, float], ...]
"""Labels and half-widths that an item may be rounded to."""

MOST = 50_000
"""Nodes after which the search ends with the best that is found."""
_MOST_LOOKS = 4_000
"""Changes that are tried on the first choice."""
NEAR = 0.8
"""Rows that use more of their target than this are looked at first."""


@dataclass(frozen=True, eq=False)
class RoundedWidths:
    """Half-widths (free items,) with label and half-width of each; None where no choice keeps the targets, or none is
    found. ``bound`` is a cost that no choice can go below; ``proven`` that there is none better."""

    halves: Array | None
    labels: list[tuple[str, float]] | None
    bound: float
    proven: bool


def rounded(problem: Problem, halves: Array, multipliers: Array, least: float, most: int = MOST) -> RoundedWidths:
    """The cheapest choice. ``least`` is the cost of the continuous optimum ``halves`` with its ``multipliers``."""
    options = [problem.items[i].choices for i in problem.free]
    costs = [np.array([law.cost(half) for _, half in some]) for law, some in zip(problem.laws, options, strict=True)]
    rows = _rows(problem, halves, multipliers)
    uses = _separated(problem, halves, rows, options)
    search = _RoundingSearch(problem, options, costs, uses, multipliers[rows], most)
    search.run(_first(problem, options, halves))
    bound = max(least, search.root)
    if search.best is None:
        return RoundedWidths(None, None, bound, search.whole)
    labels = [some[k] for some, k in zip(options, search.best, strict=True)]
    return RoundedWidths(
        np.array([half for _, half in labels]), labels, search.cost if search.whole else bound, search.whole
    )


def _rows(problem: Problem, halves: Array, multipliers: Array) -> list[int]:
    """The rows that bound the search: those with a multiplier, and of each demand the one that is used most."""
    uses = problem.target_use(halves)
    worst = [int(np.flatnonzero(problem.owner == k)[uses[problem.owner == k].argmax()]) for k in set(problem.owner)]
    return sorted({*worst, *np.flatnonzero(multipliers > 0).tolist()})


def _separated(problem: Problem, halves: Array, rows: list[int], options: list[Options]) -> list[Array]:
    """Terms of each item's options in lower bounds of the uses: a list of (rows, options); the constant is shared
    out."""
    uses, slopes = problem.target_use(halves)[rows], problem.slopes(halves)[rows]
    weights = problem.weights[rows][:, problem.free]
    correlation = problem.correlation[np.ix_(problem.free, problem.free)]
    signs = np.sign(weights)[:, :, None] * np.sign(weights)[:, None, :] * correlation
    live = weights != 0
    signs[:, range(len(options)), range(len(options))] = 1.0
    lowest = np.array([max(0.0, float(np.linalg.eigvalsh(sign[np.ix_(on, on)])[0])) if on.any() else 0.0
                       for sign, on in zip(signs, live, strict=True)])  # fmt: skip
    curved = np.where(problem.squared[rows], lowest, 0.0)[:, None] * weights**2
    found = []
    for i, some in enumerate(options):
        off = np.array([half for _, half in some]) - halves[i]
        found.append(uses[:, None] / len(options) + slopes[:, i, None] * off + curved[:, i, None] * off**2)
    return found


def _first(problem: Problem, options: list[Options], halves: Array) -> list[int]:
    """A good choice: the next finer options, loosened as far as the targets allow; then, as long as that saves, one
    option tightened by a step and another one loosened."""
    steps = [sorted(range(len(some)), key=lambda k, some=some: some[k][1]) for some in options]  # type: ignore[misc]
    sizes = [np.array([some[k][1] for k in order]) for some, order in zip(options, steps, strict=True)]
    costs = [np.array([law.cost(half) for half in size]) for law, size in zip(problem.laws, sizes, strict=True)]
    chosen = [max(int((size <= half * (1 + SLACK)).sum()) - 1, 0) for size, half in zip(sizes, halves, strict=True)]
    looks, near = _MOST_LOOKS, _near(problem, halves)

    def choice_after(*moves: tuple[int, int]) -> list[int]:
        made = [*chosen]
        for i, by in moves:
            made[i] += by
        return made

    def meets_targets(choice: list[int]) -> bool:
        made = np.array([size[k] for size, k in zip(sizes, choice, strict=True)])
        return near.meets_targets(made) and problem.meets_targets(made)

    def step(i: int, by: int) -> float:
        """What a step saves; nothing can be stepped to beyond the ends."""
        k = chosen[i] + by
        return float(costs[i][chosen[i]] - costs[i][k]) if 0 <= k < costs[i].size else -np.inf

    while looks:
        single = [(step(i, by), ((i, by),)) for i in range(len(options)) for by in (1, 2)]
        double = [
            (step(i, 1) + step(k, -1), ((i, 1), (k, -1)))
            for i in range(len(options))
            for k in range(len(options))
            if i != k
        ]
        for _, moves in sorted((move for move in [*single, *double] if move[0] > 0), reverse=True):
            looks -= 1
            if meets_targets(choice_after(*moves)):
                chosen = choice_after(*moves)
                break
            if not looks:
                break
        else:
            break
    return [order[k] for order, k in zip(steps, chosen, strict=True)]


def _near(problem: Problem, halves: Array) -> Problem:
    """The problem with those rows alone that come near their targets."""
    close, demands = problem.target_use(halves) > NEAR, []
    for k, demand in enumerate(problem.demands):
        if (mine := close[problem.owner == k]).any():
            demands.append(replace(demand, coefficients=demand.coefficients[mine]))
    return replace(problem, demands=demands or problem.demands)


class _RoundingSearch:
    """Depth first, the cheapest first."""

    def __init__(
        self,
        problem: Problem,
        options: list[Options],
        costs: list[Array],
        uses: list[Array],
        multipliers: Array,
        most: int,
    ) -> None:
        self.problem, self.left = problem, most
        self.halves = [[half for _, half in some] for some in options]
        prices = [cost + multipliers @ use for cost, use in zip(costs, uses, strict=True)]
        self.order = sorted(range(len(options)), key=lambda i: -float(np.ptp(prices[i])))
        self.costs = [cost.tolist() for cost in costs]
        self.prices, self.uses = [price.tolist() for price in prices], [use.T.tolist() for use in uses]
        self.start = -float(multipliers.sum())
        n, rows = len(options), len(multipliers)
        self.rest, self.slack = [0.0] * (n + 1), [[0.0] * rows for _ in range(n + 1)]
        for place in range(n - 1, -1, -1):
            i = self.order[place]
            self.rest[place] = self.rest[place + 1] + min(self.prices[i])
            self.slack[place] = [
                a + b for a, b in zip(self.slack[place + 1], uses[i].min(axis=1).tolist(), strict=True)
            ]
        self.root = self.start + self.rest[0]
        self.cost, self.best = np.inf, None  # type: float, list[int] | None
        self.whole = True

    def run(self, first: list[int]) -> None:
        """Search, beginning with a first choice."""
        self._look(first)
        self._from(0, self.start, [0.0] * len(self.slack[0]), [0] * len(self.order))

    def _look(self, chosen: list[int]) -> None:
        cost = sum(costs[k] for costs, k in zip(self.costs, chosen, strict=True))
        if cost < self.cost and self.problem.meets_targets(
            np.array([halves[k] for halves, k in zip(self.halves, chosen, strict=True)])
        ):
            self.cost, self.best = cost, [*chosen]

    def _from(self, place: int, price: float, used: list[float], chosen: list[int]) -> None:
        if place == len(self.order):
            self._look(chosen)
            return
        i = self.order[place]
        for k in sorted(range(len(self.prices[i])), key=self.prices[i].__getitem__):
            bound = price + self.prices[i][k]
            if bound + self.rest[place + 1] >= self.cost * (1 - 1e-12):
                return
            if not self.left:
                self.whole = False
                return
            now = [a + b for a, b in zip(used, self.uses[i][k], strict=True)]
            if any(a + b > 1 + 1e-7 for a, b in zip(now, self.slack[place + 1], strict=True)):
                continue
            self.left -= 1
            chosen[i] = k
            self._from(place + 1, bound, now, chosen)
