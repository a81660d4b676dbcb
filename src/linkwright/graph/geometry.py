"""A mechanism's dimensions as numbers: at the nominal parameters, or as symbols of them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import Any

from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, LineOn, Position
from linkwright.expressions.language import Node, evaluate
from linkwright.model.pins import Pin, pins
from linkwright.model.quantities import Quantities
from linkwright.notation import Pair, Scalar
from linkwright.notation.planar import unit_vector
from linkwright.structure import Topology

ZERO = Pair(0.0, 0.0)


class Geometry:
    """Coordinates, masses and loads of a mechanism for given parameter values (floats or symbols), in SI.

    ``plays`` are offsets of joints that no signal or mass shares, ``JOINT/NAME``: ``PIN/LINK/x`` and ``/y`` move the
    place on the link (m, in its frame) that is put on the pin; ``SLIDE/normal`` and ``SLIDE/tilt`` move the second
    link's line along its normal (m) and turn it about its point (rad); those of other kinds their closures take.
    """

    def __init__(
        self, quantities: Quantities, parameters: Mapping[str, Scalar], plays: Mapping[str, Scalar] | None = None
    ) -> None:
        self.quantities, self.parameters, self.plays = quantities, parameters, plays or {}
        self.mechanism = quantities.mechanism
        self._points: dict[tuple[str, str], Pair] = {}
        self._masses: dict[str, tuple[Scalar, Pair, Scalar]] = {}

    @cached_property
    def pins(self) -> dict[str, Pin]:
        """The pins of the mechanism by name."""
        return pins(self.mechanism)

    def number(self, expression: Expression, dimension: u.Dimension) -> Scalar:
        """The value of an expression."""
        node = self.quantities.bind(expression, dimension)
        return evaluate(node, lambda name: self.parameters[name.text])

    def bind(self, expression: Expression, dimension: u.Dimension) -> Node:
        """An expression as a tree in SI."""
        return self.quantities.bind(expression, dimension)

    @cached_property
    def nominal(self) -> Geometry:
        """The same at the nominal parameters, without plays."""
        return Geometry(self.quantities, self.quantities.parameters)

    def position(self, position: Position) -> Pair:
        """Coordinates in a link's frame (m)."""
        return position.coordinates(self.number, _no_other)

    def point(self, link: str, name: str) -> Pair:
        """A named point of a link in its frame (m)."""
        key = (link, name)
        if key not in self._points:
            at = self.mechanism.links[link].points[name]
            self._points[key] = at.coordinates(self.number, lambda other: self.point(link, other))
        return self._points[key]

    def line(self, joint: str, link: str) -> tuple[Pair, Pair]:
        """Point (m) and heading (unit vector) of a prismatic joint's line on one of its links."""
        entry = self.mechanism.joints[joint]
        assert entry.line is not None
        line: LineOn = entry.line[entry.links.index(link)]
        return self.point(link, line.point), self._heading(line.angle)

    def heading_angle(self, joint: str, link: str) -> Scalar:
        """The angle (rad) of a prismatic joint's line in the link's frame."""
        entry = self.mechanism.joints[joint]
        assert entry.line is not None
        return self.number(entry.line[entry.links.index(link)].angle, u.ANGLE)

    def phases(self, joint: str) -> tuple[float, ...] | None:
        """What a joint's kind has fixed at assembly; ``None`` before that."""
        return self.quantities.phases.get(joint)

    def play(self, joint: str, name: str) -> Scalar:
        """The offset of a joint of that name: 0 but for derivatives."""
        return self.plays.get(f"{joint}/{name}", 0.0)

    def text_of(self, value: float, dimension: u.Dimension) -> str:
        """A value in SI in the file's unit, with it."""
        text, size = self.quantities.unit_of(dimension)
        return f"{value / size:.6g} {text}"

    def pivot(self, pin: str, link: str, point: str) -> Pair:
        """The place (m, in the link's frame) that is put on a pin: its point there, and a play."""
        at, plays = self.point(link, point), self.plays
        return Pair(*(q + plays.get(f"{pin}/{link}/{axis}", 0.0) for axis, q in zip("xy", at, strict=True)))

    def pinned_place(self, pin: str, link: str) -> Pair:
        """The place (m, in the link's frame) of one of a pin's links that is put on it, its play included."""
        return self.pivot(pin, link, self.pins[pin].point(link))

    def pin_point(self, pin: str, link: str) -> Pair:
        """A link's point on a pin (m, in its frame)."""
        return self.point(link, self.pins[pin].point(link))

    def pinned(self, link: str, point: str) -> Pair:
        """The place (m, in the link's frame) of a link that is put on the pin of one of its points."""
        for pin in self.quantities.signals.pins.values() if self.plays else ():
            if (link, point) in pin.members:
                return self.pivot(pin.name, link, point)
        return self.point(link, point)

    def seat(self, joint: str, link: str) -> tuple[Pair, Pair, Scalar]:
        """Point (m), heading (unit vector) and its angle (rad) of the line by which a link slides, with its play."""
        (foot, heading), angle = self.line(joint, link), self.heading_angle(joint, link)
        if link == self.mechanism.joints[joint].links[1]:
            if (away := self.plays.get(f"{joint}/normal")) is not None:
                foot = Pair(foot.x - away * heading.y, foot.y + away * heading.x)
            if (tilt := self.plays.get(f"{joint}/tilt")) is not None:
                angle = angle + tilt
                heading = unit_vector(angle)
        return foot, heading, angle

    def _heading(self, expression: Expression) -> Pair:
        return unit_vector(self.number(expression, u.ANGLE))

    def mass(self, link: str) -> tuple[Scalar, Pair, Scalar]:
        """Mass (kg), centre of mass (m, in the link's frame), moment of inertia about it (kg m^2)."""
        if link not in self._masses:
            self._masses[link] = self._whole_mass(link)
        return self._masses[link]

    def _whole_mass(self, link: str) -> tuple[Scalar, Pair, Scalar]:
        """The same, from the link's own mass and those of its counterweights."""
        entry = self.mechanism.links[link]
        parts = [self._own_mass(link)] if entry.mass is not None else []
        for weight in (one.kind.weighs(one.entry) for one in self.mechanism.acting()):
            if weight is not None and weight.link == link:
                inertia = 0.0 if weight.inertia is None else self.number(weight.inertia, u.INERTIA)
                parts.append((self.number(weight.mass, u.MASS), self.place(link, weight.at), inertia))
        return combined_mass(parts)

    def _own_mass(self, link: str) -> tuple[Scalar, Pair, Scalar]:
        """The same of a link without its counterweights."""
        entry = self.mechanism.links[link]
        assert entry.mass is not None
        mass = self.number(entry.mass, u.MASS)
        if entry.shape is None:
            assert entry.com is not None
            assert entry.inertia is not None
            return mass, self.position(entry.com), self.number(entry.inertia, u.INERTIA)
        points = [self.point(link, name) for name in entry.shape.points]
        radius = self.number(entry.shape.radius, u.LENGTH) if entry.shape.radius else 0.0
        centre, square = _SHAPES[entry.shape.form](points, radius)
        return mass, centre, mass * square

    def gravity(self) -> Pair:
        """The acceleration of gravity (m/s^2); zero unless the file gives it."""
        g = self.mechanism.gravity
        return ZERO if g is None else Pair(*(self.number(part, u.ACCELERATION) for part in g.parts))

    def place(self, link: str, at: str | Position | None) -> Pair:
        """A place on a link, by the name of a point or by coordinates, in the link's frame (m)."""
        if isinstance(at, Position):
            return self.position(at)
        return self.point(link, at) if at else ZERO


def _no_other(name: str) -> Pair:
    raise KeyError(name)  # only a link's points are stated by others of it


def extent(topology: Topology, geometry: Geometry) -> float:
    """A length of the mechanism's order (m): the largest distance of two joints on one link."""
    mechanism = topology.mechanism
    joints: dict[str, list[Pair]] = {link: [] for link in mechanism.links}
    for pin in topology.pins.values():
        for link, point in pin.members:
            joints[link].append(geometry.point(link, point))
    for name, joint in mechanism.prismatic_joints():
        for link in joint.links:
            joints[link].append(geometry.line(name, link)[0])
    return widest(joints.values())


def widest(links: Iterable[list[Pair]]) -> float:
    """The largest distance (m) of two places on one link; 1 where there is none."""
    spans = (math.hypot(*map(float, a.minus(b))) for places in links for a in places for b in places)
    return max(spans, default=0.0) or 1.0


def combined_mass(parts: list[tuple[Scalar, Pair, Scalar]]) -> tuple[Scalar, Pair, Scalar]:
    """Mass, centre and moment of inertia about it of several masses on one link (parallel axes)."""
    if len(parts) < 2:
        return parts[0] if parts else (0.0, ZERO, 0.0)
    mass = sum(m for m, _, _ in parts)
    centre = Pair(sum(m * c.x for m, c, _ in parts) / mass, sum(m * c.y for m, c, _ in parts) / mass)
    arms = [c.minus(centre) for _, c, _ in parts]
    return mass, centre, sum(i + m * arm.dot(arm) for (m, _, i), arm in zip(parts, arms, strict=True))


def _rod(points: list[Pair], _: Scalar) -> tuple[Pair, Scalar]:
    """A slender uniform rod: centre in the middle, I = m L^2 / 12."""
    a, b = points
    arm = b.minus(a)
    return Pair((a.x + b.x) / 2, (a.y + b.y) / 2), arm.dot(arm) / 12


# Each shape: its centre of mass, and the square of its radius of gyration (m^2).
_SHAPES: dict[str, Any] = {
    "rod": _rod,
    "disc": lambda points, radius: (points[0], radius * radius / 2),
    "point": lambda points, radius: (points[0], 0.0),
}
