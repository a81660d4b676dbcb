"""Zeros of polynomials and places where legs meet, in closed form."""

from __future__ import annotations

import numpy as np

from linkwright.studies.workspace.meetings import meetings, zeros_between


def test_where_two_of_three_legs_meet() -> None:
    """Circles about (0, 0) and (3, 0) of radii 2 meet at x = 1.5, the line y = 1 crosses the first at sqrt(3)."""
    misses = np.array([[-4.0], [5.0], [-1.0]])
    slopes = np.array([[[0.0], [0.0]], [[-6.0], [0.0]], [[0.0], [1.0]]])
    legs, places = meetings(misses, slopes, 2)
    for x, y in np.array(places)[:, :, 0].tolist():
        values = [x * x + y * y - 4, (x - 3) ** 2 + y * y - 4, y - 1]
        assert max(abs(values[k]) for k in legs[:, 0]) < 1e-12
    lines = np.array([[[0.0], [1.0]], [[1.0], [0.0]], [[0.0], [1.0]]])
    legs, places = meetings(np.array([[-1.0], [-2.0], [-5.0]]), lines, 0)
    assert legs[:, 0].tolist() == [0, 1] and places[0][:, 0].tolist() == [2.0, 1.0] and np.isnan(places[1]).all()


def test_zeros_between_extrema() -> None:
    """cos(2 phi) - 1/2: four zeros, whose rooms are the lesser of both extrema's sizes, over that of the coefficients;
    cos(phi) + 2 has none."""
    coefficients = np.array([[-0.5, 2.0], [0, 1], [0, 0], [1, 0], [0, 0], [0, 0], [0, 0]])
    phi, room, which = zeros_between(coefficients)
    assert (which == -1).all()
    assert np.isfinite(phi[:, 0]).sum() == 4 and not np.isfinite(phi[:, 1]).any()
    np.testing.assert_allclose(np.cos(2 * phi[:4, 0]), 0.5, atol=1e-12)
    np.testing.assert_allclose(room[:4, 0], 0.5)
    np.testing.assert_allclose(room[:2, 1], -0.5)


def test_an_extremum_that_touches_zero_is_given_to_both_sides() -> None:
    """cos(2 phi) - 1 - 1e-12 has no zero, but nearly a double one at 0 and at pi."""
    phi, room, which = zeros_between(np.array([[-1.0 - 1e-12], [0], [0], [1], [0], [0], [0]]))
    given = np.isfinite(phi[:, 0])
    assert given.sum() == 4 and (room[given, 0] < 0).all() and sorted(which[given, 0].tolist()) == [0, 0, 1, 1]
    np.testing.assert_allclose(np.sin(phi[given, 0]), 0.0, atol=1e-9)
