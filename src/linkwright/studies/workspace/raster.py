"""Maps over the plane of the working point: on a grid of places, at the drive values that come there.

A sheet may cover a place several times, folded along limit positions of the output: all the poses are looked at, and
one of them counts.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.workspace import mesh as meshes
from linkwright.studies.workspace.maps import Maps, evaluate_in_threads
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

STEPS, MOST = 128, 400_000
"""Steps of the mesh that tells about which drive values come to a place, where the region's has more triangles."""
NEWTON = 8
NEAR, FAR = 1e-6, 0.5
"""Drive values that come within the first share of the grid's step are a place's; beyond the second they aren't."""


@dataclass(frozen=True)
class Raster:
    """A grid of places: ``x`` (columns,) and ``y`` (rows,) are equal steps (m). ``cells`` (n,) number the places that
    are covered, row by row, each as often as it is; ``q`` (2, n) are the drive values that come there, and ``figures``
    (n,) each what maps say of them."""

    x: Array
    y: Array
    cells: Rows
    q: Array
    figures: dict[str, Array]

    def map(self, name: str, score: Callable[[Array], Array]) -> Array:
        """A map's value at each place, (rows, columns): of the pose with the greatest ``score`` of its value; NaN
        where none comes."""
        values = self.figures[name]
        order = np.lexsort((np.nan_to_num(score(values), nan=-np.inf), self.cells))
        last = order[np.flatnonzero(np.diff(self.cells[order], append=-1))]
        found = np.full(self.x.size * self.y.size, np.nan)
        found[self.cells[last]] = values[last]
        return found.reshape(self.y.size, -1)


def raster(region: Region, maps: Maps, cells: int) -> Raster:
    """Over the bounds of a region, so many cells along the longer side."""
    x, y, rows, q = _poses(region, cells)
    return Raster(x, y, rows, q, evaluate_in_threads(maps.figures, q))


@lru_cache(maxsize=16)  # maps of quality and of errors want the same
def _poses(region: Region, cells: int) -> tuple[Array, Array, Rows, Array]:
    """Axes of the grid, the places that are covered and the drive values, as a :class:`Raster` has them."""
    sheet, box, bounds = region.sheet, region.box, region.shape.bounds
    step = max(bounds[2] - bounds[0], bounds[3] - bounds[1]) / cells
    axes = [
        np.arange(np.ceil((high - low) / step) + 1) * step + low for low, high in zip(bounds, bounds[2:], strict=False)
    ]
    x, y = axes
    made = region.mesh if len(region.mesh.triangles) < MOST else meshes.mesh(sheet, box, STEPS)
    at = sheet.place(made.q)[0]
    triangles = made.triangles[np.isfinite(at[:, made.triangles]).all(axis=(0, 2))]
    rows, which, shares = _places_in_triangles(at[:, triangles], x, y)
    q = np.einsum("ank,nk->an", made.q[:, triangles[which]], shares)
    places = np.stack([x[rows % x.size], y[rows // x.size]])
    q, off = _nearer(sheet, q, places, NEAR * step, np.divide(box.size, STEPS))
    found = off < FAR * step
    return x, y, rows[found], q[:, found]


def _places_in_triangles(at: Array, x: Array, y: Array) -> tuple[Rows, Rows, Array]:
    """The places of a grid within triangles at (2, n, 3): their numbers, those of the triangles, the shares (m, 3) of
    its corners."""
    step, start = x[1] - x[0], np.array([x[0], y[0]])[:, None]
    low = np.maximum(np.ceil((at.min(axis=2) - start) / step), 0).astype(int)
    high = np.minimum(np.floor((at.max(axis=2) - start) / step), [[x.size - 1], [y.size - 1]]).astype(int)
    wide, tall = np.maximum(high - low + 1, 0)
    count = wide * tall
    which = np.repeat(np.arange(count.size), count)
    own = np.arange(which.size) - np.repeat(np.cumsum(count) - count, count)
    column, row = low[0][which] + own % wide[which], low[1][which] + own // wide[which]
    (ax, bx, cx), (ay, by, cy) = (np.moveaxis(axis[which], 1, 0) for axis in at)
    px, py = x[column], y[row]
    with np.errstate(all="ignore"):
        whole = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        b = ((px - ax) * (cy - ay) - (py - ay) * (cx - ax)) / whole
        c = ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / whole
        inside = (b >= -1e-9) & (c >= -1e-9) & (b + c <= 1 + 1e-9)
    b, c = b[inside], c[inside]
    return (row * x.size + column)[inside], which[inside], np.stack([1 - b - c, b, c], axis=1)


def _nearer(sheet: ModeSheet, q: Array, places: Array, near: float, most: Array) -> tuple[Array, Array]:
    """Drive values moved so that they come to places, by a few steps of Newton's method, and how far off these are."""
    best, off = q.copy(), np.full(q.shape[1], np.inf)
    rest, tried = np.arange(q.shape[1]), q
    for _ in range(NEWTON):
        look = sheet.look(tried)
        miss = look.at - places[:, rest]
        closer = np.hypot(*miss) < off[rest]
        best[:, rest[closer]], off[rest[closer]] = tried[:, closer], np.hypot(*miss)[closer]
        with np.errstate(all="ignore"):
            (a, b), (c, d) = look.jacobian
            move = np.stack([d * miss[0] - b * miss[1], a * miss[1] - c * miss[0]]) / look.determinant
        tried = tried - np.clip(np.nan_to_num(move, nan=0.0, posinf=0.0, neginf=0.0), -most[:, None], most[:, None])
        open_ = ~(off[rest] < near)
        rest, tried = rest[open_], tried[:, open_]
        if not rest.size:
            break
    return best, off
