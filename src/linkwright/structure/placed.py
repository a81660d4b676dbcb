"""What is placed so far while a mechanism is decomposed, and how the links left hang on it."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import field

from linkwright.data_classes import dataclass
from linkwright.elements.mover import Mover
from linkwright.model.mechanism import FRAME
from linkwright.model.slides import closing
from linkwright.structure.freedoms import Freedoms
from linkwright.structure.topology import FREEDOMS, PIN, Connection, Topology


@dataclass
class PlacedLinks:
    """The ``known`` links with their rank in the order in which they were placed, and the ``joints`` of drives that
    wait."""

    topology: Topology
    known: dict[str, int] = field(default_factory=lambda: {FRAME: 0})
    joints: dict[str, Connection] = field(default_factory=dict)

    @property
    def remaining_links(self) -> list[str]:
        """The links not placed yet."""
        return [link for link in self.topology.moving if link not in self.known]

    def drive(self, name: str) -> Mover:
        """A drive as it prescribes the motion."""
        return self.topology.mechanism.prescribed(name)

    def free(self, connection: Connection) -> bool:
        """Whether a joint isn't one that a drive prescribes."""
        return connection not in self.joints.values()

    def outers(self, link: str) -> list[Connection]:
        """The joints by which an unknown link hangs on known ones; a pin counts once, through its first known link."""
        at = [c for c in self.topology.connections_of(link) if c.kind.places]
        hung = [c for c in at if c.other(link) in self.known and self.free(c)]
        found: dict[str, Connection] = {}
        for c in sorted(hung, key=lambda c: self.known[c.other(link)]):
            found.setdefault(c.joint, c)
        return list(found.values())

    def freedoms(self) -> Freedoms:
        """The freedoms of the links left, and what takes them."""
        return Freedoms(self.topology, self.known, self.joints)

    def freedom(self, part: Collection[str]) -> int:
        """Gruebler's count of a set of links that hangs on the known ones, less its drives; a slide that closes a loop
        of slides has a row less."""
        own = {*part}
        inside = own | self.known.keys()

        def within(c: Connection) -> bool:
            return inside.issuperset(c.links) and not own.isdisjoint(c.links)

        rows = sum(c.rows for c in self.topology.but_pins if within(c))
        for pin in self.topology.pins.values():
            held = len(own.intersection(pin.links))
            if held and self.known.keys().isdisjoint(pin.links):
                held -= 1
            rows += PIN.rows * held
        rows += sum(map(within, self.joints.values()))
        return FREEDOMS * len(own) - rows + self.closing_slides(inside)

    def closing_slides(self, inside: Collection[str]) -> int:
        """How many slides close loops of slides among some links, but those among the known ones."""
        if not self.topology.closing_slides:
            return 0
        slides = [(name, pair) for name, pair in self.topology.slide_pairs.items() if pair.issubset(inside)]
        known = [(name, pair) for name, pair in slides if pair <= self.known.keys()]
        return len(closing(slides)) - len(closing(known))

    def parts(self, left: list[str]) -> Iterator[list[str]]:
        """The links left, as connected parts."""
        todo = dict.fromkeys(left)
        while todo:
            front = [next(iter(todo))]
            part = {*front}
            while front:
                link = front.pop()
                fresh = {other for c in self.topology.connections_of(link) for other in c.links} & todo.keys() - part
                part |= fresh
                front += fresh
            for link in part:
                del todo[link]
            yield [link for link in left if link in part]
