"""Allocation against closed forms, brute force and full enumeration."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from linkwright.studies.accuracy.allocation_problem import Demand, Item, Problem
from linkwright.studies.accuracy.allocation_solver import allocate
from linkwright.studies.accuracy.costs import CostLaw, Processes, Reciprocal, ReciprocalSquared

MM = 1e-3
B = (2.0, 1.0, 3.0)
C = np.array([[0.8, -1.3, 0.4]])


def reciprocal(b: float) -> CostLaw:
    return Reciprocal(reciprocal=b).law(MM, lambda grade: None)


def items(laws: Sequence[CostLaw | None], choices: Any = (), low: float = 1e-6, high: float = 1e-3) -> list[Item]:
    return [Item(f"p{i}", 5e-5, 1 / 3, law, low, high, choices) for i, law in enumerate(laws)]


@pytest.mark.parametrize("method", ["worst", "rss"])
def test_closed_forms_of_the_reciprocal_law(method: str) -> None:
    """By the stationary Lagrangian: half-widths as sqrt(b/|c|) in the worst case, as (b/c^2)^(1/3) statistically."""
    b, c = np.array(B), np.abs(C[0])
    shape = np.sqrt(b / c) if method == "worst" else np.cbrt(b / c**2)
    width = c @ shape if method == "worst" else np.sqrt(c**2 @ shape**2)
    expected = shape * 1e-4 / width
    found = allocate(Problem(items([reciprocal(b) for b in B]), [Demand("x", 1e-4, C, method)], np.eye(3)))
    np.testing.assert_allclose([item.half for item in found.items], expected, rtol=1e-9)
    assert found.costs[1] == pytest.approx(float((b * MM / expected).sum()), rel=1e-9)
    assert found.optimality.worst < 1e-9
    # As half-widths scale with the target, so does the cost with its reciprocal.
    assert found.targets[0].price == pytest.approx(found.costs[1] / 1e-4, rel=1e-9)
    assert found.targets[0].passed


def test_brute_force_on_three_parameters() -> None:
    """A fine grid of two half-widths, the third as large as the targets allow: the same cost to 0.1 %."""
    rho = np.array([[1, 0.6, 0], [0.6, 1, -0.3], [0, -0.3, 1.0]])
    rows = np.array([[0.8, -1.3, 0.4], [0.5, 0.9, 1.1]])
    laws = [reciprocal(2), ReciprocalSquared(reciprocal_squared=0.04).law(MM, lambda grade: None), reciprocal(3)]
    problem = Problem(items(laws), [Demand("x", 1e-4, rows[:1]), Demand("y", 1.5e-4, rows[1:], "worst")], rho)
    found = allocate(problem)
    d0, d1 = np.meshgrid(*(np.geomspace(2e-5, 3e-4, 1200),) * 2)
    m = rho * np.outer(rows[0], rows[0]) / 1e-8  # d M d <= 1, of which the third half-width is a root
    linear, constant = 2 * (m[2, 0] * d0 + m[2, 1] * d1), m[0, 0] * d0**2 + 2 * m[0, 1] * d0 * d1 + m[1, 1] * d1**2 - 1
    with np.errstate(invalid="ignore"):
        root = (-linear + np.sqrt(linear**2 - 4 * m[2, 2] * constant)) / (2 * m[2, 2])
    d2 = np.fmin(np.fmin(root, (1.5e-4 - 0.5 * d0 - 0.9 * d1) / 1.1), 1e-3)
    cost = np.where(d2 > 1e-6, 2 * MM / d0 + 0.04e-6 / d1**2 + 3 * MM / np.where(d2 > 0, d2, 1), np.inf)
    assert found.costs[1] <= np.nanmin(cost)
    assert found.costs[1] == pytest.approx(float(np.nanmin(cost)), rel=1e-3)
    assert found.optimality.worst < 1e-8


def test_of_two_targets_the_active_one_has_a_price() -> None:
    laws = [reciprocal(b) for b in B]

    def solved(x: float, y: float) -> Any:
        return allocate(Problem(items(laws), [Demand("x", x, C), Demand("y", y, C / 2)], np.eye(3)))

    found = solved(1e-4, 1e-4)
    assert found.targets[1].price == 0
    assert found.targets[1].after == pytest.approx(0.5e-4, rel=1e-9)
    step = 1e-8  # the price is the derivative of the least cost
    slope = (solved(1e-4 - step, 1e-4).costs[1] - solved(1e-4 + step, 1e-4).costs[1]) / (2 * step)
    assert found.targets[0].price == pytest.approx(slope, rel=1e-5)
    for item in found.items:
        assert item.price == pytest.approx(B[int(item.name[1])] * MM / item.half**2, rel=1e-12)


def test_every_pose_of_a_signal_keeps_the_target() -> None:
    angles = np.linspace(0, np.pi, 181)
    rows = np.stack([np.cos(angles), np.sin(angles), 0.3 + 0 * angles], axis=1)
    problem = Problem(items([reciprocal(b) for b in B]), [Demand("E.x", 1e-4, rows)], np.eye(3))
    found = allocate(problem)
    halves = np.array([item.half for item in found.items])
    widths = np.sqrt((rows**2) @ halves**2)
    assert widths.max() == pytest.approx(1e-4, rel=1e-8)
    assert np.sum(widths > 1e-4 * (1 - 1e-6)) >= 2  # more than one pose decides
    assert found.optimality.worst < 1e-8


def test_parameters_without_a_cost_eat_of_the_budget() -> None:
    laws = [reciprocal(2), None, reciprocal(3)]
    found = allocate(Problem(items(laws), [Demand("x", 1e-4, C, "worst")], np.eye(3)))
    assert found.items[1].fixed
    assert found.items[1].half == 5e-5
    assert 0.8 * found.items[0].half + 0.4 * found.items[2].half == pytest.approx(1e-4 - 1.3 * 5e-5, rel=1e-9)


def test_out_of_reach_and_already_met() -> None:
    laws = [reciprocal(b) for b in B]
    far = allocate(Problem(items(laws), [Demand("x", 1e-6, C, "worst")], np.eye(3)))
    assert not far.reached
    assert [item.half for item in far.items] == [1e-6] * 3
    assert far.targets[0].after == pytest.approx(2.5e-6, rel=1e-12)
    loose = allocate(Problem(items(laws), [Demand("x", 1.0, C)], np.eye(3)))
    assert loose.loose
    assert [item.half for item in loose.items] == [1e-3] * 3
    assert loose.targets[0].price == 0
    assert loose.optimality.worst == 0


def test_errors_of_parts_made_together_may_cancel() -> None:
    """With correlation 1 and opposite signs equal errors cancel; the tightest are then not the best."""
    pair = [Item("a", 5e-5, 1 / 3, reciprocal(2), 1e-6, 1e-3), Item("b", 5e-5, 1 / 3, reciprocal(1), 5e-6, 1e-3)]
    demand = Demand("x", 2e-6, np.array([[1.0, -1.0]]))
    assert allocate(Problem(pair, [demand], np.ones((2, 2)))).reached
    assert not allocate(Problem(pair, [demand], np.eye(2))).reached
    far = allocate(Problem(pair, [Demand("x", 1e-7, np.array([[1.0, -0.5]]))], np.ones((2, 2))))
    assert far.reached  # a = 1e-6 .. , b = 2 a


HALVES = tuple(5e-6 * 1.6**k for k in range(8))


@pytest.mark.parametrize("correlated", [False, True])
@pytest.mark.parametrize("method", ["worst", "rss"])
def test_rounding_against_full_enumeration(method: str, correlated: bool) -> None:
    rng = np.random.default_rng(5)
    root, rows = rng.normal(size=(5, 7)), rng.normal(size=(2, 5))
    rho = root @ root.T if correlated else np.eye(5)
    rho /= np.sqrt(np.outer(np.diag(rho), np.diag(rho)))
    choices = tuple((f"{k}", half) for k, half in enumerate(HALVES))
    b = np.array([2, 1, 3, 1.5, 0.3])
    parts = items([reciprocal(float(value)) for value in b], choices, HALVES[0], HALVES[-1])
    problem = Problem(parts, [Demand("x", 1e-4, rows[:1], method), Demand("y", 8e-5, rows[1:])], rho)
    found = allocate(problem)
    every = np.array([*itertools.product(HALVES, repeat=5)])
    widths = [np.sqrt((every * c @ rho * (every * c)).sum(axis=1)) for c in rows]
    if method == "worst":
        widths[0] = every @ np.abs(rows[0])
    kept = (widths[0] <= 1e-4) & (widths[1] <= 8e-5)
    cheapest = float((b * MM / every).sum(axis=1)[kept].min())
    assert found.proven
    assert found.costs[2] == pytest.approx(cheapest, rel=1e-12)
    assert found.bound == pytest.approx(cheapest, rel=1e-12)
    assert found.loss is not None
    assert found.loss > 0
    assert all(target.rounded <= target.wanted * (1 + 1e-9) for target in found.targets if target.rounded)


def test_processes_against_full_enumeration() -> None:
    """Tables of process costs, one of them not convex: the discrete optimum, and the hull's below it."""
    tables = [
        [[0.01, 12], [0.02, 8], [0.04, 3], [0.08, 2]],
        [[0.01, 9], [0.02, 8.5], [0.04, 2], [0.08, 1.9]],
        [[0.005, 20], [0.02, 6], [0.06, 4]],
    ]
    laws = [Processes(table=table).law(MM, lambda grade: None) for table in tables]
    parts = [
        Item(f"p{i}", 5e-5, 1 / 3, law, law.halves[0], law.halves[-1], tuple(zip(law.labels, law.halves, strict=True)))
        for i, law in enumerate(laws)
    ]
    found = allocate(Problem(parts, [Demand("x", 5e-5, C)], np.eye(3)))
    sets = [
        sum(cost for _, cost in choice)
        for choice in itertools.product(*tables)
        if np.hypot.reduce(C[0] * [half for half, _ in choice]) <= 0.05
    ]
    assert found.costs[2] == pytest.approx(min(sets), rel=1e-12)
    assert found.costs[1] <= min(sets)
    assert found.optimality.worst < 1e-6
