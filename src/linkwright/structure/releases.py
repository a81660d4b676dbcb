"""Which equations of joints are left out where a redundant mechanism is solved: they follow from all others."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field

from linkwright.data_classes import dataclass
from linkwright.elements import JointKind
from linkwright.elements.joint import Inner, JointGeometry
from linkwright.elements.part_of_joint import PartOfJoint
from linkwright.elements.pins import Pin
from linkwright.notation import Body, Scalar


@dataclass(frozen=True)
class Release:
    """Equations of one joint that the groups don't keep: all between its ``links``, or all but what ``kept`` states.

    Of a pin the second of the two links is taken off it, as the closure between it and the first has it.
    """

    joint: str
    whole: JointKind
    links: tuple[str, ...]
    kept: PartOfJoint | None = None

    @property
    def rows(self) -> int:
        """How many equations are left out."""
        return self.whole.rows - (self.kept.rows if self.kept else 0)

    def inner(self, geometry: JointGeometry) -> Inner:
        """The whole closure between the links."""
        return self.whole.inner(geometry, self.joint, self.links)

    def multipliers(self, geometry: JointGeometry, bodies: Sequence[Body]) -> list[list[Scalar]]:
        """Of each equation left out, the multipliers of the whole closure that stand for a unit of it; ``bodies`` are
        those of the links."""
        if self.kept is not None:
            return [self.kept.dropped(geometry, self.joint, self.links, bodies)]
        return [[float(i == k) for i in range(self.whole.rows)] for k in range(self.whole.rows)]


Component = tuple[str, str, str]
"""One component of a reaction: the joint, the link that acts, and ``x``, ``y``, ``normal`` or ``moment``."""


@dataclass(frozen=True)
class SelfStress:
    """What the states of self-stress of a redundant mechanism do, those that no stiffness determines: by component of a
    reaction, at each of some ``times`` (s) the forces in each state (N, N m)."""

    times: tuple[float, ...] = ()
    forces: Mapping[Component, Sequence[Sequence[float]]] = field(default_factory=dict)

    @property
    def components(self) -> frozenset[Component]:
        """The components that aren't determined."""
        return frozenset(self.forces)


def released_pins(pins: dict[str, Pin], releases: Iterable[Release]) -> dict[str, Pin]:
    """The pins without the links that are taken off them."""
    off = {(one.joint, one.links[1]) for one in releases if one.whole.shared}
    left = {
        name: Pin(name, tuple(member for member in pin.members if (name, member[0]) not in off))
        for name, pin in pins.items()
    }
    return {name: pin for name, pin in left.items() if len(pin.members) > 1}
