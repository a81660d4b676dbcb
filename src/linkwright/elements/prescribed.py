"""What a drive prescribes of two links that share no joint for it: their angle, or the place of a point along a line.

No coordinate of a joint is given then. The drive states an equation between its links instead, which a group is solved
with (:class:`linkwright.structure.steps.HigherGroup`): the value of the closure here is the drive's law. The multiplier
is what the drive exerts: a torque between both links (N m), or a force at the point along the line (N).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

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
    register,
)
from linkwright.notation import Body, Jet, Pair
from linkwright.notation.planar import unit_vector


class Track(NamedTuple):
    """A ``point`` of the moved link, and the line of the other one along which its place counts: from ``base`` (m),
    at an ``angle`` (rad), each in its link's own axes."""

    point: Pair
    base: Pair
    angle: float

    def travel(self, link: Body, on: Body) -> Jet:
        """How far along the line the point lies (m), with its rates."""
        return link.point(self.point).minus(on.point(self.base)).dot(on.direction(unit_vector(self.angle)))


@dataclass(frozen=True)
class InnerAngle(Inner):
    """The angle of the first link relative to the second (rad), over whole turns where both are known."""

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        a, b = bodies
        return (Jet([a.heading - b.heading, *(a.turn - b.turn).d]),)


@dataclass(frozen=True)
class InnerTrack(Inner):
    """How far along the line a point of the first link lies (m)."""

    track: Track

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        return (self.track.travel(*bodies),)

    def place(self, bodies: Sequence[Body]) -> Pair | None:
        return bodies[0].point(self.track.point).now


class PrescribedKind(JointKind):
    """A drive's equation; its proof holds the links' reported poses against the law itself."""

    prescribed = True

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        """None: what a drive prescribes takes no mobility."""
        return []

    def applied(self, reports: JointReports, contact: ContactReaction) -> Applied:
        raise NotImplementedError  # a drive's effort stands for it (`Mover.applied`)


@register
class PrescribedAngle(PrescribedKind):
    """The angle of two links."""

    name = "prescribed_angle"
    letter = "A"
    row_units = ("angle",)

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerAngle:
        return InnerAngle()

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        return bodies[link].anchor.now

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        (cos_a, sin_a), (cos_b, sin_b) = (reports.rotated(link, (1.0, 0.0)) for link in links)
        turned = cos_a * cos_b + sin_a * sin_b + 1j * (sin_a * cos_b - cos_a * sin_b)
        return [Miss(np.abs(turned - np.exp(1j * reports.law(joint))), length=False)]


@register
class PrescribedPlace(PrescribedKind):
    """The place of a point along a line."""

    name = "prescribed_place"
    letter = "X"
    row_units = ("length",)

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerTrack:
        return InnerTrack(geometry.mechanism.prescribed(joint).track(geometry))

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        return bodies[link].anchor.now

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        track = reports.geometry.mechanism.prescribed(joint).track(reports.geometry)
        away = reports.point_position(links[0], track.point) - reports.point_position(links[1], track.base)
        along = reports.rotated(links[1], (np.cos(float(track.angle)), np.sin(float(track.angle))))
        return [Miss((away * along).sum(axis=0) - reports.law(joint), length=True)]
