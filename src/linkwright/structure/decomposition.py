"""Decomposition of a mechanism into driven links and Assur groups, in the order in which they are solved.

After Assur: with the drives taken away, a mechanism falls apart into groups of mobility zero, each hanging on
links that are already known.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import combinations

from linkwright.groups import REGISTRY
from linkwright.model.findings import Finding
from linkwright.model.mechanism import Mechanism
from linkwright.structure.topology import FRAME, Connection, Topology


@dataclass(frozen=True)
class Driven:
    """A link placed by a drive on a known one. ``sign`` is -1 where the drive names the two the other way."""

    link: str
    base: str
    joint: Connection
    drive: str
    sign: int

    @property
    def links(self) -> tuple[str, ...]:
        return (self.link,)

    @property
    def joints(self) -> tuple[Connection, ...]:
        return (self.joint,)


@dataclass(frozen=True)
class Group:
    """A dyad: its links, and the joints in the order of its signature."""

    signature: str
    links: tuple[str, str]
    outer: tuple[Connection, Connection]
    inner: Connection

    @property
    def bases(self) -> tuple[str, str]:
        """The known links on which the two links hang."""
        return self.outer[0].other(self.links[0]), self.outer[1].other(self.links[1])

    @property
    def modes(self) -> int:
        """The number of assembly modes."""
        return len(REGISTRY[self.signature].rules) or 1

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
        return (*self.outer, self.inner)


Step = Driven | Group


@dataclass(frozen=True)
class Structure:
    """How a mechanism is solved: its topology and its steps in order; ``findings`` says what can't be."""

    topology: Topology
    steps: tuple[Step, ...]
    findings: tuple[Finding, ...] = ()

    @property
    def groups(self) -> tuple[Group, ...]:
        """The Assur groups among the steps."""
        return tuple(step for step in self.steps if isinstance(step, Group))


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
            while self.drive_one() or self.group_one():
                pass
            self.report_rest()
        return Structure(self.topology, tuple(self.steps), tuple(self.findings))

    def note(self, code: str, path: tuple[str, ...], **data: object) -> None:
        self.findings.append(Finding(code, path, data))

    def find_drives(self) -> None:
        for name, drive in self.topology.mechanism.drives.items():
            options = self.topology.driven(name)
            if not options:
                kind = "revolute" if drive.turns else "prismatic"
                self.note("structure.drive-no-joint", ("drives", name), link=drive.link, on=drive.on, joint=kind)
            elif len(options) > 1:
                joints = ", ".join(c.joint for c in options)
                self.note(
                    "structure.drive-two-joints",
                    ("drives", name),
                    link=drive.link,
                    on=drive.on,
                    joints=joints,
                )
            else:
                self.joints[name] = options[0]

    def drive_one(self) -> bool:
        """Place one link by a drive on a known link."""
        for name, joint in self.joints.items():
            drive = self.topology.mechanism.drives[name]
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
        found: dict[str, Connection] = {}
        for base in self.known:
            for c in self.topology.connections:
                if {c.a, c.b} == {link, base} and self.free(c):
                    found.setdefault(c.joint, c)
        return list(found.values())

    def group_one(self) -> bool:
        """Solve one dyad that hangs on known links."""
        hanging = {link: self.outers(link) for link in self.topology.moving if link not in self.known}
        pinned = {c.joint for cs in hanging.values() for c in cs}
        for a, b in combinations([link for link, outer in hanging.items() if outer], 2):
            for inner in self.topology.connections:
                if {inner.a, inner.b} != {a, b} or inner.joint in pinned or not self.free(inner):
                    continue
                if (
                    len(hanging[a]) == 1
                    and len(hanging[b]) == 1
                    and (group := _dyad(a, hanging[a][0], inner, hanging[b][0], b))
                ):
                    self.steps.append(group)
                    self.known += group.links
                    return True
        return False

    def report_rest(self) -> None:
        """Say why what is left can't be solved."""
        top = self.topology
        left = [link for link in top.moving if link not in self.known]
        for name in self.joints:
            drive = top.mechanism.drives[name]
            if drive.link in self.known:
                self.note("structure.drive-too-many", ("drives", name), link=drive.link, on=drive.on)
        for part in self.parts(left):
            names, freedom = ", ".join(part), self.freedom(part)
            driven = [n for n in self.joints if top.mechanism.drives[n].link in part]
            if freedom > 0:
                hint = self.drive_hint(part)
                self.note("structure.loose", ("links", part[0]), links=names, freedom=freedom, hint=hint)
            elif freedom < 0:
                self.note("structure.overconstrained", ("links", part[0]), links=names, excess=-freedom)
            elif driven:
                self.note("structure.drive-inside", ("drives", driven[0]), links=names)
            else:
                self.note("structure.higher-group", ("links", part[0]), links=names, count=len(part))
        if not left and not self.findings:
            self.report_redundant()

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

    def freedom(self, part: list[str]) -> int:
        """Gruebler's count of a set of links that hangs on the known ones, less its drives."""
        joints = 0
        for pin in self.topology.pins.values():
            within = sum(link in part for link in pin.links)
            joints += within - (0 if any(link in self.known for link in pin.links) else 1) if within else 0
        joints += sum(c.letter == "P" and (c.a in part or c.b in part) for c in self.topology.connections)
        driven = sum(
            self.topology.mechanism.drives[name].link in part or self.topology.mechanism.drives[name].on in part
            for name in self.joints
        )
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


def _dyad(a: str, outer_a: Connection, inner: Connection, outer_b: Connection, b: str) -> Group | None:
    for first, second in (((a, outer_a), (b, outer_b)), ((b, outer_b), (a, outer_a))):
        signature = first[1].letter + inner.letter + second[1].letter
        if signature in REGISTRY:
            return Group(signature, (first[0], second[0]), (first[1], second[1]), inner)
    return None


def decompose(mechanism: Mechanism) -> Structure:
    """The structure of a mechanism whose names are sound (see :func:`linkwright.model.check.check_names`)."""
    return _Search(Topology(mechanism)).run()
