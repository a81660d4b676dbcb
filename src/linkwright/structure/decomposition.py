"""Decomposition of a mechanism into driven links and Assur groups, in the order in which they are solved.

After Assur: with the drives taken away, a mechanism falls apart into groups of mobility zero, each hanging on
links that are already known.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import field

from linkwright.data_classes import dataclass
from linkwright.elements import kind
from linkwright.findings import Finding, Joined, Term
from linkwright.groups import REGISTRY
from linkwright.model.mechanism import FRAME, Mechanism
from linkwright.structure.placed import PlacedLinks
from linkwright.structure.refusals import fixed_angles, immovable_outputs, redundant, unsolved
from linkwright.structure.releases import Release
from linkwright.structure.steps import Chain, Driven, Group, HigherGroup, LinkPlacement, Step, Structure, Wedge
from linkwright.structure.topology import PIN, Connection, Topology


@dataclass
class _GroupSearch(PlacedLinks):
    steps: list[Step] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    together: Mapping[str, frozenset[str]] | None = None  # of Freedoms, when first asked

    def run(self) -> Structure:
        self.find_drives()
        if not self.findings:
            while self.drive_one() or self.group_one() or self.wedge_one() or self.higher_group_one():
                pass
            self.findings += unsolved(self)
            if not self.remaining_links and not self.findings:
                self.findings += [*redundant(self.topology, self.steps), *immovable_outputs(self.topology, self.steps)]
        return Structure(self.topology, tuple(self.steps), tuple(self.findings))

    def note(self, code: str, path: tuple[str, ...], **data: object) -> None:
        self.findings.append(Finding(code, path, data))

    def place(self, step: Step) -> bool:
        """Note a step as solved."""
        self.steps.append(step)
        for link in step.links:
            self.known[link] = len(self.known)
        for name in step.drives:
            self.joints.pop(name, None)
        return True

    def find_drives(self) -> None:
        for name, own in self.topology.mechanism.movers.items():
            path = self.topology.mechanism.path_of(name)
            acting, moved = (own, self.topology.acting(name)), (self.drive(name), self.topology.drivable_joints(name))
            apart = self.topology.acts_apart(name)
            for drive, options in [moved] if apart else [acting, moved] if own.output else [acting]:
                if not options:
                    kind = Term("kind-revolute" if drive.turns else "kind-prismatic")
                    self.note("structure.drive-no-joint", path, link=drive.link, on=drive.on, joint=kind)
                elif len(options) > 1:
                    joints = Joined(c.joint for c in options)
                    data = {"link": drive.link, "on": drive.on, "joints": joints}
                    self.note("structure.drive-two-joints", path, **data)
                else:
                    self.joints[name] = options[0]

        self.findings += fixed_angles(self.topology, self.joints)

    def drive_one(self) -> bool:
        """Place one link by a drive on a known link."""
        for name, joint in self.holding.items():
            drive = self.drive(name)
            link_known, on_known = drive.link in self.known, drive.on in self.known
            if link_known == on_known:
                continue
            link, base = (drive.on, drive.link) if link_known else (drive.link, drive.on)
            return self.place(Driven(link, base, joint, name, -1 if link_known else 1))
        return False

    def group_one(self) -> bool:
        """Solve one dyad that hangs on known links; links that a drive holds on each other count as one."""
        held = {link: body for body in self.held_bodies() for link in body}
        hanging = {link: self.outers(link) for link in held}
        pinned = {c.joint for cs in hanging.values() for c in cs}
        outers = {link: {c.joint: (at, c) for at in body for c in hanging[at]} for link, body in held.items()}
        single = {link: next(iter(outer.values())) for link, outer in outers.items() if len(outer) == 1}
        for a in single:
            for inner in self.topology.connections_of(a):
                if not inner.kind.places or not self.free(inner) or inner.joint in pinned:
                    continue
                b = inner.other(a)
                if b not in single or b in held[a]:
                    continue
                sides = [(*single[link], self.chain(single[link][0], link)) for link in (a, b)]
                group = _dyad(sides[0], inner, sides[1])
                if group and not self.topology.wound & group.directed:
                    return self.place(group)
        return False

    def wedge_one(self) -> bool:
        """Solve one link on two slides of known links, that are joined by slides alone on the other side too."""
        for body in self.held_bodies():
            outer = [(at, c) for at in body for c in self.outers(at)]
            if len(outer) != 2 or not all(c.kind.parallel for _, c in outer):
                continue
            (first, a), (second, b) = outer
            chain = self.chain(first, second)
            twice = not chain and a.other(first) == b.other(second)
            if not twice and not self.freedom([first, *(edge.link for edge in chain)]):
                return self.place(Wedge(first, (a, b), chain))
        return False

    @property
    def holding(self) -> dict[str, Connection]:
        """The joints of drives that hold one link on another."""
        return {name: joint for name, joint in self.joints.items() if not joint.kind.prescribed}

    def held_bodies(self) -> list[list[str]]:
        """The unknown links as bodies: those that drives hold on each other together."""
        bodies = {link: [link] for link in self.remaining_links}
        for joint in self.holding.values():
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
            for name, joint in self.holding.items():
                if link in (joint.a, joint.b) and (other := joint.other(link)) not in ways:
                    sign = 1 if self.drive(name).link == other else -1
                    ways[other] = (*ways[link], LinkPlacement(other, joint, name, sign))
                    front.append(other)
        return ways[end]

    def higher_group_one(self) -> bool:
        """Solve the smallest set of links that hangs on known ones with no freedom left."""
        self.together = self.together if self.together is not None else self.freedoms().supporting_links
        rank = {link: i for i, link in enumerate(self.remaining_links)}
        parts = {tuple(sorted(of & rank.keys(), key=rank.__getitem__)) for link, of in self.together.items()}
        solved = [part for part in parts if len(part) > 1 or any(map(self.on_higher_pairs, part))]
        for part in sorted(solved, key=lambda part: (len(part), [rank[link] for link in part])):
            if not self.freedom(part) and (higher_group := self.tree(part)) is not None:
                return self.place(higher_group)
        return False

    def on_higher_pairs(self, link: str) -> bool:
        """Whether a link has joints by which no link is placed, so that a group of this link alone takes Newton."""
        equations = [joint for joint in self.joints.values() if joint.kind.prescribed and link in joint.links]
        return not all(c.kind.places for c in (*self.topology.connections_of(link), *equations))

    def tree(self, part: tuple[str, ...]) -> HigherGroup | None:
        """A placing order of the links, drives inside first; a link that no joint places floats. ``None`` where the
        closures are others than the coordinates, or the links don't hang together."""
        edges: list[LinkPlacement] = []
        placed = dict(self.known)
        driven = {joint: name for name, joint in self.joints.items()}
        todo = dict.fromkeys(part)
        while todo:
            options = [
                (c, link)
                for link in todo
                for c in self.topology.connections_of(link)
                if c.kind.places and c.other(link) in placed
            ]
            if not options:
                if (floating := self.floating(todo, placed)) is None:
                    return None
                edges += [LinkPlacement(floating, c) for c in floating_coordinates(floating)]
                placed[floating] = len(placed)
                del todo[floating]
                continue
            # A driven joint places its link for good; else outer joints keep the chains short.
            joint, link = min(options, key=lambda o: (o[0] not in driven, placed[o[0].other(o[1])]))
            drive = driven.get(joint)
            sign = 1 if drive is None or self.drive(drive).link == link else -1
            edges.append(LinkPlacement(link, joint, drive, sign))
            placed[link] = len(placed)
            del todo[link]
        closures = self.closures({*part}, edges)
        free = sum(edge.drive is None for edge in edges)
        return HigherGroup(tuple(edges), tuple(closures)) if free == sum(c.rows for c in closures) and free else None

    def floating(self, todo: Collection[str], placed: Collection[str]) -> str | None:
        """The first link that joints or drives without a joint tie to links placed before, though none places it."""
        equations = [joint for joint in self.joints.values() if joint.kind.prescribed]
        for link in todo:
            ties = (*self.topology.connections_of(link), *(c for c in equations if link in c.links))
            if any(other in placed for c in ties for other in c.links if other != link):
                return link
        return None

    def closures(self, part: set[str], edges: list[LinkPlacement]) -> list[Connection]:
        """The joints among the links and the known ones that the tree doesn't use."""
        placing: dict[str, list[LinkPlacement]] = {}
        for edge in edges:
            placing.setdefault(edge.joint.joint, []).append(edge)
        found = []
        for pin in self.topology.pins.values():
            parts = [{link} for link in pin.links if link in part]
            if not parts:
                continue
            if known := {link for link in pin.links if link in self.known}:
                parts.append(known)
            for edge in placing.get(pin.name, []):
                joined = [p for p in parts if edge.link in p or edge.base in p]
                parts = [p for p in parts if p not in joined] + [set().union(*joined)]
            heads = [next(link for link in pin.links if link in p) for p in parts]
            found += [Connection(pin.name, PIN, heads[0], head) for head in heads[1:]]
        used = {edge.joint for edge in edges}
        inside = part | self.known.keys()
        equations = [joint for joint in self.joints.values() if joint.kind.prescribed]
        for c in (*self.topology.but_pins, *equations):
            if c not in used and inside.issuperset(c.links) and not part.isdisjoint(c.links):
                found.append(c)
        return found


TWICE = "structure.redundant"

_Side = tuple[str, Connection, Chain]
"""One side of a dyad: the link at the outer joint, that joint, the way to the link at the inner joint."""


def floating_coordinates(link: str) -> list[Connection]:
    """The coordinates of a floating link: the first counts in the frame, the others on what it is by then."""
    coordinates = [("floating_angle", FRAME), ("floating_x", link), ("floating_y", link)]
    return [Connection(f"{link}/{name}", kind(name), base, link) for name, base in coordinates]


def _dyad(a: _Side, inner: Connection, b: _Side) -> Group | None:
    for first, second in ((a, b), (b, a)):
        signature = first[1].kind.letter + inner.kind.letter + second[1].kind.letter
        if signature in REGISTRY:
            return Group(signature, (first[0], second[0]), (first[1], second[1]), inner, (first[2], second[2]))
    return None


def decompose_without(mechanism: Mechanism, releases: tuple[Release, ...]) -> Structure:
    """The structure of a mechanism some equations of which are left out; its topology is that of all of them."""
    found = _GroupSearch(Topology(mechanism, releases)).run()
    return Structure(Topology(mechanism), found.steps, found.findings, releases)


def decompose(mechanism: Mechanism) -> Structure:
    """The structure of a mechanism whose names are sound (see :func:`linkwright.model.check.check_names`)."""
    structure = _GroupSearch(Topology(mechanism)).run()
    looped = structure.topology.closing_slides
    excess = [f for f in structure.findings if f.code == "structure.overconstrained" or (looped and f.code == TWICE)]
    if not excess:
        return structure
    spare = _spare_drive(structure.topology)
    return structure if spare is None else Structure(structure.topology, structure.steps, (spare,))


def _spare_drive(topology: Topology) -> Finding | None:
    """A finding on the last drive without which the structure is sound, where there is one."""
    mechanism = topology.mechanism
    for name, drive in reversed([*mechanism.movers.items()]):
        rest = mechanism.without_mover(name)
        if rest.movers and not _GroupSearch(Topology(rest)).run().findings:
            return Finding("structure.drive-too-many", mechanism.path_of(name), {"link": drive.link, "on": drive.on})
    return None
