"""The plane of a workspace as a picture: axes, outlines and curves in it, the legend below."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import LETTER, named, number_text, points, ticks
from linkwright.escape import markup, printed
from linkwright.findings import Joined, Text
from linkwright.presentation.lettering import FONT, folded

Array = NDArray[np.float64]
Bounds = tuple[float, float, float, float]
"""Least x, least y, largest x, largest y."""

WIDTH, LEFT, RIGHT, TOP, BOTTOM, LINE = 560.0, 58.0, 12.0, 8.0, 36.0, 17.0
TALLEST = 700.0
MARGIN = 0.04
STYLE = f"""
.still.workspace text {{ font: 12px {FONT}; }}
.still.workspace .grid {{ fill: none; stroke: #8886; stroke-width: 0.5; }}
.still.workspace .region {{ fill-opacity: 0.28; stroke: none; fill-rule: evenodd; }}
.still.workspace .path {{ fill: none; stroke-width: 1.6; }}
.still.workspace .m0 {{ fill: #1f6fb5; stroke: #1f6fb5; }}
.still.workspace .m1 {{ fill: #c2571a; stroke: #c2571a; }}
.still.workspace .m2 {{ fill: #2f8a4c; stroke: #2f8a4c; }}
.still.workspace .m3 {{ fill: #8a4fb5; stroke: #8a4fb5; }}
.still.workspace .region {{ stroke: none; }}
.still.workspace .path {{ fill: none; }}
.still.workspace .kind {{ fill: none; stroke: currentColor; stroke-width: 1; }}
.still.workspace .k-modes {{ stroke-dasharray: 5 3; stroke-width: 1.6; }}
.still.workspace .k-pins {{ stroke-dasharray: 1 3; stroke-width: 2; }}
.still.workspace .k-limit {{ stroke: #888; stroke-width: 2; }}
.still.workspace .over {{ fill: none; stroke: #8a4fb5; stroke-width: 2; }}
.still.workspace .blocked, .still.workspace .misses {{ stroke: #c8102e; }}
.still.workspace .blocked {{ stroke-width: 3.5; }}
.still.workspace .fits {{ stroke: #2f8a4c; }}
"""
"""How a picture looks; it stands in each picture, since one is written as a file of its own."""


class PicturePlane:
    """Places in a picture of a ``box``; one scale for both axes."""

    def __init__(self, box: Bounds, unit: str) -> None:
        low, high = np.array(box[:2]), np.array(box[2:])
        wide = float((high - low).max()) or 1.0
        low, high = low - MARGIN * wide, high + MARGIN * wide
        span = np.maximum(high - low, 0.2 * wide)
        self.scale = min((WIDTH - LEFT - RIGHT) / span[0], (TALLEST - TOP - BOTTOM) / span[1])
        self.low, self.unit = low, unit
        self.right, self.bottom = LEFT + span[0] * self.scale, TOP + span[1] * self.scale
        self.high = low + span

    @classmethod
    def of(cls, box: Bounds, unit: str, size: float) -> PicturePlane:
        """Of a box in m, in a ``unit`` of ``size`` m."""
        low_x, low_y, high_x, high_y = (edge / size for edge in box)
        return cls((low_x, low_y, high_x, high_y), unit)

    def to_picture(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Where places lie in the picture."""
        return LEFT + (x - self.low[0]) * self.scale, self.bottom - (y - self.low[1]) * self.scale

    @property
    def stated(self) -> str:
        """What a page's script reads: the picture's coordinates of the origin, how long a unit is, the unit."""
        x, y = (float(place) for place in self.to_picture(np.array(0.0), np.array(0.0)))
        return f"{x:.3f} {y:.3f} {self.scale:.6g} {markup(printed(self.unit))}"

    def grid(self) -> str:
        """Lines and numbers of the axes."""
        lines, numbers = [], []
        for value in ticks(self.low[0], self.high[0], 6):
            x = float(self.to_picture(np.array(value), np.array(0.0))[0])
            lines.append(f"M{x:.1f} {TOP:.0f}V{self.bottom:.1f}")
            numbers.append(
                f'<text x="{x:.1f}" y="{self.bottom + 14:.1f}" text-anchor="middle">{number_text(value)}</text>'
            )
        for value in ticks(self.low[1], self.high[1], 6):
            y = float(self.to_picture(np.array(0.0), np.array(value))[1])
            lines.append(f"M{LEFT:.0f} {y:.1f}H{self.right:.1f}")
            numbers.append(f'<text x="{LEFT - 6:.0f}" y="{y + 4:.1f}" text-anchor="end">{number_text(value)}</text>')
        label = named(Joined("xy"), self.unit)
        middle = (LEFT + self.right) / 2
        numbers.append(f'<text x="{middle:.0f}" y="{self.bottom + 30:.1f}" text-anchor="middle">{markup(label)}</text>')
        return f'<path class="grid" d="{"".join(lines)}"/>{"".join(numbers)}'


def framed_box(boxes: Iterable[Bounds]) -> Bounds:
    """The box around all boxes, so that pictures have the same axes."""
    x0, y0, x1, y1 = np.array(list(boxes)).T
    return float(x0.min()), float(y0.min()), float(x1.max()), float(y1.max())


def framed(
    plane: PicturePlane, shapes: Sequence[str], legend: Sequence[tuple[str, Text]], title: Text, room: float = 0.0
) -> str:
    """The whole: axes, shapes, and the legend ``room`` below them."""
    told, y = "", plane.bottom + 52 + room
    for look, text in legend:
        lines = [*folded(str(text), int((WIDTH - LEFT - 40) / LETTER))]
        box = "v8h-24z" if look.startswith("region") else ""
        told += f'<path class="{look}" d="M{LEFT - 30:.0f} {y - 8 + 4 * (not box):.0f}h24{box}"/>'
        for line in lines:
            told += f'<text x="{LEFT:.0f}" y="{y:.0f}">{markup(line)}</text>'
            y += LINE
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="lw still workspace" viewBox="0 0 {WIDTH:.0f} {y:.0f}" '
        f'fill="currentColor" role="img" aria-label="{markup(title)}"><style>{STYLE}</style>'
        f"{plane.grid()}{''.join(shapes)}<g>{told}</g></svg>"
    )


def heading(text: Text, top: float) -> tuple[str, float]:
    """A text in lines over a scale, its first line at ``top``, and where its last line is."""
    rows = [*folded(str(text), int((WIDTH - LEFT) / LETTER))]
    lines = (f'<text x="{LEFT:.0f}" y="{top + LINE * i:.0f}">{markup(row)}</text>' for i, row in enumerate(rows))
    return f"<g>{''.join(lines)}</g>", top + LINE * (len(rows) - 1)


def outline(shape: Any, plane: PicturePlane, size: float) -> str:
    """All rings of a shape, thinned to what can be seen."""
    import shapely

    drawn = shapely.get_parts(shape.simplify(0.1 / plane.scale * size))
    filled = [part for part in drawn if part.geom_type == "Polygon" and not part.is_empty]
    rings = [ring for polygon in filled for ring in (polygon.exterior, *polygon.interiors)]
    return "".join(f"M{points(*plane.to_picture(*(np.array(ring.coords).T / size)))}Z" for ring in rings)
