"""The revolute joint (pin): links share a point."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from linkwright.elements.joint import (
    Array,
    Contact,
    JointGeometry,
    JointKind,
    JointReports,
    Miss,
    Rate,
    Twist,
    register,
)
from linkwright.elements.lower_pair import LowerPair, Slopes
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

    def at(self, start: Scalar, rates: Jet) -> Body:
        body = self.place(unit_vector(start), rates)
        return Body(body.anchor, body.local, body.axis, body.turn, start)

    def driven(self, base: Body, law: Jet) -> Body:
        turn = base.turn + law.rate() if law.order else base.turn
        body = self.place(base.axis.now.turned(unit_vector(law.d[0])), turn)
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


@register
class Revolute(JointKind):
    """Links on one pin, from points of one name or named in ``joints``."""

    name = "revolute"
    letter = "R"
    row_units = ("length", "length")
    shared = True
    angular = True
    drive = "turns"

    def outer(self, geometry: JointGeometry, joint: str, link: str, base: str, body: Body) -> OuterPin:
        at = body.point(geometry.pinned_place(joint, base))
        return OuterPin(at, geometry.pinned_place(joint, link))

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerPin:
        a, b = links
        return InnerPin(geometry.pinned_place(joint, a), geometry.pinned_place(joint, b))

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        return bodies[link].point(geometry.pin_point(joint, link)).now

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        first, *others = (reports.at(link, reports.geometry.pin_point(joint, link)) for link in links)
        return [Miss(other - first, length=True) for other in others]

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        first, *others = links
        place = reports.at(first, reports.geometry.pin_point(joint, first))
        axes = [np.repeat([[x], [y]], place.shape[1], axis=1) for x, y in ((1.0, 0.0), (0.0, 1.0))]
        return [[Rate(link, 1.0, place, axis), Rate(first, -1.0, place, axis)] for link in others for axis in axes]

    def applied(self, reports: JointReports, contact: Contact) -> tuple[str, Array, Array, Array | float]:
        # Reported is the force of the link on the pin; the pin answers with the opposite.
        place = reports.at(contact.link, reports.geometry.pin_point(contact.joint, contact.link))
        return contact.link, -reports.reaction(contact)[0], place, 0.0
