"""Wilson's interval against SciPy's, and how often it holds."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from linkwright.studies.shares import wilson


@pytest.mark.parametrize(("met", "samples"), [(0, 10), (1, 10), (5, 10), (10, 10), (37, 50), (9_990, 10_000), (1, 1)])
def test_the_interval_is_that_of_scipy(met: int, samples: int) -> None:
    share, known = wilson(met, samples), stats.binomtest(met, samples).proportion_ci(0.95, method="wilson")
    assert share.value == met / samples
    assert (share.low, share.high) == pytest.approx((known.low, known.high), abs=1e-12)


def test_it_holds_some_95_times_in_100() -> None:
    hits = np.random.default_rng(1).binomial(200, 0.9, 2000)
    held = [(share := wilson(int(met), 200)).low <= 0.9 <= share.high for met in hits]
    assert np.mean(held) == pytest.approx(0.95, abs=0.02)
