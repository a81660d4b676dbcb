"""Once around a cam, with quarter circles on which the path is entered and left."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.nc.path import CutterPath, Element

Array = NDArray[np.float64]
Ends = tuple[Array, Array, Array]
"""Places (mm), tangents and outward normals of a path's start and end, (2, 2) each, first the start's."""

QUARTER = math.pi / 2


def around(route: CutterPath, overlap: float, radius: float, away: int = 1) -> tuple[Element, ...]:
    """Entry, once around and on by the ``overlap`` (mm), exit; both on quarter circles of a ``radius`` (mm) that lie
    outward of the path (``away`` +1) or inward (-1). Without any where it is 0."""
    turn = route.elements()
    more = share(route, overlap)
    again = route.elements(more)
    if not radius:
        return (*turn, *again)
    first, last = leads(path_ends(route, more), radius, away, route.decimals)
    return (first, *turn, *again, last)


def path_ends(route: CutterPath, more: float) -> Ends:
    """Where a path begins and where it ends, at the share ``more`` of the second turn."""
    at, tangents, normals, _ = route.at(np.array([0.0, more]))
    return np.round(at, route.decimals).T, tangents.T, normals.T


def leads(ends: Ends, radius: float, away: int, decimals: int) -> tuple[Element, Element]:
    """The quarter circles of entry and exit."""
    first, last = zip(*ends, strict=True)
    return (
        quarter(first[0], first[1], away * first[2], radius, decimals, True),
        quarter(last[0], last[1], away * last[2], radius, decimals, False),
    )


def share(route: CutterPath, length: float) -> float:
    """The share of the turn that a length (mm) from the start takes, about."""
    look = route.look(np.zeros(1))
    speed = 1e3 * float(np.broadcast_to(look.speed.d[0], 1)[0] * abs(look.radius(route.offset)[0] / look.radius()[0]))
    return min(0.25, length / (speed * 2 * math.pi))


def quarter(at: Array, tangent: Array, normal: Array, radius: float, decimals: int, entry: bool) -> Element:
    """A quarter circle that comes in along the normal and ends on the tangent, or the reverse."""
    centre = at + radius * normal
    away = np.round(centre + (-radius if entry else radius) * tangent, decimals)
    turn = 1 if tangent[0] * normal[1] - tangent[1] * normal[0] > 0 else -1
    start, end = (away, at) if entry else (at, away)
    middle = _centre(start, end, turn * QUARTER, decimals)
    return Element(tuple(start), tuple(end), middle, turn)


def _centre(start: Array, end: Array, angle: float, decimals: int) -> tuple[float, float]:
    along = end - start
    found = (start + end) / 2 + np.array([-along[1], along[0]]) / (2 * math.tan(angle / 2))
    return tuple(start + np.round(found - start, decimals + 1))


def beyond(lead: Element, far: float, last: bool = False) -> tuple[float, float]:
    """The way (mm) from a lead's outer end straight on, away from what is cut."""
    assert lead.centre is not None
    (x, y), (cx, cy) = (lead.end if last else lead.start), lead.centre
    dx, dy = x - cx, y - cy
    size = (dx * dx + dy * dy) ** 0.5
    turn = lead.turn if last else -lead.turn
    return -turn * dy / size * far, turn * dx / size * far
