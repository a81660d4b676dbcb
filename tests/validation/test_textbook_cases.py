"""Worked cases of textbooks: positions, velocities and accelerations.

Published figures are held to their printed digits; figures marked own are an independent double-precision
solution of the same loop equations, held to 1e-12, a few times their round-off.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import four_bar, slider_crank
from linkwright.graph.rows import Determinant, Named

NOW = np.zeros(1)
OWN = {"rel": 1e-12, "abs": 1e-12}


def at_start(data: dict[str, Any], *names: Named) -> list[float]:
    return [float(v) for v in compiled_from(data).evaluate(names, NOW)[:, 0]]


@pytest.mark.parametrize(
    ("rule", "theta3", "theta4"),
    [
        ("open", 20.297882788196475, 57.324880070360805),
        ("crossed", -60.97796679586442, -98.00496407802875),
        ("left of B-D", 20.297882788196475, 57.324880070360805),
        ("right of B-D", -60.97796679586442, -98.00496407802875),
    ],
)
def test_norton_4_1(rule: str, theta3: float, theta4: float) -> None:
    """Norton, Design of Machinery, Ex. 4-1: a, b, c, d = 40, 120, 80, 100 mm, crank at 40 deg; 20.298 deg open."""
    data = four_bar(40, 120, 80, 100, assembly={"C": rule})
    data["units"] |= {"length": "mm", "angle": "deg"}
    data["drives"]["motor"] |= {"start": 40}
    coupler, rocker = np.degrees(at_start(data, "coupler.angle", "rocker.angle"))
    assert (coupler, rocker) == pytest.approx((theta3, theta4), abs=1e-11)
    if theta3 > 0:
        assert coupler == pytest.approx(20.298, abs=5e-4)


NIKRAVESH_5_2 = {
    "left of B-D": {
        "angle": (0.2721247429362482, 0.7586309236111005),
        "omega": (0.028622177505290964, 0.7160755715521798),
        "alpha": (0.777949593219184, 0.36564374076175504),
        "P": (0.21066429596757313, 0.21358469552909545),
        "v": (-0.11015538266519781, 0.11007179447056155),
        "a": (-0.18550964981934537, -0.1351920259790988),
    },
    "right of B-D": {
        "angle": (-1.2730728164870202, -1.7595789971618725),
        "omega": (-0.6008528869969296, -1.2883062810438182),
        "alpha": (3.728389099070368, 4.140694951527797),
        "P": (0.2171201344724728, -0.06554008734774347),
        "v": (-0.18793268296400908, 0.018095472644139646),
        "a": (0.38089230102647376, 0.35110940404738217),
    },
}


@pytest.mark.parametrize("rule", NIKRAVESH_5_2)
def test_nikravesh_5_2(rule: str) -> None:
    """Nikravesh, Planar Multibody Dynamics, Ex. 5.2: four-bar with coupler point, crank at 1.5 rad/s and -1.2 rad/s^2.

    Parameters as published (0.1, 0.3, 0.22, ground 0.2 m; P at 0.2 m, pi/6 from the coupler); figures own.
    """
    data = four_bar(0.1, 0.3, 0.22, 0.2, assembly={"C": rule})
    data["links"]["coupler"]["points"]["P"] = "0.2 at pi/6"
    law = "pi/4*(1 rad) + (1.5 rad/s)*t - (0.6 rad/s^2)*t^2"
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "position": law}}
    expected = NIKRAVESH_5_2[rule]
    for attribute in ("angle", "omega", "alpha"):
        found = at_start(data, f"coupler.{attribute}", f"rocker.{attribute}")
        assert found == pytest.approx(expected[attribute], **OWN)
    for key, letter in (("P", ""), ("v", "v"), ("a", "a")):
        assert at_start(data, f"P.{letter}x", f"P.{letter}y") == pytest.approx(expected[key], **OWN)


def test_nikravesh_5_1() -> None:
    """Nikravesh, Planar Multibody Dynamics, Ex. 5.1: slider-crank 0.12, 0.26 m at 65 deg and 1.6 rad/s; figures own."""
    data = slider_crank(0.12, 0.26)
    data["drives"]["motor"] |= {"start": "65 deg", "speed": 1.6}
    found = at_start(data, "rod.angle", "C.x", "rod.omega", "C.vx", "rod.alpha", "C.ax")
    expected = (
        -0.43156838977042644,
        0.28687500359045,
        -0.3435909010671502,
        -0.2113789882140885,
        1.12456627186401,
        -0.03540384525616029,
    )
    assert found == pytest.approx(expected, **OWN)


def test_khurmi_pqrs() -> None:
    """Khurmi, Theory of Machines: PQRS with crank PQ at 60 deg turning at 10 rad/s clockwise.

    The book's answers are drawn: v_QR = 0.333, v_SR = 0.426 m/s, good to some 4 %; the rates are own.
    """
    data = four_bar(0.0625, 0.175, 0.1125, 0.2)
    data["drives"]["motor"] |= {"start": "60 deg", "speed": -10}
    w_qr, w_rs, a_qr, a_rs = at_start(data, "coupler.omega", "rocker.omega", "coupler.alpha", "rocker.alpha")
    assert (w_qr, w_rs) == pytest.approx((1.9800260174879885, -3.787072343327955), **OWN)
    assert (a_qr, a_rs) == pytest.approx((23.367569844067795, 46.14345990043259), **OWN)
    assert abs(w_qr) * 0.175 == pytest.approx(0.333, rel=0.045)
    assert abs(w_rs) * 0.1125 == pytest.approx(0.426, rel=0.005)


def test_transmission_angle_of_norton_4_1_by_the_law_of_cosines() -> None:
    """The determinant of the coupler-rocker group is the sine of the transmission angle (Norton eq. 4.32)."""
    data = four_bar(40, 120, 80, 100)
    data["units"] |= {"length": "mm", "angle": "deg"}
    data["drives"]["motor"] |= {"start": 40}
    (determinant,) = at_start(data, Determinant("coupler-rocker"))
    z2 = 40**2 + 100**2 - 2 * 40 * 100 * math.cos(math.radians(40))
    mu = math.acos((120**2 + 80**2 - z2) / (2 * 120 * 80))
    assert abs(determinant) == pytest.approx(math.sin(mu), rel=1e-13)
