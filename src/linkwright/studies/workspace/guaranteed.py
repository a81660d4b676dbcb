"""What tolerances leave of a workspace: maps of the working point's errors, and the part of a region that is sure.

At given drive values F(q, p) is the working point, and c_i = dF/dp_i, of contributor i, its error of first order
(superposition: Peng and Zi, Journal of Mechanical Transmission 34(4), 2010, eq. 8, 9). The boundary of a region
moves along its normal n by the sum of n . c_i d_i: how the drive values of the boundary move doesn't count there
(envelope theorem: Danskin, SIAM Journal on Applied Mathematics 14, 1966, 641-664). On the rim, where two modes meet,
c_i is taken along it, at constant reach, as it grows without bound at given drive values.
"""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.tangent import tangent
from linkwright.kernels import KERNELS
from linkwright.kernels.choice import choose
from linkwright.model import units as u
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.workspace import mesh as meshes
from linkwright.studies.workspace.maps import MOST, Maps, mapped
from linkwright.studies.workspace.mesh import Box
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.sheet import Sheet

Array = NDArray[np.float64]

STEPS = 200
ROUND = 16
"""Strips end round, in so many pieces a quarter of a turn; they are wider by what these lack."""
BESIDE = 1e-5
"""Boundaries are looked for within this share of the region's extent."""
KINDS = {f"error {what}": u.LENGTH for what in ("x least", "x most", "y least", "y most", "worst")} | {
    f"spread {what}": u.LENGTH for what in ("x", "y", "worst")
}


class Errors:
    """The errors of the working point by the contributors' deviations, at given drive values."""

    def __init__(self, sheet: Sheet, contributors: Contributors, poses: int) -> None:
        self.sheet, self.contributors = sheet, contributors
        self.graph = sheet.compiled.graph
        labels = [group.label for group in sheet.compiled.structure.groups if group.modes > 1]
        self.closed = len(labels)
        names = [f"{sheet.point}.x", f"{sheet.point}.y", *(f"reach:{label}" for label in labels)]
        program = tangent(self.graph, names)
        self.engine = KERNELS[choose(program, poses * (len(contributors) + 2), os.cpu_count() or 1).kernel](program)
        self.drives = [self.graph.drives.index(drive) * self.graph.width for drive in sheet.drives]

    def slopes(self, q: Array, drives: bool = False) -> tuple[Array, Array]:
        """Values (2 + reaches, n) of the point and the reaches of groups with two modes, and their derivatives by the
        contributors, (2 + reaches, contributors, n); with ``drives``, by the two drives after them."""
        size, many, more = len(self.graph.inputs), len(self.contributors), 2 if drives else 0
        x = np.zeros((2 * size, many + more, q.shape[1]))
        x[:size] = self.sheet.inputs(q)[:, None]
        for k, row in enumerate(self.drives[:more]):
            x[size + row, many + k] = 1.0
        along = np.zeros((self.sheet.parameters.size, many + more))
        along[:, :many] = self.contributors.directions
        p = np.concatenate([np.repeat(self.sheet.parameters[:, None], many + more, axis=1), along])
        with np.errstate(all="ignore"):
            y = self.engine.over(x, p).reshape(-1, 2, many + more, q.shape[1])
        return y[:, 0, 0], y[:, 1]

    def __call__(self, q: Array) -> dict[str, Array]:
        """The figures of the error maps at drive values (2, n): see :func:`errors`."""
        step = max(1, MOST // len(self.contributors))
        parts = [self._figures(q[:, start : start + step]) for start in range(0, q.shape[1], step)]
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]} if parts else {}

    def _figures(self, q: Array) -> dict[str, Array]:
        values, slopes = self.slopes(q)
        low, high = self.contributors.low[:, None], self.contributors.high[:, None]
        found = {"x": values[0], "y": values[1]}
        with np.errstate(all="ignore"):
            outside = ~(values[2:] > 0).all(axis=0)
            for name, slope in zip("xy", slopes[:2], strict=True):
                found[f"error {name} least"] = np.minimum(low * slope, high * slope).sum(axis=0)
                found[f"error {name} most"] = np.maximum(low * slope, high * slope).sum(axis=0)
            found["error worst"] = farthest(slopes[:2], low, high)
            xx, xy, yy = (
                np.einsum("in,ij,jn->n", slopes[a], self.contributors.covariance, slopes[b])
                for a, b in ((0, 0), (0, 1), (1, 1))
            )
            found["spread x"], found["spread y"] = 3 * np.sqrt(xx), 3 * np.sqrt(yy)
            found["spread worst"] = 3 * np.sqrt((xx + yy) / 2 + np.hypot((xx - yy) / 2, xy))
        return {name: np.where(outside, np.nan, row) for name, row in found.items()}


def errors(sheet: Sheet, box: Box, contributors: Contributors, steps: int = STEPS) -> Maps:
    """Maps of the working point's errors (m), of first order, on ``steps`` equal steps of each drive.

    Worst case: ``error x least`` and ``most`` are its limits along x, y likewise; ``error worst`` is the farthest that
    the point may be off. ``spread x``, ``y``: three standard deviations; ``spread worst`` those along the direction
    in which they are largest.
    """
    return mapped(sheet.compiled.quantities, box, steps, Errors(sheet, contributors, (steps + 1) ** 2), KINDS)


def farthest(slopes: Array, low: Array, high: Array) -> Array:
    """The greatest length of the sum of slopes (2, contributors, n) times deviations within ``low`` .. ``high``
    (contributors, 1): (n,).

    The sums fill a polygon, whose corners follow each other as its sides are ordered by their directions.
    """
    middle, half = (slopes * (low + high) / 2).sum(axis=1), slopes * (high - low) / 2
    half = np.where((half[1] < 0) | ((half[1] == 0) & (half[0] < 0)), -half, half)
    order = np.argsort(np.arctan2(half[1], half[0]), axis=0)
    sides = np.take_along_axis(half, order[None], axis=1)
    corners = sides.sum(axis=1, keepdims=True) - 2 * np.cumsum(sides, axis=1)
    both = np.stack([middle[:, None] + corners, middle[:, None] - corners])
    return np.asarray(np.hypot(both[:, 0], both[:, 1]).max(axis=(0, 1)))


@dataclass(frozen=True)
class Guaranteed:
    """What is sure of a region, to first order, for all deviations within their limits at once.

    ``shape`` (Shapely, m) is reached whatever they are. ``precise`` is the part of it in which the point is off by no
    more than ``limit`` (m) in all poses of the sheet that come there; None where no limit was asked for. ``least`` and
    ``most`` are the smallest and the greatest inward way of the boundary (m), NaN where there is no boundary.
    """

    region: Region
    shape: object
    least: float
    most: float
    limit: float | None = None
    precise: object | None = None


def guaranteed(
    region: Region, contributors: Contributors, limit: float | None = None, steps: int = STEPS
) -> Guaranteed:
    """The guaranteed part of a region; ``limit`` of the point's error is looked for on a mesh of ``steps``."""
    import shapely

    found = Errors(region.sheet, contributors, sum(one.a.shape[1] for one in region.segments))
    made = [strips(region, found, one.kind, one.a, one.b) for one in region.segments if one.a.size]
    width = np.concatenate([way for _, way in made]) if made else np.empty(0)
    cut = shapely.union_all([strip for strip, _ in made if strip is not None])
    shape = shapely.difference(region.shape, cut)
    precise = None if limit is None else shapely.difference(shape, imprecise(region, found, limit, steps))
    if not width.size:
        return Guaranteed(region, shape, np.nan, np.nan, limit, precise)
    return Guaranteed(region, shape, float(width.min()), float(width.max()), limit, precise)


def strips(region: Region, found: Errors, kind: str, a: Array, b: Array):  # type: ignore[no-untyped-def]
    """The strips along those pieces, a to b (2, n) in the drives' plane, that bound a region, together; and how far
    the boundary may move inward there: (pieces on the boundary,)."""
    import shapely

    sheet, n = region.sheet, a.shape[1]
    ends = sheet.place(np.concatenate([a, b], axis=1))[0].reshape(2, 2, n)
    edge = shapely.boundary(region.shape)
    low, high = np.nanmin(ends, axis=(1, 2)), np.nanmax(ends, axis=(1, 2))
    beside = BESIDE * float((high - low).max())
    shapely.prepare(edge)
    on = shapely.dwithin(edge, shapely.points(ends.mean(axis=1).T), beside / 10)
    on &= (ends[:, 0] != ends[:, 1]).any(axis=0)
    a, b, ends = a[:, on], b[:, on], ends[:, :, on]
    if not on.any():
        return None, np.empty(0)
    along = ends[:, 1] - ends[:, 0]
    normal = np.stack([along[1], -along[0]]) / np.hypot(*along)
    shapely.prepare(region.shape)
    sides = [shapely.contains_xy(region.shape, *(ends.mean(axis=1) + s * beside * normal)) for s in (1, -1)]
    ways = np.stack([moved(found, kind, q, normal) for q in (a, b)]).max(axis=0)
    # Where one side alone is inside, the other's way doesn't count.
    width = np.where(sides[0] & ~sides[1], ways[0], np.where(sides[1] & ~sides[0], ways[1], ways.max(axis=0)))
    lines = shapely.linestrings(np.moveaxis(ends, (0, 1, 2), (2, 1, 0)))
    strip = shapely.buffer(lines, width / np.cos(np.pi / 4 / ROUND), quad_segs=ROUND)
    return shapely.union_all(strip), width


def moved(found: Errors, kind: str, q: Array, normal: Array) -> Array:
    """How far the boundary may move along the normal (2, n), and against it: (2, n) in m, 0 or more."""
    values, slopes = found.slopes(q, drives=kind in HELD)
    own = HELD[kind](values, slopes) if kind in HELD else slopes[:2]
    across = np.einsum("kin,kn->in", own, normal)
    low, high = found.contributors.low[:, None], found.contributors.high[:, None]
    ways = [np.maximum(low * one, high * one).sum(axis=0) for one in (across, -across)]
    return np.asarray(np.maximum(np.nan_to_num(np.stack(ways), nan=0.0), 0.0))


def _at_reach(values: Array, slopes: Array) -> Array:
    """The derivatives of the point, (2, contributors, n), while the least reach stays: the drive values follow along
    the reach's gradient; what they move along the rim doesn't matter."""
    which = values[2:].argmin(axis=0)
    reach = np.take_along_axis(slopes[2:], which[None, None], axis=0)[0]
    by_drives = reach[-2:]
    follow = -by_drives[:, None] * reach[None, :-2] / (by_drives**2).sum(axis=0)
    return np.asarray(slopes[:2, :-2] + np.einsum("kjn,jin->kin", slopes[:2, -2:], follow))


HELD = {"modes": _at_reach}
"""Kinds of curves on which drive values have to follow the deviations."""


def imprecise(region: Region, found: Errors, limit: float, steps: int = STEPS):  # type: ignore[no-untyped-def]
    """Where some pose's error is above a limit, as far as triangles of the mesh show it (Shapely, m)."""
    import shapely

    sheet, box = region.sheet, region.box
    made = meshes.mesh(sheet, box, steps)

    def above(q: Array) -> NDArray[np.bool_]:
        error = found(q)["error worst"]
        return ~(error <= limit)

    q, triangles, _ = meshes._cut(above, made.q, made.triangles)
    at = sheet.place(q)[0][:, triangles]
    at = at[:, np.isfinite(at).all(axis=(0, 2))]
    if not at.size:
        return shapely.Polygon()
    return shapely.union_all(shapely.polygons(np.moveaxis(at, 0, 2)))
