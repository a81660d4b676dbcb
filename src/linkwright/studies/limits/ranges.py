"""The ranges of one drive's value in which a mechanism assembles, and what ends each of them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.elements.cylinder import links_of
from linkwright.expressions import units as u
from linkwright.findings import Finding
from linkwright.graph.rows import Determinant, ReachRow
from linkwright.kernels import Compiled
from linkwright.kernels.laws import values_at
from linkwright.results import Run
from linkwright.results.stationary import crossings
from linkwright.structure import Group, HigherGroup
from linkwright.studies.assembly_checks import gaps, shortfall
from linkwright.studies.drive_sweep import Stop, Sweep, higher_group_ends, sweeping

Array = NDArray[np.float64]
Interval = tuple[float, float]

OUTWARD = 4.0
"""A sliding drive is followed this many times the mechanism's size from its start, each way."""
LOOKS = 4
"""How often ranges are looked through again for what was missed at the first look."""
SAME = 1e-7
"""Places closer than this share of the stretch looked at are one: a higher group's end is known no better."""


@dataclass(frozen=True)
class End:
    """One end of a range: the drive's value (rad or m) and why it ends there.

    ``kind`` is ``group`` (a dyad stretched or folded), ``higher_group`` (a group that meets a singular pose), ``pole``
    (a group whose slide runs away), ``stroke`` (the cylinder's own) or ``window`` (nothing ends: no more was looked
    at). ``beyond`` says what fails.
    """

    value: float
    kind: str
    group: str | None = None
    beyond: Finding | None = None

    @property
    def dead(self) -> bool:
        """Whether the mechanism can't go on here."""
        return self.kind not in ("window", "stroke")


@dataclass(frozen=True)
class Range:
    """A range of one drive's value in which the mechanism assembles; ``full`` where that is a whole turn."""

    low: End
    high: End
    full: bool
    sweep: Sweep


@dataclass(frozen=True)
class _TimeGap:
    """A stretch of times in which ``group`` can't be placed; a pole has no width."""

    start: float
    stop: float
    kind: str
    group: Group | HigherGroup
    worst: float = np.nan


def ranges(compiled: Compiled, drive: str, window: Interval | None, samples: int) -> list[Range]:
    """The ranges of a drive's value.

    Without a ``window``: in one turn, over a cylinder's stroke, or as far as a slide gets from its start.
    """
    moving = sweeping(compiled, drive)
    search = _RangeSearch(moving, drive, samples)
    if window is not None:
        return search.between(window[0] - search.origin, window[1] - search.origin)
    if compiled.mechanism.prescribed(drive).turns:
        return search.round()
    if (ends := stroke(compiled, drive)) is not None:
        return [_of_stroke(r) for r in search.between(ends[0] - search.origin, ends[1] - search.origin)]
    reach = OUTWARD * compiled.assembly.size()
    home = [r for r in search.between(-reach, reach) if r.sweep.start <= 0.0 <= r.sweep.stop]
    # How much is missing where the search happened to stop says nothing.
    return [replace(r, low=replace(r.low, beyond=None), high=replace(r.high, beyond=None)) for r in home]


def stroke(compiled: Compiled, drive: str) -> Interval | None:
    """The shortest and the longest length (m) of the cylinder that a drive prescribes, where the file says them."""
    moved = compiled.mechanism.prescribed(drive)
    for name, cylinder in compiled.mechanism.cylinders.items():
        if {*links_of(name)} == {moved.link, moved.on} and cylinder.length is not None:
            low, high = (compiled.quantities.value(edge, u.LENGTH) for edge in cylinder.length)
            return low, high
    return None


def _of_stroke(found: Range) -> Range:
    low, high = (replace(e, kind="stroke") if e.kind == "window" else e for e in (found.low, found.high))
    return replace(found, low=low, high=high)


class _RangeSearch:
    def __init__(self, compiled: Compiled, drive: str, samples: int) -> None:
        self.compiled, self.drive, self.samples = compiled, drive, samples
        self.origin = values_at(compiled.laws, 0.0)[drive]

    def round(self) -> list[Range]:
        """A whole turn from the start value; where that fails, what assembles of it, the range of the start in one."""
        turn = 2 * np.pi
        whole = self.between(0.0, turn)
        if len(whole) == 1 and not any(whole[0].sweep.dead):
            return whole
        every = self.between(-turn, turn)
        home = next((r for r in every if r.sweep.start <= 0.0 <= r.sweep.stop), None)
        if home is None:
            return []
        tiny = SAME * turn
        low, high = home.sweep.stop - tiny, home.sweep.start + turn + tiny
        return [home, *(r for r in every if low <= r.sweep.start and r.sweep.stop <= high)]

    def closes(self, start: float, stop: float) -> bool:
        """Whether a turn fits in and all links come back to where they were; a higher group may do so in another
        mode."""
        turn = 2 * np.pi
        if not self.compiled.mechanism.prescribed(self.drive).turns or stop - start < turn * (1 - 1e-12):
            return False
        ends = self.compiled.evaluate(self.compiled.graph.pose_rows, np.array([start, start + turn]))
        return bool(np.abs(ends[:, 1] - ends[:, 0]).max() < 1e-6 * max(self.compiled.assembly.size(), 1.0))

    def between(self, low: float, high: float) -> list[Range]:
        """The ranges between two times of the sweep."""
        run = Run(self.compiled, low, high, self.samples)
        found = self.gaps(run)
        for _ in range(LOOKS):
            kept = self.remaining_ranges(run, found)
            # Near a dead end other groups move fast: looked at again where the steps are finer there.
            more = [gap for r in kept if any(r.sweep.dead) for gap in self.gaps(r.sweep)]
            if not more:
                break
            found += more
        return kept

    def remaining_ranges(self, run: Run, found: list[_TimeGap]) -> list[Range]:
        """What some gaps leave of a run."""
        low, high = run.start, run.stop
        tiny = SAME * (high - low)
        starts: list[tuple[float, _TimeGap | None]] = [(low, None)]
        ends: list[tuple[float, _TimeGap | None]] = []
        for block in _blocks(found, tiny):
            first, last = _edge(block, "start", tiny), _edge(block, "stop", tiny)
            ends.append((first.start, first))
            starts.append((last.stop, last))
        ends.append((high, None))
        kept = []
        for (start, before), (stop, after) in zip(starts, ends, strict=True):
            if stop - start > tiny:
                sides = self.range_end(start, before), self.range_end(stop, after)
                stops = tuple(None if gap is None else Stop(_dyad(gap), gap.kind == "pole") for gap in (before, after))
                sweep = Sweep(self.compiled, self.drive, start, stop, self.samples, stops)
                kept.append(Range(*sides, not any(stops) and self.closes(start, stop), sweep))
        return kept

    def gaps(self, run: Run) -> list[_TimeGap]:
        """What fails in a run: higher groups past their ends, dyads out of reach, slides that run away."""
        found = []
        ends = higher_group_ends(self.compiled, run.start, run.stop)
        for higher_group, ((low, away_below), (high, away_above)) in zip(
            self.compiled.structure.higher_groups, ends, strict=True
        ):
            if low > run.start:
                found.append(_TimeGap(run.start, low, "pole" if away_below else "cluster", higher_group))
            if high < run.stop:
                found.append(_TimeGap(high, run.stop, "pole" if away_above else "cluster", higher_group))
        for group in self.compiled.structure.groups:
            if group.modes > 1:
                edges = [edge for gap in found for edge in (gap.start, gap.stop)]
                for start, stop, worst in gaps(run, ReachRow(group.label), edges):
                    found.append(_TimeGap(start, stop, "group", group, worst))
            else:
                found += [_TimeGap(at, at, "pole", group) for at in self.poles(run, group)]
        return found

    def poles(self, run: Run, group: Group) -> list[float]:
        """Where the two lines of a dyad of one mode become parallel, so that its slide runs away."""
        row = [Determinant(group.label)]
        shares = crossings(lambda share: self.compiled.evaluate(row, run.place(share)[0])[0], 0.0, 1.0, run.grid)
        at = run.place(shares)[0]
        known = np.abs(self.compiled.evaluate(row, at)[0]) < 1e-9 if at.size else np.empty(0, bool)
        return [float(t) for t in at[known]]

    def range_end(self, time: float, gap: _TimeGap | None) -> End:
        value = self.origin + time
        if gap is None:
            return End(value, "window")
        beyond = None if (group := _dyad(gap)) is None else self.cannot(group, gap)
        return End(value, gap.kind, gap.group.label, beyond)

    def cannot(self, group: Group, gap: _TimeGap) -> Finding:
        """In words which group fails in a gap, and by how much at worst."""
        data = shortfall(self.compiled, group, gap.worst)
        unit, size = self.compiled.quantities.drive_unit(self.drive)
        ends = [f"{(self.origin + time) / size:.6g}" for time in (gap.start, gap.stop)]
        data |= {"drive": self.drive, "unit": unit, "from": ends[0], "to": ends[1]}
        return Finding("motion.cannot-assemble", ("links", group.links[0]), data)


def _dyad(gap: _TimeGap | None) -> Group | None:
    """The dyad whose two modes meet at a gap's edge."""
    return gap.group if gap is not None and gap.kind == "group" and isinstance(gap.group, Group) else None


def _blocks(found: list[_TimeGap], tiny: float) -> list[list[_TimeGap]]:
    """Gaps that touch, together."""
    blocks: list[list[_TimeGap]] = []
    for gap in sorted(found, key=lambda gap: gap.start):
        if blocks and gap.start <= max(g.stop for g in blocks[-1]) + tiny:
            blocks[-1].append(gap)
        else:
            blocks.append([gap])
    return blocks


def _edge(block: list[_TimeGap], edge: str, tiny: float) -> _TimeGap:
    """The gap that makes a block's edge: of several that end together the dyad's, whose edge is exact."""
    outer = min if edge == "start" else max
    last = outer(getattr(gap, edge) for gap in block)
    near = [gap for gap in block if abs(getattr(gap, edge) - last) <= tiny]
    return min(near, key=lambda gap: isinstance(gap.group, HigherGroup))
