"""A kind of joint of another package whose force has a part that does no work: two gears on a carrier.

The closure is stated on the pitch circles, by radii that are negative for a ring. Its rates are those of two teeth at
the pitch point, so that its multiplier is the tangential force there; what separates the gears follows from that.
"""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import BeforeValidator, Field

from linkwright.elements import Inner, JointKind, register
from linkwright.elements.entries import JointEntry
from linkwright.elements.joint import Miss, Rate
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Quantity, Ref
from linkwright.notation import Jet, Pair, Wrench
from linkwright.notation.jets import call

_Link = Annotated[Name, Ref("link")]


class GearMeshEntry(JointEntry):
    """Two gears and their carrier."""

    kind: ClassVar[str] = "gear_mesh"
    signals = {"tangential": u.FORCE}
    gear_mesh: Annotated[tuple[_Link, _Link, _Link], BeforeValidator(tuple)] = Field(
        description="both gears and their carrier"
    )
    at: ClassVar[None] = None
    points: Annotated[tuple[Name, Name, Name], BeforeValidator(tuple), Ref("point", of="links")] = Field(
        description="the centre on each, and one on the carrier"
    )
    radius_a: Annotated[Expression, Quantity(u.LENGTH)] = Field(description="pitch radius of a")
    radius_b: Annotated[Expression, Quantity(u.LENGTH)] = Field(description="pitch radius of b")

    @property
    def joint_points(self) -> tuple[str, ...]:
        return self.points


class Mesh(Inner):
    def __init__(self, ra: Any, rb: Any, at: Any, bt: Any, phase: float) -> None:
        self.ra, self.rb, self.at, self.bt, self.phase = ra, rb, at, bt, phase

    def gap(self, *bodies: Any) -> tuple[Jet, ...]:
        a, b, c = bodies
        now = (a.angle - c.angle) * self.ra + (b.angle - c.angle) * self.rb - self.phase
        apart = b.point(self.bt).minus(a.point(self.at))
        if len(apart.x.d) < 2:
            return (Jet([now]),)
        # velocity of a's less b's point at the pitch point, along the common tangent
        vx, vy = Jet([-e for e in apart.x.d[1:]]), Jet([-e for e in apart.y.d[1:]])
        across = (vy * apart.x - vx * apart.y) / (self.ra + self.rb)
        speed = a.turn * self.ra + b.turn * self.rb + across
        return (Jet([now, *speed.d[: len(apart.x.d) - 1]]),)

    def besides(self, bodies: Any, multipliers: Any) -> Any:
        a, b, _ = bodies
        at, bt = a.point(self.at).now, b.point(self.bt).now
        total = self.ra + self.rb
        along = Pair((bt.x - at.x) / total, (bt.y - at.y) / total)
        size = -call("abs", multipliers[0]) * np.tan(np.radians(20))
        about = Pair(at.x + self.ra * along.x, at.y + self.ra * along.y)
        return [
            Wrench(Pair(size * along.x, size * along.y), 0.0, about),
            Wrench(Pair(-size * along.x, -size * along.y), 0.0, about),
            Wrench.zero(about),
        ]


@register
class GearMesh(JointKind):
    """Gears that mesh, with a pressure angle of 20 deg."""

    name = "gear_mesh"
    letter = "G"
    row_units = ("length",)
    entry = GearMeshEntry
    phased = True
    winds = True
    orders = {"tangential": 2}
    words = {"en": {"term.kind-gear_mesh": "meshing gears"}}

    def _r(self, geometry: Any, joint: str) -> Any:
        e = geometry.mechanism.joints[joint]
        return geometry.number(e.radius_a, u.LENGTH), geometry.number(e.radius_b, u.LENGTH)

    def phase(self, geometry: Any, joint: str, bodies: Any) -> tuple[float, ...]:
        a, b, c = (bodies[link].angle for link in geometry.mechanism.joints[joint].links)
        ra, rb = self._r(geometry, joint)
        return (float(ra * (a - c) + rb * (b - c)),)

    def inner(self, geometry: Any, joint: str, links: Any) -> Mesh:
        e, (phase,) = geometry.mechanism.joints[joint], geometry.phases(joint) or (0.0,)
        a, b, _ = e.links
        return Mesh(*self._r(geometry, joint), geometry.point(a, e.points[0]), geometry.point(b, e.points[1]), phase)

    def reference(self, geometry: Any, joint: str, link: str, bodies: Any) -> Any:
        e = geometry.mechanism.joints[joint]
        ra, rb = self._r(geometry, joint)
        at, bt = (
            bodies[link].point(geometry.point(link, p)).now for link, p in zip(e.links[:2], e.points[:2], strict=True)
        )
        f = ra / (ra + rb)
        return Pair(at.x + f * (bt.x - at.x), at.y + f * (bt.y - at.y))

    def signal(self, geometry: Any, joint: str, attribute: str, bodies: Any, reaction: Any) -> Any:
        e = geometry.mechanism.joints[joint]
        ra, rb = self._r(geometry, joint)
        at, bt = (
            bodies[link].point(geometry.point(link, p)).now for link, p in zip(e.links[:2], e.points[:2], strict=True)
        )
        f = reaction(e.links[0]).force
        return -(f.y * (bt.x - at.x) - f.x * (bt.y - at.y)) / (ra + rb)

    def _ends(self, reports: Any, joint: str) -> Any:
        g = reports.geometry
        e = g.mechanism.joints[joint]
        at, bt = (
            np.asarray(reports.point_position(link, g.point(link, p)))
            for link, p in zip(e.links[:2], e.points[:2], strict=True)
        )
        ra, rb = map(float, self._r(g, joint))
        along = (bt - at) / (ra + rb)
        return at + ra * along, np.array([-along[1], along[0]])

    def misses(self, reports: Any, joint: str, links: Any) -> list[Miss]:
        ra, rb = map(float, self._r(reports.geometry, joint))
        a, b, c = (np.arctan2(*reports.rotated(link, (1.0, 0.0))[::-1]) for link in links)
        off = ra * np.unwrap(a - c) + rb * np.unwrap(b - c)
        return [Miss(off - off[0], length=True)]

    def constraints(self, reports: Any, joint: str, links: Any) -> list[list[Rate]]:
        place, t = self._ends(reports, joint)
        return [[Rate(links[0], 1.0, place, t), Rate(links[1], -1.0, place, t)]]

    def applied(self, reports: Any, contact: Any) -> Any:
        force, _ = reports.reaction(contact)
        return contact.link, -np.asarray(force), self._ends(reports, contact.joint)[0], 0.0
