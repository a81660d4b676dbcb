"""The freedoms of the links that aren't placed yet, and which rows of joints and drives take them.

Each link has three, a pin of more than two links two more: its place. A joint ties its links by its rows, a drive by
one; all that is placed counts as the ground. Rows that take a freedom are oriented (:mod:`.orientation`): a link hangs
on all that its arcs lead to. So a link can be placed with those on which it hangs, where none of them is loose; rows
that find no freedom name what is held too much, and freedoms that no row takes name what is loose.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property

from linkwright.data_classes import dataclass
from linkwright.model.slides import closing
from linkwright.structure.orientation import BODY, Orientation
from linkwright.structure.topology import PIN, Connection, Topology

Node = tuple[str, str]
"""``links`` or ``joints`` (pins of more than two links), and the name."""

GROUND: Node = ("links", "")
PLACE = 2
"""The freedoms of a point."""


@dataclass(frozen=True)
class Tie:
    """Rows between different nodes, of a joint or a drive; of one node alone they say nothing."""

    ends: tuple[Node, ...]
    rows: int


class Freedoms:
    """The freedoms of a mechanism of which some links are ``known``; ``drives`` are those that prescribe something new,
    with their joints."""

    def __init__(self, topology: Topology, known: Iterable[str], drives: Mapping[str, Connection]) -> None:
        self._topology, self._known = topology, frozenset(known)
        self._rank = {link: i for i, link in enumerate(topology.moving) if link not in self._known}
        joints = [*self._pins(), *self._but_pins()]
        driven = [Tie(tuple(dict.fromkeys(map(self._node, c.links))), 1) for c in drives.values()]
        self._ties = [tie for tie in (*joints, *driven) if len(tie.ends) > 1]
        self._at: dict[Node, list[Tie]] = {node: [] for node in (GROUND, *(("links", link) for link in self._rank))}
        for tie in self._ties:
            for end in tie.ends:
                self._at.setdefault(end, []).append(tie)
        outwards = self._outwards()
        self._far = {node: i for i, node in enumerate(outwards)}
        self._laid = Orientation({node: self._size(node) for node in outwards})
        self._excess: list[set[Node]] = []  # of each row too many, the rigid set that it lies in
        joints.sort(key=lambda tie: max(map(self._far.__getitem__, tie.ends)))
        for tie in (*joints, *driven):
            if len(tie.ends) > 1:
                self._excess += filter(None, (self._laid.lay(*tie.ends) for _ in range(tie.rows)))
        self._laid.gather((GROUND,), BODY)
        self._laid.gather_pebbles(node for node in outwards if node[0] == "links")

    def _size(self, node: Node) -> int:
        return BODY if node[0] == "links" else PLACE

    def _node(self, link: str) -> Node:
        return GROUND if link in self._known else ("links", link)

    def _pins(self) -> Iterator[Tie]:
        rows = PIN.rows
        for pin in self._topology.pins.values():
            ends = list(dict.fromkeys(map(self._node, pin.links)))
            if GROUND in ends:
                yield from (Tie((end, GROUND), rows) for end in ends if end != GROUND)
            elif len(ends) == 2:
                yield Tie((ends[0], ends[1]), rows)
            else:
                yield from (Tie((end, ("joints", pin.name)), rows) for end in ends)

    def _but_pins(self) -> Iterator[Tie]:
        """The joints but pins; a slide that closes a loop of slides has a row less: the others hold its direction."""
        pairs = sorted(self._topology.slide_pairs.items(), key=lambda entry: not entry[1] <= self._known)
        looped = {*closing(pairs)} if self._topology.closing_slides else set()
        for c in self._topology.but_pins:
            ends = tuple(dict.fromkeys(map(self._node, c.links)))
            yield Tie(ends, c.rows - (c.joint in looped))

    def _outwards(self) -> list[Node]:
        """The nodes, each after one on its way from the ground: so rows too many show as far out as may be, and
        freedoms left over as near as may be."""
        found: dict[Node, None] = {}
        for start in self._at:
            front = {} if start in found else {start: None}
            while front:
                found |= front
                ends = (end for node in front for tie in self._at[node] for end in tie.ends)
                front = {end: None for end in ends if end not in found}
        return list(found)

    @cached_property
    def supporting_links(self) -> dict[str, frozenset[str]]:
        """Of each link that isn't loose, those that it hangs on, itself included: to be placed with it or before it."""
        free = [node for node, count in self._laid.free.items() if count and node != GROUND]
        loose = self._laid.hanging(free)
        held = [link for link in self._rank if ("links", link) not in loose]
        return {link: frozenset(self._links(self._laid.reached([("links", link)]))) for link in held}

    def _links(self, nodes: Iterable[Node]) -> list[str]:
        """The links among some nodes, in the file's order."""
        return sorted((name for kind, name in nodes if kind == "links" and name), key=self._rank.__getitem__)

    def overfull(self) -> Iterator[tuple[list[str], int]]:
        """Sets of links that are held too much, each with its number of rows too many; none holds another one."""
        found: list[set[Node]] = []
        for rigid in sorted(self._excess, key=len):
            if not any(few <= rigid for few in found):
                few, excess = self._fewest(rigid)
                found.append(few)
                yield self._links(few), excess

    def _fewest(self, rigid: set[Node]) -> tuple[set[Node], int]:
        """What is left of a set with rows too many without all nodes that it can do without, the farthest tried first;
        and how many rows are too many there."""
        few = set(rigid)
        excess = sum(tie.rows for tie in self._ties if few.issuperset(tie.ends)) + BODY - sum(map(self._size, few))
        for node in sorted(rigid, key=self._far.__getitem__, reverse=True):
            rows = sum(tie.rows for tie in self._at[node] if few.issuperset(tie.ends))
            if (without := excess - rows + self._size(node)) > 0:
                few, excess = few - {node}, without
        return few, excess

    def loose(self, part: Iterable[str]) -> dict[str, int]:
        """The links of a part at which freedoms are left over, as near to the ground as may be, and how many."""
        return {link: free for link in part if (free := self._laid.free["links", link])}

    def could_join(self, a: str, b: str) -> bool:
        """Whether a pin between two links would take two freedoms that are left over."""
        return self._laid.gather((self._node(a), self._node(b)), BODY + PIN.rows)
