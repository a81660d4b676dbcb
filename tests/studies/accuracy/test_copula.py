"""Correlated deviations: closed forms, what samples have, what can't be had."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy import stats

import linkwright as lw
from linkwright.blocks import UNIT
from linkwright.findings import Joined
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.copula import CLOSED, cholesky, copula, definite, normal, pearson
from linkwright.studies.accuracy.deviations import Deviations
from studies.accuracy.by_hand import LAWS, Array, contributor
from studies.models import four_bar

COMPILED = lw.compile(lw.Document.model_validate(four_bar()))


def some(laws: list[str], correlation: object) -> Contributors:
    every = tuple(contributor(COMPILED, name, 1e-4, law) for name, law in zip("abcd", laws, strict=False))
    return Contributors(every, np.array(correlation, dtype=float))


def sampled(of: Contributors, plan: str = "random", samples: int = 8 * UNIT) -> Array:
    drawn = Deviations(COMPILED, of, plan, samples, 3)
    return np.concatenate([drawn.deviations(unit) for unit in range(-(-samples // UNIT))], axis=1)


@pytest.mark.parametrize("r", [-0.9, -0.3, 0.2, 0.7, 0.97])
def test_the_quadrature_is_the_closed_form(monkeypatch: pytest.MonkeyPatch, r: float) -> None:
    """Two uniform ones, 2 sin(pi r/6); two normal ones, r; one of each, r sqrt(pi/3) (Cario and Nelson)."""
    a, b = (contributor(COMPILED, "a", 1e-4, law) for law in ("uniform", "normal"))
    expected = {(0, 0): 2 * np.sin(np.pi * r / 6), (1, 1): r, (0, 1): r * np.sqrt(np.pi / 3)}
    monkeypatch.setattr("linkwright.studies.accuracy.copula.CLOSED", {})
    for (i, j), rho in expected.items():
        if abs(rho) < 1:
            assert normal((a, b)[i], (a, b)[j], r) == pytest.approx(rho, abs=1e-6)


@pytest.mark.parametrize("r", [-1.0, 0.0, 0.4, 1.0])
def test_closed_forms_and_back(r: float) -> None:
    for there, back in CLOSED.values():
        assert back(there(r)) == pytest.approx(r, abs=1e-15)


@pytest.mark.parametrize("laws", [("normal", "uniform"), ("triangular", "triangular"), ("skew", "normal")])
@pytest.mark.parametrize("plan", ["random", "latin", "sobol"])
def test_samples_have_the_stated_correlation(laws: tuple[str, str], plan: str) -> None:
    """Within five standard errors, those of the coefficient's influence function; and the distributions stay."""
    for r in (-0.6, 0.85):
        x, y = sampled(some([*laws], [[1, r], [r, 1]]), plan)
        u, v = ((row - row.mean()) / row.std() for row in (x, y))
        error = (u * v - r * (u * u + v * v) / 2).std() / np.sqrt(x.size)
        assert abs(np.mean(u * v) - r) < 5 * error
        for row, law in ((x, laws[0]), (y, laws[1])):
            assert stats.kstest(row, LAWS[law](1e-4).cdf).statistic < 2.2 / np.sqrt(x.size)  # p = 1e-4


@pytest.mark.parametrize("law", ["normal", "uniform", "triangular"])
@pytest.mark.parametrize("r", [1.0, -1.0])
def test_parts_made_together_deviate_alike(law: str, r: float) -> None:
    x, y, z = sampled(some([law, law, "normal"], [[1, r, 0], [r, 1, 0], [0, 0, 1]]), samples=UNIT)
    np.testing.assert_allclose(y, r * x, atol=1e-15)
    assert abs(np.corrcoef(x, z)[0, 1]) < 5 / np.sqrt(UNIT)


def test_independent_ones_are_the_plan_s() -> None:
    x, y = sampled(some(["normal", "uniform"], np.eye(2)), "latin", UNIT)
    for row, law in ((x, "normal"), (y, "uniform")):  # one in every slice
        assert sorted((LAWS[law](1e-4).cdf(row) * UNIT).astype(int)) == [*range(UNIT)]


def test_a_unit_stands_by_itself() -> None:
    of = some(["normal", "triangular"], [[1, 0.5], [0.5, 1]])
    whole, few = (Deviations(COMPILED, of, "random", n, 3) for n in (3 * UNIT, 2 * UNIT + 7))
    assert (whole.values(2)[:, :7] == few.values(2)).all()
    assert few.names == ("a", "b")
    np.testing.assert_array_equal(few.values(2), few.deviations(2) + COMPILED.parameters[:2, None])


def test_a_correlation_that_distributions_cannot_have() -> None:
    """A normal and a uniform one have sqrt(3/pi) = 0.9772 at most."""
    found = copula(some(["normal", "uniform"], [[1, 0.99], [0.99, 1]]))
    (finding,) = found.findings
    assert (finding.code, finding.severity) == ("accuracy.correlation-limit", "error")
    assert finding.data == {"names": Joined(["a", "b"]), "stated": "0.99", "limit": "0.9772"}
    assert not copula(some(["normal", "uniform"], [[1, 0.977], [0.977, 1]])).findings


def test_scores_that_no_matrix_gives_are_mended() -> None:
    """The stated matrix is singular, so the scores of uniform ones, each a little more correlated, have none."""
    stated = np.array([[1, 0.5, -0.5], [0.5, 1, 0.5], [-0.5, 0.5, 1]])
    of = some(["uniform"] * 3, stated)
    (finding,) = copula(of).findings
    assert (finding.code, finding.severity) == ("accuracy.correlation-adjusted", "warning")
    assert np.abs(np.corrcoef(sampled(of)) - stated).max() < 0.03
    assert not copula(some(["normal"] * 3, stated)).findings


def test_nothing_that_varies_is_correlated_with_what_does_not() -> None:
    a, b = some(["normal", "normal"], np.eye(2)).every
    still = replace(b, low=0.0, high=0.0, sigma=0.0, quantile=lambda u: 0 * u)
    x, y = sampled(Contributors((a, still), np.array([[1, 0.5], [0.5, 1]])), samples=50)
    assert x.std() > 0
    assert not y.any()


def test_factors_of_singular_matrices() -> None:
    columns = np.random.default_rng(1).normal(size=(6, 3))
    size = np.sqrt((columns**2).sum(axis=1))
    matrix = columns @ columns.T / np.outer(size, size)
    factor = cholesky(matrix)
    assert factor.shape == (6, 3)
    np.testing.assert_allclose(factor @ factor.T, matrix, atol=1e-9)
    worse = matrix.copy()
    worse[0, 1] = worse[1, 0] = -worse[0, 1]
    made = definite(worse)
    assert np.linalg.eigvalsh(worse)[0] < -0.01
    assert np.linalg.eigvalsh(made)[0] > -1e-9
    assert (np.diag(made) == 1).all()
    assert pearson(*some(["normal", "normal"], np.eye(2)).every, 0.3) == 0.3
