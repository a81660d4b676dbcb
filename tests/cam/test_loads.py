"""Contact force, torque, lift-off and springs: Newton and Euler on both bodies, energy, closed forms."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from tests.cam.cases import EVERY, NAMES
from tests.cam.lifts import HEAT_SEAL, harmonic, heat_seal

from linkwright.cam.contact import NoContact
from linkwright.cam.disc import Disc
from linkwright.cam.followers import SwingingRoller, TranslatingFlat, TranslatingKnife, TranslatingRoller
from linkwright.cam.loads import FollowerLoads, by_angle, by_lift, forces
from linkwright.cam.springs import highest_speed, least_preload, least_rate, line
from linkwright.notation import Jet

HEAT = Disc(SwingingRoller(39e-3, 20e-3, 85e-3, 90e-3), heat_seal, -1, HEAT_SEAL)
HEAVY = FollowerLoads(inertia=0.012, rate=6.0, preload=1.5, load=by_lift(lambda s: 0.8 * (s + 0.4).cos()))


@pytest.mark.parametrize("disc", EVERY, ids=NAMES)
def test_both_bodies_are_in_balance(disc: Disc) -> None:
    """The force at the profile's own point, turned into the fixed frame: its moment or thrust moves the follower, its
    moment about the shaft is what the shaft gives."""
    found = forces(disc, HEAVY, 9.0, steps=200)
    look = disc.look(found.theta)
    turn = np.exp(1j * disc.sense * look.theta)
    at, away = (np.array([1, 1j]) @ rows for rows in (look.offset(-disc.follower.radius), unit(look)))
    at, force = at * turn, found.contact * away * turn
    s, _, second = (look.lift.d[k] for k in range(3))
    wanted = 0.012 * second * 81.0 + 6.0 * s + 1.5 + 0.8 * np.cos(s + 0.4)
    lever = at - getattr(disc.follower, "distance", 0.0)
    given = -(lever.conj() * force).imag if disc.follower.turns else force.imag
    assert np.abs(given - wanted).max() < 1e-12 * np.abs(wanted).max()
    assert np.abs(found.along - wanted).max() < 1e-12 * np.abs(wanted).max()
    shaft = disc.sense * (at.conj() * force).imag
    assert np.abs(shaft - found.torque).max() < 1e-12 * np.abs(found.torque).max()
    assert abs(found.work) < 1e-13 * found.torque_rms  # all loads depend on the lift


def unit(look: Any) -> Any:
    return np.array([np.broadcast_to(n.d[0], look.theta.shape) for n in look.normal])


def test_an_offset_roller_in_the_usual_formula() -> None:
    """N = (m s'' w^2 + c (s + d) + F) / cos(alpha), tan(alpha) = (s' - e) / (s + sqrt(Rp^2 - e^2))."""
    disc = Disc(TranslatingRoller(40e-3, 10e-3, 12e-3), harmonic(6e-3, 1e-3, 0.3))
    m, c, d, load, omega = 0.4, 3000.0, 5e-3, 20.0, 60.0
    found = forces(disc, FollowerLoads(m, c, c * d, load), omega)
    t = found.theta
    s = 6e-3 * (1 - np.cos(t)) + 1e-3 * (1 - np.cos(2 * t + 0.3))
    v, a = 6e-3 * np.sin(t) + 2e-3 * np.sin(2 * t + 0.3), 6e-3 * np.cos(t) + 4e-3 * np.cos(2 * t + 0.3)
    tangent = (v - 12e-3) / (s + math.sqrt(50e-3**2 - 12e-3**2))
    normal = (m * a * omega**2 + c * (s + d) + load) * np.sqrt(1 + tangent**2)
    assert np.abs(found.contact / normal - 1).max() < 1e-12
    low, high = found.contact_range
    assert (low.value, high.value) == (pytest.approx(normal.min(), rel=1e-4), pytest.approx(normal.max(), rel=1e-4))
    assert low.value <= normal.min()
    assert high.value >= normal.max()


ECCENTRIC, E, M, C, F = Disc(TranslatingFlat(30e-3), harmonic(10e-3)), 10e-3, 0.5, 2000.0, 30.0
"""A disc of 40 mm, 10 mm off centre, under a flat face: N = F + c e + e (m w^2 - c) cos(theta)."""


def lift_off_stretches(disc: Disc, omega: float) -> list[tuple[float, float]]:
    """The stretches (rad) on which the first side doesn't bear."""
    return [(part.start, part.stop) for part in forces(disc, FollowerLoads(M, C, F), omega).bearing if part.side <= 0]


def test_an_eccentric_disc_lifts_off() -> None:
    limit = math.sqrt((F + 2 * C * E) / (M * E))
    sized = highest_speed(ECCENTRIC, FollowerLoads(M, C, F))
    assert sized is not None
    assert (sized.value, sized.theta) == (pytest.approx(limit, rel=1e-12), pytest.approx(math.pi))
    assert lift_off_stretches(ECCENTRIC, limit * (1 - 1e-9)) == []
    omega = 1.2 * limit
    ((start, stop),) = lift_off_stretches(ECCENTRIC, omega)
    edge = math.acos(-(F + C * E) / (E * (M * omega**2 - C)))
    assert (start, stop) == (pytest.approx(edge, rel=1e-12), pytest.approx(2 * math.pi - edge, rel=1e-12))
    rate = least_rate(ECCENTRIC, FollowerLoads(M, preload=F), (0.0, omega))
    assert rate is not None
    assert rate.value == pytest.approx((M * E * omega**2 - F) / (2 * E), rel=1e-12)
    preload = least_preload(ECCENTRIC, FollowerLoads(M, C, 1e9), (0.0, omega), contact=4.0)
    assert preload.value == pytest.approx(M * E * omega**2 - 2 * C * E + 4.0, rel=1e-12)
    torque = forces(ECCENTRIC, FollowerLoads(M, C, F), limit).torque_range
    t = np.linspace(0, 2 * np.pi, 100001)
    closed = (F + C * E + E * (M * limit**2 - C) * np.cos(t)) * E * np.sin(t)
    assert torque[1].value == pytest.approx(closed.max(), rel=1e-8)
    assert -torque[0].value == pytest.approx(torque[1].value)


def test_a_roller_on_an_eccentric_disc_is_a_slider_crank() -> None:
    """At the far dead centre s'' = -e (1 + e / l): there it lifts off first."""
    far = 50e-3

    def lift(theta: Any) -> Any:
        return -E * theta.cos() + (far**2 - (E * theta.sin()) ** 2).sqrt() - (far - E)

    sized = highest_speed(Disc(TranslatingRoller(30e-3, 10e-3), lift), FollowerLoads(M, C, F))
    assert sized is not None
    assert sized.value == pytest.approx(math.sqrt((F + 2 * C * E) / (M * E * (1 + E / far))), rel=1e-10)


def parabolic(theta: Jet) -> Jet:
    """20 mm up in half a turn with constant accelerations, and down."""
    x = theta.where(theta.d[0] < math.pi, 2 * math.pi - theta) * (1 / math.pi)
    return (2 * x * x).where(x.d[0] < 0.5, 1 - 2 * (1 - x) * (1 - x)) * 20e-3


def test_where_the_acceleration_jumps_the_worse_side_counts() -> None:
    """Right after the middle of the rise s = h / 2, s'' = -4 h / pi^2."""
    disc = Disc(TranslatingKnife(60e-3), parabolic, 1, (0.0, math.pi / 2, math.pi, 3 * math.pi / 2))
    sharp = 4 * 20e-3 / math.pi**2
    sized = highest_speed(disc, FollowerLoads(M, C, F))
    rate = least_rate(disc, FollowerLoads(M, preload=F), (10.0, 200.0))
    assert sized is not None
    assert rate is not None
    assert sized.value == pytest.approx(math.sqrt((F + C * 10e-3) / (M * sharp)), rel=1e-12)
    assert rate.value == pytest.approx((M * sharp * 200**2 - F) / 10e-3, rel=1e-12)
    assert least_rate(disc, FollowerLoads(M, preload=-1.0), (0.0, 1.0)) is None  # on the base circle no rate helps
    over = lift_off_stretches(disc, sized.value * 1.001)
    assert over[0][0] == pytest.approx(math.pi / 2)


def test_springs_of_the_heat_seal_cam_against_a_scan() -> None:
    t = np.linspace(0, 2 * np.pi, 40001)[:-1]
    look = HEAT.look(t)
    s, a = (np.broadcast_to(look.lift.d[k], t.shape) for k in (0, 2))
    lever = np.cos(look.pressure.d[0]) * 90e-3
    contact, fastest = 3.0, 35.0
    loads = FollowerLoads(HEAVY.inertia, load=0.2)

    def short(omega: float) -> Any:
        return contact * lever - loads.inertia * a * omega**2 - 0.2

    rates = np.array([0.0, 5.0, 20.0])
    scanned = [max((short(w) - c * s).max() for w in (0.0, fastest)) for c in rates]
    assert line(HEAT, loads, (0.0, fastest), rates, contact) == pytest.approx(scanned, rel=1e-6)
    made = FollowerLoads(HEAVY.inertia, 20.0, scanned[2] + 1e-4, 0.2)
    top = highest_speed(HEAT, made, contact)
    assert top is not None
    assert top.value == pytest.approx(fastest, rel=1e-4)
    assert min(forces(HEAT, made, w).contact.min() for w in (0.0, 0.5 * top.value, top.value)) >= contact * (1 - 1e-9)
    back = least_rate(HEAT, made, (0.0, fastest), contact)
    assert back is not None
    assert back.value == pytest.approx(20.0, rel=1e-3)


def test_speeds_without_an_end_and_without_a_start() -> None:
    still = Disc(TranslatingFlat(30e-3), lambda theta: 0.0 * theta)
    endless = highest_speed(still, FollowerLoads(M, C, F))
    assert endless is not None
    assert math.isinf(endless.value)
    assert least_rate(still, FollowerLoads(M, preload=1.0), (0.0, 1.0), contact=2.0) is None
    assert highest_speed(ECCENTRIC, FollowerLoads(M, C, -1.0)) is None
    tight = highest_speed(ECCENTRIC, FollowerLoads(M, C, F), contact=F)  # on the base circle nothing is left over
    assert tight is not None
    assert tight.value == pytest.approx(math.sqrt(2 * C / M), rel=1e-12)
    assert least_rate(ECCENTRIC, FollowerLoads(preload=F), (0.0, 0.0), contact=F) is not None
    bare = highest_speed(HEAT, FollowerLoads(0.01, rate=6.0))  # in the lower dwell nothing presses
    assert bare is not None
    assert forces(HEAT, FollowerLoads(0.01, rate=6.0), bare.value * 1.01).contact_range[0].value < 0
    assert forces(HEAT, FollowerLoads(0.01, rate=6.0), bare.value * 0.999).contact_range[0].value >= 0


def test_a_process_takes_work() -> None:
    """30 N during the rise, by the angle: 30 N times the lift."""

    def rise(theta: Jet) -> Jet:
        return Jet.constant(30.0, theta.order).where(theta.d[0] < math.pi, 0.0 * theta)

    found = forces(ECCENTRIC, FollowerLoads(M, C, F, by_angle(rise), joins=(math.pi,)), 20.0)
    assert found.work == pytest.approx(30.0 * 20e-3, rel=1e-12)
    assert found.torque_rms == pytest.approx(math.sqrt(np.mean(found.torque**2)), rel=1e-2)


def test_what_has_no_force() -> None:
    def ramp(theta: Jet) -> Jet:
        return theta.where(theta.d[0] < math.pi, 2 * math.pi - theta) * 5e-3

    with pytest.raises(NoContact) as error:
        forces(Disc(TranslatingRoller(40e-3, 10e-3), ramp, 1, (0.0, math.pi)), FollowerLoads(1.0), 1.0)
    assert (error.value.key, error.value.data) == ("cam.shock", {"theta": 0.0})
    with pytest.raises(NoContact, match=r"cam\.shock"):  # ends elsewhere than it starts
        forces(Disc(TranslatingRoller(40e-3, 10e-3), lambda theta: theta * 5e-3), FollowerLoads(1.0), 1.0)
    with pytest.raises(NoContact) as error:  # an arm that folds over the line of centres
        forces(Disc(SwingingRoller(39e-3, 20e-3, 85e-3, 90e-3), harmonic(1.5)), FollowerLoads(1.0), 1.0)
    assert error.value.key == "cam.locked"
