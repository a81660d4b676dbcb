"""Three kinds of force elements of another package, one for each section: a drag, an inerter, a ball of lead.

The drag has no signals, follows the time and asks for a signal of another element. The inerter needs accelerations, and
whole turns of an angle. The ball only weighs.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import Field

from linkwright.elements.entries import ForceEntry
from linkwright.elements.force import ForceKind, Misfit, Weight, register
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Quantity, Ref, Scope, Sign
from linkwright.notation import Pair, Wrench


class DragEntry(ForceEntry):
    """What brakes a point of a link and its turning."""

    kind: ClassVar[str] = "drag"

    drag: Annotated[Name, Ref("link")] = Field(description="the link")
    at: Annotated[Name, Ref("point", of="drag")] = Field(description="its point")
    coefficient: Annotated[Expression, Quantity(u.DAMPING, scope=Scope.LOAD)] = Field(description="force over speed")
    turning: Annotated[Expression, Quantity(u.TORSIONAL_DAMPING)] = Field(description="moment over angular velocity")


@register
class Drag(ForceKind[DragEntry]):
    """Drags."""

    name = "drag"
    section = "loads"
    entry = DragEntry
    words = {"en": {"term.kind-drag": "drag"}}

    def laws(self, entry: Any) -> Any:
        return ((entry.coefficient, u.DAMPING),)

    def depends(self, name: str, entry: Any) -> tuple[str, ...]:
        return (f"{entry.drag}.omega",)

    def wrenches(self, context: Any, name: str, entry: Any) -> Iterator[tuple[str, Wrench]]:
        at = context.bodies[entry.drag].point(context.geometry.point(entry.drag, entry.at))
        c, ct = context.value(entry.coefficient, u.DAMPING), context.geometry.number(entry.turning, u.TORSIONAL_DAMPING)
        moment = -ct * context.signal(f"{entry.drag}.omega")
        yield entry.drag, Wrench(Pair(-c * at.x.d[1], -c * at.y.d[1]), moment, at.now)

    def applied(self, reports: Any, name: str, entry: Any) -> Any:
        place = reports.point_position(entry.drag, reports.geometry.point(entry.drag, entry.at))
        force = -reports.value(entry.coefficient, u.DAMPING) * reports.velocity(entry.drag, place)
        ct = float(reports.geometry.number(entry.turning, u.TORSIONAL_DAMPING))
        return [(entry.drag, force, place, -ct * reports.rows[f"{entry.drag}.omega"])]


class InerterEntry(ForceEntry):
    """A wheel that a link turns against the frame."""

    kind: ClassVar[str] = "inerter"

    inerter: Annotated[Name, Ref("link")] = Field(description="the link")
    inertia: Annotated[Expression, Quantity(u.INERTIA, Sign.POSITIVE)] = Field(description="moment of inertia")


@register
class Inerter(ForceKind[InerterEntry]):
    """Inerters."""

    name = "inerter"
    section = "springs"
    entry = InerterEntry
    stores = True
    order = 2
    orders = {"wound": 0, "energy": 1}
    words = {"en": {"term.kind-inerter": "inerter"}}

    def signals(self, entry: Any) -> Any:
        return {"wound": u.ANGLE, "moment": u.TORQUE, "energy": u.ENERGY}

    def effort(self, entry: Any) -> str:
        return "moment"

    def counted_angle(self, entry: Any) -> tuple[str, str]:
        return entry.inerter, "frame"

    def start_angle(self, entry: Any, value: Any, middle: Any) -> float:
        return 3.0

    def wrenches(self, context: Any, name: str, entry: Any) -> Iterator[tuple[str, Wrench]]:
        moment = self.signal(context, name, entry, "moment")
        for link, on_it in ((entry.inerter, moment), ("frame", -moment)):
            yield link, Wrench(Pair(0.0, 0.0), on_it, context.bodies[link].anchor.now)

    def energy(self, context: Any, name: str, entry: Any) -> Any:
        omega = context.bodies[entry.inerter].turn.d[0]
        return context.geometry.number(entry.inertia, u.INERTIA) / 2 * omega * omega

    def signal(self, context: Any, name: str, entry: Any, attribute: str) -> Any:
        body = context.bodies[entry.inerter]
        if attribute == "wound":
            return body.heading + 2 * np.pi * context.turns(name)
        if attribute == "energy":
            return self.energy(context, name, entry)
        return -context.geometry.number(entry.inertia, u.INERTIA) * body.turn.d[1]

    def reported(self, entry: Any) -> tuple[str, ...]:
        return ("moment",)

    def applied(self, reports: Any, name: str, entry: Any) -> Any:
        moment, nowhere = self._seen(reports, entry), np.zeros((2, reports.count))
        return [(entry.inerter, nowhere, nowhere, moment), ("frame", nowhere, nowhere, -moment)]

    def dissipative_forces(self, reports: Any, name: str, entry: Any) -> Any:
        return []

    def misfits(self, reports: Any, name: str, entry: Any) -> list[Misfit]:
        return [Misfit(reports.rows[f"{name}.moment"] - self._seen(reports, entry), force=False)]

    def _seen(self, reports: Any, entry: Any) -> Any:
        return -float(reports.geometry.number(entry.inertia, u.INERTIA)) * reports.rows[f"{entry.inerter}.alpha"]


class BallEntry(ForceEntry):
    """A ball on a link."""

    kind: ClassVar[str] = "ball"

    ball: Annotated[Name, Ref("link")] = Field(description="the link")
    at: Annotated[Name, Ref("point", of="ball")] = Field(description="its point")
    mass: Annotated[Expression, Quantity(u.MASS, Sign.POSITIVE)] = Field(description="mass")


@register
class Ball(ForceKind[BallEntry]):
    """Balls of lead."""

    name = "ball"
    section = "counterweights"
    entry = BallEntry
    acts = False
    words = {"en": {"term.kind-ball": "ball of lead"}}

    def weighs(self, entry: Any) -> Weight:
        return Weight(entry.ball, entry.mass, entry.at, None)
