"""Angles known but for whole turns: also where a rate is infinite, as it is in a dead centre, or nothing is known."""

from __future__ import annotations

import numpy as np

from linkwright.notation.angles import steps, whole_turns, wrapped


def test_wrapped() -> None:
    found = wrapped(np.array([0.0, np.pi + 0.1, -7.0, np.inf, -np.inf, np.nan]))
    np.testing.assert_allclose(found[:3], [0.0, 0.1 - np.pi, 2 * np.pi - 7.0])
    assert np.isnan(found[3:]).all()


def test_whole_turns() -> None:
    np.testing.assert_array_equal(whole_turns(np.array([0.1, np.nan]), np.array([13.0, 1.0])), [2.0, np.nan])


def test_steps_follow_the_rates() -> None:
    places = np.linspace(0.0, 1.0, 5)
    turned, largest = steps(places, wrapped(14 * places), np.full(5, 14.0))
    np.testing.assert_allclose(turned, 3.5)
    assert largest == 3.5


def test_steps_beside_an_infinite_rate_are_unknown() -> None:
    turned, _ = steps(np.arange(4.0), np.array([0.0, 0.1, 0.2, 0.3]), np.array([0.1, 0.1, np.inf, -np.inf]))
    np.testing.assert_allclose(turned[0], 0.1)
    assert np.isnan(turned[1:]).all()
