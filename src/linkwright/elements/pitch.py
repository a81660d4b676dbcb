"""What two wheels share that turn on a carrier and drive each other: gears by their teeth, pulleys by a belt.

With r1 > 0 and r2 the pitch radii, r2 negative where both wheels turn the same way as seen from the carrier, and psi
the direction of the line of centres, which the carrier has:

    r1 (theta1 - psi) + r2 (theta2 - psi) = constant,

where the pose in which the links are drawn fixes the constant. The angles are continuous, over any number of turns; psi
is the carrier's angle, corrected by what its centres miss those of the wheels by, so that the equation is a function of
the wheels' places too and its multiplier (N) is the force along the pitch circles. By duality this force turns wheel 1
by r1 and wheel 2 by r2 times the multiplier about their centres, and (r1 + r2)/a times it pushes them across the line
of centres, a being the centre distance: of gears the tangential force at the pitch point, of a belt the difference of
the forces of its strands. Source: J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of Machines and Mechanisms, 4th
ed. (2011), ch. 7 and 9 (pitch circles; relative angles on a carrier, Willis' formula).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any, ClassVar, NamedTuple, Self

import numpy as np
from pydantic import BeforeValidator

from linkwright.data_classes import dataclass
from linkwright.elements.curves import Curve, circle, spoked
from linkwright.elements.entries import JointEntry
from linkwright.elements.fields import point_of_joint
from linkwright.elements.joint import (
    Array,
    Inner,
    JointGeometry,
    JointKind,
    JointReports,
    Miss,
    Rate,
    Reaction,
    Restated,
)
from linkwright.elements.mirror import Mirror
from linkwright.elements.pins import pins
from linkwright.elements.points import FRAME
from linkwright.expressions import units as u
from linkwright.expressions.fields import Name, pair
from linkwright.expressions.typed_fields import Ref
from linkwright.expressions.written import FaultWithin
from linkwright.findings import Joined
from linkwright.notation import Body, Jet, Pair, Scalar, Vec, Wrench
from linkwright.notation.jets import call


class WheelsEntry(JointEntry):
    """Two wheels on a carrier; the key that is named after the kind has the wheels."""

    signals = {
        "tangential": u.FORCE,
        "speed": u.SPEED,
        "power": u.POWER,
    }

    centres: Annotated[
        tuple[Annotated[Name, point_of_joint(0)], Annotated[Name, point_of_joint(1)]],
        BeforeValidator(pair("two-points")),
    ]
    carrier: Annotated[Name, Ref("link")] = FRAME

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same wheels seen in a mirror: all turn the other way round."""
        mirror.holds(*self.wheels, self.carrier)
        return self

    @property
    def wheels(self) -> tuple[str, str]:
        """Both wheels."""
        first, second = getattr(self, self.kind)
        return first, second

    @property
    def links(self) -> tuple[str, ...]:
        """The wheels; and the carrier, unless that is the frame, which doesn't turn."""
        return self.wheels if self.carrier == FRAME else (*self.wheels, self.carrier)

    @property
    def joint_points(self) -> tuple[str, ...]:
        return self.centres

    def carrier_points(self, mechanism: Any) -> list[str | None]:
        """The carrier's points at both centres; ``None`` where it isn't pinned to the wheel."""
        return [pinned_point(mechanism, self.carrier, end) for end in zip(self.wheels, self.centres, strict=True)]

    def name_faults(self, mechanism: Any) -> Iterator[FaultWithin]:
        """That the carrier is pinned to both wheels at their centres."""
        if self.carrier not in mechanism.links or self.carrier in self.wheels:
            if self.carrier in self.wheels and self.carrier != FRAME:
                yield "joint.same-link", {"name": self.carrier}
            return
        ends = [*zip(self.wheels, self.centres, strict=True)]
        if any(link not in mechanism.links or point not in mechanism.links[link].points for link, point in ends):
            return
        for (wheel, centre), found in zip(ends, self.carrier_points(mechanism), strict=True):
            if found is None:
                able = (link for link in mechanism.links if all(pinned_point(mechanism, link, end) for end in ends))
                data = {"carrier": self.carrier, "wheel": wheel, "centre": centre}
                yield "joint.carrier", {**data, "able": Joined(able) or "-"}, "carrier"
                return


def pinned_point(mechanism: Any, link: str, end: tuple[str, str]) -> str | None:
    """The point at which a link is pinned to a point of another; the point itself where it is the link's own."""
    if end[0] == link:
        return end[1]
    found = (pin.point(link) for pin in pins(mechanism).values() if end in pin.members and link in pin.links)
    return next(found, None)


def continuous_angle(body: Body) -> Scalar:
    """The angle (rad) of a link over any number of turns, which kinds that wind have (:attr:`JointKind.winds`)."""
    return body.angle


class Pitch(NamedTuple):
    """The dimensions of two wheels (m): the centres in their links, those of the carrier in its own, the signed radii;
    and how the carrier's line of centres lies in it (a vector, from the first centre to the second)."""

    centres: tuple[Pair, Pair]
    radii: tuple[Scalar, Scalar]
    line: Pair

    @property
    def distance(self) -> Scalar:
        """The centre distance (m)."""
        return call("sqrt", self.line.dot(self.line))

    def rolled(self, a: Scalar, b: Scalar, line: Scalar) -> Scalar:
        """What stays constant (m), by the angles of both wheels and of the line of centres (rad)."""
        first, second = self.radii
        return first * (a - line) + second * (b - line)


@dataclass(frozen=True)
class InnerWheels(Inner):
    """Two wheels, and their carrier unless it is the frame, as a closure; the drawing fixes the ``constant`` (m)."""

    pitch: Pitch
    constant: Scalar

    def apart(self, a: Body, b: Body) -> Vec:
        """From the first centre to the second."""
        first, second = self.pitch.centres
        return b.point(second).minus(a.point(first))

    def turned(self, bodies: Sequence[Body]) -> Scalar:
        """The angle of the line of centres (rad): the carrier's, and what the wheels' centres lie beside its own."""
        a, b = bodies[:2]
        away, line = self.apart(a, b).now, self.pitch.line
        if len(bodies) == 2:
            return call("arctan2", line.cross(away), line.dot(away))
        carrier = bodies[2]
        along = carrier.direction(line).now
        return carrier.angle + call("arctan2", along.cross(away), along.dot(away))

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        """Closure (m): what has passed at the pitch circle of one wheel but not at that of the other."""
        a, b = bodies[:2]
        now = self.pitch.rolled(a.angle, b.angle, self.turned(bodies)) - self.constant
        away = self.apart(a, b)
        if not away.x.order:
            return (Jet([now]),)
        rate = Vec(away.x.rate(), away.y.rate())
        line = away.cross(rate) / away.dot(away)
        first, second = self.pitch.radii
        speed = (a.turn - line) * first + (b.turn - line) * second
        return (Jet([now, *speed.d]),)

    def unit(self, a: Body, b: Body) -> tuple[Pair, Pair]:
        """The direction from the first centre to the second, and across it to the left."""
        away = self.apart(a, b).now
        size = away.length
        along = Pair(away.x / size, away.y / size)
        return along, along.perp

    def pulled(self, bodies: Sequence[Body], force: Scalar) -> list[Wrench]:
        """A force (N) that pulls the wheels towards each other at their centres; nothing on the carrier."""
        a, b, *carrier = bodies
        along, _ = self.unit(a, b)
        pull = Wrench(Pair(force * along.x, force * along.y), 0.0, a.point(self.pitch.centres[0]).now)
        return [pull, pull.opposite, *(Wrench.zero(body.anchor.now) for body in carrier)]


class WheelsKind(JointKind):
    """What kinds of two wheels on a carrier share: the closure, signals, drawing and proof on pitch circles."""

    row_units = ("length",)
    phased = True
    winds = True
    orders: ClassVar[Mapping[str, int]] = {"tangential": 2, "speed": 1, "power": 2}

    def radii(self, geometry: JointGeometry, joint: str, distance: Scalar) -> tuple[Scalar, Scalar]:
        """The signed pitch radii (m) of an entry at a centre distance (m)."""
        raise NotImplementedError

    def closure(self, geometry: JointGeometry, joint: str, pitch: Pitch, constant: Scalar) -> InnerWheels:
        """The closure with what comes beside its force."""
        return InnerWheels(pitch, constant)

    def pitch(self, geometry: JointGeometry, joint: str) -> Pitch:
        """The dimensions of a joint."""
        entry = geometry.mechanism.joints[joint]
        (a, b), (at, to) = entry.wheels, entry.centres
        first, second = entry.carrier_points(geometry.mechanism)
        line = geometry.point(entry.carrier, second).minus(geometry.point(entry.carrier, first))
        distance = line.length
        return Pitch((geometry.point(a, at), geometry.point(b, to)), self.radii(geometry, joint, distance), line)

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerWheels:
        pitch = self.pitch(geometry, joint)
        constant = pitch.rolled(*(geometry.phases(joint) or (0.0, 0.0, 0.0)))
        across = geometry.play(joint, "across")  # by which the first wheel has run ahead
        return self.closure(geometry, joint, pitch, constant + across)

    def phase(self, geometry: JointGeometry, joint: str, bodies: Mapping[str, Body]) -> tuple[float, ...]:
        inner = InnerWheels(self.pitch(geometry, joint), 0.0)
        poses = [bodies[link] for link in geometry.mechanism.joints[joint].links]
        first, second = (float(continuous_angle(pose)) for pose in poses[:2])
        return first, second, float(inner.turned(poses))

    def signal(
        self, geometry: JointGeometry, joint: str, attribute: str, bodies: Mapping[str, Body], reaction: Reaction
    ) -> Scalar:
        entry = geometry.mechanism.joints[joint]
        inner = self.inner(geometry, joint, entry.links)
        a, b = (bodies[wheel] for wheel in entry.wheels)
        if attribute == "speed":
            return self.pitch_speed(geometry, joint, inner, bodies)
        # The moment about its centre that the first wheel passes on.
        moment = reaction(entry.wheels[0]).at(a.point(inner.pitch.centres[0]).now).moment
        tangential = moment / inner.pitch.radii[0]
        if attribute == "tangential":
            return tangential
        if attribute == "power":
            return tangential * self.pitch_speed(geometry, joint, inner, bodies)
        return self.force_signal(geometry, joint, attribute, inner, (a, b), tangential)

    def pitch_speed(
        self, geometry: JointGeometry, joint: str, inner: InnerWheels, bodies: Mapping[str, Body]
    ) -> Scalar:
        """The speed (m/s) of the pitch circles as seen from the carrier, positive where the first wheel turns to the
        left."""
        entry = geometry.mechanism.joints[joint]
        return (bodies[entry.wheels[0]].turn.d[0] - bodies[entry.carrier].turn.d[0]) * inner.pitch.radii[0]

    def force_signal(
        self,
        geometry: JointGeometry,
        joint: str,
        attribute: str,
        inner: InnerWheels,
        wheels: tuple[Body, Body],
        tangential: Scalar,
    ) -> Scalar:
        """A signal that follows from the tangential force (N)."""
        raise NotImplementedError

    def outline(self, geometry: JointGeometry, joint: str, low: Scalar, high: Scalar) -> list[Curve]:
        """Both pitch circles, each with a spoke, from which its turning is seen; on the frame without one."""
        entry, pitch = geometry.mechanism.joints[joint], self.pitch(geometry, joint)
        found: list[Curve] = []
        for link, at, radius in zip(entry.wheels, pitch.centres, pitch.radii, strict=True):
            size = call("abs", radius)
            found += [circle(link, at, size)] if link == FRAME else spoked(link, at, size)
        return found

    # The proof: angles of wheels and carrier once more from reported directions and rates, forces from those reported.

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        ends, radii = self.reported(reports, joint)
        away = ends[1] - ends[0]
        entry = reports.geometry.mechanism.joints[joint]
        a, b = (reports.turned(link) for link in entry.wheels)
        line = reports.turned(entry.carrier)
        apart = np.hypot(*away)
        missed = radii[0] * (a - line) + radii[1] * (b - line)
        # Of the time before the first pose the directions alone are known: the wheels pass what they passed since then.
        return [Miss(missed - missed[0], length=True), Miss(apart - apart[0], length=True)]

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        # A point of each wheel at its pitch circle moves along it as much as that of the other, where the line of
        # centres stands still: r1 omega1 + r2 omega2, and the centres' velocities across over the distance.
        (start, end), (first, second) = self.reported(reports, joint)
        _, across, apart = of_line(start, end)
        total = (first + second) / float(apart[0])
        a, b = reports.geometry.mechanism.joints[joint].wheels
        return [[Rate(a, first), Rate(b, second), Rate(a, total, start, across), Rate(b, -total, end, across)]]

    def restated(self, reports: JointReports, joint: str) -> dict[str, Restated]:
        """The speed is that of the first wheel's material at its pitch circle as the carrier sees it, the power that of
        the force there, and the tangential force from the moment about the first wheel's centre."""
        entry, own = reports.geometry.mechanism.joints[joint], self.reported(reports, joint)
        (start, end), (first, _) = own
        along, across, _ = of_line(start, end)
        place = start + first * along
        seen = reports.velocity(entry.wheels[0], place) - reports.velocity(entry.carrier, place)
        speed = (seen * across).sum(axis=0)
        moment = self.driving_moment(reports, joint)
        return {
            "speed": Restated(speed),
            "tangential": Restated(moment / first),
            "power": Restated(moment * (reports.omega(entry.wheels[0]) - reports.omega(entry.carrier))),
            **self.restated_forces(reports, joint, moment / first),
        }

    def driving_moment(self, reports: JointReports, joint: str) -> Array:
        """The moment (N m) about its centre that the first wheel passes on, from the reported reaction."""
        raise NotImplementedError

    def restated_forces(self, reports: JointReports, joint: str, tangential: Array) -> dict[str, Restated]:
        """The signals of :meth:`force_signal` once more."""
        raise NotImplementedError

    def stated_radii(self, reports: JointReports, joint: str, distance: float) -> tuple[float, float]:
        """The signed pitch radii (m) by the file's numbers, by another formula than :meth:`radii`'s."""
        raise NotImplementedError

    def on_carrier(self, reports: JointReports, joint: str) -> list[Array]:
        """The force (N) that a moving carrier is reported to get of the wheels, which is none."""
        entry = reports.geometry.mechanism.joints[joint]
        if entry.carrier not in entry.links or entry.carrier in entry.wheels:
            return []
        return [*np.asarray(reports.reaction(reports.contact(joint, entry.carrier))[0])]

    def reported(self, reports: JointReports, joint: str) -> tuple[tuple[Array, Array], tuple[float, float]]:
        """The centres of both wheels in the frame (2, times), and the signed radii (m)."""
        geometry = reports.geometry
        entry = geometry.mechanism.joints[joint]
        start, end = (
            reports.point_position(link, geometry.point(link, point))
            for link, point in zip(entry.wheels, entry.centres, strict=True)
        )
        return (start, end), self.stated_radii(reports, joint, float(np.hypot(*(end - start)[:, 0])))


def of_line(start: Array, end: Array) -> tuple[Array, Array, Array]:
    """The direction of a line from start to end, that across it to the left, and its length."""
    away = end - start
    apart = np.hypot(*away)
    across = np.array([-away[1], away[0]]) / apart
    return np.array([across[1], -across[0]]), across, apart
