"""Form closure: which flank bears, conjugate discs without play, yokes."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from tests.cam.cases import EVERY, NAMES
from tests.cam.lifts import HEAT_SEAL, harmonic, heat_seal

from linkwright.cam.contact import ContactPlace, NoContact
from linkwright.cam.disc import Disc
from linkwright.cam.followers import SwingingRoller, TranslatingFlat, TranslatingKnife, TranslatingRoller
from linkwright.cam.form_closure import conjugate, groove, yoke
from linkwright.cam.hertz import rolling
from linkwright.cam.loads import FollowerLoads, forces
from linkwright.cam.rolling import rolled
from linkwright.notation import Jet

HEAT = Disc(SwingingRoller(39e-3, 20e-3, 85e-3, 90e-3), heat_seal, -1, HEAT_SEAL)
FINE = np.linspace(0, 2 * np.pi, 20000, endpoint=False)


def test_a_groove_bears_by_the_sign_of_the_acceleration() -> None:
    """Cycloidal rise and return with inertia alone: it changes in the middle of both, and from flank to flank."""
    found = forces(HEAT, FollowerLoads(0.012), 30.0, second=groove(HEAT).second)
    a, b, c = HEAT_SEAL[1:]
    assert [part.side for part in found.bearing] == [1, -1, 0, -1, 1, 0]
    assert [part.start for part in found.bearing] == pytest.approx([0, a / 2, a, b, (b + c) / 2, c], abs=1e-12)
    assert found.reversals == pytest.approx([a / 2, (b + c) / 2])
    assert np.abs(found.contact * found.contact_second).max() == 0
    lever = 90e-3 * np.cos(HEAT.look(found.theta).pressure.d[0])
    assert np.abs((found.contact - found.contact_second) * lever - found.along).max() < 1e-12
    assert found.second_range is not None
    assert found.second_range[1].value == pytest.approx(found.contact_second.max(), rel=1e-3)


def test_both_flanks_of_a_groove_are_checked() -> None:
    deep = groove(Disc(TranslatingRoller(30e-3, 10e-3), harmonic(8e-3, 15e-3)))
    assert {check.name: check.passed for check in deep.checks} == {"pitch_radius": True, "groove_radius": True}
    y, roller = 30e-3, 70e-3  # at angle 0 the pitch curve's radius is y^2 / (a - y), less than the roller's
    cut = groove(Disc(TranslatingRoller(y + 35e-3 - roller, roller), harmonic(8e-3, 15e-3)))
    assert not cut.passed
    assert cut.second.flank == 1
    with pytest.raises(NoContact, match=r"cam\.groove"):
        groove(Disc(TranslatingFlat(30e-3), harmonic(1e-3)))


@pytest.mark.parametrize("disc", EVERY, ids=NAMES)
def test_a_conjugate_disc_touches_all_around(disc: Disc) -> None:
    """The second contact goes with the follower as one body, and its disc with the first; nothing of the second's
    description but its profile and its place at the lift 0 is used."""
    made = conjugate(disc, base=disc.follower.base * 0.95)
    follower: Any = made.disc.follower
    touch = follower.touch(Jet.constant(made.total, 3))
    theta = FINE[::800]
    s = np.broadcast_to(disc.look(theta).lift.d[0], theta.shape)
    x, y = made.curve(FINE)
    curve = (x + 1j * y)[None, :] * np.exp(1j * disc.sense * theta)[:, None]
    pivot = getattr(follower, "distance", 0.0)

    def carried(point: complex) -> Any:
        return pivot + (point - pivot) * np.exp(-1j * s) if follower.turns else point + 1j * s

    if touch.at is not None:
        centre = carried(complex(float(touch.at[0].d[0]), -float(touch.at[1].d[0])))
        gap = np.abs(curve - centre[:, None]).min(axis=1) - follower.radius
    else:
        facing, height = -float(touch.facing.d[0]), float(touch.height.d[0])
        foot = carried(height * np.exp(1j * facing))
        normal = np.exp(1j * (facing - (s if follower.turns else 0 * s)))
        gap = ((foot[:, None] - curve) * normal.conj()[:, None]).real.min(axis=1)
    assert np.abs(gap).max() < 1e-16
    if follower.turns:
        assert made.between == pytest.approx(disc.follower.start + follower.start + made.total)


@pytest.mark.parametrize("disc", EVERY, ids=NAMES)
def test_the_size_of_a_conjugate_disc_and_what_is_between(disc: Disc) -> None:
    other = {"roller": disc.follower.radius * 0.8} if disc.follower.radius else {}
    made = conjugate(disc, base=disc.follower.base * 0.97, **other)
    again = conjugate(disc, between=made.between, **other)
    assert again.disc.follower.base == pytest.approx(disc.follower.base * 0.97, rel=1e-12)
    with pytest.raises(NoContact, match=r"cam\.second-side"):
        conjugate(disc, between=disc.follower.start + made.total + (-1.6 if disc.follower.turns else -1e-3))


def test_lifts_of_both_contours_add_up() -> None:
    """Each disc rolled for itself, the second with a longer arm and a smaller roller."""
    made = conjugate(HEAT, base=50e-3, roller=15e-3, arm=95e-3)
    theta = np.linspace(0, 2 * np.pi, 50)
    lifts = [rolled(disc, disc.look(FINE).offset(-disc.follower.radius), theta) for disc in (made.first, made.disc)]
    assert np.abs(lifts[0] + lifts[1] - math.radians(12)).max() < 1e-7


def test_forces_of_a_conjugate_pair() -> None:
    """What the second disc does is in balance with its shaft too."""
    made = conjugate(HEAT)
    found = forces(HEAT, FollowerLoads(0.012), 30.0, second=made.second)
    look = made.disc.look(found.theta)
    profile = look.offset(-made.disc.follower.radius)
    normal = np.array([np.broadcast_to(n.d[0], found.theta.shape) for n in look.normal])
    moment = made.disc.sense * found.contact_second * (profile[0] * normal[1] - profile[1] * normal[0])
    bears = found.contact_second > 0
    assert 50 < bears.sum() < bears.size - 50
    assert np.abs(moment - found.torque)[bears].max() < 1e-12
    assert found.reversals == pytest.approx([HEAT_SEAL[1] / 2, (HEAT_SEAL[2] + HEAT_SEAL[3]) / 2])


@pytest.mark.parametrize("sense", [1, -1])
def test_rollers_on_both_discs_of_a_pair(sense: int) -> None:
    """At rest on round discs both turn against the shaft, by the ratio of the radii."""
    still = Disc(SwingingRoller(39e-3, 20e-3, 85e-3, 90e-3), lambda theta: 0.0 * theta, sense)
    second = conjugate(still, base=50e-3, roller=16e-3).second
    spins = [rolling(side, 8.0, np.zeros(1)).spin[0] for side in (ContactPlace(still), second)]
    assert spins == pytest.approx([-sense * 8.0 * 39 / 20, -sense * 8.0 * 50 / 16])


def test_a_yoke_of_constant_breadth() -> None:
    """Odd harmonics keep the breadth; a second one of 1 mm makes 4 mm of play."""

    def odd(theta: Jet) -> Jet:
        return 10e-3 * (1 - theta.cos()) + 0.5e-3 * (3 * theta).cos()

    for follower in (TranslatingFlat(40e-3), TranslatingRoller(40e-3, 10e-3), TranslatingKnife(40e-3)):
        found = yoke(Disc(follower, odd))
        assert found.play < 1e-15
        assert found.widest.value == pytest.approx(2 * (follower.start + 10e-3), rel=1e-14)
    found = yoke(Disc(TranslatingFlat(40e-3), harmonic(10e-3, 1e-3)))
    assert found.play == pytest.approx(4e-3, rel=1e-12)
    assert found.widest.value == pytest.approx(104e-3, rel=1e-12)
    assert found.narrowest.theta % math.pi == pytest.approx(0.0, abs=1e-6)
    profile = found.disc.look(FINE).offset(0.0)
    assert np.ptp(profile[0]) == pytest.approx(104e-3, abs=1e-8)  # the disc itself across its widest place
    with pytest.raises(NoContact, match=r"cam\.yoke"):
        yoke(HEAT)


def test_forces_in_a_yoke() -> None:
    """An eccentric disc between two faces: m s'' w^2, on the one or the other."""
    disc = Disc(TranslatingFlat(30e-3), harmonic(10e-3))
    found = forces(disc, FollowerLoads(2.0), 10.0, second=yoke(disc).second)
    assert found.contact - found.contact_second == pytest.approx(2.0 * np.cos(found.theta), abs=1e-14)
    assert found.reversals == pytest.approx([math.pi / 2, 3 * math.pi / 2])


def test_a_second_disc_that_can_not_be() -> None:
    with pytest.raises(NoContact, match=r"cam\.undercut"):
        conjugate(Disc(TranslatingFlat(40e-3), harmonic(10e-3, 3e-3)), base=1e-3)
    still = Disc(TranslatingRoller(40e-3, 10e-3), lambda theta: 0.0 * theta)
    with pytest.raises(NoContact, match=r"cam\.second-base"):
        conjugate(still, between=59e-3)  # 9 mm off the shaft
