"""The trajectories of a point as a picture: thin translucent lines, coloured by the value of the drive that is held, in
the outline of the region; the scale of colours below."""

from __future__ import annotations

from collections.abc import Sequence
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.drawing.charts import ticks
from linkwright.drawing.colour_scale import colours
from linkwright.drawing.plane import LEFT, WIDTH, PicturePlane, framed, heading
from linkwright.escape import markup
from linkwright.findings import Text

Array = NDArray[np.float64]

FINE, COARSEST, LARGEST = 0.05, 0.4, 250_000
"""Lines are thinned by so much of a picture's pixel; by up to so much where they take more letters than that."""
PARTS = 10
"""Of a pixel, in which places are written."""
STOPS = 24
"""Colours of the scale between which it is even."""
FEW, WIDE, DENSE = 72, 1.2, 0.8
"""Up to so many trajectories have such a width and opacity; of more, each is fainter ..."""
NARROWEST, FAINTEST = 0.5, 0.3
"""... down to these."""
BAR = 12.0
"""The height of the scale."""
DEGREES = (5, 10, 15, 30, 45, 60, 90)
STYLE = """
.still.workspace .ground { fill: #8888; fill-opacity: 0.14; fill-rule: evenodd; stroke: none; }
.still.workspace .trajectories path { fill: none; stroke-linejoin: round; stroke-linecap: round; }
.still.workspace .trajectories path:hover { stroke-width: 26; stroke-opacity: 1; }
.still.workspace .edge { fill: none; stroke: currentColor; stroke-width: 1.1; stroke-opacity: 0.75; }
"""


@dataclass(frozen=True)
class Scale:
    """The values of the held drive from ``low`` to ``high`` in ``unit``, of a whole ``turn`` or not; ``name`` stands at
    the scale."""

    low: float
    high: float
    unit: str
    turn: bool
    name: Text

    def colours(self, values: Array) -> list[str]:
        """Of some values."""
        span = self.high - self.low
        return colours((values - self.low) / span if span > 0 else np.zeros_like(values), self.turn)

    def marks(self) -> list[float]:
        """Round values on it; angles in degrees at parts of a turn."""
        if self.unit != "deg" or self.high - self.low < 4 * DEGREES[0]:
            return ticks(self.low, self.high, 6) if self.high > self.low else [self.low]
        step = next((s for s in DEGREES if (self.high - self.low) / s <= 8), DEGREES[-1])
        first = int(np.ceil(self.low / step - 1e-9))
        return [k * float(step) for k in range(first, int(np.floor(self.high / step + 1e-9)) + 1)]


@dataclass(frozen=True)
class ColouredLine:
    """A trajectory: the held drive's ``value``, its lines (2, n) in the plane's unit, and what is said of it."""

    value: float
    lines: Sequence[Array]
    text: str


def trajectory_picture(
    plane: PicturePlane,
    drawn: Sequence[ColouredLine],
    scale: Scale,
    outline: str,
    over: Sequence[str],
    legend: Sequence[tuple[str, Text]],
    title: Text,
) -> str:
    """The picture as SVG, with other shapes ``over`` it of which the ``legend`` tells."""
    share = min(1.0, FEW / max(len(drawn), 1))
    wide, dense = max(NARROWEST, WIDE * share**0.5), max(FAINTEST, DENSE * share**0.5)
    shapes = [
        f"<style>{STYLE}</style>",
        f'<path class="ground" d="{outline}"/>',
        f'<g class="trajectories" transform="scale({1 / PARTS})" '
        f'stroke-width="{PARTS * wide:.1f}" stroke-opacity="{dense:.2f}">'
        f"{_group(plane, drawn, scale)}</g>",
        f'<path class="edge" d="{outline}"/>',
        *over,
    ]
    bar, height = _bar(plane, scale, f"{title}{outline}")
    return framed(plane, [*shapes, bar], legend, title, height)


def _group(plane: PicturePlane, drawn: Sequence[ColouredLine], scale: Scale) -> str:
    """The trajectories as paths, each with its text: thinned until they are small enough, then every other one left
    out."""
    fine, step = FINE, 1
    placed = [[np.stack(plane.to_picture(*line)) for line in one.lines] for one in drawn]
    while True:
        made = _paths(drawn[::step], placed[::step], scale, fine)
        if len(made) <= LARGEST or step > len(drawn):
            return made
        fine, step = (2 * fine, step) if fine < COARSEST else (fine, 2 * step)


def _paths(drawn: Sequence[ColouredLine], placed: Sequence[Sequence[Array]], scale: Scale, fine: float) -> str:
    hues = scale.colours(np.array([one.value for one in drawn]))
    return "".join(
        f'<path stroke="{hue}" d="{_path(lines, fine)}"><title>{markup(one.text)}</title></path>'
        for one, lines, hue in zip(drawn, placed, hues, strict=True)
        if lines
    )


def _path(lines: Sequence[Array], fine: float) -> str:
    """Lines (2, n) in the picture as one path, thinned: each place by its steps from the last one."""
    import shapely

    made = ""
    for line in lines:
        thin = shapely.get_coordinates(shapely.simplify(shapely.linestrings(line.T), fine))
        places = np.rint(thin * PARTS).astype(int)
        (x, y), steps = places[0].tolist(), np.diff(places, axis=0).tolist()
        made += f"M{x} {y}l" + " ".join(f"{dx} {dy}" for dx, dy in steps).replace(" -", "-")
    return made


def _bar(plane: PicturePlane, scale: Scale, own: str) -> tuple[str, float]:
    """The scale below the axes, and how much room it takes."""
    made, top = heading(scale.name, plane.bottom + 56)
    top += 8
    left, wide = LEFT, min(WIDTH - LEFT - 30, 420.0)
    name = f"s{crc32(own.encode()):x}"
    shares = np.linspace(0, 1, STOPS + 1)
    stops = "".join(
        f'<stop offset="{100 * share:.1f}%" stop-color="{hue}"/>'
        for share, hue in zip(shares.tolist(), colours(shares, scale.turn), strict=True)
    )
    made += f'<linearGradient id="{name}">{stops}</linearGradient>'
    made += f'<rect x="{left:.0f}" y="{top:.0f}" width="{wide:.0f}" height="{BAR:.0f}" rx="2" fill="url(#{name})"/>'
    span = scale.high - scale.low or 1.0
    for mark in scale.marks():
        x = left + (mark - scale.low) / span * wide
        made += f'<path class="grid" d="M{x:.1f} {top + BAR:.0f}v4"/>'
        made += f'<text x="{x:.1f}" y="{top + BAR + 17:.0f}" text-anchor="middle">{_text(mark)}</text>'
    return made, top + BAR + 41 - (plane.bottom + 52)


def _text(value: float) -> str:
    return f"{value:.6g}".replace("-", "−")
