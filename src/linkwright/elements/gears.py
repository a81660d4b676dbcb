"""Gears in mesh: two spur gears on a carrier, external or one of them a ring; with the forces of their teeth.

The ratio is that of the teeth, or of the pitch radii. The gears roll on their working pitch circles, which divide the
actual centre distance a in this ratio. The force of the teeth acts at the pitch point along the line of action, which
has the working pressure angle to the common tangent there: on the flank that drives, so that it pushes external gears
apart whichever way the torque acts (and a gear in a ring towards the ring's centre),

    T the tangential force,   |T| tan(alpha_w) the separating force,   |T|/cos(alpha_w) the force of the teeth.

With teeth and module alpha_w follows from the reference pressure angle alpha and the centre distance of gears without
profile shift a0 = module (z2 +- z1)/2: cos(alpha_w) = a0 cos(alpha)/a. Otherwise ``pressure_angle`` is alpha_w itself.
There is no friction between the teeth. Backlash is a clearance of the accuracy study, half of it to either side along
the pitch circles; motion and forces are those of teeth that bear on both flanks.

Sources: ISO 21771 (2007; working pitch circles, working pressure angle); G. Niemann, H. Winter, Maschinenelemente II
(2003), ch. 21; J. E. Shigley, C. R. Mischke, Mechanical Engineering Design, 5th ed. (1989), ch. 13 (forces of teeth).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import BeforeValidator

from linkwright.data_classes import dataclass
from linkwright.elements.clearance import OnFlank, StatedClearance
from linkwright.elements.entries import NumberFault, StatedPlaces
from linkwright.elements.fields import TwoLinks
from linkwright.elements.joint import Applied, Array, ContactReaction, JointGeometry, JointReports, Restated, register
from linkwright.elements.pitch import InnerWheels, Pitch, WheelsEntry, WheelsKind, of_line
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name, Two, pair
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.expressions.written import FaultWithin
from linkwright.notation import Body, Pair, Scalar, Wrench
from linkwright.notation.jets import call, is_zero

EXACT, VARIED = 1e-6, 1e-2
"""By how much of itself the centre distance may differ from that of the radii, where both are nominal, and where
dimensions vary by tolerances: the gears then keep their ratio on working pitch circles."""
SHIFTED = 1.0
"""By how many modules the centre distance may differ from that of gears without profile shift."""
MESH_SIGNALS = {
    "tangential": u.FORCE,
    "separating": u.FORCE,
    "force": u.FORCE,
    "speed": u.SPEED,
    "power": u.POWER,
}
"""The signals of teeth in mesh."""
WHOLE = 1e-9
"""Numbers of teeth are whole but for this."""


class GearsEntry(WheelsEntry):
    """Two gears in mesh."""

    kind: ClassVar[str] = "gears"
    signals = MESH_SIGNALS

    gears: TwoLinks
    teeth: Annotated[
        Annotated[Two, BeforeValidator(pair("two-numbers"))] | None,
        Quantity(u.PURE, Sign.POSITIVE, "teeth", whole=True),
    ] = None
    radii: Annotated[
        Annotated[Two, BeforeValidator(pair("two-radii"))] | None, Quantity(u.LENGTH, Sign.POSITIVE, "pitch-radius")
    ] = None
    module: Annotated[Expression | None, Quantity(u.LENGTH, Sign.POSITIVE, "module")] = None
    internal: Annotated[Name | None, Ref("link")] = None
    pressure_angle: Annotated[Expression, Quantity(u.ANGLE, Sign.NOT_NEGATIVE, "pressure-angle")] = Expression("20 deg")

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[FaultWithin]:
        sizes = [key for key in ("teeth", "radii") if key in given]
        if len(sizes) != 1:
            yield "gears.size", {"given": " ".join(sizes) or "-"}
        elif "module" in given and "teeth" not in given:
            yield "gears.module", {}, "module"
        ring, gears = given.get("internal"), given.get("gears")
        if isinstance(ring, str) and isinstance(gears, list | tuple) and ring not in gears:
            yield "gears.internal", {"name": ring, "gears": ", ".join(map(str, gears[:2]))}, "internal"

    @property
    def kinks(self) -> tuple[str, ...]:
        return ("tangential",)

    @property
    def signs(self) -> tuple[float, float]:
        """The signs of both pitch radii."""
        return 1.0, -1.0 if self.internal else 1.0

    @property
    def inner(self) -> int:
        """Which of the gears lies in the ring."""
        return 1 - self.gears.index(self.internal) if self.internal else 0

    def sizes(self, numbers: Any) -> tuple[Scalar, Scalar]:
        """The teeth or radii of both, of which the ratio counts; ``numbers`` gives values."""
        of, dimension = (self.teeth, u.PURE) if self.teeth is not None else (self.radii, u.LENGTH)
        assert of is not None
        first, second = (numbers.number(one, dimension) for one in of)
        return first, second

    def total(self, sizes: tuple[Scalar, Scalar]) -> Scalar:
        """What both make together: their sum, of a gear in a ring what the ring has more."""
        if self.internal is None:
            return sizes[0] + sizes[1]
        return sizes[1 - self.inner] - sizes[self.inner]

    def reference_distance(self, numbers: Any) -> Scalar | None:
        """The centre distance (m) of gears of this module without profile shift; ``None`` without a module."""
        if self.module is None:
            return None
        return numbers.number(self.module, u.LENGTH) * self.total(self.sizes(numbers)) / 2.0

    def line_of_action(self, numbers: Any, distance: Scalar) -> tuple[Scalar, Scalar]:
        """Cosine and tangent of the working pressure angle at a centre distance (m)."""
        alpha, reference = numbers.number(self.pressure_angle, u.ANGLE), self.reference_distance(numbers)
        if reference is None:
            return call("cos", alpha), call("tan", alpha)
        cosine = call("cos", alpha) * reference / distance
        return cosine, call("sqrt", 1.0 - cosine * cosine) / cosine

    def place_faults(self, places: StatedPlaces, nominal: bool) -> Iterator[NumberFault]:
        sizes = self.sizes(places)
        total = self.total(sizes)
        key = "radii" if self.teeth is None else "teeth"
        if self.internal is not None:
            yield total, Sign.POSITIVE, ("gears.ring", {"ring": self.internal}, key)
        if nominal and self.teeth is not None:
            off = max(abs(size - np.round(size)) for size in sizes)
            yield WHOLE - off, Sign.POSITIVE, ("gears.whole", {}, key)
        alpha = places.number(self.pressure_angle, u.ANGLE)
        for margin in (np.pi / 2 - alpha, alpha if self.module is not None else 1.0):
            yield margin - WHOLE, Sign.POSITIVE, ("gears.pressure", {}, "pressure_angle")
        ends = self.carrier_points(places.mechanism) if self.carrier in places.mechanism.links else [None]
        if None in ends:
            return
        first, second = (places.point(self.carrier, str(point)) for point in ends)
        away = second.minus(first)
        distance = away.length
        data = {"carrier": self.carrier, "distance": places.text_of(distance, u.LENGTH)}
        yield distance, Sign.POSITIVE, ("gears.concentric", data, "centres")
        if self.radii is not None:
            data = {**data, "radii": places.text_of(total, u.LENGTH)}
            off, slack = call("abs", distance - total), EXACT if nominal else VARIED
            yield slack * distance - off, Sign.NOT_NEGATIVE, ("gears.distance", data, "radii")
        reference = self.reference_distance(places)
        if reference is not None:
            assert self.module is not None
            module = places.number(self.module, u.LENGTH)
            data = {**data, "reference": places.text_of(reference, u.LENGTH)}
            off = call("abs", distance - reference)
            yield SHIFTED * module * (1 + EXACT) - off, Sign.NOT_NEGATIVE, ("gears.shift", data, "module")
            margin = distance - reference * call("cos", alpha)
            yield margin, Sign.POSITIVE, ("gears.shift", data, "module")


@dataclass(frozen=True)
class InnerGears(InnerWheels):
    """Gears as a closure; ``steep`` is the tangent of the working pressure angle, negative where one is a ring."""

    steep: Scalar = 0.0

    def besides(self, bodies: Sequence[Body], multipliers: Sequence[Scalar]) -> list[Wrench]:
        """The separating force, between the centres: the tangential force, of either sign, times the tangent."""
        if is_zero(self.steep):
            return []
        return self.pulled(bodies, -call("abs", multipliers[0]) * self.steep)


@register
class Gears(WheelsKind):
    """Two gears in mesh on a carrier."""

    name = "gears"
    letter = "G"
    entry = GearsEntry
    plays = ()
    orders: ClassVar[Mapping[str, int]] = {**WheelsKind.orders, "separating": 2, "force": 2}

    def play(self, geometry: JointGeometry, joint: str, links: Sequence[str], stated: StatedClearance) -> list[OnFlank]:
        """Backlash along the pitch circles: the first gear has run ahead of the second where it pushes that way."""
        a, b = links[:2]
        return [OnFlank(joint, (b, a), stated.clearance, f"{joint}.tangential")]

    def radii(self, geometry: JointGeometry, joint: str, distance: Scalar) -> tuple[Scalar, Scalar]:
        entry = geometry.mechanism.joints[joint]
        sizes = entry.sizes(geometry)
        one = distance / entry.total(sizes)
        first, second = (sign * size * one for sign, size in zip(entry.signs, sizes, strict=True))
        return first, second

    def closure(self, geometry: JointGeometry, joint: str, pitch: Pitch, constant: Scalar) -> InnerGears:
        entry = geometry.mechanism.joints[joint]
        _, steep = entry.line_of_action(geometry, pitch.distance)
        return InnerGears(pitch, constant, -steep if entry.internal else steep)

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        """The pitch point."""
        entry, pitch = geometry.mechanism.joints[joint], self.pitch(geometry, joint)
        (a, b), (first, second) = (bodies[wheel] for wheel in entry.wheels), pitch.radii
        start = a.point(pitch.centres[0]).now
        away, share = b.point(pitch.centres[1]).now.minus(start), first / (first + second)
        return Pair(start.x + share * away.x, start.y + share * away.y)

    def force_signal(
        self,
        geometry: JointGeometry,
        joint: str,
        attribute: str,
        inner: InnerWheels,
        wheels: tuple[Body, Body],
        tangential: Scalar,
    ) -> Scalar:
        cosine, steep = geometry.mechanism.joints[joint].line_of_action(geometry, inner.pitch.distance)
        size = call("abs", tangential)
        return size / cosine if attribute == "force" else size * steep

    def stated_radii(self, reports: JointReports, joint: str, distance: float) -> tuple[float, float]:
        """The pitch point divides the line of centres, within it or beyond, in the ratio of both sizes."""
        entry, number = reports.geometry.mechanism.joints[joint], reports.geometry.number
        stated, dimension = (entry.radii, u.LENGTH) if entry.teeth is None else (entry.teeth, u.PURE)
        ratio = float(number(stated[1], dimension)) / float(number(stated[0], dimension))
        first = distance / abs(1.0 - ratio) if entry.internal else distance / (1.0 + ratio)
        return first, -first * ratio if entry.internal else first * ratio

    def driving_moment(self, reports: JointReports, joint: str) -> Array:
        entry = reports.geometry.mechanism.joints[joint]
        (start, end), (first, second) = self.reported(reports, joint)
        force = np.asarray(reports.reaction(reports.contact(joint, entry.wheels[0]))[0])
        arm = first / (first + second) * (end - start)  # to the pitch point, where the teeth push
        return np.asarray(arm[0] * force[1] - arm[1] * force[0])

    def restated_forces(self, reports: JointReports, joint: str, tangential: Array) -> dict[str, Restated]:
        """The whole force is that of the reported reaction, and what is left of it across the pitch circles separates
        the gears."""
        entry = reports.geometry.mechanism.joints[joint]
        along, _, _ = of_line(*self.reported(reports, joint)[0])
        force = np.asarray(reports.reaction(reports.contact(joint, entry.wheels[0]))[0])
        return {"force": Restated(np.hypot(*force)), "separating": Restated(np.abs((force * along).sum(axis=0)))}

    def applied(self, reports: JointReports, contact: ContactReaction) -> Applied:
        # Reported is the force of the link on the others; what it gets is the opposite, at the pitch point.
        (start, end), (first, second) = self.reported(reports, contact.joint)
        place = start + first / (first + second) * (end - start)
        return contact.link, -np.asarray(reports.reaction(contact)[0]), place, 0.0

    def misfits(self, reports: JointReports, joint: str) -> list[Array]:
        """By what the force between the centres misses the tangential one times the tangent of the pressure angle."""
        entry = reports.geometry.mechanism.joints[joint]
        (start, end), _ = self.reported(reports, joint)
        along, across, apart = of_line(start, end)
        force = np.asarray(reports.reaction(reports.contact(joint, entry.wheels[0]))[0])
        tangential, pushes = (force * across).sum(axis=0), (force * along).sum(axis=0)
        alpha = float(reports.geometry.number(entry.pressure_angle, u.ANGLE))
        if entry.module is not None:  # base circles keep their radii: the working pressure angle follows
            base = float(reports.geometry.number(entry.module, u.LENGTH)) / 2 * np.cos(alpha)
            teeth = [float(reports.geometry.number(size, u.PURE)) for size in entry.teeth]
            alpha = np.arccos(base * (abs(teeth[0] - teeth[1]) if entry.internal else sum(teeth)) / apart)
        steep = np.tan(alpha) * (-1.0 if entry.internal else 1.0)
        return [pushes - np.abs(tangential) * steep, *self.on_carrier(reports, joint)]
