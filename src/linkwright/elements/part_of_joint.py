"""What is left of a joint of which one equation follows from the rest of the mechanism: the other equation alone.

The groups of a redundant mechanism are solved with these kinds instead of the whole joint; the whole one stays what is
drawn, reported and proven. Each states what its joint has of equations besides, as multipliers of the whole closure.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, ClassVar

from linkwright.data_classes import dataclass
from linkwright.elements.joint import (
    Applied,
    ContactReaction,
    Inner,
    JointGeometry,
    JointKind,
    JointReports,
    Miss,
    Rate,
    kind,
)
from linkwright.findings import Term
from linkwright.notation import Body, Jet, Pair, Scalar


@dataclass(frozen=True)
class InnerAcross(Inner):
    """A pin that two links share in one direction: the normal of a ``heading`` of one of them (``index``)."""

    whole: Inner
    index: int
    heading: Pair

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        x, y = self.whole.gap(*bodies)
        normal = bodies[self.index].direction(self.heading).perp
        return (x * normal.x + y * normal.y,)


@dataclass(frozen=True)
class InnerEquation(Inner):
    """One equation of a closure."""

    whole: Inner
    index: int

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        return (self.whole.gap(*bodies)[self.index],)


class PartOfJoint(JointKind):
    """A joint with one equation; all that is reported or proven of it asks the ``whole`` kind."""

    letter = "I"
    keeps_direction: ClassVar[bool] = False
    """Whether the equation that is left is that of the directions of a slide."""

    @property
    def whole(self) -> JointKind:
        """The kind of the whole joint."""
        raise NotImplementedError

    def dropped(
        self, geometry: JointGeometry, joint: str, links: Sequence[str], bodies: Sequence[Body]
    ) -> list[Scalar]:
        """The multipliers of the whole closure that stand for a unit of the equation left out."""
        raise NotImplementedError

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), tuple(vars(self).values())  # no registered kind, but a value

    @property
    def title(self) -> Term:
        return self.whole.title

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        return self.whole.reference(geometry, joint, link, bodies)

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        return self.whole.misses(reports, joint, links)

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        return self.whole.constraints(reports, joint, links)

    def applied(self, reports: JointReports, contact: ContactReaction) -> Applied:
        return self.whole.applied(reports, contact)


@dataclass(frozen=True)
class PinAcross(PartOfJoint):
    """A pin that holds its links across a direction: that from it to a point of one ``link``, or with ``turned`` the
    normal of that. Along it they are held by others."""

    link: str
    point: str
    turned: bool = False
    name = "pin_across"
    row_units = ("length",)

    @property
    def whole(self) -> JointKind:
        return kind("revolute")

    def heading(self, geometry: JointGeometry, joint: str) -> Pair:
        """The direction along which the pin holds nothing, in the link's frame."""
        away = geometry.point(self.link, self.point).minus(geometry.pin_point(joint, self.link))
        size = away.length
        along = Pair(away.x / size, away.y / size)
        return along.perp if self.turned else along

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerAcross:
        whole = self.whole.inner(geometry, joint, links)
        return InnerAcross(whole, list(links).index(self.link), self.heading(geometry, joint))

    def dropped(
        self, geometry: JointGeometry, joint: str, links: Sequence[str], bodies: Sequence[Body]
    ) -> list[Scalar]:
        return [*bodies[list(links).index(self.link)].direction(self.heading(geometry, joint)).now]


class PartOfSlide(PartOfJoint):
    """A slide with the equation ``index`` of its closure."""

    index: ClassVar[int]

    @property
    def whole(self) -> JointKind:
        return kind("prismatic")

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerEquation:
        return InnerEquation(self.whole.inner(geometry, joint, links), self.index)

    def dropped(
        self, geometry: JointGeometry, joint: str, links: Sequence[str], bodies: Sequence[Body]
    ) -> list[Scalar]:
        return [float(i != self.index) for i in range(self.whole.rows)]


@dataclass(frozen=True)
class SlideAcross(PartOfSlide):
    """A slide that holds the second link's point on the first one's line; others hold its direction."""

    name = "slide_across"
    index = 1
    row_units = ("length",)


@dataclass(frozen=True)
class SlideParallel(PartOfSlide):
    """A slide that holds the directions of its links; others hold the place across."""

    name = "slide_parallel"
    index = 0
    keeps_direction = True
    row_units = ("angle",)
