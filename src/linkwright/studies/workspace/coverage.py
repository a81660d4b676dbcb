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
    sides = np.sort(sides_of(triangles), axis=1)
    start, along = at[:, sides[:, 0]], at[:, sides[:, 1]] - at[:, sides[:, 0]]
    across = at[:, np.concatenate([triangles[:, 2], triangles[:, 0], triangles[:, 1]])] - start
    left = along[0] * across[1] - along[1] * across[0] > 0
    _, first, which = np.unique(sides[:, 0] * at.shape[1] + sides[:, 1], return_index=True, return_inverse=True)
    # Between two triangles on either side of it nothing ends.
    ending = sides[first[(np.bincount(which) != 2) | (np.bincount(which, weights=left) != 1)]]
    if not ending.size:
        return shapely.Polygon()
    lines = shapely.linestrings(np.moveaxis(at[:, ending], (0, 1, 2), (2, 0, 1)))
    joined = shapely.unary_union(lines, grid_size=1e-9 * float(np.ptp(at[:, ending], axis=(1, 2)).max()))
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(joined)))
    if not len(faces):
        return shapely.Polygon()
    tree = shapely.STRtree(shapely.polygons(np.moveaxis(corners, 0, 2)))
    hit = np.unique(tree.query(shapely.point_on_surface(faces), predicate="intersects")[0])
    return shapely.coverage_union_all(faces[hit])
