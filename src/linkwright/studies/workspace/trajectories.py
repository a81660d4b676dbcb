"""Trajectories of a sheet's working point while one drive is held at a constant value and the other one goes through
its range: by such pictures Peng and Zi (Journal of Mechanical Transmission 34(4), 2010) show the workspace of a
hybrid-driven five-bar. Neighbouring trajectories touch along limit positions of the output: folds of a region show as
envelopes.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.studies.workspace.coupler_curve import CurveStretch
from linkwright.studies.workspace.curves import distance
from linkwright.studies.workspace.mesh import DriveBox, halved
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

STEPS = 180
"""Equal steps of the moving drive's range, before they are refined."""
GOLDEN, SEARCHES = (np.sqrt(5.0) - 1.0) / 2, 45
"""So many steps of a golden section search leave 4e-10 of an interval."""
WITHIN = 0.9
"""Of the chord tolerance, as what lies between four places of a step is foretold, not looked at."""
SHARES = np.linspace(0, 1, 13)[1:-1]
CUBIC = np.stack([np.prod([(3 * SHARES - k) / (i - k) for k in range(4) if k != i], axis=0) for i in range(4)], axis=1)
"""The cubic through the ends and thirds of a step: (shares, 4) by which these are weighed."""
WHOLE = 1 - 1e-9
"""Of a range is all of it."""
LEAST = 1e-12
"""Steps below this share of a range aren't made finer ..."""
JUMP = 10.0
"""... and where they are still longer than so many chord tolerances, the point jumps: the pins of a dyad meet there."""


@dataclass(frozen=True)
class Trajectory:
    """The working point's trajectory at a constant value ``held`` of one drive (rad or m): ``stretches`` over values of
    the other one, broken where the mechanism can't be assembled. Where that drive turns fully, a stretch that passes
    the end of the range goes on beyond it."""

    held: float
    stretches: tuple[CurveStretch, ...]

    @cached_property
    def length(self) -> float:
        """The length of all stretches (m)."""
        return sum(one.length for one in self.stretches)


@dataclass(frozen=True)
class Trajectories:
    """The trajectories of one sheet at values of drive number ``hold`` (0 or 1) of its two; ``span`` (rad or m) is the
    range of the other one."""

    hold: int
    span: float
    each: tuple[Trajectory, ...]

    @property
    def length(self) -> float:
        """The length of all (m)."""
        return sum(one.length for one in self.each)

    @property
    def stretches(self) -> list[CurveStretch]:
        """The stretches of all."""
        return [stretch for one in self.each for stretch in one.stretches]

    @property
    def full_range_count(self) -> int:
        """At how many values the other drive goes through all of its range."""
        return sum(bool(one.q[-1] - one.q[0] >= WHOLE * self.span) for one in self.stretches)


def trajectories(sheet: ModeSheet, box: DriveBox, hold: int, values: Array, chord: float) -> Trajectories:
    """The trajectories at constant values (n,) of drive number ``hold`` while the other one goes through its range of
    ``box``. Their corners are exact; chords lie within ``chord`` (m) of the true curves."""
    slices = _Slices(sheet, box, hold, values)
    runs = slices.ended(slices.runs())
    q = np.concatenate([run.q for run in runs]) if runs else np.empty(0)
    number = np.repeat(np.arange(len(runs)), [run.q.size for run in runs])
    q, at, number = slices.refined(q, number, np.array([run.row for run in runs], dtype=np.intp), chord)
    kept: list[list[CurveStretch]] = [[] for _ in values]
    for i, run in enumerate(runs):
        mine = number == i
        kept[run.row] += _unbroken(CurveStretch(q[mine], at[:, mine], run.closed), slices.span, chord)
    each = tuple(Trajectory(float(v), tuple(some)) for v, some in zip(values, kept, strict=True))
    return Trajectories(hold, slices.span, each)


@dataclass(frozen=True)
class _Run:
    """Values ``q`` of the moving drive at which the mechanism closes, in row ``row``; ``before`` and ``after`` are the
    next ones at which it doesn't, where there are such. ``closed``: all of a whole turn."""

    row: int
    q: Array
    before: float | None
    after: float | None
    closed: bool


class _Slices:
    """Slices of a sheet: in each row the held drive has a value of its own."""

    def __init__(self, sheet: ModeSheet, box: DriveBox, hold: int, values: Array) -> None:
        self.sheet, self.hold, self.values = sheet, hold, values
        self.low, self.high, self.turns = box.low[1 - hold], box.high[1 - hold], box.turns[1 - hold]
        self.span = self.high - self.low

    def place(self, row: Rows, q: Array) -> tuple[Array, Array]:
        """The working point (2, n) and the reach (n,) at values of the moving drive in some rows."""
        held = self.values[row]
        at, reach = self.sheet.place(np.stack([held, q] if self.hold == 0 else [q, held]))
        return at, np.where((reach <= 0) | np.isfinite(at).all(axis=0), reach, -1.0)

    def runs(self) -> list[_Run]:
        """Where the mechanism closes, to the steps of a grid and to what is narrower than these."""
        grid, rows = np.linspace(self.low, self.high, STEPS + 1), np.arange(self.values.size)
        reach = self.place(np.repeat(rows, grid.size), np.tile(grid, rows.size))[1].reshape(rows.size, grid.size)
        if self.turns:
            reach[:, -1] = reach[:, 0]  # one place, whatever its round-off
        at, q = self._narrow(grid, reach)
        closes = self.place(at, q)[1] > 0
        found: list[_Run] = []
        for row in rows.tolist():
            more = at == row
            every = np.concatenate([grid, q[more]])
            order = np.argsort(every, kind="stable")
            found += self._row(row, every[order], np.concatenate([reach[row] > 0, closes[more]])[order])
        return found

    def _narrow(self, grid: Array, reach: Array) -> tuple[Rows, Array]:
        """Places between the steps of the grid at which the reach has another sign than on both sides: rows and values.
        They are at its least sizes, by golden section search (J. Kiefer, Proc. AMS 4 (1953) 502-506)."""
        step = grid[1] - grid[0]
        if self.turns:  # the place before the first is the last but one
            reach = np.concatenate([reach[:, -2:-1], reach], axis=1)
            grid = np.concatenate([[grid[0] - step], grid])
        size, side = np.abs(reach), reach > 0
        same = (side[:, :-2] == side[:, 1:-1]) & (side[:, 2:] == side[:, 1:-1])
        row, column = np.nonzero(same & (size[:, 1:-1] <= size[:, :-2]) & (size[:, 1:-1] <= size[:, 2:]))
        sign = np.where(side[row, column + 1], 1.0, -1.0)
        a, b = grid[column], grid[column + 2]
        for _ in range(SEARCHES if row.size else 0):
            c, d = b - GOLDEN * (b - a), a + GOLDEN * (b - a)
            first = sign * self.place(row, c)[1] < sign * self.place(row, d)[1]
            a, b = np.where(first, a, c), np.where(first, d, b)
        q = (a + b) / 2
        other = (self.place(row, q)[1] > 0) != (sign > 0)
        q = self.low + (q - self.low) % self.span if self.turns else q
        return row[other], q[other]

    def _row(self, row: int, q: Array, closes: NDArray[np.bool_]) -> Iterator[_Run]:
        """The runs of a row at rising values ``q``, where it is known whether the mechanism closes."""
        if self.turns and closes.all():
            yield _Run(row, q, None, None, closed=True)
            return
        if self.turns:  # begin where it doesn't close: no run is cut at the end of the turn
            first = int(np.argmin(closes))
            q = np.concatenate([q[first:-1], q[: first + 1] + self.span])
            closes = np.concatenate([closes[first:-1], closes[: first + 1]])
        edges = np.flatnonzero(np.diff(np.concatenate([[False], closes, [False]]).astype(int)))
        for first, after in edges.reshape(-1, 2).tolist():
            before = float(q[first - 1]) if first else None
            yield _Run(row, q[first:after], before, float(q[after]) if after < q.size else None, closed=False)

    def ended(self, runs: list[_Run]) -> list[_Run]:
        """Runs with their ends at the rim, halved down to round-off."""
        row = np.array([run.row for run in runs for _ in "ab"], dtype=np.intp)
        good = np.array([run.q[end] for run in runs for end in (0, -1)])
        bad = np.array([g if b is None else b for g, b in zip(good, _beyond(runs), strict=True)])
        share = halved(lambda s: self.place(row, good + s * (bad - good))[1] > 0, good.size)
        ends = (good + share * (bad - good)).reshape(-1, 2)
        made = []
        for run, (start, stop) in zip(runs, ends.tolist(), strict=True):
            q = np.concatenate([[start][: run.before is not None], run.q, [stop][: run.after is not None]])
            made.append(_Run(run.row, q, run.before, run.after, run.closed))
        return made

    def refined(self, q: Array, number: Rows, rows: Rows, chord: float) -> tuple[Array, Array, Rows]:
        """Values with steps cut into thirds until they are fine enough, the working point there (2, n), the numbers of
        the runs to which they belong; ``rows`` are those of the runs. Both thirds of a step are looked at: a curve that
        changes its bend crosses its chord halfway, and one that turns back has its tip anywhere."""
        at = self.place(rows[number], q)[0]
        todo = number[1:] == number[:-1]
        while (steps := np.flatnonzero(todo & (np.diff(q) > LEAST * self.span))).size:
            parts = q[steps] + np.array([[1.0], [2.0]]) / 3 * (q[steps + 1] - q[steps])
            here = np.tile(rows[number[steps]], 2)
            there = self.place(here, parts.ravel())[0].reshape(2, 2, -1)
            a, b = at[:, None, steps], at[:, None, steps + 1]
            curve = np.einsum("sk,ckn->csn", CUBIC, np.concatenate([a, there, b], axis=1))
            wrong = ~(distance(curve, a, b).max(axis=0) <= WITHIN * chord)
            coarse = steps[wrong]
            into = np.repeat(coarse + 1, 2)
            q = np.insert(q, into, parts[:, wrong].T.ravel())
            at = np.insert(at, into, there[:, :, wrong].transpose(0, 2, 1).reshape(2, -1), axis=1)
            number = np.insert(number, into, number[np.repeat(coarse, 2)])
            todo = np.zeros(max(q.size - 1, 0), dtype=bool)
            todo[((coarse + 2 * np.arange(coarse.size))[:, None] + np.arange(3)).ravel()] = True
        return q, at, number


def _beyond(runs: list[_Run]) -> Iterator[float | None]:
    for run in runs:
        yield from (run.before, run.after)


def _unbroken(one: CurveStretch, span: float, chord: float) -> Iterator[CurveStretch]:
    """The parts of a stretch between jumps of the point, and between places at which the mechanism doesn't close."""
    known = np.asarray(np.isfinite(one.at).all(axis=0))
    far = ~(np.hypot(*np.diff(one.at)) <= JUMP * chord) & (np.diff(one.q) <= LEAST * span)
    cuts = np.flatnonzero(far | ~known[1:] | ~known[:-1]) + 1
    if not cuts.size:
        yield one
        return
    pieces = list(zip(np.split(one.q, cuts), np.split(one.at, cuts, axis=1), strict=True))
    if one.closed:  # the last part goes on with the first one
        (q, at), (last, there) = pieces[0], pieces.pop()
        pieces[0] = (np.concatenate([last, q[1:] + span]), np.concatenate([there, at[:, 1:]], axis=1))
    for q, at in pieces:
        if q.size > 1:
            yield CurveStretch(q, at, closed=False)
