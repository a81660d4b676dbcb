"""Lines that joints draw on links: places by a parameter, so that a page draws them at any numbers of the file."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import NamedTuple

from linkwright.notation import Pair, Scalar
from linkwright.notation.jets import call

AROUND = 72
"""Places of a circle."""


class Curve(NamedTuple):
    """A line that is drawn on a link: an open one becomes a slot, a closed one is drawn as it is.

    ``place`` gives its places (m) in the link's axes at values of a parameter that runs between two ``ends``; they may
    be numbers, arrays or symbols.
    """

    link: str
    place: Callable[[Scalar], Pair]
    ends: tuple[Scalar, Scalar]
    closed: bool = False
    points: int = 65


def circle(link: str, centre: Pair, radius: Scalar) -> Curve:
    """A circle (m)."""

    def place(turn: Scalar) -> Pair:
        return Pair(centre.x + radius * call("cos", turn), centre.y + radius * call("sin", turn))

    return Curve(link, place, (0.0, 2.0 * math.pi), closed=True, points=AROUND)


def spoked(link: str, centre: Pair, radius: Scalar) -> list[Curve]:
    """A circle with a spoke, from which its turning is seen."""
    return [circle(link, centre, radius), polygon(link, [centre, Pair(centre.x + radius, centre.y)])]


def polygon(link: str, corners: Sequence[Pair]) -> Curve:
    """A closed line through corners (m); the parameter is their number."""

    def place(number: Scalar) -> Pair:
        x, y = corners[0]
        for k, corner in enumerate(corners[1:], start=1):
            here = number >= k - 0.5
            x, y = call("where", here, corner.x, x), call("where", here, corner.y, y)
        return Pair(x, y)

    return Curve(link, place, (0.0, float(len(corners))), closed=True, points=len(corners))
