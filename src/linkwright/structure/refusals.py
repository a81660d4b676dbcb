"""Why a mechanism can't be solved: findings on what is left, what is too much, and outputs that drives can't move."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from linkwright.model.findings import Finding
from linkwright.model.mechanism import FRAME
from linkwright.structure.placed import Placed
from linkwright.structure.steps import Step
from linkwright.structure.topology import Topology


def unsolved(placed: Placed) -> Iterator[Finding]:
    """Drives that prescribe nothing new, and the links left: loose, held too much, or too many in one group."""
    for name in placed.joints:
        drive = placed.drive(name)
        if drive.link in placed.known:
            yield Finding("structure.drive-too-many", ("drives", name), {"link": drive.link, "on": drive.on})
    for part in placed.parts(placed.left):
        part = placed.overfull(part) or part
        path, names, freedom = ("links", part[0]), ", ".join(part), placed.freedom(part)
        if freedom > 0:
            data = {"links": names, "freedom": freedom, "hint": _drive_hint(placed, part)}
            yield Finding("structure.loose", path, data)
        elif freedom < 0:
            yield Finding("structure.overconstrained", path, {"links": names, "excess": -freedom})
        elif placed.closing_slides({*part, *placed.known}):
            yield Finding("structure.loop-of-slides", path, {"links": names})
        else:
            yield Finding("structure.higher-group", path, {"links": names, "most": placed.LARGEST})


def _drive_hint(placed: Placed, part: list[str]) -> str:
    """A drive line that would hold a loose part, where one of its links hangs on a known one."""
    for link in part:
        for c in placed.outers(link):
            verb = "turns" if c.letter == "R" else "slides"
            return f"{{{verb}: {link}, on: {c.other(link)}, ...}}"
    return ""


def redundant(topology: Topology, steps: Sequence[Step]) -> Iterator[Finding]:
    """Joints between links that other joints have placed already."""
    used = Counter(c.joint for step in steps for c in step.joints)
    links = {name: pin.links for name, pin in topology.pins.items()}
    links |= {name: joint.links for name, joint in topology.mechanism.prismatic_joints()}
    for name, joined in links.items():
        if used[name] < len(joined) - 1:
            yield Finding("structure.redundant", ("joints", name), {"joint": name, "links": ", ".join(joined)})


def apart(topology: Topology, steps: Sequence[Step]) -> Iterator[Finding]:
    """Drives that can't move the outputs asked of them, since these don't move the drives' own joints.

    Each needs an output of its own that moves its joint (with several drives not its own one by need).
    """
    moved_by: dict[str, set[str]] = {FRAME: set()}
    for step in steps:
        hung = {link for joint in step.joints for link in (joint.a, joint.b)} & moved_by.keys()
        moved_by |= dict.fromkeys(step.links, set(step.drives).union(*(moved_by[link] for link in hung)))
    drives = {name: drive for name, drive in topology.mechanism.drives.items() if drive.output}
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
            yield Finding("structure.output-apart", ("drives", name, "output"), data)
