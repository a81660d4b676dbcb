"""What tolerances leave of a workspace: the part of a region that is sure.

With c_i = dF/dp_i of the working point F at given drive values (:mod:`errors`), the boundary of a region moves along
its normal n by the sum of n . c_i d_i: how the drive values of the boundary move doesn't count there
(envelope theorem: Danskin, SIAM Journal on Applied Mathematics 14, 1966, 641-664). On the rim, where two modes meet,
c_i is taken along it, at constant reach, as it grows without bound at given drive values. A clearance of which the
displacements e are of any direction moves it by no more than that times the length of all n . dF/de.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.workspace import mesh as meshes
from linkwright.studies.workspace.causes import Causes
from linkwright.studies.workspace.coverage import covered
from linkwright.studies.workspace.errors import STEPS, Errors
from linkwright.studies.workspace.mesh import Mesh
from linkwright.studies.workspace.regions import Region

Array = NDArray[np.float64]

ROUND = 8
"""Strips end round, in so many pieces a quarter of a turn; they are wider by what these lack."""
THIN = 0.05
"""Parts narrower than about this share of a step of the mesh, over the region's extent, are left out."""
ROUGH = 0.01
"""Segments of the boundary are one where their strips' widths differ by no more than this share of the widest."""
BESIDE = 1e-6
"""Curves within this share of the region's extent from its boundary bound it."""
AWAY = 2.0**15
"""How much farther from a pit than its innermost ring the shifts are looked at: the direction alone matters."""


@dataclass(frozen=True)
class Guaranteed:
    """What is sure of a region, to first order, for all deviations within their limits and all displacements within
    clearances at once.

    ``shape`` (Shapely, m) is reached whatever they are. ``precise`` is the part of it in which the point is off by no
    more than ``limit`` (m) in all poses of the sheet that come there; None where no limit was asked for. ``least`` and
    ``most`` are the smallest and the greatest way that the boundary may move inward (m), NaN where there is none.
    """

    region: Region
    shape: Any
    least: float
    most: float
    limit: float | None = None
    precise: Any | None = None


def guaranteed(region: Region, causes: Causes, limit: float | None = None, steps: int = STEPS) -> Guaranteed:
    """The guaranteed part of a region; ``limit`` of the point's error is looked for on a mesh of ``steps``."""
    import shapely

    found = Errors(region.sheet, causes, sum(one.a.shape[1] for one in region.segments))
    made = edges(region, found)
    width = np.concatenate([one.width for one in made]) if made else np.array([np.nan])
    shape = shapely.difference(region.shape, shapely.union_all(_strips(region, made))) if made else region.shape
    precise = None
    if limit is not None:
        parts = shapely.get_parts(shapely.difference(shape, imprecise(region, found, limit, steps)))
        thin = THIN / steps * float(np.ptp(np.reshape(region.shape.bounds, (2, 2)), axis=0).max())
        precise = shapely.union_all(parts[shapely.area(parts) > thin * shapely.length(parts)])
    return Guaranteed(region, shape, float(np.min(width)), float(np.max(width)), limit, precise)


def _strips(region: Region, made: Sequence[BoundaryEdge]) -> Any:
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
        kept = _corners_to_keep(ring, cut)
        kept[1:-1] |= level[1:] != level[:-1]
        stops = np.flatnonzero(kept)
        lines.append(
            shapely.linestrings(np.stack([ring[:, stops[:-1]], ring[:, stops[1:]]], axis=2).transpose(1, 2, 0))
        )
        widths.append(np.maximum.reduceat(own, stops[:-1]) + cut)
        first += count
    wide = np.concatenate(widths) / np.cos(np.pi / 4 / ROUND)
    return shapely.buffer(np.concatenate(lines), wide, quad_segs=ROUND)


def _corners_to_keep(ring: Array, cut: float) -> NDArray[np.bool_]:
    """Which corners of a closed line (2, n) are left where others may be ``cut`` off: by Douglas and Peucker."""
    import shapely

    left = {
        tuple(place) for place in shapely.get_coordinates(shapely.simplify(shapely.linestrings(ring.T), cut)).tolist()
    }
    kept = np.array([tuple(place) in left for place in ring.T.tolist()])
    kept[[0, -1]] = True
    return kept


def _rings(shape: Any) -> Any:
    """The boundary's rings; the shape lies to their left."""
    import shapely

    return shapely.get_parts(shapely.boundary(shapely.orient_polygons(shape)))


@dataclass(frozen=True)
class BoundaryEdge:
    """The boundary's pieces that lie on one kind of curve.

    ``ends`` (2, 2, n) are their places: coordinate, end, piece; ``outward`` (2, n) their unit normals. ``shifts``
    (columns, 2, n) is how far either end moves outward per unit of each cause, ``width`` (n,) how far inward at worst
    (m); ``segment`` (n,) numbers the boundary's segments, which may lie on several curves.
    """

    kind: str
    ends: Array
    outward: Array
    shifts: Array
    width: Array
    segment: NDArray[np.intp]


def edges(region: Region, found: Errors) -> list[BoundaryEdge]:
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
            seen = move_off_pits(region.mesh, seen) if one.kind == "pins" else seen
            shifts = edge_shifts(found, one.kind, seen, outward[:, which[of]], of_used)
            width = np.fmax.reduce(np.maximum(found.causes.most(-shifts), 0.0))
            width[np.isnan(width)] = np.fmax.reduce(width)
            made.append(BoundaryEdge(one.kind, ends[:, :, which[of]], outward[:, which[of]], shifts, width, which[of]))
    return made


def move_off_pits(mesh: Mesh, drives: Array) -> Array:
    """Drive values (2, 2, n) so near to pits that derivatives have no digits left, moved away from them."""
    corners = np.unique(mesh.pits)
    before = corners - corners.size  # the mesh's rings, each half as wide as the one before, follow each other
    centres = 2 * mesh.q[:, corners] - mesh.q[:, before]
    far = np.hypot(*(drives[:, :, :, None] - centres[:, None, None]))
    centre = centres[:, far.argmin(axis=2)]
    return np.asarray(centre + AWAY * (drives - centre))


def edge_shifts(found: Errors, kind: str, drives: Array, outward: Array, of: NDArray[np.intp] | None = None) -> Array:
    """How far the ends of pieces (2, 2, n): coordinate, end, piece, in the drives' plane, move along their own normals,
    which point about as ``outward`` (2, n) does, per unit of each cause: (columns, 2, n). With ``of`` (m,) the
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
"""How the place of a boundary goes with the causes, (2, columns, n), and its direction (2, n), of any size."""


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


def imprecise(region: Region, found: Errors, limit: float, steps: int = STEPS) -> Any:
    """Where some pose's error is above a limit, as far as triangles of the mesh show it (Shapely, m)."""

    sheet, box = region.sheet, region.box
    pits = meshes.found_pits(sheet, box) if region.mesh.pits.size else None
    made = meshes.mesh(sheet, box, steps, pits)

    def above(q: Array) -> NDArray[np.bool_]:
        error = found(q)["error worst"]
        return ~(error <= limit)

    q, triangles, _ = meshes.cut_triangles(above, made.q, made.triangles)
    at = sheet.place(q)[0]
    return covered(at, triangles[np.isfinite(at[:, triangles]).all(axis=(0, 2))])
