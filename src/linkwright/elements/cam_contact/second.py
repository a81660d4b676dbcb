"""The second contact of a cam closed by form: on a second disc, or on the same one within a yoke.

It lies across the line of centres, or beyond the shaft, and holds the follower against the first; so it is a contact of
its own on the other side. Where the file doesn't give its place, this follows from what keeps the follower without
play: the angle between both arms or faces, or the distance along the slide, is start + second start + largest lift with
a second disc, and with a yoke both starts + the largest sum of two lifts half a turn apart
(:mod:`linkwright.cam.form_closure` has the discs).
"""

from __future__ import annotations

from dataclasses import replace
from math import atan2, cos, hypot, pi, sin
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.cam_contact.contact import CamPair, ContactFeature, outward, seat, touch
from linkwright.expressions import units as u
from linkwright.laws import Motion
from linkwright.notation import Scalar
from linkwright.notation.planar import unit_vector

if TYPE_CHECKING:
    from linkwright.elements.cam_contact.follower import CamFollower
    from linkwright.elements.follower import FollowerGeometry

SAMPLES = 3600
"""Places of half a turn at which sums of two lifts are looked at, besides the law's joins."""


def other_side(drive: CamFollower) -> CamFollower:
    """The second contact as if it were the first one, on the other side; its place is right where it is stated."""
    cam, stated = drive.cam, drive.cam.second
    change = {key: value for key, value in stated or () if value is not None}
    if cam.knife is not None and "at" in change:
        change["knife"] = change.pop("at")
    return replace(drive, entry=cam.model_copy(update=change), side=-drive.side)


def second(geometry: FollowerGeometry, drive: CamFollower, total: Scalar) -> ContactFeature:
    """What touches on the other side; ``total`` (rad or m) is the largest lift, or of a yoke the largest sum of two
    lifts half a turn apart."""
    other = other_side(drive)
    if not drive.derived:
        return touch(geometry, other)
    first, here = touch(geometry, drive), seat(geometry, drive)
    between = here.start + second_seat(geometry, drive).start + total
    if here.turns:
        assert drive.pivot is not None
        own = geometry.point(drive.link, drive.pivot[0])
        turn = unit_vector(-here.sign * between)
        if first.face is None:
            return ContactFeature(own.plus(first.at.minus(own).rotated(turn)), None)
        face = first.face.rotated(turn)
        return ContactFeature(own.plus(outward(other, face), here.reach), face)
    assert drive.joint is not None
    heading = geometry.line(drive.joint, drive.link)[1]
    at = first.at.plus(heading, -here.sign * between)
    if drive.cam.closed == "yoke":  # its rollers lie opposite each other about the shaft
        at = at.plus(heading.perp, 2 * here.sign * here.aside)
    return ContactFeature(at, first.face)


def second_seat(geometry: FollowerGeometry, drive: CamFollower) -> CamPair:
    """The numbers of the second contact; ``base`` is that of its disc only where its place isn't stated."""
    if not drive.derived:
        return seat(geometry, other_side(drive))
    cam = other_side(drive).cam
    roller = geometry.number(cam.roller, u.LENGTH) if cam.roller is not None else 0.0
    return replace(seat(geometry, drive), base=geometry.number(cam.base, u.LENGTH), roller=roller)


def base_circle_position(geometry: FollowerGeometry, drive: CamFollower, total: float) -> tuple[float, float]:
    """Where the second contact stands at the largest lift ``total`` (rad or m), as it is on its own base circle, by
    plain numbers: the angle (rad, -pi .. pi) of arm or face with the line of centres or the height (m) beyond the
    shaft, and the radius (m) of the base circle."""
    here, there = seat(geometry, drive), second_seat(geometry, drive)
    if drive.derived:
        return float(there.start), float(there.base)
    start = float(there.sign * (here.offset + here.sign * (here.start + total) - there.offset))
    if not there.turns:
        return start, start if there.faced else hypot(start, there.aside) - float(there.roller)
    start = atan2(sin(start), cos(start))
    away, reach = float(there.distance), float(there.reach)
    if there.faced:
        return start, away * sin(start) + reach
    return start, hypot(away - reach * cos(start), reach * sin(start)) - float(there.roller)


def contact_range(drive: CamFollower) -> tuple[float, float]:
    """Between what a second contact's angle or height may lie all over the lift (rad or m)."""
    if drive.pivot is None:
        return 0.0, float("inf")
    return (-pi / 2, pi / 2) if drive.cam.face is not None else (0.0, pi)


def largest(drive: CamFollower, motion: Motion) -> float:
    """The largest lift (rad or m), or of a yoke the largest sum of two lifts half a turn apart."""
    return float(sums(motion).max()) if drive.cam.closed == "yoke" else motion.extremes(0)[1].value


def sums(motion: Motion) -> NDArray[np.float64]:
    """Sums of two lifts (m) half a turn apart, all over a turn: one number where a yoke fits without play."""
    places = np.concatenate([np.linspace(0.0, pi, SAMPLES), motion.breaks])
    return np.asarray(motion.at(places) + motion.at(places + pi))
