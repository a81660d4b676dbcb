"""Figures of plane shapes, and shapes without what only chords make."""

from __future__ import annotations

from typing import Any

from linkwright.data_classes import dataclass

THIN = 4.0
"""What is narrower than so many chord tolerances is where two boundaries are one, each drawn to its own chords."""


@dataclass(frozen=True)
class ShapeFigures:
    """Figures of a shape: m2, m; ``bounds`` are least x, least y, largest x, largest y; ``centroid`` x, y."""

    area: float
    perimeter: float
    holes: int
    parts: int
    bounds: tuple[float, float, float, float]
    centroid: tuple[float, float]


def figures(shape: Any) -> ShapeFigures:
    """The figures of a polygon or several."""
    polygons = pieces(shape)
    if not polygons:
        nowhere = float("nan")
        return ShapeFigures(0.0, 0.0, 0, 0, (nowhere,) * 4, (nowhere, nowhere))
    holes = sum(len(polygon.interiors) for polygon in polygons)
    x, y = shape.centroid.coords[0]
    return ShapeFigures(
        float(shape.area), float(shape.length), holes, len(polygons), shape.bounds, (float(x), float(y))
    )


def pieces(shape: Any) -> list[Any]:
    """The polygons of a shape."""
    import shapely

    return [part for part in shapely.get_parts(shape) if part.geom_type == "Polygon" and not part.is_empty]


def without_slivers(shape: Any, chord: float) -> Any:
    """A shape without the parts and holes that only chords make."""
    import shapely

    def wide(ring: Any) -> bool:
        return bool(shapely.Polygon(ring).area > THIN * chord * ring.length / 2)

    kept = [
        shapely.Polygon(part.exterior, [ring for ring in part.interiors if wide(ring)])
        for part in pieces(shape)
        if wide(part.exterior)
    ]
    found = _as_geometry(kept)
    if not shapely.is_valid(found):  # its rings cross, by no more than they were made simpler
        found = _as_geometry(pieces(shapely.make_valid(found, method="structure", keep_collapsed=False)))
    return found


def _as_geometry(polygons: list[Any]) -> Any:
    import shapely

    return shapely.MultiPolygon(polygons) if len(polygons) != 1 else polygons[0]
