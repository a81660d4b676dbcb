"""Rack and pinion: a gear on a carrier in mesh with a rack that slides on the same carrier, with the forces of the
teeth.

In the rack's axes along and across its pitch line let the pinion's centre lie at (x, y), s being the sign of y: on
which side of the line it is. The pinion rolls along the line with its pitch radius r:

    x + s r (theta_pinion - theta_rack) = constant,

where the pose in which the links are drawn fixes the constant. By duality the multiplier is the tangential force T at
the pitch point, at r below the centre; |T| tan(alpha) pushes the pinion away from the rack, on either flank. The
rolling radius of a pinion on a rack is that of its reference circle, module times teeth over 2, and alpha the
reference pressure angle, whether the rack lies as without profile shift or not.

Source: G. Niemann, H. Winter, Maschinenelemente II (2003), ch. 21; ISO 21771 (2007; basic rack).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any, ClassVar, NamedTuple, Self

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.elements.clearance import OnFlank, StatedClearance
from linkwright.elements.curves import Curve, polygon, spoked
from linkwright.elements.entries import JointEntry, NumberFault, StatedPlaces
from linkwright.elements.fields import TwoLinks, point_of_joint
from linkwright.elements.gears import EXACT, MESH_SIGNALS, SHIFTED, VARIED, WHOLE
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
from linkwright.elements.pitch import continuous_angle, pinned_point
from linkwright.elements.points import FRAME
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, LineOn, Name
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.expressions.written import FaultWithin
from linkwright.findings import Joined
from linkwright.notation import Body, Jet, Pair, Scalar, Wrench
from linkwright.notation.jets import call, is_zero
from linkwright.notation.planar import unit_vector

PARALLEL = 1e-9
"""The sine of the angle between a rack's line and its guide is below this."""


class RackEntry(JointEntry):
    """A pinion in mesh with a rack."""

    kind: ClassVar[str] = "rack"
    signals = MESH_SIGNALS

    rack: TwoLinks
    centre: Annotated[Name, point_of_joint(0)]
    pitch_line: Annotated[LineOn, point_of_joint(1)]
    carrier: Annotated[Name, Ref("link")] = FRAME
    radius: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE, "pitch-radius")] = None
    teeth: Annotated[Expression | None, Quantity(u.PURE, Sign.POSITIVE, "teeth", whole=True)] = None
    module: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE, "module")] = None
    pressure_angle: Annotated[Expression, Quantity(u.ANGLE, Sign.NOT_NEGATIVE, "pressure-angle")] = Expression("20 deg")

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[FaultWithin]:
        sizes = [key for key in ("radius", "teeth", "module") if key in given]
        if sizes not in (["radius"], ["teeth", "module"]):
            yield "gears.pinion", {"given": " ".join(sizes) or "-"}

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same rack and pinion seen in a mirror."""
        mirror.holds(self.rack[0], self.carrier)
        return self.model_copy(update={"pitch_line": mirror.line(self.rack[1], self.pitch_line)})

    @property
    def joint_points(self) -> tuple[str, ...]:
        return self.centre, self.pitch_line.point

    @property
    def kinks(self) -> tuple[str, ...]:
        return ("tangential",)

    def guide(self, mechanism: Any) -> tuple[str, str] | None:
        """The carrier's point at the pinion's centre, and the prismatic joint of carrier and rack; ``None`` where it
        lacks one of them."""
        return _guided(mechanism, self.carrier, self)

    def name_faults(self, mechanism: Any) -> Iterator[FaultWithin]:
        known = mechanism.links.keys() >= {self.carrier, *self.rack}
        if known and self.centre in mechanism.links[self.rack[0]].points and self.guide(mechanism) is None:
            able = [link for link in mechanism.links if _guided(mechanism, link, self) is not None]
            data = {"carrier": self.carrier, "pinion": self.rack[0], "rack": self.rack[1]}
            yield "gears.guide", {**data, "able": Joined(able) or "-"}, "carrier"

    def pitch_radius(self, numbers: Any) -> Scalar:
        """The radius (m) with which the pinion rolls; ``numbers`` gives values."""
        if self.radius is not None:
            return numbers.number(self.radius, u.LENGTH)
        assert self.teeth is not None
        assert self.module is not None
        return numbers.number(self.teeth, u.PURE) * numbers.number(self.module, u.LENGTH) / 2.0

    def lines(self, numbers: Any) -> tuple[Scalar, Scalar]:
        """How far to the left of the rack's line the pinion's centre lies (m), by the carrier's dimensions; and the
        sine of the angle from the guide to the line."""
        guide = self.guide(numbers.mechanism)
        assert guide is not None
        point, slide = guide
        entry = numbers.mechanism.joints[slide]
        lines = dict(zip(entry.links, entry.line, strict=True))
        on_carrier, on_rack = lines[self.carrier], lines[self.rack[1]]
        own, other = (unit_vector(numbers.number(line.angle, u.ANGLE)) for line in (on_carrier, on_rack))
        heading = unit_vector(numbers.number(self.pitch_line.angle, u.ANGLE))
        centre = numbers.point(self.carrier, point).minus(numbers.point(self.carrier, on_carrier.point))
        foot = numbers.point(self.rack[1], self.pitch_line.point).minus(numbers.point(self.rack[1], on_rack.point))
        across = own.cross(centre) - other.cross(foot)
        return across * other.dot(heading), other.cross(heading)

    def place_faults(self, places: StatedPlaces, nominal: bool) -> Iterator[NumberFault]:
        if nominal and self.teeth is not None:
            teeth = places.number(self.teeth, u.PURE)
            yield WHOLE - abs(teeth - np.round(teeth)), Sign.POSITIVE, ("gears.whole", {}, "teeth")
        quarter = np.pi / 2 - places.number(self.pressure_angle, u.ANGLE)
        yield quarter - WHOLE, Sign.POSITIVE, ("gears.pressure", {}, "pressure_angle")
        links = places.mechanism.links
        named = ((self.rack[0], self.centre), (self.rack[1], self.pitch_line.point))
        if any(link not in links or point not in links[link].points for link, point in named):
            return
        if self.carrier not in links or self.guide(places.mechanism) is None:
            return
        away, tilt = self.lines(places)
        yield PARALLEL - call("abs", tilt), Sign.POSITIVE, ("gears.rack-line", {"rack": self.rack[1]}, "pitch_line")
        radius, apart = self.pitch_radius(places), call("abs", away)
        texts = {"radius": places.text_of(radius, u.LENGTH), "distance": places.text_of(apart, u.LENGTH)}
        slack = (EXACT if nominal else VARIED) * radius
        if self.module is not None:
            slack = slack + SHIFTED * places.number(self.module, u.LENGTH)
        yield slack - call("abs", apart - radius), Sign.NOT_NEGATIVE, ("gears.rack-distance", texts, "pitch_line")


def _guided(mechanism: Any, carrier: str, entry: RackEntry) -> tuple[str, str] | None:
    pinion, rack = entry.rack
    point = pinned_point(mechanism, carrier, (pinion, entry.centre))
    slides = (name for name, joint in mechanism.joints.items() if joint.prismatic and {*joint.links} == {carrier, rack})
    slide = next(slides, None)
    return None if point is None or slide is None or carrier in (pinion, rack) else (point, slide)


class Mesh(NamedTuple):
    """Where pinion and rack mesh at a pose: the direction of the line, across it away from the rack, the pitch
    point."""

    along: Pair
    away: Pair
    place: Pair


@dataclass(frozen=True)
class InnerRack(Inner):
    """Pinion and rack as a closure: the pinion's ``centre``, ``base`` and ``heading`` of the line in the rack, the
    signed pitch ``radius`` (m; negative to the right of the line), the ``constant`` (m) that the drawing fixes; how
    ``steep`` the line of action is, the tangent of the pressure angle."""

    centre: Pair
    base: Pair
    heading: Pair
    radius: Scalar
    constant: Scalar
    steep: Scalar

    def travel(self, a: Body, b: Body) -> Jet:
        """The pinion's centre along the line (m)."""
        return a.point(self.centre).minus(b.point(self.base)).dot(b.direction(self.heading))

    def rolled(self, a: Body, b: Body) -> Scalar:
        """What stays constant (m)."""
        return self.travel(a, b).d[0] + self.radius * (continuous_angle(a) - continuous_angle(b))

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        """Closure (m): what has passed along the line but not at the pitch circle."""
        a, b = bodies
        travel = self.travel(a, b)
        rates = travel.rate() + (a.turn - b.turn) * self.radius if travel.order else Jet(())
        return (Jet([self.rolled(a, b) - self.constant, *rates.d]),)

    def mesh(self, a: Body, b: Body) -> Mesh:
        """Where they mesh."""
        along = b.direction(self.heading).now
        side = call("sign", self.radius)
        away, centre, size = Pair(-side * along.y, side * along.x), a.point(self.centre).now, side * self.radius
        return Mesh(along, away, Pair(centre.x - size * away.x, centre.y - size * away.y))

    def besides(self, bodies: Sequence[Body], multipliers: Sequence[Scalar]) -> list[Wrench]:
        """The separating force: the tangential force, of either sign, times the tangent."""
        if is_zero(self.steep):
            return []
        _, away, place = self.mesh(*bodies)
        size = call("abs", multipliers[0]) * self.steep
        push = Wrench(Pair(size * away.x, size * away.y), 0.0, place)
        return [push, push.opposite]


@register
class Rack(JointKind):
    """A pinion in mesh with a rack."""

    name = "rack"
    letter = "K"
    row_units = ("length",)
    entry = RackEntry
    phased = True
    winds = True
    plays = ()
    orders: ClassVar[Mapping[str, int]] = {"tangential": 2, "separating": 2, "force": 2, "speed": 1, "power": 2}

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerRack:
        entry = geometry.mechanism.joints[joint]
        along, turned = geometry.phases(joint) or (0.0, 0.0)
        away, _ = entry.lines(geometry)
        radius = call("sign", away) * entry.pitch_radius(geometry)
        return InnerRack(
            geometry.point(entry.rack[0], entry.centre),
            geometry.point(entry.rack[1], entry.pitch_line.point),
            unit_vector(geometry.number(entry.pitch_line.angle, u.ANGLE)),
            radius,
            along + radius * turned + geometry.play(joint, "across"),
            call("tan", geometry.number(entry.pressure_angle, u.ANGLE)),
        )

    def play(self, geometry: JointGeometry, joint: str, links: Sequence[str], stated: StatedClearance) -> list[OnFlank]:
        """Backlash along the line: the pinion has run ahead of the rack where it pushes that way."""
        pinion, other = links
        return [OnFlank(joint, (other, pinion), stated.clearance, f"{joint}.tangential")]

    def phase(self, geometry: JointGeometry, joint: str, bodies: Mapping[str, Body]) -> tuple[float, ...]:
        links = geometry.mechanism.joints[joint].links
        a, b = (bodies[link] for link in links)
        along = self.inner(geometry, joint, links).travel(a, b).d[0]
        return float(along), float(continuous_angle(a) - continuous_angle(b))

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        """The pitch point."""
        links = geometry.mechanism.joints[joint].links
        return self.inner(geometry, joint, links).mesh(*(bodies[one] for one in links)).place

    def signal(
        self, geometry: JointGeometry, joint: str, attribute: str, bodies: Mapping[str, Body], reaction: Reaction
    ) -> Scalar:
        entry = geometry.mechanism.joints[joint]
        inner, (a, b) = self.inner(geometry, joint, entry.links), (bodies[link] for link in entry.links)
        speed = (a.turn.d[0] - bodies[entry.carrier].turn.d[0]) * inner.radius
        if attribute == "speed":
            return speed
        tangential = reaction(entry.rack[0]).force.dot(inner.mesh(a, b).along)
        if attribute == "tangential":
            return tangential
        if attribute == "power":
            return tangential * speed
        size = call("abs", tangential)
        if attribute == "separating":
            return size * inner.steep
        return size / call("cos", geometry.number(entry.pressure_angle, u.ANGLE))

    def outline(self, geometry: JointGeometry, joint: str, low: Scalar, high: Scalar) -> list[Curve]:
        """The pitch circle with a spoke; of the rack a bar along its line, on the other side of it than the pinion."""
        entry = geometry.mechanism.joints[joint]
        inner = self.inner(geometry, joint, entry.links)
        size, (along, base) = call("abs", inner.radius), (inner.heading, inner.base)
        across = Pair(-inner.radius * along.y, inner.radius * along.x)

        def corner(far: float, deep: float) -> Pair:
            return Pair(
                base.x + far * size * along.x + deep * across.x, base.y + far * size * along.y + deep * across.y
            )

        pinion, rack = entry.rack
        bar = [corner(far, deep) for far, deep in ((-2.0, 0.0), (2.0, 0.0), (2.0, -0.4), (-2.0, -0.4))]
        return [*spoked(pinion, inner.centre, size), polygon(rack, bar)]

    # The proof: the pinion's place along the line and the angles once more, from reported poses and rates.

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        at = self._reported(reports, joint)
        a, b = (reports.turned(link) for link in links)
        missed = at.along_line + at.radius * (a - b)
        return [Miss(missed - missed[0], length=True), Miss(at.off - at.off[0], length=True)]

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        at, (a, b) = self._reported(reports, joint), links
        return [[Rate(a, 1.0, at.place, at.along), Rate(b, -1.0, at.place, at.along)]]

    def applied(self, reports: JointReports, contact: ContactReaction) -> Applied:
        # Reported is the force of the link on the other; what it gets is the opposite, at the pitch point.
        place = self._reported(reports, contact.joint).place
        return contact.link, -np.asarray(reports.reaction(contact)[0]), place, 0.0

    def restated(self, reports: JointReports, joint: str) -> dict[str, Restated]:
        """The force is that of the reported reaction with its parts along and across the line; the speed is that of the
        pinion's material at the pitch point as the carrier sees it."""
        entry, at = reports.geometry.mechanism.joints[joint], self._reported(reports, joint)
        force = np.asarray(reports.reaction(reports.contact(joint, entry.rack[0]))[0])
        seen = reports.velocity(entry.rack[0], at.place) - reports.velocity(entry.carrier, at.place)
        across = force[1] * at.along[0] - force[0] * at.along[1]
        return {
            "speed": Restated((seen * at.along).sum(axis=0)),
            "tangential": Restated((force * at.along).sum(axis=0)),
            "separating": Restated(np.abs(across)),
            "force": Restated(np.hypot(*force)),
            "power": Restated((force * seen).sum(axis=0)),
        }

    def misfits(self, reports: JointReports, joint: str) -> list[Array]:
        """By what the force across the line misses the tangential one times the tangent of the pressure angle."""
        entry, at = reports.geometry.mechanism.joints[joint], self._reported(reports, joint)
        force = np.asarray(reports.reaction(reports.contact(joint, entry.rack[0]))[0])
        steep = np.tan(float(reports.geometry.number(entry.pressure_angle, u.ANGLE)))
        away = np.sign(at.radius) * np.array([-at.along[1], at.along[0]])
        return [(force * away).sum(axis=0) + np.abs((force * at.along).sum(axis=0)) * steep]

    def _reported(self, reports: JointReports, joint: str) -> _Reported:
        geometry = reports.geometry
        entry = geometry.mechanism.joints[joint]
        pinion, rack = entry.rack
        centre = reports.point_position(pinion, geometry.point(pinion, entry.centre))
        angle = float(geometry.number(entry.pitch_line.angle, u.ANGLE))
        along = reports.rotated(rack, (np.cos(angle), np.sin(angle)))
        apart = centre - reports.point_position(rack, geometry.point(rack, entry.pitch_line.point))
        left = np.array([-along[1], along[0]])
        off = (apart * left).sum(axis=0)
        radius = _stated_radius(reports, entry) * float(np.sign(off[0]))
        return _Reported((apart * along).sum(axis=0), off, along, centre - radius * left, radius)


def _stated_radius(reports: JointReports, entry: RackEntry) -> float:
    """The pinion's pitch radius (m): stated, or of a pitch of pi modules for each of the teeth around it."""
    if entry.radius is not None:
        return float(reports.geometry.number(entry.radius, u.LENGTH))
    pitch = np.pi * float(reports.geometry.number(entry.module, u.LENGTH))
    return float(reports.geometry.number(entry.teeth, u.PURE)) * pitch / (2 * np.pi)


class _Reported(NamedTuple):
    """Of a reported motion where the pinion's centre lies along and to the left of the line (m), the direction of that,
    the pitch point, the signed radius (m)."""

    along_line: Array
    off: Array
    along: Array
    place: Array
    radius: float
