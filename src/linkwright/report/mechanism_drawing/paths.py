"""Paths of points, and areas behind the mechanism."""

from __future__ import annotations

import numpy as np

from linkwright.report.mechanism_drawing.shapes import line, number
from linkwright.report.mechanism_drawing.survey import PALETTE, Survey, rows
from linkwright.report.mechanism_drawing.view import View

DOT = 3.4
"""Radius of the dot on a path, in pixels."""


def areas(survey: Survey, view: View) -> str:
    """What lies behind the mechanism."""
    found = ""
    for i, area in enumerate(survey.scene.get("areas", ())):
        d = "".join(line(view.to_picture(ring), closed=True) for ring in area["rings"])
        found += f'<g class="lw-area lw-c{i % PALETTE}"><path d="{d}"/></g>'
    return found


def traces(survey: Survey, view: View, k: int) -> str:
    """The paths, each with its dot at a sample; one that isn't of the scene's times has none."""
    found = ""
    for i, trace in enumerate(survey.scene["traces"]):
        places = view.to_picture(rows(trace["x"], trace["y"]))
        dot = ""
        if len(places) == len(survey.scene["time"]) and np.isfinite(places[k]).all():
            x, y = (number(value) for value in places[k])
            dot = f'<circle r="{DOT}" cx="{x}" cy="{y}"/>'
        found += f'<g class="lw-trace {survey.trace_colour(i)}"><path d="{line(places)}"/>{dot}</g>'
    return found
