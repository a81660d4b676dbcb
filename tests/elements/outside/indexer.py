"""A kind of joint of another package, in one file: a barrel cam that has a link follow a motor by a motion law.

The link's value on the other one, which it is pinned to or slides on, is the law's at the motor's value. No equation is
left to be solved; the effort acts by duality at both joints, and its proof states the same from reported numbers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import BeforeValidator, Field

from linkwright.elements.follower import Follower, FollowerEntry, MotorRelation, register_follower
from linkwright.elements.joint import Applied
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.language import Binary, Call
from linkwright.expressions.language import Name as Signal
from linkwright.expressions.typed_fields import Quantity, Ref
from linkwright.findings import Finding


class IndexerEntry(FollowerEntry):
    """A link that a barrel cam moves on another."""

    kind: ClassVar[str] = "indexer"

    indexer: Annotated[tuple[Annotated[Name, Ref("link")], Annotated[Name, Ref("link")]], BeforeValidator(tuple)] = (
        Field(description="the link that is moved, and the one on which it is pinned or slides")
    )
    motor: Annotated[Name, Ref("drive")] = Field(description="the drive that turns the barrel")
    law: Annotated[Name, Ref("law")] = Field(description="the motion law over the motor's angle")
    phase: Annotated[Expression, Quantity(u.ANGLE)] = Field(Expression(0), description="where in the law it starts")


@register_follower
@dataclass(frozen=True)
class Indexer(Follower):
    """A link on its barrel cam."""

    kind = "indexer"
    stated = IndexerEntry
    words = {
        "en": {
            "term.kind-indexer": "barrel cam",
            "indexer.joint.what": "{a} isn't joined to {b} by one joint, on which it could follow.",
            "indexer.joint.mend": "Pin the two, or give them one prismatic joint.",
        }
    }

    @classmethod
    def read(cls, m: Any, name: str, pins: Mapping[str, Any]) -> Indexer | list[Finding]:
        entry = m.joints[name]
        pinned = [pin for pin in pins.values() if {*entry.links} <= {*pin.links}]
        slides = [slide for slide, joint in m.prismatic_joints() if {*joint.links} == {*entry.links}]
        if len(pinned) + len(slides) != 1:
            return [Finding("indexer.joint", ("joints", name), {"a": entry.links[0], "b": entry.links[1]})]
        slide = slides[0] if slides else None
        return cls(entry, *entry.links, turning=bool(pinned), motor=entry.motor, joint=slide)

    @property
    def laws(self) -> Mapping[str, str]:
        return {"law": self.entry.law}

    def relation(self, geometry: Any, motions: Any) -> MotorRelation:
        law = motions[self.entry.law]
        return MotorRelation(
            lambda at, angle: law.at_parameters(at.parameters).on(angle + at.number(self.entry.phase, u.ANGLE))
        )

    def tree(self, geometry: Any, motor: Any) -> Any:
        return Call(self.entry.law, (Binary("+", motor, geometry.bind(self.entry.phase, u.ANGLE)),))

    def calls(self, geometry: Any) -> list[Call]:
        return [self.tree(geometry, Signal(f"{self.motor}.angle"))]

    def applied(self, reports: Any, name: str) -> list[Applied]:
        m, effort = reports.geometry.mechanism, reports.rows[f"{name}.{self.effort}"]
        asked = reports.rows[f"{self.motor}.angle"] + reports.number(self.entry.phase, u.ANGLE)
        slope = reports.motions[self.entry.law].at(asked, 1)
        motor, none = m.drives[self.motor], np.zeros((2, reports.count))
        geared = [(motor.link, none, none, -slope * effort), (motor.on, none, none, slope * effort)]
        if self.turning:
            return [(self.link, none, none, effort), (self.on, none, none, -effort), *geared]
        place, along = reports.line(self.joint, self.on)
        return [(self.link, effort * along, place, 0.0), (self.on, -effort * along, place, 0.0), *geared]
