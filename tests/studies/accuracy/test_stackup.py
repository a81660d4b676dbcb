"""What deviations make together, against every vertex of the box and against sums written out."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from linkwright.expressions import units as u
from linkwright.reductions import Derivative
from linkwright.studies.accuracy.contributors import Contributor, Contributors
from linkwright.studies.accuracy.stackup import shares, spread, worst

LIMITS = [(-0.02, 0.05), (0.01, 0.03), (-0.04, -0.01), (-0.02, 0.02)]
SIGMA = np.array([0.01, 0.003, 0.005, 0.02])


def contributors(correlation: np.ndarray) -> Contributors:
    every = tuple(
        Contributor(
            f"p{i}", np.eye(4)[i], 1.0, *limits, sum(limits) / 2, sigma, np.asarray, u.LENGTH, "m", 1.0, "", "normal"
        )
        for i, (limits, sigma) in enumerate(zip(LIMITS, SIGMA, strict=True))
    )
    return Contributors(every, correlation)


VERTICES = np.array(list(product(*LIMITS))).T


def test_the_linear_worst_case_is_that_of_all_vertices() -> None:
    coefficients = np.random.default_rng(1).normal(size=(4, 7))
    least, largest = worst(coefficients, contributors(np.eye(4)))
    every = coefficients.T @ VERTICES
    np.testing.assert_allclose(least, every.min(axis=1))
    np.testing.assert_allclose(largest, every.max(axis=1))


def test_root_sum_square_counts_correlations() -> None:
    c = np.array([2.0, -1.0, 3.0, 0.5])
    mean, sigma = spread(c, contributors(np.eye(4)))
    assert sigma == pytest.approx(np.sqrt(((c * SIGMA) ** 2).sum()), rel=1e-14)
    assert mean == pytest.approx(2 * 0.015 - 0.02 - 3 * 0.025, rel=1e-12)
    together = np.eye(4)
    together[0, 2] = together[2, 0] = 1.0  # the two add up as one
    alone = spread(c, contributors(together))[1]
    assert alone == pytest.approx(np.sqrt((0.02 + 0.015) ** 2 + 0.003**2 + 0.01**2), rel=1e-12)
    assert shares(c, contributors(together)).sum() == pytest.approx(1.0)
    assert shares(np.zeros(4), contributors(together)).tolist() == [0.0] * 4


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_limits_of_a_tie_hold_every_vertex(sign: float) -> None:
    places = np.random.default_rng(2).normal(size=(3, 4))
    low, high = (np.array(ends) for ends in zip(*LIMITS, strict=True))
    one = Derivative("", None, places, sign)
    dense = low[:, None] + (high - low)[:, None] * np.random.default_rng(3).random((4, 20_000))
    changes = sign * (sign * places @ np.concatenate([VERTICES, dense], axis=1)).max(axis=0)
    least, largest = one.limits(low, high)
    assert least <= changes.min() + 1e-15
    assert largest >= changes.max() - 1e-15
    outer = (largest, changes.max()) if sign > 0 else (least, changes.min())
    assert outer[0] == pytest.approx(outer[1], rel=1e-12)  # this one is reached
    below, above = one.sides.T
    for i, step in enumerate(np.eye(4)):
        assert sign * (sign * places @ step).max() == pytest.approx(above[i])
        assert -sign * (-sign * places @ step).min() == pytest.approx(above[i])
        assert sign * (-sign * places @ step).max() == pytest.approx(-below[i])
