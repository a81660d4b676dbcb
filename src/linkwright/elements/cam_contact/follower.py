"""The cam contact: a follower that rides on a plate cam by a law over the cam's angle."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, ClassVar

from linkwright.data_classes import dataclass
from linkwright.elements.cam_contact import contact as contacts
from linkwright.elements.cam_contact import proof
from linkwright.elements.cam_contact.entry import Cam
from linkwright.elements.cam_contact.entry_reader import read
from linkwright.elements.cam_contact.faults import faults, loose, not_whole
from linkwright.elements.cam_contact.second import largest, other_side, second
from linkwright.elements.follower import (
    FollowedMotion,
    Follower,
    FollowerGeometry,
    FollowerReports,
    Motions,
    MotorRelation,
    PoseQuery,
    UnitEffort,
    register_follower,
)
from linkwright.elements.force import SignalChart
from linkwright.elements.joint import Applied, Miss, Restated
from linkwright.elements.touch import ReportedTouch, Touch
from linkwright.expressions import units as u
from linkwright.expressions.language import Call, Node
from linkwright.expressions.typed_fields import Path
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding
from linkwright.laws import Motion
from linkwright.notation import Jet, Pair, Scalar


@register_follower
@dataclass(frozen=True)
class CamFollower(Follower):
    """A follower on its cam; its effort is the force in the contact.

    ``shaft`` are the points of cam and carrier on the cam's pin, ``pivot`` those of follower and carrier on the
    follower's. ``motor_sign`` is +1 where the motor's value is the cam's angle on the carrier, -1 where it is the
    carrier's on the cam. ``side`` is +1 where the follower's contact lies left of the line from shaft to pivot, or
    where it rises along the slide; else -1.
    """

    shaft: tuple[str, str] = ("", "")
    pivot: tuple[str, str] | None = None
    side: int = 1

    kind: ClassVar[str] = "cam"
    stated: ClassVar[type[Any]] = Cam
    lifts: ClassVar[str] = "cam.lifts-off"
    locks: ClassVar[str] = "cam.locks"

    @classmethod
    def read(cls, m: Any, name: str, pins: Mapping[str, Any]) -> CamFollower | list[Finding]:
        found = read(m, name, pins)
        return cls(**found) if isinstance(found, dict) else found

    @property
    def cam(self) -> Cam:
        """What the file says of it."""
        entry: Cam = self.entry
        return entry

    @property
    def has_second_contact(self) -> bool:
        return self.cam.closed in ("conjugate", "yoke")

    @property
    def derived(self) -> bool:
        return self.has_second_contact and (self.cam.second is None or self.cam.second.touches is None)

    @property
    def effort(self) -> str:
        return "force"

    @property
    def extra(self) -> Mapping[str, Dimension]:
        return {"pressure": u.ANGLE, **({"pressure_second": u.ANGLE} if self.has_second_contact else {})}

    @property
    def charts(self) -> Sequence[SignalChart]:
        return [
            SignalChart("contact", "force", self.effort),
            *(SignalChart("pressure", "force", angle) for angle in self.extra),
        ]

    @property
    def touching(self) -> tuple[str, str]:
        return self.link, self.cam.cam

    @property
    def roller(self) -> Any:
        return self.cam.roller

    def touch(self, name: str, poses: PoseQuery, acting: UnitEffort) -> Touch:
        push = acting.wrenches[self.link]
        size = 0.0 if self.roller is None else poses.geometry.number(self.roller, u.LENGTH)
        place, normal = push.about, push.force
        return Touch(Pair(place.x - size * normal.x, place.y - size * normal.y), normal)

    def reported_touch(self, reports: FollowerReports, name: str) -> ReportedTouch:
        return proof.touch(reports, self, name)

    @property
    def pressures(self) -> Sequence[str]:
        return [*self.extra]

    @property
    def laws(self) -> Mapping[str, str]:
        return {"law": self.cam.law}

    def relation(self, geometry: FollowerGeometry, motions: Motions) -> MotorRelation:
        motion, turn = motions[self.cam.law], contacts.base_circle_turns(geometry, self)
        factor = float(contacts.sense(geometry, self) * self.motor_sign)

        def value(at: FollowerGeometry, angle: Jet) -> Jet:
            here = contacts.seat(at, self)
            lift = motion.at_parameters(at.parameters).on(factor * angle + at.number(self.cam.phase, u.ANGLE))
            found: Jet = here.sign * lift + (here.offset + here.sign * here.start - turn)
            return found

        return MotorRelation(value, largest(self, motion) if self.derived else 0.0)

    def acting(self, name: str, poses: PoseQuery, ratio: Scalar) -> UnitEffort:
        return contacts.contact(poses, self, ratio)

    def second(self, name: str, poses: PoseQuery, ratio: Scalar, total: Scalar) -> UnitEffort | None:
        if not self.has_second_contact:
            return None
        what = second(poses.geometry, self, total)
        return contacts.contact(poses, other_side(self), ratio, what, "pressure_second")

    def tree(self, geometry: FollowerGeometry, motor: Node) -> Node:
        return contacts.tree(geometry, self, motor)

    def calls(self, geometry: FollowerGeometry) -> list[Call]:
        return [Call(self.cam.law, (contacts.argument(geometry, self),))]

    def step(self, motions: Motions) -> float:
        shortest: float = min(part.stop - part.start for part in motions[self.cam.law].curve.parts)
        return shortest / 2

    def faults(self, quantities: Any, geometry: FollowerGeometry, motions: Motions, path: Path) -> Iterator[Finding]:
        yield from faults(quantities, geometry, path, self, motions.get(self.cam.law))

    def law_faults(self, quantities: Any, law: str, motion: Motion, path: Path) -> Iterator[tuple[Finding, Any]]:
        return not_whole(quantities, law, motion, path)

    def findings(self, run: FollowedMotion, path: Path) -> Iterator[Finding]:
        return loose(run, path, self)

    def misses(self, reports: FollowerReports, name: str) -> list[Miss]:
        return proof.misses(reports, self)

    def restated(self, reports: FollowerReports, name: str) -> dict[str, Restated]:
        return proof.restated(reports, self)

    def applied(self, reports: FollowerReports, name: str) -> list[Applied]:
        return proof.applied(reports, self, name)
