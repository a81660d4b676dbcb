"""Why a mechanism can't be solved: findings on what is left, what is too much, and outputs that drives can't move."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from linkwright.expressions.unknown import alike
from linkwright.findings import Finding, Joined
from linkwright.model.mechanism import FRAME
from linkwright.model.slides import closing
from linkwright.structure.freedoms import Freedoms
from linkwright.structure.placed import PlacedLinks
from linkwright.structure.steps import Step
from linkwright.structure.topology import PIN, Connection, Topology

HARDLY = 0.5
"""The share of two names that agree, where what is left over speaks for one pin: C0 and CX."""
EXCESS = ("structure.overconstrained", "structure.redundant")
"""The findings on constraints in excess, which may follow from the others: the mechanism is redundant then."""
MANY = 12
"""The most loose links that are all named; of more, those at which the free motions begin."""


def unsolved(placed: PlacedLinks) -> Iterator[Finding]:
    """Drives that prescribe nothing new, and the links left: held too much, loose, or in loops of slides."""
    for name in placed.joints:
        drive = placed.drive(name)
        if drive.link in placed.known:
            path = placed.topology.mechanism.path_of(name)
            yield Finding("structure.drive-too-many", path, {"link": drive.link, "on": drive.on})
    if not placed.remaining_links:
        return
    freedoms = placed.freedoms()
    full = list(freedoms.overfull())
    for links, excess in full:
        yield Finding("structure.overconstrained", ("links", links[0]), {"links": Joined(links), "excess": excess})
    crowded = {link for links, _ in full for link in links}
    unpinned: set[object] = set()
    parts = [(part, freedoms.loose(part)) for part in placed.parts(placed.remaining_links)]
    # Where so many freedoms are left as one pin takes, that one is looked for by less of its spelling.
    one_pin = sum(sum(free.values()) for _, free in parts) == PIN.rows and not full
    for part, free in parts:
        if free:
            finding = _loose(placed, freedoms, part, free, HARDLY if one_pin else None)
            pair = frozenset((finding.data.get("point"), finding.data.get("other"))) - {None}
            if pair not in unpinned:  # the two parts that a misspelled pin leaves are one mistake
                yield finding
            unpinned |= {pair} if pair else set()
        elif crowded.isdisjoint(part):
            yield Finding("structure.loop-of-slides", ("links", part[0]), {"links": Joined(part)})


def _loose(
    placed: PlacedLinks, freedoms: Freedoms, part: list[str], free: dict[str, int], cutoff: float | None
) -> Finding:
    """What a connected part of the links lacks: a pin, by the spelling of its points, or a drive."""
    links = part if len(part) <= MANY else list(free)
    data: dict[str, object] = {"links": Joined(links[:MANY]), "freedom": sum(free.values())}
    for (link, point), (on, other) in _alike(placed.topology, part, cutoff):
        if freedoms.could_join(link, on):
            data |= {"point": point, "link": link, "other": other, "on": on}
            code = "structure.unpinned-joint" if other in placed.topology.pins else "structure.unpinned"
            return Finding(code, ("links", link, "points", point), data)
    data |= {"hint": _drive_hint(placed, part)}
    if links is part:
        return Finding("structure.loose", ("links", links[0]), data)
    return Finding("structure.loose-many", ("links", links[0]), {**data, "count": len(part)})


def _alike(
    topology: Topology, part: list[str], cutoff: float | None
) -> Iterator[tuple[tuple[str, str], tuple[str, str]]]:
    """Points on one link each and of no joint, with like names (in the share ``cutoff``), the first on a link of the
    part; then such a point and the pin of others whose name differs in letters."""
    used = {member for pin in topology.pins.values() for member in pin.members}
    used |= {
        (link, line.point)
        for _, joint in topology.mechanism.prismatic_joints()
        for link, line in zip(joint.links, joint.line or (), strict=False)
    }
    alone = [(link, p) for link, of in topology.mechanism.links.items() for p in of.points if (link, p) not in used]
    for link, point in alone:
        others = {other: on for on, other in alone if on != link}
        if link in part:
            yield from (((link, point), (others[other], other)) for other in alike(point, [*others], cutoff))
    for link, point in alone:
        if link in part:
            pins = [name for name in topology.pins if _digits(name) == _digits(point)]
            yield from (((link, point), (topology.pins[pin].links[0], pin)) for pin in alike(point, pins))


def _digits(name: str) -> str:
    return "".join(filter(str.isdigit, name))


def _drive_hint(placed: PlacedLinks, part: list[str]) -> str:
    """A drive line that would hold a loose part, where one of its links hangs on a known one."""
    for link in part:
        for c in placed.outers(link):
            return f"{{{c.kind.drive}: {link}, on: {c.other(link)}, ...}}"
    return ""


def fixed_angles(topology: Topology, drives: Mapping[str, Connection]) -> Iterator[Finding]:
    """Drives of an angle without a joint between links whose angle slides and other drives give already: these count
    the same freedoms otherwise, but no motion has them."""
    turning = {name: c for name, c in drives.items() if topology.mechanism.prescribed(name).turns}
    ties = [(name, frozenset(c.links)) for name, c in turning.items() if not c.kind.prescribed]
    apart = [(name, frozenset(c.links)) for name, c in turning.items() if c.kind.prescribed]
    slides = [*topology.slide_pairs.items()]
    for i, (name, _) in enumerate(apart):
        if closing([*slides, *ties, *apart[: i + 1]])[-1:] == [name]:
            on, link = topology.mechanism.prescribed(name).on, topology.mechanism.prescribed(name).link
            yield Finding("structure.drive-angle-fixed", topology.mechanism.path_of(name), {"link": link, "on": on})


def redundant(topology: Topology, steps: Sequence[Step]) -> Iterator[Finding]:
    """Joints between links that other joints have placed already."""
    used = Counter(c.joint for step in steps for c in step.joints)
    links = {name: pin.links for name, pin in topology.pins.items()}
    needed = {name: len(joined) - 1 for name, joined in links.items()}
    links |= {c.joint: c.links for c in topology.but_pins}
    for name, joined in links.items():
        if used[name] < needed.get(name, 1):
            yield Finding("structure.redundant", ("joints", name), {"joint": name, "links": Joined(joined)})


def immovable_outputs(topology: Topology, steps: Sequence[Step]) -> Iterator[Finding]:
    """Drives that can't move the outputs asked of them, since these don't move the drives' own joints.

    Each needs an output of its own that moves its joint (with several drives not its own one by need).
    """
    moved_by: dict[str, set[str]] = {FRAME: set()}
    for step in steps:
        hung = {link for joint in step.joints for link in (joint.a, joint.b)} & moved_by.keys()
        moved_by |= dict.fromkeys(step.links, set(step.drives).union(*(moved_by[link] for link in hung)))
    drives = {name: drive for name, drive in topology.mechanism.drives.items() if drive.output}
    taken: dict[str, str] = {}

    def assign_output(name: str, tried: set[str]) -> bool:
        """An output for the drive, by turns with drives that can take another one (augmenting paths)."""
        for output in (moved_by[drives[name].link] | moved_by[drives[name].on]) & drives.keys() - tried:
            tried.add(output)
            if output not in taken or assign_output(taken[output], tried):
                taken[output] = name
                return True
        return False

    for name, drive in drives.items():
        if not assign_output(name, set()):
            data = {"output": drive.output, "link": drive.link, "on": drive.on}
            yield Finding("structure.output-apart", ("drives", name, "output"), data)
