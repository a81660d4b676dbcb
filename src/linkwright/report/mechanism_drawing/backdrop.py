"""What doesn't move: grid, scale bar, ground symbols and fixed guides."""

from __future__ import annotations

from math import ceil, cos, degrees, pi

from linkwright.escape import markup
from linkwright.report.mechanism_drawing.joints import HEIGHT, LENGTH, Guide, Pin
from linkwright.report.mechanism_drawing.shapes import number, written
from linkwright.report.mechanism_drawing.survey import Survey
from linkwright.report.mechanism_drawing.view import View


def backdrop(survey: Survey, view: View) -> str:
    """All of it."""
    rails = (_rail(guide, survey, view) for guide in survey.guides if guide.fixed)
    grounds = (_ground(pin, survey, view) for pin in survey.pins)
    unit = survey.scene["length_unit"]
    return _grid(view) + _scale_bar(view, unit) + "".join(rails) + "".join(grounds)


def _grid(view: View) -> str:
    """Lines at multiples of a round length; those through the origin are named."""
    step, (x, y) = view.step * view.k, view.origin
    across = [x + i * step for i in range(ceil(-x / step), ceil((view.width - x) / step)) if i]
    up = [y + i * step for i in range(ceil(-y / step), ceil((view.height - y) / step)) if i]
    lines = [f"M{number(at)} 0v{number(view.height)}" for at in across]
    lines += [f"M0 {number(at)}h{number(view.width)}" for at in up]
    axes, names = "", ""
    if 0 <= x < view.width:
        axes += f"M{number(x)} 0v{number(view.height)}"
        names += f'<text x="{number(x + 5)}" y="13">y</text>'
    if 0 <= y < view.height:
        axes += f"M0 {number(y)}h{number(view.width)}"
        names += f'<text x="{number(view.width - 12)}" y="{number(y - 5)}">x</text>'
    axis = f'<path class="lw-axis" d="{axes}"/>' if axes else ""
    return f'<g class="lw-grid"><path d="{"".join(lines)}"/>{axis}{names}</g>'


def _scale_bar(view: View, unit: str) -> str:
    length, y = view.step * view.k, view.height - 14
    text = f'<text x="{number(14 + length / 2)}" y="{number(y - 6)}">{view.step:.6g} {markup(unit)}</text>'
    return f'<g class="lw-scale"><path d="M14 {number(y - 5)}v5h{number(length)}v-5"/>{text}</g>'


def _rail(guide: Guide, survey: Survey, view: View) -> str:
    """A guide in the ground: its centre line, and hatching along the block's travel, never above the block."""
    poses, side = survey.poses[guide.guide.link], guide.guide
    turn = poses.turn(0) + side.angle
    flip = cos(turn) < -1e-9 or (abs(cos(turn)) < 1e-9 and turn < 0)
    low, high = (-guide.high, -guide.low) if flip else (guide.low, guide.high)
    (at,) = view.to_picture(poses.at(0, [side.local]))
    spare = LENGTH / 2 + 8
    start, stop = low * view.k - spare, high * view.k + spare
    centre = f'<path class="lw-centre" d="M{number(min(0, start))} 0H{number(max(0, stop))}"/>'
    rotated = number(-degrees(turn + pi * flip))
    hatching = _hatch(start, stop - start, HEIGHT / 2 + 2)
    return f'<g transform="translate({written([at])}) rotate({rotated})">{centre}{hatching}</g>'


def _ground(pin: Pin, survey: Survey, view: View) -> str:
    """The symbol of a pin in the ground, or a cross at a point of it; nothing of a pin between moving links."""
    link, point = pin.places[0]
    fixed = next((one for one in survey.scene["links"] if one["name"] == link and one["fixed"]), None)
    if fixed is None:
        return ""
    at = written(view.to_picture(survey.poses[link].at(0, [fixed["points"][point]])))
    if not pin.joined:
        return f'<path class="lw-ground" transform="translate({at})" d="M-5 0H5M0-5V5"/>'
    symbol = '<path class="lw-pivot" d="M0 0-11 18H11Z"/>'
    return f'<g transform="translate({at})">{symbol}{_hatch(-16, 32, 18)}</g>'


def _hatch(x: float, length: float, y: float) -> str:
    """Hatching of fixed ground: a line of some length along x, with strokes below it."""
    strokes = "".join(f"M{number(x + 5 + 7 * i)} {number(y)}l-6 7" for i in range(int((length - 4.9) // 7) + 1))
    return f'<path class="lw-ground" d="M{number(x)} {number(y)}h{number(length)}{strokes}"/>'
