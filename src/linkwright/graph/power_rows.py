"""The balance of power of a pose, as output rows: what drives give, what loads, springs, gravity and inertia take.

Reactions do no work. So the balance checks the efforts of drives against the motion and all that acts, whatever the
groups were solved by: the principle of virtual power.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from linkwright.data_classes import dataclass
from linkwright.graph.actions import wrenches
from linkwright.graph.forces import own_wrench
from linkwright.graph.power import power_of_wrench, supplied
from linkwright.graph.rows import ElementActionRow, Row
from linkwright.notation import Scalar
from linkwright.notation.jets import call
from linkwright.structure import FRAME

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph
    from linkwright.graph.view import View


@dataclass(frozen=True)
class PowerRow(Row):
    """What the powers (W) of a pose leave, which is zero; of the ``size`` the sum of their magnitudes."""

    size: bool = False
    called = "power/{size}"

    def order(self, graph: Graph) -> int:
        return graph.actions.forces

    def expression(self, view: View) -> Scalar:
        terms = powers(view)
        return sum((call("abs", term) for term in terms) if self.size else terms, 0.0)


@dataclass(frozen=True)
class ElementPower(ElementActionRow):
    """The power (W) that an element supplies to its links."""

    called = "power/{section}/{name}"

    def order(self, graph: Graph) -> int:
        return graph.actions.forces

    def expression(self, view: View) -> Scalar:
        return supplied(view, view.graph.actions.at[self.section, self.name])


def powers(view: View) -> list[Scalar]:
    """The power (W) of each drive, of gravity and inertia of each link, and of all that is applied to links."""
    bodies, motion = view.motion.bodies, view.motion
    own = ((link, own_wrench(motion, link, body)) for link, body in bodies.items() if link != FRAME)
    acting = [*own, *((link, wrench) for link, wrench in wrenches(view) if link != FRAME)]
    drives = [view.forces.efforts[name] * view.drive_value(name, 1) for name in view.graph.motors]
    return [*drives, *(power_of_wrench(bodies[link], wrench) for link, wrench in acting)]
