"""The worst case by search: against all vertices, against a fine grid where it lies inside, and on mechanisms."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.expressions import units as u
from linkwright.measures import bound_measures
from linkwright.results import Run
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.accuracy.outcome import OutputDeviations, SearchedWorstCase
from linkwright.studies.accuracy.worst_case_vertices import check_searched, evaluating, search
from linkwright.studies.figures import FigureColumn
from studies.accuracy.by_hand import Array, contributors
from studies.models import four_bar


def box(*limits: tuple[float, float]) -> Contributors:
    every = [
        Contributor(f"d{i}", np.zeros(1), 0, low, high, 0, 1, lambda u: u, u.LENGTH, "m", 1, "-", "uniform")
        for i, (low, high) in enumerate(limits)
    ]
    return Contributors(tuple(every), np.eye(len(every)))


def figure(of: Contributors, f: Callable[[Array], Array], name: str = "f", size: float = 1e-7) -> OutputDeviations:
    """A figure with its linear worst case, from central differences."""
    n = len(of)
    ends = [f(sign * size * np.eye(n)) for sign in (-1, 1)]
    nominal, c = float(f(np.zeros((n, 1)))[0]), (ends[1] - ends[0]) / (2 * size)
    moved = np.stack([c * of.low, c * of.high])
    worst = float(moved.min(axis=0).sum()), float(moved.max(axis=0).sum())
    column = FigureColumn(name, "", u.LENGTH, "m", 1.0)
    return OutputDeviations(column, nominal, None, np.stack([c, c], axis=1), worst=worst)


def found(of: Contributors, f: Callable[[Array], Array], share: float = 0.05) -> tuple[SearchedWorstCase, int]:
    """What the search finds for one function, and of how many places."""
    batches: list[int] = []

    def evaluate(d: Array) -> dict[str, Array]:
        batches.append(d.shape[1])
        return {"f": f(d)}

    (result,) = search(evaluate, of, {"f": figure(of, f)}, share).values()
    assert result.looked == sum(batches)
    assert len(batches) < 250
    for value, at in ((result.low, result.low_at), (result.high, result.high_at)):
        assert f(at[:, None])[0] - f(np.zeros((len(of), 1)))[0] == pytest.approx(value, rel=1e-12)
        assert (at >= of.low).all()
        assert (at <= of.high).all()
    return result, sum(batches)


def test_where_the_linear_one_is_right_its_vertices_are_enough() -> None:
    c = np.array([2.0, -1.0, 0.5])
    result, looked = found(box((-1, 1), (-2, 3), (0, 1)), lambda d: 5 + c @ d)
    assert (result.low, result.high) == pytest.approx((-2 - 3, 2 + 2 + 0.5))
    assert result.high_at.tolist() == [1, -2, 1]
    assert (looked, result.proven, result.lost) == (2 + 6, False, 0)
    assert result.off == pytest.approx(0, abs=1e-6)


def test_all_vertices_of_a_few_contributors() -> None:
    """A product of sums: the linear coefficients name the wrong vertices."""
    a = np.random.default_rng(2).normal(size=(3, 8))

    def f(d: Array) -> Array:
        return np.prod(a @ d + 0.3, axis=0)

    result, _ = found(box(*[(-1.0, 1.0)] * 8), f)
    every = np.array([*itertools.product([-1.0, 1.0], repeat=8)]).T
    exact = f(every) - f(np.zeros((8, 1)))
    assert result.off > 0.05
    assert result.low <= exact.min() + 1e-12
    assert result.high >= exact.max() - 1e-12
    assert not result.proven


@pytest.mark.parametrize("seed", [0, 1, 7])
def test_flips_find_the_worst_of_many_vertices(seed: int) -> None:
    """14 contributors with random products of two (convex upward along no coordinate): all 2^14 are the test's."""
    random = np.random.default_rng(seed)
    q, c = random.normal(size=(14, 14)), random.normal(size=14)
    np.fill_diagonal(q, 0.0)

    def f(d: Array) -> Array:
        return np.einsum("in,ij,jn->n", d, q, d) + c @ d

    result, looked = found(box(*[(-1.0, 1.0)] * 14), f)
    assert result.off > 0.05
    every = np.array([*itertools.product([-1.0, 1.0], repeat=14)]).T
    exact = f(every)
    assert result.low <= 0.97 * exact.min()  # a search: not always the very one
    assert result.high >= 0.97 * exact.max()
    assert looked < 14_000


def test_the_worst_lies_inside() -> None:
    """A hill at (0.3, -0.2) on a slope, whose top no vertex has."""

    def f(d: Array) -> Array:
        return 0.2 * d[0] + np.exp(-((d[0] - 0.3) ** 2) - 2 * (d[1] + 0.2) ** 2 + 0.5 * d[0] * d[1])

    of = box((-1, 1), (-1, 1))
    result, _ = found(of, f)
    grid = np.stack(np.meshgrid(*[np.linspace(-1, 1, 801)] * 2)).reshape(2, -1)
    exact = f(grid) - f(np.zeros((2, 1)))
    assert result.high == pytest.approx(exact.max(), abs=1e-6)
    assert result.high >= exact.max() - 1e-12
    assert (np.abs(result.high_at) < 0.7).all()
    assert result.low == pytest.approx(exact.min(), abs=1e-6)


def test_an_extreme_of_design_has_no_linear_width() -> None:
    result, _ = found(box((-1, 2), (-1, 1)), lambda d: 1 - d[0] ** 2 - d[1] ** 2)
    assert result.off > 1
    assert (result.low, result.high) == pytest.approx((-5, 0), abs=1e-12)


def test_a_tie_has_its_least_value_at_the_nominal_place() -> None:
    of, column = box((-1, 1), (-1, 2)), FigureColumn("f", "", u.LENGTH, "m", 1.0)
    given = OutputDeviations(column, 0.0, None, np.array([[-3.0, 1.0], [1.0, 1.0]]), worst=(-1.0, 5.0))
    result = search(lambda d: {"f": np.where(d[0] < 0, -3 * d[0], d[0]) + d[1]}, of, {"f": given}, 0.05)["f"]
    assert (result.low, result.high, result.off) == pytest.approx((-1, 5, 0))
    assert result.low_at.tolist() == [0, -1]


def test_a_box_without_width_is_looked_at_all_over() -> None:
    result, _ = found(box((0.5, 0.5), (0, 0)), lambda d: d[0] + d[1] ** 2)
    assert (result.low, result.high, result.proven) == (0.5, 0.5, True)


def test_places_that_have_no_value_are_counted() -> None:
    """Where the sum is over 0.5 nothing can be assembled: the worst is that of the rest, and it's said."""

    def f(d: Array) -> Array:
        return np.where(d.sum(axis=0) > 0.5, np.nan, d[0] + d[1])

    result, _ = found(box((-1, 1), (-1, 1)), f)
    assert result.off == np.inf
    assert result.lost > 0
    assert result.low == -2
    assert result.high == pytest.approx(0.5, abs=1e-3)
    (finding,) = check_searched({"f": result})
    assert (finding.code, finding.severity) == ("accuracy.vertices-fail", "warning")
    assert f"{result.lost} of {result.looked}" in finding.what
    assert not [*check_searched({})]


def test_nothing_can_be_assembled() -> None:
    of = box((-1, 1))
    given = {"f": figure(of, lambda d: d[0])}
    result = search(lambda d: {"f": np.full(d.shape[1], np.nan)}, of, given, 0.1)
    assert np.isnan([result["f"].low, result["f"].high]).all()
    assert np.isnan(result["f"].low_at).all()


@pytest.mark.parametrize(("half", "searched"), [(2e-5, False), (4e-3, True)])
def test_a_four_bar_s_swing(half: float, searched: bool) -> None:
    """Small deviations are linear; of large ones all vertices and a grid of places inside are evaluated by hand."""
    data: dict[str, Any] = four_bar(measures={"swing": {"span": "rocker.angle"}})
    compiled = lw.compile(lw.Document.model_validate(data))
    of = contributors(compiled, dict.fromkeys("abcd", (half, "uniform")))
    evaluate = evaluating(Run(compiled, 0.0, 1.0, 36), of, bound_measures(compiled.quantities))
    given = figure(of, lambda d: evaluate(d)["swing"], "swing")
    result = search(evaluate, of, {"swing": given}, 0.05)["swing"]

    def swing(d: Array) -> Array:
        """The rocker's ends are where crank and coupler lie in line: law of cosines."""
        a, b, c, e = np.array([[0.04], [0.12], [0.08], [0.1]]) + d
        ends = [np.arccos((c**2 + e**2 - (b + sign * a) ** 2) / (2 * c * e)) for sign in (1, -1)]
        return np.asarray(ends[0] - ends[1])

    grid = half * np.array([*itertools.product(np.linspace(-1, 1, 9), repeat=4)]).T
    exact = swing(grid) - swing(np.zeros((4, 1)))
    assert (result.off > 0.05) == searched
    assert (result.looked > 2 + 8) == searched
    assert result.low <= exact.min() + 1e-9
    assert result.high >= exact.max() - 1e-9
    assert result.high == pytest.approx(float(swing(result.high_at[:, None])[0] - swing(np.zeros((4, 1)))[0]), abs=1e-9)
