"""Stationary points of known functions, each found once and to round-off."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from linkwright.results.stationary import MAX_STEPS, bracketed, crossings, fineness, stationary

Array = NDArray[np.float64]
Pair = tuple[Callable[[Array], Array], Callable[[Array], Array]]


def found(*rows: Pair, start: float = 0.0, stop: float = 1.0, steps: int = 20) -> list[Array]:
    """The stationary points of some functions given with their rates."""

    def rates(t: Array) -> tuple[Array, Array]:
        return np.array([f(t) + 0 * t for f, _ in rows]), np.array([df(t) + 0 * t for _, df in rows])

    return stationary(rates, start, stop, steps)


def sine(w: float, size: float = 1.0, offset: float = 0.0) -> Pair:
    return lambda t: offset + size * np.sin(w * t), lambda t: size * w * np.cos(w * t)


@pytest.mark.parametrize("steps", [1, 2, 3, 20, 500])
def test_all_turning_points_of_a_sine(steps: int) -> None:
    times = found(sine(2 * np.pi * 5), steps=steps)[0]
    assert times == pytest.approx((np.arange(10) + 0.5) / 10, abs=1e-15)


def test_rows_do_not_disturb_each_other() -> None:
    rows = found(sine(2 * np.pi), (np.cosh, np.sinh), (lambda t: 3 + 0 * t, lambda t: 0 * t), sine(6 * np.pi))
    assert [len(row) for row in rows] == [2, 0, 0, 6]
    assert rows[0] == pytest.approx([0.25, 0.75], abs=1e-15)


def test_a_constant_has_none() -> None:
    assert found((lambda t: 0 * t, lambda t: 0 * t), (lambda t: 7 + 0 * t, lambda t: 0 * t))[0].size == 0


def test_round_off_noise_on_a_constant_is_not_a_turning_point() -> None:
    """Values of 700 that wobble in the last digits, with rates to match."""
    noise = np.random.default_rng(3)

    def rate(t: Array) -> Array:
        return 1e-11 * noise.standard_normal(t.size)

    assert found((lambda t: 700 + 1e-13 * np.sin(1e4 * t), rate))[0].size == 0


def test_noise_around_zero_rate_of_a_plateau_is_not_counted() -> None:
    """A rise, a dwell whose rate is round-off of either sign, a fall: no root that matters lies inside the dwell."""
    noise = np.random.default_rng(4)

    def value(t: Array) -> Array:
        return np.interp(t, [0, 0.3, 0.7, 1], [0, 1, 1, 0])

    def rate(t: Array) -> Array:
        slope = np.where(t < 0.3, 1 / 0.3, np.where(t > 0.7, -1 / 0.3, 0.0))
        return slope + np.where(slope == 0, 1e-15 * noise.standard_normal(t.size), 0.0)

    times = found((value, rate))[0]
    assert times.size == 1
    assert 0.29 < times[0] < 0.71
    assert value(times)[0] == pytest.approx(1.0, abs=1e-12)


def cycloid(t: Array) -> tuple[Array, Array]:
    """Rise of 1 in 0..0.25, dwell, return in 0.5..0.75, dwell: the sign of a cam's or a feeder's cycle."""
    up, down = np.clip(t / 0.25, 0, 1), np.clip((t - 0.5) / 0.25, 0, 1)

    def s(u: Array) -> Array:
        return u - np.sin(2 * np.pi * u) / (2 * np.pi)

    def v(u: Array) -> Array:
        return (1 - np.cos(2 * np.pi * u)) / 0.25

    return s(up) - s(down), v(up) - v(down)


def test_a_dwell_has_one_stationary_point_at_its_height() -> None:
    """Between rise and return lies one bracket; the start and the end of the cycle are ends, not turning points."""
    times = found((lambda t: cycloid(t)[0], lambda t: cycloid(t)[1]), steps=360)[0]
    assert times.size == 1
    assert 0.249 <= times[0] <= 0.501
    assert cycloid(times)[0][0] == pytest.approx(1.0, abs=1e-12)


def test_kinks_of_an_absolute_value_are_found() -> None:
    """|sin|: the maxima, and the zeros where the rate jumps from minus to plus."""
    w = 3 * np.pi
    times = found((lambda t: np.abs(np.sin(w * t)), lambda t: w * np.sign(np.sin(w * t)) * np.cos(w * t)))[0]
    assert times == pytest.approx([1 / 6, 1 / 3, 1 / 2, 2 / 3, 5 / 6], abs=1e-12)


def test_a_triple_root_of_the_rate_is_found_once() -> None:
    times = found((lambda t: (t - 0.37) ** 4, lambda t: 4 * (t - 0.37) ** 3))[0]
    assert times == pytest.approx([0.37], abs=1e-4)
    assert (times[0] - 0.37) ** 4 < 1e-16


def test_an_inflection_is_not_a_turning_point() -> None:
    assert found((lambda t: (t - 0.4) ** 3, lambda t: 3 * (t - 0.4) ** 2))[0].size == 0


def test_a_narrow_hump_between_two_samples_is_found() -> None:
    """Two turning points 1/500 of the span apart, looked at on 20 steps at first."""
    a, b = 0.5231, 0.5251
    rate = (lambda t: t**3 / 3 - (a + b) * t**2 / 2 + a * b * t, lambda t: (t - a) * (t - b))
    fast = sine(2 * np.pi * 40)
    times = found(rate, fast)[0]
    assert times == pytest.approx([a, b], abs=1e-12)


def test_small_wiggles_on_a_large_value_count() -> None:
    """A stroke of a nanometre about a metre is more than round-off."""
    times = found(sine(2 * np.pi, size=1e-9, offset=1.0))[0]
    assert times == pytest.approx([0.25, 0.75], abs=1e-12)


def test_poses_that_are_not_numbers_are_left_out() -> None:
    def gap(f: Callable[[Array], Array]) -> Callable[[Array], Array]:
        return lambda t: np.where((t > 0.4) & (t < 0.6), np.nan, f(t))

    value, rate = sine(2 * np.pi)
    times = found((gap(value), gap(rate)))[0]
    assert {0.25, 0.75} <= {round(x, 12) for x in times}


@settings(max_examples=60)
@given(
    st.lists(st.floats(0.02, 0.98), min_size=0, max_size=6).map(sorted),
    st.integers(1, 200),
    st.floats(1e-6, 1e6),
)
def test_polynomials_with_known_turning_points(roots: list[float], steps: int, size: float) -> None:
    if any(b - a < 0.01 for a, b in pairwise(roots)):
        return
    rate = size * np.polynomial.Polynomial.fromroots(roots) if roots else np.polynomial.Polynomial([size])
    value = rate.integ()
    times = found((value, rate), steps=steps)[0]
    assert times == pytest.approx(roots, abs=1e-9)


@pytest.mark.parametrize("span", [(0.0, 1.0), (-3.0, 2.0), (1e3, 1e3 + 1.0)])
def test_crossings_of_a_line_through_zero(span: tuple[float, float]) -> None:
    at = span[0] + 0.3 * (span[1] - span[0])
    assert crossings(lambda t: np.sin(2 * (t - at)) + 0 * t, *span, 10)[0] == pytest.approx(at, abs=1e-12)


def test_crossings_at_jumps_are_found_too() -> None:
    times = crossings(lambda t: np.where(t < 0.61803, -1.0, 2.0), 0.0, 1.0, 10)
    assert times == pytest.approx([0.61803], abs=1e-12)


def test_an_end_whose_sign_is_round_off_is_the_root() -> None:
    """A rate that is zero but for round-off at the start, and comes out with another sign when it is asked again."""

    def rates(t: Array) -> tuple[Array, Array]:
        slopes = np.where(t == 0, -1e-6 if t.size > 10 else 1e-6, t)
        return (t**2 / 2)[None], slopes[None]

    (found,) = stationary(rates, 0.0, 1.0, 64)
    assert found == pytest.approx([0.0], abs=1e-12)


# Roots in brackets.


def poles(t: Array, row: NDArray[np.intp]) -> Array:
    """A cubic, a jump, a steep and a flat root, an infinite one, at 0.3 each."""
    x = t - 0.3
    with np.errstate(divide="ignore"):
        kinds = [x + x**3, np.where(x < 0, -2.0, 1e9), np.tanh(1e6 * x), x**5, 1 / x]
    return np.choose(row, kinds)


@pytest.mark.parametrize("first", [0.5, 0.0, 1.0, 0.3, np.nan])
def test_roots_of_all_kinds(first: float) -> None:
    rows = np.arange(5)
    found = bracketed(poles, rows, np.zeros(5), np.ones(5), np.full(5, first))
    assert found == pytest.approx(np.full(5, 0.3), abs=1e-15)
    assert bracketed(poles, rows, np.ones(5), np.zeros(5), np.full(5, first)) == pytest.approx(found, abs=1e-15)


def test_each_root_is_found_by_itself() -> None:
    rows = np.random.default_rng(0).integers(0, 5, 200)
    low, high = -np.random.default_rng(1).uniform(0, 1, 200), np.random.default_rng(2).uniform(0.4, 1, 200)
    found = bracketed(poles, rows, low, high)
    assert found == pytest.approx(np.full(200, 0.3), abs=1e-15)
    for some in (slice(0, 1), slice(3, 50), slice(None, None, -3)):
        assert np.array_equal(bracketed(poles, rows[some], low[some], high[some]), found[some])


def test_a_bracket_whose_ends_have_one_sign_gives_the_end_nearer_to_a_root() -> None:
    found = bracketed(lambda t, row: t + 0 * row, np.arange(2), np.array([1e-17, -2.0]), np.array([1.0, -1e-18]))
    assert found.tolist() == [1e-17, -1e-18]


def test_the_grid_on_which_counts_stand_still() -> None:
    """A sine of 200 waves has its counts from 1024 steps on, one of a single wave from the first grid on."""
    rng = np.random.default_rng(0)

    def rates(t: Array) -> tuple[Array, Array]:
        w = 2 * np.pi * np.array([[1.0], [200.0]])
        noise = rng.standard_normal((1, t.size))
        return np.concatenate([np.sin(w * t), noise]), np.concatenate([w * np.cos(w * t), noise])

    coarse, fine, never = fineness(rates, 0.0, 1.0, 50)
    assert (coarse, never) == (4 * 64, MAX_STEPS)
    assert 4 * 400 <= fine <= 4 * 1024
