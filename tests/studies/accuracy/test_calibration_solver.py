"""Calibration on a four-bar in closed form and on linear models."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from linkwright.studies.accuracy.calibration_solver import Measurements, TooFew, Unusable, fit, scaling

Array = NDArray[np.float64]

NOMINAL = np.array([0.04, 0.12, 0.08, 0.1])  # crank, coupler, rocker, ground (m)
TURN = np.linspace(0, 2 * np.pi, 24, endpoint=False)
TRUE = np.array([2e-5, -5e-5, 3e-5, 4e-5])
BASIS = np.diag([2e-5, 3e-5, 3e-5, 2e-5])


def positions(lengths: Array) -> Array:
    """Coupler pin x, y and rocker angle of the open four-bar over a turn, (3, positions), by the cosine law; takes
    complex lengths too."""
    a, b, c, d = lengths
    x, y = a * np.cos(TURN), a * np.sin(TURN)
    dx, dy = d - x, -y
    diagonal = np.sqrt(dx**2 + dy**2)
    along = (b**2 - c**2 + diagonal**2) / (2 * diagonal)
    high = np.sqrt(b**2 - along**2)
    px, py = x + (along * dx - high * dy) / diagonal, y + (along * dy + high * dx) / diagonal
    east, north = px - d, py
    angle = np.arctan2(north.real, east.real) + 1j * (east.real * north.imag - north.real * east.imag) / (c.real**2)
    return np.stack([px, py, angle if np.iscomplexobj(lengths) else angle.real])


def model(rows: list[int]) -> Callable[[Array], tuple[Array, Array]]:
    """The rows with derivatives by complex steps, exact to round-off."""

    def at(d: Array) -> tuple[Array, Array]:
        steps = [positions(NOMINAL + d + 1e-30j * unit)[rows].imag / 1e-30 for unit in np.eye(4)]
        return positions(NOMINAL + d + 0j)[rows].real, np.stack(steps, axis=1)

    return at


def measured(rows: list[int], noise: Array | float = 0.0, sigma: list[float] | None = None) -> Measurements:
    values = positions(NOMINAL + TRUE + 0j)[rows].real + noise
    return Measurements(values, np.array(sigma or [np.nan] * len(rows)), np.array([row == 2 for row in rows]))


def test_known_errors_are_found_again() -> None:
    for sigma in (None, [1e-6, 1e-6, 1e-5]):
        found = fit(model([0, 1, 2]), measured([0, 1, 2], sigma=sigma), np.zeros(4), BASIS)
        np.testing.assert_allclose(found.deviations, TRUE, atol=1e-9 * 0.1)
        assert found.identified.all()
        assert found.null.shape == (4, 0)
        assert found.freedom == 3 * 24 - 4


def test_intervals_hold_as_often_as_they_say() -> None:
    """200 repeats of 4 estimates at 90 %: the count of hits has a binomial distribution (correlated within a repeat, so
    each estimate is held by itself), whose 1e-4 quantiles are 163 and 194. Sigma stated, and estimated."""
    rng, clean = np.random.default_rng(3), measured([0, 1])
    for sigma in ([2e-5, 3e-5], [np.nan, np.nan]):
        hits, probabilities = np.zeros(4), []
        for _ in range(200 if np.isfinite(sigma).all() else 40):
            noise = rng.normal(size=clean.values.shape) * [[2e-5], [3e-5]]
            data = Measurements(clean.values + noise, np.array(sigma), clean.turns)
            found = fit(model([0, 1]), data, np.zeros(4), BASIS, confidence=0.9)
            hits += np.abs(found.deviations - TRUE) <= found.factor * np.sqrt(np.diag(found.covariance))
            probabilities.append(found.probability)
        if np.isfinite(sigma).all():
            assert ((hits >= 163) & (hits <= 194)).all(), hits
            assert 0.4 < np.mean(np.array(probabilities, dtype=float)) < 0.6  # uniform: a standard error of 0.02
        else:
            assert ((hits >= 28) & (hits <= 40)).all(), hits
            np.testing.assert_allclose(found.sigma, [2e-5, 3e-5], rtol=0.6)


def test_angles_alone_do_not_tell_the_scale() -> None:
    found = fit(model([2]), measured([2], sigma=[1e-5]), np.zeros(4), BASIS)
    assert found.singular[-1] < 1e-12 * found.singular[0]
    assert not found.identified.any()
    assert found.null.shape == (4, 1)
    assert scaling(found.null[:, 0], NOMINAL + found.deviations)
    # What is told, the ratios, is right; and no other deviations that fit are smaller.
    lengths, true = NOMINAL + found.deviations, NOMINAL + TRUE
    np.testing.assert_allclose(lengths / lengths[0], true / true[0], rtol=1e-9)
    z, direction = np.linalg.solve(BASIS, found.deviations), np.linalg.solve(BASIS, lengths)
    assert abs(z @ direction) < 1e-9 * np.linalg.norm(z) * np.linalg.norm(direction)


def test_prior_tolerances_tell_what_measurements_leave_open() -> None:
    found = fit(model([2]), measured([2], sigma=[1e-5]), np.zeros(4), BASIS, prior=True)
    assert found.identified.all()
    assert found.null.shape == (4, 1)
    errors = np.sqrt(np.diag(found.covariance))
    assert (errors < np.diag(BASIS)).all()
    # Bayes' rule for normal distributions, at the estimate.
    j = model([2])(found.deviations)[1][0].T / 1e-5
    np.testing.assert_allclose(
        found.covariance, np.linalg.inv(j.T @ j + np.linalg.inv(BASIS @ BASIS)), rtol=1e-6, atol=1e-18
    )


def linear(slopes: Array) -> Callable[[Array], tuple[Array, Array]]:
    return lambda d: ((slopes @ d)[None], slopes.T[None])


def test_a_straight_line_by_the_book() -> None:
    """Intercept and slope with their standard errors, the studentised residuals by leaving each one out."""
    rng = np.random.default_rng(1)
    x = np.arange(12.0)
    y = 2 + 0.5 * x + rng.normal(size=12) * 0.1
    y[7] += 2.0
    data = Measurements(y[None], np.array([np.nan]), np.array([False]))
    found = fit(linear(np.stack([np.ones(12), x], axis=1)), data, np.zeros(2), np.eye(2))
    mean, sxx = x.mean(), ((x - x.mean()) ** 2).sum()
    slope = ((x - mean) * y).sum() / sxx
    intercept = y.mean() - slope * mean
    s = np.sqrt(((y - intercept - slope * x) ** 2).sum() / 10)
    np.testing.assert_allclose(found.deviations, [intercept, slope], rtol=1e-12)
    errors = s / np.sqrt(sxx) * np.array([np.sqrt((x**2).mean()), 1])
    np.testing.assert_allclose(np.sqrt(np.diag(found.covariance)), errors, rtol=1e-9)
    assert found.factor == pytest.approx(2.228138852, rel=1e-9)  # t of 10 degrees of freedom, 97.5 %
    assert found.freedom == 10
    others = np.delete(np.arange(12), 3)
    line = np.polyfit(x[others], y[others], 1, cov="unscaled")
    spread = np.sqrt(((y[others] - np.polyval(line[0], x[others])) ** 2).sum() / 9)
    variance = 1 + np.array([3.0, 1]) @ line[1] @ np.array([3.0, 1])
    expected = (y[3] - np.polyval(line[0], 3.0)) / (spread * np.sqrt(variance))
    assert found.studentised[0, 3] == pytest.approx(expected, rel=1e-9)
    assert np.flatnonzero(found.outliers[0]).tolist() == [7]


def test_chi_square_tells_wrong_sigmas() -> None:
    rng, x = np.random.default_rng(2), np.arange(30.0)
    y = 0.5 * x + rng.normal(size=30)
    for sigma, likely in ((1.0, True), (0.3, False)):
        data = Measurements(y[None], np.array([sigma]), np.array([False]))
        found = fit(linear(x[:, None]), data, np.zeros(1), np.eye(1))
        assert found.probability is not None
        assert (found.probability > 0.01) == likely
        assert found.covariance[0, 0] == pytest.approx(sigma**2 / (x @ x), rel=1e-9)


def test_angles_count_but_for_whole_turns_and_gaps_are_left_out() -> None:
    values = 0.3 * np.arange(5.0) + 2 * np.pi * np.array([0, 1, -3, 0, 2])
    values[3] = np.nan
    data = Measurements(values[None], np.array([1.0]), np.array([True]))
    found = fit(linear(np.arange(5.0)[:, None]), data, np.array([0.2]), np.eye(1))
    assert found.deviations[0] == pytest.approx(0.3, rel=1e-12)
    assert found.freedom == 3
    assert np.isnan(found.fitted[0, 3])


def test_several_directions_have_a_plain_basis() -> None:
    """p0 + p1 and p2 - 2 p3 are measured: each sum leaves one direction of its own, and p4 is told."""
    rows = np.array([[1.0, 1, 0, 0, 0], [0, 0, 1, -2, 0], [0, 0, 0, 0, 1]])
    data = Measurements(np.array([[1.0, 2, 3]]), np.array([0.1]), np.array([False]))
    found = fit(linear(rows), data, np.zeros(5), np.eye(5))
    assert found.identified.tolist() == [False] * 4 + [True]
    involved = {tuple(np.flatnonzero(column)) for column in found.null.T}
    assert involved == {(0, 1), (2, 3)}
    np.testing.assert_allclose(found.deviations, [0.5, 0.5, 0.4, -0.8, 3], atol=1e-12)


def test_what_cannot_be_estimated_is_told() -> None:
    data = Measurements(np.array([[1.0, 2]]), np.array([np.nan]), np.array([False]))
    with pytest.raises(TooFew):
        fit(linear(np.eye(2)), data, np.zeros(2), np.eye(2))
    with pytest.raises(Unusable):
        fit(linear(np.array([[np.nan, 1], [1, 2]])), data, np.zeros(2), np.eye(2))
