"""Full turns of two drives: the values of one at which the other can go all round, by exact interval ends.

While one drive goes round, the smallest radicand of each group (:meth:`Dyad.radicand`) is at a root of its exact rate,
found between brackets of a grid; its zeros over the other drive's values are the ends of the intervals.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.rows import Determinant, Radicand
from linkwright.kernels import KERNELS
from linkwright.model.quantities import Quantities
from linkwright.results.stationary import bracketed
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Interval = tuple[float, float]

SLACK = 1e-13
"""A group closes with a room above -SLACK times the square of the mechanism's largest link: less is round-off."""
FIRST, MOST = 64, 512
"""The grids of both drives are doubled between these steps until the intervals stay the same ..."""
SAME = 1e-9
"""... to this share of the range."""
FAR = 2.0
"""No zero is looked for beside an extreme that is farther from it than so many times the steps to its neighbours."""
ZOOM, ZOOMS = 8, 14
"""An extreme lies between the neighbours of the best of so many steps; they are made finer so often."""


@dataclass(frozen=True)
class TurningValues:
    """The values of drive ``other`` (rad or m) at which ``drive`` goes through all of its range, a whole turn where it
    turns freely.

    ``mode`` has the branches, by group, on which that depends: none where it is the same in every mode. ``intervals``
    are in order; where ``other`` turns, one that passes the end of the range goes on beyond it. ``whole``: at every
    value of ``other``, so that both go through all of their ranges, whatever the other does.
    """

    drive: str
    other: str
    mode: Mapping[str, int]
    intervals: tuple[Interval, ...]
    whole: bool

    def as_dict(self, units: Quantities) -> dict[str, Any]:
        """As plain data, the intervals in the unit of ``other``."""
        unit, size = units.drive_unit(self.other)
        intervals = [[low / size, high / size] for low, high in self.intervals]
        found = {"drive": self.drive, "other": self.other, "mode": dict(self.mode), "unit": unit}
        return {**found, "intervals": intervals, "whole": self.whole}


def turnings(sheets: Sequence[ModeSheet], box: DriveBox) -> list[TurningValues]:
    """Both drives of a mechanism, one after the other, in each of its modes that differ in this."""
    found: list[TurningValues] = []
    for k in (0, 1):
        for sheet in sheets:
            margin = _Margin(sheet, box, k)
            if not any(one.drive == sheet.drives[k] and one.mode == margin.mode for one in found):
                found.append(_turning(sheet, box, k, margin))
    return found


def _turning(sheet: ModeSheet, box: DriveBox, k: int, margin: _Margin) -> TurningValues:
    low, high = box.low[1 - k], box.high[1 - k]
    last: list[Interval] = []
    steps = FIRST
    while True:
        intervals, whole = positive(margin.least(steps), low, high, box.turns[1 - k], steps)
        same = len(last) == len(intervals) and np.allclose(last, intervals, rtol=0, atol=SAME * (high - low))
        if (same and steps > FIRST) or 2 * steps > MOST:
            break
        last, steps = intervals, 2 * steps
    return TurningValues(sheet.drives[k], sheet.drives[1 - k], margin.mode, tuple(intervals), whole)


class _Margin:
    """How far all groups of a sheet are from not closing while drive ``k`` goes through its range."""

    def __init__(self, sheet: ModeSheet, box: DriveBox, k: int) -> None:
        graph, groups = sheet.compiled.graph, sheet.compiled.structure.groups
        self.sheet, self.k, self.low, self.high = sheet, k, box.low[k], box.high[k]
        self.rate = graph.drives.index(sheet.drives[k]) * graph.width + 1
        self.size = graph.size
        rooms = [Radicand(group.label) for group in groups if group.modes > 1]
        slides = [Determinant(group.label) for group in groups if group.modes == 1]
        self.rooms, self.count = len(rooms), len(rooms) + len(slides)
        self.mode: dict[str, int] = {}
        if self.count:
            program = graph.program((*rooms, *slides), rates=True)
            self.engine, used = KERNELS[sheet.kernel](program), program.used[0]
            branches = zip(graph.branched, sheet.branches, strict=True)
            rows = {group.label: int(sign) for group, sign in branches}
            self.mode = {g: s for g, s in rows.items() if graph.inputs.index(f"branch:{g}") in used}

    def rows(self, turned: Array, held: Array) -> tuple[Array, Array]:
        """Rooms, then determinants, then these with the other sign, over the drives' values (n,), with their rates by
        the one that is turned: (rows, n) both, negative where the mechanism doesn't close."""
        x = self.sheet.inputs(np.stack([turned, held][:: 1 if self.k == 0 else -1]))
        x[self.rate] = 1.0
        with np.errstate(all="ignore"):
            y = self.engine.run(x, self.sheet.parameters).reshape(self.count, 2, -1)
        rooms, slides = y[: self.rooms] / self.size**2, y[self.rooms :]
        values = np.concatenate([rooms[:, 0], slides[:, 0] - 2 * SLACK, -slides[:, 0] - 2 * SLACK])
        return values, np.concatenate([rooms[:, 1], slides[:, 1], -slides[:, 1]])

    def least(self, steps: int) -> Callable[[Array], Array]:
        """The margin over values (n,) of the other drive, on a grid of so many steps: (n,), positive where it goes."""
        grid = np.linspace(self.low, self.high, steps + 1)

        def margin(held: Array) -> Array:
            if not self.count:
                return np.ones(held.size)
            turned, other = np.repeat(grid, held.size), np.tile(held, grid.size)
            values, slopes = (part.reshape(-1, grid.size, held.size) for part in self.rows(turned, other))
            best = np.fmin.reduce(values, axis=1)
            row, before, at = np.nonzero((slopes[:, :-1] < 0) & (slopes[:, 1:] > 0))

            def slope(turned: Array, which: NDArray[np.intp]) -> Array:
                return np.asarray(self.rows(turned, held[at[which]])[1][row[which], np.arange(which.size)])

            where = bracketed(slope, np.arange(row.size), grid[before], grid[before + 1])
            np.fmin.at(best, (row, at), self.rows(where, held[at])[0][row, np.arange(row.size)])
            return self.combined_margin(best)

        return margin

    def combined_margin(self, best: Array) -> Array:
        """The margins of all rows (rows, n) as one (n,): a determinant keeps its sign, whichever it is."""
        rooms, ahead, behind = best[: self.rooms], best[self.rooms : self.count], best[self.count :]
        margins = np.concatenate([rooms, np.fmax(ahead, behind)])
        return np.asarray(np.nan_to_num(np.fmin.reduce(margins), nan=-1.0, neginf=-1.0))


def positive(
    f: Callable[[Array], Array], low: float, high: float, turns: bool, steps: int
) -> tuple[list[Interval], bool]:
    """The intervals of ``low`` .. ``high`` in which f isn't negative but for round-off, and whether they are all of it;
    with ``turns``, both ends are one place."""
    q = np.linspace(low, high, steps + 1)
    g = f(q)
    extra, values = _extremes(f, q, g, turns)
    q, g = np.concatenate([q, extra]), np.concatenate([g, values])
    order = np.argsort(q, kind="stable")
    q, g = q[order], g[order]
    yes = g >= -SLACK
    if yes.all():
        return [(low, high)], True
    if not yes.any():
        return [], False
    turn = np.flatnonzero(yes[:-1] != yes[1:])
    slack = np.where(np.maximum(g[turn], g[turn + 1]) < 0, SLACK, 0.0)  # where it only comes near zero
    ends = bracketed(lambda t, i: f(t) + slack[i], np.arange(turn.size), q[turn], q[turn + 1]).tolist()
    starts = [end for end, i in zip(ends, turn, strict=True) if yes[i + 1]]
    stops = [end for end, i in zip(ends, turn, strict=True) if yes[i]]
    if turns and yes[0] and yes[-1]:
        stops = [*stops[1:], stops[0] + high - low]
    else:
        starts, stops = [low] * bool(yes[0]) + starts, stops + [high] * bool(yes[-1])
    return list(zip(starts, stops, strict=True)), False


def _extremes(f: Callable[[Array], Array], q: Array, g: Array, turns: bool) -> tuple[Array, Array]:
    """Places between those of a grid, with their values, at which f may have the other sign: extremes near zero."""
    low, size = q[0], q[-1] - q[0]
    if turns:
        q, g = np.concatenate([[q[-2] - size], q]), np.concatenate([[g[-2]], g])
    sign = np.where(g[1:-1] >= -SLACK, 1.0, -1.0)
    before, here, after = (sign * part for part in (g[:-2], g[1:-1], g[2:]))
    near = (here <= before) & (here <= after) & (here <= FAR * np.maximum(before - here, after - here))
    if not near.any():
        return np.empty(0), np.empty(0)
    first, last, sign, at = q[:-2][near], q[2:][near], sign[near], np.arange(near.sum())
    share = np.linspace(0.0, 1.0, ZOOM + 1)[:, None]
    for _ in range(ZOOMS):
        places = first + share * (last - first)
        values = (sign * f(places.ravel()).reshape(places.shape)).argmin(axis=0)
        found = places[values, at]
        first, last = places[np.maximum(values - 1, 0), at], places[np.minimum(values + 1, ZOOM), at]
    found = low + (found - low) % size if turns else found
    return found, f(found)
