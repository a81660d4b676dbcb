"""What is said of a Geneva drive before it runs: when it moves and when it stands, and how hard."""

from __future__ import annotations

from math import acos, cos, pi, sin, sqrt, tan
from typing import TYPE_CHECKING

from linkwright.elements.geneva.contact import Dimensions, Indexing
from linkwright.expressions import units as u
from linkwright.findings import Joined, Said
from linkwright.notation import Jet

if TYPE_CHECKING:
    from linkwright.elements.follower import FollowerGeometry
    from linkwright.elements.geneva.follower import GenevaDrive


def sentence(geometry: FollowerGeometry, drive: GenevaDrive) -> Said:
    """Step, stretches in the drive's angle, and peaks over the driver's speed and its square."""
    at = Dimensions.of(geometry, drive)
    slots, half = round(pi / float(at.half)), float(at.half)
    reach, ranges = pi / 2 - half, list[str]()
    for psi in Indexing(drive, at).angles(at, Jet([0.0])):
        ends = sorted(drive.motor_sign * (end - float(psi.d[0])) for end in (-reach, reach))
        ranges.append(" .. ".join(geometry.text_of(end, u.ANGLE) for end in ends))
    speed, acceleration, beside = peaks(slots)
    return Said(
        "fact.law.geneva",
        step=geometry.text_of(2 * half, u.ANGLE),
        motor=drive.motor,
        ranges=Joined(ranges),
        turn=geometry.text_of(2 * pi, u.ANGLE),
        share=f"{len(at.arms) * reach / pi:.4g}",
        speed=f"{speed:.6g}",
        acceleration=f"{acceleration:.6g}",
        beside=geometry.text_of(beside, u.ANGLE),
        entry=f"{tan(half):.6g}",
    )


def peaks(slots: int) -> tuple[float, float, float]:
    """Peak speed and peak acceleration of the wheel at a driver's speed of 1, and the driver's angle (rad) from the
    middle of the indexing at which the latter is."""
    size = sin(pi / slots)
    level = (1 + size * size) / (4 * size)
    beside = acos(sqrt(level * level + 2) - level)
    below = 1 - 2 * size * cos(beside) + size * size
    return size / (1 - size), size * (1 - size * size) * sin(beside) / below**2, beside
