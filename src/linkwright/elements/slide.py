"""The prismatic joint (slide): a line on each of two links, coincident and equally directed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.elements.clearance import Axis, Known, Rows, Seats, StatedClearance
from linkwright.elements.joint import (
    Array,
    ContactReaction,
    JointGeometry,
    JointKind,
    JointReports,
    Miss,
    Rate,
    Twist,
    register,
)
from linkwright.elements.lower_pair import LowerPair, Slopes
from linkwright.expressions.written import FaultWithin
from linkwright.findings import Joined
from linkwright.notation import Body, Jet, Pair, Scalar, Vec, Wrench


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

    def place(self, start: Scalar, rates: Jet) -> Body:
        travel = Jet([start, *rates.d])
        axis = Vec(
            self.direction.x * self.heading.x + self.direction.y * self.heading.y,
            self.direction.y * self.heading.x - self.direction.x * self.heading.y,
        )
        return Body(self.base.plus(self.direction.times(travel)), self.foot, axis, self.turn, self.angle)

    place_at = place

    def driven_body(self, base: Body, law: Jet) -> Body:
        return self.place(law.d[0], law.rate())

    def twist(self, body: Body) -> Twist:
        return Twist(0.0, body.anchor.now, self.direction.now)

    def coordinate(self, body: Body) -> float:
        away = body.point(self.foot).now.minus(self.base.now)
        return float(away.dot(self.direction.now))

    def nearest(self, places: Sequence[tuple[Pair, Pair]]) -> float | None:
        travels = [float(self.direction.now.dot(goal.minus(here))) for here, goal in places]
        return sum(travels) / len(travels) if travels else None


@dataclass(frozen=True)
class InnerLine(LowerPair):
    """A line on each link, coincident and equally directed: points and headings in the links' frames."""

    first: Pair
    first_heading: Pair
    second: Pair
    second_heading: Pair

    def seen_from(self, a: Body, b: Body) -> InnerLine:
        ends = (a, self.first, self.first_heading), (b, self.second, self.second_heading)
        (p, u), (q, v) = ((body.point(point).now, body.direction(heading).now) for body, point, heading in ends)
        return InnerLine(p, u, q, v)

    def gap(self, *bodies: Body) -> tuple[Jet, Jet]:
        """Closure: equal headings (rad; the sine of the difference at order 0) and no distance across (m)."""
        a, b = bodies
        u, v = a.direction(self.first_heading), b.direction(self.second_heading)
        between = Jet([u.now.cross(v.now), *(b.turn - a.turn).d])
        across = b.point(self.second).minus(a.point(self.first)).dot(u.perp)
        return between, across

    def slopes(self, a: Body, b: Body, first: Twist, second: Twist) -> Slopes:
        normal = a.direction(self.first_heading).perp.now
        point = b.point(self.second).now
        return (-first.turn, second.turn), (
            -first.velocity(point).dot(normal),
            second.velocity(point).dot(normal),
        )

    def action(self, a: Body, b: Body, multipliers: tuple[Scalar, Scalar]) -> Wrench:
        normal = a.direction(self.first_heading).perp.now
        moment, force = multipliers
        return Wrench(Pair(-force * normal.x, -force * normal.y), -moment, b.point(self.second).now)


@dataclass(frozen=True)
class InGuide:
    """The second link of a slide in its guide of ``length`` (m) about ``centre``, a point; ``foot`` is the point of
    the second link's line, ``heading`` the first line's direction in its link."""

    joint: str
    links: tuple[str, str]
    clearance: float
    length: float
    centre: str
    foot: str
    heading: tuple[float, float]
    kind: ClassVar[str] = "guide"
    flank: ClassVar[int] = 0
    round: ClassVar[bool] = False

    @property
    def plays(self) -> tuple[str, str]:
        return f"{self.joint}/normal", f"{self.joint}/tilt"

    @cached_property
    def rows(self) -> tuple[Known, ...]:
        first, second = self.links
        force = f"force({second}, {first}, {self.joint})"
        return (f"{force}.normal", f"{force}.moment", *self.places)

    @cached_property
    def places(self) -> tuple[Known, ...]:
        first = self.links[0]
        points = (f"{point}.{axis}" for point in (self.centre, self.foot) for axis in "xy")
        return (*Axis.of(first), *points)

    def _ahead(self, rows: Rows) -> Any:
        """How far the centre lies ahead of the foot along the line (m)."""
        cos, sin, x, y, foot_x, foot_y = (rows[name] for name in self.places)
        (a, b) = self.heading
        return (x - foot_x) * (cos * a - sin * b) + (y - foot_y) * (sin * a + cos * b)

    def forces(self, rows: Rows) -> Seats:
        normal, moment = rows[self.rows[0]], rows[self.rows[1]]
        turning = (moment - self._ahead(rows) * normal) * (1 / self.length)
        return [(normal * 0.5 + turning,), (normal * 0.5 - turning,)]

    def gradients(self, by: Sequence[Any], rows: Rows) -> Seats:
        x, y = by
        across, tilt = -x, self._ahead(rows) * x - y
        return [(across * 0.5 + tilt * (1 / self.length),), (across * 0.5 - tilt * (1 / self.length),)]

    def size(self, parts: Sequence[Any]) -> Any:
        x, y = parts
        return np.abs(x) + np.abs(y)

    def displacement(self, seats: Seats) -> tuple[Any, Any]:
        (ahead,), (behind,) = seats
        return (ahead + behind) * 0.5, (ahead - behind) * (1 / self.length)


@register
class Prismatic(JointKind):
    """Two links on a common line."""

    name = "prismatic"
    letter = "P"
    row_units = ("angle", "length")
    parallel = True
    angular = False
    drive = "slides"
    plays = ("length", "centre")

    def outer(self, geometry: JointGeometry, joint: str, link: str, base: str, body: Body) -> OuterLine:
        base_point, base_heading, base_angle = geometry.seat(joint, base)
        foot, heading, own_angle = geometry.seat(joint, link)
        angle = None if body.angle is None else body.angle + base_angle - own_angle
        return OuterLine(body.point(base_point), body.direction(base_heading), body.turn, foot, heading, angle)

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerLine:
        a, b = links
        return InnerLine(*geometry.seat(joint, a)[:2], *geometry.seat(joint, b)[:2])

    def play(self, geometry: JointGeometry, joint: str, links: Sequence[str], stated: StatedClearance) -> list[InGuide]:
        assert stated.length is not None
        (first, second), foot = links, geometry.mechanism.joints[joint].line[1].point
        heading = geometry.line(joint, first)[1]
        direction, centre = (float(heading.x), float(heading.y)), stated.centre or foot
        return [InGuide(joint, (first, second), stated.clearance, stated.length, centre, foot, direction)]

    def play_faults(
        self, geometry: JointGeometry, joint: str, links: Sequence[str], stated: StatedClearance
    ) -> Iterator[FaultWithin]:
        if stated.length is None:
            yield "clearance.no-length", {"name": joint}
        elif stated.clearance >= stated.length / 2:
            yield "clearance.short-guide", {"name": joint}
        every = geometry.mechanism.links
        if stated.centre is not None and not any(stated.centre in every[link].points for link in links):
            yield "clearance.centre", {"name": stated.centre, "links": Joined(links)}, "centre"

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        second = geometry.mechanism.joints[joint].links[1]
        point, _ = geometry.line(joint, second)
        return bodies[second].point(point).now

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        (start, along), (end, other) = (reports.line(joint, link) for link in links)
        between = end - start
        return [Miss(between[0] * along[1] - between[1] * along[0], length=True), Miss(other - along, length=False)]

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        a, b = links
        place, along = reports.line(joint, b)[0], reports.line(joint, a)[1]
        normal = np.array([-along[1], along[0]])
        return [[Rate(b, 1.0, place, normal), Rate(a, -1.0, place, normal)], [Rate(b, 1.0), Rate(a, -1.0)]]

    def applied(self, reports: JointReports, contact: ContactReaction) -> tuple[str, Array, Array, Array | float]:
        force, moment = reports.reaction(contact)
        place, _ = reports.line(contact.joint, reports.geometry.mechanism.joints[contact.joint].links[1])
        return contact.on, force, place, moment
