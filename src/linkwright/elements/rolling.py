"""Rolling: a disc of one link rolls without slip along a line, on a circle or inside a circle of another link.

Two constraints: the disc touches, and what passes at its circumference passes along the other one. Nothing else needs
to hold the distance. On a line, in whose axes on the other link the disc's centre lies at (x, y), s being the sign of
y:

    s y - r = 0,    x + s r (theta - theta_other) = constant;

on a circle of radius R about M, with e the direction and d the distance from M to the disc's centre, rho = -1 inside
the circle and else 1, D = R + rho r:

    rho (d - |D|) = 0,    R theta_other + rho r theta - D psi = constant,    psi the direction of e.

The multipliers are the normal force N (pressing where it is positive) and the tangential one T: the rolling needs a
coefficient of static friction of at least |T|/N. The second equation is taken as D times the angle from a unit vector
to e, so that turns about M needn't be counted. The pose in which the links are drawn fixes the constants. Rolling
takes no power. Source: P. E. Nikravesh, Computer-Aided Analysis of Mechanical Systems (1988), 4.2; J. L. Meriam, L.
G. Kraige, Engineering Mechanics: Dynamics, 7th ed. (2012), 5/4, 6/4 (rolling)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any, ClassVar, NamedTuple, Self

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.elements.curves import Curve, circle, polygon, spoked
from linkwright.elements.entries import JointEntry, NumberFault
from linkwright.elements.fields import TwoLinks, point_of_joint
from linkwright.elements.joint import (
    Applied,
    Array,
    ContactReaction,
    Inner,
    JointGeometry,
    JointKind,
    JointReports,
    Miss,
    Rate,
    Reaction,
    Restated,
    register,
)
from linkwright.elements.mirror import Mirror
from linkwright.elements.pitch import continuous_angle
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, LineOn, Name
from linkwright.expressions.typed_fields import Quantity, Sign
from linkwright.expressions.written import FaultWithin
from linkwright.notation import Body, Jet, Pair, Scalar, Vec
from linkwright.notation.jets import call
from linkwright.notation.planar import unit_vector


class Circle(Frozen):
    """A circle of the other link."""

    centre: Annotated[Name, point_of_joint(1)]
    radius: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE, "circle-radius")]
    inside: bool = False


class RollingEntry(JointEntry):
    """A disc that rolls on another link."""

    kind: ClassVar[str] = "rolling"
    signals = {"normal": u.FORCE, "tangential": u.FORCE}

    rolling: TwoLinks
    centre: Annotated[Name, point_of_joint(0)]
    radius: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE, "disc-radius")]
    on_line: Annotated[LineOn | None, point_of_joint(1)] = None
    on_circle: Circle | None = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[FaultWithin]:
        paths = [key for key in ("on_line", "on_circle") if key in given]
        if len(paths) != 1:
            yield "gears.path", {"given": " ".join(paths) or "-"}

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same disc seen in a mirror."""
        mirror.holds(*self.rolling)
        if self.on_line is None:
            return self
        return self.model_copy(update={"on_line": mirror.line(self.rolling[1], self.on_line)})

    @property
    def joint_points(self) -> tuple[str, ...]:
        if self.on_circle is not None:
            return self.centre, self.on_circle.centre
        assert self.on_line is not None
        return self.centre, self.on_line.point

    @property
    def one_sided(self) -> Mapping[str, int]:
        return {"normal": 1}

    def number_faults(self, value: Any) -> Iterator[NumberFault]:
        if self.on_circle is not None and self.on_circle.inside:
            apart = call("abs", value(self.on_circle.radius, u.LENGTH) - value(self.radius, u.LENGTH))
            yield apart, Sign.POSITIVE, ("gears.same-radius", {}, "on_circle", "radius")


class Touch(NamedTuple):
    """Where a disc touches at a pose: the place, the direction of the push on the disc, the one along the path."""

    place: Pair
    push: Pair
    along: Pair


@dataclass(frozen=True)
class OnLine(Inner):
    """A disc on a line: its ``centre`` and ``radius`` (m), ``base`` and ``heading`` of the line; on which ``side``
    (1 to the left, -1) and which ``constant`` (m) the drawing has."""

    centre: Pair
    radius: Scalar
    base: Pair
    heading: Pair
    side: Scalar
    constant: Scalar

    def lies(self, a: Body, b: Body) -> tuple[Jet, Jet]:
        """The disc's centre along the line and to the left of it (m)."""
        away, along = a.point(self.centre).minus(b.point(self.base)), b.direction(self.heading)
        return away.dot(along), away.dot(along.perp)

    def drawn(self, a: Body, b: Body) -> tuple[float, ...]:
        """Of a pose the side, where the centre lies along the line (m), and the angle between disc and line (rad)."""
        x, y = (float(one.d[0]) for one in self.lies(a, b))
        return -1.0 if y < 0 else 1.0, x, float(continuous_angle(a) - continuous_angle(b))

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        """Closure (m): the gap to the line; what has passed along it but not at the circumference."""
        a, b = bodies
        x, y = self.lies(a, b)
        signed = self.side * self.radius
        rates = x.rate() + (a.turn - b.turn) * signed if x.order else Jet(())
        rolled = x.d[0] + signed * (continuous_angle(a) - continuous_angle(b)) - self.constant
        return y * self.side - self.radius, Jet([rolled, *rates.d])

    def touch(self, a: Body, b: Body) -> Touch:
        along = b.direction(self.heading).now
        push, centre = Pair(-self.side * along.y, self.side * along.x), a.point(self.centre).now
        return Touch(Pair(centre.x - self.radius * push.x, centre.y - self.radius * push.y), push, along)


@dataclass(frozen=True)
class OnCircle(Inner):
    """A disc on a circle about ``base``: its ``centre`` and ``radius`` (m), the circle's radius (``round``, m),
    ``rho`` 1 on it and -1 in it; which ``constant`` (m) the drawing has."""

    centre: Pair
    radius: Scalar
    base: Pair
    round: Scalar
    rho: float
    constant: Scalar

    @property
    def apart(self) -> Scalar:
        """The distance of both centres, with the sign of what passes along the circle (m)."""
        return self.round + self.rho * self.radius

    def drawn(self, a: Body, b: Body) -> tuple[float, ...]:
        """The angles of a pose (rad): disc, circle, and the line of their centres."""
        away = a.point(self.centre).now.minus(b.point(self.base).now)
        line = float(np.arctan2(float(away.y), float(away.x)))
        return float(continuous_angle(a)), float(continuous_angle(b)), line

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        """Closure (m): the gap to the circle; what has passed along it but not at the circumference."""
        a, b = bodies
        away: Vec = a.point(self.centre).minus(b.point(self.base))
        signed, apart = self.rho * self.radius, self.apart
        distance = (away.dot(away)).sqrt()
        missed = (distance - call("abs", apart)) * self.rho
        foretold = unit_vector(
            (self.round * continuous_angle(b) + signed * continuous_angle(a) - self.constant) / apart
        )
        off = call("arctan2", away.now.cross(foretold), away.now.dot(foretold))
        if not away.x.order:
            return missed, Jet([apart * off])
        line = away.cross(Vec(away.x.rate(), away.y.rate())) / away.dot(away)
        passed = b.turn * self.round + a.turn * signed - line * apart
        return missed, Jet([apart * off, *passed.d])

    def touch(self, a: Body, b: Body) -> Touch:
        start = b.point(self.base).now
        away = a.point(self.centre).now.minus(start)
        size = away.length
        out = call("sign", self.apart)
        along = Pair(out * away.x / size, out * away.y / size)  # from the circle's centre to where they touch
        push = Pair(self.rho * along.x * out, self.rho * along.y * out)
        return Touch(Pair(start.x + self.round * along.x, start.y + self.round * along.y), push, along.perp)


@register
class Rolling(JointKind):
    """A disc that rolls without slip."""

    name = "rolling"
    letter = "W"
    row_units = ("length", "length")
    entry = RollingEntry
    phased = True
    winds = True
    orders: ClassVar[Mapping[str, int]] = {"normal": 2, "tangential": 2}

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> OnLine | OnCircle:
        entry, (a, b) = geometry.mechanism.joints[joint], links
        centre, radius = geometry.point(a, entry.centre), geometry.number(entry.radius, u.LENGTH)
        base = geometry.point(b, entry.joint_points[1])
        if entry.on_circle is None:
            heading = unit_vector(geometry.number(entry.on_line.angle, u.ANGLE))
            side, along, turned = geometry.phases(joint) or (1.0, 0.0, 0.0)
            return OnLine(centre, radius, base, heading, side, along + side * radius * turned)
        circle, rho = geometry.number(entry.on_circle.radius, u.LENGTH), -1.0 if entry.on_circle.inside else 1.0
        disc, other, line = geometry.phases(joint) or (0.0, 0.0, 0.0)
        constant = circle * other + rho * radius * disc - (circle + rho * radius) * line
        return OnCircle(centre, radius, base, circle, rho, constant)

    def phase(self, geometry: JointGeometry, joint: str, bodies: Mapping[str, Body]) -> tuple[float, ...]:
        links = geometry.mechanism.joints[joint].links
        return self.inner(geometry, joint, links).drawn(*(bodies[link] for link in links))

    def _touch(self, geometry: JointGeometry, joint: str, bodies: Mapping[str, Body]) -> Touch:
        links = geometry.mechanism.joints[joint].links
        return self.inner(geometry, joint, links).touch(*(bodies[link] for link in links))

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        """Where they touch."""
        return self._touch(geometry, joint, bodies).place

    def signal(
        self, geometry: JointGeometry, joint: str, attribute: str, bodies: Mapping[str, Body], reaction: Reaction
    ) -> Scalar:
        touch = self._touch(geometry, joint, bodies)
        force = reaction(geometry.mechanism.joints[joint].links[0]).force
        # Reported is the force of the disc on the other link.
        return -force.dot(touch.push) if attribute == "normal" else force.dot(touch.along)

    def outline(self, geometry: JointGeometry, joint: str, low: Scalar, high: Scalar) -> list[Curve]:
        """The disc with a spoke; the circle on which it rolls, or a piece of the line."""
        entry = geometry.mechanism.joints[joint]
        (disc, other), inner = entry.links, self.inner(geometry, joint, entry.links)
        drawn, base = spoked(disc, inner.centre, inner.radius), inner.base
        if isinstance(inner, OnCircle):
            return [*drawn, circle(other, base, inner.round)]
        x, y = (LONG * inner.radius * part for part in (inner.heading.x, inner.heading.y))
        return [*drawn, polygon(other, [Pair(base.x - x, base.y - y), Pair(base.x + x, base.y + y)])]

    # The proof: place, directions and angles once more, from reported poses and rates.

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        at, (a, b) = _reported(reports, joint), (reports.turned(link) for link in links)
        own, other = at.radii
        passed = at.passed + own * (a - a[0]) + other * (b - b[0])
        if at.turn is not None:  # how often the disc has gone round the circle, its place alone doesn't tell
            passed = passed - at.turn * np.round(passed / at.turn)
        return [Miss(at.gap, length=True), Miss(passed, length=True)]

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        at, (a, b) = _reported(reports, joint), links
        ways = at.push, np.array([-at.push[1], at.push[0]])
        return [[Rate(a, 1.0, at.place, way), Rate(b, -1.0, at.place, way)] for way in ways]

    def restated(self, reports: JointReports, joint: str) -> dict[str, Restated]:
        """The parts of the disc's reported force along and across its path."""
        entry, at = reports.geometry.mechanism.joints[joint], _reported(reports, joint)
        force = np.asarray(reports.reaction(reports.contact(joint, entry.links[0]))[0])
        return {
            "normal": Restated(-(force * at.push).sum(axis=0)),
            "tangential": Restated((force * at.along).sum(axis=0)),
        }

    def applied(self, reports: JointReports, contact: ContactReaction) -> Applied:
        # Reported is the force of the link on the other; what it gets is the opposite, where they touch.
        place = _reported(reports, contact.joint).place
        return contact.link, -np.asarray(reports.reaction(contact)[0]), place, 0.0


LONG = 4.0
"""Half the length of the line that is drawn, over the disc's radius."""


class _Reported(NamedTuple):
    """Of a reported motion where the disc touches, in which direction it is pushed and that of the path (2, times), the
    gap (m), what has passed by the centre's motion alone since the first time (m), the factors of both angles in it
    (m), and what passes in one turn about a circle (m)."""

    place: Array
    push: Array
    along: Array
    gap: Array
    passed: Array
    radii: tuple[float, float]
    turn: float | None


def _reported(reports: JointReports, joint: str) -> _Reported:
    geometry = reports.geometry
    entry = geometry.mechanism.joints[joint]
    disc, other = entry.links
    radius = float(geometry.number(entry.radius, u.LENGTH))
    centre = reports.point_position(disc, geometry.point(disc, entry.centre))
    base = reports.point_position(other, geometry.point(other, entry.joint_points[1]))
    apart = centre - base
    if entry.on_circle is None:
        angle = float(geometry.number(entry.on_line.angle, u.ANGLE))
        along = reports.rotated(other, (np.cos(angle), np.sin(angle)))
        left = np.array([-along[1], along[0]])
        side = float(np.sign((apart * left).sum(axis=0)[0]))
        push, x = side * left, (apart * along).sum(axis=0)
        gap = (apart * push).sum(axis=0) - radius
        return _Reported(centre - radius * push, push, along, gap, x - x[0], (side * radius, -side * radius), None)
    circle, inside = float(geometry.number(entry.on_circle.radius, u.LENGTH)), entry.on_circle.inside
    size = np.hypot(*apart)
    unit, between = apart / size, circle - radius if inside else circle + radius
    push = -unit if inside else unit
    out = np.sign(between) * unit  # from the circle's centre to where they touch
    place, along = base + circle * out, np.array([-out[1], out[0]])
    turned = np.arctan2(apart[1], apart[0])
    signed = -radius if inside else radius
    return _Reported(
        place, push, along, size - abs(between), -between * (turned - turned[0]), (signed, circle), 2 * np.pi * between
    )
