"""Output rows of forces as pictures need them: a vector, and the place where it acts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from linkwright.data_classes import dataclass
from linkwright.graph.rows import ElementActionRow, Row
from linkwright.notation import Scalar, Wrench

if TYPE_CHECKING:
    from linkwright.graph.graph import Graph
    from linkwright.graph.view import View

FORCE = ("x", "y")
PLACE = ("at_x", "at_y")
MOMENT = "moment"


@dataclass(frozen=True)
class AppliedForce(ElementActionRow):
    """Of what an element applies: its force's ``x`` or ``y`` (N), where that acts, ``at_x`` or ``at_y`` (m), or its
    ``moment`` about this place (N m, counter-clockwise).

    ``index`` is its number among the element's wrenches, one for each link.
    """

    index: int
    part: str
    called = "{section}/{name}/{index}/{part}"

    def expression(self, view: View) -> Scalar:
        one = view.graph.actions.at[self.section, self.name]
        _, wrench = [*one.kind.wrenches(view, one.name, one.entry)][self.index]
        return _part(wrench, self.part)


@dataclass(frozen=True)
class DriveForce(Row):
    """Of the force that a drive exerts on the point that it moves: its ``x`` or ``y`` (N)."""

    drive: str
    part: str
    called = "drive/{drive}/{part}"

    def order(self, graph: Graph) -> int:
        return graph.actions.forces

    def expression(self, view: View) -> Scalar:
        link = view.geometry.mechanism.drives[self.drive].link
        return view.forces.efforts[self.drive] * getattr(view.motion.unit(self.drive)[link].force, self.part)


@dataclass(frozen=True)
class FrictionNumber(Row):
    """One of the numbers of the laws of friction, as :attr:`~linkwright.graph.friction.FrictionSystem.numbers` lists
    them."""

    index: int
    called = "friction/{index}"

    def order(self, graph: Graph) -> int:
        return graph.actions.forces

    def expression(self, view: View) -> Scalar:
        assert view.forces.friction is not None
        return view.forces.friction.numbers[self.index]


@dataclass(frozen=True)
class HoldingEffort(Row):
    """The torque (N m) or force (N) with which a drive holds a pose at rest without any friction."""

    drive: str
    called = "holding/{drive}"

    def order(self, graph: Graph) -> int:
        return graph.actions.forces

    def expression(self, view: View) -> Scalar:
        return view.breakaway(self.drive, 1, friction=False)


@dataclass(frozen=True)
class FrictionlessEffort(Row):
    """The torque (N m) or force (N) that a drive would need without any friction."""

    drive: str
    called = "frictionless/{drive}"

    def order(self, graph: Graph) -> int:
        return graph.actions.forces

    def expression(self, view: View) -> Scalar:
        assert view.forces.friction is not None
        return view.forces.friction.drives[self.drive]


@dataclass(frozen=True)
class Weight(Row):
    """The ``x`` or ``y`` of a link's weight (N), which acts at its centre of mass."""

    link: str
    part: str
    called = "weight/{link}/{part}"

    def expression(self, view: View) -> Scalar:
        mass, _, _ = view.geometry.mass(self.link)
        return mass * getattr(view.geometry.gravity(), self.part)


@dataclass(frozen=True)
class ReactionPlace(Row):
    """Where the reaction of a joint on a link is stated: the place's ``x`` or ``y`` (m)."""

    joint: str
    link: str
    part: str
    called = "place/{joint}/{link}/{part}"

    def expression(self, view: View) -> Scalar:
        kind = view.graph.structure.topology.kind_of(self.joint)
        return getattr(kind.reference(view.geometry, self.joint, self.link, view.bodies), self.part)


def _part(wrench: Wrench, part: str) -> Scalar:
    if part == MOMENT:
        return wrench.moment
    vector = wrench.about if part.startswith("at_") else wrench.force
    return getattr(vector, part[-1])
