"""Which links meet where: the joints of a mechanism as connections between two links."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

from linkwright.model.mechanism import FRAME, Drive, Mechanism
from linkwright.model.pins import Pin, pins
from linkwright.model.slides import closing, pairs_of

FREEDOMS = 3
"""Those of a link."""


@dataclass(frozen=True)
class Connection:
    """One joint as it ties two links: a pin (letter R) or a line (letter P)."""

    ROWS: ClassVar[dict[str, int]] = {"R": 2, "P": 2}
    """The constraints that a joint states, by its letter."""

    joint: str
    letter: str
    a: str
    b: str

    @property
    def rows(self) -> int:
        """The constraints that it states."""
        return self.ROWS[self.letter]

    def other(self, link: str) -> str:
        """The link at the other end."""
        return self.b if link == self.a else self.a


@dataclass(frozen=True)
class Topology:
    """Links, pins, lines and drives of a mechanism, by name."""

    mechanism: Mechanism

    @cached_property
    def pins(self) -> dict[str, Pin]:
        """The pins by name."""
        return pins(self.mechanism)

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
                found += [Connection(pin.name, "R", a, b) for b in pin.links[i + 1 :]]
        found += [Connection(name, "P", *joint.links) for name, joint in self.mechanism.prismatic_joints()]
        return tuple(found)

    @cached_property
    def _at(self) -> dict[str, list[Connection]]:
        found: dict[str, list[Connection]] = {link: [] for link in self.mechanism.links}
        for c in self.connections:
            found[c.a].append(c)
            found[c.b].append(c)
        return found

    def at(self, link: str) -> list[Connection]:
        """The connections of a link."""
        return self._at[link]

    @cached_property
    def letters(self) -> Counter[str]:
        """How many joints there are of each letter; a pin of k links counts k - 1."""
        pinned = sum(len(pin.links) - 1 for pin in self.pins.values())
        return Counter(R=pinned, P=sum(1 for _ in self.mechanism.prismatic_joints()))

    @property
    def joint_count(self) -> int:
        """The joints, each between two links: a pin of k links counts k - 1."""
        return self.letters.total()

    @property
    def gruebler(self) -> int:
        """Mobility by Gruebler's count: three freedoms of each moving link, less the constraints of all joints; one
        more for each slide that closes a loop of slides alone, since its direction is held by the others already."""
        rows = sum(Connection.ROWS[letter] * count for letter, count in self.letters.items())
        return FREEDOMS * len(self.moving) - rows + len(self.closing_slides)

    @cached_property
    def slide_pairs(self) -> dict[str, frozenset[str]]:
        """The links of slides, as :mod:`linkwright.model.slides` counts them."""
        return pairs_of(self.mechanism)

    @cached_property
    def closing_slides(self) -> tuple[str, ...]:
        """The slides that close loops of slides, one for each independent loop."""
        return tuple(closing(self.slide_pairs.items()))

    @property
    def loops(self) -> int:
        """The number of independent loops, j - n."""
        return self.joint_count - len(self.moving)

    def driven(self, drive: str) -> list[Connection]:
        """The joints whose motion a drive can prescribe: its own, or that of its output."""
        entry = self.mechanism.prescribed(drive)
        joints = self._between(entry)
        return joints if entry.output is None or entry.turns else [c for c in joints if c.joint == entry.output]

    def acting(self, drive: str) -> list[Connection]:
        """The joints at which a drive's effort can act."""
        return self._between(self.mechanism.drives[drive])

    def _between(self, drive: Drive) -> list[Connection]:
        letter = "R" if drive.turns else "P"
        return [c for c in self.connections if c.letter == letter and {c.a, c.b} == {drive.link, drive.on}]
