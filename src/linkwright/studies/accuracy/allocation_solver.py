r"""Tolerance allocation: the cheapest tolerances with which all outputs meet their targets.

Costs are convex in the half-widths :math:`d`. Of the two kinds of rows of a problem (``allocation_problem.py``) the
first is a convex quadratic (a correlation matrix has no negative eigenvalue), the second is linear: the problem is
convex, so a point that meets the conditions of Karush, Kuhn and Tucker is the optimum (Boyd and Vandenberghe, Convex
Optimization, 2004, 5.5.3).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.studies.accuracy.allocation_outcome import AllocatedTarget, Allocation, Allotted, Optimality
from linkwright.studies.accuracy.allocation_problem import SLACK, Problem, hull
from linkwright.studies.accuracy.convex_minimum import Convex, Values, minimum
from linkwright.studies.accuracy.costs import NEAR, CostLaw, Stepped
from linkwright.studies.accuracy.rounding import RoundedWidths, rounded

Array = NDArray[np.float64]

NONE = 1e-8
"""A multiplier below this share of the cost is what an interior point method leaves where there is slack."""
APART = 1e-9
"""Half-widths that may not vary get this share of room, in which a method of inner points can move."""


def allocate(problem: Problem) -> Allocation:
    """The cheapest half-widths; where an item has choices, the cheapest of these as well."""
    # If even the loosest tolerances meet all targets there is nothing to solve; if the tightest do not, they cannot
    # be met.
    low, high = problem.half_width_limits
    halves, multipliers, reached = high, np.zeros(problem.owner.size), True
    loose = problem.meets_targets(high)
    if not loose:
        halves = low if problem.meets_targets(low) else _closest(problem)
        reached = problem.meets_targets(halves)
    # In between: the convex optimum.
    if not loose and reached:
        halves, multipliers = _optimum(problem)
    cost = problem.hull(halves)
    # Round to grades, if every item has a list of choices.
    choice = rounded(problem, halves, multipliers, cost) if reached and _all_have_choices(problem) else None
    return _outcome(problem, halves, multipliers, cost, choice, reached, loose)


def _all_have_choices(problem: Problem) -> bool:
    return all(problem.items[i].choices for i in problem.free)


def optimality(problem: Problem, halves: Array, multipliers: Array) -> Optimality:
    """The conditions of Karush, Kuhn and Tucker, taken from the laws and the rows alone."""
    cost, uses = problem.hull(halves), problem.target_use(halves)
    low, high = problem.half_width_limits
    # Stationarity: at the optimum each marginal cost equals the weighted sum of the rows' slopes; at a kink or at an
    # end of its range it may lie between the one-sided slopes.
    needed, off = -multipliers @ problem.slopes(halves), 0.0
    for i, (law, half) in enumerate(zip(problem.laws, halves, strict=True)):
        below, above = law.slopes(half)
        below = -np.inf if half <= low[i] * (1 + NEAR) else below
        above = np.inf if half >= high[i] * (1 - NEAR) else above
        off = max(off, (below - needed[i]) * half, (needed[i] - above) * half)
    # Complementarity: a row with a multiplier must be fully used.
    slack = float(np.abs(multipliers * (1 - uses)).max())
    return Optimality(
        float(off / cost if cost else off), max(0.0, float(uses.max()) - 1), slack / cost if cost else slack
    )


def _optimum(problem: Problem) -> tuple[Array, Array]:
    """The optimum and the multiplier of each row. Rows are taken in as they are exceeded: few of a signal's poses ever
    are."""
    multipliers, halves = np.zeros(problem.owner.size), problem.half_width_limits[1]
    rows: list[int] = []
    while True:
        uses = problem.target_use(halves)
        # Active set: add the most exceeded row of each target and solve again, until no row is exceeded.
        worst = [int(np.flatnonzero(problem.owner == k)[uses[problem.owner == k].argmax()]) for k in _demands(problem)]
        new = [row for row in worst if uses[row] > 1 + SLACK and row not in rows]
        if not new:
            return halves, multipliers
        rows += new
        halves, found = _solved(problem, rows)
        multipliers[:] = 0.0
        multipliers[rows] = found


def _demands(problem: Problem) -> range:
    return range(len(problem.demands))


class _Scaled:
    """A problem as a convex one in variables of a size of about 1: the free half-widths over their means ``middle``,
    then further variables of which conditions are made."""

    def __init__(self, problem: Problem, rows: Sequence[int], further: Array) -> None:
        self.problem, self.rows = problem, [*rows]
        low, high = problem.half_width_limits
        self.middle = np.sqrt(low * high)
        self.count = self.middle.size
        self.start = np.concatenate([np.ones(self.count), further])
        self.low = low / self.middle * (1 - APART)
        self.high = high / self.middle * (1 + APART)

    def halves(self, x: Array) -> Array:
        """The free half-widths."""
        return self.middle * x[: self.count]

    def uses(self, x: Array) -> tuple[Array, Array]:
        """How much of its target each row uses, and its slopes by all variables."""
        halves = self.halves(x)
        slopes = np.zeros((len(self.rows), x.size))
        slopes[:, : self.count] = self.problem.slopes(halves)[self.rows] * self.middle
        return self.problem.target_use(halves)[self.rows], slopes

    def ends(self, x: Array) -> tuple[Array, Array]:
        """That half-widths lie in their ranges, as conditions, with their slopes."""
        y = x[: self.count]
        slopes = np.zeros((2 * self.count, x.size))
        slopes[range(self.count), range(self.count)] = -1.0
        slopes[range(self.count, 2 * self.count), range(self.count)] = 1.0
        return np.concatenate([self.low - y, y - self.high]), slopes

    def curvature(self, x: Array, multipliers: Array) -> Array:
        """The curvature of the uses: that of a square doesn't change."""
        found = np.zeros((x.size, x.size))
        problem, free = self.problem, self.problem.free
        for row, multiplier in zip(self.rows, multipliers, strict=False):
            if problem.squared[row]:
                weights = problem.weights[row][free] * self.middle
                correlation = problem.correlation[np.ix_(free, free)]
                found[: self.count, : self.count] += 2 * multiplier * correlation * np.outer(weights, weights)
        return found


def _solved(problem: Problem, rows: Sequence[int]) -> tuple[Array, Array]:
    """The optimum under some rows, and their multipliers (of uses, in cost)."""
    # Smooth laws enter the cost as they are. A stepped law enters as its convex hull: a variable above all its
    # straight pieces (epigraph form).
    laws = problem.laws
    stepped = [i for i, law in enumerate(laws) if isinstance(law, Stepped)]
    scaled = _Scaled(problem, rows, np.zeros(len(stepped)))
    scale = problem.hull(scaled.middle) or 1.0
    levels = [hull(laws[i], scaled.middle[i]) / scale + 1.0 for i in stepped]
    scaled.start[scaled.count :] = levels
    pieces = [(scaled.count + k, i, a / scale, s / scale) for k, i in enumerate(stepped) for a, s in _pieces(laws[i])]

    def values(x: Array) -> Values:
        halves, gradient = scaled.halves(x), np.zeros(x.size)
        gradient[scaled.count :] = 1.0
        for i, law in enumerate(laws):
            if i not in stepped:
                gradient[i] = law.slopes(halves[i])[0] * scaled.middle[i] / scale
        above, above_slopes = np.zeros(len(pieces)), np.zeros((len(pieces), x.size))
        for row, (level, i, a, s) in enumerate(pieces):
            above[row] = a + s * halves[i] - x[level]
            above_slopes[row, [i, level]] = s * scaled.middle[i], -1.0
        uses, slopes = scaled.uses(x)
        ends, end_slopes = scaled.ends(x)
        return Values(
            gradient, np.concatenate([uses - 1.0, above, ends]), np.vstack([slopes, above_slopes, end_slopes])
        )

    def curvature(x: Array, multipliers: Array) -> Array:
        found = scaled.curvature(x, multipliers[: len(rows)])
        for i, law in enumerate(laws):
            if not isinstance(law, Stepped):
                found[i, i] += law.curvature(scaled.halves(x)[i]) * scaled.middle[i] ** 2 / scale  # type: ignore[attr-defined]
        return found

    x, multipliers = minimum(Convex(scaled.start, values, curvature))
    # Tiny multipliers are what an interior point method leaves, and count as zero.
    of_rows = multipliers[: len(rows)]
    halves = np.clip(scaled.halves(x), *problem.half_width_limits)
    return halves, np.where(of_rows < NONE, 0.0, of_rows) * scale


def _pieces(law: CostLaw) -> list[tuple[float, float]]:
    """The straight pieces of a stepped law's hull, intercepts and slopes; the last is its least cost."""
    assert isinstance(law, Stepped)
    return [*zip(*(part.tolist() for part in law.pieces), strict=True), (float(law.costs.min()), 0.0)]


def _closest(problem: Problem) -> Array:
    """The half-widths that come closest to the targets: the least ones, unless errors of parts that are made together
    cancel."""
    low, high = problem.half_width_limits
    # Without negative correlations smaller tolerances always help, so the least ones are closest.
    part = problem.weights[problem.squared][:, :, None] * problem.weights[problem.squared][:, None, :]
    if not (part * problem.correlation < 0).any():
        return low
    # Otherwise minimise the largest use of all rows, a variable above all of them.
    rows = range(problem.owner.size)
    scaled = _Scaled(problem, rows, np.zeros(1))
    scaled.start[-1] = problem.target_use(scaled.middle).max() + 1.0

    def values(x: Array) -> Values:
        gradient = np.zeros(x.size)
        gradient[-1] = 1.0
        uses, slopes = scaled.uses(x)
        slopes[:, -1] = -1.0
        ends, end_slopes = scaled.ends(x)
        return Values(gradient, np.concatenate([uses - x[-1], ends]), np.vstack([slopes, end_slopes]))

    x, _ = minimum(Convex(scaled.start, values, lambda x, multipliers: scaled.curvature(x, multipliers[: len(rows)])))
    halves = np.clip(scaled.halves(x), low, high)
    return np.asarray(halves if problem.shares(halves).max() < problem.shares(low).max() else low)


def _outcome(
    problem: Problem,
    halves: Array,
    multipliers: Array,
    cost: float,
    choice: RoundedWidths | None,
    reached: bool,
    loose: bool,
) -> Allocation:
    """All of it put together."""
    chosen = choice.halves if choice is not None else None
    costs = problem.cost(problem.now[problem.free]), cost, None if chosen is None else problem.cost(chosen)
    if reached:
        proof = optimality(problem, halves, multipliers)
    else:
        proof = Optimality(0.0, float(problem.target_use(halves).max()) - 1, 0.0)
    return Allocation(
        tuple(_items(problem, halves, multipliers, choice)),
        tuple(_targets(problem, halves, multipliers, chosen)),
        problem.sigmas,
        costs,
        choice.bound if choice is not None else None,
        choice is not None and choice.proven,
        proof,
        reached,
        loose,
    )


def _items(problem: Problem, halves: Array, multipliers: Array, choice: RoundedWidths | None) -> Iterator[Allotted]:
    needed, place = -multipliers @ problem.slopes(halves), {item: i for i, item in enumerate(problem.free)}
    for k, one in enumerate(problem.items):
        if one.law is None:
            yield Allotted(one.name, one.unit, one.size, one.now, one.now, fixed=True)
            continue
        i, half = place[k], float(halves[place[k]])
        label, fine = choice.labels[i] if choice is not None and choice.labels is not None else (None, None)
        costs = one.law.cost(one.now), hull(one.law, half), None if fine is None else one.law.cost(fine)
        price = 0.0 - float(np.clip(needed[i], *one.law.slopes(half)))
        ends = one.low, one.high
        yield Allotted(one.name, one.unit, one.size, one.now, half, *ends, fine, label, costs, price)


def _targets(problem: Problem, halves: Array, multipliers: Array, chosen: Array | None) -> Iterator[AllocatedTarget]:
    now, after = problem.shares(problem.now[problem.free]), problem.shares(halves)
    fine, uses = None if chosen is None else problem.shares(chosen), problem.target_use(halves)
    for k, demand in enumerate(problem.demands):
        mine, wanted = problem.owner == k, demand.wanted
        power = 2 if demand.method == "rss" else 1
        yield AllocatedTarget(
            demand.name,
            demand.unit,
            demand.size,
            demand.method,
            wanted,
            float(now[k] * wanted),
            float(after[k] * wanted),
            None if fine is None else float(fine[k] * wanted),
            float(power * (multipliers * uses)[mine].sum() / wanted),
            demand.coefficients,
            int(uses[mine].argmax()),
        )
