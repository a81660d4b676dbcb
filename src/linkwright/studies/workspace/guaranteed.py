"""What tolerances leave of a workspace: maps of the working point's errors, and the part of a region that is sure.

At given drive values F(q, p) is the working point, and c_i = dF/dp_i, of contributor i, its error of first order
(superposition: Peng and Zi, Journal of Mechanical Transmission 34(4), 2010, eq. 8, 9). The boundary of a region
moves along its normal n by the sum of n . c_i d_i: how the drive values of the boundary move doesn't count there
(envelope theorem: Danskin, SIAM Journal on Applied Mathematics 14, 1966, 641-664). On the rim, where two modes meet,
c_i is taken along it, at constant reach, as it grows without bound at given drive values.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.tangent import jacobian
from linkwright.kernels import KERNELS
from linkwright.kernels.choice import choose
from linkwright.kernels.registry import Kernel
from linkwright.model import units as u
from linkwright.structure import Group
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.workspace import mesh as meshes
from linkwright.studies.workspace.maps import Maps, mapped
from linkwright.studies.workspace.mesh import Box, Mesh
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.sheet import Sheet

Array = NDArray[np.float64]

STEPS = 200
ROUND = 8
"""Strips end round, in so many pieces a quarter of a turn; they are wider by what these lack."""
ROUGH = 0.01
"""Segments of the boundary are one where their strips' widths differ by no more than this share of the widest."""
BESIDE = 1e-6
"""Curves within this share of the region's extent from its boundary bound it."""
AWAY = 2.0**15
"""How much farther from a pit than its innermost ring the shifts are looked at: the direction alone matters."""
KINDS = {f"error {what}": u.LENGTH for what in ("x least", "x most", "y least", "y most", "worst")} | {
    f"spread {what}": u.LENGTH for what in ("x", "y", "worst")
}


POSES: dict[str, Callable[[Group], tuple[str, str]]] = {
    "RRR": lambda group: (f"{group.ends[0]}.angle", f"{group.ends[1]}.angle"),
    "RPR": lambda group: (f"{group.ends[0]}.angle", f"{group.inner.joint}.s"),
}
"""What tells the pose of a dyad with two outer pins, which may meet."""


class Errors:
    """The errors of the working point by the contributors' deviations, at given drive values."""

    def __init__(self, sheet: Sheet, contributors: Contributors, count: int) -> None:
        self.sheet, self.contributors = sheet, contributors
        self.graph = sheet.compiled.graph
        groups = sheet.compiled.structure.groups
        closed = [f"reach:{group.label}" for group in groups if group.modes > 1]
        poses = [row for group in groups if group.signature in POSES for row in POSES[group.signature](group)]
        self.reaches, self.poses = slice(2, 2 + len(closed)), slice(2 + len(closed), None)
        self.names = [f"{sheet.point}.x", f"{sheet.point}.y", *closed, *poses]
        moving = np.flatnonzero(contributors.directions.any(axis=1))
        self.directions = contributors.directions[moving]
        self.by = [self.graph.parameters[i] for i in moving]
        program = jacobian(self.graph, self.names[:2], self.by, closed)
        self.engine = KERNELS[choose(program, count, os.cpu_count() or 1).kernel](program)

    @cached_property
    def _whole(self) -> Kernel:
        """What gives all derivatives, by the drives too; used at the few poses of curves."""
        width = self.graph.width
        drives = [self.graph.inputs[self.graph.drives.index(drive) * width] for drive in self.sheet.drives]
        return KERNELS["numpy"](jacobian(self.graph, self.names, [*self.by, *drives]))

    def slopes(self, q: Array) -> tuple[Array, Array]:
        """Values (rows, n) of the point, of the ``reaches`` of groups with two modes, of the ``poses`` of those with
        two outer pins; their derivatives by the contributors, and by the two drives after them: (rows, contributors +
        2, n)."""
        with np.errstate(all="ignore"):
            y = self._whole.run(self.sheet.inputs(q), self.sheet.parameters)
        rows = len(self.names)
        found = y[rows:].reshape(rows, -1, q.shape[1])
        return y[:rows], np.concatenate([self._along(found[:, :-2]), found[:, -2:]], axis=1)

    def _along(self, slopes: Array) -> Array:
        """Derivatives (rows, parameters, n) as those by the contributors: (rows, contributors, n)."""
        if np.array_equal(self.directions, np.eye(len(self.by))):
            return slopes
        with np.errstate(all="ignore"):
            return np.matmul(self.directions.T, slopes)

    def __call__(self, q: Array) -> dict[str, Array]:
        """The figures of the error maps at drive values (2, n): see :func:`errors`."""
        low, high = self.contributors.low[:, None], self.contributors.high[:, None]
        covariance = self.contributors.covariance
        n, last = q.shape[1], 2 + 2 * len(self.by)
        with np.errstate(all="ignore"):
            y = self.engine.run(self.sheet.inputs(q), self.sheet.parameters)
        slopes = self._along(y[2:last].reshape(2, -1, n))
        found = {"x": y[0], "y": y[1]}
        with np.errstate(all="ignore"):
            outside = ~(y[last:] > 0).all(axis=0)
            for name, slope in zip("xy", slopes, strict=True):
                found[f"error {name} least"] = np.minimum(low * slope, high * slope).sum(axis=0)
                found[f"error {name} most"] = np.maximum(low * slope, high * slope).sum(axis=0)
            found["error worst"] = farthest(slopes, low, high)
            diagonal = np.diag(covariance)[:, None]
            apart = np.array_equal(covariance, np.diag(diagonal[:, 0]))
            spread = slopes * diagonal if apart else np.matmul(covariance, slopes)
            xx, xy, yy = ((slopes[a] * spread[b]).sum(axis=0) for a, b in ((0, 0), (0, 1), (1, 1)))
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
    # Of the corners on both sides of the middle, the farther one.
    beyond = (corners * corners).sum(axis=0) + 2 * np.abs((corners * middle[:, None]).sum(axis=0))
    return np.asarray(np.sqrt(beyond.max(axis=0) + (middle * middle).sum(axis=0)))


@dataclass(frozen=True)
class Guaranteed:
    """What is sure of a region, to first order, for all deviations within their limits at once.

    ``shape`` (Shapely, m) is reached whatever they are. ``precise`` is the part of it in which the point is off by no
    more than ``limit`` (m) in all poses of the sheet that come there; None where no limit was asked for. ``least`` and
    ``most`` are the smallest and the greatest way that the boundary may move inward (m), NaN where there is none.
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
    made = edges(region, found)
    width = np.concatenate([one.width for one in made]) if made else np.array([np.nan])
    shape = shapely.difference(region.shape, shapely.union_all(_strips(region, made))) if made else region.shape
    precise = None if limit is None else shapely.difference(shape, imprecise(region, found, limit, steps))
    return Guaranteed(region, shape, float(np.min(width)), float(np.max(width)), limit, precise)


def _strips(region: Region, made: Sequence[Edge]):  # type: ignore[no-untyped-def]
    """Strips along the boundary, each as wide as it moves inward there. Segments in a row that move alike are one, and
    the strip wider by what is cut off."""
    import shapely

    corners = [shapely.get_coordinates(ring).T for ring in _rings(region.shape)]
    widest = np.zeros(sum(ring.shape[1] - 1 for ring in corners))
    for one in made:
        np.maximum.at(widest, one.segment, one.width)
    cut = ROUGH * float(widest.max())
    levels = np.floor(widest / max(cut, 1e-300))
    lines, widths, first = [], [], 0
    for ring in corners:
        count = ring.shape[1] - 1
        own, level = widest[first : first + count], levels[first : first + count]
        kept = _kept(ring, cut)
        kept[1:-1] |= level[1:] != level[:-1]
        stops = np.flatnonzero(kept)
        lines.append(
            shapely.linestrings(np.stack([ring[:, stops[:-1]], ring[:, stops[1:]]], axis=2).transpose(1, 2, 0))
        )
        widths.append(np.maximum.reduceat(own, stops[:-1]) + cut)
        first += count
    wide = np.concatenate(widths) / np.cos(np.pi / 4 / ROUND)
    return shapely.buffer(np.concatenate(lines), wide, quad_segs=ROUND)


def _kept(ring: Array, cut: float) -> NDArray[np.bool_]:
    """Which corners of a closed line (2, n) are left where others may be ``cut`` off: by Douglas and Peucker."""
    import shapely

    left = {
        tuple(place) for place in shapely.get_coordinates(shapely.simplify(shapely.linestrings(ring.T), cut)).tolist()
    }
    kept = np.array([tuple(place) in left for place in ring.T.tolist()])
    kept[[0, -1]] = True
    return kept


def _rings(shape):  # type: ignore[no-untyped-def]
    """The boundary's rings; the shape lies to their left."""
    import shapely

    return shapely.get_parts(shapely.boundary(shapely.orient_polygons(shape)))


@dataclass(frozen=True)
class Edge:
    """The boundary's pieces that lie on one kind of curve.

    ``ends`` (2, 2, n) are their places: coordinate, end, piece; ``outward`` (2, n) their unit normals. ``shifts``
    (contributors, 2, n) is how far either end moves outward per unit of each deviation, ``width`` (n,) how far inward
    at worst (m); ``segment`` (n,) numbers the boundary's segments, which may lie on several curves.
    """

    kind: str
    ends: Array
    outward: Array
    shifts: Array
    width: Array
    segment: NDArray[np.intp]


def edges(region: Region, found: Errors) -> list[Edge]:
    """The boundary of a region by the curves on which it lies."""
    import shapely

    corners = [shapely.get_coordinates(ring).T for ring in _rings(region.shape)]
    if not corners:
        return []
    ends = np.concatenate([np.stack([ring[:, :-1], ring[:, 1:]], axis=1) for ring in corners], axis=2)
    along = ends[:, 1] - ends[:, 0]
    outward = np.stack([along[1], -along[0]]) / np.hypot(*along)
    middles = shapely.points(ends.mean(axis=1).T)
    drives = [np.stack([one.a, one.b], axis=1) for one in region.segments]
    kinds = np.repeat(np.arange(len(drives)), [part.shape[2] for part in drives])
    every = np.concatenate(drives, axis=2)
    paths = region.sheet.place(every.reshape(2, -1))[0].reshape(every.shape)
    known = np.flatnonzero(np.isfinite(paths).all(axis=(0, 1)))
    tree = shapely.STRtree(shapely.linestrings(np.moveaxis(paths[:, :, known], (0, 1, 2), (2, 1, 0))))
    beside = BESIDE * float(np.ptp(ends, axis=(1, 2)).max())
    # Segments shorter than that lie where curves end, among many others: the nearest curve tells enough.
    long = np.flatnonzero(np.hypot(*along) > beside)
    near = tree.query(middles[long], predicate="dwithin", distance=beside)
    near[0] = long[near[0]]
    nearest = tree.query_nearest(middles)
    which, piece = np.unique(np.concatenate([near, nearest], axis=1), axis=1)
    piece, made = known[piece], []
    for k, one in enumerate(region.segments):
        of = kinds[piece] == k
        if of.any():
            used, of_used = np.unique(piece[of], return_inverse=True)  # many pieces meet where a curve ends
            seen = every[:, :, used]
            seen = apart(region.mesh, seen) if one.kind == "pins" else seen
            shifts = moved(found, one.kind, seen, outward[:, which[of]], of_used)
            width = np.fmax.reduce(_worst(found.contributors, -shifts))
            width[np.isnan(width)] = np.fmax.reduce(width)
            made.append(Edge(one.kind, ends[:, :, which[of]], outward[:, which[of]], shifts, width, which[of]))
    return made


def apart(mesh: Mesh, drives: Array) -> Array:
    """Drive values (2, 2, n) so near to pits that derivatives have no digits left, moved away from them."""
    corners = np.unique(mesh.pits)
    before = corners - corners.size  # the mesh's rings, each half as wide as the one before, follow each other
    centres = 2 * mesh.q[:, corners] - mesh.q[:, before]
    far = np.hypot(*(drives[:, :, :, None] - centres[:, None, None]))
    centre = centres[:, far.argmin(axis=2)]
    return np.asarray(centre + AWAY * (drives - centre))


def _worst(contributors: Contributors, shifts: Array) -> Array:
    """The greatest sum of shifts (contributors, ...) times deviations, 0 or more."""
    low, high = (np.reshape(end, (-1, 1, 1)) for end in (contributors.low, contributors.high))
    return np.asarray(np.maximum(np.maximum(low * shifts, high * shifts).sum(axis=0), 0.0))


def moved(found: Errors, kind: str, drives: Array, outward: Array, of: NDArray[np.intp] | None = None) -> Array:
    """How far the ends of pieces (2, 2, n): coordinate, end, piece, in the drives' plane, move along their own normals,
    which point about as ``outward`` (2, n) does, per unit of each deviation: (contributors, 2, n). With ``of`` (m,) the
    pieces to which ``outward`` (2, m) belongs.

    The normals come from derivatives: where a curve ends on the rim, these grow without bound and hardly the shifts.
    """
    values, slopes = found.slopes(drives.reshape(2, -1))
    way = np.repeat((drives[:, 1] - drives[:, 0])[:, None], 2, axis=1).reshape(2, -1)
    with np.errstate(all="ignore"):
        own, along = ALONG.get(kind, _free)(found, values, slopes, way)
        normal = np.stack([along[1], -along[0]]) / np.hypot(*along)
    shifts = np.einsum("kin,kn->in", own, normal).reshape(len(own[0]), 2, -1)
    normal = normal.reshape(2, 2, -1)
    if of is not None:
        shifts, normal = shifts[:, :, of], normal[:, :, of]
    return np.asarray(shifts * np.where((normal * outward[:, None]).sum(axis=0) < 0, -1.0, 1.0))


Held = tuple[Array, Array]
"""How the place of a boundary goes with the deviations, (2, contributors, n), and its direction (2, n), of any size."""


def _free(found: Errors, values: Array, slopes: Array, way: Array) -> Held:
    """Along a way in the drives' plane."""
    return slopes[:2, :-2], np.einsum("kjn,jn->kn", slopes[:2, -2:], way)


def _singular(found: Errors, values: Array, slopes: Array, way: Array) -> Held:
    """All that the drives can do is one direction: that of the larger of their two columns."""
    one, two = slopes[:2, -2], slopes[:2, -1]
    return slopes[:2, :-2], np.where(np.hypot(*one) >= np.hypot(*two), one, two)


def _rim(found: Errors, values: Array, slopes: Array, way: Array) -> Held:
    """The least reach stays: drive values follow along its gradient; what they move along the rim doesn't matter."""
    which = values[found.reaches].argmin(axis=0)
    reach = np.take_along_axis(slopes[found.reaches], which[None, None], axis=0)[0]
    by_drives = reach[-2:]
    follow = -by_drives[:, None] * reach[None, :-2] / (by_drives**2).sum(axis=0)
    own = slopes[:2, :-2] + np.einsum("kjn,jin->kin", slopes[:2, -2:], follow)
    return own, np.einsum("kjn,jn->kn", slopes[:2, -2:], np.stack([by_drives[1], -by_drives[0]]))


def _pins(found: Errors, values: Array, slopes: Array, way: Array) -> Held:
    """Where outer pins meet their group may have any pose: it stays, and the drive values follow."""
    pose = slopes[found.poses].reshape(-1, 2, *slopes.shape[1:])
    size = np.abs(pose[:, 0, -2] * pose[:, 1, -1] - pose[:, 0, -1] * pose[:, 1, -2])  # greatest where pins meet
    (first, second) = np.take_along_axis(pose, size.argmax(axis=0)[None, None, None], axis=0)[0]
    a, b, c, d = first[-2], first[-1], second[-2], second[-1]
    follow = np.stack([b * second[:-2] - d * first[:-2], c * first[:-2] - a * second[:-2]]) / (a * d - b * c)
    own = slopes[:2, :-2] + np.einsum("kjn,jin->kin", slopes[:2, -2:], follow)
    return own, _free(found, values, slopes, way)[1]


ALONG = {"singular": _singular, "modes": _rim, "pins": _pins}
"""What tells of a kind of curve how it moves."""


def imprecise(region: Region, found: Errors, limit: float, steps: int = STEPS):  # type: ignore[no-untyped-def]
    """Where some pose's error is above a limit, as far as triangles of the mesh show it (Shapely, m)."""

    sheet, box = region.sheet, region.box
    made = meshes.mesh(sheet, box, steps)

    def above(q: Array) -> NDArray[np.bool_]:
        error = found(q)["error worst"]
        return ~(error <= limit)

    q, triangles, _ = meshes.cut(above, made.q, made.triangles)
    at = sheet.place(q)[0]
    return covered(at, triangles[np.isfinite(at).all(axis=0)[triangles].all(axis=1)])


def covered(at: Array, triangles: NDArray[np.intp]):  # type: ignore[no-untyped-def]
    """What triangles with their corners at places (2, n) cover, folded as they may be (Shapely): of the faces between
    the sides on which they end or fold back, those on which some triangle lies."""
    import shapely

    corners = at[:, triangles]
    (ax, bx, cx), (ay, by, cy) = corners[0].T, corners[1].T
    left = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 0
    sides = np.sort(meshes.sides_of(triangles), axis=1)
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
