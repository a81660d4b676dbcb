r"""Tolerance allocation: the cheapest tolerances with which all outputs meet their targets.

Costs are convex in the half-widths :math:`d`. Of the two kinds of rows of a problem (``allocation_problem.py``) the
first is a convex quadratic (a correlation matrix has no negative eigenvalue), the second is linear: the problem is
convex, so a point that meets the conditions of Karush, Kuhn and Tucker is the optimum (Boyd and Vandenberghe, Convex
Optimization, 2004, 5.5.3). It is solved in log d, where costs over decades are flat; a change of variables makes no new
optima.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.studies.accuracy.allocation_outcome import AllocatedTarget, Allocation, Allotted, Optimality
from linkwright.studies.accuracy.allocation_problem import SLACK, Problem, hull
from linkwright.studies.accuracy.costs import NEAR, Stepped
from linkwright.studies.accuracy.rounding import RoundedWidths, rounded

Array = NDArray[np.float64]

NONE = 1e-8
"""A multiplier below this share of the cost is what an interior point method leaves where there is slack."""
SETTINGS: dict[str, Any] = {
    "print_time": False,
    "ipopt.print_level": 0,
    "ipopt.sb": "yes",
    "ipopt.tol": 1e-11,
    "ipopt.constr_viol_tol": 1e-12,
    "ipopt.bound_relax_factor": 0.0,
    "ipopt.max_iter": 1000,
}


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


def _symbolic_target_use(problem: Problem, every: Any, rows: Sequence[int]) -> list[Any]:
    """The uses of some rows in symbols."""
    import casadi as ca

    found = []
    for row in rows:
        part = ca.DM(problem.weights[row]) * every
        found.append(ca.bilin(ca.DM(problem.correlation), part, part) if problem.squared[row] else ca.sum1(part))
    return found


def _symbols(problem: Problem) -> tuple[Any, Any, Array]:
    """The logarithms of the free half-widths over their means, all half-widths, and those means."""
    import casadi as ca

    low, high = problem.half_width_limits
    middle = np.sqrt(low * high)
    u = ca.SX.sym("u", len(problem.free))
    every = ca.SX(ca.DM(problem.now))
    every[problem.free] = ca.DM(middle) * ca.exp(u)
    return u, every, middle


def _solved(problem: Problem, rows: Sequence[int]) -> tuple[Array, Array]:
    """The optimum under some rows, and their multipliers (of uses, in cost)."""
    import casadi as ca

    low, high = problem.half_width_limits
    u, every, middle = _symbols(problem)
    scale = problem.hull(middle) or 1.0
    # Smooth laws enter the cost as formulas. A stepped law enters as its convex hull: a new variable above all
    # straight pieces (epigraph form).
    total, levels, pieces = ca.SX(0), [], []
    for half, law in zip(ca.vertsplit(every[problem.free]), problem.laws, strict=True):
        if isinstance(law, Stepped):  # a level above all pieces of the hull
            level = ca.SX.sym("level")
            levels.append(level)
            pieces += [(a + s * half) / scale - level for a, s in zip(*law.pieces, strict=True)]
            pieces.append(law.costs.min() / scale - level)
            total += level
        else:
            total += law.formula(half) / scale  # type: ignore[attr-defined]
    uses = _symbolic_target_use(problem, every, rows)
    # Solve with IPOPT in the logarithms of the half-widths; costs are scaled to about one.
    found = _minimum(
        ca.vertcat(u, *levels),
        total,
        ca.vertcat(*uses, *pieces),
        [*([1.0] * len(uses)), *([0.0] * len(pieces))],
        (np.log(low / middle), np.log(high / middle)),
    )
    # Undo the logarithm; tiny multipliers are what an interior point method leaves, and count as zero.
    halves = np.clip(middle * np.exp(np.array(found["x"]).ravel()[: low.size]), low, high)
    multipliers = np.array(found["lam_g"]).ravel()[: len(uses)]
    return halves, np.where(multipliers < NONE, 0.0, multipliers) * scale


def _closest(problem: Problem) -> Array:
    """The half-widths that come closest to the targets: the least ones, unless errors of parts that are made together
    cancel."""
    import casadi as ca

    low, high = problem.half_width_limits
    # Without negative correlations smaller tolerances always help, so the least ones are closest.
    part = problem.weights[problem.squared][:, :, None] * problem.weights[problem.squared][:, None, :]
    if not (part * problem.correlation < 0).any():
        return low
    u, every, middle = _symbols(problem)
    most = ca.SX.sym("most")
    uses = _symbolic_target_use(problem, every, range(problem.owner.size))
    # Otherwise minimise the largest use of all rows.
    found = _minimum(
        ca.vertcat(u, most),
        most,
        ca.vertcat(*uses) - most,
        [0.0] * len(uses),
        (np.log(low / middle), np.log(high / middle)),
    )
    halves = np.clip(middle * np.exp(np.array(found["x"]).ravel()[: low.size]), low, high)
    return np.asarray(halves if problem.shares(halves).max() < problem.shares(low).max() else low)


def _minimum(x: Any, f: Any, g: Any, most: list[float], ends: tuple[Array, Array]) -> Any:
    """Minimise f(x) where g(x) <= most and the first of x lie between the ends."""
    import casadi as ca

    open_ = [np.inf] * (x.numel() - ends[0].size)
    solver = ca.nlpsol("allocation", "ipopt", {"x": x, "f": f, "g": g}, SETTINGS)
    return solver(x0=0.0, lbx=[*ends[0], *(-value for value in open_)], ubx=[*ends[1], *open_], lbg=-np.inf, ubg=most)


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
