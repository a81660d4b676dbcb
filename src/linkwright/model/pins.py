"""Pins of a file: those that its links' points make, and those that only cylinders name."""

from __future__ import annotations

from collections import Counter

from linkwright.elements.pins import Pin, pins
from linkwright.elements.points import links_of_points
from linkwright.model.mechanism import Mechanism

__all__ = ["Pin", "pins", "shared_pins"]


def shared_pins(m: Mechanism) -> list[str]:
    """The points that only cylinders name, several of them: pins between their barrels and rods."""
    named = Counter(point for cylinder in m.cylinders.values() for point in {cylinder.from_, cylinder.to})
    links = links_of_points(m)
    return [point for point, count in named.items() if count > 1 and point not in links]
