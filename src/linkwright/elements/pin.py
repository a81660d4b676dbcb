"""The revolute joint (pin): links share a point."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.elements.clearance import AnyDirection, Axis, Known, Rows, Seats, StatedClearance
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
from linkwright.expressions import units as u
from linkwright.expressions.written import FaultWithin
from linkwright.findings import Joined
from linkwright.notation import Body, Jet, Pair, Scalar, Vec, Wrench
from linkwright.notation.planar import turning_axis, unit_vector

Turn = Pair
"""A position on a pin: the unit vector (cos, sin) of the link's x axis."""
VAGUE = 1e-12
"""Sketched places nearer to the pin (m2) don't tell an angle."""


@dataclass(frozen=True)
class OuterPin:
    """A link on a pin whose position is known; ``foot`` is the pinned point in the link's frame.

    The coordinate is the link's angle (rad); dyads have its unit vector.
    """

    base: Vec
    foot: Pair

    def place(self, start: Turn, rates: Jet) -> Body:
        return Body(self.base, self.foot, turning_axis(start, rates), rates)

    def place_at(self, start: Scalar, rates: Jet) -> Body:
        body = self.place(unit_vector(start), rates)
        return Body(body.anchor, body.local, body.axis, body.turn, start)

    def driven_body(self, base: Body, law: Jet) -> Body:
        turn = base.turn + law.rate() if law.order else base.turn
        body = self.place(base.axis.now.rotated(unit_vector(law.d[0])), turn)
        known = None if base.angle is None else base.angle + law.d[0]
        return Body(body.anchor, body.local, body.axis, body.turn, known)

    def twist(self, body: Body) -> Twist:
        return Twist(1.0, self.base.now, Pair(0.0, 0.0))

    def coordinate(self, body: Body) -> float:
        return math.atan2(float(body.axis.y.d[0]), float(body.axis.x.d[0]))

    def nearest(self, places: Sequence[tuple[Pair, Pair]]) -> float | None:
        base = self.base.now
        arms = [(here.minus(base), goal.minus(base)) for here, goal in places]
        sine = sum(float(here.cross(goal)) for here, goal in arms)
        cosine = sum(float(here.dot(goal)) for here, goal in arms)
        return math.atan2(sine, cosine) if math.hypot(sine, cosine) > VAGUE else None


@dataclass(frozen=True)
class InnerPin(LowerPair):
    """The two links share a pin: ``first`` and ``second`` are its coordinates in their frames."""

    first: Pair
    second: Pair

    def seen_from(self, a: Body, b: Body) -> InnerPin:
        return InnerPin(a.point(self.first).now, b.point(self.second).now)

    def gap(self, *bodies: Body) -> tuple[Jet, Jet]:
        """Closure: the two pin positions coincide (m)."""
        a, b = bodies
        difference = a.point(self.first).minus(b.point(self.second))
        return difference.x, difference.y

    def slopes(self, a: Body, b: Body, first: Twist, second: Twist) -> Slopes:
        da = first.velocity(a.point(self.first).now)
        db = second.velocity(b.point(self.second).now)
        return (da.x, -db.x), (da.y, -db.y)

    def action(self, a: Body, b: Body, multipliers: tuple[Scalar, Scalar]) -> Wrench:
        return Wrench(Pair(*multipliers), 0.0, a.point(self.first).now)


@dataclass(frozen=True)
class OnPin(AnyDirection):
    """A link on a pin, or on the other link there: the pin's journal lies in the bearing at ``clearance``."""

    joint: str
    links: tuple[str, str]
    clearance: float

    @property
    def plays(self) -> tuple[str, str]:
        link = self.links[1]
        return f"{self.joint}/{link}/x", f"{self.joint}/{link}/y"

    @property
    def rows(self) -> tuple[Known, ...]:
        on, link = self.links
        return (*(f"force({link}, {on}, {self.joint}).{axis}" for axis in "xy"), *self.places)

    @property
    def places(self) -> tuple[Known, ...]:
        return Axis.of(self.links[1])

    def forces(self, rows: Rows) -> Seats:
        return [(rows[self.rows[0]], rows[self.rows[1]])]

    def gradients(self, by: Sequence[Any], rows: Rows) -> Seats:
        # The play moves the place on the link that is held: where it goes, the link goes the other way.
        (x, y), (cos, sin) = by, (rows[name] for name in self.places)
        return [(y * sin - x * cos, -(x * sin) - y * cos)]


@register
class Revolute(JointKind):
    """Links on one pin, from points of one name or named in ``joints``."""

    name = "revolute"
    letter = "R"
    row_units = ("length", "length")
    shared = True
    angular = True
    drive = "turns"
    plays = ("in",)

    def outer(self, geometry: JointGeometry, joint: str, link: str, base: str, body: Body) -> OuterPin:
        at = body.point(geometry.pinned_place(joint, base))
        return OuterPin(at, geometry.pinned_place(joint, link))

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerPin:
        a, b = links
        return InnerPin(geometry.pinned_place(joint, a), geometry.pinned_place(joint, b))

    def play(self, geometry: JointGeometry, joint: str, links: Sequence[str], stated: StatedClearance) -> list[OnPin]:
        """Of two links the second on the first; of more each on the pin, but the one in which it is fixed."""
        if len(links) == 2:
            return [OnPin(joint, (links[0], links[1]), stated.clearance)]
        return [OnPin(joint, (joint, link), stated.clearance) for link in links if link != stated.in_]

    def play_faults(
        self, geometry: JointGeometry, joint: str, links: Sequence[str], stated: StatedClearance
    ) -> Iterator[FaultWithin]:
        if stated.in_ is not None and stated.in_ not in links:
            yield "clearance.not-on-pin", {"name": joint, "link": stated.in_, "links": Joined(links)}, "in"
        for link in links:
            pinned, points = geometry.pin_point(joint, link), geometry.mechanism.links[link].points
            arms = [geometry.point(link, point).minus(pinned) for point in points]
            reach = max(math.hypot(float(arm.x), float(arm.y)) for arm in arms)
            if 0 < reach <= stated.clearance:
                length = geometry.text_of(reach, u.LENGTH)
                yield "clearance.too-large", {"name": joint, "link": link, "length": length}
                return

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        return bodies[link].point(geometry.pin_point(joint, link)).now

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        first, *others = (reports.point_position(link, reports.geometry.pin_point(joint, link)) for link in links)
        return [Miss(other - first, length=True) for other in others]

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        first, *others = links
        place = reports.point_position(first, reports.geometry.pin_point(joint, first))
        axes = [np.repeat([[x], [y]], place.shape[1], axis=1) for x, y in ((1.0, 0.0), (0.0, 1.0))]
        return [[Rate(link, 1.0, place, axis), Rate(first, -1.0, place, axis)] for link in others for axis in axes]

    def applied(self, reports: JointReports, contact: ContactReaction) -> tuple[str, Array, Array, Array | float]:
        # Reported is the force of the link on the pin; the pin answers with the opposite.
        place = reports.point_position(contact.link, reports.geometry.pin_point(contact.joint, contact.link))
        return contact.link, -reports.reaction(contact)[0], place, 0.0
