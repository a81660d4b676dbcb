"""Names of pins and links, kept clear of what they name."""

from __future__ import annotations

import re
from math import atan2, cos, hypot, pi, sin

import numpy as np
from numpy.typing import NDArray

from linkwright.escape import markup
from linkwright.presentation.lettering import columns
from linkwright.report.data import LinkData
from linkwright.report.mechanism_drawing.joints import HEIGHT, Pin
from linkwright.report.mechanism_drawing.shapes import hull, number
from linkwright.report.mechanism_drawing.survey import Survey
from linkwright.report.mechanism_drawing.view import View

Array = NDArray[np.float64]

LATIN = re.compile("[ -\u024f]*")
"""Such names are slanted; hanzi have no slanted form."""
MIDDLE = 4.2
"""From the middle of a letter down to its base line, in pixels."""
LETTER = 6.4
"""The width of a letter, near enough."""
INSTANTS = 16
"""So many samples show where the links of a pin are over the motion."""


def labels(survey: Survey, view: View, r: float, k: int) -> str:
    """All names at a sample."""
    pins = "".join(_pin_name(pin, survey, view, r, k) for pin in survey.pins)
    links = "".join(_link_name(link, survey, view, r, k) for link in survey.moving)
    return f'<g class="lw-labels">{pins}{links}</g>'


def _pin_name(pin: Pin, survey: Survey, view: View, r: float, k: int) -> str:
    link, point = pin.places[0]
    if not survey.poses[link].known[k]:
        return ""
    x, y = view.to_picture(survey.poses[link].at(k, [_local(survey, link, point)]))[0].tolist()
    direction = _free_direction(pin, survey)
    dx, dy = cos(direction), sin(direction)
    anchor = "start" if dx > 0.3 else "end" if dx < -0.3 else "middle"
    place = f'x="{number(x + dx * (r + 7))}" y="{number(y + dy * (r + 9) + MIDDLE)}"'
    return f'<text class="lw-label" text-anchor="{anchor}" {place}>{markup(pin.name)}</text>'


def _local(survey: Survey, link: str, point: str) -> tuple[float, float]:
    of = next(one for one in survey.scene["links"] if one["name"] == link)
    x, y = of["points"][point]
    return x, y


def _free_direction(pin: Pin, survey: Survey) -> float:
    """The direction (one of eight, radians, clockwise) in which a pin's name meets its links least."""
    busy = _busy_directions(pin, survey)
    if any(link["fixed"] for link in survey.scene["links"] if link["name"] == pin.places[0][0]):
        busy = np.append(busy, [0.9, 1.57, 2.24] * 3)  # its symbol
    choices = [eighth * pi / 4 for eighth in (-1, -3, 1, 3, 0, 4, -2, 2)]
    costs = [float((np.maximum(0, np.cos(busy - choice)) ** 3).sum()) for choice in choices]
    least = min(costs)
    return next(choice for choice, cost in zip(choices, costs, strict=True) if cost < least + 1e-9)


def _busy_directions(pin: Pin, survey: Survey) -> Array:
    """Where the links of a pin reach from it, over the motion (radians, clockwise)."""
    x0, y0, x1, y1 = survey.box
    near = 1e-6 * max(x1 - x0, y1 - y0)
    found = [np.empty(0)]
    for link in survey.moving:
        for _, point in (place for place in pin.places if place[0] == link["name"]):
            every = survey.poses[link["name"]].places(list(link["points"].values()))
            every = every[:: max(1, len(every) // INSTANTS)]
            off = (every - every[:, [list(link["points"]).index(point)]]).reshape(-1, 2)
            off = off[np.hypot(*off.T) > near]
            found.append(np.arctan2(-off[:, 1], off[:, 0]))
    return np.concatenate(found)


def _link_name(link: LinkData, survey: Survey, view: View, r: float, k: int) -> str:
    """A link's name: in the middle of a plate, along the side of a bar or a slide."""
    name, poses = link["name"], survey.poses[link["name"]]
    points = np.array(list(link["points"].values()), float).reshape(-1, 2)
    ring = hull(points * view.k) / view.k
    if not len(ring) or not poses.known[k]:
        return ""
    riding = next((guide for guide in survey.guides if guide.block.link == name), None)
    slide = riding or next((guide for guide in survey.guides if guide.guide.link == name), None)
    side = riding.block if riding else slide.guide if slide else None
    middle = ring.mean(axis=0)
    if len(ring) == 2:
        middle = _widest_gap(ring, points)
    elif slide and side is slide.guide and slide.cylinder:
        middle = np.array(side.along((slide.low + slide.high) / 4))
    x, y = view.to_picture(poses.at(k, [middle]))[0].tolist()
    half = LETTER / 2 * columns(name)
    if len(ring) <= 2:
        bar = ring[1] - ring[0] if len(ring) == 2 else None
        along = atan2(bar[1], bar[0]) if bar is not None else side.angle if side else 0.0
        away = r + 3 if bar is not None else HEIGHT / 2 + 6
        across = poses.turn(k) + along - pi / 2
        x, y = x + cos(across) * (away + half), y - sin(across) * (away + 7)
    x = min(max(x, half + 4), view.width - half - 4)
    slanted = " lw-slanted" if LATIN.fullmatch(name) else ""
    look = f"lw-label lw-name{slanted} {survey.colour(name)}"
    return f'<text class="{look}" text-anchor="middle" x="{number(x)}" y="{number(y + MIDDLE)}">{markup(name)}</text>'


def _widest_gap(bar: Array, points: Array) -> Array:
    """Middle of the longest stretch of a bar that is free of points."""
    row = points[np.argsort((points - bar[0]) @ (bar[1] - bar[0]), kind="stable")]
    widest = int(np.argmax([hypot(*step) for step in np.diff(row, axis=0)]))
    middle: Array = row[widest : widest + 2].mean(axis=0)
    return middle
