"""Closed loops of four links in a mechanism, the frame among them or not."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from linkwright.data_classes import dataclass
from linkwright.structure.topology import Connection, Topology

MOST = 1000
"""The most loops that are looked at: many links between the same pins make more than anyone reads."""


@dataclass(frozen=True)
class Loop:
    """Four links in order round the loop; ``joints[i]`` lies between ``links[i]`` and the next."""

    links: tuple[str, ...]
    joints: tuple[Connection, ...]

    @property
    def turning(self) -> tuple[bool, ...]:
        """Of the joints in order, whether each leaves a turn; the others leave a travel."""
        return tuple(bool(joint.kind.angular) for joint in self.joints)

    def rotated(self, by: int) -> Loop:
        """The same loop begun ``by`` links later."""
        return Loop(self.links[by:] + self.links[:by], self.joints[by:] + self.joints[:by])


def loops_of_four(topology: Topology) -> list[Loop]:
    """Every loop of four links over four different joints, each once, begun at its first link of the file."""
    return list(islice(_loops(topology), MOST))


def _loops(topology: Topology) -> Iterator[Loop]:
    rank = {link: i for i, link in enumerate(topology.mechanism.links)}
    for a in rank:
        ways = [(c.other(a), c) for c in topology.connections_of(a) if c.kind.places and rank[c.other(a)] > rank[a]]
        for b, first in ways:
            for d, last in ways:
                if not rank[b] < rank[d] or first.joint == last.joint:
                    continue
                yield from _four_bar_loops(topology, (a, b, d), first, last)


def _four_bar_loops(
    topology: Topology, links: tuple[str, str, str], first: Connection, last: Connection
) -> Iterator[Loop]:
    """The loops over two links on the first one, by each link that ties these two."""
    a, b, d = links
    rank = list(topology.mechanism.links).index
    for second in topology.connections_of(b):
        if not second.kind.places:
            continue
        c = second.other(b)
        if c in links or rank(c) < rank(a):
            continue
        for third in filter(lambda joint: joint.kind.places, topology.connections_of(c)):
            joints = (first, second, third, last)
            if third.other(c) == d and len({joint.joint for joint in joints}) == 4:
                yield Loop((a, b, c, d), joints)
