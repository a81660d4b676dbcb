"""A cam as a picture: profile, pitch curve, base circle and follower; turning, where the picture is clicked."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.nc.swept import ROUGH
from linkwright.cam.nc.track import chains, pieces
from linkwright.model import units as u
from linkwright.report.charts import points, thinned
from linkwright.report.plane import LEFT, TOP, Plane
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.words import say

Array = NDArray[np.float64]

FRAMES = 120
SECONDS = 6
MOST = 1500
"""Points of a line of the cutter's path."""
STYLE = """
.still.cam text { font: 12px system-ui, Arial, "DejaVu Sans", "Liberation Sans", "Noto Sans", sans-serif; }
.still.cam .grid { fill: none; stroke: #8886; stroke-width: 0.5; }
.still.cam .profile { fill: #1f6fb5; fill-opacity: 0.18; stroke: #1f6fb5; stroke-width: 2; }
.still.cam .pitch { fill: none; stroke: #2f8a4c; stroke-width: 1.2; stroke-dasharray: 5 3; }
.still.cam .base { fill: none; stroke: #888; stroke-width: 1; stroke-dasharray: 2 3; }
.still.cam .follower { fill: none; stroke: #c2571a; stroke-width: 2; }
.still.cam .flank { fill: none; stroke: #1f6fb5; stroke-width: 2; }
.still.cam .tool { fill: none; stroke: #8a4fb5; stroke-width: 1.2; }
.still.cam .worst { fill: #c8102e; stroke: none; }
"""


def still(outcome: CamOutcome) -> str:
    """The picture as a file of its own."""
    drawing = picture(outcome, turning=False)
    box = drawing.split('viewBox="0 0 ', 1)[1].split('"', 1)[0]
    wide, high = map(float, box.split())
    front = f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide:.0f}" height="{high:.0f}" color="#1d2733" '
    return (
        drawing.replace("<svg ", front, 1).replace(
            "<style>", '<rect width="100%" height="100%" fill="#fff"/><style>', 1
        )
        + "\n"
    )


def picture(outcome: CamOutcome, turning: bool = True) -> str:
    """The cam in the disc's axes (x to a swinging follower's pivot, y the way of a sliding one), at the cam angle 0."""
    size = outcome.compiled.quantities.unit_of(u.LENGTH)[1]
    disc, look = outcome.disc, outcome.look
    follower, roller = disc.follower, disc.follower.radius
    curves = [look.offset(0.0), look.offset(-roller)] if outcome.made else [look.offset(0.0)]
    far = max(float(np.hypot(*curve).max()) for curve in curves)
    centre = np.array([np.broadcast_to(c.d[0], look.theta.shape) for c in look.centre])
    pivot = (getattr(follower, "distance", 0.0), 0.0)
    right = max(far, pivot[0] if follower.turns else 0.0, float(centre[0].max()) + roller)
    top = max(far, float(centre[1].max()) + roller)
    plane = Plane(
        (-far / size, -far / size, right / size, top / size), outcome.compiled.quantities.unit_of(u.LENGTH)[0]
    )

    def path(curve: Array) -> str:
        return points(*plane.at(*(curve / size)))

    ox, oy = (float(v) for v in plane.at(np.array(0.0), np.array(0.0)))
    scale = plane.scale / size
    cam = [f'<circle class="base" cx="{ox:.2f}" cy="{oy:.2f}" r="{follower.base * scale:.2f}"/>']
    if outcome.made:
        cam.append(f'<polygon class="profile" points="{path(curves[1])}"/>')
    if roller:
        cam.append(f'<polygon class="pitch" points="{path(curves[0])}"/>')
    worst = next((f for f in outcome.figures if f.name == "profile_curvature_max"), None)
    if worst is not None:
        (x,), (y,) = plane.at(*(disc.look(np.array([worst.theta])).offset(-roller) / size))
        cam.append(f'<circle class="worst" cx="{x:.2f}" cy="{y:.2f}" r="3"/>')
    turned = _spin(f"{-disc.sense * 360} {ox:.2f} {oy:.2f}", f"0 {ox:.2f} {oy:.2f}") if turning else ""
    rider, moved = _follower(outcome, plane, size, centre, pivot)
    legend = [("base", say("cam.kind.base"))] + ([("profile", say("cam.kind.profile"))] if outcome.made else [])
    legend += [("pitch", say("cam.kind.pitch"))] if roller else []
    legend += [("follower", say("cam.kind.follower"))] + ([("worst", say("cam.kind.worst"))] if worst else [])
    body = f'<g id="camPicture"><g>{"".join(cam)}{turned}</g><g>{rider}{moved if turning else ""}</g></g>'
    return drawn(plane, body, legend, say("cam.picture.turning" if turning else "cam.picture", name=outcome.name))


def _follower(
    outcome: CamOutcome, plane: Plane, size: float, centre: Array, pivot: tuple[float, float]
) -> tuple[str, str]:
    """The follower at the cam angle 0, and how it moves."""
    disc, look = outcome.disc, outcome.look
    follower, scale = disc.follower, plane.scale / size
    px, py = (float(v) for v in plane.at(np.array(pivot[0] / size), np.array(pivot[1] / size)))
    cx, cy = (float(v) for v in plane.at(centre[0, 0] / size, centre[1, 0] / size))
    lift = np.broadcast_to(look.lift.d[0], look.theta.shape)
    some = np.linspace(0, lift.size - 1, FRAMES + 1).round().astype(int)
    if follower.turns:
        values = ";".join(f"{math.degrees(v):.3f} {px:.2f} {py:.2f}" for v in (lift[some] - lift[0]))
        moved = _moved("rotate", values)
    else:
        values = ";".join(f"0 {-scale * v:.3f}" for v in (lift[some] - lift[0]))
        moved = _moved("translate", values)
    shapes = []
    if follower.faced:
        normal = [float(np.broadcast_to(n.d[0], look.theta.shape)[0]) for n in look.along]
        tx, ty = -normal[1], normal[0]
        reach = 0.8 * follower.base * scale
        shapes.append(f"M{cx - reach * tx:.2f} {cy + reach * ty:.2f}L{cx + reach * tx:.2f} {cy - reach * ty:.2f}")
    elif follower.turns:
        shapes.append(f"M{px:.2f} {py:.2f}L{cx:.2f} {cy:.2f}")
    else:
        shapes.append(f"M{cx:.2f} {cy:.2f}V{TOP:.2f}")
    body = f'<path class="follower" d="{"".join(shapes)}"/>'
    if follower.radius:
        body += f'<circle class="follower" cx="{cx:.2f}" cy="{cy:.2f}" r="{follower.radius * scale:.2f}"/>'
    if follower.turns:
        body += f'<circle class="follower" cx="{px:.2f}" cy="{py:.2f}" r="4"/>'
    return body, moved


def _spin(to: str, start: str) -> str:
    return _moved("rotate", f"{start};{to}")


def _moved(kind: str, values: str) -> str:
    return (
        f'<animateTransform attributeName="transform" type="{kind}" values="{values}" dur="{SECONDS}s" '
        f'begin="camPicture.click" repeatCount="2"/>'
    )


def tool_path(outcome: CamOutcome) -> str:
    """The path of the cutter's centre at full depth, read back from the first file, around the profile, or between the
    flanks of a groove."""
    size = outcome.compiled.quantities.unit_of(u.LENGTH)[1]
    one = outcome.milled[0]
    deepest = min(move.end[2] for move in one.proof.moves)
    cutting = [m for m in one.proof.moves if m.feed is not None and max(m.start[2], m.end[2]) <= deepest + 1e-6]
    lines = [line[thinned(len(line), MOST)].T / 1e3 for line in chains(pieces(cutting, one.job.cutter), ROUGH)]
    kinds = {"profile": -1} | ({"flank": 1} if one.job.groove else {})
    curves = {kind: outcome.look.offset(side * outcome.disc.follower.radius) for kind, side in kinds.items()}
    every = np.concatenate([*lines, *curves.values()], axis=1)
    low, high = every.min(axis=1) / size, every.max(axis=1) / size
    plane = Plane((low[0], low[1], high[0], high[1]), outcome.compiled.quantities.unit_of(u.LENGTH)[0])
    shapes = "".join(
        f'<polygon class="{kind}" points="{points(*plane.at(*(curve / size)))}"/>' for kind, curve in curves.items()
    )
    shapes += "".join(f'<polyline class="tool" points="{points(*plane.at(*(line / size)))}"/>' for line in lines)
    legend = [(kind, say(f"cam.kind.{kind}")) for kind in (*curves, "tool")]
    return drawn(plane, shapes, legend, say("cam.chart.tool"))


def drawn(plane: Plane, shapes: str, legend: Sequence[tuple[str, str]], title: str) -> str:
    """The whole picture with its legend below."""
    top = plane.bottom + 44.0
    rows = "".join(
        f'<rect class="{kind}" x="{LEFT:.0f}" y="{top + 17 * i:.0f}" width="18" height="8"/>'
        f'<text x="{LEFT + 26:.0f}" y="{top + 17 * i + 8:.0f}">{escape(text)}</text>'
        for i, (kind, text) in enumerate(legend)
    )
    wide, high = plane.right + 12, top + 17 * len(legend)
    return (
        f'<svg class="lw still cam" viewBox="0 0 {wide:.0f} {high:.0f}" role="img" aria-label="{escape(title)}">'
        f"<style>{STYLE}</style>{plane.grid()}{shapes}{rows}</svg>"
    )
