"""Decomposition of a mechanism into driven links and Assur groups, in the order in which they are solved.

After Assur: with the drives taken away, a mechanism falls apart into groups of mobility zero, each hanging on
links that are already known.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import combinations

from linkwright.groups import REGISTRY, Dyad
from linkwright.model.findings import Finding
from linkwright.model.mechanism import Drive, Mechanism
from linkwright.structure.topology import FRAME, Connection, Topology

MAX_CLUSTER = 10
"""The largest group looked for, in links."""


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
class Edge:
    """How a link of a group is placed: by a joint on an earlier link, free, or held by a drive inside."""

    link: str
    joint: Connection
    drive: str | None = None
    sign: int = 1

    @property
    def base(self) -> str:
        """The link on which it is placed."""
        return self.joint.other(self.link)


Chain = tuple[Edge, ...]


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

    @property
    def links(self) -> tuple[str, ...]:
        """All its links, the first side's before the second's."""
        return tuple(link for side in self.sides for link in side)

    @property
    def sides(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """The links of each side, from the outer joint to the inner one."""
        first, second = (
            (end, *(edge.link for edge in chain)) for end, chain in zip(self.ends, self.chains, strict=True)
        )
        return first, second

    @property
    def drives(self) -> tuple[str, ...]:
        """The drives inside."""
        return tuple(edge.drive for chain in self.chains for edge in chain if edge.drive)

    @property
    def modes(self) -> int:
        """The number of assembly modes."""
        return len(REGISTRY[self.signature].rules) or 1

    @property
    def has_span(self) -> bool:
        """Whether it is a dyad whose pose is vague where a distance vanishes (:meth:`Dyad.span`)."""
        return REGISTRY[self.signature].span is not Dyad.span

    def rule(self, branch: float) -> str:
        """The assembly rule that states a branch, as a file spells it; empty where there is one mode only."""
        if self.modes == 1:
            return ""
        first, second = (c.joint for c in self.outer)
        template = REGISTRY[self.signature].rules[0 if branch > 0 else 1][0]
        return template.format(inner=self.inner.joint, first=first, second=second)

    @property
    def label(self) -> str:
        """The group's name in words: its links."""
        return "-".join(self.links)

    @property
    def joints(self) -> tuple[Connection, ...]:
        return (*self.outer, self.inner, *(edge.joint for chain in self.chains for edge in chain))


@dataclass(frozen=True)
class Cluster:
    """A group beyond the dyads: links placed one on another over a tree of joints, and the joints that close it.

    Each free edge has an unknown coordinate (the link's angle on a pin, its travel on a line), each closure
    two equations.
    """

    edges: tuple[Edge, ...]
    closures: tuple[Connection, ...]

    @property
    def links(self) -> tuple[str, ...]:
        return tuple(edge.link for edge in self.edges)

    @property
    def signature(self) -> str:
        """The letters of the joints by which its links are placed (in brackets where driven), then of the closures."""
        placed = "".join(e.joint.letter if e.drive is None else f"({e.joint.letter})" for e in self.edges)
        return f"{placed}-{''.join(c.letter for c in self.closures)}"

    @property
    def drives(self) -> tuple[str, ...]:
        """The drives inside."""
        return tuple(edge.drive for edge in self.edges if edge.drive)

    @property
    def free(self) -> tuple[Edge, ...]:
        """The edges with an unknown coordinate."""
        return tuple(edge for edge in self.edges if edge.drive is None)

    @property
    def label(self) -> str:
        """The group's name in words: its links."""
        return "-".join(self.links)

    @property
    def joints(self) -> tuple[Connection, ...]:
        return (*(edge.joint for edge in self.edges), *self.closures)

    def rule(self, branch: float) -> str:
        """Clusters keep the mode that their sketch pose begins with."""
        return ""


Step = Driven | Group | Cluster


@dataclass(frozen=True)
class Structure:
    """How a mechanism is solved: its topology and its steps in order; ``findings`` says what can't be."""

    topology: Topology
    steps: tuple[Step, ...]
    findings: tuple[Finding, ...] = ()

    @property
    def groups(self) -> tuple[Group, ...]:
        """The dyads among the steps."""
        return tuple(step for step in self.steps if isinstance(step, Group))

    @property
    def clusters(self) -> tuple[Cluster, ...]:
        """The groups beyond dyads among the steps."""
        return tuple(step for step in self.steps if isinstance(step, Cluster))


@dataclass
class _Search:
    topology: Topology
    known: list[str] = field(default_factory=lambda: [FRAME])
    steps: list[Step] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    joints: dict[str, Connection] = field(default_factory=dict)

    def run(self) -> Structure:
        self.find_drives()
        if not self.findings:
            while self.drive_one() or self.group_one() or self.cluster_one():
                pass
            self.report_rest()
        return Structure(self.topology, tuple(self.steps), tuple(self.findings))

    def note(self, code: str, path: tuple[str, ...], **data: object) -> None:
        self.findings.append(Finding(code, path, data))

    def drive(self, name: str) -> Drive:
        """A drive as it prescribes the motion."""
        return self.topology.mechanism.prescribed(name)

    def find_drives(self) -> None:
        for name, own in self.topology.mechanism.drives.items():
            acting, moved = (own, self.topology.acting(name)), (self.drive(name), self.topology.driven(name))
            for drive, options in [acting, moved] if own.output else [acting]:
                if not options:
                    kind = "revolute" if drive.turns else "prismatic"
                    self.note("structure.drive-no-joint", ("drives", name), link=drive.link, on=drive.on, joint=kind)
                elif len(options) > 1:
                    joints = ", ".join(c.joint for c in options)
                    data = {"link": drive.link, "on": drive.on, "joints": joints}
                    self.note("structure.drive-two-joints", ("drives", name), **data)
                else:
                    self.joints[name] = options[0]

    def drive_one(self) -> bool:
        """Place one link by a drive on a known link."""
        for name, joint in self.joints.items():
            drive = self.drive(name)
            link_known, on_known = drive.link in self.known, drive.on in self.known
            if link_known == on_known:
                continue
            link, base = (drive.on, drive.link) if link_known else (drive.link, drive.on)
            self.steps.append(Driven(link, base, joint, name, -1 if link_known else 1))
            self.known.append(link)
            del self.joints[name]
            return True
        return False

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

    def group_one(self) -> bool:
        """Solve one dyad that hangs on known links; links that a drive holds on each other count as one."""
        known = set(self.known)
        held = {link: body for body in self.held_bodies() for link in body}
        hanging = {link: self.outers(link) for link in held}
        pinned = {c.joint for cs in hanging.values() for c in cs}
        outers = {link: {c.joint: (at, c) for at in body for c in hanging[at]} for link, body in held.items()}
        single = {link: next(iter(outer.values())) for link, outer in outers.items() if len(outer) == 1}
        for a in single:
            for inner in self.topology.at(a):
                b = inner.other(a)
                if b not in single or b in held[a] or inner.joint in pinned or not self.free(inner):
                    continue
                sides = [(*single[link], self.chain(single[link][0], link)) for link in (a, b)]
                if group := _dyad(sides[0], inner, sides[1]):
                    self.steps.append(group)
                    self.known += [link for link in group.links if link not in known]
                    for edge in (*group.chains[0], *group.chains[1]):
                        self.joints.pop(edge.drive or "", None)
                    return True
        return False

    def held_bodies(self) -> list[list[str]]:
        """The unknown links as bodies: those that drives hold on each other together."""
        bodies = {link: [link] for link in self.topology.moving if link not in self.known}
        for joint in self.joints.values():
            if joint.a in bodies and joint.b in bodies and bodies[joint.a] is not bodies[joint.b]:
                merged = [*bodies[joint.a], *bodies[joint.b]]
                bodies |= dict.fromkeys(merged, merged)
        return list({id(body): body for body in bodies.values()}.values())

    def chain(self, start: str, end: str) -> Chain:
        """How drives hold one link of a body on another, link by link."""
        ways: dict[str, Chain] = {start: ()}
        front = [start]
        while end not in ways:
            link = front.pop(0)
            for name, joint in self.joints.items():
                if link in (joint.a, joint.b) and (other := joint.other(link)) not in ways:
                    sign = 1 if self.drive(name).link == other else -1
                    ways[other] = (*ways[link], Edge(other, joint, name, sign))
                    front.append(other)
        return ways[end]

    def cluster_one(self) -> bool:
        """Solve the smallest set of links that hangs on known ones with no freedom left."""
        left = [link for link in self.topology.moving if link not in self.known]
        for size in range(2, min(len(left), MAX_CLUSTER) + 1):
            for chosen in combinations(left, size):
                part = list(chosen)
                if self.freedom(part) or self.overfull(part):
                    continue
                if (cluster := self.tree(part)) is not None:
                    self.steps.append(cluster)
                    self.known += cluster.links
                    for edge in cluster.edges:
                        self.joints.pop(edge.drive or "", None)
                    return True
        return False

    def overfull(self, links: list[str]) -> list[str]:
        """The fewest of some links that the known ones hold with more constraints than they have freedoms."""
        sizes = range(1, min(len(links), MAX_CLUSTER) + 1)
        subsets = (list(chosen) for size in sizes for chosen in combinations(links, size))
        return next((subset for subset in subsets if self.freedom(subset) < 0), [])

    def tree(self, part: list[str]) -> Cluster | None:
        """A placing order of the links, drives inside first; ``None`` where the links don't hang together."""
        edges: list[Edge] = []
        placed: list[str] = list(self.known)
        driven = {joint: name for name, joint in self.joints.items()}
        within = [c for c in self.topology.connections if {c.a, c.b} <= {*part, *self.known}]
        todo = list(part)
        while todo:
            options = [(c, link) for link in todo for c in within if link in (c.a, c.b) and c.other(link) in placed]
            if not options:
                return None
            # A driven joint places its link for good; else outer joints keep the chains short.
            joint, link = min(options, key=lambda o: (o[0] not in driven, placed.index(o[0].other(o[1]))))
            drive = driven.get(joint)
            sign = 1 if drive is None or self.drive(drive).link == link else -1
            edges.append(Edge(link, joint, drive, sign))
            placed.append(link)
            todo.remove(link)
        closures = self.closures(part, edges)
        free = sum(edge.drive is None for edge in edges)
        return Cluster(tuple(edges), tuple(closures)) if free == 2 * len(closures) and free else None

    def closures(self, part: list[str], edges: list[Edge]) -> list[Connection]:
        """The joints among the links and the known ones that the tree doesn't use."""
        found = []
        for pin in self.topology.pins.values():
            parts = [{link} for link in pin.links if link in part]
            if not parts:
                continue
            if known := {link for link in pin.links if link in self.known}:
                parts.append(known)
            for edge in edges:
                if edge.joint.joint == pin.name:
                    joined = [p for p in parts if edge.link in p or edge.base in p]
                    parts = [p for p in parts if p not in joined] + [set().union(*joined)]
            heads = [next(link for link in pin.links if link in p) for p in parts]
            found += [Connection(pin.name, "R", heads[0], head) for head in heads[1:]]
        used = {edge.joint for edge in edges}
        for c in self.topology.connections:
            if (
                c.letter == "P"
                and c not in used
                and (c.a in part or c.b in part)
                and {c.a, c.b} <= {*part, *self.known}
            ):
                found.append(c)
        return found

    def report_rest(self) -> None:
        """Say why what is left can't be solved."""
        top = self.topology
        left = [link for link in top.moving if link not in self.known]
        for name in self.joints:
            drive = self.drive(name)
            if drive.link in self.known:
                self.note("structure.drive-too-many", ("drives", name), link=drive.link, on=drive.on)
        for part in self.parts(left):
            part = self.overfull(part) or part
            names, freedom = ", ".join(part), self.freedom(part)
            if freedom > 0:
                hint = self.drive_hint(part)
                self.note("structure.loose", ("links", part[0]), links=names, freedom=freedom, hint=hint)
            elif freedom < 0:
                self.note("structure.overconstrained", ("links", part[0]), links=names, excess=-freedom)
            else:
                self.note("structure.higher-group", ("links", part[0]), links=names, most=MAX_CLUSTER)
        if not left and not self.findings:
            self.report_redundant()
            self.report_apart()

    def report_redundant(self) -> None:
        """Joints between links that other joints have placed already."""
        used = Counter(c.joint for step in self.steps for c in step.joints)
        wanted = {name: len(pin.links) - 1 for name, pin in self.topology.pins.items()}
        wanted |= {name: 1 for name, _ in self.topology.mechanism.prismatic_joints()}
        for name, count in wanted.items():
            if used[name] < count:
                pin = self.topology.pins.get(name)
                links = pin.links if pin else self.topology.mechanism.joints[name].links
                self.note("structure.redundant", ("joints", name), joint=name, links=", ".join(links))

    def report_apart(self) -> None:
        """Drives that can't move the outputs asked of them, since these don't move the drives' own joints.

        Each needs an output of its own that moves its joint (with several drives not its own one by need).
        """
        moved_by: dict[str, set[str]] = {FRAME: set()}
        for step in self.steps:
            hung = {link for joint in step.joints for link in (joint.a, joint.b)} & moved_by.keys()
            moved_by |= dict.fromkeys(step.links, set(step.drives).union(*(moved_by[link] for link in hung)))
        drives = {name: drive for name, drive in self.topology.mechanism.drives.items() if drive.output}
        taken: dict[str, str] = {}

        def take(name: str, tried: set[str]) -> bool:
            """An output for the drive, by turns with drives that can take another one (augmenting paths)."""
            for output in (moved_by[drives[name].link] | moved_by[drives[name].on]) & drives.keys() - tried:
                tried.add(output)
                if output not in taken or take(taken[output], tried):
                    taken[output] = name
                    return True
            return False

        for name, drive in drives.items():
            if not take(name, set()):
                data = {"output": drive.output, "link": drive.link, "on": drive.on}
                self.note("structure.output-apart", ("drives", name, "output"), **data)

    def freedom(self, part: list[str]) -> int:
        """Gruebler's count of a set of links that hangs on the known ones, less its drives."""
        inside = {*part, *self.known}
        joints = 0
        for pin in self.topology.pins.values():
            within = sum(link in part for link in pin.links)
            joints += within - (0 if any(link in self.known for link in pin.links) else 1) if within else 0
        joints += sum(
            c.letter == "P" and {c.a, c.b} <= inside and (c.a in part or c.b in part) for c in self.topology.connections
        )
        driven = sum({c.a, c.b} <= inside and (c.a in part or c.b in part) for c in self.joints.values())
        return 3 * len(part) - 2 * joints - driven

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

    def drive_hint(self, part: list[str]) -> str:
        """A drive line that would hold a loose part, where one of its links hangs on a known one."""
        for link in part:
            for c in self.outers(link):
                verb = "turns" if c.letter == "R" else "slides"
                return f"{{{verb}: {link}, on: {c.other(link)}, ...}}"
        return ""


_Side = tuple[str, Connection, Chain]
"""One side of a dyad: the link at the outer joint, that joint, the way to the link at the inner joint."""


def _dyad(a: _Side, inner: Connection, b: _Side) -> Group | None:
    for first, second in ((a, b), (b, a)):
        signature = first[1].letter + inner.letter + second[1].letter
        if signature in REGISTRY:
            return Group(signature, (first[0], second[0]), (first[1], second[1]), inner, (first[2], second[2]))
    return None


def decompose(mechanism: Mechanism) -> Structure:
    """The structure of a mechanism whose names are sound (see :func:`linkwright.model.check.check_names`)."""
    structure = _Search(Topology(mechanism)).run()
    if all(finding.code != "structure.overconstrained" for finding in structure.findings):
        return structure
    spare = _spare_drive(mechanism)
    return structure if spare is None else Structure(structure.topology, structure.steps, (spare,))


def _spare_drive(mechanism: Mechanism) -> Finding | None:
    """A finding on the last drive without which the structure is sound, where there is one."""
    for name in reversed(mechanism.drives):
        drives = {other: drive for other, drive in mechanism.drives.items() if other != name}
        rest = mechanism.model_copy(update={"drives": drives})
        if drives and not _Search(Topology(rest)).run().findings:
            drive = mechanism.drives[name]
            return Finding("structure.drive-too-many", ("drives", name), {"link": drive.link, "on": drive.on})
    return None
