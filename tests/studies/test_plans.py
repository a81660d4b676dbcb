"""Plans: grids by hand, slices of Latin hypercubes, Sobol' points against SciPy's; units stand by themselves."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from scipy import stats
from scipy.stats import qmc

from linkwright.blocks import UNIT
from linkwright.studies.distributions import Listed, Normal, ParameterSpread, Uniform
from linkwright.studies.plans import PLANS, Grid, Latin, Plan, Random, Sobol, register


def listed(*values: float) -> ParameterSpread:
    return Listed(values).spread([*values])


UNIT_SQUARE = [Uniform.model_validate({"uniform": [0, 1]}).spread([0.0, 1.0]) for _ in range(2)]
FREE = [name for name, plan in PLANS.items() if plan.chosen]


def everything(plan: Plan) -> np.ndarray:
    return np.concatenate([plan.values(unit) for unit in range(-(-plan.samples // UNIT))], axis=1)


def test_a_grid_by_hand() -> None:
    plan = Grid([listed(1, 2), listed(10, 20, 30)], 4096, 0)
    assert plan.samples == 6
    assert plan.values(0).tolist() == [[1, 1, 1, 2, 2, 2], [10, 20, 30, 10, 20, 30]]


def test_a_grid_over_several_units_is_the_product_in_order() -> None:
    points = [[*map(float, range(n))] for n in (7, 30, 41)]
    plan = Grid([listed(*values) for values in points], 4096, 0)
    assert plan.samples == 8610
    assert everything(plan).T.tolist() == [list(row) for row in itertools.product(*points)]


def test_a_sample_of_a_huge_grid_needs_no_table() -> None:
    many = listed(*map(float, range(2000)))
    plan = Grid([many, many, many], 4096, 0)
    assert plan.samples == 8 * 10**9
    k = plan.samples - 1
    assert plan.values(k // UNIT)[:, k % UNIT].tolist() == [1999, 1999, 1999]


@pytest.mark.parametrize("samples", [5, 1000, 10_000])
def test_a_latin_hypercube_has_one_sample_in_every_slice(samples: int) -> None:
    values = everything(Latin(UNIT_SQUARE, samples, 3))
    for row in values:
        assert sorted((row * samples).astype(int)) == list(range(samples))
    assert abs(np.corrcoef(values)[0, 1]) < 5 / np.sqrt(samples)


def test_sobol_points_are_those_of_scipy() -> None:
    plan = Sobol(UNIT_SQUARE, 3 * UNIT - 7, 11)
    whole = qmc.Sobol(2, scramble=True, bits=32, rng=11).random(4 * UNIT).T[:, : plan.samples]
    np.testing.assert_allclose(everything(plan), whole, atol=2.0**-32, rtol=0)


def test_sobol_points_in_any_order_of_units() -> None:
    forth, back = Sobol(UNIT_SQUARE, 4 * UNIT, 1), Sobol(UNIT_SQUARE, 4 * UNIT, 1)
    units = [forth.values(unit) for unit in range(4)]
    for unit in (3, 1, 1, 0, 2):
        assert (back.values(unit) == units[unit]).all()


@pytest.mark.parametrize("name", FREE)
def test_a_unit_is_the_same_whenever_it_is_asked_for(name: str) -> None:
    first, second = (PLANS[name](UNIT_SQUARE, 2 * UNIT + 100, 5) for _ in range(2))
    assert (first.values(2) == second.values(2)).all()
    assert first.values(2).shape == (2, 100)
    assert (first.values(0) == second.values(0)).all()
    assert not (first.values(0) == first.values(1)).any()
    assert not (PLANS[name](UNIT_SQUARE, 2 * UNIT + 100, 6).values(0) == first.values(0)).any()


@pytest.mark.parametrize("name", ["random", "sobol"])
def test_more_samples_begin_with_the_fewer(name: str) -> None:
    few, many = PLANS[name](UNIT_SQUARE, 50, 5), PLANS[name](UNIT_SQUARE, UNIT + 50, 5)
    assert (few.values(0) == many.values(0)[:, :50]).all()


@pytest.mark.parametrize("name", FREE)
def test_samples_follow_their_distribution(name: str) -> None:
    normal = Normal.model_validate({"normal": 0, "sigma": 1}).spread([0.0, 1.0])
    values = everything(PLANS[name]([normal, *UNIT_SQUARE], 20_000, 2))
    assert np.isfinite(values).all()
    assert stats.kstest(values[0], "norm").pvalue > 1e-3
    assert stats.kstest(values[1], "uniform").pvalue > 1e-3


def test_random_samples_are_independent() -> None:
    values = everything(Random(UNIT_SQUARE, 40_000, 2))
    assert abs(np.corrcoef(values)[0, 1]) < 0.02
    assert abs(np.corrcoef(values[0, :-1], values[0, 1:])[0, 1]) < 0.02


def test_a_second_plan_of_the_same_name_is_refused() -> None:
    with pytest.raises(ValueError, match="registered twice"):
        register(type("Other", (Grid,), {}))
    assert set(PLANS) == {"grid", "latin", "random", "sobol"}
