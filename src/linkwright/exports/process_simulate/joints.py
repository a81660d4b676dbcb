"""The joints of a mechanism as the tool has them: each between a parent and a child link, with a name there."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from linkwright.data_classes import dataclass
from linkwright.structure import FRAME, Driven, Group, Structure


@dataclass(frozen=True)
class ToolJoint:
    """A joint between two links.

    ``joint`` is its name in the model, with that of the child where a pin holds more than two links; ``of`` the pin's
    or slide's. ``kind`` is ``T`` (turns) or ``D`` (slides); ``sign`` is -1 where the tool counts the other way. Its
    value is the child's turn or slide against the parent since the zero pose.
    """

    joint: str
    of: str
    kind: str
    parent: str
    child: str
    name: str = ""
    sign: float = 1.0
    left_out: bool = False


def joints_of(structure: Structure) -> list[ToolJoint]:
    """All joints in the order of solution; the link placed first is the parent."""
    order = placing(structure)
    found: list[tuple[int, ToolJoint]] = []
    for pin in structure.topology.pins.values():
        first, *others = sorted(pin.links, key=order.__getitem__)
        for link in others:
            name = pin.name if len(others) == 1 else f"{pin.name}_{link}"
            found.append((order[link], ToolJoint(name, pin.name, "T", first, link)))
    for name, joint in structure.topology.mechanism.prismatic_joints():
        first, second = sorted(joint.links, key=order.__getitem__)
        found.append((order[second], ToolJoint(name, name, "D", first, second)))
    return [joint for _, joint in sorted(found, key=lambda pair: pair[0])]


def placing(structure: Structure) -> dict[str, int]:
    """The order in which links are placed; of a dyad, the side first that hangs on what was placed last."""
    order = {FRAME: 0}
    for step in structure.steps:
        links = list(step.links)
        if isinstance(step, Group) and order[step.bases[1]] > order[step.bases[0]]:
            links = [*step.sides[1], *step.sides[0]]
        for link in links:
            order[link] = len(order)
    return order


def driving(structure: Structure, drive: str) -> tuple[str, str, str]:
    """The joint that a drive moves, and its links: name in the model, link, the link that it is counted from."""
    moved = structure.topology.mechanism.prescribed(drive)
    for step in structure.steps:
        edges = [step] if isinstance(step, Driven) else []
        joints = [edge.joint for edge in edges] if edges else step.joints
        for joint in joints:
            if {*joint.links} == {moved.link, moved.on} and joint.kind.angular is (moved.turns is not None):
                return joint.joint, moved.link, moved.on
    raise KeyError(drive)


def named(
    joints: list[ToolJoint], names: Mapping[str, str], flipped: Collection[str], left_out: Collection[str]
) -> list[ToolJoint]:
    """The joints with their names in the tool; those of the model where none is given."""
    return [
        ToolJoint(
            j.joint, j.of, j.kind, j.parent, j.child,
            names.get(j.joint, j.joint), -1.0 if j.joint in flipped else 1.0, j.joint in left_out,
        )
        for j in joints
    ]  # fmt: skip
