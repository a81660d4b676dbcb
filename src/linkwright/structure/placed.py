"""What is placed so far while a mechanism is decomposed, and how the links left hang on it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import combinations
from typing import ClassVar

from linkwright.model.mechanism import FRAME, Drive
from linkwright.model.slides import closing
from linkwright.structure.topology import Connection, Topology


@dataclass
class Placed:
    """The ``known`` links in the order in which they were placed, and the ``joints`` of drives that wait."""

    LARGEST: ClassVar[int] = 10
    """The largest group looked for, in links."""

    topology: Topology
    known: list[str] = field(default_factory=lambda: [FRAME])
    joints: dict[str, Connection] = field(default_factory=dict)

    @property
    def left(self) -> list[str]:
        """The links not placed yet."""
        return [link for link in self.topology.moving if link not in self.known]

    def drive(self, name: str) -> Drive:
        """A drive as it prescribes the motion."""
        return self.topology.mechanism.prescribed(name)

    def free(self, connection: Connection) -> bool:
        """Whether a joint isn't one that a drive prescribes."""
        return connection not in self.joints.values()

    def outers(self, link: str) -> list[Connection]:
        """The joints by which an unknown link hangs on known ones; a pin counts once, through its first known link."""
        rank = {base: i for i, base in enumerate(self.known)}
        hung = [c for c in self.topology.at(link) if c.other(link) in rank and self.free(c)]
        found: dict[str, Connection] = {}
        for c in sorted(hung, key=lambda c: rank[c.other(link)]):
            found.setdefault(c.joint, c)
        return list(found.values())

    def subsets(self, links: list[str], least: int) -> Iterator[list[str]]:
        """The sets of some links, small ones first."""
        for size in range(least, min(len(links), self.LARGEST) + 1):
            yield from map(list, combinations(links, size))

    def overfull(self, links: list[str]) -> list[str]:
        """The fewest of some links that the known ones hold with more constraints than they have freedoms."""
        return next((subset for subset in self.subsets(links, 1) if self.freedom(subset) < 0), [])

    def freedom(self, part: list[str]) -> int:
        """Gruebler's count of a set of links that hangs on the known ones, less its drives; a slide that closes a loop
        of slides counts once instead of twice."""
        inside = {*part, *self.known}
        joints = 0
        for pin in self.topology.pins.values():
            within = sum(link in part for link in pin.links)
            joints += within - (0 if any(link in self.known for link in pin.links) else 1) if within else 0
        joints += sum(
            c.letter == "P" and {c.a, c.b} <= inside and (c.a in part or c.b in part) for c in self.topology.connections
        )
        driven = sum({c.a, c.b} <= inside and (c.a in part or c.b in part) for c in self.joints.values())
        return 3 * len(part) - 2 * joints - driven + self.closing_slides(inside)

    def closing_slides(self, inside: set[str]) -> int:
        """How many slides close loops of slides among some links, but those among the known ones."""
        if not self.topology.closing_slides:
            return 0
        slides = [(name, pair) for name, pair in self.topology.slide_pairs.items() if pair <= inside]
        known = [(name, pair) for name, pair in slides if pair <= {*self.known}]
        return len(closing(slides)) - len(closing(known))

    def parts(self, left: list[str]) -> Iterator[list[str]]:
        """The links left, as connected parts."""
        todo = list(left)
        while todo:
            part, front = [todo[0]], [todo[0]]
            while front:
                link = front.pop()
                for c in self.topology.connections:
                    if link in (c.a, c.b) and (other := c.other(link)) in todo and other not in part:
                        part.append(other)
                        front.append(other)
            todo = [link for link in todo if link not in part]
            yield [link for link in left if link in part]
