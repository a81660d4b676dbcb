"""The contacts of cams from a run's reports: where each acts, and its normal, in plain NumPy."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.cam_contact.second import largest
from linkwright.elements.joint import Miss, Restated
from linkwright.elements.touch import ReportedTouch
from linkwright.expressions import units as u
from linkwright.expressions.fields import LineOn

if TYPE_CHECKING:
    from linkwright.elements.cam_contact.follower import CamFollower
    from linkwright.elements.follower import FollowerReports
    from linkwright.elements.joint import Applied

Array = NDArray[np.float64]


def applied(r: FollowerReports, drive: CamFollower, name: str) -> list[Applied]:
    """What the reported force does to the follower and the cam; a negative one is that of the second contact."""
    size = r.rows[f"{name}.force"]
    place, normal = contact(r, drive)
    if drive.has_second_contact:
        there, other = contact(r, drive, second=True)
        place, normal = np.where(size < 0, there, place), np.where(size < 0, -other, normal)
    force = size * normal
    return [(drive.link, force, place, 0.0), (drive.cam.cam, -force, place, 0.0)]


def touch(r: FollowerReports, drive: CamFollower, name: str) -> ReportedTouch:
    """Where the follower or its roller touches the cam."""
    place, normal = contact(r, drive)
    roller = 0.0 if drive.cam.roller is None else r.number(drive.cam.roller, u.LENGTH)
    return ReportedTouch(place - roller * normal, normal, r.rows[f"{name}.force"])


def contact(r: FollowerReports, drive: CamFollower, second: bool = False) -> tuple[Array, Array]:
    """A place on the common normal, and this as a unit vector from the cam to the follower: (2, times) each; of the
    ``second`` contact of a conjugate pair or a yoke.

    It is square to the way of the follower's point past the cam; a face has its own.
    """
    cam = drive.cam
    number = r.number
    turn = r.rows[f"{drive.motor}.angle"] * drive.motor_sign  # of the cam on its carrier
    forward_sign = _forward(r, drive)
    lift, asked = r.motions[cam.law], forward_sign * turn + number(cam.phase, u.ANGLE)
    slope = forward_sign * lift.at(asked, 1)  # by the cam's angle
    shaft = r.point_position(drive.on, r.geometry.point(drive.on, drive.shaft[1]))
    at = r.point_position(drive.link, r.geometry.point(drive.link, cam.touches))
    face = _direction(r, drive, cam.face) if cam.face is not None else None
    if second:
        at, face = _second(r, drive, shaft, at, face, lift.at(asked))
    if drive.pivot is not None:
        pivot = r.point_position(drive.on, r.geometry.point(drive.on, drive.pivot[1]))
        moved = -drive.side * slope * _quarter(at - pivot)
    else:
        assert drive.joint is not None
        pivot, moved = at, drive.side * slope * r.line(drive.joint, drive.on)[1]
    if face is None:
        past = moved - _quarter(at - shaft)
        normal = _quarter(past)
        return at, normal / np.hypot(*normal)
    normal = -drive.side * _quarter(face) if drive.pivot else drive.side * r.line(str(drive.joint), drive.on)[1]
    normal = -normal if second else normal
    # Where the face moves along itself past the cam: its points at `at + x face`, in both its turning and the cam's.
    spin = -drive.side * slope - 1.0 if drive.pivot is not None else -np.ones(r.count)
    past = moved - _quarter(at - shaft)
    along = -(past * normal).sum(axis=0) / (spin * (_quarter(face) * normal).sum(axis=0))
    return at + along * face, normal


def restated(r: FollowerReports, drive: CamFollower) -> dict[str, Restated]:
    """The pressure angles, each between the common normal and the way of the follower's point there."""
    pivot = None
    if drive.pivot is not None:
        pivot = r.point_position(drive.on, r.geometry.point(drive.on, drive.pivot[1]))
    forward, found = _forward(r, drive), dict[str, Restated]()
    for attribute, side in zip(drive.extra, (drive.side, -drive.side), strict=False):
        place, normal = contact(r, drive, second=attribute != "pressure")
        way = r.line(str(drive.joint), drive.on)[1] if pivot is None else -_quarter(place - pivot)
        turned = np.angle((way[0] + 1j * way[1]) / (normal[0] + 1j * normal[1]) * side)
        found[attribute] = Restated(-forward * turned, 2 * np.pi)
    return found


def misses(r: FollowerReports, drive: CamFollower) -> list[Miss]:
    """By what the follower lies beside where the cam's law has it: on the base circle, and from there the lift on."""
    cam, side = drive.cam, drive.side
    turn = r.rows[f"{drive.motor}.angle"] * drive.motor_sign
    lift = r.motions[cam.law].at(_forward(r, drive) * turn + r.number(cam.phase, u.ANGLE))
    shaft = r.point_position(drive.on, r.geometry.point(drive.on, drive.shaft[1]))
    at = r.point_position(drive.link, r.geometry.point(drive.link, cam.touches))
    base = r.number(cam.base, u.LENGTH)
    pitch = base if cam.roller is None else base + r.number(cam.roller, u.LENGTH)
    if drive.pivot is None:
        way = side * r.line(str(drive.joint), drive.on)[1]
        height, aside = ((at - shaft) * way).sum(axis=0), ((at - shaft) * _quarter(way)).sum(axis=0)
        start = base if cam.face is not None else np.sqrt(pitch**2 - aside**2)
        return [Miss(height - start - lift, length=True)]
    pivot = r.point_position(drive.on, r.geometry.point(drive.on, drive.pivot[1]))
    to_shaft, arm = shaft - pivot, at - pivot
    away, reach = np.hypot(*to_shaft), np.hypot(*arm)
    beam = arm / reach
    if cam.face is not None:
        beam = _direction(r, drive, cam.face)
        start = np.arcsin((base + side * (_quarter(beam) * arm).sum(axis=0)) / away)
    else:
        start = np.arccos((away**2 + reach**2 - pitch**2) / (2 * away * reach))
    angle = start + lift
    wanted = (np.cos(angle) * to_shaft - side * np.sin(angle) * _quarter(to_shaft)) / away
    return [Miss(np.hypot(*(beam - wanted)), length=False)]


def _second(
    r: FollowerReports, drive: CamFollower, shaft: Array, at: Array, face: Array | None, lift: Array
) -> tuple[Array, Array | None]:
    """The second contact's point, and its face's direction, from those of the first and the lift."""
    cam, stated, length = drive.cam, drive.cam.second, r.number
    if stated is not None and stated.touches is not None:
        own = r.point_position(drive.link, r.geometry.point(drive.link, stated.touches))
        return own, _direction(r, drive, stated.face) if stated.face is not None else None
    left = largest(drive, r.motions[cam.law]) - lift  # by which the second contact has risen
    base = length(stated.base if stated is not None and stated.base is not None else cam.base, u.LENGTH)
    roller = stated.roller if stated is not None and stated.roller is not None else cam.roller
    pitch = base + (length(roller, u.LENGTH) if roller is not None else 0.0)
    if drive.joint is not None:
        way = drive.side * r.line(drive.joint, drive.on)[1]
        right = -_quarter(way)
        aside = ((at - shaft) * right).sum(axis=0)
        height = base if face is not None else np.sqrt(pitch**2 - aside**2)
        return shaft + (-1 if cam.closed == "yoke" else 1) * aside * right - (height + left) * way, face
    assert drive.pivot is not None
    pivot = r.point_position(drive.on, r.geometry.point(drive.on, drive.pivot[1]))
    away, arm = np.hypot(*(shaft - pivot)), np.hypot(*(at - pivot))
    if face is None:
        angle = left + np.arccos((away**2 + arm**2 - pitch**2) / (2 * away * arm))
    else:
        arm = -drive.side * (_quarter(face) * (at - pivot)).sum(axis=0)
        angle = left + np.arcsin((base - arm) / away)
    to_shaft = (shaft - pivot) / away
    beam = np.cos(angle) * to_shaft + drive.side * np.sin(angle) * _quarter(to_shaft)
    return (pivot + arm * beam, None) if face is None else (pivot + drive.side * arm * _quarter(beam), beam)


def _direction(r: FollowerReports, drive: CamFollower, face: LineOn) -> Array:
    """The direction of a follower's face."""
    heading = r.number(face.angle, u.ANGLE)
    return r.rotated(drive.link, (np.cos(heading), np.sin(heading)))


def _forward(r: FollowerReports, drive: CamFollower) -> float:
    """The sense (1 or -1) in which the cam turns on its carrier as it runs through its law."""
    if drive.cam.sense is not None:
        return 1.0 if drive.cam.sense == "counter-clockwise" else -1.0
    speed = r.geometry.mechanism.drives[drive.motor].speed
    backward = (drive.motor_sign < 0) != (speed is not None and r.number(speed, u.OMEGA) < 0)
    return -1.0 if backward else 1.0


def _quarter(vector: Array) -> Array:
    """Turned by +90 degrees."""
    return np.array([-vector[1], vector[0]])
