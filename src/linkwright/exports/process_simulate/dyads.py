"""What each dyad says of its joints: the directions of its links by its closed form, a class under its signature.

The formulas are derived in docs/theory.md, "Joint functions". A side of a dyad is a link on a known one, or several
that the driving joint holds on each other.
"""

from __future__ import annotations

import math
from typing import ClassVar

from linkwright.data_classes import dataclass
from linkwright.exports.process_simulate.dialects import Dialect, Triangle
from linkwright.exports.process_simulate.linkage import MM, OWN, Linkage
from linkwright.exports.process_simulate.trees import Tree, add, call, divide, multiply, negated, number
from linkwright.exports.process_simulate.vectors import Angle, Vector, cosine, sine
from linkwright.notation import Pair
from linkwright.notation.registry import Registry
from linkwright.structure import Chain, Connection, Group

STRAIGHT = 1e-12
"""An offset of a sliding line from its pins below this share of the links is none."""


@dataclass(frozen=True)
class DyadSide:
    """One side: the known ``base``, the link ``end`` on it by the joint ``outer``, and the link ``meeting`` the other
    side."""

    links: Linkage
    base: str
    end: str
    meeting: str
    outer: Connection
    chain: Chain

    def place(self) -> None:
        """Put its links on the base; the end's angle is open where a pin holds it."""
        if self.outer.kind.angular:
            self.links.angles[self.end] = Angle(0.0, ((OWN, 1),))
        self.links.sit(self.outer, self.base, self.end)
        self.place_chain()

    def place_chain(self) -> None:
        """Put its further links on the end."""
        for edge in self.chain:
            self.links.place_by_drive(edge.joint, edge.base, edge.link)

    @property
    def meeting_angle(self) -> Angle:
        """The angle of the link at the inner joint against the end."""
        return self.links.angles[self.meeting].minus(self.links.angles[self.end])

    def arm(self, to: Pair) -> Vector:
        """From the outer joint to a place of the link at the inner joint, seen from the end (mm)."""
        links = self.links
        seat = links.seats[self.end]
        start, stop = _on(links, self.end, self.end, seat.foot), _on(links, self.end, self.meeting, to)
        return stop.minus(start).rotated(Angle().minus(links.angles[self.end]))

    @property
    def start(self) -> Vector:
        """The outer joint on the known link (mm)."""
        seat = self.links.seats[self.end]
        return self.links.point(self.base, seat.spot)

    @property
    def line(self) -> Angle:
        """The heading of the known line on which the end slides."""
        return self.links.angles[self.base].rotated(self.links.seats[self.end].heading)

    def turn(self, angle: Angle) -> None:
        """Give the end its angle."""
        self.links.turn(self.outer, self.base, self.end, angle)
        self.place_chain()

    def out(self, tree: Tree) -> None:
        """Give the end how far it is out on its line (mm)."""
        self.links.out(self.outer, self.base, self.end, tree)

    @property
    def has_outer_joint(self) -> bool:
        """Whether the tool has its outer joint."""
        found, _ = self.links.between(self.outer.joint, self.base, self.end)
        return found is not None and not found.left_out


def _on(links: Linkage, end: str, link: str, at: Pair) -> Vector:
    """A place of a side's link from the end's origin (mm)."""
    if link == end:
        return Vector.fixed(MM * at.x, MM * at.y, links.angles[end])
    seat = links.seats[link]
    return _on(links, end, seat.base, seat.spot).plus(links.beyond(link, at))


class Rule:
    """The functions of one kind of dyad."""

    signature: ClassVar[str]

    def apply(self, links: Linkage, dialect: Dialect, group: Group, first: DyadSide, second: DyadSide) -> None:
        """Place the links, and give the joints their functions."""
        raise NotImplementedError


RULES: Registry[Rule] = Registry()


def register(cls: type[Rule]) -> type[Rule]:
    """Register the rule of a dyad under its signature; a second one of the same signature is an error."""
    RULES[cls.signature] = cls()
    return cls


def solve(links: Linkage, dialect: Dialect, group: Group) -> None:
    """The functions of a dyad's joints."""
    first, second = (
        DyadSide(links, base, side[0], side[-1], outer, chain)
        for base, side, outer, chain in zip(group.bases, group.sides, group.outer, group.chains, strict=True)
    )
    for side in (first, second):
        side.place()
    RULES[group.signature].apply(links, dialect, group, first, second)
    links.finish()


@register
class RRR(Rule):
    """Law of cosines at the inner pin, and at one of the outer pins from the line between them."""

    signature = "RRR"

    def apply(self, links: Linkage, dialect: Dialect, group: Group, first: DyadSide, second: DyadSide) -> None:
        sides, branch = (first, second), links.branches[group]
        arms = tuple(side.arm(links.pin(group.inner, side.meeting)) for side in sides)
        base = second.start.minus(first.start)
        own = [dialect.aim(links, arm) for arm in arms]
        l1, l2 = (dialect.length(links, arm) for arm in arms)
        squares = [arm.square(links.symbols) for arm in arms]
        above = add(*squares, negated(base.square(links.symbols)))
        opening = call("acos", divide(above, multiply(number(2.0), l1, l2)))
        # From the first arm to the second, and what that makes between the links that meet.
        bend = Angle().plus(links.hidden(opening), round(branch))
        apart = bend.plus(own[0]).minus(own[1])
        meeting = apart.plus(second.meeting_angle).minus(first.meeting_angle)
        inner, sign = links.between(group.inner.joint, first.meeting, second.meeting)
        if inner is not None:
            links.set_function(inner, Angle().plus(meeting, round(sign)).tree(links.symbols))
            if not inner.left_out:
                meeting = Angle().plus(links.offset(inner), round(sign))
                apart = meeting.minus(second.meeting_angle).plus(first.meeting_angle)
                bend = apart.plus(own[1]).minus(own[0])
        triangle = Triangle(base, (arms[0], arms[1]), (l1, l2), branch, bend)
        order = list(links.seats)
        side = max(
            (0, 1),
            key=lambda k: (sides[k].has_outer_joint, order.index(sides[k].base) if sides[k].base in order else -1),
        )
        heading = dialect.aim(links, base, links.angles[sides[side].base]).rotated(math.pi * side)
        angle = heading.plus(dialect.from_base(links, triangle, side)).minus(own[side])
        sides[side].turn(angle)
        there = links.angles[sides[side].end].plus(apart, (1, -1)[side])
        other = sides[1 - side]
        links.angles[other.end] = there
        other.place_chain()


@register
class RRP(Rule):
    """A circle and a line: the arm by how far the line passes aside of the pin."""

    signature = "RRP"

    def apply(self, links: Linkage, dialect: Dialect, group: Group, first: DyadSide, second: DyadSide) -> None:
        branch, symbols, line = links.branches[group], links.symbols, second.line
        arm = first.arm(links.pin(group.inner, first.meeting))
        offset = second.arm(links.pin(group.inner, second.meeting)).rotated(links.angles[second.end])
        start = second.start.minus(first.start).plus(offset)
        aside = start.across(line, symbols)
        lean = links.hidden(call("acos", divide(aside, dialect.length(links, arm))))
        heading = line.rotated(math.pi / 2).plus(lean, -round(branch))
        first.turn(heading.minus(dialect.aim(links, arm)))
        ahead = dialect.root(links, arm.rotated(links.angles[first.end]), aside, line, branch)
        second.out(add(ahead, negated(start.along(line, symbols))))


@register
class RPR(Rule):
    """The line between the outer pins is the sliding line, or off it by a fixed distance."""

    signature = "RPR"

    def apply(self, links: Linkage, dialect: Dialect, group: Group, first: DyadSide, second: DyadSide) -> None:
        branch, symbols, sides = links.branches[group], links.symbols, (first, second)
        base = second.start.minus(first.start)
        ends = [links.line(group.inner, side.meeting) for side in sides]
        headings = [side.meeting_angle.rotated(angle) for side, (_, angle) in zip(sides, ends, strict=True)]
        arms = [side.arm(point) for side, (point, _) in zip(sides, ends, strict=True)]
        seen = [arm.rotated(Angle().minus(heading)) for arm, heading in zip(arms, headings, strict=True)]
        between = seen[0].minus(seen[1])
        across, along = between.across(Angle(), symbols), between.along(Angle(), symbols)
        side = 0 if first.has_outer_joint else 1
        aim = dialect.aim(links, base, links.angles[sides[side].base])
        size = float(abs(links.numbers(base.square(symbols))).max()) ** 0.5
        if abs(links.numbers(across)).max() <= STRAIGHT * size:
            across = number(0.0)
            heading = aim.rotated(0.0 if branch > 0 else math.pi)
        else:
            lean = links.hidden(call("acos", divide(across, dialect.length(links, base))))
            heading = aim.rotated(-math.pi / 2).plus(lean, round(branch))
        sides[side].turn(heading.minus(headings[side]))
        heading = links.angles[sides[side].end].plus(headings[side])
        other = sides[1 - side]
        links.angles[other.end] = heading.minus(headings[1 - side])
        other.place_chain()
        reach = dialect.root(links, base, across, heading, branch)
        links.out(group.inner, first.meeting, second.meeting, add(reach, negated(along)))


@register
class PRP(Rule):
    """Two lines meet."""

    signature = "PRP"

    def apply(self, links: Linkage, dialect: Dialect, group: Group, first: DyadSide, second: DyadSide) -> None:
        symbols, lines, starts = links.symbols, (first.line, second.line), []
        for side in (first, second):
            offset = side.arm(links.pin(group.inner, side.meeting)).rotated(links.angles[side.end])
            starts.append(side.start.plus(offset))
        between, cross = starts[1].minus(starts[0]), sine(lines[1].minus(lines[0]), symbols)
        for side, line in ((first, lines[1]), (second, lines[0])):
            side.out(divide(negated(between.across(line, symbols)), cross))


@register
class RPP(Rule):
    """Both links' angles follow from the known line."""

    signature = "RPP"

    def apply(self, links: Linkage, dialect: Dialect, group: Group, first: DyadSide, second: DyadSide) -> None:
        symbols, line = links.symbols, second.line
        (here, own), (there, heading) = (links.line(group.inner, side.meeting) for side in (first, second))
        inner = links.angles[second.meeting].rotated(heading)
        first.turn(inner.rotated(-own).minus(first.meeting_angle))
        inner = links.angles[second.meeting].rotated(heading)
        arm1 = first.arm(here).rotated(links.angles[first.end])
        arm2 = second.arm(there).rotated(links.angles[second.end])
        between = second.start.minus(first.start).plus(arm2).minus(arm1)
        cross = line.minus(inner)
        travel = divide(negated(between.across(inner, symbols)), sine(cross, symbols))
        second.out(travel)
        out = links.slide(group.outer[1].joint, second.base, second.end)
        along = add(between.along(inner, symbols), multiply(out, cosine(cross, symbols)))
        links.out(group.inner, first.meeting, second.meeting, along)
