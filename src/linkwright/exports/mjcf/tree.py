"""A tree of joints that carries all links from the frame on, and the pins that close its loops."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable

from linkwright.data_classes import dataclass
from linkwright.structure import FRAME, Topology
from linkwright.structure.topology import Connection


@dataclass(frozen=True)
class Hold:
    """A joint of the tree: ``child`` hangs on ``parent`` by a pin (R) or a line (P). ``name`` is that of the joint,
    with the child's where several joints of the tree lie on one pin."""

    name: str
    joint: str
    turns: bool
    parent: str
    child: str


@dataclass(frozen=True)
class JointTree:
    """The joints in depth-first order, and the pins at which loops are cut: (name, pin, link, link)."""

    holds: tuple[Hold, ...]
    cuts: tuple[Hold, ...]

    def joint_between(self, joint: str, *links: str) -> Hold | None:
        """The joint of the tree between two links."""
        return next((h for h in self.holds if h.joint == joint and {h.parent, h.child} == {*links}), None)


class _Sets:
    """Which things are joined already."""

    def __init__(self) -> None:
        self._up: dict[str, str] = {}

    def root(self, name: str) -> str:
        while (up := self._up.get(name, name)) != name:
            name = up
        return name

    def join(self, a: str, b: str) -> bool:
        """Join two; whether they weren't before."""
        a, b = self.root(a), self.root(b)
        self._up[a] = b
        return a != b


def needed(topology: Topology) -> list[Connection]:
    """The joints that must be in the tree, since only there they can be written: slides, and those at which drives act.

    They close no loop: loops of slides alone aren't exported, and with its drives held another one would be
    overconstrained, which the structure refuses.
    """
    slides = [c for c in topology.connections if not c.kind.angular]
    acting = [topology.acting(drive)[0] for drive in topology.mechanism.movers]
    return list(dict.fromkeys([*slides, *acting]))


def spanning(topology: Topology) -> JointTree:
    """The tree with the joints that it needs, else as shallow as the order of links lets it be."""
    musts, sets = needed(topology), _Sets()
    for c in musts:
        assert sets.join(c.a, c.b), c.joint
    held: dict[str, list[Connection]] = {link: [] for link in topology.mechanism.links}
    seen, queue = {FRAME}, deque([FRAME])
    while queue:
        link = queue.popleft()
        at = topology.connections_of(link)
        for c in [*(c for c in at if c in musts), *(c for c in at if c not in musts)]:
            other = c.other(link)
            if other not in seen and (c in musts or sets.join(link, other)):
                held[link].append(c)
                seen.add(other)
                queue.append(other)
    chosen = list(_deep(held, FRAME))
    return JointTree(tuple(_named(chosen)), tuple(_named(_cuts(topology, [c for c, _ in chosen]))))


def _deep(held: dict[str, list[Connection]], link: str) -> Iterable[tuple[Connection, str]]:
    """The joints below a link with their parents, depth first."""
    for c in held[link]:
        yield c, link
        yield from _deep(held, c.other(link))


def _cuts(topology: Topology, chosen: list[Connection]) -> Iterable[tuple[Connection, str]]:
    """The pins that the tree leaves open; on a pin of many links no more than it takes."""
    for pin in topology.pins.values():
        sets = _Sets()
        here = [c for c in topology.connections if c.joint == pin.name]
        for c in [*(c for c in here if c in chosen), *(c for c in here if c not in chosen)]:
            if sets.join(c.a, c.b) and c not in chosen:
                yield c, c.a


def _named(joints: Iterable[tuple[Connection, str]]) -> Iterable[Hold]:
    taken: set[str] = set()
    for c, parent in joints:
        child = c.other(parent)
        name = c.joint if c.joint not in taken else f"{c.joint}:{child}"  # no name of a file holds a colon
        taken.add(name)
        yield Hold(name, c.joint, bool(c.kind.angular), parent, child)
