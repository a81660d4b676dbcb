"""Pitch curve, profile, curvature and pressure angle: closed forms, the envelope, known shapes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.cam.lifts import HEAT_SEAL, harmonic, heat_seal

from linkwright.cam.disc import Disc
from linkwright.cam.extremes import curvature, extremes, pressure
from linkwright.cam.followers import (
    FOLLOWERS,
    NoFollower,
    SwingingFlat,
    SwingingRoller,
    TranslatingFlat,
    TranslatingKnife,
    TranslatingRoller,
)

THETA = np.linspace(0.0, 2 * np.pi, 400, endpoint=False)
CASES: dict[str, list[Any]] = {
    "translating_roller": [
        (TranslatingRoller(40e-3, 10e-3, offset), harmonic(6e-3, 1e-3, 0.3)) for offset in (0.0, 12e-3, -9e-3)
    ],
    "translating_knife": [(TranslatingKnife(40e-3, offset=5e-3), harmonic(6e-3, 1e-3, 0.3))],
    "swinging_roller": [(SwingingRoller(39e-3, 20e-3, 85e-3, 90e-3), harmonic(0.1, 0.01, 0.5))],
    "translating_flat": [(TranslatingFlat(40e-3), harmonic(6e-3, 1e-3, 0.3))],
    "swinging_flat": [(SwingingFlat(40e-3, 90e-3, face), harmonic(0.06, 0.01, 0.5)) for face in (0.0, 8e-3, -8e-3)],
}
EVERY = [(name, case, sense) for name, cases in CASES.items() for case in cases for sense in (1, -1)]


def test_each_registered_follower_is_tried() -> None:
    assert set(CASES) == set(FOLLOWERS)


def closed(name: str, f: Any, s: Any, sense: int) -> tuple[Any, Any, Any]:
    """Contact or centre in the fixed frame as complex numbers, tangent of the pressure angle, radius of curvature: the
    usual formulas (Rothbart 2004; Norton)."""
    s, v, a = (s.d[k] for k in range(3))
    if name in ("translating_roller", "translating_knife"):
        e, y = f.offset, s + math.sqrt((f.base + f.roller) ** 2 - f.offset**2)
        b = v - sense * e
        rho = (y**2 + b**2) ** 1.5 / (y**2 + b * (2 * v - sense * e) - y * a)
        return e + 1j * y, b / y, rho
    if name == "translating_flat":
        return sense * v + 1j * (f.base + s), 0 * s, f.base + s + a
    if name == "swinging_roller":
        d, arm, psi, h = f.distance, f.arm, f.start + s, 1 + sense * v
        rho = (d**2 + arm**2 * h**2 - 2 * d * arm * h * np.cos(psi)) ** 1.5 / (
            d**2 + arm**2 * h**3 - d * arm * h * (1 + h) * np.cos(psi) - d * arm * a * np.sin(psi)
        )
        return d - arm * np.exp(-1j * psi), sense * (arm * h - d * np.cos(psi)) / (d * np.sin(psi)), rho
    d, psi, h = f.distance, f.start + s, 1 + sense * v
    t = d * np.cos(psi) / h
    rho = f.face + d * (np.sin(psi) * (1 + 2 * sense * v) / h**2 + np.cos(psi) * a / h**3)
    return d - t * np.exp(-1j * psi) + f.face * 1j * np.exp(-1j * psi), sense * f.face / t, rho


@pytest.mark.parametrize(("name", "case", "sense"), EVERY)
def test_closed_forms(name: str, case: Any, sense: int) -> None:
    follower, lift = case
    look = Disc(follower, lift, sense).look(THETA)
    at, tangent, rho = closed(name, follower, look.lift, sense)
    place = at * np.exp(-1j * sense * THETA)
    assert np.abs(look.offset(0.0) - [place.real, place.imag]).max() < 1e-15
    assert np.abs(np.tan(look.pressure.d[0]) - tangent).max() < 1e-12
    assert np.abs(look.radius() / rho - 1).max() < 1e-11


@pytest.mark.parametrize(("name", "case", "sense"), EVERY)
def test_the_profile_touches_the_follower_and_nothing_is_inside_it(name: str, case: Any, sense: int) -> None:
    """The reversal of the construction: the follower in all its places around the cam at rest, none cuts it."""
    follower, lift = case
    disc = Disc(follower, lift, sense)
    look = disc.look(THETA)
    profile = look.offset(-follower.radius).T
    back = np.exp(-1j * sense * THETA)
    touch = follower.touch(look.lift)
    if touch.at is not None:
        centre = (touch.at[0].d[0] + 1j * touch.at[1].d[0]) * back
        away = np.abs((profile[:, 0] + 1j * profile[:, 1])[:, None] - centre[None, :]) - follower.radius
    else:
        normal = np.exp(1j * np.broadcast_to(touch.facing.d[0], THETA.shape)) * back
        point = profile[:, 0] + 1j * profile[:, 1]
        away = touch.height.d[0][None, :] - (point[:, None] * normal.conj()[None, :]).real
    assert np.abs(np.diag(away)).max() < 1e-15
    assert away.min() > -1e-15


MADE: dict[str, Any] = {
    "translating_roller": lambda u: (TranslatingRoller(0.05, 0.01, 0.04 * u), 0.002),
    "translating_knife": lambda u: (TranslatingKnife(0.05, offset=0.04 * u), 0.002),
    "translating_flat": lambda u: (TranslatingFlat(0.05 + 0.01 * u), 0.002),
    "swinging_roller": lambda u: (SwingingRoller(0.04, 0.012, 0.09 + 0.01 * u, 0.085), 0.02),
    "swinging_flat": lambda u: (SwingingFlat(0.04, 0.09, 0.01 * u), 0.02),
}


@pytest.mark.parametrize("name", FOLLOWERS)
@given(st.floats(0.5, 4.0), st.floats(-0.8, 0.8), st.floats(0.0, 6.0), st.sampled_from([1, -1]))
@settings(max_examples=12, deadline=None)
def test_tangent_and_curvature_against_the_curve_itself(
    name: str, size: float, length: float, phase: float, sense: int
) -> None:
    """Along the curve of random cams, by a Fourier series: derivatives that know of no formula here."""
    follower, lift = MADE[name](length)
    n = 512
    theta = np.arange(n) * 2 * np.pi / n
    look = Disc(follower, harmonic(size * lift, 0.1 * size * lift, phase), sense).look(theta)
    curve = look.offset(0.0)
    waves = 1j * np.fft.fftfreq(n, 1 / n)
    first, second = (np.fft.ifft(waves**k * np.fft.fft(curve[0] + 1j * curve[1])) for k in (1, 2))
    kappa = -sense * (first.conj() * second).imag / np.abs(first) ** 3
    assert np.abs(np.broadcast_to(look.curvature.d[0], n) - kappa).max() < 1e-7 * np.abs(kappa).max()
    normal = sense * 1j * first / np.abs(first)
    assert np.abs(np.array([*(c.d[0] for c in look.normal)]) - [normal.real, normal.imag]).max() < 1e-8


@pytest.mark.parametrize(
    ("sense", "curve", "profile", "pitch", "angle"),
    [(-1, 0.0450156, 22.2145, 42.2145, 44.325), (1, 0.0669892, 14.9278, 34.9278, 41.904)],
)
def test_the_heat_seal_cam(sense: int, curve: float, profile: float, pitch: float, angle: float) -> None:
    """Zhang, Fu and Gao print 0.045 per mm and 22.25 mm (read off a plot): lift in the sense of the cam's turn."""
    disc = Disc(SwingingRoller(39.0, 20.0, 85.0, 90.0), heat_seal, sense, HEAT_SEAL)
    assert extremes(disc, curvature(-20.0))[1].value == pytest.approx(curve, abs=5e-8)
    assert 1 / extremes(disc, curvature(-20.0))[1].value == pytest.approx(profile, abs=5e-5)
    assert 1 / extremes(disc, curvature())[1].value == pytest.approx(pitch, abs=5e-5)
    assert math.degrees(extremes(disc, pressure)[1].value) == pytest.approx(angle, abs=5e-4)
    edge = np.hypot(*disc.look(np.linspace(0, 2 * np.pi, 3600)).offset(-20.0))
    assert (edge.min(), edge.max()) == (pytest.approx(39.0, abs=1e-9), pytest.approx(55.852, abs=1e-3))


@pytest.mark.parametrize(
    ("follower", "key"),
    [
        (TranslatingRoller(30.0, 10.0, 41.0), "cam.offset"),
        (SwingingRoller(39.0, 20.0, 200.0, 90.0), "cam.reach"),
        (SwingingFlat(95.0, 90.0), "cam.face"),
    ],
)
def test_a_follower_that_can_not_reach(follower: Any, key: str) -> None:
    with pytest.raises(NoFollower) as error:
        Disc(follower, harmonic(1.0)).look(THETA)
    assert error.value.key == key
