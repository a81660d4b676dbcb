"""What varied parameters take: quantiles against SciPy's own distributions, moments, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy import stats

from linkwright.studies.distributions import DISTRIBUTIONS, Listed, Normal, Steps, Triangular, Uniform, register

U = np.concatenate([[2.0**-54, 1e-12, 1e-6], np.linspace(0.001, 0.999, 201), [1 - 1e-6, 1 - 1e-12]])


def spread(cls: Any, *numbers: float, **data: Any) -> Any:
    return cls.model_validate(data).spread([*numbers])


CASES = {
    "normal": (spread(Normal, 395.0, 0.02, normal=395, sigma=0.02), stats.norm(395.0, 0.02)),
    "both cut": (
        spread(Normal, 1.0, 0.5, 0.2, 1.4, normal=1, sigma=0.5, low=0.2, high=1.4),
        stats.truncnorm(-1.6, 0.8, 1.0, 0.5),
    ),
    "cut below": (spread(Normal, 0.0, 1.0, -0.5, normal=0, sigma=1, low=-0.5), stats.truncnorm(-0.5, np.inf)),
    "upper tail": (spread(Normal, 0.0, 1.0, 5.0, 5.5, normal=0, sigma=1, low=5, high=5.5), stats.truncnorm(5.0, 5.5)),
    "lower tail": (
        spread(Normal, 0.0, 1.0, -5.5, -5.0, normal=0, sigma=1, low=-5.5, high=-5),
        stats.truncnorm(-5.5, -5.0),
    ),
    "uniform": (spread(Uniform, 499.0, 501.0, uniform=[499, 501]), stats.uniform(499.0, 2.0)),
    "triangular": (spread(Triangular, 1.0, 1.2, 2.0, triangular=[1, 1.2, 2]), stats.triang(0.2, 1.0, 1.0)),
    "rising": (spread(Triangular, 1.0, 2.0, 2.0, triangular=[1, 2, 2]), stats.triang(1.0, 1.0, 1.0)),
    "falling": (spread(Triangular, 1.0, 1.0, 2.0, triangular=[1, 1, 2]), stats.triang(0.0, 1.0, 1.0)),
}


@pytest.mark.parametrize("name", CASES)
def test_quantiles_are_those_of_scipy(name: str) -> None:
    made, known = CASES[name]
    # Where a quantile is a difference of shares near 1, either side may lose digits: 1e-9 of the width.
    np.testing.assert_allclose(made.quantile(U), known.ppf(U), rtol=1e-12, atol=1e-9 * float(known.std()))


@pytest.mark.parametrize("name", CASES)
def test_mean_and_deviation_of_stratified_samples(name: str) -> None:
    made, known = CASES[name]
    values = made.quantile((np.arange(200_000) + 0.5) / 200_000)
    assert values.mean() == pytest.approx(known.mean(), abs=1e-5 * float(known.std()))
    assert values.std() == pytest.approx(known.std(), rel=1e-3)


@pytest.mark.parametrize("name", CASES)
def test_quantiles_rise_and_stay_in_the_range(name: str) -> None:
    made, known = CASES[name]
    values = made.quantile(np.sort(U))
    assert (np.diff(values) >= 0).all()
    low, high = known.support()
    assert low <= values[0]
    assert values[-1] <= high


def test_steps_hold_both_ends() -> None:
    made = Steps.model_validate({"from": 150, "to": 160, "count": 11}).spread([0.15, 0.16])
    assert made.points.tolist() == pytest.approx([0.15 + 0.001 * k for k in range(11)])
    assert made.points[-1] == 0.16


def test_points_are_equally_likely() -> None:
    made = Listed([1, 2, 5]).spread([1.0, 2.0, 5.0])
    assert made.quantile(np.array([0.0, 0.33, 0.34, 0.66, 0.67, 1 - 2.0**-53])).tolist() == [1, 1, 2, 2, 5, 5]


def test_a_second_distribution_of_the_same_name_is_refused() -> None:
    with pytest.raises(ValueError, match="registered twice"):
        register(type("Other", (Normal,), {}))
    assert set(DISTRIBUTIONS) == {"normal", "uniform", "triangular"}
