"""A differential: shafts whose angles on a common housing keep one linear relation, such as a bevel gear differential.

With the angles theta_i of the links relative to the link ``on`` and the weights w_i of the file

    w_1 theta_1 + w_2 theta_2 + ... + w_n theta_n = constant,

where the pose in which the links are drawn fixes the constant. By duality the torques that the shafts pass into the
differential are in the ratio of the weights, T_i/w_i = T_1/w_1, and their sum goes into ``on``: w_1 + ... + w_n = 0
leaves the housing without torque. Wheels and planets inside are massless, without losses, and none of their forces is
known: only torques pass.

A bevel gear differential has the weights [2, -1, -1] of its cage and both side gears; a planetary gear set with z_s and
z_r teeth of sun and ring [z_s, z_r, -(z_s + z_r)] of sun, ring and arm. Source: J. J. Uicker, G. R. Pennock, J. E.
Shigley, Theory of Machines and Mechanisms, 4th ed. (2011), ch. 9 (Willis' formula; differentials).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Annotated, Any, ClassVar, Self

import numpy as np
from pydantic import BeforeValidator

from linkwright.data_classes import dataclass
from linkwright.elements.curves import Curve, spoked
from linkwright.elements.entries import JointEntry, NumberFault
from linkwright.elements.fields import LinkName
from linkwright.elements.joint import (
    Applied,
    Array,
    ContactReaction,
    Inner,
    JointGeometry,
    JointKind,
    JointReports,
    Miss,
    Rate,
    Reaction,
    Restated,
    register,
)
from linkwright.elements.mirror import Mirror
from linkwright.elements.pins import pins
from linkwright.elements.pitch import continuous_angle
from linkwright.elements.points import FRAME
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.expressions.units import Dimension
from linkwright.expressions.written import FaultWithin, unexpected
from linkwright.notation import Body, Jet, Pair, Scalar
from linkwright.notation.jets import call

LEAST = 3
"""The fewest shafts: of two there is a ratio, which a coupling or gears have."""
MOST = 20
"""The most shafts."""
DRAWN = 0.3
"""The radius of a shaft's wheel in drawings, over the distance of its link's first other point."""


def _several(wanted: str) -> Callable[[Any], Any]:
    """A validator of lists of three entries or more; ``wanted`` is the phrase that says what they hold."""

    def check(raw: Any) -> Any:
        if not isinstance(raw, list | tuple) or not LEAST <= len(raw) <= MOST:
            raise unexpected(wanted, raw)
        return tuple(raw)

    return check


class DifferentialEntry(JointEntry):
    """Shafts whose angles keep a linear relation."""

    kind: ClassVar[str] = "differential"
    signals: ClassVar[Mapping[str, Dimension]] = {"torque": u.TORQUE}
    couple: ClassVar[bool] = True

    differential: Annotated[tuple[LinkName, ...], BeforeValidator(_several("three-links"))]
    weights: Annotated[
        Annotated[tuple[Expression, ...], BeforeValidator(_several("three-numbers"))], Quantity(u.PURE, whole=True)
    ]
    on: Annotated[Name, Ref("link")] = FRAME

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[FaultWithin]:
        shafts, weights = given.get("differential"), given.get("weights")
        if isinstance(shafts, list | tuple) and isinstance(weights, list | tuple) and len(shafts) != len(weights):
            yield "differential.count", {"shafts": len(shafts), "weights": len(weights)}, "weights"

    def mirrored(self, name: str, mirror: Mirror) -> Self:
        """The same differential seen in a mirror: all shafts turn the other way round."""
        mirror.holds(*self.links)
        return self

    @property
    def links(self) -> tuple[str, ...]:
        """The shafts, then the link on which their angles count."""
        return (*self.differential, self.on)

    @property
    def joint_points(self) -> tuple[str, ...]:
        return ()

    def number_faults(self, value: Callable[[Expression, Dimension], Any]) -> Iterator[NumberFault]:
        for link, weight in zip(self.differential, self.weights, strict=True):
            size = call("abs", value(weight, u.PURE))
            yield size, Sign.POSITIVE, ("differential.weight", {"link": link}, "weights")


@dataclass(frozen=True)
class InnerDifferential(Inner):
    """The relation as a closure between the shafts and, last, the link ``on``; the drawing fixes the ``constant``."""

    weights: tuple[Scalar, ...]
    constant: Scalar

    def turned(self, bodies: Sequence[Body]) -> Scalar:
        """What stays constant (rad)."""
        on = continuous_angle(bodies[-1])
        found: Scalar = 0.0
        for weight, body in zip(self.weights, bodies, strict=False):
            found = found + weight * (continuous_angle(body) - on)
        return found

    def gap(self, *bodies: Body) -> tuple[Jet, ...]:
        """Closure (rad): by what the weighted angles miss their sum in the drawing."""
        rates = Jet([0.0] * len(bodies[-1].turn.d))
        for weight, body in zip(self.weights, bodies, strict=False):
            rates = rates + (body.turn - bodies[-1].turn) * weight
        return (Jet([self.turned(bodies) - self.constant, *rates.d]),)


@register
class Differential(JointKind):
    """Shafts whose angles keep a linear relation."""

    name = "differential"
    letter = "Y"
    row_units = ("angle",)
    entry = DifferentialEntry
    phased = True
    winds = True
    orders: ClassVar[Mapping[str, int]] = {"torque": 2}

    def inner(self, geometry: JointGeometry, joint: str, links: Sequence[str]) -> InnerDifferential:
        weights, angles = self.weights(geometry, joint), geometry.phases(joint) or ()
        return InnerDifferential(weights, sum((w * a for w, a in zip(weights, angles, strict=False)), 0.0))

    def weights(self, geometry: JointGeometry, joint: str) -> tuple[Scalar, ...]:
        """The weights of an entry."""
        return tuple(geometry.number(weight, u.PURE) for weight in geometry.mechanism.joints[joint].weights)

    def phase(self, geometry: JointGeometry, joint: str, bodies: Mapping[str, Body]) -> tuple[float, ...]:
        *shafts, on = (continuous_angle(bodies[link]) for link in geometry.mechanism.joints[joint].links)
        return tuple(float(shaft - on) for shaft in shafts)

    def reference(self, geometry: JointGeometry, joint: str, link: str, bodies: Mapping[str, Body]) -> Pair:
        """The link's origin; a torque is the same about every place."""
        return bodies[link].anchor.now

    def signal(
        self, geometry: JointGeometry, joint: str, attribute: str, bodies: Mapping[str, Body], reaction: Reaction
    ) -> Scalar:
        """The torque (N m) that the first shaft passes into the differential."""
        return reaction(geometry.mechanism.joints[joint].differential[0]).moment

    def outline(self, geometry: JointGeometry, joint: str, low: Scalar, high: Scalar) -> list[Curve]:
        """A wheel with a spoke on each shaft that is pinned to the link ``on``: the smaller, the more its angle
        counts."""
        m, weights = geometry.mechanism, self.weights(geometry, joint)
        entry, found = m.joints[joint], list[Curve]()
        for link, weight in zip(entry.differential, weights, strict=True):
            points = iter(m.links[link].points)
            pin = next((p.point(link) for p in pins(m).values() if {link, entry.on} <= {*p.links}), None)
            other = next((point for point in points if point != pin), None)
            if pin is None or other is None:
                continue
            centre = geometry.point(link, pin)
            away = geometry.point(link, other).minus(centre)
            size = away.length * DRAWN / call("abs", weight / weights[0])
            found += spoked(link, centre, size)
        return found

    # The proof: the relation once more from reported directions and rates, the torques from those reported.

    def misses(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[Miss]:
        *shafts, on = (reports.turned(link) for link in links)
        weights = [float(weight) for weight in self.weights(reports.geometry, joint)]
        total = sum(weight * (shaft - on) for weight, shaft in zip(weights, shafts, strict=True))
        missed = np.asarray(total)
        return [Miss(missed - missed[0], length=False)]

    def constraints(self, reports: JointReports, joint: str, links: Sequence[str]) -> list[list[Rate]]:
        weights = [float(weight) for weight in self.weights(reports.geometry, joint)]
        *shafts, on = links
        rates = [Rate(link, weight) for link, weight in zip(shafts, weights, strict=True)]
        return [[*rates, Rate(on, -sum(weights))]]

    def applied(self, reports: JointReports, contact: ContactReaction) -> Applied:
        # Reported are the link's force on the others, which is none, and its torque; it gets the opposite.
        force, moment = reports.reaction(contact)
        place = reports.point_position(contact.link, (0.0, 0.0))
        return contact.link, -np.asarray(force), place, -moment

    def restated(self, reports: JointReports, joint: str) -> dict[str, Restated]:
        """The reported reaction's moment of the first shaft."""
        first = reports.geometry.mechanism.joints[joint].differential[0]
        return {"torque": Restated(np.asarray(reports.reaction(reports.contact(joint, first))[1]))}

    def misfits(self, reports: JointReports, joint: str) -> list[Array]:
        """By what reported torques miss the ratio of the weights, and what forces are reported."""
        entry = reports.geometry.mechanism.joints[joint]
        weights = [float(weight) for weight in self.weights(reports.geometry, joint)]
        reported = [reports.reaction(reports.contact(joint, link)) for link in entry.links]
        share = np.asarray(reported[0][1]) / weights[0]
        factors = [*weights, -sum(weights)]
        torques = [np.asarray(moment) - factor * share for (_, moment), factor in zip(reported, factors, strict=True)]
        return [*torques, *(row for force, _ in reported for row in np.asarray(force))]
