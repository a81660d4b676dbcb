"""step5 against ADAMS' STEP5 in closed form, its end conditions, and its smoothness."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.differences import derivatives
from linkwright.laws import step5
from linkwright.notation import Jet

number = st.floats(-5.0, 5.0)
width = st.floats(0.1, 4.0)


def adams_step5(x: float, x0: float, h0: float, x1: float, h1: float) -> float:
    """STEP5 as Adams/Solver's function reference states it: h0 + (h1 - h0) d^3 (10 - 15 d + 6 d^2)."""
    if x <= x0:
        return h0
    if x >= x1:
        return h1
    d = (x - x0) / (x1 - x0)
    return h0 + (h1 - h0) * d**3 * (10 - 15 * d + 6 * d**2)


def time_jet(t: Any, order: int = 4) -> Jet:
    t = np.asarray(t, dtype=float)
    return Jet([t, np.ones_like(t), *[np.zeros_like(t)] * (order - 1)])


@given(number, number, width, number, number)
def test_equals_adams_on_numbers(x: float, x0: float, w: float, h0: float, h1: float) -> None:
    scale = max(1.0, abs(h0), abs(h1))
    assert step5(x, x0, h0, x0 + w, h1) == pytest.approx(adams_step5(x, x0, h0, x0 + w, h1), abs=1e-14 * scale)


@given(number, width, number, number)
def test_equals_adams_on_jets(x0: float, w: float, h0: float, h1: float) -> None:
    t = np.linspace(x0 - w, x0 + 2 * w, 31)
    wanted = [adams_step5(x, x0, h0, x0 + w, h1) for x in t]
    scale = max(1.0, abs(h0), abs(h1))
    found = np.broadcast_to(step5(time_jet(t), x0, h0, x0 + w, h1).d[0], t.shape)
    assert np.allclose(found, wanted, rtol=0, atol=1e-14 * scale)


@settings(max_examples=30)
@given(number, width, number, number)
def test_end_conditions(x0: float, w: float, h0: float, h1: float) -> None:
    """Rest and no acceleration at both ends; value, velocity and acceleration run on without a jump."""
    for end, h in ((x0, h0), (x0 + w, h1)):
        for side in (-1e-9, 0.0, 1e-9):
            value, velocity, acceleration = (
                float(d) for d in step5(time_jet(end + side * w), x0, h0, x0 + w, h1).d[:3]
            )
            size = abs(h1 - h0)
            assert value == pytest.approx(h, abs=1e-14 * max(1.0, abs(h0), abs(h1)))
            assert abs(velocity) <= 1e-12 * size / w
            assert abs(acceleration) <= 1e-7 * size / w**2


@given(number, width, number, number, st.floats(0.0, 10.0))
def test_constant_outside(x0: float, w: float, h0: float, h1: float, away: float) -> None:
    before, after = (step5(time_jet(x), x0, h0, x0 + w, h1) for x in (x0 - away, x0 + w * (1 + 1e-15) + away))
    assert [float(d) for d in before.d] == [h0, 0.0, 0.0, 0.0, 0.0]
    assert float(after.d[0]) == pytest.approx(h1, rel=1e-15, abs=1e-15 * max(abs(h0), abs(h1), 1e-30))
    assert [float(d) for d in after.d[1:]] == [0.0, 0.0, 0.0, 0.0]


def test_largest_rates_in_closed_form() -> None:
    """Peaks of the 3-4-5 polynomial: velocity 15/8 at the middle, acceleration 10/sqrt(3) (Norton, Cam Design, 3.6)."""
    t = np.linspace(0.0, 2.0, 2001)
    jet = step5(time_jet(t), 0.0, 1.0, 2.0, 4.0)
    assert jet.d[1].max() == pytest.approx(3.0 * 15 / 8 / 2, rel=1e-12)
    assert jet.d[2].max() == pytest.approx(3.0 * 10 / np.sqrt(3) / 4, rel=1e-6)
    assert jet.d[3][0] == 0.0
    assert step5(time_jet(1e-12), 0.0, 1.0, 2.0, 4.0).d[3] == pytest.approx(3.0 * 60 / 8, rel=1e-9)


def test_rates_against_differences() -> None:
    t = np.array([-0.5, 0.21, 0.9, 1.37, 1.8, 2.6])
    for k in range(1, 5):

        def rate(at: Any, k: int = k) -> Any:
            return step5(time_jet(at), 0.0, -1.0, 2.0, 4.0).d[k - 1]

        assert np.allclose(step5(time_jet(t), 0.0, -1.0, 2.0, 4.0).d[k], derivatives(rate, t, 0.02), atol=1e-8)


def test_of_a_moving_argument_and_moving_ends() -> None:
    """Everything in it may be a jet: the step of a function of time, between levels that move."""
    t = np.array([0.2, 0.5, 0.8])

    def law(t: Any) -> Jet:
        time = time_jet(t)
        return step5(time * time, 0.1 * time, time.sin(), 1.0 + 0.2 * time, time.cos())

    for k in range(1, 5):
        assert np.allclose(law(t).d[k], derivatives(lambda at, k=k: law(at).d[k - 1], t, 0.01), atol=1e-7)


def test_a_step_downwards_and_one_backwards() -> None:
    assert step5(1.0, 0.0, 5.0, 2.0, 1.0) == 3.0
    assert step5(1.0, 2.0, 1.0, 0.0, 5.0) == 3.0
