"""Cam pairs: where a follower stands at a lift, and where and how it touches the cam.

A follower's value (angle or travel on the link that carries it) is ``offset + sign * (start + lift)``. On the base
circle a swinging follower makes the angle ``start`` with the line from its pivot to the cam's shaft: by the law of
cosines with a roller or edge, from the face's distance with a flat face. A sliding one stands ``start`` over the shaft.

The pitch curve moves past the roller's centre C along dC/dq - J (C - O), with q the cam's angle on the carrier, O its
shaft and J a quarter turn; the common normal is square to that: C - O + J dC/dq, outward. A flat face carries its
normal with it, and touches where its distance H from O is the cam's support function: at O + H n + dH/dphi J n, phi
being the normal's direction in the cam. (Rothbart, Cam Design Handbook, 2004, ch. 7.) All of it works on numbers,
arrays, duals and symbols alike.
"""

from __future__ import annotations

from math import pi
from typing import TYPE_CHECKING

from linkwright.data_classes import dataclass
from linkwright.elements.follower import FollowerGeometry, UnitEffort
from linkwright.expressions import units as u
from linkwright.expressions.language import Binary, Call, Name, Node, Number
from linkwright.notation import Pair, Scalar, Wrench
from linkwright.notation.jets import call
from linkwright.notation.planar import angle_near, unit_vector

if TYPE_CHECKING:
    from linkwright.elements.cam_contact.follower import CamFollower
    from linkwright.elements.follower import PoseQuery


def sense(geometry: FollowerGeometry, drive: CamFollower) -> int:
    """The sense of turn (+1: counter-clockwise) on the carrier in which the cam runs through its law."""
    if drive.cam.sense is not None:
        return 1 if drive.cam.sense == "counter-clockwise" else -1
    speed = geometry.mechanism.drives[drive.motor].speed
    forward = speed is None or geometry.nominal.number(speed, u.OMEGA) >= 0
    return drive.motor_sign if forward else -drive.motor_sign


def argument(geometry: FollowerGeometry, drive: CamFollower, motor: Node | None = None) -> Node:
    """The angle at which the cam's law is asked (rad), as a tree in SI of the motor's angle or of what this is."""
    factor = Number(float(sense(geometry, drive) * drive.motor_sign))
    cam_angle = Binary("*", factor, motor or Name(f"{drive.motor}.angle"))
    return Binary("+", cam_angle, geometry.bind(drive.cam.phase, u.ANGLE))


def tree(geometry: FollowerGeometry, drive: CamFollower, motor: Node) -> Node:
    """A follower's value at the nominal lengths (rad or m), as a tree in SI of what its motor's angle is."""
    plain = geometry.nominal
    here = seat(plain, drive)
    start = here.offset + here.sign * here.start - base_circle_turns(plain, drive)
    lift = Call(drive.cam.law, (argument(geometry, drive, motor),))
    return Binary("+", Number(float(start)), Binary("*", Number(float(here.sign)), lift))


@dataclass(frozen=True)
class CamPair:
    """The numbers of a cam pair (SI) at some parameters.

    ``shaft`` and ``pivot`` are points of the carrier; of a sliding follower ``pivot`` is the slide's point there and
    ``way`` the direction in which it rises. ``reach`` is the distance from pivot to contact, of a face its distance
    from the pivot on the side away from the cam.
    """

    shaft: Pair
    pivot: Pair
    way: Pair
    base: Scalar
    roller: Scalar
    reach: Scalar
    aside: Scalar  # of a sliding follower: how far right of the shaft it slides, looking the way that it rises
    shaft_direction: Scalar  # of a swinging follower: the direction from its pivot to the shaft
    offset: Scalar
    sign: int
    faced: bool
    turns: bool

    @property
    def distance(self) -> Scalar:
        """From the shaft to the pivot."""
        away = self.pivot.minus(self.shaft)
        return away.length

    @property
    def level(self) -> Scalar:
        """What the start is the arc cosine, arc sine or root of; it has none where this is out of range."""
        pitch = self.base + self.roller
        if not self.turns:
            return self.base if self.faced else pitch * pitch - self.aside * self.aside
        if self.faced:
            return (self.base - self.reach) / self.distance
        away, arm = self.distance, self.reach
        return (away * away + arm * arm - pitch * pitch) / (2 * (away * arm))

    @property
    def start(self) -> Scalar:
        """The angle between arm or face and the line from pivot to shaft, or the height, on the base circle."""
        if self.turns:
            return call("arcsin" if self.faced else "arccos", self.level)
        return self.level if self.faced else call("sqrt", self.level)


def seat(geometry: FollowerGeometry, drive: CamFollower) -> CamPair:
    """The numbers of a cam pair."""
    cam, on = drive.cam, drive.on
    shaft = geometry.pinned(on, drive.shaft[1])
    base = geometry.number(cam.base, u.LENGTH)
    roller = geometry.number(cam.roller, u.LENGTH) if cam.roller is not None else 0.0
    touching = geometry.point(drive.link, cam.touches)
    plain = geometry.nominal
    faced = cam.face is not None
    if drive.pivot is not None:
        own, pivot = geometry.pinned(drive.link, drive.pivot[0]), geometry.pinned(on, drive.pivot[1])
        arm, to_shaft = touching.minus(own), shaft.minus(pivot)
        far = plain.point(on, drive.shaft[1]).minus(plain.point(on, drive.pivot[1]))
        if cam.face is not None:
            heading = geometry.number(cam.face.angle, u.ANGLE)
            reach, turn = -drive.side * arm.dot(unit_vector(heading).perp), heading
        else:
            about = plain.point(drive.link, cam.touches).minus(plain.point(drive.link, drive.pivot[0]))
            reach, turn = arm.length, angle_near(arm, about)
        back, none = angle_near(to_shaft, far), Pair(0.0, 0.0)
        return CamPair(shaft, pivot, none, base, roller, reach, 0.0, back, back - turn, -drive.side, faced, True)
    assert drive.joint is not None
    (at, heading_on), (foot, heading_of) = (geometry.seat(drive.joint, link)[:2] for link in (on, drive.link))
    ahead, own = at.minus(shaft), touching.minus(foot)
    offset = -(ahead.dot(heading_on) + own.dot(heading_of))
    aside = -drive.side * (ahead.dot(heading_on.perp) + own.dot(heading_of.perp))
    way = Pair(drive.side * heading_on.x, drive.side * heading_on.y)
    return CamPair(shaft, at, way, base, roller, 0.0, aside, 0.0, offset, drive.side, faced, False)


def slant(geometry: FollowerGeometry, drive: CamFollower) -> Scalar:
    """The angle (rad, within a quarter turn) by which a sliding follower's face isn't square to its slide."""
    assert drive.cam.face is not None
    assert drive.joint is not None
    turn = geometry.number(drive.cam.face.angle, u.ANGLE) - geometry.seat(drive.joint, drive.link)[2]
    return call("arctan", call("cos", turn) / call("sin", turn))


@dataclass(frozen=True)
class ContactFeature:
    """What of a follower touches the cam, in its own axes: a roller's centre, an edge or a point of a face (m), and the
    face's direction."""

    at: Pair
    face: Pair | None


def touch(geometry: FollowerGeometry, drive: CamFollower) -> ContactFeature:
    """What of a follower touches."""
    face = drive.cam.face
    heading = unit_vector(geometry.number(face.angle, u.ANGLE)) if face is not None else None
    return ContactFeature(geometry.point(drive.link, drive.cam.touches), heading)


def outward(drive: CamFollower, face: Pair) -> Pair:
    """The normal of a pinned follower's face in some direction, away from the cam."""
    return Pair(-drive.side * face.perp.x, -drive.side * face.perp.y)


def contact(
    poses: PoseQuery, drive: CamFollower, rate: Scalar, what: ContactFeature | None = None, pressure: str = "pressure"
) -> UnitEffort:
    """What 1 N along the common normal, from the cam to the follower, does: from the poses and the derivative of the
    follower's value by the cam's angle (m or 1); ``what`` of it touches, unless that of the drive.

    Its signal is the ``pressure`` angle (rad, signed) from the normal to the follower's way as the lift grows; its
    reach what the force does along the lift (N, or N m of a swinging follower).
    """
    geometry, bodies = poses.geometry, poses.bodies
    what = what or touch(geometry, drive)
    here, on = seat(geometry, drive), bodies[drive.on]
    forward = sense(geometry, drive)
    shaft = on.point(here.shaft).now
    way = on.direction(here.way).now if not here.turns else Pair(0.0, 0.0)
    pivot = on.point(here.pivot).now

    def point_displacement(point: Pair) -> Pair:
        """What a unit of the follower's value moves its point by."""
        return point.minus(pivot).perp if here.turns else Pair(here.sign * way.x, here.sign * way.y)

    at = bodies[drive.link].point(what.at).now
    if what.face is not None:
        normal = outward(drive, bodies[drive.link].direction(what.face).now) if here.turns else way
        height = at.minus(shaft).dot(normal)
        facing = pivot.minus(shaft).dot(normal.perp)
        along = facing * rate / (rate - 1.0) if here.turns else -(here.sign * rate)
        at = Pair(
            shaft.x + height * normal.x - along * normal.y,
            shaft.y + height * normal.y + along * normal.x,
        )
    else:
        moving, arm = point_displacement(at).perp, at.minus(shaft)
        across = Pair(arm.x + rate * moving.x, arm.y + rate * moving.y)
        size = across.length
        normal = Pair(across.x / size, across.y / size)
    rising = point_displacement(at)
    rising = Pair(here.sign * rising.x, here.sign * rising.y)
    reach = normal.dot(rising)
    angle, push = call("arctan2", -forward * normal.cross(rising), reach), Wrench(normal, 0.0, at)
    return UnitEffort({drive.link: push, drive.cam.cam: push.opposite}, reach, {pressure: angle})


def base_circle_turns(geometry: FollowerGeometry, drive: CamFollower) -> float:
    """Whole turns (rad) by which a swinging follower's value on the base circle lies outside of -pi .. pi."""
    if drive.pivot is None:
        return 0.0
    here = seat(geometry, drive)
    value = float(here.offset + here.sign * here.start)
    return 2 * pi * round(value / (2 * pi)) if abs(value) < 1e9 else 0.0
