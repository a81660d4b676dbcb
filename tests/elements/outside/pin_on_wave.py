"""A kind of joint of another package, in one file: a point of one link on a sine-shaped edge of another, one row over
two links, which can only push and may have play.

The edge is y = h sin(2 pi x / l) over a line of its link; normals are those to the left of growing x, upwards.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import BeforeValidator, Field

from linkwright.elements import Inner, JointKind, register
from linkwright.elements.clearance import OnFlank, StatedClearance
from linkwright.elements.curves import Curve
from linkwright.elements.entries import JointEntry
from linkwright.elements.joint import Miss, Rate
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, LineOn, Name
from linkwright.expressions.typed_fields import Quantity, Sign
from linkwright.notation import Body, Jet, Pair
from linkwright.notation.jets import call
from linkwright.notation.planar import unit_vector


class WaveEntry(JointEntry):
    """A point of the first link on an edge of the second."""

    kind: ClassVar[str] = "pin_on_wave"
    signals = {"s": u.LENGTH, "v": u.SPEED, "force": u.FORCE}
    one_sided: ClassVar[Mapping[str, int]] = {"force": 1}  # type: ignore[assignment]

    pin_on_wave: Annotated[tuple[Name, Name], BeforeValidator(tuple)] = Field(description="the links")
    pin: Name = Field(description="the point of the first link")
    along: LineOn = Field(description="the line of the second link")
    height: Annotated[Expression, Quantity(u.LENGTH)] = Field(description="height of the wave")
    length: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE, "length")] = Field(description="length of the wave")

    @property
    def joint_points(self) -> tuple[str, ...]:
        return self.pin, self.along.point


class OnWave(Inner):
    def __init__(self, pin: Pair, base: Pair, heading: Pair, height: Any, per: Any, off: Any) -> None:
        self.pin, self.base, self.heading, self.height, self.per, self.off = pin, base, heading, height, per, off

    def local(self, a: Body, b: Body) -> tuple[Jet, Jet]:
        """The point's coordinates over the line."""
        away, along = a.point(self.pin).minus(b.point(self.base)), b.direction(self.heading)
        return away.dot(along), away.dot(along.perp)

    def normal(self, x: Any) -> Pair:
        slope = self.height * self.per * call("cos", x * self.per)
        size = call("sqrt", 1.0 + slope * slope)
        return Pair(-slope / size, 1.0 / size)

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        x, y = self.local(*bodies)
        up = y - (x * self.per).sin() * self.height
        share = self.normal(x.d[0]).y  # of the distance along the normal in that upwards
        return (Jet([share * up.d[0] - self.off, *(share * rate for rate in up.d[1:])]),)


@register
class PinOnWave(JointKind):
    """A point on a wave."""

    name = "pin_on_wave"
    letter = "W"
    row_units = ("length",)
    plays = ()
    entry = WaveEntry
    orders = {"s": 0, "v": 1, "force": 2}
    words = {"en": {"term.kind-pin_on_wave": "pin on a wave"}}

    def inner(self, geometry: Any, joint: str, links: Sequence[str]) -> OnWave:
        entry, (a, b) = geometry.mechanism.joints[joint], links
        base, heading = geometry.point(b, entry.along.point), unit_vector(geometry.number(entry.along.angle, u.ANGLE))
        height, per = geometry.number(entry.height, u.LENGTH), 2 * math.pi / geometry.number(entry.length, u.LENGTH)
        return OnWave(geometry.point(a, entry.pin), base, heading, height, per, geometry.play(joint, "across"))

    def play(self, geometry: Any, joint: str, links: Sequence[str], stated: StatedClearance) -> list[OnFlank]:
        # The signal is the wave's force on the pin along the normal: the pin acts with the opposite, and rests below.
        return [OnFlank(joint, (links[1], links[0]), stated.clearance, f"{joint}.force", -1, -1)]

    def reference(self, geometry: Any, joint: str, link: str, bodies: Any) -> Pair:
        entry = geometry.mechanism.joints[joint]
        at: Pair = bodies[entry.links[0]].point(geometry.point(entry.links[0], entry.pin)).now
        return at

    def signal(self, geometry: Any, joint: str, attribute: str, bodies: Any, reaction: Any) -> Any:
        a, b = geometry.mechanism.joints[joint].links
        inner = self.inner(geometry, joint, (a, b))
        x, _ = inner.local(bodies[a], bodies[b])
        if attribute != "force":
            return x.d[self.orders[attribute]]
        turned = inner.normal(x.d[0]).rotated(bodies[b].direction(inner.heading).now)
        return -reaction(a).force.dot(turned)

    def outline(self, geometry: Any, joint: str, low: Any, high: Any) -> list[Curve]:
        entry = geometry.mechanism.joints[joint]
        inner = self.inner(geometry, joint, entry.links)
        (u_, v), base = inner.heading, inner.base

        def place(x: Any) -> Pair:
            y = inner.height * call("sin", x * inner.per)
            return Pair(base.x + u_ * x - v * y, base.y + v * x + u_ * y)

        return [Curve(entry.links[1], place, (low, high), points=33)]

    def misses(self, reports: Any, joint: str, links: Any) -> list[Miss]:
        return [Miss(seen(reports, joint)[2], length=True)]

    def constraints(self, reports: Any, joint: str, links: Any) -> list[list[Rate]]:
        place, normal, _ = seen(reports, joint)
        return [[Rate(links[0], 1.0, place, normal), Rate(links[1], -1.0, place, normal)]]

    def applied(self, reports: Any, contact: Any) -> Any:
        place, normal, _ = seen(reports, contact.joint)
        force = -np.asarray(reports.reaction(contact)[0])
        return contact.link, (force * normal).sum(axis=0) * normal, place, 0.0


def seen(reports: Any, joint: str) -> tuple[Any, Any, Any]:
    """The pin's place, the normal there and how far it lies off the wave, from reported poses."""
    geometry = reports.geometry
    entry = geometry.mechanism.joints[joint]
    a, b = entry.links
    height, length = (float(geometry.number(part, u.LENGTH)) for part in (entry.height, entry.length))
    angle = float(geometry.number(entry.along.angle, u.ANGLE))
    along = reports.rotated(b, (np.cos(angle), np.sin(angle)))
    left = np.array([-along[1], along[0]])
    place = reports.point_position(a, geometry.point(a, entry.pin))
    away = place - reports.point_position(b, geometry.point(b, entry.along.point))
    x, y = (away * along).sum(axis=0), (away * left).sum(axis=0)
    slope = height * 2 * np.pi / length * np.cos(2 * np.pi * x / length)
    size = np.hypot(1.0, slope)
    return place, (left - slope * along) / size, (y - height * np.sin(2 * np.pi * x / length)) / size
