"""What intervals promise is held to random samples of known distributions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from linkwright.studies.accuracy.intervals import (
    convergence,
    counted_coverage,
    coverage,
    kurtosis,
    of_mean,
    of_sigma,
)

RANDOM = np.random.default_rng(8)


def test_order_statistics_by_hand() -> None:
    """JCGM 101:2008, 7.7.2: of M = 10^4 and p = 0.9973 q = 9973, r = 14; of M = 100 and p = 0.95 q = 95, r = 3."""
    assert coverage(RANDOM.permutation(10_000) + 1.0, 0.9973) == (14, 9987)
    assert coverage(RANDOM.permutation(100) + 1.0, 0.95) == (3, 98)
    assert coverage(np.array([3.0, 1.0, 2.0]), 0.9973) == (1, 3)
    assert coverage(np.array([7.0]), 0.9973) == (7, 7)
    assert np.isnan(coverage(np.empty(0), 0.9973)).all()


def test_counts_give_the_same_interval() -> None:
    values = RANDOM.normal(size=200_000)
    edges = np.linspace(-6, 6, 4097)
    found = counted_coverage(edges, np.histogram(values, edges)[0], (0, 0), 0.95)
    assert found == pytest.approx(coverage(values, 0.95), abs=12 / 4096)
    beyond = counted_coverage(edges, np.histogram(values, edges)[0], (20_000, 0), 0.95)
    assert np.isnan(beyond[0])
    assert np.isfinite(beyond[1])


def test_of_normal_values_the_interval_of_sigma_is_chi_square_s() -> None:
    ends = [np.sqrt(49 / stats.chi2.ppf(p, 49)) for p in (0.975, 0.025)]
    assert of_sigma(1.0, 50, 3.0, 0.95) == pytest.approx(ends, rel=1e-12)


@pytest.mark.parametrize("law", [stats.norm(), stats.uniform(), stats.triang(0.5), stats.expon()])
def test_intervals_keep_their_promise(law: stats.rv_continuous) -> None:
    """Of 1000 sets of 400 samples some 95 % have the true figure inside; a little less of those with heavy tails."""
    sets = law.rvs((1000, 400), random_state=9)
    inside = np.zeros(2)
    for values in sets:
        mean, sigma = values.mean(), values.std(ddof=1)
        of = of_mean(mean, sigma, 400, 0.95), of_sigma(sigma, 400, kurtosis(values), 0.95)
        assert of[0] is not None
        assert of[1] is not None
        inside += [of[0][0] < law.mean() < of[0][1], of[1][0] < law.std() < of[1][1]]
    error = 5 * np.sqrt(0.95 * 0.05 / 1000)
    assert abs(inside[0] / 1000 - 0.95) < error
    assert abs(inside[1] / 1000 - 0.95) < error + (0.05 if law.dist.name == "expon" else 0)
    if law.dist.name == "uniform":  # where the usual interval would be too wide
        assert np.ptp(of_sigma(1.0, 400, 1.8, 0.95) or ()) < 0.7 * np.ptp(of_sigma(1.0, 400, 3.0, 0.95) or ())


def test_too_few_samples_for_an_interval() -> None:
    assert of_mean(1.0, np.nan, 1, 0.95) is None
    assert of_sigma(1.0, 7, 3.0, 0.95) is None
    assert of_sigma(0.0, 9, np.nan, 0.95) == (0.0, 0.0)
    assert of_sigma(1.0, 1000, 1.0, 0.95) is not None  # two values alike often: nothing is known better


def test_convergence_of_values_of_which_some_are_missing() -> None:
    values = RANDOM.normal(size=1000)
    values[::7] = np.nan
    rows = convergence(values, 12)
    assert rows[0, 0] == 16
    assert rows[-1] == pytest.approx([1000, np.nanmean(values), np.nanstd(values, ddof=1)], rel=1e-12)
    assert (np.diff(rows[:, 0]) > 0).all()
    assert convergence(np.full(3, np.nan), 12).shape == (1, 3)
