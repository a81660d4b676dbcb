"""The coupling: a link whose value on another one follows a drive by an expression, such as ``2*motor.angle + 30 deg``.

It stands for a transmission of which only the ratio matters: a gearbox, a timing belt, a second axis that a controller
couples to the first. Its effort acts at the joint of its two links and, times the slope of the expression and the other
way round, at that of the motor, so that both do no work together.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import Field

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
from linkwright.expressions.language import Node, evaluate, signal_text, signals_in
from linkwright.expressions.trees import replaced
from linkwright.expressions.typed_fields import Scope, of_drive
from linkwright.expressions.unknown import near
from linkwright.findings import Finding
from linkwright.notation import Jet, Scalar


class CouplingEntry(FollowerEntry):
    """A link that follows a drive by an expression."""

    kind: ClassVar[str] = "coupling"

    coupling: TwoLinks
    expression: Annotated[Expression, of_drive(u.ANGLE, u.LENGTH, lambda c: c.name, Scope.FOLLOWS)] = Field(
        alias="follows"
    )

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same coupling seen in a mirror: an angle that follows counts the other way round."""
        mirror.holds(*self.coupling)
        follows = mirror.expression(self.expression)
        if mirror.turns(*self.coupling):
            follows = mirror.angle(*self.coupling).image(follows)
        return self.model_copy(update={"expression": follows})

    @property
    def asked(self) -> list[str]:
        """The signals that the expression names."""
        return [*dict.fromkeys(map(signal_text, signals_in(self.expression.node)))]


@register_follower
@dataclass(frozen=True)
class Coupling(Follower):
    """A link that follows a drive; ``signal`` is the drive's value as the expression names it."""

    signal: str = ""

    kind: ClassVar[str] = "coupling"
    stated: ClassVar[type[Any]] = CouplingEntry

    @classmethod
    def read(cls, m: Any, name: str, pins: Mapping[str, Any]) -> Coupling | list[Finding]:
        entry: CouplingEntry = m.joints[name]
        path, (link, on) = ("joints", name), entry.links
        pinned, slides = joints_between(m, entry.links, pins)
        faults = []
        if len(pinned) + len(slides) != 1:
            faults.append(Finding("joint.coupling-joint", path, {"link": link, "on": on}))
        values = {f"{drive}.{one.value}": drive for drive, one in m.drives.items()}
        if len(entry.asked) != 1 or entry.asked[0] not in values:
            data = {"text": entry.expression.text[:60], "near": near((entry.asked or ["-"])[0], values)}
            faults.append(Finding("joint.coupling-motor", (*path, "follows"), data))
        if faults:
            return faults
        (signal,) = entry.asked
        slide = slides[0] if slides else None
        return cls(entry, link, on, turning=slide is None, motor=values[signal], joint=slide, signal=signal)

    def _node(self, geometry: FollowerGeometry) -> Node:
        return geometry.bind(self.entry.expression, u.ANGLE if self.turning else u.LENGTH)

    def relation(self, geometry: FollowerGeometry, motions: Motions) -> MotorRelation:
        node = self._node(geometry)

        return MotorRelation(lambda at, motor: _value(node, self.signal, motor, at.parameters))

    def tree(self, geometry: FollowerGeometry, motor: Node) -> Node:
        return replaced(self._node(geometry), self.signal, motor)

    def restated(self, reports: FollowerReports, name: str) -> dict[str, Restated]:
        """The expression at the drive's reported value."""
        dimension = u.ANGLE if self.turning else u.LENGTH
        return {self.value: Restated(reports.value(self.entry.expression, dimension))}

    def applied(self, reports: FollowerReports, name: str) -> list[Applied]:
        effort, motor = reports.rows[f"{name}.{self.effort}"], reports.geometry.mechanism.drives[self.motor]
        # The slope by the expression itself, at the motor's reported value.
        asked = Jet([reports.rows[self.signal], np.ones(reports.count)])
        slope = _value(self._node(reports.geometry), self.signal, asked, reports.geometry.parameters).d[1]
        back = -slope * effort
        return [*exerted(self, reports, name, effort), *exerted(motor, reports, self.motor, back)]


def _value(node: Node, signal: str, motor: Jet, parameters: Mapping[str, Scalar]) -> Jet:
    """The expression at the motor's value, with as many rates as this has."""
    found = evaluate(node, lambda name: motor if name.text == signal else parameters[name.text])
    return found if isinstance(found, Jet) else Jet.constant(found, motor.order)
