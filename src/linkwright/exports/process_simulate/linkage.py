"""A mechanism as angles and vectors in joint values: what is placed so far, and what its joints are functions of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.exports.process_simulate.joints import ToolJoint
from linkwright.exports.process_simulate.trees import Array, Tree, add, evaluate, joint, multiply, number
from linkwright.exports.process_simulate.vectors import Angle, Arm, Vector
from linkwright.findings import Finding, Joined, enumerated
from linkwright.graph.geometry import Geometry
from linkwright.notation import Pair
from linkwright.structure import FRAME, Connection, Group, Structure, Wedge

MM = 1000.0
OWN = "?"
"""The symbol of a link's own angle while that isn't known."""


class Refused(Exception):
    """A joint has no function of the kind that is wanted; the finding says why."""

    def __init__(self, finding: Finding) -> None:
        super().__init__(finding.code)
        self.finding = finding


def shared_pin(drive: str, pin: str) -> Finding:
    """That the joint which a drive moves isn't one of the tool's."""
    return Finding("functions.shared-pin", ("exports", "process-simulate"), {"drive": drive, "pin": pin})


def wedge(step: Wedge) -> Finding:
    """That a link on two slides has no function."""
    data = {"links": Joined(step.links), "slides": enumerated([c.joint for c in step.outer])}
    return Finding("functions.wedge", ("exports", "process-simulate"), data)


@dataclass(frozen=True)
class LinkSeat:
    """How a link sits on another: its point ``foot`` at ``spot`` of ``base`` (m, each in its own frame), or off that
    by what a slide is out, in ``heading`` of the base."""

    base: str
    spot: Pair
    foot: Pair
    slide: str = ""
    heading: float = 0.0


@dataclass
class Linkage:
    """The links placed so far.

    ``poses`` are the driving joint's values (rad or mm, ascending) on which ranges are looked at, the zero pose 0 among
    them; ``symbols`` has what each symbol of an angle stands for, ``values`` its values there. ``functions`` are the
    dependent joints' in order, ``at_zero`` each joint's angle or slide at the zero pose, of the child less the parent.
    """

    structure: Structure
    geometry: Geometry
    branches: Mapping[Group, float]
    joints: list[ToolJoint]
    poses: Array
    symbols: dict[str, Tree] = field(default_factory=dict)
    values: dict[str, Array] = field(default_factory=dict)
    angles: dict[str, Angle] = field(default_factory=dict)
    seats: dict[str, LinkSeat] = field(default_factory=dict)
    at_zero: dict[str, float] = field(default_factory=dict)
    functions: dict[str, Tree] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.zero = int(np.flatnonzero(self.poses == 0.0)[0])
        self.angles[FRAME] = Angle()
        self.by_pair = {(j.of, j.parent, j.child): j for j in self.joints}

    # Joints.

    def between(self, name: str, a: str, b: str) -> tuple[ToolJoint | None, float]:
        """The joint of a pin or slide between two links, with -1 where b is its parent."""
        if (found := self.by_pair.get((name, a, b))) is not None:
            return found, 1.0
        return self.by_pair.get((name, b, a)), -1.0

    def drive(self, name: str, a: str, b: str, value: float) -> None:
        """Make a joint the driving one; ``value`` is b's angle (rad) or slide (mm) against a at the zero pose."""
        found, sign = self.between(name, a, b)
        if found is None:
            raise KeyError(name)
        self.at_zero[found.joint] = sign * value
        self.symbols[found.joint] = joint(found.kind, found.joint)
        self.values[found.joint] = self.poses

    def set_function(self, found: ToolJoint, tree: Tree) -> None:
        """Give a joint its function, from a tree of what the child is turned or slid against the parent."""
        values = self.numbers(tree)
        start = float(values[self.zero])
        function = multiply(number(found.sign), add(tree, number(-start)))
        self.at_zero[found.joint] = start
        self.values[found.joint] = found.sign * (values - start)
        if not found.left_out:
            self.functions[found.joint] = function
        self.symbols[found.joint] = function if found.left_out else joint(found.kind, found.joint)

    def hidden(self, tree: Tree) -> Angle:
        """A tree as an angle."""
        if tree.op == "number":
            return Angle(tree.value)
        symbol = f"{OWN}{len(self.symbols)}"
        self.symbols[symbol], self.values[symbol] = tree, self.numbers(tree)
        return Angle(0.0, ((symbol, 1),))

    def offset(self, found: ToolJoint) -> Angle:
        """The child's angle less the parent's, by the joint's value."""
        return Angle(self.at_zero[found.joint], ((found.joint, round(found.sign)),))

    def slide(self, name: str, base: str, link: str) -> Tree:
        """How far a link is out on its base along a slide (mm)."""
        found, sign = self.between(name, base, link)
        assert found is not None
        moved = multiply(number(found.sign), self.symbols[found.joint])
        return multiply(number(sign), add(moved, number(self.at_zero[found.joint])))

    # Numbers.

    def numbers(self, tree: Tree) -> Array:
        """The values of a tree over the poses."""
        return np.broadcast_to(evaluate(tree, self.values), self.poses.shape)

    def angle_values(self, angle: Angle) -> Array:
        """The values of an angle over the poses (rad)."""
        total = np.full(self.poses.shape, angle.constant)
        for symbol, count in angle.parts:
            total = total + count * self.values[symbol]
        return total

    # Places.

    def point(self, link: str, at: Pair) -> Vector:
        """A link's point from the frame's origin (mm), over the links that it sits on."""
        if link == FRAME:
            return Vector.fixed(MM * at.x, MM * at.y, Angle())
        seat = self.seats[link]
        return self.point(seat.base, seat.spot).plus(self.beyond(link, at))

    def beyond(self, link: str, at: Pair) -> Vector:
        """A link's point from the spot of its base on which it sits (mm)."""
        seat = self.seats[link]
        arm = Vector.fixed(MM * (at.x - seat.foot.x), MM * (at.y - seat.foot.y), self.angles[link])
        if not seat.slide:
            return arm
        out = Arm(self.slide(seat.slide, seat.base, link), self.angles[seat.base].rotated(seat.heading))
        return arm.plus(Vector((out,)))

    def pin(self, connection: Connection, link: str) -> Pair:
        """The place of a pin on a link (m, in its frame)."""
        pin = self.structure.topology.pins[connection.joint]
        return self.geometry.point(link, pin.point(link))

    def line(self, connection: Connection, link: str) -> tuple[Pair, float]:
        """A slide's point (m) and heading (rad) on a link, in its frame."""
        heading = float(self.geometry.heading_angle(connection.joint, link))
        return self.geometry.line(connection.joint, link)[0], heading

    def sit(self, connection: Connection, base: str, link: str) -> None:
        """Put a link on a base by a joint; of a slide, its angle follows."""
        if connection.kind.angular:
            self.seats[link] = LinkSeat(base, self.pin(connection, base), self.pin(connection, link))
            return
        (spot, heading), (foot, own) = self.line(connection, base), self.line(connection, link)
        self.seats[link] = LinkSeat(base, spot, foot, connection.joint, heading)
        self.angles[link] = self.angles[base].rotated(heading - own)

    def place_by_drive(self, connection: Connection, base: str, link: str) -> None:
        """Put a link on a base by the driving joint."""
        self.sit(connection, base, link)
        if connection.kind.angular:
            found, sign = self.between(connection.joint, base, link)
            assert found is not None
            self.angles[link] = self.angles[base].plus(self.offset(found), round(sign))

    # What a step leaves to be said.

    def turn(self, connection: Connection, base: str, link: str, angle: Angle) -> None:
        """Place a link by its angle, which a formula gives: the function of the joint with its base follows."""
        found, sign = self.between(connection.joint, base, link)
        self.angles[link] = angle
        if found is None or found.joint in self.at_zero:
            return
        self.set_function(found, Angle().plus(angle.minus(self.angles[base]), round(sign)).tree(self.symbols))
        if not found.left_out:
            self.angles[link] = self.angles[base].plus(self.offset(found), round(sign))

    def out(self, connection: Connection, base: str, link: str, tree: Tree) -> None:
        """The function of a slide, from how far a link is out on its base (mm)."""
        found, sign = self.between(connection.joint, base, link)
        assert found is not None
        self.set_function(found, multiply(number(sign), tree))

    def finish(self) -> None:
        """The functions of the pins that no formula has given, as sums; then each link's angle by the fewest joints."""
        for found in self.joints:
            known = found.parent in self.angles and found.child in self.angles
            if found.kind == "T" and known and found.joint not in self.at_zero:
                between = self.angles[found.child].minus(self.angles[found.parent])
                self.set_function(found, between.tree(self.symbols))
                self._shorten(found)
        for found in self.joints:
            if found.kind == "T" and found.joint in self.at_zero:
                self._shorten(found)

    def _shorten(self, found: ToolJoint) -> None:
        if found.left_out:
            return
        for here, there, sign in ((found.parent, found.child, 1), (found.child, found.parent, -1)):
            if there != FRAME and {here, there} <= self.angles.keys():
                other = self.angles[here].plus(self.offset(found), sign)
                if self._weight(other) < self._weight(self.angles[there]):
                    self.angles[there] = other

    def _weight(self, angle: Angle) -> int:
        """How much there is to write for an angle."""
        return sum(1 if self.symbols[s].op in ("T", "D") else 10 for s, _ in angle.parts)

    def where(self, angle: Angle) -> Joined:
        """The joints whose values an angle holds, in words."""
        names = [tree.name for s, _ in angle.parts for tree in self.symbols[s].every() if tree.name]
        return Joined(dict.fromkeys(names))
