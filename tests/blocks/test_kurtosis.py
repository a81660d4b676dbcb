"""The kurtosis of samples: SciPy's, in any strips, folded unit by unit."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from blocks.test_reductions import reduced, same_bits, state, values
from linkwright.blocks import Fourth


@pytest.mark.parametrize("mean", [0.0, 1e6])
def test_kurtosis_is_scipy_s(mean: float) -> None:
    y = mean + np.random.default_rng(1).exponential(size=(2, 3000, 2))
    figures = reduced(Fourth(), y, unit=512)
    assert (figures["count"] == 3000).all()
    exact = stats.kurtosis(y - mean, axis=1, fisher=False)  # the difference loses nothing
    np.testing.assert_allclose(figures["kurtosis"], exact, rtol=1e-12)


def test_values_that_are_missing_or_all_the_same() -> None:
    y = values(2, 700, 3, missing=0.2)
    y[0, :, 0] = np.nan
    y[1, :300, 1] = np.nan
    y[1, :, 2] = 0.1
    figures = reduced(Fourth(), y, unit=300)
    for i, j in ((0, 1), (0, 2), (1, 0), (1, 1)):
        column = y[i, np.isfinite(y[i, :, j]), j]
        assert figures["kurtosis"][i, j] == pytest.approx(stats.kurtosis(column, fisher=False), rel=1e-12)
    assert np.isnan(figures["kurtosis"][[0, 1], [0, 2]]).all()
    assert figures["count"][0, 0] == 0


@pytest.mark.parametrize("poses", [1, 4])
def test_strips_change_no_bit(poses: int) -> None:
    y = values(2, 500, poses, missing=0.1)
    assert same_bits(state(Fourth(), y), state(Fourth(), y, strip=7))
