"""Plane vectors, rigid bodies and wrenches over jets (right-handed x-y plane, angles counter-clockwise)."""

from __future__ import annotations

import math
from typing import NamedTuple

from linkwright.data_classes import dataclass
from linkwright.notation.jets import Jet, Scalar, call, is_zero, leibniz


class Pair(NamedTuple):
    """Two plain numbers (no derivatives): coordinates in a link's own frame, or (cos, sin) there."""

    x: Scalar
    y: Scalar

    @property
    def length(self) -> Scalar:
        """The length of this vector."""
        return call("sqrt", self.dot(self))

    def plus(self, other: Pair, times: Scalar = 1.0) -> Pair:
        """The place so many ``times`` another vector away."""
        return Pair(self.x + times * other.x, self.y + times * other.y)

    def minus(self, other: Pair) -> Pair:
        """The coordinates relative to another point of the same link."""
        return Pair(_minus(self.x, other.x), _minus(self.y, other.y))

    def dot(self, other: Pair) -> Scalar:
        return self.x * other.x + self.y * other.y

    def cross(self, other: Pair) -> Scalar:
        return self.x * other.y - self.y * other.x

    def rotated(self, by: Pair) -> Pair:
        """This vector turned by the angle of the unit vector ``by``."""
        return Pair(by.x * self.x - by.y * self.y, by.y * self.x + by.x * self.y)

    def rotated_back(self, by: Pair) -> Pair:
        """This vector turned by minus the angle of the unit vector ``by``."""
        return Pair(by.x * self.x + by.y * self.y, by.x * self.y - by.y * self.x)

    @property
    def perp(self) -> Pair:
        """This vector turned by +90 degrees."""
        return Pair(-self.y, self.x)


def angle_near(vector: Pair, near: Pair) -> Scalar:
    """The angle (rad) of a vector, without a jump near that of another one, of plain numbers, about which it varies."""
    return math.atan2(near.y, near.x) + call("arctan2", near.cross(vector), near.dot(vector))


class Vec(NamedTuple):
    """A plane vector whose components are jets."""

    x: Jet
    y: Jet

    @classmethod
    def constant(cls, pair: Pair, order: int) -> Vec:
        return cls(Jet.constant(pair.x, order), Jet.constant(pair.y, order))

    def plus(self, other: Vec) -> Vec:
        return Vec(self.x + other.x, self.y + other.y)

    def minus(self, other: Vec) -> Vec:
        return Vec(self.x - other.x, self.y - other.y)

    def times(self, factor: Jet | Scalar) -> Vec:
        return Vec(self.x * factor, self.y * factor)

    def dot(self, other: Vec) -> Jet:
        return self.x * other.x + self.y * other.y

    def cross(self, other: Vec) -> Jet:
        return self.x * other.y - self.y * other.x

    @property
    def perp(self) -> Vec:
        """This vector turned by +90 degrees."""
        return Vec(-self.y, self.x)

    def carry(self, local: Pair) -> Vec:
        """With this unit vector as the x axis of a frame, the vector of coordinates ``local`` in it."""
        return Vec(self.x * local.x - self.y * local.y, self.y * local.x + self.x * local.y)

    @property
    def now(self) -> Pair:
        """The value alone, without derivatives."""
        return Pair(self.x.d[0], self.y.d[0])


@dataclass(frozen=True)
class Body:
    """The motion of a rigid link.

    ``anchor`` is the position (m) of the link's point ``local`` (coordinates in the link's frame); ``axis``
    the unit vector of the link's x axis; ``turn`` the angle's derivatives (omega, alpha, jerk, ...) in rad/s,
    rad/s^2, ...; ``angle`` the continuous angle (rad) where it is known exactly (a driven link, a link that
    only slides on one), else ``None`` and the angle is that of ``axis``.
    """

    anchor: Vec
    local: Pair
    axis: Vec
    turn: Jet
    angle: Scalar | None = None

    @classmethod
    def fixed(cls, order: int) -> Body:
        """The frame: at rest at the origin."""
        at_rest = Vec.constant(Pair(0.0, 0.0), order)
        axis = Vec.constant(Pair(1.0, 0.0), order)
        return cls(at_rest, Pair(0.0, 0.0), axis, Jet.constant(0.0, order - 1), 0.0)

    @classmethod
    def still(cls, at: Pair, local: Pair, axis: Pair) -> Body:
        """A pose without rates: the link's point ``local`` lies at ``at``, its x axis along ``axis``."""
        return cls(Vec.constant(at, 0), local, Vec.constant(axis, 0), Jet(()))

    def point(self, local: Pair) -> Vec:
        """Position and its derivatives of the link's point ``local``."""
        arm = local.minus(self.local)
        if is_zero(arm.x) and is_zero(arm.y):
            return self.anchor
        return self.anchor.plus(self.axis.carry(arm))

    def velocity(self, place: Pair) -> Pair:
        """The velocity (m/s) of the link's material that is now at a place (m) in the frame."""
        away, omega = place.minus(self.anchor.now), self.turn.d[0]
        return Pair(self.anchor.x.d[1] - omega * away.y, self.anchor.y.d[1] + omega * away.x)

    def direction(self, local: Pair) -> Vec:
        """The unit vector of a direction fixed in the link."""
        return self.axis.carry(local)

    @property
    def heading(self) -> Scalar:
        """The link's angle (rad): exact where it is known so, else that of its axis, in -pi .. pi."""
        return call("arctan2", self.axis.y.d[0], self.axis.x.d[0]) if self.angle is None else self.angle


def unit_vector(angle: Scalar) -> Pair:
    """(cos, sin) of an angle (rad), exact at multiples of a right angle."""
    if isinstance(angle, int | float):
        quarters = angle / (math.pi / 2)
        if abs(quarters - round(quarters)) < 1e-15 * max(1.0, abs(quarters)):
            return (Pair(1.0, 0.0), Pair(0.0, 1.0), Pair(-1.0, 0.0), Pair(0.0, -1.0))[round(quarters) % 4]
    return Pair(call("cos", angle), call("sin", angle))


def turning_axis(start: Pair, turn: Jet) -> Vec:
    """A unit vector and its derivatives, from its value and its angular velocity: c' = -s omega, s' = c omega."""
    c, s = [start.x], [start.y]
    for k in range(turn.order + 1):
        c_rate = -leibniz(s, turn.d, k, range(k + 1))
        s_rate = leibniz(c, turn.d, k, range(k + 1))
        c.append(c_rate)
        s.append(s_rate)
    return Vec(Jet(c), Jet(s))


def _minus(a: Scalar, b: Scalar) -> Scalar:
    return 0.0 if a is b else a - b


@dataclass(frozen=True)
class Wrench:
    """A force (N) and its moment (N m, counter-clockwise) about a stated point ``about`` (m)."""

    force: Pair
    moment: Scalar
    about: Pair

    @classmethod
    def zero(cls, about: Pair) -> Wrench:
        return cls(Pair(0.0, 0.0), 0.0, about)

    def at(self, point: Pair) -> Wrench:
        """The same wrench stated about another point."""
        arm = self.about.minus(point)
        return Wrench(self.force, self.moment + arm.cross(self.force), point)

    def plus(self, other: Wrench) -> Wrench:
        """The sum, stated about this wrench's point."""
        moved = other.at(self.about)
        force = Pair(self.force.x + moved.force.x, self.force.y + moved.force.y)
        return Wrench(force, self.moment + moved.moment, self.about)

    def times(self, factor: Scalar) -> Wrench:
        """The wrench times a number."""
        return Wrench(Pair(self.force.x * factor, self.force.y * factor), self.moment * factor, self.about)

    @property
    def opposite(self) -> Wrench:
        return Wrench(Pair(-self.force.x, -self.force.y), -self.moment, self.about)
