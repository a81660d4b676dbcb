"""The drawing of Geneva drives: outlines of parts that could be made, which don't run into each other over a turn."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest
import shapely
from shapely import affinity

from elements.geneva.drives import A, arc, model
from helpers.compiled import compiled_from
from linkwright.graph.geometry import Geometry


@pytest.mark.parametrize(("n", "pins"), [(3, 1), (4, 1), (4, 2), (6, 2), (9, 1)])
def test_parts_keep_clear_of_each_other(n: int, pins: int) -> None:
    """Wheel, locking disc and pins overlap by no more than what their straight pieces do."""
    compiled = compiled_from(model(n, pins=pins))
    geometry = Geometry(compiled.quantities, compiled.quantities.parameters)
    shapes: dict[str, list[shapely.Polygon]] = {"wheel": [], "driver": []}
    for curve in compiled.mechanism.followers["indexing"].outline(geometry):
        assert curve.closed
        first, last = curve.ends
        at = first + (last - first) * np.linspace(0.0, 1.0, curve.points, endpoint=False)
        shape = shapely.Polygon(np.column_stack([1e3 * part for part in curve.place(at)]))
        assert shape.is_valid
        shapes[curve.link].append(shape)
    assert [len(shapes[link]) for link in ("wheel", "driver")] == [1, 1 + pins]
    (wheel,), (disc, *_) = shapes["wheel"], shapes["driver"]
    assert wheel.bounds[2] <= A * np.cos(pi / n) * (1 + 1e-9)
    assert shapely.hausdorff_distance(disc.convex_hull, shapely.Point(0, 0).buffer(arc(n), 64)) < 0.7 * arc(n)
    rows = [f"{name}.{part}" for name in ("O", "Q") for part in "xy"] + ["driver.angle", "wheel.angle"]
    for ox, oy, qx, qy, driver, turn in compiled.evaluate(rows, np.linspace(0.0, 1.0, 73)).T.tolist():
        there = [(shape, ox, oy, driver) for shape in shapes["driver"]]
        placed = [
            affinity.translate(affinity.rotate(shape, angle, origin=(0, 0), use_radians=True), 1e3 * x, 1e3 * y)
            for shape, x, y, angle in (*there, (wheel, qx, qy, turn))
        ]
        overlap = max(part.intersection(placed[-1]).area for part in placed[:-1])
        assert overlap < 5e-3 * disc.area
