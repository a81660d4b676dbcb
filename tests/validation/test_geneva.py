"""Geneva drives against closed forms, in 40-digit arithmetic.

J. H. Bickford, Mechanisms for Intermittent Motion (1972), and textbooks of mechanism theory have, of an external wheel
with n slots and lambda = sin(180 deg/n), over the driver's angle alpha from the line of centres at the speed 1,

    omega = lambda (cos(alpha) - lambda)/(1 - 2 lambda cos(alpha) + lambda^2),
    peak speed = lambda/(1 - lambda),        acceleration where the pin enters = tan(180 deg/n),
    acceleration = lambda (lambda^2 - 1) sin(alpha)/(1 - 2 lambda cos(alpha) + lambda^2)^2,
    peak where cos(alpha) = (((1 + lambda^2)/(4 lambda))^2 + 2)^(1/2) - (1 + lambda^2)/(4 lambda),
    time in motion over that of a turn = (n - 2)/(2 n).

The peak acceleration is found here without any of them: from the angle of the pin as seen from the wheel's centre, of
which the derivatives and their largest value are taken numerically with 40 digits. The table has the three digits with
which peaks are usually printed. Drives are exact, so the tolerances are those of round-off and of the search.
"""

from __future__ import annotations

from math import tan
from typing import Any

import mpmath as mp
import numpy as np
import pytest

import linkwright as lw
from elements.geneva.drives import LINE, model
from helpers.compiled import compiled_from
from linkwright.elements.geneva.sentence import peaks as said

SLOTS = [3, 4, 5, 6, 7, 8]
PRINTED = {3: (6.46, 31.4), 4: (2.41, 5.41), 5: (1.43, 2.30), 6: (1.00, 1.35), 8: (0.620, 0.700)}
"""Peak speed and peak acceleration of the wheel over the driver's speed and its square."""


def seen(n: int, alpha: Any) -> Any:
    """The angle of the pin as seen from the wheel's centre, against the line to the driver's."""
    size = mp.sin(mp.pi / n)
    return mp.arg(mp.conj(1 - size * mp.expj(alpha)))


def peaks(n: int) -> tuple[Any, Any, Any]:
    """Peak speed, peak acceleration and where that is (rad), by numerical derivatives with 40 digits."""
    with mp.workdps(40):
        speed = mp.diff(lambda alpha: seen(n, alpha), 0)
        at = mp.findroot(
            lambda alpha: mp.diff(lambda x: seen(n, x), alpha, 3),
            (mp.mpf(3) / 100 * n, mp.mpf(5) / 100 * n)
            if n < 9
            else (mp.pi / 2 - mp.mpf(12) / n, mp.pi / 2 - mp.mpf(13) / n),
        )
        return speed, abs(mp.diff(lambda alpha: seen(n, alpha), at, 2)), abs(at)


def cycle(n: int, **measures: Any) -> Any:
    """The outcome of two turns of a drive at one radian a second."""
    data = model(
        n, psi=-170.0, speed="1 rad/s", measures=measures, studies={"cycle": {"turns": "2 motor", "samples": 400}}
    )
    job = lw.run(lw.Document.model_validate(data))
    assert job.cycle is not None
    assert job.cycle.result.certificate.sound(1e-11)
    return {found.name: found.found[0] for found in job.cycle.measures}


@pytest.mark.parametrize("n", SLOTS)
def test_peaks_are_those_of_the_closed_forms(n: int) -> None:
    found = cycle(
        n,
        speed={"max": "abs(wheel.omega)/(1 rad/s)"},
        acceleration={"max": "abs(wheel.alpha)/(1 rad/s^2)"},
        moving={"mean": "indexing.engaged"},
    )
    speed, acceleration, at = peaks(n)
    size = float(mp.sin(mp.pi / n))
    assert found["speed"].value == pytest.approx(float(speed), rel=1e-13)
    assert found["speed"].value == pytest.approx(size / (1 - size), rel=1e-13)
    assert found["acceleration"].value == pytest.approx(float(acceleration), rel=1e-12)
    psi = np.mod(found["acceleration"].time - np.radians(170.0) + np.pi, 2 * np.pi) - np.pi
    assert abs(psi) == pytest.approx(float(at), abs=1e-6)
    assert found["moving"].value == pytest.approx((n - 2) / (2 * n), rel=1e-9)
    if n in PRINTED:
        for value, printed in zip((found["speed"].value, found["acceleration"].value), PRINTED[n], strict=True):
            assert f"{value:.3g}" == f"{printed:.3g}"


@pytest.mark.parametrize("n", [*SLOTS, 12, 60])
def test_what_is_said_beforehand_is_right(n: int) -> None:
    """Peaks in the summary of a drive, by closed forms."""
    speed, acceleration, at = peaks(n)
    assert said(n) == pytest.approx((float(speed), float(acceleration), float(at)), rel=1e-12)


@pytest.mark.parametrize("n", SLOTS)
def test_speed_and_acceleration_are_those_of_the_closed_forms(n: int) -> None:
    """All over an indexing, and the jumps of the acceleration at both of its ends, from both sides."""
    size, reach = float(mp.sin(mp.pi / n)), np.pi / 2 - np.pi / n
    alpha = np.linspace(-reach + 1e-9, reach - 1e-9, 301)
    run = compiled_from(model(n, psi=-float(np.degrees(reach)) - 1.0, speed="1 rad/s"))
    omega, acceleration = run.evaluate(["wheel.omega", "wheel.alpha"], alpha + reach + np.radians(1.0))
    below = 1 - 2 * size * np.cos(alpha) + size**2
    assert np.abs(omega + size * (np.cos(alpha) - size) / below).max() < 1e-12 * np.abs(omega).max()
    expected = -size * (size**2 - 1) * np.sin(alpha) / below**2
    assert np.abs(acceleration - expected).max() < 1e-11 * np.abs(expected).max()
    ends = np.radians(1.0) + np.array([-1e-9, 1e-9, 2 * reach - 1e-9, 2 * reach + 1e-9])
    before, entered, leaving, after = run.evaluate(["wheel.alpha"], ends)[0]
    assert (before, after) == (0.0, 0.0)
    assert (entered, leaving) == pytest.approx((-tan(np.pi / n), tan(np.pi / n)), rel=1e-7)


def test_the_speed_of_a_drive_that_accelerates() -> None:
    """Rates of the wheel follow from those of the driver: omega = f' psi', alpha = f'' psi'^2 + f' psi''."""
    data = model(4, psi=-30.0)
    data["drives"]["motor"] = {**data["drives"]["motor"], "acceleration": "90 deg/s^2", "speed": "100 deg/s"}
    t = np.linspace(0.0, 0.5, 41)
    omega, alpha, jerk = compiled_from(data).evaluate(["wheel.omega", "wheel.alpha", "indexing.jerk"], t)
    speed, gain = np.radians(100 + 90 * t), np.radians(90)
    psi = np.radians(-30 + 100 * t + 45 * t**2)
    with mp.workdps(30):
        slopes = np.array([[float(mp.diff(lambda a: seen(4, a), p, k)) for k in (1, 2, 3)] for p in psi.tolist()]).T
    assert np.abs(omega + slopes[0] * speed).max() < 1e-12
    assert np.abs(alpha + slopes[1] * speed**2 + slopes[0] * gain).max() < 1e-11
    expected = -(slopes[2] * speed**3 + 3 * slopes[1] * speed * gain)
    assert np.abs(jerk - expected).max() < 1e-11 * np.abs(expected).max()


def test_torques_by_power() -> None:
    """Of a balanced wheel without gravity the motor's torque is the inertia's times the slope, I omega alpha over the
    speed, and zero in the dwell."""
    data = model(6, psi=LINE)
    del data["gravity"]
    data["links"]["wheel"] |= {"com": [0, 0]}
    t = np.linspace(0.0, 1.0, 201)
    torque, omega, alpha, taken = compiled_from(data).evaluate(
        ["motor.torque", "wheel.omega", "wheel.alpha", "indexing.engaged"], t
    )
    expected = 9000e-6 * omega * alpha / (2 * np.pi)
    assert np.abs(torque - expected).max() < 1e-12 * np.abs(expected).max()
    assert np.abs(torque[taken == 0]).max() < 1e-15
