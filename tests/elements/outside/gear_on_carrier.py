"""A kind of joint of another package, in one file: two gears that mesh on a carrier, one row over three links.

The angles of both gears relative to the carrier keep a ratio: z1 (a - c) + z2 (b - c) = constant, which the drawn pose
fixes. The angles are continuous, over any number of turns.
"""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import BeforeValidator, Field

from linkwright.elements import Inner, JointKind, register
from linkwright.elements.curves import Curve, circle
from linkwright.elements.entries import JointEntry
from linkwright.elements.joint import Miss, Rate
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.notation import Jet
from linkwright.notation.jets import call

_Link = Annotated[Name, Ref("link")]


class GearEntry(JointEntry):
    """Two gears on a carrier."""

    kind: ClassVar[str] = "gear_on_carrier"
    couple = True
    signals = {"turned": u.ANGLE}

    gear_on_carrier: Annotated[tuple[_Link, _Link, _Link], BeforeValidator(tuple)] = Field(
        description="both gears and their carrier"
    )
    at: ClassVar[None] = None
    points: Annotated[tuple[Name, Name, Name], BeforeValidator(tuple), Ref("point", of="links")] = Field(
        description="a point of each"
    )
    ratio: Annotated[Expression, Quantity(u.PURE, Sign.POSITIVE, "number")] = Field(description="teeth of b over a")

    @property
    def joint_points(self) -> tuple[str, ...]:
        return self.points


class Mesh(Inner):
    def __init__(self, ratio: Any, phase: float) -> None:
        self.ratio, self.phase = ratio, phase

    def gap(self, *bodies: Any) -> tuple[Jet, ...]:
        a, b, c = bodies
        now = (a.angle - c.angle) + self.ratio * (b.angle - c.angle) - self.phase
        return (Jet([now, *((a.turn - c.turn) + (b.turn - c.turn) * self.ratio).d]),)


@register
class GearOnCarrier(JointKind):
    """Gears that mesh on a carrier."""

    name = "gear_on_carrier"
    letter = "G"
    row_units = ("angle",)
    entry = GearEntry
    phased = True
    winds = True
    orders = {"turned": 0}
    words = {"en": {"term.kind-gear_on_carrier": "gears on a carrier"}}

    def phase(self, geometry: Any, joint: str, bodies: Any) -> tuple[float, ...]:
        entry = geometry.mechanism.joints[joint]
        a, b, c = (bodies[link].angle for link in entry.links)
        return (float((a - c) + geometry.number(entry.ratio, u.PURE) * (b - c)),)

    def inner(self, geometry: Any, joint: str, links: Any) -> Mesh:
        entry, (phase,) = geometry.mechanism.joints[joint], geometry.phases(joint) or (0.0,)
        return Mesh(geometry.number(entry.ratio, u.PURE), phase)

    def reference(self, geometry: Any, joint: str, link: str, bodies: Any) -> Any:
        entry = geometry.mechanism.joints[joint]
        return bodies[link].point(geometry.point(link, entry.points[entry.links.index(link)])).now

    def signal(self, geometry: Any, joint: str, attribute: str, bodies: Any, reaction: Any) -> Any:
        entry = geometry.mechanism.joints[joint]
        return bodies[entry.links[0]].angle - bodies[entry.links[2]].angle

    def outline(self, geometry: Any, joint: str, low: Any, high: Any) -> list[Curve]:
        """Both pitch circles, where the carrier has the centres."""
        entry = geometry.mechanism.joints[joint]
        a, b, carrier = entry.links
        centres = entry.points[:2]
        if not geometry.mechanism.links[carrier].points.keys() >= {*centres}:
            return []
        away = geometry.point(carrier, centres[1]).minus(geometry.point(carrier, centres[0]))
        radius = call("hypot", *away) / (1.0 + geometry.number(entry.ratio, u.PURE))
        found = []
        for link, point, size in ((a, centres[0], radius), (b, centres[1], call("hypot", *away) - radius)):
            found.append(circle(link, geometry.point(link, point), size))
        return found

    def misses(self, reports: Any, joint: str, links: Any) -> list[Miss]:
        # Of reported axes only the angle but for whole turns is known: that of a turn of the mesh.
        entry = reports.geometry.mechanism.joints[joint]
        ratio = float(reports.geometry.number(entry.ratio, u.PURE))
        a, b, c = (np.arctan2(*reports.rotated(link, (1.0, 0.0))[::-1]) for link in links)
        off = np.unwrap(a - c) + ratio * np.unwrap(b - c)
        off = off - off[0]
        return [Miss(off - 2 * np.pi * np.round(off / (2 * np.pi)), length=False)]

    def constraints(self, reports: Any, joint: str, links: Any) -> list[list[Rate]]:
        ratio = float(reports.geometry.number(reports.geometry.mechanism.joints[joint].ratio, u.PURE))
        a, b, c = links
        return [[Rate(a, 1.0), Rate(b, ratio), Rate(c, -1.0 - ratio)]]

    def applied(self, reports: Any, contact: Any) -> Any:
        force, moment = reports.reaction(contact)
        entry = reports.geometry.mechanism.joints[contact.joint]
        point = entry.points[entry.links.index(contact.link)]
        return (
            contact.link,
            -force,
            reports.point_position(contact.link, reports.geometry.point(contact.link, point)),
            -moment,
        )
