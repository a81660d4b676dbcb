"""A map over the plane as a picture: bands of colour, lines between them with their values, a scale."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator, Sequence
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import points
from linkwright.drawing.levels import band_colours
from linkwright.drawing.plane import LEFT, WIDTH, PicturePlane, framed, heading
from linkwright.drawing.png import png
from linkwright.findings import Text
from linkwright.studies.workspace.maps import chained, crossings
from linkwright.studies.workspace.mesh import halves

Array = NDArray[np.float64]

FINER = 3
"""Pixels of a picture for each place of a grid, and direction."""
INSIDE = 4.0
"""A line's value stands where it is so many places away from the edge, at least."""
APART = 30.0
"""Such values are so far apart, in the picture."""
BEYOND = 3.0
"""Lines go on so many places beyond the edge, where they are cut off."""
SHORT = 24
"""A line through fewer places has no value written to it."""
STYLE = """
.still.workspace .line { fill: none; stroke: #000; stroke-opacity: 0.55; stroke-width: 0.8; }
.still.workspace .value { font-size: 11px; fill: #000; stroke: #fff; stroke-width: 2.5px; paint-order: stroke; }
.still.workspace .locus, .still.workspace .part { fill: none; stroke: #d1242f; stroke-width: 1.8; }
.still.workspace .p-precise { stroke-dasharray: 6 3; }
"""


def map_picture(
    plane: PicturePlane,
    axes: tuple[Array, Array],
    values: Array,
    levels: Sequence[float],
    outline: str,
    over: Sequence[str],
    legend: Sequence[tuple[str, Text]],
    title: Text,
    name: Text,
) -> str:
    """A map as SVG: ``values`` (rows, columns) on ``axes`` (x and y) in the plane's unit, NaN where there are none.

    It is seen within the ``outline``; ``over`` it lie other shapes, of which the ``legend`` tells. ``name`` stands at
    the scale.
    """
    from scipy.ndimage import distance_transform_edt

    rising = _rising(values, levels)
    own = f"w{crc32(f'{title}{outline}'.encode()):x}"
    shapes = [
        f"<style>{STYLE}</style>",
        f'<clipPath id="{own}"><path clip-rule="evenodd" d="{outline}"/></clipPath>',
        f'<g clip-path="url(#{own})">{_bands(plane, axes, rising, len(levels))}',
    ]
    inside = distance_transform_edt(np.pad(np.isfinite(values), 1))[1:-1, 1:-1]
    seen = np.where(distance_transform_edt(np.isnan(values)) < BEYOND, rising, np.nan)
    numbers: dict[tuple[float, float], str] = {}
    for k, level in enumerate(levels):
        for line, at in sorted(_lines(plane, axes, seen - k), key=lambda found: -found[1].shape[1]):
            shapes.append(f'<polyline class="line" points="{points(*line)}"/>')
            where = zip(at, axes, strict=True)
            column, row = (np.rint((p - axis[0]) / (axis[1] - axis[0])).astype(int) for p, axis in where)
            best = int(inside[row, column].argmax())
            x, y = map(float, plane.to_picture(*at[:, best]))
            far = min((np.hypot(x - a, y - b) for a, b in numbers), default=np.inf)
            if at.shape[1] > SHORT and inside[row[best], column[best]] >= INSIDE and far > APART:
                place = f'x="{x:.1f}" y="{y + 4:.1f}" text-anchor="middle"'
                numbers[x, y] = f'<text class="value" {place}>{_text(level)}</text>'
    shapes += [*over, "</g>", *numbers.values()]
    scale, height = _scale(plane, levels, name)
    return framed(plane, [*shapes, scale], legend, title, height)


def beyond_edge(values: Array) -> Array:
    """Values that go on a few places beyond the edge, each as the nearest one has it."""
    from scipy.ndimage import distance_transform_edt

    unknown = np.isnan(values)
    if unknown.all():
        return values
    far, near = distance_transform_edt(unknown, return_indices=True)
    return np.where(far < BEYOND, values[tuple(near)], np.nan)


def _rising(values: Array, levels: Sequence[float]) -> Array:
    """Values so that the levels become 0, 1, 2 and so on, straight between them, and within -1 .. their number; places
    without one have that of the nearest that has."""
    from scipy.ndimage import distance_transform_edt

    unknown = np.isnan(values)
    if unknown.all() or not levels:
        return np.full(values.shape, -1.0)
    near = distance_transform_edt(unknown, return_distances=False, return_indices=True)
    first, last = (levels[1] - levels[0], levels[-1] - levels[-2]) if len(levels) > 1 else (1.0, 1.0)
    stops = [levels[0] - first, *levels, levels[-1] + last]
    return np.asarray(np.interp(values[tuple(near)], stops, np.arange(-1, len(levels) + 1)))


def _bands(plane: PicturePlane, axes: tuple[Array, Array], rising: Array, count: int) -> str:
    """Bands between levels, as an image of few colours."""
    fine = _finer(_finer(rising).T).T
    bands = np.clip(np.floor(fine) + 1, 0, count).astype(np.uint8)
    data = b64encode(png(bands[::-1], band_colours(count + 1))).decode()
    half = (axes[0][1] - axes[0][0]) / FINER / 2
    left, top = plane.to_picture(axes[0][0] - half, axes[1][-1] + half)
    right, bottom = plane.to_picture(axes[0][-1] + half, axes[1][0] - half)
    place = f'x="{left:.2f}" y="{top:.2f}" width="{right - left:.2f}" height="{bottom - top:.2f}"'
    return f'<image {place} preserveAspectRatio="none" href="data:image/png;base64,{data}"/>'


def _finer(values: Array) -> Array:
    """More rows, between those given."""
    at = np.arange((len(values) - 1) * FINER + 1) / FINER
    low = np.minimum(at.astype(int), len(values) - 2)
    share = (at - low)[:, None]
    return np.asarray((1 - share) * values[low] + share * values[low + 1])


def _lines(plane: PicturePlane, axes: tuple[Array, Array], values: Array) -> Iterator[tuple[Array, Array]]:
    """The lines on which values at a grid are zero: places (2, n) in the picture, thinned, and all on the axes."""
    import shapely

    flat = values.ravel()
    pairs, ends, _ = crossings(halves(*values.shape), flat)
    if not len(pairs):
        return
    grid = np.stack(np.meshgrid(*axes)).reshape(2, -1)
    a, b = flat[pairs[:, 0]], flat[pairs[:, 1]]
    at = grid[:, pairs[:, 0]] + a / (a - b) * (grid[:, pairs[:, 1]] - grid[:, pairs[:, 0]])
    places = np.stack(plane.to_picture(*at))
    for chain in chained(ends):
        if len(chain) > 2:
            thin = shapely.simplify(shapely.linestrings(places[:, chain].T), 0.3)
            yield shapely.get_coordinates(thin).T, at[:, chain]


def _scale(plane: PicturePlane, levels: Sequence[float], name: Text) -> tuple[str, float]:
    """The colours with the values between them, below the axes, and how much room they take."""
    made, top = heading(name, plane.bottom + 56)
    top += 6
    wide = min((WIDTH - LEFT - 20) / (len(levels) + 1), 70.0)
    for k, (red, green, blue) in enumerate(band_colours(len(levels) + 1).tolist()):
        place = f'x="{LEFT + k * wide:.1f}" y="{top:.0f}" width="{wide:.1f}" height="12"'
        made += f'<rect {place} fill="rgb({red},{green},{blue})"/>'
    for k, level in enumerate(levels, start=1):
        place = f'x="{LEFT + k * wide:.1f}" y="{top + 26:.0f}" text-anchor="middle"'
        made += f"<text {place}>{_text(level)}</text>"
    return made, top + 50 - (plane.bottom + 52)


def _text(level: float) -> str:
    return f"{level:.5g}".replace("-", "−")
