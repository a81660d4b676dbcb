"""The Geneva drive as a follower: a wheel whose angle is a function of the angle of its driver, which a drive turns."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, ClassVar

from linkwright.data_classes import dataclass
from linkwright.elements.curves import Curve
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
from linkwright.elements.geneva import proof
from linkwright.elements.geneva.contact import Dimensions, Indexing, contact
from linkwright.elements.geneva.entry import GenevaEntry
from linkwright.elements.geneva.sentence import sentence
from linkwright.elements.geneva.shape import outline
from linkwright.elements.geneva.uncovered_horn import unsupported
from linkwright.elements.joint import Applied, Miss, Restated
from linkwright.elements.points import FRAME
from linkwright.expressions import units as u
from linkwright.expressions.language import Binary, Call, Name, Node
from linkwright.expressions.typed_fields import Path
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, Said
from linkwright.notation import Jet, Scalar


@register_follower
@dataclass(frozen=True)
class GenevaDrive(Follower):
    """A wheel that a driver indexes and locks; its effort is the force of the driver on the wheel, positive where it
    turns the wheel counter-clockwise. ``shafts`` are the carrier's points at the centres of driver and wheel."""

    shafts: tuple[str, str] = ("", "")

    kind: ClassVar[str] = "geneva"
    stated: ClassVar[type[Any]] = GenevaEntry

    @classmethod
    def read(cls, m: Any, name: str, pins: Mapping[str, Any]) -> GenevaDrive | list[Finding]:
        entry: GenevaEntry = m.joints[name]
        path, (driver, wheel) = ("joints", name), entry.wheels
        if any(point not in m.links[driver].points for point in (*entry.pins, entry.centres[0])):
            return []  # told with all names of points
        shafts = entry.carrier_points(m)
        turning = ((name, one) for name, one in m.drives.items() if one.turns and one.output is None)
        motor = next((name for name, one in turning if {one.link, one.on} == {driver, entry.carrier}), None)
        if entry.carrier == FRAME and FRAME in entry.wheels:
            return [Finding("geneva.frame", path)]
        if len({driver, wheel, entry.carrier}) < 3 or None in shafts:
            return []  # told with how it lies among the links
        if motor is None:
            return [Finding("geneva.motor", path, {"driver": driver, "carrier": entry.carrier})]
        sign = 1 if m.drives[motor].link == driver else -1
        ends = str(shafts[0]), str(shafts[1])
        return cls(entry, wheel, entry.carrier, turning=True, motor=motor, motor_sign=sign, shafts=ends)

    @property
    def geneva(self) -> GenevaEntry:
        """What the file says of it."""
        entry: GenevaEntry = self.entry
        return entry

    @property
    def has_second_contact(self) -> bool:
        return True  # the other flank of a slot, the other horn of an arc

    @property
    def effort(self) -> str:
        return "force"

    @property
    def extra(self) -> Mapping[str, Dimension]:
        return {"arm": u.LENGTH, "engaged": u.PURE}

    @property
    def charts(self) -> Sequence[SignalChart]:
        return [SignalChart("follower", "force", self.effort), SignalChart("follower", "motion", "engaged")]

    def relation(self, geometry: FollowerGeometry, motions: Motions) -> MotorRelation:
        indexing = Indexing(self, Dimensions.of(geometry, self))

        def value(at: FollowerGeometry, motor: Jet) -> Jet:
            return indexing.value(Dimensions.of(at, self), motor)

        return MotorRelation(value)

    def acting(self, name: str, poses: PoseQuery, ratio: Scalar) -> UnitEffort:
        return contact(poses, self)

    def second(self, name: str, poses: PoseQuery, ratio: Scalar, total: Scalar) -> UnitEffort:
        return contact(poses, self, -1)

    def joins(self, geometry: FollowerGeometry) -> list[Node]:
        """Where pins enter and leave slots: the place of each along the line of centres less r sin(pi/n)."""
        first, second = self.geneva.centres
        half = Call("sin", (Binary("/", Name("pi"), geometry.bind(self.geneva.slots, u.PURE)),))
        line, found = _between(first, second), list[Node]()
        for pin in self.geneva.pins:
            arm = _between(first, pin)
            along = Binary("+", *(Binary("*", a, b) for a, b in zip(arm, line, strict=True)))
            size = Binary("*", Call("hypot", arm), Call("hypot", line))
            found.append(Binary("-", Binary("/", along, size), half))
        return found

    def sentence(self, geometry: FollowerGeometry) -> Said:
        return sentence(geometry, self)

    def outline(self, geometry: FollowerGeometry) -> list[Curve]:
        return outline(Dimensions.of(geometry, self), *self.geneva.wheels, geometry.nominal, self.geneva)

    def findings(self, run: FollowedMotion, path: Path) -> Iterator[Finding]:
        return unsupported(run, path, self)

    # The proof.

    @property
    def reported(self) -> Sequence[str]:
        return ["engaged"]

    def misses(self, reports: FollowerReports, name: str) -> list[Miss]:
        return proof.misses(reports, self, name)

    def restated(self, reports: FollowerReports, name: str) -> dict[str, Restated]:
        return proof.restated(reports, self, name)

    def applied(self, reports: FollowerReports, name: str) -> list[Applied]:
        return proof.applied(reports, self, name)


def _between(start: str, end: str) -> tuple[Node, Node]:
    """The vector between two points, as signals."""
    return (
        Binary("-", Name(f"{end}.x"), Name(f"{start}.x")),
        Binary("-", Name(f"{end}.y"), Name(f"{start}.y")),
    )
