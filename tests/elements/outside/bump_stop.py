"""A kind of force element of another package, in one file: a bump stop between two points.

Its force follows a table of the distance (positive in tension, as that of springs); nearer than the gap a preload
pushes besides, that is there at once. Both store energy.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import BeforeValidator, Field

from linkwright.elements.entries import ForceEntry
from linkwright.elements.force import AskedTable, Between, Break, ForceKind, Misfit, SignalChart, Use, register
from linkwright.elements.points import links_of_points
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.language import Binary
from linkwright.expressions.language import Name as Signal
from linkwright.expressions.typed_fields import Quantity, Ref, Scope, Sign
from linkwright.findings import Term
from linkwright.notation import Pair, Wrench
from linkwright.notation.jets import call

Point = Annotated[Name, Ref("point")]


class BumpStopEntry(ForceEntry):
    """A stop of rubber between two points."""

    kind: ClassVar[str] = "bump_stop"

    bump_stop: Annotated[tuple[Point, Point], BeforeValidator(tuple)] = Field(
        description="the two points between which it acts"
    )
    table: Name = Field(description="a table of the force over the distance")
    gap: Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE)] = Field(description="distance at contact")
    preload: Annotated[Expression, Quantity(u.FORCE, Sign.NOT_NEGATIVE)] = Field(description="push at contact")


@register
class BumpStop(ForceKind[BumpStopEntry]):
    """Bump stops."""

    name = "bump_stop"
    section = "springs"
    entry = BumpStopEntry
    stores = True
    order = 0
    orders = {"closing": 1, "power": 1}
    charts = (SignalChart("stop_push", "force", "push"),)
    words = {
        "en": {
            "term.kind-bump_stop": "bump stop",
            "term.stop-between": "{name}, a bump stop from {start} to {end}, pushes with {push} at the start",
            "plot.stop_push": "Forces of the bump stops (push positive)",
        }
    }

    def signals(self, entry: Any) -> Any:
        return {"distance": u.LENGTH, "closing": u.SPEED, "push": u.FORCE, "power": u.POWER, "energy": u.ENERGY}

    def effort(self, entry: Any) -> str:
        return "push"

    def implied_expressions(self, mechanism: Any, entry: Any) -> Iterator[Use]:
        yield Use("table", Expression(f"{entry.table}(1 m)"), u.FORCE, Scope.TIME)

    def needed_tables(self, name: str, entry: Any) -> tuple[AskedTable, ...]:
        return tuple(AskedTable(entry.table, Signal(f"{name}.distance"), integral) for integral in (False, True))

    def breaks(self, name: str, entry: Any, bind: Any) -> Iterator[Break]:
        yield Break(Binary("-", Signal(f"{name}.distance"), bind(entry.gap, u.LENGTH)), jumps=True)

    def wrenches(self, context: Any, name: str, entry: Any) -> Iterator[tuple[str, Wrench]]:
        (a, start), (b, end) = _ends(context, entry)
        away, x = end.minus(start).now, self.signal(context, name, entry, "distance")
        push = self.signal(context, name, entry, "push")
        force = Pair(push * away.x / x, push * away.y / x)
        yield b, Wrench(force, 0.0, end.now)
        yield a, Wrench(Pair(-force.x, -force.y), 0.0, start.now)

    def energy(self, context: Any, name: str, entry: Any) -> Any:
        under = context.geometry.number(entry.gap, u.LENGTH) - self.signal(context, name, entry, "distance")
        pressed = context.geometry.number(entry.preload, u.FORCE) * call("where", under > 0, under, 0.0)
        return context.lookup(entry.table, Signal(f"{name}.distance"), integral=True) + pressed

    def signal(self, context: Any, name: str, entry: Any, attribute: str) -> Any:
        if attribute == "energy":
            return self.energy(context, name, entry)
        (_, start), (_, end) = _ends(context, entry)
        away = end.minus(start)
        distance = away.dot(away).sqrt()
        if attribute in ("distance", "closing"):
            return distance.d[0] if attribute == "distance" else -distance.d[1]
        gap, preload = (context.geometry.number(of, d) for of, d in ((entry.gap, u.LENGTH), (entry.preload, u.FORCE)))
        push = call("where", distance.d[0] < gap, preload, 0.0)
        push = push - context.lookup(entry.table, Signal(f"{name}.distance"))
        return push if attribute == "push" else push * distance.d[1]

    # The proof.

    def reported(self, entry: Any) -> tuple[str, ...]:
        return ("push",)

    def applied(self, reports: Any, name: str, entry: Any) -> Any:
        (a, start), (b, end), push = self._seen(reports, entry)
        force = push * (end - start) / np.hypot(*(end - start))
        return [(b, force, end, 0.0), (a, -force, start, 0.0)]

    def dissipative_forces(self, reports: Any, name: str, entry: Any) -> Any:
        return []

    def misfits(self, reports: Any, name: str, entry: Any) -> list[Misfit]:
        return [Misfit(reports.rows[f"{name}.push"] - self._seen(reports, entry)[2], force=True)]

    def _seen(self, reports: Any, entry: Any) -> Any:
        geometry, found = reports.geometry, links_of_points(reports.geometry.mechanism)
        start, end = (
            (found[p], reports.point_position(found[p], geometry.point(found[p], p))) for p in entry.bump_stop
        )
        x = np.hypot(*(end[1] - start[1]))
        pressed = float(geometry.number(entry.preload, u.FORCE)) * (x < float(geometry.number(entry.gap, u.LENGTH)))
        return start, end, pressed - reports.table(entry.table, x)

    # What is told of it.

    def distance(self, entry: Any) -> str:
        return "distance"

    def outline(self, mechanism: Any, entry: Any) -> Between:
        return Between([links_of_points(mechanism)[point] for point in entry.bump_stop], entry.bump_stop, "strut")

    def sentence(self, name: str, entry: Any, effort: float, shown: Any) -> Term:
        start, end = entry.bump_stop
        return Term("stop-between", name=name, start=start, end=end, push=shown(effort, u.FORCE))


def _ends(context: Any, entry: Any) -> Any:
    found = links_of_points(context.geometry.mechanism)
    return [(found[p], context.bodies[found[p]].point(context.geometry.point(found[p], p))) for p in entry.bump_stop]
