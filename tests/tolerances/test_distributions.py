"""Distributions of deviations: quantiles invert the distribution; mean and deviation are those of the density."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

from linkwright.tolerances import DISTRIBUTIONS
from linkwright.tolerances.distributions import register

LIMITS = -0.3, 0.5
# The integral of a density over the reals is cut where nothing is left.
DENSITIES = {
    "normal": (lambda x, s: mp.npdf(x, 0.1, s), lambda s: [0.1 - 12 * s, 0.1, 0.1 + 12 * s]),
    "uniform": (lambda x, s: 1 / mp.mpf("0.8"), lambda s: [*LIMITS]),
    "triangular": (lambda x, s: (mp.mpf("0.4") - abs(x - mp.mpf("0.1"))) / mp.mpf("0.16"), lambda s: [-0.3, 0.1, 0.5]),
    "truncated": (lambda x, s: mp.npdf(x, 0.1, s) / mp.erf(0.4 / s / mp.sqrt(2)), lambda s: [-0.3, 0.1, 0.5]),
}


@pytest.mark.parametrize("sigma", [0.1, 0.3, 40.0])
@pytest.mark.parametrize("name", DISTRIBUTIONS)
def test_against_the_density(name: str, sigma: float) -> None:
    density, ends = DENSITIES[name]
    made = DISTRIBUTIONS[name].make(*LIMITS, sigma)
    points = ends(sigma)
    mean, square = (mp.quad(lambda x, k=k: x**k * density(x, sigma), points) for k in (1, 2))
    assert made.mean == pytest.approx(float(mean), abs=1e-12 * max(1, sigma))
    assert made.sigma == pytest.approx(float(mp.sqrt(square - mean**2)), rel=1e-9)
    shares = np.array([1e-6, 0.02, 0.3, 0.5, 0.9, 1 - 1e-6])
    values = made.quantile(shares)
    below = [
        float(mp.quad(lambda x: density(x, sigma), [*(p for p in points if p < value), value])) for value in values
    ]
    assert below == pytest.approx(shares.tolist(), rel=1e-6)
    if name != "normal":
        assert (values >= LIMITS[0]).all()
        assert (values <= LIMITS[1]).all()
    assert made.quantile(shares.reshape(2, 3)).shape == (2, 3)


def test_a_narrow_normal_distribution_isnt_touched_by_its_limits() -> None:
    cut, whole = (DISTRIBUTIONS[name].make(*LIMITS, 0.01) for name in ("truncated", "normal"))
    assert cut.sigma == pytest.approx(whole.sigma, rel=1e-14)
    u = np.linspace(0.001, 0.999, 99)
    assert cut.quantile(u) == pytest.approx(whole.quantile(u), abs=1e-15)


def test_a_wide_one_becomes_uniform() -> None:
    cut, uniform = (DISTRIBUTIONS[name].make(*LIMITS, 1e7) for name in ("truncated", "uniform"))
    assert cut.sigma == pytest.approx(uniform.sigma, rel=1e-12)


def test_a_distribution_registers_once() -> None:
    with pytest.raises(ValueError, match="normal"):
        register("normal", free=True)(DISTRIBUTIONS["normal"].make)
