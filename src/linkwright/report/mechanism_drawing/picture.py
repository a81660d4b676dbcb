"""The whole drawing, layer upon layer."""

from __future__ import annotations

import numpy as np

from linkwright.escape import markup
from linkwright.report.data import Scene
from linkwright.report.mechanism_drawing.backdrop import backdrop
from linkwright.report.mechanism_drawing.bodies import bodies, ghosts
from linkwright.report.mechanism_drawing.labels import labels
from linkwright.report.mechanism_drawing.paths import areas, traces
from linkwright.report.mechanism_drawing.shapes import number, spring
from linkwright.report.mechanism_drawing.survey import Survey, survey
from linkwright.report.mechanism_drawing.view import View, fit
from linkwright.words import say

WIDTH, MOST, R = 520.0, 460.0, 5.8
"""Width and largest height of the drawing, and half a bar's width, in pixels."""
GHOSTS = 3
"""So many further poses are drawn faintly."""


def drawing(scene: Scene) -> str:
    """The SVG of a scene at its first pose that can be assembled, with faint further poses and the paths of points;
    where no pose can, it says so."""
    known = survey(scene)
    view = fit(known, WIDTH, MOST)
    k = int(known.sound[0]) if known.sound.size else 0
    picture = [
        backdrop(known, view),
        areas(known, view),
        ghosts(known, view, R, _faint(known)),
        traces(known, view, k),
        bodies(known, view, R, k),
        _springs(known, view, k),
        _pins(known, view, k),
        labels(known, view, R, k),
    ]
    if not known.sound.size:
        note = markup(say("report.not_assembled"))
        picture.append(f'<text class="lw-note" x="{number(WIDTH / 2)}" y="24" text-anchor="middle">{note}</text>')
    size = f"0 0 {number(view.width)} {number(view.height)}"
    title = markup(say("report.drawing"))
    return f'<svg class="lw lw-drawing" viewBox="{size}" role="img" aria-label="{title}">{"".join(picture)}</svg>'


def _faint(known: Survey) -> list[int]:
    count = max(min(GHOSTS, known.sound.size - 1), 0)
    return [int(known.sound[(i + 1) * known.sound.size // (count + 1)]) for i in range(count)]


def _springs(known: Survey, view: View, k: int) -> str:
    points = {link["name"]: link["points"] for link in known.scene["links"]}
    found = ""
    for one in known.scene.get("springs", ()):
        ends = zip(one["links"], one["points"], strict=True)
        start, stop = (view.to_picture(known.poses[link].at(k, [points[link][point]]))[0] for link, point in ends)
        if np.isfinite([start, stop]).all():
            found += f'<path class="lw-spring" d="{spring(start, stop, one["look"], R)}"/>'
    return found


def _pins(known: Survey, view: View, k: int) -> str:
    """A circle for each pin and each point that moves."""
    links = {link["name"]: link for link in known.scene["links"]}
    found = ""
    for pin in known.pins:
        link, point = pin.places[0]
        x, y = view.to_picture(known.poses[link].at(k, [links[link]["points"][point]]))[0].tolist()
        if not np.isfinite([x, y]).all() or (links[link]["fixed"] and not pin.joined):
            continue
        look = ("lw-pin", 4.3) if pin.joined else (f"lw-point {known.colour(link)}", 2.6)
        found += f'<circle class="{look[0]}" r="{look[1]}" cx="{number(x)}" cy="{number(y)}"/>'
    return found
