"""Hertz pressure against published constants and the theory's own identities; how rollers spin and faces slide."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from tests.cam.cases import EVERY
from tests.cam.lifts import HEAT_SEAL, harmonic, heat_seal

from linkwright.cam import form_closure, hertz
from linkwright.cam.contact import ContactPlace, NoContact
from linkwright.cam.disc import Disc
from linkwright.cam.followers import SwingingRoller, TranslatingFlat, TranslatingKnife, TranslatingRoller
from linkwright.cam.loads import FollowerLoads, forces

HEAT = Disc(SwingingRoller(39e-3, 20e-3, 85e-3, 90e-3), heat_seal, -1, HEAT_SEAL)
ROLLED = [disc for disc in EVERY if disc.follower.radius > 0]
THETA = np.linspace(0, 2 * np.pi, 181)[:-1]


@pytest.mark.parametrize(
    ("first", "second", "printed"),
    [(30, 30, 2300), (30, 22, 2100), (22, 22, 1960), (30, 16, 1900), (22, 16, 1800), (16, 16, 1650)],
)
def test_the_elastic_coefficient(first: float, second: float, printed: float) -> None:
    """AGMA's sqrt(E / pi), as in Shigley's Mechanical Engineering Design, table 14-8 (v = 0.3, moduli in 1e6 psi,
    printed in psi^(1/2)): steel, cast iron, tin bronze, printed to 10 or 50."""
    found = hertz.effective(*(hertz.Material(modulus * 1e6, 0.3) for modulus in (first, second)))
    assert math.sqrt(found / math.pi) == pytest.approx(printed, rel=0.015)


def test_a_constant_load_on_a_round_disc() -> None:
    """p = 0.418 sqrt(F E / (L R)) for v = 0.3 (Dubbel); the strip carries the load; b / R = 2 p / E (Johnson 4.43)."""
    disc = Disc(TranslatingRoller(40e-3, 10e-3), lambda theta: 0.0 * theta)
    steel = hertz.Material(210e9, 0.3)
    found = hertz.pressure(forces(disc, FollowerLoads(preload=1000.0), 10.0), 12e-3, steel, steel)
    assert np.ptp(found.peak) < 1e-14 * found.highest.value
    assert found.highest.value == pytest.approx(0.418 * math.sqrt(1000 * 210e9 / (12e-3 * 8e-3)), rel=1e-3)
    assert found.highest.value == pytest.approx(found.peak[0], rel=1e-14)
    assert found.reduced[0] == pytest.approx(8e-3, rel=1e-14)
    half_width = 1000.0 / (math.pi / 2 * found.peak[0] * 12e-3)
    assert half_width / 8e-3 == pytest.approx(2 * found.peak[0] / (210e9 / (2 * 0.91)), rel=1e-13)


@pytest.mark.parametrize("disc", [disc for disc in EVERY if disc.follower.faced or disc in ROLLED])
def test_both_radii_count(disc: Disc) -> None:
    look = disc.look(THETA)
    roller = disc.follower.radius
    inverse = 1 / look.radius(-roller) + (1 / roller if roller else 0.0)
    assert np.abs(ContactPlace(disc).reduced(look).d[0] * inverse - 1).max() < 1e-12
    if roller:  # the outer flank of a groove is hollow where the cam is convex
        assert (
            np.abs(ContactPlace(disc, flank=1).reduced(look).d[0] * (1 / roller - 1 / look.radius(roller)) - 1).max()
            < 1e-11
        )


def test_a_hollow_profile_spreads_the_load() -> None:
    """Case of test_checks: at angle 0 the profile's radius is -(y^2 / (a - y) + r)."""
    disc = Disc(TranslatingRoller(30e-3, 10e-3), harmonic(8e-3, 15e-3))
    hollow = (40e-3**2) / (68e-3 - 40e-3) + 10e-3
    reduced = hertz.pressure(forces(disc, FollowerLoads(preload=500.0), 1.0), 10e-3).reduced[0]
    assert reduced == pytest.approx(1 / (1 / 10e-3 - 1 / hollow), rel=1e-12)
    assert reduced > 10e-3


def test_the_highest_pressure_has_its_place() -> None:
    found = hertz.pressure(forces(HEAT, FollowerLoads(0.012, 6.0, 1.5), 18.0, steps=20000), 10e-3)
    assert found.highest.value == pytest.approx(found.peak.max(), rel=1e-7)
    assert found.highest.value >= found.peak.max()
    assert found.highest.theta == pytest.approx(found.forces.theta[found.peak.argmax()], abs=1e-3)
    off = hertz.pressure(forces(HEAT, FollowerLoads(0.012, 1.0), 40.0), 10e-3)
    assert (off.peak[off.forces.contact <= 0] == 0).all()
    assert off.peak.max() > 0


@pytest.mark.parametrize("disc", ROLLED)
@pytest.mark.parametrize("flank", [-1, 1])
def test_a_roller_rolls_along_its_flank(disc: Disc, flank: int) -> None:
    """Seen from the cam its centre goes along the pitch curve and turns by that length over its radius."""
    side, omega = ContactPlace(disc, flank=flank), 11.0
    look = disc.look(THETA)
    arm = -np.broadcast_to(look.lift.d[1], THETA.shape) if disc.follower.turns else 0.0
    length = np.broadcast_to(look.speed.d[0], THETA.shape)
    wanted = disc.sense * (1 + flank * length / disc.follower.radius) - arm
    found = hertz.rolling(side, omega, THETA)
    assert np.abs(found.spin - wanted * omega).max() < 1e-12 * np.abs(found.spin).max()
    assert found.spin_range[1].value >= found.spin.max() - 1e-9
    whole = np.fft.fftfreq(THETA.size, 1 / THETA.size)
    total = (wanted + arm) * omega**2
    rate = np.fft.ifft(1j * whole * np.fft.fft(total)).real
    assert np.abs(found.acceleration - rate).max() < 1e-6 * np.abs(rate).max()


def test_a_roller_on_an_eccentric_disc_is_a_planet() -> None:
    """Willis: (w_roller - w_rod) r = -(w_disc - w_rod) R, the rod from the disc's centre to the roller's."""
    e, far, roller = 10e-3, 50e-3, 10e-3

    def lift(theta: Any) -> Any:
        return -e * theta.cos() + (far**2 - (e * theta.sin()) ** 2).sqrt() - (far - e)

    found = hertz.rolling(ContactPlace(Disc(TranslatingRoller(30e-3, roller), lift)), 7.0, THETA)
    rod = np.arcsin(e * np.sin(THETA) / far)
    rate = e * np.cos(THETA) / (far * np.cos(rod))
    second = (far * np.sin(rod) * rate**2 - e * np.sin(THETA)) / (far * np.cos(rod))
    ratio = 40e-3 / roller
    assert found.spin == pytest.approx(7.0 * (rate - (1 - rate) * ratio), rel=1e-12)
    assert found.acceleration == pytest.approx(49.0 * second * (1 + ratio), abs=1e-10)


@pytest.mark.parametrize("sense", [1, -1])
def test_a_flat_face_slides(sense: int) -> None:
    """The contact's height times the speed, whatever the lift does."""
    disc = Disc(TranslatingFlat(40e-3), harmonic(6e-3, 0.5e-3, 0.3), sense)
    found = hertz.rolling(ContactPlace(disc), 10.0, THETA)
    lift = disc.look(THETA).lift.d[0]
    assert found.surface == pytest.approx(sense * 10.0 * (40e-3 + lift), rel=1e-12)


def test_what_has_no_line_of_contact() -> None:
    knife = Disc(TranslatingKnife(40e-3), harmonic(6e-3))
    with pytest.raises(NoContact, match=r"cam\.knife"):
        hertz.pressure(forces(knife, FollowerLoads(preload=1.0), 1.0), 10e-3)
    sharp = Disc(TranslatingRoller(5e-3, 20e-3), harmonic(8e-3, -6e-3))
    with pytest.raises(NoContact, match=r"cam\.undercut"):
        hertz.pressure(forces(sharp, FollowerLoads(preload=1.0), 1.0), 10e-3)
    with pytest.raises(NoContact, match=r"cam\.undercut"):
        hertz.rolling(ContactPlace(sharp), 1.0, THETA)
    assert hertz.rolling(ContactPlace(knife), 1.0, THETA).surface.size == THETA.size
    with pytest.raises(NoContact, match=r"cam\.no-roller"):
        _ = hertz.rolling(ContactPlace(knife), 1.0, THETA).spin


def test_the_outer_flank_has_its_own_pressure() -> None:
    groove = form_closure.groove(HEAT)
    found = forces(HEAT, FollowerLoads(0.012), 30.0, second=groove.second)
    inner, outer = (hertz.pressure(found, 10e-3, second=second) for second in (False, True))
    assert ((inner.peak > 0) & (outer.peak > 0)).sum() == 0
    assert (inner.highest.value, outer.highest.value) == (
        pytest.approx(inner.peak.max(), rel=1e-3),
        pytest.approx(outer.peak.max(), rel=1e-3),
    )
