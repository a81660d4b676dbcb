"""Dwells: closed forms, and random signals against a sliding window over dense samples."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from linkwright.reductions.dwell import TurningCourse
from linkwright.results.stationary import stationary
from studies.models import measured, slider_crank


def near(wanted: float, tolerance: float = 1e-11) -> Any:
    return pytest.approx(wanted, rel=tolerance, abs=tolerance)


def longest(value: Any, turning: list[float], width: float) -> tuple[float, float]:
    return TurningCourse(value, np.array(turning)).longest(width)


def test_around_a_turning_point() -> None:
    """sin stays within w of its top for 2 acos(1 - w)."""
    turning = [0, math.pi / 2, 1.5 * math.pi, 2 * math.pi]
    for width in (1e-8, 0.1, 0.5):
        start, stop = longest(np.sin, turning, width)
        # At 1e-8 the square root leaves half the digits.
        assert stop - start == near(2 * math.acos(1 - width), 1e-7 if width < 0.01 else 1e-11)
        assert (start + stop) / 2 == near(math.pi / 2, 1e-8)


@pytest.mark.parametrize("sign", [1, -1])
def test_passing_slowly(sign: int) -> None:
    """A cubic slows down and goes on: the band lies evenly about the inflection."""
    start, stop = longest(lambda t: sign * (t - 1) ** 3, [0, 2], 0.002)
    assert (start, stop) == (near(0.9, 1e-8), near(1.1, 1e-8))
    assert stop - start == near(0.2, 1e-11)


def test_passing_with_wiggles() -> None:
    """t^3 - 3 e^2 t turns at -e and e by 4 e^3; a wider band leaves beyond both, evenly."""
    e = 0.1
    width = 0.05
    start, stop = longest(lambda t: t**3 - 3 * e**2 * t, [-1, -e, e, 1], width)
    edge = max(np.roots([1, 0, -3 * e**2, -width / 2]).real)
    assert (start, stop) == (near(-edge, 1e-7), near(edge, 1e-7))
    assert stop - start == near(2 * edge)


def test_ends_of_the_run_count() -> None:
    assert longest(lambda t: t, [0, 10], 3.0) == (near(0), near(3))
    assert longest(lambda t: t * t, [0, 10], 4.0) == (near(0), near(2))
    assert longest(lambda t: -((10 - t) ** 2), [0, 10], 4.0) == (near(8), near(10))
    assert longest(lambda t: t, [0, 10], 30.0) == (0, 10)
    assert longest(lambda t: 0 * t, [0, 10], 1.0) == (0, 10)


def test_equal_dwells_give_the_first() -> None:
    turning = [0, *(math.pi / 2 + k * math.pi for k in range(8)), 8 * math.pi]
    start, stop = longest(np.cos, [k * math.pi for k in range(9)], 0.3)
    assert stop < 2 * math.pi
    assert longest(np.sin, turning, 0.3)[0] < math.pi
    assert start > 0


waves = st.lists(st.tuples(st.floats(-1, 1), st.integers(1, 6), st.floats(0, 6)), min_size=1, max_size=5)


@settings(max_examples=60, deadline=None)
@given(waves, st.floats(0.02, 0.99) | st.floats(1.01, 1.5), st.floats(-0.5, 0.5))
def test_random_signals_against_a_sliding_window(terms: Any, share: float, slope: float) -> None:
    """Over 4001 samples of one period: the longest window of samples is shorter by two steps at most."""

    def wave(t: Any, rate: bool = False) -> Any:
        rows = [a * k * np.cos(k * t + p) if rate else a * np.sin(k * t + p) for a, k, p in terms]
        return sum(rows) + (slope if rate else slope * t)

    t = np.linspace(0, 2 * np.pi, 4001)
    y = wave(t)
    if np.ptp(y) < 1e-3:
        return
    width = share * float(np.ptp(y))
    turning = stationary(lambda at: (wave(at)[None], wave(at, True)[None]), 0.0, 2 * np.pi, 256)[0]
    start, stop = longest(wave, [0.0, *turning, 2 * np.pi], width)
    inside = wave(np.linspace(start, stop, 3001))
    assert np.ptp(inside) <= width * (1 + 1e-9)
    first, most = 0, 0
    for last in range(t.size):
        while np.ptp(y[first : last + 1]) > width:
            first += 1
        most = max(most, last - first)
    assert -1e-9 <= stop - start - most * t[1] < 2.001 * t[1]


# In model files.


def test_a_slider_at_its_dead_centre() -> None:
    """In line with the crank, 50 and 160 mm: within 1 mm of the inner dead centre."""
    found = measured(slider_crank(e=0), d={"dwell": "guide.s", "within": 1})["d"]
    inner, r, l = 110.0 + 1.0, 50.0, 160.0  # noqa: E741
    angle = math.acos((inner**2 + r**2 - l**2) / (2 * inner * r))
    assert (found.shown(), found.unit) == (near((2 * math.pi - 2 * angle) / (2 * math.pi)), "s")
    assert found.found[0].time == near(angle / (2 * math.pi))


def test_constant_speed_and_windows() -> None:
    windows = {"late": ["0.5 s", "0.52 s"], "quarter": {"motor.angle": ["0 deg", "90 deg"]}}
    data = slider_crank(windows=windows)
    found = measured(
        data,
        turn={"dwell": "motor.angle", "within": "36 deg"},
        late={"dwell": "motor.angle", "within": "36 deg", "window": "late"},
        quarter={"dwell": "2*B.y", "within": "50 mm", "window": "quarter", "unit": "ms"},
        still={"dwell": "C.y", "within": "1 um"},
        constant={"dwell": 0.5, "within": "1 um"},
    )
    assert found["turn"].shown() == near(0.1)
    assert found["late"].shown() == near(0.02)
    assert found["quarter"].shown() == near(1000 * math.acos(0.5) / (2 * math.pi))
    assert found["quarter"].found[0].time == near(1 / 12)
    assert found["still"].shown() == near(1.0)
    assert found["constant"].shown() == near(1.0)
