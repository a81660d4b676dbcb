"""The pin in a slot: a point of one link stays on a curve of another, by one constraint.

The slot is a straight line, a circular arc, or a curve through places, given by its height over a line (natural cubic
spline). The normal force acts at the pin along the normal of the curve; there is no friction. With a ``flank`` the pin
bears on one side of the slot alone.

Normals are those on the left of the direction in which the travel grows: along the line, counter-clockwise on an arc.
Sources: P. E. Nikravesh, Computer-Aided Analysis of Mechanical Systems (1988), 4.2 (point follower); C. de Boor, A
Practical Guide to Splines (1978), ch. IV (natural splines).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Annotated, Any, ClassVar, Literal, Self

import numpy as np
from pydantic import BeforeValidator

from linkwright.data_classes import dataclass
from linkwright.elements.clearance import OnFlank, StatedClearance
from linkwright.elements.curves import Curve
from linkwright.elements.entries import JointEntry, NumberFault
from linkwright.elements.fields import TwoLinks, point_of_joint
from linkwright.elements.joint import (
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
from linkwright.elements.mirror import Mirror, Reflection
from linkwright.elements.touch import Reacting, ReportedTouch, Touch
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, LineOn, Name, Two, fault, pair
from linkwright.expressions.typed_fields import Ends, Quantity, Ref, Sign
from linkwright.expressions.written import Fault, unexpected
from linkwright.findings import Joined
from linkwright.notation import Body, Jet, Pair, Scalar, Vec
from linkwright.notation.jets import call, is_zero
from linkwright.notation.planar import unit_vector

MOST = 60
"""The most places that a curve may be given by."""


_IN_SLOT = point_of_joint(1)


def _places(raw: Any) -> Any:
    if not isinstance(raw, list | tuple):
        raise unexpected("slot-places", raw)
    if not 2 <= len(raw) <= MOST:
        raise fault("joint.slot-places", count=len(raw), most=MOST)
    return tuple(raw)


class Arc(Frozen):
    """A slot along a circle about a point of the link that has it."""

    centre: Annotated[Name, _IN_SLOT]
    radius: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE, "slot-radius")]
    start: Annotated[Expression, Quantity(u.ANGLE)] = Expression("0 deg")


class SlotCurve(Frozen):
    """A slot through places over a line: natural cubic spline."""

    along: Annotated[LineOn, _IN_SLOT]
    through: Annotated[
        tuple[Annotated[Two, BeforeValidator(pair("slot-place"))], ...],
        BeforeValidator(_places),
        Quantity(u.LENGTH),
    ]


class PinInSlotEntry(JointEntry):
    """A point of the first link in a slot of the second one; the slot is straight, an arc or a curve."""

    kind: ClassVar[str] = "pin_in_slot"
    signals = {"s": u.LENGTH, "v": u.SPEED, "a": u.ACCELERATION, "j": u.JERK, "force": u.FORCE}

    pin_in_slot: TwoLinks
    pin: Annotated[Name, Ref("point", of=lambda c: c.entry.pin_in_slot[0])]
    straight: Annotated[LineOn | None, _IN_SLOT] = None
    arc: Arc | None = None
    curve: SlotCurve | None = None
    flank: Literal["both", "left", "right"] = "both"
    travel: Annotated[
        Annotated[Two, BeforeValidator(pair("interval"))] | None, Quantity(u.LENGTH, ends=Ends.RISING)
    ] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        slots = [key for key in ("straight", "arc", "curve") if key in given]
        if len(slots) != 1:
            yield "joint.slot", {"given": Joined(slots) or "-"}

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same slot seen in a mirror: its flanks change sides. The travel of an arc is counter-clockwise there too:
        it has the other sign, and the flanks stay."""
        link, other = self.pin_in_slot[1], Reflection(True)
        mirror.holds(*self.pin_in_slot)
        if self.arc is not None:
            start = mirror.line(link, LineOn(f"{self.arc.centre} at {self.arc.start.text}")).angle
            update: dict[str, Any] = {"arc": self.arc.model_copy(update={"start": start})}
            if self.travel is not None:
                update["travel"] = (other.image(self.travel[1]), other.image(self.travel[0]))
            return self.model_copy(update=update)
        update = {"flank": {"left": "right", "right": "left"}.get(self.flank, self.flank)}
        if self.straight is not None:
            update["straight"] = mirror.line(link, self.straight)
        if self.curve is not None:
            along = mirror.line(link, self.curve.along)
            through = tuple((s, other.image(across)) for s, across in self.curve.through)
            update["curve"] = self.curve.model_copy(update={"along": along, "through": through})
        return self.model_copy(update=update)

    @property
    def joint_points(self) -> tuple[str, ...]:
        if self.arc is not None:
            return self.pin, self.arc.centre
        return self.pin, self.axis.point

    @property
    def touching(self) -> tuple[str, str]:
        return self.pin_in_slot

    @property
    def limits(self) -> Two | None:
        return self.travel

    @property
    def one_sided(self) -> Mapping[str, int]:
        return {"left": {"force": -1}, "right": {"force": 1}}.get(self.flank, {})

    @property
    def joins(self) -> Mapping[str, tuple[Expression, ...]]:
        return {} if self.curve is None else {"s": tuple(along for along, _ in self.curve.through)}

    def number_faults(self, value: Callable[[Expression, u.Dimension], Any]) -> Iterator[NumberFault]:
        places = self.curve.through if self.curve is not None else ()
        along = [value(x, u.LENGTH) for x, _ in places]
        for row, (before, after) in enumerate(pairwise(along), start=2):
            yield after - before, Sign.POSITIVE, ("joint.slot-order", {"row": row}, "curve", "through")

    @property
    def axis(self) -> LineOn:
        """The line of a straight slot, or the one over which a curve runs."""
        line = self.straight if self.curve is None else self.curve.along
        assert line is not None
        return line


# The shapes of slots, in the frame of the slotted link: what a pin at local coordinates misses by, and its travel.


@dataclass(frozen=True)
class StraightSlot:
    """The x axis."""

    def gap(self, x: Jet, y: Jet) -> Jet:
        """How far to the left of the slot (m)."""
        return y

    def travel(self, x: Jet, y: Jet) -> Jet:
        """Along the slot (m)."""
        return x

    def normal(self, x: Scalar, y: Scalar) -> Pair:
        """The normal to the left of the travel."""
        return Pair(0.0, 1.0)

    def place(self, travel: Scalar) -> Pair:
        """Where the travel (m) leads."""
        return Pair(travel, 0.0)


@dataclass(frozen=True)
class CircularSlot:
    """A circle about the origin; the travel counts from the x axis."""

    radius: Scalar

    def gap(self, x: Jet, y: Jet) -> Jet:
        """How far to the left of the slot, inwards (m): exact where the pin is in the slot, and of slope 1 there."""
        found: Jet = (self.radius * self.radius - (x * x + y * y)) / (2.0 * self.radius)
        return found

    def travel(self, x: Jet, y: Jet) -> Jet:
        found: Jet = y.arctan2(x) * self.radius
        return found

    def normal(self, x: Scalar, y: Scalar) -> Pair:
        size = call("sqrt", x * x + y * y)
        return Pair(-x / size, -y / size)

    def place(self, travel: Scalar) -> Pair:
        turn = travel / self.radius
        return Pair(self.radius * call("cos", turn), self.radius * call("sin", turn))


@dataclass(frozen=True)
class SplineSlot:
    """A height over the x axis: pieces a + b t + c t^2 + d t^3, t from each knot on; straight beyond the ends."""

    knots: Sequence[Scalar]
    pieces: Sequence[tuple[Scalar, Scalar, Scalar, Scalar]]

    @classmethod
    def through(cls, places: Sequence[tuple[Scalar, Scalar]]) -> SplineSlot:
        """The natural cubic spline through places (x, y) in ascending x, by elimination: numbers or symbols alike."""
        x, y = ([place[k] for place in places] for k in (0, 1))
        last = len(x) - 1
        h = [x[i + 1] - x[i] for i in range(last)]
        slope = [(y[i + 1] - y[i]) / h[i] for i in range(last)]
        # Second derivatives m: a tridiagonal system, m = 0 at both ends; forward elimination, then back.
        pivots: list[Scalar] = []
        rights: list[Scalar] = []
        for i in range(1, last):
            pivot, right = 2.0 * (h[i - 1] + h[i]), 6.0 * (slope[i] - slope[i - 1])
            if pivots:
                factor = h[i - 1] / pivots[-1]
                pivot, right = pivot - factor * h[i - 1], right - factor * rights[-1]
            pivots.append(pivot)
            rights.append(right)
        m: list[Scalar] = [0.0] * (last + 1)
        for i in range(last - 1, 0, -1):
            m[i] = (rights[i - 1] - h[i] * m[i + 1]) / pivots[i - 1]
        pieces = [
            (y[i], slope[i] - h[i] * (2.0 * m[i] + m[i + 1]) / 6.0, m[i] / 2.0, (m[i + 1] - m[i]) / (6.0 * h[i]))
            for i in range(last)
        ]
        # A straight piece beyond each end goes on with the slope there.
        end = slope[-1] + h[-1] * (m[-2] + 2.0 * m[-1]) / 6.0
        return cls([x[0], *x], [(y[0], pieces[0][1], 0.0, 0.0), *pieces, (y[-1], end, 0.0, 0.0)])

    def height(self, x: Jet, rate: bool = False) -> Jet:
        """The height over a place of the axis, with its rates; or with ``rate`` the slope there."""
        here = x.d[0]
        knot, piece = self.knots[0], self.pieces[0]
        for start, following in zip(self.knots[1:], self.pieces[1:], strict=True):
            beyond = here >= start
            knot = call("where", beyond, start, knot)
            piece = tuple(call("where", beyond, n, o) for n, o in zip(following, piece, strict=True))
        a, b, c, d = piece
        t = x - knot
        found: Jet = (t * (3.0 * d) + 2.0 * c) * t + b if rate else ((t * d + c) * t + b) * t + a
        return found

    def place(self, travel: Scalar) -> Pair:
        return Pair(travel, self.height(Jet([travel])).d[0])

    def steepness(self, x: Scalar) -> Scalar:
        """The length of the curve over that of the axis there: sqrt(1 + slope^2)."""
        slope = self.height(Jet([x]), rate=True).d[0]
        return call("sqrt", 1.0 + slope * slope)

    def gap(self, x: Jet, y: Jet) -> Jet:
        """How far to the left of the slot (m), along its normal. In it all rates vanish: they share one factor."""
        size = self.steepness(x.d[0])
        return Jet([entry / size for entry in (y - self.height(x)).d])

    def travel(self, x: Jet, y: Jet) -> Jet:
        """Along the line over which the slot runs (m)."""
        return x

    def normal(self, x: Scalar, y: Scalar) -> Pair:
        slope = self.height(Jet([x]), rate=True).d[0]
        size = call("sqrt", 1.0 + slope * slope)
        return Pair(-slope / size, 1.0 / size)


Slot = StraightSlot | CircularSlot | SplineSlot


@dataclass(frozen=True)
class InnerSlot(Inner):
    """A ``pin`` of the first link in a ``slot`` of the second, in axes at ``base`` along ``heading`` of that link;
    ``off`` is how far to the left of the middle it lies by its play (m)."""

    pin: Pair
    base: Pair
    heading: Pair
    slot: Slot
    off: Scalar = 0.0

    def local(self, a: Body, b: Body) -> tuple[Jet, Jet]:
        """The pin's coordinates in the slot's axes."""
        away: Vec = a.point(self.pin).minus(b.point(self.base))
        along = b.direction(self.heading)
        return away.dot(along), away.dot(along.perp)

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        """Closure: the pin is in the middle of the slot, or as far beside it as its play has it (m)."""
        missed = self.slot.gap(*self.local(*bodies))
        return (missed if is_zero(self.off) else Jet([missed.d[0] - self.off, *missed.d[1:]]),)

    def place(self, bodies: Sequence[Body]) -> Pair | None:
        return bodies[0].point(self.pin).now


@register
class PinInSlot(JointKind):
    """A pin in a straight, circular or curved slot."""

    name = "pin_in_slot"
    letter = "S"
    row_units = ("length",)
    plays = ()
    entry = PinInSlotEntry
    orders = {"s": 0, "v": 1, "a": 2, "j": 3, "force": 2}

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerSlot:
        entry, (a, b) = geometry.mechanism.joints[joint], links
        base, heading, slot = _slot(geometry, entry, b)
        return InnerSlot(geometry.point(a, entry.pin), base, heading, slot, geometry.play(joint, "across"))

    def play(self, geometry: JointGeometry, joint: str, links: Sequence[str], stated: StatedClearance) -> list[OnFlank]:
        """The pin in the slot, to the left: on the flank on which it is pressed, or which alone it has."""
        (a, b), one_sided = links, geometry.mechanism.joints[joint].one_sided
        flank = -one_sided.get("force", 0)  # the signal is the slot's force on the pin, which acts with the opposite
        return [OnFlank(joint, (b, a), stated.clearance, f"{joint}.force", -1, flank)]

    def touch(self, geometry: JointGeometry, joint: str, bodies: Mapping[str, Body]) -> Touch:
        a, b = geometry.mechanism.joints[joint].links
        inner = self.inner(geometry, joint, (a, b))
        x, y = inner.local(bodies[a], bodies[b])
        normal = inner.slot.normal(x.d[0], y.d[0]).rotated(bodies[b].direction(inner.heading).now)
        return Touch(bodies[a].point(inner.pin).now, normal)

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        entry = geometry.mechanism.joints[joint]
        return bodies[entry.links[0]].point(geometry.point(entry.links[0], entry.pin)).now

    def signal(
        self, geometry: JointGeometry, joint: str, attribute: str, bodies: Mapping[str, Body], reaction: Reaction
    ) -> Scalar:
        entry = geometry.mechanism.joints[joint]
        a, b = entry.links
        inner = self.inner(geometry, joint, entry.links)
        x, y = inner.local(bodies[a], bodies[b])
        if attribute != "force":
            return inner.slot.travel(x, y).d[self.orders[attribute]]
        normal = inner.slot.normal(x.d[0], y.d[0])
        # Reported is the force of the pinned link on the slot, which answers with the opposite.
        return -reaction(a).force.dot(normal.rotated(bodies[b].direction(inner.heading).now))

    def outline(self, geometry: JointGeometry, joint: str, low: Scalar, high: Scalar) -> list[Curve]:
        """The slot's centre line, on the slotted link."""
        entry = geometry.mechanism.joints[joint]
        link = entry.links[1]
        base, heading, slot = _slot(geometry, entry, link)
        across = heading.perp

        def place(travel: Scalar) -> Pair:
            x, y = slot.place(travel)
            return Pair(base.x + heading.x * x + across.x * y, base.y + heading.y * x + across.y * y)

        return [Curve(link, place, (low, high))]

    # The proof: the pin's place in the slot and its normal once more, from reported poses, in plain NumPy.

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        return [Miss(_reported_contact(reports, joint)[2], length=True)]

    def reported_touch(self, reports: JointReports, joint: str) -> ReportedTouch:
        place, normal, _ = _reported_contact(reports, joint)
        force, _ = reports.reaction(Reacting(joint, *reports.geometry.mechanism.joints[joint].links))
        return ReportedTouch(place, normal, -(np.asarray(force) * normal).sum(axis=0))

    def restated(self, reports: JointReports, joint: str) -> dict[str, Restated]:
        """The travel along the line or as the angle about the arc's centre; the force along the slot's normal."""
        entry = reports.geometry.mechanism.joints[joint]
        (a, b), stated = entry.links, reports.geometry.number
        away = reports.point_position(a, reports.geometry.point(a, entry.pin)) - reports.point_position(
            b, reports.geometry.point(b, entry.joint_points[1])
        )
        angle = float(stated(entry.axis.angle if entry.arc is None else entry.arc.start, u.ANGLE))
        along = reports.rotated(b, (np.cos(angle), np.sin(angle)))
        travel = Restated((away * along).sum(axis=0))
        if entry.arc is not None:
            radius = float(stated(entry.arc.radius, u.LENGTH))
            turned = np.angle((away[0] + 1j * away[1]) / (along[0] + 1j * along[1]))
            travel = Restated(radius * turned, 2 * np.pi * radius)
        return {"s": travel, "force": Restated(self.reported_touch(reports, joint).force)}

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        place, normal, _ = _reported_contact(reports, joint)
        a, b = links
        return [[Rate(a, 1.0, place, normal), Rate(b, -1.0, place, normal)]]

    def applied(self, reports: JointReports, contact: ContactReaction) -> tuple[str, Array, Array, Array | float]:
        # Reported is the force of the link on the other; what it gets is the opposite, along the normal alone.
        place, normal, _ = _reported_contact(reports, contact.joint)
        force = -np.asarray(reports.reaction(contact)[0])
        return contact.link, (force * normal).sum(axis=0) * normal, place, 0.0


def _slot(geometry: JointGeometry, entry: PinInSlotEntry, link: str) -> tuple[Pair, Pair, Slot]:
    """The origin and the direction of a slot's axes on its link, and its shape there."""
    if entry.arc is not None:
        heading = unit_vector(geometry.number(entry.arc.start, u.ANGLE))
        return (
            geometry.point(link, entry.arc.centre),
            heading,
            CircularSlot(geometry.number(entry.arc.radius, u.LENGTH)),
        )
    base, heading = geometry.point(link, entry.axis.point), unit_vector(geometry.number(entry.axis.angle, u.ANGLE))
    if entry.curve is None:
        return base, heading, StraightSlot()
    places = [(geometry.number(x, u.LENGTH), geometry.number(y, u.LENGTH)) for x, y in entry.curve.through]
    return base, heading, SplineSlot.through(places)


def _reported_contact(reports: JointReports, joint: str) -> tuple[Array, Array, Array]:
    """The pin's place and the slot's normal there (2, times), and how far the pin lies beside the slot (m)."""
    geometry = reports.geometry
    entry = geometry.mechanism.joints[joint]
    a, b = entry.links
    place = reports.point_position(a, geometry.point(a, entry.pin))
    base = reports.point_position(b, geometry.point(b, entry.joint_points[1]))
    away = place - base
    if entry.arc is not None:
        size = np.hypot(*away)
        return place, -away / size, float(geometry.number(entry.arc.radius, u.LENGTH)) - size
    angle = float(geometry.number(entry.axis.angle, u.ANGLE))
    along = reports.rotated(b, (np.cos(angle), np.sin(angle)))
    left = np.array([-along[1], along[0]])
    x, y = (away * along).sum(axis=0), (away * left).sum(axis=0)
    if entry.curve is None:
        return place, left, y
    from scipy.interpolate import CubicSpline

    through = [[float(geometry.number(v, u.LENGTH)) for v in two] for two in entry.curve.through]
    spline = CubicSpline(*np.array(through).T, bc_type="natural")
    inside = np.clip(x, spline.x[0], spline.x[-1])
    slope = spline(inside, 1)
    size = np.hypot(1.0, slope)
    return place, (left - slope * along) / size, (y - spline(inside) - slope * (x - inside)) / size
