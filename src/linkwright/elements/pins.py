"""Which points are pinned together: the revolute joints that a mechanism's point names imply."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from linkwright.data_classes import dataclass


@dataclass(frozen=True)
class Pin:
    """A revolute joint: the links on one pin, each with the name of its point there."""

    name: str
    members: tuple[tuple[str, str], ...]

    @cached_property
    def links(self) -> tuple[str, ...]:
        """The links on the pin, in the file's order."""
        return tuple(link for link, _ in self.members)

    def point(self, link: str) -> str:
        """The link's point on this pin."""
        return dict(self.members)[link]


def pins(mechanism: Any) -> dict[str, Pin]:
    """All pins by name: points of the same name on several links, and points joined by a revolute joint.

    A pin is called after its point; where a joint ties points of two names, after the joint.
    """
    group: dict[tuple[str, str], str] = {}
    for link, entry in mechanism.links.items():
        for point in entry.points:
            group[link, point] = point
    for name, joint in mechanism.joints.items():
        if joint.revolute is None or joint.at is None:
            continue
        ends = list(zip(joint.revolute, joint.at, strict=True))
        merged = {group[end] for end in ends if end in group}
        for member, of in group.items():
            if of in merged:
                group[member] = name
    members: dict[str, list[tuple[str, str]]] = {}
    for member, name in group.items():
        members.setdefault(name, []).append(member)
    return {name: Pin(name, tuple(of)) for name, of in members.items() if len(of) > 1}
