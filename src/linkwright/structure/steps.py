"""The steps in which a mechanism is solved: driven links, dyads, links on two slides, and groups beyond the dyads."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.groups import REGISTRY, Dyad
from linkwright.structure.releases import Release, SelfStress
from linkwright.structure.topology import Connection, Topology


@dataclass(frozen=True)
class Driven:
    """A link placed by a drive on a known one. ``sign`` is -1 where the drive names the two the other way."""

    link: str
    base: str
    joint: Connection
    drive: str
    sign: int

    @property
    def drives(self) -> tuple[str, ...]:
        return (self.drive,)

    @property
    def links(self) -> tuple[str, ...]:
        return (self.link,)

    @property
    def joints(self) -> tuple[Connection, ...]:
        return (self.joint,)


@dataclass(frozen=True)
class LinkPlacement:
    """How a link of a group is placed: by a joint on an earlier link, free, or held by a drive inside."""

    link: str
    joint: Connection
    drive: str | None = None
    sign: int = 1

    @property
    def base(self) -> str:
        """The link on which it is placed."""
        return self.joint.other(self.link)


Chain = tuple[LinkPlacement, ...]


@dataclass(frozen=True)
class Group:
    """A dyad: the two links at its outer joints, and the joints in the order of its signature.

    A drive between two unknown links holds them on each other, so that they are one body whose shape follows the
    drive: ``chains`` leads on each side from the link at the outer joint to the one at the inner joint, empty where
    that is the same link.
    """

    signature: str
    ends: tuple[str, str]
    outer: tuple[Connection, Connection]
    inner: Connection
    chains: tuple[Chain, Chain] = ((), ())

    @property
    def bases(self) -> tuple[str, str]:
        """The known links on which the two sides hang."""
        return self.outer[0].other(self.ends[0]), self.outer[1].other(self.ends[1])

    @cached_property
    def links(self) -> tuple[str, ...]:
        """All its links, the first side's before the second's."""
        return tuple(link for side in self.sides for link in side)

    @cached_property
    def sides(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """The links of each side, from the outer joint to the inner one."""
        first, second = (
            (end, *(edge.link for edge in chain)) for end, chain in zip(self.ends, self.chains, strict=True)
        )
        return first, second

    @property
    def directed(self) -> frozenset[str]:
        """Those of its links of which its closed form tells the direction alone, not the angle over whole turns: no
        slides lead from them to known links."""
        (first, second), inner = (c.kind.parallel for c in self.outer), self.inner.kind.parallel
        told = first or (inner and second), second or (inner and first)
        return frozenset(link for side, known in zip(self.sides, told, strict=True) if not known for link in side)

    @property
    def meeting(self) -> tuple[str, str]:
        """The two links at the inner joint."""
        return self.sides[0][-1], self.sides[1][-1]

    @property
    def drives(self) -> tuple[str, ...]:
        """The drives inside."""
        return tuple(edge.drive for chain in self.chains for edge in chain if edge.drive)

    @property
    def modes(self) -> int:
        """The number of assembly modes."""
        return len(REGISTRY[self.signature].rules) or 1

    @property
    def front(self) -> float:
        """The branch of an RPR in which its slide has the second link ahead of the first, as a cylinder its rod."""
        return 1.0 if self.sides[0][-1] == self.inner.a else -1.0

    @property
    def has_span(self) -> bool:
        """Whether it is a dyad whose pose is vague where a distance vanishes (:meth:`Dyad.span`)."""
        return REGISTRY[self.signature].span is not Dyad.span

    @property
    def has_outer_pins(self) -> bool:
        """Whether it is a dyad whose outer pins may meet (:meth:`Dyad.apart`)."""
        return REGISTRY[self.signature].apart is not Dyad.apart

    def rules(self, branch: float) -> list[tuple[str, str]]:
        """The ways in which a file states a branch, as point and rule; none where there is one mode only."""
        first, second = (c.joint for c in self.outer)
        templates = REGISTRY[self.signature].rules
        texts = templates[0 if branch > 0 else 1] if templates else ()
        said = (text.format(inner=self.inner.joint, first=first, second=second) for text in texts)
        return [(point, rule) for point, rule in (text.split(": ", 1) for text in said)]

    def rule(self, branch: float) -> str:
        """The first of these, as a line of a file."""
        return ": ".join(self.rules(branch)[0])

    @property
    def label(self) -> str:
        """The group's name in words: its links."""
        return "-".join(self.links)

    @property
    def joints(self) -> tuple[Connection, ...]:
        return (*self.outer, self.inner, *(edge.joint for chain in self.chains for edge in chain))


@dataclass(frozen=True)
class Wedge:
    """A link on two slides whose direction is known: all joints of its loop are slides.

    ``outer`` are the two slides; the first one's direction is that of the link, the second one closes the loop by one
    equation. Links that drives hold on each other count as one: ``chain`` leads from the link at the first slide to the
    one at the second, empty where that is the same link.
    """

    link: str
    outer: tuple[Connection, Connection]
    chain: Chain = ()

    signature = "PP"

    @property
    def links(self) -> tuple[str, ...]:
        """All its links, from the first slide to the second."""
        return (self.link, *(edge.link for edge in self.chain))

    @property
    def bases(self) -> tuple[str, str]:
        """The known links on which it slides."""
        return self.outer[0].other(self.links[0]), self.outer[1].other(self.links[-1])

    @property
    def drives(self) -> tuple[str, ...]:
        """The drives inside."""
        return tuple(edge.drive for edge in self.chain if edge.drive)

    @property
    def label(self) -> str:
        """Its name in words: its links."""
        return "-".join(self.links)

    @property
    def joints(self) -> tuple[Connection, ...]:
        return (*self.outer, *(edge.joint for edge in self.chain))


@dataclass(frozen=True)
class HigherGroup:
    """A group beyond the dyads: links placed one on another over a tree of joints, and the joints that close it.

    Each free edge has an unknown coordinate (the link's angle on a pin, its travel on a line), each closure
    two equations.
    """

    edges: tuple[LinkPlacement, ...]
    closures: tuple[Connection, ...]

    @cached_property
    def links(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(edge.link for edge in self.edges))

    @property
    def signature(self) -> str:
        """The letters of the joints by which its links are placed (in brackets where driven), then of the closures."""
        placed = "".join(e.joint.kind.letter if e.drive is None else f"({e.joint.kind.letter})" for e in self.edges)
        return f"{placed}-{''.join(c.kind.letter for c in self.closures)}"

    @property
    def drives(self) -> tuple[str, ...]:
        """The drives inside: those that hold links on each other, and those whose equations it keeps."""
        equations = (c.joint for c in self.closures if c.kind.prescribed)
        return (*(edge.drive for edge in self.edges if edge.drive), *equations)

    @property
    def free(self) -> tuple[LinkPlacement, ...]:
        """The edges with an unknown coordinate."""
        return tuple(edge for edge in self.edges if edge.drive is None)

    @property
    def turning(self) -> tuple[bool, ...]:
        """Which of the unknown coordinates are angles; the others are travels."""
        return tuple(bool(edge.joint.kind.angular) for edge in self.free)

    def units(self, size: float) -> list[float]:
        """What the coordinates count in: 1 rad, or the mechanism's size (m)."""
        return [1.0 if turns else size for turns in self.turning]

    @property
    def label(self) -> str:
        """The group's name in words: its links."""
        return "-".join(self.links)

    @property
    def joints(self) -> tuple[Connection, ...]:
        return (*(edge.joint for edge in self.edges), *self.closures)


Step = Driven | Group | Wedge | HigherGroup
Pose = tuple[float, float, float]
"""Where a link's origin is (m), and its angle (rad)."""


@dataclass(frozen=True)
class Structure:
    """How a mechanism is solved: its topology and its steps in order; ``findings`` says what can't be."""

    topology: Topology
    steps: tuple[Step, ...]
    findings: tuple[Finding, ...] = ()
    releases: tuple[Release, ...] = ()
    """Equations of joints that no step keeps, as they follow from all others; the topology has them."""
    spare_joints: tuple[str, ...] = ()
    """The joints that are named as redundant."""
    self_stress: SelfStress = field(default_factory=SelfStress, compare=False)
    """What neither statics nor stiffness determines."""
    drawn: Mapping[str, Pose] | None = field(default=None, compare=False)
    """Of a redundant mechanism the start pose, in which the closures of all joints were found to agree."""

    @property
    def redundant(self) -> int:
        """How many equations follow from the others, so that no step keeps them."""
        return Topology(self.topology.mechanism, self.releases).gruebler - self.topology.gruebler

    @property
    def mobility(self) -> int:
        """Gruebler's count, without the equations that follow from others."""
        return self.topology.gruebler + self.redundant

    @property
    def groups(self) -> tuple[Group, ...]:
        """The dyads among the steps."""
        return tuple(step for step in self.steps if isinstance(step, Group))

    @property
    def higher_groups(self) -> tuple[HigherGroup, ...]:
        """The groups beyond dyads among the steps."""
        return tuple(step for step in self.steps if isinstance(step, HigherGroup))

    @property
    def choices(self) -> tuple[Group | HigherGroup, ...]:
        """The steps that can be put together in several ways."""
        return tuple(s for s in self.steps if isinstance(s, HigherGroup) or (isinstance(s, Group) and s.modes > 1))
