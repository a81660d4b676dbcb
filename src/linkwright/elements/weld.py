"""The weld: two links that share a pin and keep their angle to each other there, such as a bracket on a rod.

The pin holds the place and the weld the angle, so their reactions are the section forces at that place: normal and
shear force from the pin, the bending moment from the weld. It is stated as a value that follows a drive with the slope
0. The links stay two, and are solved in closed form as links that a drive holds on each other.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Self

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.elements.fields import TwoLinks
from linkwright.elements.follower import (
    Follower,
    FollowerEntry,
    FollowerGeometry,
    FollowerReports,
    Motions,
    MotorRelation,
    joints_between,
    register_follower,
)
from linkwright.elements.joint import Applied, Restated
from linkwright.elements.mirror import Mirror
from linkwright.elements.mover import exerted
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Node
from linkwright.expressions.typed_fields import Quantity
from linkwright.findings import Finding
from linkwright.notation import Jet


class WeldEntry(FollowerEntry):
    """Two links that keep their angle to each other at the pin that they share."""

    kind: ClassVar[str] = "weld"

    weld: TwoLinks
    angle: Annotated[Expression, Quantity(u.ANGLE)]

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same weld seen in a mirror: on the other side."""
        return self.model_copy(update={"angle": mirror.angle(*self.weld).image(self.angle)})


@register_follower
@dataclass(frozen=True)
class Weld(Follower):
    """A link that is welded onto another one; its ``torque`` is the moment on it in the section at their pin (N m)."""

    kind: ClassVar[str] = "weld"
    stated: ClassVar[type[Any]] = WeldEntry

    @classmethod
    def read(cls, m: Any, name: str, pins: Mapping[str, Any]) -> Weld | list[Finding]:
        entry: WeldEntry = m.joints[name]
        path, (link, on) = ("joints", name), entry.links
        pinned, slides = joints_between(m, entry.links, pins)
        motors = [drive for drive, one in m.drives.items() if one.output is None]
        faults = []
        if len(pinned) != 1 or slides:
            faults.append(Finding("joint.weld-pin", path, {"link": link, "on": on}))
        if not motors:
            faults.append(Finding("joint.weld-drive", path, {"link": link, "on": on}))
        return faults or cls(entry, link, on, turning=True, motor=motors[0])

    def relation(self, geometry: FollowerGeometry, motions: Motions) -> MotorRelation:
        node = self.entry.angle
        return MotorRelation(lambda at, motor: Jet.constant(at.number(node, u.ANGLE), motor.order))

    def tree(self, geometry: FollowerGeometry, motor: Node) -> Node:
        return geometry.bind(self.entry.angle, u.ANGLE)

    def restated(self, reports: FollowerReports, name: str) -> dict[str, Restated]:
        """The angle as the file states it."""
        stated = float(reports.geometry.number(self.entry.angle, u.ANGLE))
        return {self.value: Restated(np.full(reports.count, stated))}

    def applied(self, reports: FollowerReports, name: str) -> list[Applied]:
        return exerted(self, reports, name, reports.rows[f"{name}.{self.effort}"])
