"""The shape of a triad: a platform on three legs, and what each kind of leg demands of the platform.

The platform's cosine and sine are numbers, arrays over sampled angles or symbols; all else may be symbols with the
latter. Its place is that of its reference point.
"""

from __future__ import annotations

import math

from linkwright.data_classes import dataclass
from linkwright.elements import InnerLine, InnerPin, OuterLine, OuterPin
from linkwright.graph.motion import Motion
from linkwright.graph.placing import driven_body, inner_joint, outer_joint
from linkwright.notation import Body, Jet, Pair, Scalar
from linkwright.notation.jets import is_zero
from linkwright.structure import Connection, HigherGroup

Row = tuple[Scalar, Scalar, Scalar]
Poses = dict[str, Body]


@dataclass(frozen=True)
class RigidPart:
    """Links that drives inside the group hold to each other: one body, in the axes of its first link."""

    links: tuple[str, ...]
    poses: Poses

    def point(self, link: str, local: Pair) -> Pair:
        """A link's point in the body's axes."""
        return self.poses[link].point(local).now

    def heading(self, link: str, local: Pair) -> Pair:
        """A link's direction in the body's axes."""
        return self.poses[link].direction(local).now


@dataclass(frozen=True)
class Leg:
    """A leg: its part, the joint on a known link and the one on the platform, and the links at both."""

    part: RigidPart
    outer: Connection
    inner: Connection
    links: tuple[str, str]  # the leg's link at the outer joint, and at the inner one
    on: str  # the platform's link at the inner joint

    @property
    def turning(self) -> tuple[bool, bool]:
        """Of the two joints, from the known link inwards, whether each is a pin; else it is a slide."""
        return bool(self.outer.kind.angular), bool(self.inner.kind.angular)


@dataclass(frozen=True)
class Triad:
    """A higher group as a platform and three legs."""

    platform: RigidPart
    legs: tuple[Leg, Leg, Leg]


def parts(motion: Motion, higher_group: HigherGroup, drives: dict[str, Jet]) -> list[RigidPart]:
    """The higher group's rigid bodies: its links, those held to each other by drives as one."""
    groups: list[list[str]] = []
    for edge in higher_group.edges:
        joined = next((g for g in groups if edge.base in g), None) if edge.drive is not None else None
        groups.append([edge.link]) if joined is None else joined.append(edge.link)
    kept = dict(motion.bodies)
    found = []
    for group in groups:
        motion.bodies[group[0]] = Body.fixed(0)
        for edge in higher_group.edges:
            if edge.drive is not None and edge.link in group[1:]:
                motion.bodies[edge.link] = driven_body(motion, edge, drives[edge.drive])[1]
        found.append(RigidPart(tuple(group), {link: motion.bodies[link] for link in group}))
    motion.bodies.clear()
    motion.bodies.update(kept)
    return found


def triad(motion: Motion, higher_group: HigherGroup, drives: dict[str, Jet]) -> Triad | None:
    """The platform and the legs of a higher group; ``None`` where it has another shape."""
    bodies = parts(motion, higher_group, drives)
    owner = {link: i for i, part in enumerate(bodies) for link in part.links}
    joints = [
        c
        for c in (*(e.joint for e in higher_group.free), *higher_group.closures)
        if owner.get(c.a, -1) != owner.get(c.b, -2)
    ]
    if len(bodies) != 4 or len(joints) != 6 or not all(c.kind.places for c in joints):
        return None
    ends = [(owner.get(c.a), owner.get(c.b)) for c in joints]
    for middle in range(4):
        legs = []
        for leg in set(range(4)) - {middle}:
            outer = [c for c, e in zip(joints, ends, strict=True) if leg in e and None in e]
            inner = [c for c, e in zip(joints, ends, strict=True) if leg in e and middle in e]
            if len(outer) == len(inner) == 1:
                mine = set(bodies[leg].links)
                at = tuple(c.a if c.a in mine else c.b for c in (outer[0], inner[0]))
                legs.append(Leg(bodies[leg], outer[0], inner[0], (at[0], at[1]), inner[0].other(at[1])))
        if len(legs) == 3:
            return Triad(bodies[middle], (legs[0], legs[1], legs[2]))
    return None


class Equation:
    """What any leg has: its joints' points in the leg and the platform, and where it hangs."""

    def __init__(self, motion: Motion, triad: Triad, leg: Leg) -> None:
        self.leg, part, platform = leg, leg.part, triad.platform
        outer = outer_joint(motion, leg.outer, leg.links[0])
        assert isinstance(outer, OuterPin | OuterLine)
        inner = inner_joint(motion, leg.inner, (leg.links[1], leg.on))
        assert isinstance(inner, InnerPin | InnerLine)
        self.base = outer.base.now
        self.foot = part.point(leg.links[0], outer.foot)
        self.tip, self.on = part.point(leg.links[1], inner.first), platform.point(leg.on, inner.second)
        if isinstance(inner, InnerLine):
            self.tip_heading = part.heading(leg.links[1], inner.first_heading)
            self.on_heading = platform.heading(leg.on, inner.second_heading)
        if isinstance(outer, OuterLine):
            self.along = outer.direction.now
            self.leg_axis = unit(self.along.rotated_back(part.heading(leg.links[0], outer.heading)))  # the leg's axis

    @property
    def arm(self) -> Pair:
        """From the foot to the tip, in the leg's axes."""
        return self.tip.minus(self.foot)

    @property
    def leg_length(self) -> Scalar:
        """The leg's length between its joints (m)."""
        return self.arm.length

    def place(self, platform: Body) -> Body:
        """The leg's first link at a pose of the platform."""
        raise NotImplementedError


class CircleLeg(Equation):
    """Two pins: the platform's point keeps its distance from the base."""

    def centre(self, c: Scalar, s: Scalar, reference: Pair) -> Pair:
        """The centre of the reference point's circle."""
        return self.base.minus(self.on.minus(reference).rotated(Pair(c, s)))

    def place(self, platform: Body) -> Body:
        x, y = platform.point(self.on).now.minus(self.base).rotated_back(self.arm)
        square = self.arm.dot(self.arm)  # of a pose both lengths are the same
        return Body.still(self.base, self.foot, Pair(x / square, y / square))


class Linear(Equation):
    """A pin and a slide: the platform keeps a distance from a line."""

    def row(self, c: Scalar, s: Scalar, reference: Pair) -> Row:
        """The equation a x + b y + c = 0."""
        raise NotImplementedError


class SlideOnBase(Linear):
    """The slide is on a known link."""

    def row(self, c: Scalar, s: Scalar, reference: Pair) -> Row:
        normal, arm = self.along.perp, self.arm.rotated(self.leg_axis)
        on = self.on.minus(reference).rotated(Pair(c, s))
        return normal.x, normal.y, normal.dot(on) - normal.dot(Pair(self.base.x + arm.x, self.base.y + arm.y))

    def place(self, platform: Body) -> Body:
        return Body.still(platform.point(self.on).now, self.tip, self.leg_axis)


class SlideOnPlatform(Linear):
    """The slide is on the platform."""

    def row(self, c: Scalar, s: Scalar, reference: Pair) -> Row:
        axis, offset = Pair(c, s), self.arm.dot(self.tip_heading.perp)
        normal, on = self.on_heading.perp.rotated(axis), self.on.minus(reference).rotated(axis)
        return normal.x, normal.y, normal.dot(on.minus(self.base)) - offset

    def place(self, platform: Body) -> Body:
        return Body.still(self.base, self.foot, platform.direction(self.on_heading).now.rotated_back(self.tip_heading))


class Fixed(Equation):
    """Two slides: the platform keeps its angle."""

    def angle(self) -> float:
        """The platform's angle (rad)."""
        axis = self.leg_axis.rotated(self.tip_heading).rotated_back(self.on_heading)
        return math.atan2(axis.y, axis.x)

    def place(self, platform: Body) -> Body:
        at, normal = platform.point(self.on).now, platform.direction(self.on_heading).now.perp
        start = Body.still(self.base, self.foot, self.leg_axis)
        gap = at.minus(start.point(self.tip).now).dot(normal) / self.along.dot(normal)
        return Body.still(
            Pair(self.base.x + gap * self.along.x, self.base.y + gap * self.along.y), self.foot, self.leg_axis
        )


EQUATIONS: dict[tuple[bool, bool], type[Equation]] = {
    (True, True): CircleLeg,
    (False, True): SlideOnBase,
    (True, False): SlideOnPlatform,
    (False, False): Fixed,
}
"""By whether a leg's two joints are pins, from the known link inwards."""


def unit(v: Pair) -> Pair:
    """The unit vector along a pair."""
    size = v.length
    size = 1.0 if is_zero(size) else size
    return Pair(v.x / size, v.y / size)
