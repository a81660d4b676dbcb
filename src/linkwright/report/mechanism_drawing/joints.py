"""Joints as they are drawn: points that revolute joints hold together as pins, prismatic joints as guide and block."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import cos, inf, pi, sin

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.report.data import JointData, Scene
from linkwright.report.mechanism_drawing.poses import Poses

LENGTH, HEIGHT = 30.0, 18.0
"""Size of a block, in pixels."""


@dataclass
class Pin:
    """A pin, or a point that no joint holds: its places as (link, point), the fixed link's first."""

    name: str
    places: list[tuple[str, str]]
    joined: bool = False


def in_cylinder(guides: Sequence[Guide], link: str) -> bool:
    """Whether a link is barrel or rod of a cylinder, whose symbol stands for what lies on its line."""
    return any(one.cylinder and link in (one.guide.link, one.block.link) for one in guides)


def pins_of(scene: Scene) -> list[Pin]:
    """All pins of a scene, in the order of its links."""
    at = {
        (link["name"], point): Pin(point, [(link["name"], point)])
        for link in scene["links"]
        for point in link["points"]
    }
    fixed = {link["name"] for link in scene["links"] if link["fixed"]}
    for joint in scene["joints"]:
        if "angles" in joint:
            continue
        one, other = (at[place] for place in zip(joint["links"], joint["points"], strict=True))
        if one is not other:
            one.name = one.name if one.name == other.name else joint["name"]
            one.places += other.places
            at.update(dict.fromkeys(other.places, one))
        one.joined = True
    found = list({id(pin): pin for pin in at.values()}.values())
    for pin in found:
        pin.places.sort(key=lambda place: place[0] not in fixed)
    return found


@dataclass(frozen=True)
class Side:
    """One side of a prismatic joint: its line by a point and a direction in its link's axes."""

    link: str
    local: tuple[float, float]
    angle: float

    def along(self, travel: float, across: float = 0.0) -> tuple[float, float]:
        """The place at a distance from the point along the line, and beside it."""
        c, s = cos(self.angle), sin(self.angle)
        return self.local[0] + travel * c - across * s, self.local[1] + travel * s + across * c


@dataclass(frozen=True)
class Guide:
    """Guide and block with the block's travel along the guide, from ``low`` to ``high`` of the guide's point."""

    guide: Side
    block: Side
    low: float
    high: float
    fixed: bool
    cylinder: bool

    @property
    def forward(self) -> bool:
        """Whether the rod of a cylinder leaves it along the line."""
        return abs(self.high) >= abs(self.low)

    @property
    def reach(self) -> tuple[float, float]:
        """The least and the largest distance of the two points of a cylinder."""
        near, far = sorted((abs(self.low), abs(self.high)))
        return near, far

    def turn(self, side: Side) -> Side:
        """A side of a cylinder, turned towards the other one."""
        back = self.forward != (side is self.guide)
        return Side(side.link, side.local, side.angle + pi) if back else side


def guides_of(scene: Scene, poses: Mapping[str, Poses]) -> list[Guide]:
    """The prismatic joints of a scene."""
    return [_guide(scene, joint, poses) for joint in scene["joints"] if "angles" in joint]


def _guide(scene: Scene, joint: JointData, poses: Mapping[str, Poses]) -> Guide:
    links = {link["name"]: link for link in scene["links"]}
    sides = []
    for link, point, angle in zip(joint["links"], joint["points"], joint["angles"], strict=True):
        x, y = links[link]["points"][point]
        sides.append(Side(link, (x, y), angle))
    one, other = sides
    guide, block = (other, one) if links[other.link]["fixed"] and not links[one.link]["fixed"] else (one, other)
    fixed = links[guide.link]["fixed"]
    cylinder = joint.get("look") == "cylinder" and not fixed
    # A slot in a moving link reaches to the guide's own point too.
    low, high = (inf, -inf) if fixed or cylinder else (0.0, 0.0)
    carrier, rider = poses[guide.link], poses[block.link]
    between = (rider.places([block.local]) - carrier.places([guide.local]))[:, 0]
    along = np.arctan2(carrier.s, carrier.c) + guide.angle
    travel = between[:, 0] * np.cos(along) + between[:, 1] * np.sin(along)
    travel = travel[np.isfinite(travel)]
    low, high = min([low, *travel.tolist()]), max([high, *travel.tolist()])
    return (
        Guide(guide, block, low, high, fixed, cylinder) if low <= high else Guide(guide, block, 0, 0, fixed, cylinder)
    )
