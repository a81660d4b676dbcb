"""Belts and chains: two wheels on a carrier, tied by a belt that is open or crossed; with the forces of both strands.

The belt doesn't slip or stretch: r1 (theta1 - psi) -+ r2 (theta2 - psi) stays constant, minus where it is open. With
the tangential force T that the first wheel passes on, the strand that leaves it on the left of the line of centres
(seen from the first wheel) carries more than the other one by T. What both carry together depends on the pretension
F0 of a strand at rest:

    with pretension  F0 + T/2 and F0 - T/2, as long as none is slack (an elastic belt keeps its length);
    without          |T| in one and nothing in the other: a chain, or a toothed belt, whose loose side hangs.

The wheels are pulled together by the sum times cos(beta), and across the line of centres by T sin(beta), where
sin(beta) = (r1 - r2)/a for an open and (r1 + r2)/a for a crossed belt. A friction belt slips where the ratio of its
strands passes exp(mu phi), phi being the smaller angle of wrap (Eytelwein); the weight and the centrifugal force of
the belt are left out. Source: R. S. Khurmi, J. K. Gupta, Theory of Machines, 14th ed. (2005), ch. 11; J. L. Meriam,
L. G. Kraige, Engineering Mechanics: Statics, 7th ed. (2012), 6/8 (flexible belts)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import BeforeValidator

from linkwright.data_classes import dataclass
from linkwright.elements.curves import Curve, polygon
from linkwright.elements.entries import NumberFault, StatedPlaces
from linkwright.elements.fields import TwoLinks
from linkwright.elements.joint import Applied, Array, ContactReaction, JointGeometry, JointReports, Restated, register
from linkwright.elements.pitch import InnerWheels, Pitch, WheelsEntry, WheelsKind, of_line
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Two, pair
from linkwright.expressions.typed_fields import Quantity, Sign
from linkwright.expressions.written import FaultWithin
from linkwright.notation import Body, Pair, Scalar, Wrench
from linkwright.notation.jets import call, is_zero

STRANDS = {"left": u.FORCE, "right": u.FORCE}


class BeltEntry(WheelsEntry):
    """Two wheels tied by a belt or a chain."""

    kind: ClassVar[str] = "belt"
    couple: ClassVar[bool] = True
    lifts: ClassVar[Mapping[str, str]] = {"left": "belt.slack", "right": "belt.slack", "reserve": "belt.slips"}

    belt: TwoLinks
    radii: Annotated[
        Annotated[Two, BeforeValidator(pair("two-radii"))] | None, Quantity(u.LENGTH, Sign.POSITIVE, "pitch-radius")
    ] = None
    teeth: Annotated[
        Annotated[Two, BeforeValidator(pair("two-numbers"))] | None,
        Quantity(u.PURE, Sign.POSITIVE, "teeth", whole=True),
    ] = None
    pitch: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE, "pitch")] = None
    crossed: bool = False
    pretension: Annotated[Expression | None, Quantity(u.FORCE, Sign.POSITIVE, "pretension")] = None
    friction: Annotated[Expression | None, Quantity(u.PURE, Sign.POSITIVE, "friction-coefficient")] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[FaultWithin]:
        sizes = [key for key in ("radii", "teeth", "pitch") if key in given]
        if sizes not in (["radii"], ["teeth", "pitch"]):
            yield "belt.size", {"given": " ".join(sizes) or "-"}
        if "friction" in given and "pretension" not in given:
            yield "belt.friction", {}, "friction"

    @property
    def signals(self) -> Mapping[str, u.Dimension]:  # type: ignore[override]
        found = {"tangential": u.FORCE, **STRANDS, "speed": u.SPEED, "power": u.POWER}
        return found if self.friction is None else {**found, "reserve": u.FORCE}

    @property
    def kinks(self) -> tuple[str, ...]:
        return ("tangential",)

    @property
    def one_sided(self) -> Mapping[str, int]:
        if self.pretension is None:
            return {}
        return {"left": 1, "right": 1} if self.friction is None else {"left": 1, "right": 1, "reserve": 1}

    def sizes(self, numbers: Any) -> tuple[Scalar, Scalar]:
        """Both pitch radii (m); ``numbers`` gives values."""
        if self.radii is not None:
            first, second = (numbers.number(one, u.LENGTH) for one in self.radii)
            return first, second
        assert self.teeth is not None
        assert self.pitch is not None
        unit = numbers.number(self.pitch, u.LENGTH) / (2.0 * np.pi)
        first, second = (numbers.number(one, u.PURE) * unit for one in self.teeth)
        return first, second

    def place_faults(self, places: StatedPlaces, nominal: bool) -> Iterator[NumberFault]:
        if self.carrier not in places.mechanism.links:
            return
        first, second = self.carrier_points(places.mechanism)
        if first is None or second is None:
            return
        away = places.point(self.carrier, second).minus(places.point(self.carrier, first))
        distance, sizes = away.length, self.sizes(places)
        texts = {"distance": places.text_of(distance, u.LENGTH), "radii": places.text_of(sizes[0] + sizes[1], u.LENGTH)}
        yield distance - sizes[0] - sizes[1], Sign.POSITIVE, ("belt.distance", texts, "centres")


@dataclass(frozen=True)
class InnerBelt(InnerWheels):
    """A belt as a closure; ``lean`` is the cosine of the strands' angle to the line of centres, ``pretension`` (N)
    that of a strand, ``None`` where one of them is slack."""

    lean: Scalar = 1.0
    pretension: Scalar | None = None

    def carried(self, tangential: Scalar) -> Scalar:
        """What both strands carry together (N)."""
        return call("abs", tangential) if self.pretension is None else 2.0 * self.pretension

    def besides(self, bodies: Sequence[Body], multipliers: Sequence[Scalar]) -> list[Wrench]:
        """What the strands carry together pulls the centres towards each other."""
        return self.pulled(bodies, self.carried(multipliers[0]) * self.lean)


@register
class Belt(WheelsKind):
    """A belt or chain over two wheels."""

    name = "belt"
    letter = "B"
    entry = BeltEntry
    orders: ClassVar[Mapping[str, int]] = {**WheelsKind.orders, "left": 2, "right": 2, "reserve": 2}

    def radii(self, geometry: JointGeometry, joint: str, distance: Scalar) -> tuple[Scalar, Scalar]:
        entry = geometry.mechanism.joints[joint]
        first, second = entry.sizes(geometry)
        return first, second if entry.crossed else -second

    def closure(self, geometry: JointGeometry, joint: str, pitch: Pitch, constant: Scalar) -> InnerBelt:
        entry, sine = geometry.mechanism.joints[joint], (pitch.radii[0] + pitch.radii[1]) / pitch.distance
        pretension = None if entry.pretension is None else geometry.number(entry.pretension, u.FORCE)
        lean = 1.0 if is_zero(sine) else call("sqrt", 1.0 - sine * sine)
        return InnerBelt(pitch, constant, lean, pretension)

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        """The wheel's centre; of the carrier that of the first wheel."""
        entry = geometry.mechanism.joints[joint]
        own = entry.wheels.index(link) if link in entry.wheels else 0
        wheel = entry.wheels[own]
        return bodies[wheel].point(geometry.point(wheel, entry.centres[own])).now

    def force_signal(
        self,
        geometry: JointGeometry,
        joint: str,
        attribute: str,
        inner: InnerWheels,
        wheels: tuple[Body, Body],
        tangential: Scalar,
    ) -> Scalar:
        assert isinstance(inner, InnerBelt)
        entry = geometry.mechanism.joints[joint]
        carried = inner.carried(tangential)
        if attribute != "reserve":
            return (carried + tangential if attribute == "left" else carried - tangential) / 2.0
        lean = call("arcsin", (inner.pitch.radii[0] + inner.pitch.radii[1]) / inner.pitch.distance)
        wrap = np.pi + 2.0 * lean if entry.crossed else np.pi - 2.0 * call("abs", lean)
        # (exp(mu phi) - 1)/(exp(mu phi) + 1), which is at most 1 however large the coefficient is.
        ratio = call("exp", -(geometry.number(entry.friction, u.PURE) * wrap))
        return carried * (1.0 - ratio) / (1.0 + ratio) - call("abs", tangential)

    def outline(self, geometry: JointGeometry, joint: str, low: Scalar, high: Scalar) -> list[Curve]:
        """Both wheels; on the carrier both strands, as lines that touch them."""
        entry, pitch = geometry.mechanism.joints[joint], self.pitch(geometry, joint)
        (first, second), line, size = pitch.radii, pitch.line, pitch.distance
        at = geometry.point(entry.carrier, entry.carrier_points(geometry.mechanism)[0])
        sine = (first + second) / size
        cosine = call("sqrt", 1.0 - sine * sine)
        drawn = super().outline(geometry, joint, low, high)
        for side in (1.0, -1.0):
            # From a centre to where the strand touches.
            x, y = ((sine * a + side * cosine * b) / size for a, b in zip(line, line.perp, strict=True))
            ends = (
                Pair(at.x + first * x, at.y + first * y),
                Pair(at.x + line.x - second * x, at.y + line.y - second * y),
            )
            drawn.append(polygon(entry.carrier, ends))
        return drawn

    def stated_radii(self, reports: JointReports, joint: str, distance: float) -> tuple[float, float]:
        """Stated, or by the teeth that fill a circumference."""
        entry, number = reports.geometry.mechanism.joints[joint], reports.geometry.number
        if entry.radii is not None:
            first, second = (float(number(one, u.LENGTH)) for one in entry.radii)
        else:
            around = (float(number(one, u.PURE)) * float(number(entry.pitch, u.LENGTH)) for one in entry.teeth)
            first, second = (length / (2 * np.pi) for length in around)
        return first, second if entry.crossed else -second

    def driving_moment(self, reports: JointReports, joint: str) -> Array:
        wheel = reports.geometry.mechanism.joints[joint].wheels[0]
        return np.asarray(reports.reaction(reports.contact(joint, wheel))[1])

    def restated_forces(self, reports: JointReports, joint: str, tangential: Array) -> dict[str, Restated]:
        """Both strands touch both wheels: along the line of centres they pull with the cosine of their slope, and about
        the first centre with its radius and opposite senses. A strand slips where the other is exp(mu phi) times as
        strong, phi being the angle over which it wraps the wheel that it wraps less."""
        entry = reports.geometry.mechanism.joints[joint]
        ends, (first, second) = self.reported(reports, joint)
        along, _, apart = of_line(*ends)
        force = np.asarray(reports.reaction(reports.contact(joint, entry.wheels[0]))[0])
        slope = np.arccos((first + second) / apart)  # between the line of centres and the radius to where it touches
        carried = -(force * along).sum(axis=0) / np.sin(slope)
        strands = {"left": Restated((carried + tangential) / 2), "right": Restated((carried - tangential) / 2)}
        if entry.friction is None:
            return strands
        wrap = 2 * (np.pi - slope) if entry.crossed else 2 * np.minimum(slope, np.pi - slope)
        grip = np.tanh(float(reports.geometry.number(entry.friction, u.PURE)) * wrap / 2)
        return {**strands, "reserve": Restated(carried * grip - np.abs(tangential))}

    def applied(self, reports: JointReports, contact: ContactReaction) -> Applied:
        # Reported are the link's force on the others and its moment about the wheel's centre; it gets the opposite.
        entry = reports.geometry.mechanism.joints[contact.joint]
        ends, _ = self.reported(reports, contact.joint)
        own = entry.wheels.index(contact.link) if contact.link in entry.wheels else 0
        force, moment = reports.reaction(contact)
        return contact.link, -np.asarray(force), ends[own], -moment

    def misfits(self, reports: JointReports, joint: str) -> list[Array]:
        """By what the reported forces and moments miss those of two strands that touch both wheels."""
        entry = reports.geometry.mechanism.joints[joint]
        (start, end), (first, second) = self.reported(reports, joint)
        along, across, apart = of_line(start, end)
        (force, moment), (back, other) = (reports.reaction(reports.contact(joint, wheel)) for wheel in entry.wheels)
        tangential, sine = np.asarray(moment) / first, (first + second) / apart
        carried = np.abs(tangential)
        if entry.pretension is not None:
            carried = np.full_like(carried, 2.0 * float(reports.geometry.number(entry.pretension, u.FORCE)))
        return [
            (force * along).sum(axis=0) + carried * np.sqrt(1.0 - sine**2),
            (force * across).sum(axis=0) - tangential * sine,
            np.asarray(other) / second - tangential,
            *np.asarray(force + back),
            *self.on_carrier(reports, joint),
        ]
