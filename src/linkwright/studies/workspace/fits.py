"""Whether a required circle or rectangle fits into a region, and the largest that does.

The largest rectangle of a given shape and angle: turned and stretched so that it becomes an upright square, the side
of the largest one around a centre grows by no more than twice the centre's shift along an axis. So a cell of centres
whose middle isn't good enough can be left out as a whole, and what is left bounds the answer from above (branch and
bound, as polylabel does with circles). Containment is that of the polygon, exact.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

PRECISION = 1e-4
"""Of the region's extent, to which sizes are proven."""
HALVINGS = 50
MOST = 200_000
"""Cells looked at, at the most."""


@dataclass(frozen=True)
class LargestCircle:
    """The largest circle (m); no other has a radius above ``at_most``."""

    centre: tuple[float, float]
    radius: float
    at_most: float


@dataclass(frozen=True)
class Rectangle:
    """The largest rectangle (m) of its shape, its width at ``angle`` (rad) to the x axis; no other of that shape and
    angle is wider than ``at_most``."""

    centre: tuple[float, float]
    width: float
    height: float
    angle: float
    at_most: float


@dataclass(frozen=True)
class FigureMargin:
    """Whether a required figure fits. ``margin`` (m) is the least distance from it to what can't be reached; where it
    doesn't fit, less zero: how far its farthest place lies off the region (to 1e-4 of its size). ``scale`` is the
    largest factor by which it fits when it grows or shrinks about its centre, ``outside`` the share of its area off the
    region. ``centre`` is where it was put."""

    fits: bool
    centre: tuple[float, float]
    margin: float
    scale: float
    outside: float


def largest_circle(shape: Any, precision: float = PRECISION) -> LargestCircle | None:
    """In a region (Shapely polygons, m), to a share ``precision`` of its extent; ``None`` where it is empty."""
    import shapely

    if shape.is_empty or not shape.area:
        return None
    close = precision * _extent(shape)
    spoke = shapely.get_coordinates(shapely.maximum_inscribed_circle(shape, tolerance=close))
    radius = float(shapely.distance(shape.boundary, shapely.Point(spoke[0])))
    return LargestCircle((float(spoke[0, 0]), float(spoke[0, 1])), radius, radius + close)


def largest_rectangle(shape: Any, aspect: float, angle: float, precision: float = PRECISION) -> Rectangle | None:
    """Of width over height ``aspect``, its width at ``angle`` (rad) to the x axis, in a region (Shapely polygons, m);
    to a share ``precision`` of its extent; ``None`` where the region is empty."""
    import shapely

    if shape.is_empty or not shape.area:
        return None
    c, s = np.cos(angle), np.sin(angle)
    turned = shapely.transform(shape, lambda xy: (xy @ np.array([[c, -s], [s, c]])) * [1.0, aspect])
    shapely.prepare(turned)
    close = precision * _extent(shape) / 2
    start = np.array(shapely.get_coordinates(shapely.maximum_inscribed_circle(turned, tolerance=close))[0])
    centre, half, bound = _largest_square(turned, start, close)
    x, y = centre[0], centre[1] / aspect
    place = (float(c * x - s * y), float(s * x + c * y))
    return Rectangle(place, 2 * half, 2 * half / aspect, angle, 2 * bound)


def _extent(shape: Any) -> float:
    x0, y0, x1, y1 = shape.bounds
    return float(max(x1 - x0, y1 - y0))


def _largest_square(shape: Any, start: Array, close: float) -> tuple[Array, float, float]:
    """Centre and half side of the largest upright square, and what no half side exceeds."""

    def grown(at: Array, low: float, high: float) -> float:
        """The largest half side around a centre, between one that fits and one that doesn't."""
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if _fit(shape, at[None], np.array([middle]))[0] else (low, middle)
        return low

    bounds = np.array(shape.bounds).reshape(2, 2)
    most = float((bounds[1] - bounds[0]).min()) / 2 * (1 + 1e-9)
    best, centre = grown(start, 0.0, most), start
    cell = float((bounds[1] - bounds[0]).max()) / 16
    axes = [np.arange(low + cell / 2, high + cell / 2, cell) for low, high in bounds.T]
    at = np.stack(np.meshgrid(*axes, indexing="ij")).reshape(2, -1).T
    half, looked = cell / 2, 0
    while True:
        looked += len(at)
        for one in at[_fit(shape, at, np.full(len(at), best + close / 8))]:
            if _fit(shape, one[None], np.array([best + close / 8]))[0]:
                best, centre = grown(one, best, most), one
        need = best + close - half
        at = at[_fit(shape, at, np.full(len(at), need)) if need > 0 else _near(shape, at, half)]
        if not len(at):
            return centre, best, min(best + close, most)
        if looked > MOST:
            return centre, best, min(best + half, most)
        half /= 2
        corners = half * np.array([[-1, -1], [-1, 1], [1, -1], [1, 1]])
        at = (at[:, None] + corners).reshape(-1, 2)


def _fit(shape: Any, at: Array, half: Array) -> NDArray[np.bool_]:
    """Whether upright squares around centres (n, 2) lie in a region."""
    import shapely

    (x, y), h = at.T, half
    return np.asarray(shapely.covers(shape, shapely.box(x - h, y - h, x + h, y + h)))


def _near(shape: Any, at: Array, half: float) -> NDArray[np.bool_]:
    """Whether cells around centres (n, 2) meet a region."""
    import shapely

    x, y = at.T
    return np.asarray(shapely.intersects(shape, shapely.box(x - half, y - half, x + half, y + half)))


def circle_fits(shape: Any, radius: float, centre: tuple[float, float] | None = None) -> FigureMargin | None:
    """Whether a circle fits into a region (Shapely polygons, m): at its ``centre``, or anywhere; ``None`` where the
    region is empty."""
    import shapely

    found = largest_circle(shape)
    if found is None:
        return None
    centre = centre or found.centre
    place = np.array(centre)

    def over(square: Array) -> Array:
        """Places of the figure for those of the square -1 .. 1: (2, n)."""
        long = np.maximum(1.0, np.hypot(*square))
        return np.asarray(place[:, None] + radius * square / long)

    point = shapely.Point(centre)
    room = float(point.distance(shape.boundary)) * (1.0 if shape.covers(point) else 0.0)
    fits = bool(room >= radius)
    margin = room - radius if fits else -_farthest(shape, over, radius, disc=True)
    disc = point.buffer(radius, quad_segs=256)
    return FigureMargin(
        fits, centre, margin, room / radius, 0.0 if fits else float(disc.difference(shape).area / disc.area)
    )


def rectangle_fits(
    shape: Any, width: float, height: float, angle: float = 0.0, centre: tuple[float, float] | None = None
) -> FigureMargin | None:
    """Whether a rectangle, its width at ``angle`` (rad) to the x axis, fits into a region (Shapely polygons, m): at its
    ``centre``, or anywhere; ``None`` where the region is empty."""
    import shapely

    if shape.is_empty or not shape.area:
        return None
    if centre is None:
        found = largest_rectangle(shape, width / height, angle)
        assert found is not None
        centre = found.centre
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s], [s, c]]) * np.array([width, height]) / 2
    place = np.array(centre)

    def over(square: Array) -> Array:
        return np.asarray(place[:, None] + turn @ square)

    corners = np.array([[-1.0, 1, 1, -1], [-1, -1, 1, 1]])
    figure = shapely.Polygon(over(corners).T)
    shapely.prepare(shape)
    fits = bool(shape.covers(figure))
    low, high = 0.0, 1.0
    while shape.covers(shapely.Polygon(over(high * corners).T)):
        low, high = high, 2 * high
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        inside = shape.covers(shapely.Polygon(over(middle * corners).T))
        low, high = (middle, high) if inside else (low, middle)
    margin = float(figure.distance(shape.boundary)) if fits else -_farthest(shape, over, max(width, height) / 2)
    return FigureMargin(fits, centre, margin, low, 0.0 if fits else float(figure.difference(shape).area / figure.area))


def _farthest(shape: Any, over: Callable[[Array], Array], size: float, disc: bool = False) -> float:
    """How far the farthest place of a figure lies off a region (m); ``over`` draws the square -1 .. 1 onto the figure
    and stretches no distance by more than ``size``. Cells of the square are left out as for rectangles; so are those
    off the unit circle of a ``disc``, to which their places would be drawn."""
    import shapely

    boundary = shape.boundary
    shapely.prepare(shape)
    half = 0.25
    axis = np.arange(-1 + half, 1, 2 * half)
    at = np.stack(np.meshgrid(axis, axis)).reshape(2, -1)
    edge = np.linspace(-1, 1, 257)
    one = np.ones_like(edge)
    rim = np.concatenate([[edge, one], [edge, -one], [one, edge], [-one, edge]], axis=1)
    best = float(shapely.distance(shape, shapely.points(over(rim).T)).max())
    while half > PRECISION / 4:
        if disc:
            at = at[:, np.hypot(*at) <= 1.0 + np.sqrt(2) * half]
        points = shapely.points(over(at).T)
        # How far outside a place lies; inside, less than nothing, so that cells deep in the region are left out soon.
        far = shapely.distance(boundary, points) * np.where(shapely.covers(shape, points), -1.0, 1.0)
        best = max(best, float(far.max()))
        at = at[:, far + np.sqrt(2) * half * size > best + PRECISION * size]
        if not at.shape[1]:
            break
        half /= 2
        corners = half * np.array([[-1.0, -1, 1, 1], [-1, 1, -1, 1]])
        at = (at[:, :, None] + corners[:, None, :]).reshape(2, -1)
    return best
