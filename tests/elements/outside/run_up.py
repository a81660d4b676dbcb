"""A kind of joint of another package, in one file: a clutch that has a link run up behind its motor, from an angle on.

Up to the angle ``from`` the link stands; from there on its angle is the square of what the motor has turned since, over
``over``. So its acceleration jumps there, at a place that no motion law has.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import BeforeValidator, Field

from linkwright.elements.curves import circle
from linkwright.elements.follower import Follower, FollowerEntry, MotorRelation, register_follower
from linkwright.elements.joint import Applied, Miss
from linkwright.elements.mover import exerted
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.language import Binary
from linkwright.expressions.language import Name as Signal
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.findings import Finding, Said
from linkwright.notation import Jet, Pair
from linkwright.notation.duals import value_of


class RunUpEntry(FollowerEntry):
    """A link that runs up."""

    kind: ClassVar[str] = "run_up"

    run_up: Annotated[tuple[Annotated[Name, Ref("link")], Annotated[Name, Ref("link")]], BeforeValidator(tuple)] = (
        Field(description="the link that is moved, and the one on which it is pinned")
    )
    motor: Annotated[Name, Ref("drive")] = Field(description="the drive that it follows")
    begin: Annotated[Expression, Quantity(u.ANGLE)] = Field(
        description="the motor's angle at which it begins", alias="from"
    )
    over: Annotated[Expression, Quantity(u.ANGLE)] = Field(description="what the square is divided by")

    def name_faults(self, mechanism: Any) -> Any:
        if self.run_up[1] != "frame":
            yield "run_up.frame", {"link": self.run_up[1]}, "run_up"

    def number_faults(self, value: Any) -> Any:
        yield value(self.over, u.ANGLE), Sign.POSITIVE, ("run_up.over", {}, "over")


@register_follower
@dataclass(frozen=True)
class RunUp(Follower):
    """A link on its clutch."""

    kind = "run_up"
    stated = RunUpEntry
    words = {
        "en": {
            "term.kind-run_up": "run-up clutch",
            "fact.run-up": "runs up from {begin} on",
            "run_up.joint.what": "{a} isn't pinned to {b}.",
            "run_up.joint.mend": "Pin the two.",
            "run_up.frame.what": "It stands on {link}.",
            "run_up.frame.mend": "Use the frame.",
            "run_up.over.what": "The length of the run-up isn't positive.",
            "run_up.over.mend": "Write a positive angle.",
        }
    }

    @classmethod
    def read(cls, m: Any, name: str, pins: Mapping[str, Any]) -> RunUp | list[Finding]:
        entry = m.joints[name]
        if not [pin for pin in pins.values() if {*entry.links} <= {*pin.links}]:
            return [Finding("run_up.joint", ("joints", name), {"a": entry.links[0], "b": entry.links[1]})]
        return cls(entry, *entry.links, turning=True, motor=entry.motor)

    def relation(self, geometry: Any, motions: Any) -> MotorRelation:
        def value(at: Any, angle: Jet) -> Jet:
            since = angle - at.number(self.entry.begin, u.ANGLE)
            squared = since * since * (1.0 / at.number(self.entry.over, u.ANGLE))
            return squared.where(value_of(since.d[0]) > 0, Jet.constant(0.0, angle.order))

        return MotorRelation(value)

    def joins(self, geometry: Any) -> Any:
        return [Binary("-", Signal(f"{self.motor}.angle"), geometry.bind(self.entry.begin, u.ANGLE))]

    def sentence(self, geometry: Any) -> Said:
        return Said("fact.run-up", begin=geometry.text_of(geometry.number(self.entry.begin, u.ANGLE), u.ANGLE))

    def outline(self, geometry: Any) -> Any:
        return [circle(self.link, Pair(0.0, 0.0), geometry.number(self.entry.over, u.ANGLE) * 0.02)]

    def since(self, reports: Any) -> Any:
        """What the motor has turned since, from reports."""
        return np.maximum(reports.rows[f"{self.motor}.angle"] - reports.number(self.entry.begin, u.ANGLE), 0.0)

    def misses(self, reports: Any, name: str) -> list[Miss]:
        expected = self.since(reports) ** 2 / reports.number(self.entry.over, u.ANGLE)
        x, y = reports.rotated(self.link, (1.0, 0.0))
        return [Miss(y * np.cos(expected) - x * np.sin(expected), length=False)]

    def applied(self, reports: Any, name: str) -> list[Applied]:
        effort = reports.rows[f"{name}.torque"]
        back = -2.0 * self.since(reports) / reports.number(self.entry.over, u.ANGLE) * effort
        motor = reports.geometry.mechanism.drives[self.motor]
        return [*exerted(self, reports, name, effort), *exerted(motor, reports, self.motor, back)]
