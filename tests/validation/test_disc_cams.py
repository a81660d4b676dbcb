"""Disc cams of textbooks whose profile or acceleration is known: figures as printed there, and their closed forms.

Sources: the tangent cam with roller (187.6 m/s2) and the simple harmonic flat-faced cam are stock examples of courses
on the theory of machines; the parabolic flat-faced cam, the involute and the eccentric disc follow from the definition.
Tolerances: the digits printed; the closed forms to round-off.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from linkwright.cam.contact import on_face
from linkwright.cam.disc import Disc
from linkwright.cam.extremes import extremes, pressure
from linkwright.cam.followers import SwingingFlat, TranslatingFlat, TranslatingKnife, TranslatingRoller

THETA = np.linspace(0.0, 2 * np.pi, 720, endpoint=False)


def test_a_tangent_cam() -> None:
    """Least radius 30 mm, roller 17.5 mm, 600 rpm: 187.6 m/s2 at the start of the lift; the flank is straight."""
    reach, omega = 47.5e-3, 2 * math.pi * 10

    def lift(theta: Any) -> Any:
        return reach * (1.0 / theta.cos() - 1.0)

    disc = Disc(TranslatingRoller(30e-3, 17.5e-3), lift)
    look = disc.look(np.linspace(0.0, 0.5, 50))
    assert look.lift.d[2][0] * omega**2 == pytest.approx(187.52, abs=5e-3)
    assert np.abs(look.curvature.d[0]).max() < 1e-10
    flank = look.offset(-17.5e-3)
    assert np.abs(flank[1] - 30e-3).max() < 1e-16


def test_a_flat_face_in_simple_harmonic_motion() -> None:
    """50 mm over a turn, least radius 25 mm: a circle of 50 mm, 25 mm off centre; the face needs 50 mm."""
    disc = Disc(TranslatingFlat(25.0), lambda theta: 25.0 * (1.0 - theta.cos()))
    look = disc.look(THETA)
    assert np.abs(look.radius() - 50.0).max() < 1e-12
    least, most = extremes(disc, lambda look: look.lift.rate())
    assert most.value - least.value == pytest.approx(50.0, abs=1e-12)
    near, far = extremes(disc, on_face(disc))
    assert (near.value, far.value) == pytest.approx((-25.0, 25.0), abs=1e-12)


def test_a_swinging_flat_face() -> None:
    """The contact lies a cos(psi) / (1 + sigma delta') along the face (cam reference, closed forms)."""
    for sense in (1, -1):
        follower = SwingingFlat(24e-3, 60e-3, -4e-3)
        disc = Disc(follower, lambda theta: 0.05 * (1.0 - theta.cos()), sense)
        psi, rate = follower.start + 0.05 * (1 - np.cos(THETA)), 0.05 * np.sin(THETA)
        place = on_face(disc)(disc.look(THETA)).d[0]
        assert np.abs(place - 60e-3 * np.cos(psi) / (1 + sense * rate)).max() < 1e-15


def test_a_flat_face_in_parabolic_motion() -> None:
    """10 mm in 60 deg by s = k theta^2: at 45 deg 5.625 mm, the contact 14.3239 mm from the line of the slide."""
    rate = 10.0 / math.radians(60) ** 2
    look = Disc(TranslatingFlat(30.0), lambda theta: rate * theta * theta).look(np.array([math.radians(45)]))
    assert look.lift.d[0][0] == pytest.approx(5.625, abs=1e-12)
    assert abs(look.centre[0].d[0][0]) == pytest.approx(14.3239, abs=5e-5)


def test_an_involute() -> None:
    """Offset and base circle of 20 mm, 10 rad/s: 0.2 m/s, without any pressure angle."""
    disc = Disc(TranslatingKnife(20.1e-3, offset=20e-3), lambda theta: 20e-3 * theta)
    look = disc.look(np.linspace(0.0, 1.0, 11))
    assert np.abs(np.broadcast_to(look.lift.d[1], 11) * 10.0 - 0.2).max() < 1e-15
    assert np.abs(look.pressure.d[0]).max() < 1e-14


def test_an_eccentric_disc() -> None:
    """40 mm disc, 10 mm off, roller 10 mm: pitch radius 50 mm, pressure angle up to asin(10 / 50) = 11.5370 deg."""

    def lift(theta: Any) -> Any:
        return -10.0 * theta.cos() + (2500.0 - 100.0 * theta.sin() ** 2).sqrt() - 40.0

    disc = Disc(TranslatingRoller(30.0, 10.0), lift)
    assert np.abs(disc.look(THETA).radius() - 50.0).max() < 1e-11
    assert extremes(disc, pressure)[1].value == pytest.approx(math.asin(0.2), abs=1e-12)
