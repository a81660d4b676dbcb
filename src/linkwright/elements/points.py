"""Which link a point's name refers to."""

from __future__ import annotations

from typing import Any

AXES = ("x", "y")
"""The coordinates of a point, in the order of the drives that prescribe them along a path."""
FRAME = "frame"
"""The name of the link that doesn't move."""


def links_of_points(mechanism: Any) -> dict[str, str]:
    """The first link that carries each point name: what ``E.x`` refers to."""
    found: dict[str, str] = {}
    for link, entry in mechanism.links.items():
        for point in entry.points:
            found.setdefault(point, link)
    return found
