"""How a link hangs on an already known body by one joint, and how two links of a group meet.

An outer joint gives its link one freedom with coordinate q: the angle on a pin, the travel on a line. An inner
joint states two closure equations between the group's links. Both speak jets, so the same few lines give
position, velocity, acceleration and jerk, and by duality the equilibrium.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from linkwright.notation import Body, Jet, Pair, Scalar, Vec, Wrench
from linkwright.notation.planar import turning_axis

Turn = Pair
"""A position on a pin: the unit vector (cos, sin) of the link's x axis."""


@dataclass(frozen=True)
class Twist:
    """The motion that a unit rate of a freedom gives a link: turning ``turn`` (1 or 0) about ``about``, while that
    place moves ``along`` (m per unit rate)."""

    turn: float
    about: Pair
    along: Pair

    def velocity(self, point: Pair) -> Pair:
        """Velocity of the link's point now at ``point`` (m per unit rate)."""
        if not self.turn:
            return self.along
        turned = point.minus(self.about).perp
        return Pair(self.along.x + turned.x, self.along.y + turned.y)

    def work(self, wrench: Wrench) -> Scalar:
        """Power of a wrench on this unit rate: the generalised force."""
        pushed = self.along.dot(wrench.force)
        return pushed + wrench.at(self.about).moment if self.turn else pushed


class Outer(Protocol):
    """An outer joint: places its link from a coordinate, and tells the freedom it leaves."""

    @property
    def letter(self) -> str:
        """R for a pin, P for a line."""

    def place(self, start: Any, rates: Jet) -> Body:
        """The link's motion from its coordinate: the value now, and the rates (q', q'', ...)."""

    def twist(self, body: Body) -> Twist:
        """The freedom of the placed link."""


@dataclass(frozen=True)
class OuterPin:
    """A link on a pin whose position is known; ``foot`` is the pinned point in the link's frame."""

    base: Vec
    foot: Pair
    letter: str = "R"

    def place(self, start: Turn, rates: Jet) -> Body:
        return Body(self.base, self.foot, turning_axis(start, rates), rates)

    def twist(self, body: Body) -> Twist:
        return Twist(1.0, self.base.now, Pair(0.0, 0.0))


@dataclass(frozen=True)
class OuterLine:
    """A link whose line lies on a known line, through ``base`` in ``direction`` of a body turning at ``turn``.

    ``foot`` and ``heading`` are the link's own line in its frame; the coordinate is the distance from ``base``
    to the foot along the direction (m).
    """

    base: Vec
    direction: Vec
    turn: Jet
    foot: Pair
    heading: Pair
    angle: Scalar | None = None  # of the base link plus the difference of the two lines' headings
    letter: str = "P"

    def place(self, start: Scalar, rates: Jet) -> Body:
        travel = Jet([start, *rates.d])
        axis = Vec(
            self.direction.x * self.heading.x + self.direction.y * self.heading.y,
            self.direction.y * self.heading.x - self.direction.x * self.heading.y,
        )
        return Body(self.base.plus(self.direction.times(travel)), self.foot, axis, self.turn, self.angle)

    def twist(self, body: Body) -> Twist:
        return Twist(0.0, body.anchor.now, self.direction.now)


@dataclass(frozen=True)
class InnerPin:
    """The two links share a pin: ``first`` and ``second`` are its coordinates in their frames."""

    first: Pair
    second: Pair
    letter: str = "R"

    def seen_from(self, a: Body, b: Body) -> InnerPin:
        """The same joint by coordinates in the frames in which the two links lie as ``a`` and ``b`` say."""
        return InnerPin(a.point(self.first).now, b.point(self.second).now)

    def gap(self, a: Body, b: Body) -> tuple[Jet, Jet]:
        """Closure: the two pin positions coincide (m)."""
        difference = a.point(self.first).minus(b.point(self.second))
        return difference.x, difference.y

    def slopes(self, a: Body, b: Body, first: Twist, second: Twist) -> Slopes:
        """d(gap)/d(coordinates)."""
        da = first.velocity(a.point(self.first).now)
        db = second.velocity(b.point(self.second).now)
        return (da.x, -db.x), (da.y, -db.y)

    def action(self, a: Body, b: Body, multipliers: tuple[Scalar, Scalar]) -> Wrench:
        """The wrench on the first link that the closure's multipliers stand for."""
        return Wrench(Pair(*multipliers), 0.0, a.point(self.first).now)


@dataclass(frozen=True)
class InnerLine:
    """A line on each link, coincident and equally directed: points and headings in the links' frames."""

    first: Pair
    first_heading: Pair
    second: Pair
    second_heading: Pair
    letter: str = "P"

    def seen_from(self, a: Body, b: Body) -> InnerLine:
        """The same joint by coordinates in the frames in which the two links lie as ``a`` and ``b`` say."""
        ends = (a, self.first, self.first_heading), (b, self.second, self.second_heading)
        (p, u), (q, v) = ((body.point(point).now, body.direction(heading).now) for body, point, heading in ends)
        return InnerLine(p, u, q, v)

    def gap(self, a: Body, b: Body) -> tuple[Jet, Jet]:
        """Closure: equal headings (rad; the sine of the difference at order 0) and no distance across (m)."""
        u, v = a.direction(self.first_heading), b.direction(self.second_heading)
        between = Jet([u.now.cross(v.now), *(b.turn - a.turn).d])
        across = b.point(self.second).minus(a.point(self.first)).dot(u.perp)
        return between, across

    def slopes(self, a: Body, b: Body, first: Twist, second: Twist) -> Slopes:
        """d(gap)/d(coordinates)."""
        normal = a.direction(self.first_heading).perp.now
        point = b.point(self.second).now
        return (-first.turn, second.turn), (
            -first.velocity(point).dot(normal),
            second.velocity(point).dot(normal),
        )

    def action(self, a: Body, b: Body, multipliers: tuple[Scalar, Scalar]) -> Wrench:
        """The wrench on the first link that the closure's multipliers stand for."""
        normal = a.direction(self.first_heading).perp.now
        moment, force = multipliers
        return Wrench(Pair(-force * normal.x, -force * normal.y), -moment, b.point(self.second).now)


Slopes = tuple[tuple[Scalar, Scalar], tuple[Scalar, Scalar]]
Inner = InnerPin | InnerLine
