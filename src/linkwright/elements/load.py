"""Loads: forces at points of links and torques on them, constant or following the time, tables and the motion.

A load between two links has an opposite on the other, in the same line of action.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import Discriminator, Field, Tag

from linkwright.elements.entries import ForceEntry
from linkwright.elements.fields import At, Vector
from linkwright.elements.force import ForceContext, ForceKind, ForceReports, Use, register
from linkwright.elements.joint import Applied
from linkwright.elements.mirror import Mirror, Reflection
from linkwright.elements.points import FRAME
from linkwright.expressions.dimensions import crossed
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Path, Quantity, Ref, Scope
from linkwright.expressions.units import FORCE, TORQUE, Dimension
from linkwright.expressions.written import Fault
from linkwright.findings import Finding
from linkwright.notation import Pair, Scalar, Wrench
from linkwright.notation.jets import call

# A branch of a union is chosen by the looks of the value, so that its faults are told once.
Force = Annotated[
    Annotated[Vector, Tag("vector")] | Annotated[Expression, Tag("scalar")],
    Discriminator(lambda raw: "vector" if isinstance(raw, list | tuple) else "scalar"),
]


class Load(ForceEntry):
    """A force at a point, or a torque, on a link: constant, or an expression in t, tables and the motion."""

    kind: ClassVar[str] = "load"

    on: Annotated[Name, Ref("link")]
    against: Annotated[Name | None, Ref("link")] = None
    at: Annotated[At | None, Ref("point", of="on")] = None
    force: Annotated[Force | None, Quantity(FORCE, scope=Scope.LOAD)] = None
    along: Annotated[Name | None, Ref("slide")] = None
    torque: Annotated[Expression | None, Quantity(TORQUE, scope=Scope.LOAD)] = None
    in_: Annotated[Name | None, Ref("link")] = Field(None, alias="in")
    window: Annotated[Name | None, Ref("window")] = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if "force" not in given and "torque" not in given:
            yield "load.empty", {}
        if "force" not in given:
            return
        if "at" not in given:
            yield "load.at", {}
        if isinstance(given["force"], Mapping):
            return
        vector = isinstance(given["force"], list | tuple)
        if vector == ("along" in given):
            yield "load.direction", {}
        elif not vector and "in" in given:
            yield "load.in", {}

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same load seen in a mirror: of a vector the component along the mirrored axis has the other sign, and so
        has a torque."""
        axes = self.in_ or FRAME
        mirror.holds(self.on, axes, *filter(None, (self.against,)))
        update: dict[str, Any] = {}
        if self.at is not None and not isinstance(self.at, str):
            update["at"] = mirror.position(self.on, self.at)
        if isinstance(self.force, tuple):
            x, y = map(mirror.expression, self.force)
            other = Reflection(True)
            update["force"] = (other.image(x), y) if axes == FRAME else (x, other.image(y))
        elif self.force is not None:
            update["force"] = mirror.expression(self.force)
        if self.torque is not None:
            update["torque"] = Reflection(True).image(mirror.expression(self.torque))
        return self.model_copy(update=update)

    @property
    def parts(self) -> tuple[tuple[Expression, Dimension], ...]:
        """Its expressions with their dimensions: the force's one or two numbers, then the torque."""
        forces = self.force if isinstance(self.force, tuple) else (self.force,) if self.force else ()
        torque = ((self.torque, TORQUE),) if self.torque is not None else ()
        return (*((force, FORCE) for force in forces), *torque)

    def spread(self, values: list[Any]) -> tuple[Pair, Any]:
        """The values of its parts as force and torque; a single force goes along the first axis."""
        torque = values[-1] if self.torque is not None else 0.0
        force = values[: -1 if self.torque is not None else None]
        return Pair(*(*force, 0.0, 0.0)[:2]), torque


@register
class Loads(ForceKind[Load]):
    """Forces and torques on links."""

    name = "load"
    section = "loads"
    entry = Load
    usual = True
    order = 0

    def faults(self, mechanism: Any, path: Path, entry: Load) -> Iterator[Finding]:
        if entry.against == entry.on:
            yield Finding("load.against-itself", path, {"name": entry.on})

    def implied_expressions(self, mechanism: Any, entry: Load) -> Iterator[Use]:
        # The signal that bounds its window, of which the load is then a function.
        window = mechanism.windows.get(entry.window) if entry.window else None
        for signal in window if isinstance(window, dict) else ():
            yield Use("window", Expression(signal), crossed(str(entry.window)), Scope.LOAD)

    def laws(self, entry: Load) -> tuple[tuple[Expression, Dimension], ...]:
        return entry.parts

    def window(self, entry: Load) -> str | None:
        return entry.window

    def wrenches(self, context: ForceContext, name: str, entry: Load) -> Iterator[tuple[str, Wrench]]:
        geometry, bodies = context.geometry, context.bodies
        force, torque = _values(context, entry)
        if entry.along:
            joint = geometry.mechanism.joints[entry.along]
            heading = geometry.line(entry.along, joint.links[0])[1]
            force = force.rotated(bodies[joint.links[0]].direction(heading).now)
        elif entry.in_ and entry.in_ != FRAME:
            force = force.rotated(bodies[entry.in_].axis.now)
        wrench = Wrench(force, torque, bodies[entry.on].point(geometry.place(entry.on, entry.at)).now)
        yield entry.on, wrench
        if entry.against:
            yield entry.against, wrench.opposite

    def strength(self, context: ForceContext, name: str, entry: Load) -> Scalar:
        force, torque = _values(context, entry)
        return force.x + force.y + torque

    def applied(self, reports: ForceReports, name: str, entry: Load) -> list[Applied]:
        geometry = reports.geometry
        inside = True if entry.window is None else reports.inside(entry.window)
        values = [np.where(inside, reports.value(part, dimension), 0.0) for part, dimension in entry.parts]
        force, torque = entry.spread(values)
        turns_with, local = entry.in_ or FRAME, force
        if entry.along:
            turns_with = geometry.mechanism.joints[entry.along].links[0]
            heading = geometry.line(entry.along, turns_with)[1]
            local = Pair(force.x * heading.x, force.x * heading.y)
        place = reports.point_position(entry.on, geometry.place(entry.on, entry.at))
        acts = reports.rotated(turns_with, local)
        found: list[Applied] = [(entry.on, acts, place, torque)]
        return [*found, (entry.against, -acts, place, -torque)] if entry.against else found


def _values(context: ForceContext, entry: Load) -> tuple[Pair, Scalar]:
    """Its force (N, in the axes that it is given in) and torque (N m)."""
    values = [context.value(part, dimension) for part, dimension in entry.parts]
    if entry.window:
        inside = context.inside(entry.window)
        values = [call("where", inside, value, 0.0) for value in values]
    return entry.spread(values)
