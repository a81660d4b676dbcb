"""The workspace by subdivision: square cells of the plane, each proven to be reached or not, or left open.

At a place of the working point each pose of the mechanism has functions that must all be positive: the radicands of its
dyads and the distances of its drives from the ends of their ranges. Enclosures bound these functions over a whole cell.
A cell is *reached* if one pose has all of them positive all over it, and *not reached* if every pose has a negative
one. Other cells are cut into four, down to a size, and further only where the edge of the region doesn't pass as one
line.

The reached share of open cells is bounded by linear functions with a remainder (mean value form: Moore, Kearfott,
Cloud, Introduction to Interval Analysis, 2009, ch. 6). So the area is enclosed, whatever curves are drawn.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.enclosures.angles import numbered
from linkwright.enclosures.forms import AffineForm
from linkwright.studies.workspace.places import ModePlaces

Array = NDArray[np.float64]
Rows = NDArray[np.intp]
Mask = NDArray[np.bool_]

COARSE = 3
"""The plane is cut so often before anything is decided ..."""
FINE = 8
"""... and the region's extent into two to this power cells along a side, before ..."""
DEEP = 12
"""... cells that more than one line may pass are halved so many times more, ..."""
SHARP = 0.02
"""... or of which more than this share is left open, ..."""
MOST = 250_000
"""... as long as they are no more than that, ..."""
HEAVY = 6
"""... or with a triad, where each cell takes far longer, than this share of it, ..."""
CLEAR = 4.0
"""The edge is one line where all that bounds it grows along one direction, by so many times what its forms leave open,
..."""
BLUNT = 0.5
"""... and within 60 degrees of that direction, so that its corners are blunt."""
DEEPEST = 21
"""The whole square is halved no more often than that: what is narrower than a two-millionth of it isn't told."""
FEW, LITTLE = 400, 5e-4
"""... and of more than so many as long as more than this share of the area of all is open, ..."""
ENOUGH = 4.0
"""... with a triad, so many times that."""


CORNERS = np.array([[-1.0, 1.0, -1.0, 1.0], [-1.0, -1.0, 1.0, 1.0]])
"""A square's corners ..."""
SIDES = np.array([[0, 1], [0, 2], [1, 3], [2, 3]])
"""... and its sides by these."""


@dataclass
class Cells:
    """Square cells: the corner (m) and side (m) of the whole, numbers (2, n) and ``level`` (n,) of each."""

    corner: Array
    side: float
    number: Rows
    level: Rows

    @property
    def size(self) -> Array:
        """The sides (m): (n,)."""
        return self.side * 2.0 ** -self.level.astype(float)

    @property
    def low(self) -> Array:
        """The lower left corners: (2, n)."""
        return self.corner[:, None] + self.number * self.size

    @property
    def high(self) -> Array:
        """The upper right corners; those of neighbours are the same numbers."""
        return self.corner[:, None] + (self.number + 1) * self.size

    @property
    def middle(self) -> Array:
        """The centres."""
        return self.corner[:, None] + (self.number + 0.5) * self.size

    def subset(self, which: Mask | Rows | slice) -> Cells:
        """Some of the cells."""
        return Cells(self.corner, self.side, self.number[:, which], self.level[which])

    def quarters(self) -> Cells:
        """Each cut into four, which follow each other."""
        number = np.repeat(2 * self.number, 4, axis=1)
        number += np.tile([[0, 1, 0, 1], [0, 0, 1, 1]], self.level.size)
        return Cells(self.corner, self.side, number, np.repeat(self.level + 1, 4))


def merge_cells(parts: list[Cells]) -> Cells:
    """Several sets of cells of one square as one."""
    number = np.concatenate([part.number for part in parts], axis=1)
    return Cells(parts[0].corner, parts[0].side, number, np.concatenate([part.level for part in parts]))


@dataclass(frozen=True)
class LinearForms:
    """Linear forms over cells, by pairs of a cell, numbered ``of`` (pairs,), and a pose that may reach it: ``value``
    and ``rest`` (functions, pairs), ``slope`` (2, functions, pairs); coordinates run from -1 to 1 over the cell.
    Functions that are positive all over it are left as 1."""

    of: Rows
    value: Array
    rest: Array
    slope: Array

    @property
    def arrays(self) -> tuple[Array, Array, Array]:
        """The forms alone."""
        return self.value, self.rest, self.slope

    def tells(self, cell: Rows, start: Array, stop: Array) -> NDArray[np.int8]:
        """Of lines in cells, (n,), from ``start`` to ``stop`` (2, n) in their coordinates: 1 for those that are reached
        all along, -1 for those that aren't anywhere, 0 where that is undecided."""
        order = np.argsort(self.of, kind="stable")
        first = np.searchsorted(self.of[order], cell)
        count = np.searchsorted(self.of[order], cell, side="right") - first
        line = np.repeat(np.arange(cell.size), count)
        pair = order[numbered(count) + np.repeat(first, count)]
        value, rest, slope = self.value[:, pair], self.rest[:, pair], self.slope[:, :, pair]
        # Evaluate the linear bounds of every pose at both ends of its line.
        ends = [value + (slope * at[:, None, line]).sum(axis=0) for at in (start, stop)]
        # The forms are straight: what holds at both ends holds between.
        above = (np.minimum(*ends) > rest).all(axis=0)
        below = (np.maximum(*ends) < -rest).any(axis=0)
        # A line is reached if one pose reaches it; it is not if no pose does; else undecided.
        found = np.full(cell.size, -1, dtype=np.int8)
        np.maximum.at(found, line, np.where(above, 1, np.where(below, -1, 0)).astype(np.int8))
        return found


@dataclass
class Decided:
    """What is decided of the plane: cells that are ``reached``, that are ``never``, and ``open`` ones. Of these
    ``least`` and ``most`` (n,) bound the share that is reached; ``forms`` are their functions. ``edge`` are the cells
    of all that isn't decided in which the region's edge is to be traced: larger where it is one line."""

    reached: Cells
    never: Cells
    open: Cells
    edge: Cells
    least: Array
    most: Array
    forms: LinearForms

    @property
    def area(self) -> tuple[float, float]:
        """The area (m2) of the region lies between these."""
        inner = float((self.reached.size**2).sum())
        own = self.open.size**2
        slack = 1e-13 * (inner + float(own.sum()))  # the sums' own round-off
        return inner + float((self.least * own).sum()) - slack, inner + float((self.most * own).sum()) + slack


def decided(places: ModePlaces, corner: Array, side: float, extent: float, deep: int = DEEP) -> Decided:
    """The square of a ``side`` from a ``corner`` (2,), in which all of a region of some ``extent`` (m) lies; cells are
    halved at most ``deep`` times more than everywhere along the edge."""
    axis = np.arange(2**COARSE)
    cells = Cells(corner, side, np.stack(np.meshgrid(axis, axis)).reshape(2, -1), np.full(4**COARSE, COARSE))
    fine = int(np.ceil(np.log2(side / extent))) + FINE
    little = LITTLE if places.poses_each == 1 else ENOUGH * LITTLE
    return _divide_cells(places, cells, fine, min(fine + deep, DEEPEST), little)


def cut_on(places: ModePlaces, found: Decided, which: Mask) -> Decided:
    """The same with some of the open cells cut on; the edge is traced in the same cells."""
    # Keep the cells that are not chosen, with renumbered bounds; subdivide the others level by level.
    rest = found.open.subset(~which)
    kept = ~which[found.forms.of]
    number = np.cumsum(~which) - 1
    forms = LinearForms(number[found.forms.of[kept]], *(part[..., kept] for part in found.forms.arrays))
    made = [Decided(found.reached, found.never, rest, found.edge, found.least[~which], found.most[~which], forms)]
    for level in np.unique(found.open.level[which]):
        some = found.open.subset(which & (found.open.level == level)).quarters()
        made.append(_divide_cells(places, some, int(level) + 1, min(int(level) + DEEP, DEEPEST), 0.0))
    return _merge_decided(made, found.edge)


def _merge_decided(parts: list[Decided], edge: Cells) -> Decided:
    """What is decided of several parts of the plane."""
    first = np.cumsum([0, *(part.open.level.size for part in parts)])
    of = np.concatenate([part.forms.of + start for part, start in zip(parts, first, strict=False)])
    arrays = (np.concatenate(some, axis=-1) for some in zip(*(part.forms.arrays for part in parts), strict=True))
    reached, never, open_ = (
        merge_cells([getattr(part, name) for part in parts]) for name in ("reached", "never", "open")
    )
    least, most = (np.concatenate([getattr(part, name) for part in parts]) for name in ("least", "most"))
    return Decided(reached, never, open_, edge, least, most, LinearForms(of, *arrays))


def _divide_cells(places: ModePlaces, cells: Cells, fine: int, deep: int, little: float) -> Decided:
    """Cells of one level, cut into four until they are decided; from level ``fine`` on only where the edge isn't one
    line, down to level ``deep`` or until no more than a share ``little`` of the area is open."""
    count, empty = len(places.branches), cells.subset(slice(0, 0))
    # Start with every combination of cell and branch (sign pattern of the dyads' roots).
    of, branch = np.repeat(np.arange(cells.level.size), count), np.tile(np.arange(count), cells.level.size)
    reached, never, edge, made = [empty], [empty], [empty], [_nothing(empty, len(places.rows))]
    most_cells = MOST if places.poses_each == 1 else MOST // HEAVY
    traced, area, undecided = np.zeros(cells.level.size, dtype=bool), 0.0, 0.0
    while cells.level.size:
        level, size = int(cells.level[0]), float(cells.size[0])
        # Bound the closure and range functions over each cell by linear forms with a rigorous remainder.
        linear, pair = places.forms(cells.middle[:, of], np.full(of.size, size / 2), branch)
        of, branch = of[pair], branch[pair]
        forms = _Forms(linear, of, cells.level.size)
        # Decided: all functions of one pose positive means reached; one function of every pose negative means
        # unreachable.
        reached.append(cells.subset(forms.reached))
        never.append(cells.subset(~forms.alive))
        area += size**2 * int(forms.reached.sum())
        # Undecided cells continue, with the poses that may still reach them.
        going = forms.alive & ~forms.reached
        kept = going[of] & ~forms.dead
        if level >= fine:
            # Near the edge: bound the share of the cell that is reached, so that cells crossed by a single straight
            # edge need not be subdivided to the end.
            least, most = forms.shares(kept)
            none = going & (most <= 0)
            never.append(cells.subset(none))
            going &= ~none
            kept &= going[of]
            # A cell is good enough if its edge is one line and its area is known sharply.
            plain = forms.plain(kept)
            rest = going & ~(plain & (most - least < SHARP))
            more, left = int(rest.sum()), undecided + float((most - least)[going].sum()) * size**2
            # Stop at the deepest level, if there would be too many cells, or if little area is left open.
            last = level >= deep or 4 * more > most_cells or (more > FEW and left < little * area)
            # Cells that stay open keep their bounds; the tracing of the edge uses the largest cells that hold one
            # line.
            stays = going if last else going & ~rest
            drawn = going & ~traced & (plain | stays)
            edge.append(cells.subset(drawn))
            traced |= drawn
            open_ = cells.subset(stays)
            made.append(Decided(empty, empty, open_, empty, least[stays], most[stays], forms.straight(kept, stays)))
            undecided += float((most - least)[stays].sum()) * size**2
            going &= ~stays
            kept &= going[of]
        # Subdivide: renumber the surviving combinations, cut each cell into four and give each quarter its poses.
        of, branch = np.divmod(np.unique((np.cumsum(going) - 1)[of[kept]] * count + branch[kept]), count)
        cells, traced = cells.subset(going).quarters(), np.repeat(traced[going], 4)
        of, branch = (4 * of[:, None] + np.arange(4)).ravel(), np.repeat(branch, 4)
    found = _merge_decided(made, merge_cells(edge))
    found.reached, found.never = merge_cells(reached), merge_cells(never)
    return found


def _nothing(empty: Cells, functions: int) -> Decided:
    none = LinearForms(
        np.empty(0, dtype=np.intp), np.empty((functions, 0)), np.empty((functions, 0)), np.empty((2, functions, 0))
    )
    return Decided(empty, empty, empty, empty, np.empty(0), np.empty(0), none)


class _Forms:
    """The functions of pairs of a cell, numbered ``of``, and a branch as linear forms over the cell.

    A function is ``open`` where its sign isn't known all over the cell; a pair ``dead`` where one is negative.
    """

    def __init__(self, forms: AffineForm, of: Rows, count: int) -> None:
        self.of, self.count = of, count
        # Functions without finite bounds are treated as unknown: value 0, remainder infinite.
        low, high = forms.bounds
        self.known = np.isfinite(low) & np.isfinite(high)
        self.value, self.rest = np.where(self.known, forms.value, 0.0), np.where(self.known, forms.rest, np.inf)
        self.slope = np.where(self.known, np.stack([forms.u, forms.v]), 0.0)
        self.open = ~((low > 0) | (high < 0))
        self.dead = (high < 0).any(axis=0)
        self.reached, self.alive = np.zeros(count, dtype=bool), np.zeros(count, dtype=bool)
        self.reached[of[(low > 0).all(axis=0)]] = True
        self.alive[of[~self.dead]] = True

    def plain(self, kept: Mask) -> Mask:
        """In which cells all open functions of the pairs ``kept`` grow along one direction, by more than what their
        forms leave open: (cells,). Then the region's edge is one line, at that width."""
        open_ = self.open & kept
        with np.errstate(all="ignore"):
            unit = np.where(open_ & self.known, self.slope / np.hypot(*self.slope), 0.0)
        # Mean direction of the gradients of all functions of unknown sign in each cell.
        way = np.zeros((2, self.count))
        for k in range(2):
            np.add.at(way[k], self.of, np.nan_to_num(unit[k]).sum(axis=0))
        with np.errstate(all="ignore"):
            way = way / np.hypot(*way)
            # Every one of them must grow along it by more than its remainder: then their zero lines form one
            # connected edge.
            along = (way[:, self.of][:, None] * self.slope).sum(axis=0)
            grows = (along > CLEAR * self.rest) & (along > BLUNT * np.hypot(*self.slope))
        bad = (open_ & ~grows).any(axis=0)
        found = np.ones(self.count, dtype=bool)
        found[self.of[bad]] = False
        return found

    def shares(self, kept: Mask) -> tuple[Array, Array]:
        """Bounds of the share of each cell that is reached: (cells,) both."""
        pairs = np.flatnonzero(kept)
        of, count = self.of[pairs], self.count
        value, rest, slope = self.value[:, pairs], self.rest[:, pairs], self.slope[:, :, pairs]
        open_, known = self.open[:, pairs], self.known[:, pairs]
        # Lower bound per function from value - remainder, upper bound from value + remainder.
        sure = np.where(open_, np.where(known, _share(value - rest, slope), 0.0), 1.0)
        may = np.where(open_ & known, _share(value + rest, slope), 1.0)
        least, most = np.zeros(count), np.zeros(count)
        # A pose reaches at least 1 less the sum of what its functions may exclude; the best pose counts.
        np.maximum.at(least, of, np.maximum(1.0 - (1.0 - sure).sum(axis=0), 0.0))
        # Poses that differ behind a root share it: what it leaves counts once.
        which, row = may.argmin(axis=0), np.arange(pairs.size)
        own, off = value[which, row], rest[which, row]
        order = np.lexsort((off, own, which, of))
        told = np.stack([of, which, own, off])[:, order]
        new = order[np.append(True, (told[:, 1:] != told[:, :-1]).any(axis=0))] if order.size else order
        np.add.at(most, of[new], may[which[new], new])
        return least, np.minimum(most, 1.0)

    def straight(self, kept: Mask, stays: Mask) -> LinearForms:
        """The forms of the cells that stay."""
        pairs = np.flatnonzero(kept & stays[self.of])
        number = np.cumsum(stays) - 1
        open_ = self.open[:, pairs]
        value, rest = np.where(open_, self.value[:, pairs], 1.0), np.where(open_, self.rest[:, pairs], 0.0)
        return LinearForms(number[self.of[pairs]], value, rest, np.where(open_, self.slope[:, :, pairs], 0.0))


def _share(value: Array, slope: Array) -> Array:
    """The share of the square from -1 to 1 in which value + slope . (u, v) is positive."""
    with np.errstate(all="ignore"):
        # Area cut off a square by a straight line, by how the line passes: across opposite sides, across a corner, or
        # not at all.
        p, q = np.maximum(*np.abs(slope)), np.minimum(*np.abs(slope))
        straight = 0.5 + value / (2 * p)
        corner = (p + q - np.abs(value)) ** 2 / (8 * p * q)
        found = np.where(np.abs(value) <= p - q, straight, np.where(value > 0, 1 - corner, corner))
        found = np.where(np.abs(value) >= p + q, (value > 0).astype(float), found)
    return np.clip(np.where(np.isnan(found), np.where(value > 0, 1.0, 0.0), found), 0.0, 1.0)


def key(at: Any) -> Any:
    """One number for each corner of a fine grid, (2, ...)."""
    return (at[0] << 32) | at[1]


def known_corners(cells: Cells, deepest: int) -> Rows:
    """The keys of the corners of cells, and of those that they were cut from, down to the size of the largest; on a
    grid of the ``deepest`` level."""
    number, level, found = cells.number, cells.level, []
    while number.shape[1]:
        unit = 2 ** (deepest - level)
        found.append(np.concatenate([key((number + np.array([[i], [k]])) * unit) for i in (0, 1) for k in (0, 1)]))
        above = level > cells.level.min()
        _, first = np.unique(key(number[:, above] // 2) + (level[above] << 58), return_index=True)
        number, level = number[:, above][:, first] // 2, level[above][first] - 1
    return _sorted(np.concatenate(found)) if found else np.empty(0, dtype=int)


def _sorted(keys: Rows) -> Rows:
    """Different keys in order; sooner done so than by NumPy's hashes."""
    keys = np.sort(keys)
    return keys[np.append(True, keys[1:] != keys[:-1])] if keys.size else keys


def among(keys: Rows, known: Rows) -> Mask:
    """Which keys are among some that are in order."""
    if not known.size:
        return np.zeros(keys.shape, dtype=bool)
    at = np.minimum(np.searchsorted(known, keys), known.size - 1)
    return np.asarray(known[at] == keys)


def cut_sides(cells: Cells, deepest: int, known: Rows) -> tuple[Rows, Rows, Rows, Rows]:
    """The sides of cells cut at corners known by their keys, on a grid of the ``deepest`` level: their starts and ends
    (2, n), the cells (n,) and which of the :data:`SIDES` of each it is a piece of."""
    # Corners as integers on the finest grid, so that equal corners compare exactly.
    unit = 2 ** (deepest - cells.level)
    ends = (cells.number[:, None] + (CORNERS[:, :, None] > 0)) * unit  # (2, 4, cells)
    start, stop = (ends[:, corner].reshape(2, -1) for corner in SIDES.T)
    own, which = np.tile(np.arange(unit.size), len(SIDES)), np.repeat(np.arange(len(SIDES)), unit.size)
    done: list[tuple[Rows, Rows, Rows, Rows]] = []
    while own.size or not done:
        # Halve sides as long as a smaller neighbour has a corner in the middle.
        middle = (start + stop) // 2
        cut = (np.abs(stop - start).max(axis=0) > 1) & among(key(middle), known)
        done.append((start[:, ~cut], stop[:, ~cut], own[~cut], which[~cut]))
        start, stop = (
            np.concatenate([start[:, cut], middle[:, cut]], axis=1),
            np.concatenate([middle[:, cut], stop[:, cut]], axis=1),
        )
        own, which = np.tile(own[cut], 2), np.tile(which[cut], 2)
    first, last, cell, side = (np.concatenate(part, axis=-1) for part in zip(*done, strict=True))
    return first, last, cell, side
