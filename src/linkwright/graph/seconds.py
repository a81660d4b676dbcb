"""The second contact of a cam closed by form: on a second disc, or on the same one within a yoke.

It lies on the other side of the line of centres, or beyond the shaft, and holds the follower against the first. Where
the file doesn't give its place, this follows from what keeps the follower without play: the angle between both arms or
faces, or the distance along the slide, is start + second start + largest lift with a second disc; a yoke takes the two
starts and the largest sum of two lifts that are half a turn apart (:mod:`linkwright.cam.closing` has the discs).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import atan2, hypot, sin

import numpy as np

from linkwright.graph.cams import Seat, Touch, seat, touch
from linkwright.graph.geometry import Geometry, unit_vector
from linkwright.model import units as u
from linkwright.model.cams import Following
from linkwright.notation import Pair, Scalar
from linkwright.notation.angles import wrapped


def second(geometry: Geometry, drive: Following, total: Scalar) -> Touch:
    """What touches on the other side; ``total`` (rad or m) is the largest lift, or of a yoke the largest sum of two
    lifts half a turn apart."""
    first, stated = touch(geometry, drive), drive.cam.second
    if stated is not None and stated.touches is not None:
        heading = None if stated.face is None else unit_vector(geometry.number(stated.face.angle, u.ANGLE))
        return Touch(geometry.point(drive.link, stated.touches), heading, -1)
    here = seat(geometry, drive)
    between = here.start + other_seat(geometry, drive).start + total
    if here.turns:
        assert drive.pivot is not None
        own = geometry.point(drive.link, drive.pivot[0])
        turn = unit_vector(-here.sign * between)
        if first.face is None:
            return Touch(_plus(own, first.at.minus(own).turned(turn)), None, -1)
        face = first.face.turned(turn)
        made = Touch(own, face, -1)
        return replace(made, at=_plus(own, made.outward(drive, face), here.reach))
    way, right = _way(geometry, drive)
    at = _plus(first.at, way, -between)
    if drive.cam.closed == "yoke":  # its rollers lie opposite each other about the shaft
        at = _plus(at, right, -2 * here.aside)
    return Touch(at, first.face, -1)


def other_seat(geometry: Geometry, drive: Following) -> Seat:
    """The numbers of the second contact where its place isn't stated."""
    here, stated = seat(geometry, drive), drive.cam.second
    if stated is None:
        return here
    lengths = {key: getattr(stated, key) for key in ("base", "roller")}
    return replace(here, **{k: geometry.number(v, u.LENGTH) for k, v in lengths.items() if v is not None})


@dataclass(frozen=True)
class Rest:
    """Where the second contact stands at the first one's largest lift, when it is on its own base circle; numbers.

    ``start`` is the angle (rad, -pi .. pi) of arm or face with the line of centres, or the height (m) beyond the shaft,
    positive on the side away from the first; ``reach`` and ``aside`` are as in :class:`Seat`; ``base`` is the radius
    (m) of the disc's base circle.
    """

    start: float
    base: float
    roller: float
    reach: float
    aside: float


def rest(geometry: Geometry, drive: Following, total: float) -> Rest:
    """Where the second contact stands at the largest lift ``total`` (rad or m), at plain parameters."""
    here, what = seat(geometry, drive), second(geometry, drive, total)
    roller, up = float(other_seat(geometry, drive).roller), float(here.start + total)
    if not here.turns:
        way, right = _way(geometry, drive)
        off = what.at.minus(touch(geometry, drive).at)
        height, aside = -float(up + off.dot(way)), float(here.aside + off.dot(right))
        return Rest(height, height if here.faced else hypot(height, aside) - roller, roller, 0.0, aside)
    assert drive.pivot is not None
    arm = what.at.minus(geometry.point(drive.link, drive.pivot[0]))
    along = arm if what.face is None else what.face
    value = float(here.offset + here.sign * up)
    start = float(wrapped(np.array(-here.sign * (value + atan2(along.y, along.x) - float(here.home)))))
    away = float(here.distance)
    if what.face is not None:
        reach = float(what.outward(drive, what.face).dot(arm))
        return Rest(start, away * sin(start) + reach, roller, reach, 0.0)
    reach = hypot(arm.x, arm.y)
    beam = unit_vector(start)
    return Rest(start, hypot(away - reach * beam.x, reach * beam.y) - roller, roller, reach, 0.0)


def _way(geometry: Geometry, drive: Following) -> tuple[Pair, Pair]:
    """The way in which a sliding follower rises, and its right, in the follower's axes."""
    assert drive.joint is not None
    heading = geometry.line(drive.joint, drive.link)[1]
    way = Pair(drive.side * heading.x, drive.side * heading.y)
    return way, Pair(way.y, -way.x)


def _plus(at: Pair, by: Pair, times: Scalar = 1.0) -> Pair:
    return Pair(at.x + times * by.x, at.y + times * by.y)
