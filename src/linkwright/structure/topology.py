"""Which links meet where: the joints of a mechanism as connections between two links."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from linkwright.data_classes import dataclass
from linkwright.elements import JointKind, kind
from linkwright.elements.mover import Mover
from linkwright.model.mechanism import FRAME, Mechanism
from linkwright.model.pins import Pin, pins
from linkwright.model.slides import closing, pairs_of
from linkwright.structure.releases import Release, released_pins

FREEDOMS = 3
"""Those of a link."""


PIN = kind("revolute")
"""The joint that points of one name make."""
ANGLE, PLACE = kind("prescribed_angle"), kind("prescribed_place")
"""What drives prescribe without a joint."""


@dataclass(frozen=True)
class Connection:
    """One joint as it ties links: two, or of some kinds ``more``."""

    joint: str
    kind: JointKind
    a: str
    b: str
    more: tuple[str, ...] = ()

    @property
    def rows(self) -> int:
        """The constraints that it states."""
        return self.kind.rows

    @property
    def links(self) -> tuple[str, ...]:
        """All its links."""
        return (self.a, self.b, *self.more)

    def other(self, link: str) -> str:
        """The link at the other end of a joint of two."""
        return self.b if link == self.a else self.a


@dataclass(frozen=True)
class Topology:
    """Links, pins, lines and drives of a mechanism, by name."""

    mechanism: Mechanism
    releases: tuple[Release, ...] = ()
    """What is left out of it: equations of joints that follow from all others."""

    @cached_property
    def pins(self) -> dict[str, Pin]:
        """The pins by name."""
        every = pins(self.mechanism)
        return released_pins(every, self.releases) if self.releases else every

    @cached_property
    def moving(self) -> tuple[str, ...]:
        """All links but the frame."""
        return tuple(link for link in self.mechanism.links if link != FRAME)

    @cached_property
    def connections(self) -> tuple[Connection, ...]:
        """Every pair of links that share a joint; on a pin of three links, each of the three pairs."""
        found = []
        for pin in self.pins.values():
            for i, a in enumerate(pin.links):
                found += [Connection(pin.name, PIN, a, b) for b in pin.links[i + 1 :]]
        return (*found, *self.but_pins)

    @cached_property
    def but_pins(self) -> tuple[Connection, ...]:
        """The joints that aren't pins."""
        joints = self.mechanism.joints_but_pins()
        every = (Connection(name, kind(j.kind), j.links[0], j.links[1], tuple(j.links[2:])) for name, j in joints)
        if not self.releases:
            return tuple(every)
        released = {one.joint for one in self.releases}
        parts = (
            Connection(one.joint, one.kept, one.links[0], one.links[1]) for one in self.releases if one.kept is not None
        )
        return (*(c for c in every if c.joint not in released), *parts)

    @cached_property
    def joints(self) -> dict[str, tuple[JointKind, tuple[str, ...]]]:
        """All joints by name, each with its kind and its links; the pins first."""
        return {name: (PIN, pin.links) for name, pin in self.pins.items()} | {
            c.joint: (c.kind, c.links) for c in self.but_pins
        }

    @cached_property
    def equations(self) -> dict[str, tuple[JointKind, tuple[str, ...]]]:
        """What drives prescribe without a joint, by drive: its kind and its links."""
        moved = (c for name in self.mechanism.movers for c in self.drivable_joints(name) if c.kind.prescribed)
        return {c.joint: (c.kind, c.links) for c in moved}

    def kind_of(self, joint: str) -> JointKind:
        """The kind of a joint by name."""
        return self.joints[joint][0]

    @cached_property
    def wound(self) -> frozenset[str]:
        """The links whose angles are asked for over whole turns: by joints, or through slides and drives that give
        links the angles of others."""
        found = {link for c in self.but_pins if c.kind.winds for link in c.links}
        ties = [c.links for c in self.but_pins if c.kind.parallel]
        ties += [(d.link, d.on) for d in map(self.mechanism.prescribed, self.mechanism.movers) if not d.moves]
        while found and (more := {link for tie in ties if not found.isdisjoint(tie) for link in tie} - found):
            found |= more
        return frozenset(found)

    @cached_property
    def _connections_by_link(self) -> dict[str, list[Connection]]:
        found: dict[str, list[Connection]] = {link: [] for link in self.mechanism.links}
        for c in self.connections:
            for link in c.links:
                found[link].append(c)
        return found

    def connections_of(self, link: str) -> list[Connection]:
        """The connections of a link."""
        return self._connections_by_link[link]

    @cached_property
    def pinned(self) -> int:
        """The pins, each between two links: one of k links counts k - 1."""
        return sum(len(pin.links) - 1 for pin in self.pins.values())

    @property
    def joint_count(self) -> int:
        """The joints; a pin of k links counts k - 1."""
        return self.pinned + len(self.but_pins)

    @property
    def gruebler(self) -> int:
        """Mobility by Gruebler's count: three freedoms of each moving link, less the constraints of all joints.

        A follower is a higher pair (or a relation of its kind) and takes one freedom. A slide that closes a loop of
        slides alone gives one back, since its direction is held by the others already.
        """
        rows = PIN.rows * self.pinned + sum(c.rows for c in self.but_pins) + len(self.mechanism.followers)
        return FREEDOMS * len(self.moving) - rows + len(self.closing_slides)

    @cached_property
    def slide_pairs(self) -> dict[str, frozenset[str]]:
        """The links of slides, as :mod:`linkwright.model.slides` counts them."""
        bent = {one.joint for one in self.releases if one.kept is None or not one.kept.keeps_direction}
        return {name: pair for name, pair in pairs_of(self.mechanism).items() if name not in bent}

    @cached_property
    def closing_slides(self) -> tuple[str, ...]:
        """The slides that close loops of slides, one for each independent loop."""
        return tuple(closing(self.slide_pairs.items()))

    @property
    def loops(self) -> int:
        """The number of independent loops, j - n."""
        return self.joint_count - len(self.moving)

    def drivable_joints(self, drive: str) -> list[Connection]:
        """The joints whose motion a drive can prescribe: its own, or that of its output; its equation where there are
        none."""
        entry = self.mechanism.prescribed(drive)
        joints = self._between(entry)
        found = joints if entry.output is None or entry.turns else [c for c in joints if c.joint == entry.output]
        return found or [*self._equation(drive, entry)]

    def _equation(self, drive: str, entry: Mover) -> Iterator[Connection]:
        """What a drive prescribes where its links share no joint for it."""
        if entry.moves or entry.turns:
            yield Connection(drive, PLACE if entry.moves else ANGLE, entry.link, entry.on)

    def acting(self, drive: str) -> list[Connection]:
        """The joints at which a drive's effort can act; none where it needs no joint."""
        return self._between(self.mechanism.movers[drive])

    def acts_apart(self, drive: str) -> bool:
        """Whether a drive acts on its two links without a joint that they share."""
        entry = self.mechanism.movers[drive]
        return bool(entry.moves or (entry.turns and not self._between(entry)))

    def _between(self, drive: Mover) -> list[Connection]:
        if drive.moves:
            return []
        turns, links = drive.turns is not None, {drive.link, drive.on}
        return [c for c in self.connections if c.kind.angular is turns and {*c.links} == links]
