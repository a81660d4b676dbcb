"""Motion laws against published figures.

Peak factors: R. L. Norton, Design of Machinery, ch. 8, table 8-3, as closed forms (1e-12). Cases 1 and 7: textbook
rises in m/s and mm/s, to the digits printed. Case 6: Norton, example 8-8, the 3-4-5-6 polynomial of a single-dwell cam.
Table 1: Zhang Jun, Fu Zhengfei, Gao Chenghui, "A quickly entity modeling method for planar cam based on
Pro/mechanism": the arm's swing of the heat-seal cam of an MH-101B strapping machine as expressions in t.
"""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest

from laws.texts import value
from linkwright.laws import LAWS, Blend, Dwell, Rise, motion

FACTORS = {
    "cycloidal": (2.0, 6.283185307179586, 39.47841760435743),
    "poly_345": (1.875, 5.773502691896258, 60.0),
    "poly_4567": (2.1875, 7.513188404399293, 52.5),
    "modified_trapezoid": (2.0, 4.888123762813258, 61.425974812367315),
    "modified_sine": (1.7596033859537705, 5.52795707054409, 69.46635728872427),
}


@pytest.mark.parametrize("name", FACTORS)
def test_factors_of_double_dwell_laws(name: str) -> None:
    law = LAWS[name]
    assert [law.factor(k) for k in (1, 2, 3)] == pytest.approx(FACTORS[name], rel=1e-12)


def test_simple_harmonic_motion_of_50_mm() -> None:
    """Case 1: rise over 120, return over 60 deg at 100 rpm; published 0.39 and 0.78 m/s, 6.17 and 24.67 m/s^2."""
    law = LAWS["simple_harmonic"]
    cam = motion([Rise(120, 0.05, law), Dwell(180), Rise(60, -0.05, law)], period=360)
    low, high = (extreme.value for extreme in cam.restated(600).extremes(1))  # 600 deg/s: over seconds
    assert (high, -low) == pytest.approx((0.3927, 0.7854), rel=1e-4)
    assert cam.restated(600).extremes(2)[0].value == pytest.approx(-24.674, rel=1e-5)
    rise = motion([Rise(120, 0.05, law)], beyond="hold").restated(600)
    assert rise.extremes(2)[1].value == pytest.approx(6.1685, rel=1e-5)


def test_the_3456_rise_and_fall() -> None:
    """Case 6: 1 in within 180 deg at 15 rad/s: by conditions alone, -547.13 in/s^2 at the top."""
    cam = motion([Blend(math.pi, 0.0, (0.0, 0.0), (0.0, 0.0), ((math.pi / 2, 1.0),)), Dwell(math.pi)])
    low, _ = cam.restated(15).extremes(2)
    assert low.value == pytest.approx(-547.13, rel=1e-5)
    assert low.at == pytest.approx(math.pi / 2 / 15)
    u = np.linspace(0, 1, 20)
    assert cam.at(u * math.pi) == pytest.approx(64 * (u**3 - 3 * u**4 + 3 * u**5 - u**6), abs=1e-12)


def test_the_345_rise_of_25_mm() -> None:
    """Case 7: within 90 deg at one turn a second: 187.5 mm/s, 2309.40 mm/s^2."""
    rise = motion([Rise(90, 25, LAWS["poly_345"])], beyond="hold").restated(360)
    assert rise.extremes(1)[1].value == pytest.approx(187.5, rel=1e-12)
    assert rise.extremes(2)[1].value == pytest.approx(2309.40, rel=1e-6)


@pytest.mark.parametrize("period", [24, 1, 7.3])
def test_table_1_of_the_heat_seal_cam(period: float) -> None:
    """In t for any period; printed for 24 s: m (t/6 - sin(2 pi t/6)/2 pi), m, m (1 - ...) over 5 s from 18 s, 0."""
    m, law = 12.0, LAWS["cycloidal"]
    swing = motion([Rise(90, m, law), Dwell(180), Rise(75, -m, law), Dwell(15)], period=360)
    pieces = swing.restated(360 / period).pieces("x")
    scale = period / 24
    assert [start / scale for start, _, _ in pieces] == pytest.approx([0, 6, 18, 23])
    assert [stop / scale for _, stop, _ in pieces] == pytest.approx([6, 18, 23, 24])
    printed = [
        lambda t: m * (t / 6 - mp.sin(2 * mp.pi * t / 6) / (2 * mp.pi)),
        lambda t: mp.mpf(m),
        lambda t: m * (1 - (t - 18) / 5 + mp.sin(2 * mp.pi * (t - 18) / 5) / (2 * mp.pi)),
        lambda t: mp.mpf(0),
    ]
    for (start, stop, text), formula in zip(pieces, printed, strict=True):
        for share in (0.0, 0.13, 0.5, 0.81):
            t = mp.mpf(start + share * (stop - start))
            assert float(value(text, t)) == pytest.approx(float(formula(t / scale)), abs=1e-13)
