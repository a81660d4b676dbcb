"""The moving links at a pose: bars and plates, slots, blocks, cylinders, lines of cams."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.report.data import LinkData
from linkwright.report.mechanism_drawing.joints import HEIGHT, LENGTH, Guide, Side, in_cylinder
from linkwright.report.mechanism_drawing.shapes import UNSEEN, hull, line, outline
from linkwright.report.mechanism_drawing.survey import Survey
from linkwright.report.mechanism_drawing.view import View

Array = NDArray[np.float64]
Placed = Callable[[Array], Array]
"""From a link's axes into the picture."""

FIXED = "lw-on-frame"
"""The class of what is drawn of the fixed link."""
FAINT = 0.5
"""Faint lines may differ by so much from those that they stand for, in pixels."""


@dataclass
class Layers:
    """Shapes as (class, path), from the lowest layer to the top."""

    slots: list[tuple[str, str]] = field(default_factory=list)
    bodies: list[tuple[str, str]] = field(default_factory=list)
    blocks: list[tuple[str, str]] = field(default_factory=list)


def bodies(survey: Survey, view: View, r: float, k: int) -> str:
    """All moving links that have a place at a sample, and outlines on the fixed one. ``r``: half a bar's width."""
    drawn = [(FIXED, _outlined(link, survey, view, k)) for link in survey.scene["links"] if link["fixed"]]
    drawn += [(survey.colour(link["name"]), _layers(link, survey, view, r, k)) for link in survey.moving]
    return "".join(
        f'<path class="{kind} {colour}" d="{d}"/>'
        for layer in ("slots", "bodies", "blocks")
        for colour, layers in drawn
        for kind, d in getattr(layers, layer)
    )


def ghosts(survey: Survey, view: View, r: float, samples: list[int]) -> str:
    """The lines of all moving links at some samples, one path a link."""
    paths = ""
    for link in survey.moving:
        each = (_layers(link, survey, view, r, k, FAINT) for k in samples)
        d = "".join(d for of in each for layer in (of.slots, of.bodies, of.blocks) for _, d in layer)
        paths += f'<path class="{survey.colour(link["name"])}" d="{d}"/>' if d else ""
    return f'<g class="lw-ghost">{paths}</g>' if paths else ""


def _outlined(link: LinkData, survey: Survey, view: View, k: int, unseen: float = UNSEEN) -> Layers:
    """The outlines of joints on a link, such as pitch circles."""
    poses, found = survey.poses[link["name"]], Layers()
    for shape in link.get("outlines", ()):
        placed = view.to_picture(poses.at(k, np.array(shape, float)))
        found.slots.append(("lw-slot lw-outline", line(placed, closed=True, unseen=unseen)))
    return found


def _layers(link: LinkData, survey: Survey, view: View, r: float, k: int, unseen: float = UNSEEN) -> Layers:
    poses, found = survey.poses[link["name"]], Layers()
    if not poses.known[k]:
        return found

    def placed(local: Array) -> Array:
        return view.to_picture(poses.at(k, local))

    sliding = False
    for guide in survey.guides:
        for side in (guide.guide, guide.block):
            if side.link == link["name"]:
                sliding = True
                _slide(guide, side, view, placed, found)
    found.slots += _outlined(link, survey, view, k, unseen).slots
    ring = hull(np.array(list(link["points"].values()), float).reshape(-1, 2) * view.k) / view.k
    shown = len(ring) > 1 or not sliding
    if len(ring) > 2 or (shown and not in_cylinder(survey.guides, link["name"])):
        found.bodies.append(("lw-body", outline(placed(ring), r)))
    return found


def _slide(guide: Guide, side: Side, view: View, placed: Placed, found: Layers) -> None:
    """What a link has of a prismatic joint."""
    if guide.cylinder:
        _cylinder(guide, side, view, placed, found)
    elif side is guide.guide:
        ends = hull(np.array([side.along(guide.low), side.along(guide.high)]) * view.k) / view.k
        found.slots.append(("lw-slot", outline(placed(ends), HEIGHT / 2 + 3)))
    else:
        found.blocks.append(("lw-block", _box(side, view, placed, -LENGTH / 2, LENGTH / 2, HEIGHT / 2)))


def _cylinder(guide: Guide, side: Side, view: View, placed: Placed, found: Layers) -> None:
    """Barrel (on the guide's link) or rod and piston (on the block's) of a cylinder, for its whole travel."""
    near, far = (reach * view.k for reach in guide.reach)
    turned = guide.turn(side)
    if side is guide.guide:
        found.bodies.append(("lw-body", _box(turned, view, placed, 0.0, max(near - 14, 20.0), 10.0)))
        return
    length = far - near + 24
    ends = placed(np.array([turned.along(0.0), turned.along(length / view.k)]))
    found.slots.append(("lw-rod", line(ends)))
    found.slots.append(("lw-piston", _box(turned, view, placed, length - 3, length + 3, 8.0)))


def _box(side: Side, view: View, placed: Placed, start: float, stop: float, half: float) -> str:
    """A rectangle along a side's line, in pixels from its point."""
    corners = ((start, -half), (stop, -half), (stop, half), (start, half))
    return line(placed(np.array([side.along(x / view.k, y / view.k) for x, y in corners])), closed=True)
