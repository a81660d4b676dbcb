"""A cam as a DXF drawing: closed polylines of arcs and lines, as laser and wire cutters want them."""

from __future__ import annotations

import io
import math
from collections.abc import Mapping, Sequence

from linkwright._machine import needed
from linkwright.cam.nc.path import Element
from linkwright.cam.splines import Spline

Circle = tuple[float, float, float]
"""x, y, radius (mm)."""


def bulge(element: Element) -> float:
    """The tangent of a quarter of the angle of an arc, positive counter-clockwise; 0 of a line."""
    return 0.0 if element.centre is None else element.turn * math.tan(element.swept / 4)


def dxf(
    contours: Mapping[str, Sequence[Element]],
    circles: Mapping[str, Sequence[Circle]],
    splines: Mapping[str, Sequence[Spline]] | None = None,
) -> str:
    """A drawing in mm: contours, closed, circles, and splines (these in m) by the name of their layer."""
    splines = splines or {}
    ezdxf = needed("ezdxf", "cad")
    drawing = ezdxf.new("R2010", setup=False)
    drawing.units = 4
    space = drawing.modelspace()
    for layer in {**contours, **circles, **splines}:
        drawing.layers.add(layer)
    for layer, elements in contours.items():
        rows = [(*element.start, bulge(element)) for element in elements]
        space.add_lwpolyline(rows, format="xyb", close=True, dxfattribs={"layer": layer})
    for layer, pieces in splines.items():
        for piece in pieces:
            places = [(x, y, 0.0) for x, y in (1e3 * piece.points).T.tolist()]
            space.add_open_spline(places, degree=3, knots=piece.knots.tolist(), dxfattribs={"layer": layer})
    for layer, some in circles.items():
        for x, y, radius in some:
            space.add_circle((x, y), radius, dxfattribs={"layer": layer})
    stream = io.StringIO()
    drawing.write(stream)
    return stream.getvalue()
