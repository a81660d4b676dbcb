"""What triangles cover that overlap and fold back."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.studies.workspace.mesh import sides_of


def covered(at: NDArray[np.float64], triangles: NDArray[np.intp]) -> Any:
    """What triangles with their corners at places (2, n) cover, folded as they may be (Shapely): of the faces between
    the sides on which they end or fold back, those on which some triangle lies."""
    import shapely

    corners = at[:, triangles]
    (ax, bx, cx), (ay, by, cy) = corners[0].T, corners[1].T
    left = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 0
    sides = np.sort(sides_of(triangles), axis=1)
    _, first, which = np.unique(sides[:, 0] * at.shape[1] + sides[:, 1], return_index=True, return_inverse=True)
    turned = np.bincount(which, weights=np.tile(left, 3))
    ending = sides[first[(np.bincount(which) != 2) | (turned == 1)]]
    if not ending.size:
        return shapely.Polygon()
    lines = shapely.linestrings(np.moveaxis(at[:, ending], (0, 1, 2), (2, 0, 1)))
    joined = shapely.unary_union(lines, grid_size=1e-9 * float(np.ptp(at[:, ending], axis=(1, 2)).max()))
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(joined)))
    if not len(faces):
        return shapely.Polygon()
    tree = shapely.STRtree(shapely.polygons(np.moveaxis(corners, 0, 2)))
    hit = np.unique(tree.query(shapely.point_on_surface(faces), predicate="intersects")[0])
    return shapely.union_all(faces[hit])
