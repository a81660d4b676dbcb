"""What is proven of a region: its area between two bounds, its parts and holes; and what contradicts its shape.

The cells (:mod:`linkwright.studies.workspace.cells`) know nothing of the shape that is drawn, nor do the values of the
drives at random, mapped forward. A part or hole is sure if it has a decided cell, and if the counts stay what they are
when all that is open is given to the region, and when it is taken from it.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.workspace.cells import (
    DEEPEST,
    Cells,
    Decided,
    among,
    cut_on,
    cut_sides,
    key,
    known_corners,
    merge_cells,
)
from linkwright.studies.workspace.places import ModePlaces
from linkwright.studies.workspace.shapes import figures

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

ENCLOSED, SEARCHED = "enclosed", "searched"
OPEN = 0.01
"""A region of whose area more than this share is open isn't certified."""
BESIDE = 4.0
"""The edge may run into a decided cell by so many chords."""
ROUNDS = 2
"""Open cells that may be parts or holes by themselves are cut on so often."""
BACK = 400
"""So many places are mapped back and forth ..."""
CLOSE = 1e-9
"""... and come back within this share of the region's extent."""


@dataclass(frozen=True)
class Contradiction:
    """What contradicts a region: which ``kind`` of contradiction, of what ``size`` (m2, m, a share), and where (m)."""

    kind: str
    size: float
    at: tuple[float, float]


@dataclass(frozen=True)
class RegionCertificate:
    """``area`` (m2) holds the region's area between two bounds; ``parts`` and ``holes`` say whether these counts are
    sure, but for parts and holes narrower than ``finest`` (m)."""

    grade: str
    area: tuple[float, float] | None = None
    parts: bool = False
    holes: bool = False
    finest: float = 0.0
    faults: tuple[Contradiction, ...] = ()

    @property
    def certified(self) -> bool:
        """Whether the area is enclosed and nothing contradicts the shape."""
        return self.grade == ENCLOSED and not self.faults

    @property
    def open(self) -> float | None:
        """The area (m2) that is left open."""
        return None if self.area is None else self.area[1] - self.area[0]


UNPROVEN = RegionCertificate(SEARCHED)


def certified(places: ModePlaces, decided: Decided, shape: Any, chord: float) -> RegionCertificate:
    """The certificate of a shape."""
    parts, holes, doubtful = _count_parts_and_holes(decided)
    for _ in range(ROUNDS):
        if not doubtful.any():
            break
        decided = cut_on(places, decided, doubtful)
        parts, holes, doubtful = _count_parts_and_holes(decided)
    low, high = decided.area
    faults = [*_area(decided, shape, chord), *_cells(decided, shape, chord), *_back(places, decided, shape)]
    own = figures(shape)
    finest = decided.open.side * 2.0**-DEEPEST
    return RegionCertificate(ENCLOSED, (low, high), parts == own.parts, holes == own.holes, finest, tuple(faults))


def _area(decided: Decided, shape: Any, chord: float) -> list[Contradiction]:
    """The area beyond its bounds, or too much of it open."""
    low, high = decided.area
    slack, found = chord * shape.length, []
    off = max(low - shape.area - slack, shape.area - high - slack)
    where = _worst(decided)
    if off > 0:
        found.append(Contradiction("area", off, where))
    if high - low > OPEN * max(shape.area, low):
        found.append(Contradiction("open", high - low, where))
    return found


def _worst(decided: Decided) -> tuple[float, float]:
    """The middle of the cell that leaves most open."""
    left = (decided.most - decided.least) * decided.open.size**2
    if not left.size:
        return 0.0, 0.0
    x, y = decided.open.middle[:, int(left.argmax())].tolist()
    return x, y


def _cells(decided: Decided, shape: Any, chord: float) -> list[Contradiction]:
    """Decided cells that lie on the other side of the edge, and such into which it runs."""
    import shapely

    found = []
    shapely.prepare(shape)
    for cells, inside, kind in ((decided.reached, True, "left-out"), (decided.never, False, "too-much")):
        wrong = cells.subset(shapely.contains_xy(shape, *cells.middle) != inside)
        far = shapely.distance(shape.boundary, shapely.points(wrong.middle.T)) > BESIDE * chord
        wrong = wrong.subset(far if len(far) else slice(0, 0))
        if wrong.level.size:
            x, y = wrong.middle[:, int(wrong.size.argmax())].tolist()
            found.append(Contradiction(kind, float((wrong.size**2).sum()), (x, y)))
    cells = merge_cells([decided.reached, decided.never])
    margin = BESIDE * chord
    wide = cells.subset(cells.size > 4 * margin)
    corners = shapely.get_coordinates(shape).T
    within = _inside(wide, corners, margin)
    if within.any():
        x, y = corners[:, within][:, 0].tolist()
        found.append(Contradiction("edge", float(within.sum()), (x, y)))
    return found


def _inside(cells: Cells, at: Array, margin: float) -> Mask:
    """Which places (2, n) lie in one of some cells, by more than a margin."""
    found = np.zeros(at.shape[1], dtype=bool)
    for level in np.unique(cells.level):
        size = cells.side * 2.0 ** -float(level)
        number = np.floor((at - cells.corner[:, None]) / size).astype(np.int64)
        away = at - cells.corner[:, None] - number * size  # from the lower left corner
        deep = np.minimum(away, size - away).min(axis=0) > margin
        found |= deep & among(key(number), np.sort(key(cells.number[:, cells.level == level])))
    return found


def _back(places: ModePlaces, decided: Decided, shape: Any) -> list[Contradiction]:
    """Places of decided cells whose drive values lead elsewhere, or from which no pose comes back."""
    cells = decided.reached
    if not cells.level.size:
        return []
    some = np.random.default_rng(0).integers(0, cells.level.size, BACK)
    at = cells.low[:, some] + np.random.default_rng(1).uniform(0, 1, (2, BACK)) * cells.size[some]
    q, depth = places.drives(at)
    branch = depth.argmax(axis=0)
    values = q[branch, :, np.arange(BACK)].T
    back, reach = places.sheet.place(values)
    off = np.hypot(*(back - at))
    extent = max(shape.bounds[2] - shape.bounds[0], shape.bounds[3] - shape.bounds[1]) if not shape.is_empty else 0.0
    wrong = ~(off <= CLOSE * extent) & (reach > 1e-9)
    if not wrong.any():
        return []
    x, y = at[:, wrong][:, 0].tolist()
    return [Contradiction("back", float(wrong.mean()), (x, y))]


def _count_parts_and_holes(decided: Decided) -> tuple[int | None, int | None, Mask]:
    """How many parts and holes the region has, each ``None`` where that isn't sure; and which open cells hang together
    with no decided one that counts, so that a part or hole may be there."""
    cells = merge_cells([decided.reached, decided.never, decided.open])
    first, count = decided.reached.level.size, decided.reached.level.size + decided.never.level.size
    deepest = int(cells.level.max(initial=0))
    start, stop, cell, _ = cut_sides(cells, deepest, known_corners(cells, deepest))
    keys, ends = np.unique([key(start), key(stop)], return_inverse=True)
    ends = ends.reshape(2, -1)
    kind = np.where(cell < first, 1, np.where(cell < count, -1, 0))
    told, lines = kind.copy(), kind == 0
    unit = 2 ** (deepest - cells.level[cell[lines]])
    low = cells.number[:, cell[lines]] * unit
    own = [2 * (at[:, lines] - low) / unit - 1 for at in (start, stop)]
    told[lines] = decided.forms.tells(cell[lines] - count, *own)
    counts: list[int | None] = []
    doubtful = np.zeros(decided.open.level.size, dtype=bool)
    for way in (1, -1):
        sure = _marked(_hung(ends[:, told == way], keys.size)[ends[0, kind == way]], keys.size)
        may = (kind != -way) & ((kind != 0) | (cells.level[cell] < DEEPEST))
        most = _hung(ends[:, may], keys.size)[ends[0]]
        apart = may & ~_marked(most[kind == way], keys.size)[most]
        doubtful[cell[apart] - count] = True
        number, possible = (int(np.count_nonzero(some)) for some in (sure, _marked(most[may], keys.size)))
        counts.append(number if number == possible else None)
    parts, without = counts
    return parts, None if without is None else without - 1, doubtful


def _marked(which: Any, size: int) -> Mask:
    """A mask of some size that holds at some numbers."""
    found = np.zeros(size, dtype=bool)
    found[which] = True
    return found


def _hung(pairs: Any, size: int) -> Any:
    """To which set of corners that hang together by pairs (2, n) each of some corners belongs: (size,)."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    graph = coo_array((np.ones(pairs.shape[1], dtype=np.int8), (pairs[0], pairs[1])), shape=(size, size))
    return connected_components(graph, directed=False)[1]
