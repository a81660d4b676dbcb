"""The three coordinates of a link that no joint places on another: its angle in the frame, then where its origin is.

A bar on two pins in slots hangs on closures of one equation alone. Its group places it by these coordinates, one after
the other, each on what those before have made of the link itself; joints they are none and transmit nothing.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from linkwright.data_classes import dataclass
from linkwright.elements.joint import (
    Applied,
    ContactReaction,
    Inner,
    JointGeometry,
    JointKind,
    JointReports,
    Miss,
    Rate,
    Twist,
    register,
)
from linkwright.notation import Body, Jet, Pair, Scalar, Vec
from linkwright.notation.planar import turning_axis, unit_vector

ORIGIN = Pair(0.0, 0.0)
VAGUE = 1e-12
"""Sketched places of one link that lie nearer to each other (m2) don't tell its angle."""


@dataclass(frozen=True)
class FloatingAngle:
    """A link whose origin lies at that of the frame so far; the coordinate is its angle (rad)."""

    def place_at(self, start: Scalar, rates: Jet) -> Body:
        anchor = Vec.constant(ORIGIN, rates.order + 1)
        return Body(anchor, ORIGIN, turning_axis(unit_vector(start), rates), rates, start)

    place = place_at

    def driven_body(self, base: Body, law: Jet) -> Body:
        raise NotImplementedError  # no drive acts in it

    def twist(self, body: Body) -> Twist:
        return Twist(1.0, body.anchor.now, ORIGIN)

    def coordinate(self, body: Body) -> float:
        return math.atan2(float(body.axis.y.d[0]), float(body.axis.x.d[0]))

    def nearest(self, places: Sequence[tuple[Pair, Pair]]) -> float | None:
        """The angle from how places of the link lie to each other: one alone tells none."""
        if len(places) < 2:
            return None
        here, there = ([pair[k] for pair in places] for k in (0, 1))
        middles = [Pair(*(sum(float(p[k]) for p in of) / len(of) for k in (0, 1))) for of in (here, there)]
        arms = [(a.minus(middles[0]), b.minus(middles[1])) for a, b in places]
        sine = sum(float(a.cross(b)) for a, b in arms)
        cosine = sum(float(a.dot(b)) for a, b in arms)
        return math.atan2(sine, cosine) if math.hypot(sine, cosine) > VAGUE else None


@dataclass(frozen=True)
class FloatingPlace:
    """A link, as its coordinates so far have it (``body``), moved along an axis of the frame (m)."""

    body: Body
    axis: Pair

    def place_at(self, start: Scalar, rates: Jet) -> Body:
        body, travel = self.body, Jet([start, *rates.d])
        x, y = (at + travel * along if along else at for at, along in zip(body.anchor, self.axis, strict=True))
        return Body(Vec(x, y), body.local, body.axis, body.turn, body.angle)

    place = place_at

    def driven_body(self, base: Body, law: Jet) -> Body:
        raise NotImplementedError  # no drive acts in it

    def twist(self, body: Body) -> Twist:
        return Twist(0.0, body.anchor.now, self.axis)

    def coordinate(self, body: Body) -> float:
        return float(self.axis.dot(body.point(ORIGIN).now))

    def nearest(self, places: Sequence[tuple[Pair, Pair]]) -> float | None:
        travels = [float(self.axis.dot(goal.minus(here))) for here, goal in places]
        return sum(travels) / len(travels) if travels else None


class FloatingKind(JointKind):
    """A coordinate of a floating link: no equation, no reaction, nothing to prove."""

    floating = True
    row_units = ()

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> Inner:
        raise NotImplementedError  # it closes nothing

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        return bodies[link].anchor.now

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        return []

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        return []

    def applied(self, reports: JointReports, contact: ContactReaction) -> Applied:
        raise NotImplementedError  # it transmits nothing


@register
class Turned(FloatingKind):
    """The angle."""

    name = "floating_angle"
    letter = "t"
    angular = True

    def outer(self, geometry: JointGeometry, joint: str, link: str, base: str, body: Body) -> FloatingAngle:
        return FloatingAngle()


@register
class MovedX(FloatingKind):
    """The place along the frame's x axis."""

    name = "floating_x"
    letter = "x"
    angular = False

    def outer(self, geometry: JointGeometry, joint: str, link: str, base: str, body: Body) -> FloatingPlace:
        return FloatingPlace(body, Pair(1.0, 0.0))


@register
class MovedY(FloatingKind):
    """The place along the frame's y axis."""

    name = "floating_y"
    letter = "y"
    angular = False

    def outer(self, geometry: JointGeometry, joint: str, link: str, base: str, body: Body) -> FloatingPlace:
        return FloatingPlace(body, Pair(0.0, 1.0))
