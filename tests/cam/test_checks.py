"""Checks against closed forms and each other; sizes that keep limits and none smaller that does."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from tests.cam.lifts import HEAT_SEAL, cycloidal, harmonic, heat_seal

from linkwright.cam.checks import CamLimits, checks, undercut
from linkwright.cam.disc import Disc
from linkwright.cam.followers import SwingingRoller, TranslatingFlat, TranslatingRoller
from linkwright.cam.sizing import feasible, margin, resized, smallest

HEAT = Disc(SwingingRoller(39.0, 20.0, 85.0, 90.0), heat_seal, -1, HEAT_SEAL)


def by_name(disc: Disc, limits: CamLimits | None = None) -> dict[str, Any]:
    return {check.name: check for check in checks(disc, limits)}


def test_the_heat_seal_cam() -> None:
    """The paper compares 22.25 mm, the profile's radius, with the roller's 20; what matters is the pitch curve's."""
    found = by_name(HEAT, CamLimits(pressure_rise=math.radians(45), cutter=8.0))
    assert found["profile_radius"].value == pytest.approx(22.2145, abs=5e-5)
    assert found["profile_radius"].margin is None
    assert (found["pitch_radius"].value, found["pitch_radius"].margin) == (
        pytest.approx(42.2145, abs=5e-5),
        pytest.approx(22.2145, abs=5e-5),
    )
    angles = [math.degrees(found[name].value) for name in ("pressure_rise", "pressure_return")]
    assert max(angles) == pytest.approx(44.325, abs=5e-4)
    assert found["pressure_rise"].passed
    assert not by_name(HEAT, CamLimits(pressure_return=math.radians(44)))["pressure_return"].passed


def test_pressure_is_looked_for_where_the_follower_moves() -> None:
    look = HEAT.look(np.linspace(0, 2 * np.pi, 20001))
    size = np.abs(look.pressure.d[0])
    for rising, sign in ((True, 1), (False, -1)):
        moves = sign * np.broadcast_to(look.lift.d[1], size.shape) > 1e-9
        found = by_name(HEAT)["pressure_rise" if rising else "pressure_return"]
        assert found.value == pytest.approx(size[moves].max(), rel=1e-6)
        assert found.value >= size[moves].max() * (1 - 1e-12)


def test_a_cusp_is_where_the_pitch_radius_is_the_rollers() -> None:
    radius = by_name(HEAT)["pitch_radius"].value
    for roller, cut in ((radius * 0.999, False), (radius * 1.001, True)):
        bigger = Disc(SwingingRoller(59.0 - roller, roller, 85.0, 90.0), heat_seal, -1, HEAT_SEAL)
        found = undercut(bigger)
        assert (found is not None) == cut
        assert cut or by_name(bigger)["profile_radius"].value == pytest.approx(radius * 0.001, rel=1e-6)


def test_a_flat_face_needs_a_convex_cam() -> None:
    """rho = base + s + s'': of 2 .. with harmonics known in closed form."""
    lift = harmonic(10.0, 3.0)
    least = min(
        40 + 13 - 3 * math.cos(2 * t) + 12 * math.cos(2 * t) for t in np.linspace(0, 2 * math.pi, 100001)
    )  # the first harmonic falls out of s + s''
    found = by_name(Disc(TranslatingFlat(40.0), lift))["profile_radius"]
    assert found.value == pytest.approx(least, rel=1e-9)
    assert undercut(Disc(TranslatingFlat(40.0), lift)) is None
    assert undercut(Disc(TranslatingFlat(40.0 - least - 0.01), harmonic(10.0, 12.0))) is not None


def test_a_hollow_is_held_against_the_cutter() -> None:
    disc = Disc(TranslatingRoller(30.0, 10.0), harmonic(8.0, 15.0))
    found = by_name(disc, CamLimits(cutter=70.0, groove=True))
    y, a = 40.0, 8 + 60.0  # at angle 0: s = s' = 0, rho = Y^2 / (Y - s'')
    assert found["hollow_radius"].value == pytest.approx(-(y**2) / (y - a) + 10.0, rel=1e-9)
    assert not found["hollow_radius"].passed
    assert found["groove_radius"].margin == pytest.approx(-(y**2) / (y - a) - 10.0, rel=1e-9)


def translating(theta: Any) -> Any:
    """20 mm cycloidal in half a turn, and back."""
    rise = cycloidal(theta / math.pi) * 20.0
    fall = 20.0 - cycloidal((theta - math.pi) / math.pi) * 20.0
    return rise.where(theta.d[0] < math.pi, fall)


@pytest.mark.parametrize("offset", [0.0, 5.0])
def test_the_smallest_base_circle(offset: float) -> None:
    """The limits hold at it and not below; without offset the pressure angle alone gives s' / (Rp + s) = tan."""
    disc = Disc(TranslatingRoller(40.0, 8.0, offset), translating, 1, (0.0, math.pi))
    limits = CamLimits(pressure_rise=math.radians(15 if offset else 30), pressure_return=math.radians(60))
    base = smallest(disc, limits, 5.0, 200.0)
    assert base is not None
    assert base > 5.0
    assert abs(margin(resized(disc, {"base": base}), limits)) < 1e-10
    assert margin(resized(disc, {"base": base * 0.999}), limits) < 0
    if not offset:
        t = np.linspace(0, np.pi, 200001)
        s, v = 20 * (t / np.pi - np.sin(2 * t) / (2 * np.pi)), 20 / np.pi * (1 - np.cos(2 * t))
        assert base == pytest.approx((v / math.tan(math.radians(30)) - s).max() - 8.0, rel=1e-8)
    assert smallest(disc, CamLimits(pressure_rise=1e-3), 5.0, 200.0) is None


def test_the_feasible_map_and_the_margin_are_one() -> None:
    limits = CamLimits(pressure_rise=math.radians(40), pressure_return=math.radians(40), pitch_over_roller=2.0)
    found = feasible(HEAT, limits, ("base", 20.0, 60.0), ("distance", 60.0, 110.0), steps=2)
    assert found.margins.shape == (3, 3)
    assert found.margins[1, 1] == pytest.approx(
        margin(resized(HEAT, {"base": 40.0, "distance": 85.0}), limits), rel=1e-3
    )
    assert np.isneginf(margin(resized(HEAT, {"base": 200.0}), limits))
