"""A cam as a picture: profile, pitch curve, base circle and follower; turning, where the picture is clicked."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import DiscJets
from linkwright.data_classes import dataclass
from linkwright.drawing.charts import points
from linkwright.drawing.plane import LEFT, TOP, PicturePlane
from linkwright.escape import markup
from linkwright.expressions import units as u
from linkwright.findings import Said, Text
from linkwright.presentation.lettering import FONT
from linkwright.studies.cam.outcome import CamOutcome

Array = NDArray[np.float64]

FRAMES = 120
SECONDS = 6
STYLE = f"""
.still.cam text {{ font: 12px {FONT}; }}
.still.cam .grid {{ fill: none; stroke: #8886; stroke-width: 0.5; }}
.still.cam .profile {{ fill: #1f6fb5; fill-opacity: 0.18; stroke: #1f6fb5; stroke-width: 2; }}
.still.cam .second {{ fill: #7a6a2f; stroke: #7a6a2f; fill-opacity: 0.18; stroke-width: 2; }}
.still.cam .pitch {{ fill: none; stroke: #2f8a4c; stroke-width: 1.2; stroke-dasharray: 5 3; }}
.still.cam .base {{ fill: none; stroke: #888; stroke-width: 1; stroke-dasharray: 2 3; }}
.still.cam .follower {{ fill: none; stroke: #c2571a; stroke-width: 2; }}
.still.cam .flank {{ fill: none; stroke: #1f6fb5; stroke-width: 2; }}
.still.cam .worst {{ fill: #c8102e; stroke: none; }}
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
    first, rides = outcome.first, contacts(outcome)
    follower = first.disc.follower
    discs = [(plate, flipped(plate.look.offset(-plate.disc.follower.radius), plate.second)) for plate in outcome.plates]
    outer = [first.look.offset(follower.radius)] if first.outer else []
    curves = [*outer, *(curve for plate, curve in discs if plate.has_profile)]
    curves += [flipped(p.look.offset(0.0), p.second) for p, _ in discs]
    far = max(float(np.hypot(*curve).max()) for curve in curves)
    pivot = (getattr(follower, "distance", 0.0), 0.0)
    reach = [(ride.centre + sign * ride.roller, sign) for ride in rides for sign in (1, -1)]
    right = max(far, pivot[0] if follower.turns else 0.0, *(float(row[0].max()) for row, sign in reach if sign > 0))
    top = max(far, *(float(row[1].max()) for row, sign in reach if sign > 0))
    below = max(far, *(-float(row[1].min()) for row, sign in reach if sign < 0)) if len(rides) > 1 else far
    plane = PicturePlane(
        (-far / size, -below / size, right / size, top / size), outcome.compiled.quantities.unit_of(u.LENGTH)[0]
    )

    def path(curve: Array) -> str:
        return points(*plane.to_picture(*(curve / size)))

    ox, oy = (float(v) for v in plane.to_picture(np.array(0.0), np.array(0.0)))
    scale = plane.scale / size
    cam = [f'<circle class="base" cx="{ox:.2f}" cy="{oy:.2f}" r="{follower.base * scale:.2f}"/>']
    for plate, curve in reversed(discs):
        if plate.has_profile:
            kind = "profile second" if plate.second else "profile"
            cam.append(f'<polygon class="{kind}" points="{path(curve)}"/>')
        if plate.disc.follower.radius:
            cam.append(f'<polygon class="pitch" points="{path(flipped(plate.look.offset(0.0), plate.second))}"/>')
    cam += [f'<polygon class="flank" points="{path(curve)}"/>' for curve in outer]
    worst = next((f for f in outcome.figures if f.name == "profile_curvature_max"), None)
    if worst is not None:
        (x,), (y,) = plane.to_picture(*(first.disc.look(np.array([worst.theta])).offset(-follower.radius) / size))
        cam.append(f'<circle class="worst" cx="{x:.2f}" cy="{y:.2f}" r="3"/>')
    turned = _spin(f"{-first.disc.sense * 360} {ox:.2f} {oy:.2f}", f"0 {ox:.2f} {oy:.2f}") if turning else ""
    rider, moved = _follower(outcome, plane, size, rides, pivot)
    kinds = ["base", *(["profile"] if outcome.has_profile else []), *(["flank"] if outer else [])]
    kinds += ["second"] if outcome.second is not None and outcome.second.has_profile else []
    kinds += [*(["pitch"] if follower.radius else []), "follower", *(["worst"] if worst else [])]
    legend: list[tuple[str, Text]] = [(kind, Said(f"cam.kind.{kind}")) for kind in kinds]
    body = f'<g id="camPicture"><g>{"".join(cam)}{turned}</g><g>{rider}{moved if turning else ""}</g></g>'
    return picture_svg(plane, body, legend, Said("cam.picture", name=outcome.name))


def flipped(points: Array, second: bool) -> Array:
    """Points of a second disc (2, n) in the axes of the first."""
    return points * np.array([[1.0], [-1.0]]) if second else points


@dataclass(frozen=True)
class ContactPicture:
    """A contact of the follower in the fixed frame, in the axes of the first disc: the ``centre`` of its roller, its
    edge or where its face touches (2, n), the ``normal`` there at the cam angle 0, the ``roller``'s radius; m."""

    centre: Array
    normal: tuple[float, float]
    roller: float


def contacts(outcome: CamOutcome) -> list[ContactPicture]:
    """Those of the follower: on the first disc, on the second, or opposite in a yoke as wide as the disc needs."""
    made = [_contact_picture(plate.look, plate.disc.follower.radius, plate.second) for plate in outcome.plates]
    span = {} if outcome.closing is None else outcome.closing.figures
    if "yoke_span_max" in span:
        (ride,) = made
        across = np.array([[-2 * ride.centre[0, 0]], [-span["yoke_span_max"].value]])
        other = ride.centre + (across if not outcome.disc.follower.faced else across * np.array([[0.0], [1.0]]))
        made.append(ContactPicture(other, (-ride.normal[0], -ride.normal[1]), ride.roller))
    return made


def _contact_picture(look: DiscJets, roller: float, second: bool) -> ContactPicture:
    centre, normal = (
        flipped(np.array([np.broadcast_to(c.d[0], look.theta.shape) for c in of]), second)
        for of in (look.centre, look.along)
    )
    return ContactPicture(centre, (float(normal[0, 0]), float(normal[1, 0])), roller)


def _follower(
    outcome: CamOutcome, plane: PicturePlane, size: float, rides: Sequence[ContactPicture], pivot: tuple[float, float]
) -> tuple[str, str]:
    """The follower at the cam angle 0, and how it moves."""
    look, follower, scale = outcome.first.look, outcome.disc.follower, plane.scale / size
    px, py = (float(v) for v in plane.to_picture(np.array(pivot[0] / size), np.array(pivot[1] / size)))
    lift = np.broadcast_to(look.lift.d[0], look.theta.shape)
    some = np.linspace(0, lift.size - 1, FRAMES + 1).round().astype(int)
    if follower.turns:
        values = ";".join(f"{math.degrees(v):.3f} {px:.2f} {py:.2f}" for v in (lift[some] - lift[0]))
        moved = _animation("rotate", values)
    else:
        values = ";".join(f"0 {-scale * v:.3f}" for v in (lift[some] - lift[0]))
        moved = _animation("translate", values)
    shapes, circles = [], []
    places = [tuple(float(v) for v in plane.to_picture(*(ride.centre[:, 0] / size))) for ride in rides]
    for ride, (cx, cy) in zip(rides, places, strict=True):
        if follower.faced and follower.turns:
            normal = np.array(ride.normal)
            foot = np.array(pivot) + (ride.centre[:, 0] - pivot) @ normal * normal
            along = ride.centre[:, 0] - foot
            end = ride.centre[:, 0] + 0.5 * follower.base * along / np.hypot(*along)
            (fx, fy), (ex, ey) = (tuple(float(v) for v in plane.to_picture(*(place / size))) for place in (foot, end))
            shapes.append(f"M{px:.2f} {py:.2f}L{fx:.2f} {fy:.2f}L{ex:.2f} {ey:.2f}")
        elif follower.faced:
            tx, ty = -ride.normal[1], ride.normal[0]
            reach = 0.8 * follower.base * scale
            shapes.append(f"M{cx - reach * tx:.2f} {cy + reach * ty:.2f}L{cx + reach * tx:.2f} {cy - reach * ty:.2f}")
        elif follower.turns:
            shapes.append(f"M{px:.2f} {py:.2f}L{cx:.2f} {cy:.2f}")
        if ride.roller:
            circles.append((cx, cy, ride.roller * scale))
    if not follower.turns:
        if not follower.faced:
            shapes.append(f"M{places[0][0]:.2f} {places[0][1]:.2f}V{TOP:.2f}")
        shapes += [_contact_line(places)] if len(places) > 1 else []
    else:
        circles.append((px, py, 4.0))
    body = f'<path class="follower" d="{"".join(shapes)}"/>'
    body += "".join(f'<circle class="follower" cx="{x:.2f}" cy="{y:.2f}" r="{r:.2f}"/>' for x, y, r in circles)
    return body, moved


def _contact_line(places: Sequence[tuple[float, ...]]) -> str:
    """What a sliding follower's two contacts have between them: a line."""
    (ax, ay), (bx, by) = places
    return f"M{ax:.2f} {ay:.2f}L{bx:.2f} {by:.2f}"


def _spin(to: str, start: str) -> str:
    return _animation("rotate", f"{start};{to}")


def _animation(kind: str, values: str) -> str:
    return (
        f'<animateTransform attributeName="transform" type="{kind}" values="{values}" dur="{SECONDS}s" '
        f'begin="camPicture.click" repeatCount="2"/>'
    )


def picture_svg(plane: PicturePlane, shapes: str, legend: Sequence[tuple[str, Text]], title: Text) -> str:
    """The whole picture with its legend below."""
    top = plane.bottom + 44.0
    rows = "".join(
        f'<rect class="{kind}" x="{LEFT:.0f}" y="{top + 17 * i:.0f}" width="18" height="8"/>'
        f'<text x="{LEFT + 26:.0f}" y="{top + 17 * i + 8:.0f}">{markup(text)}</text>'
        for i, (kind, text) in enumerate(legend)
    )
    wide, high = plane.right + 12, top + 17 * len(legend)
    return (
        f'<svg class="lw still cam" viewBox="0 0 {wide:.0f} {high:.0f}" data-plane="{plane.stated}" role="img" '
        f'aria-label="{markup(title)}">'
        f"<style>{STYLE}</style>{plane.grid()}{shapes}{rows}</svg>"
    )
