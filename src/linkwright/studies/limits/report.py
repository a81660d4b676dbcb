"""What the limits study shows, and what ``summary.json`` says of it, in the file's units."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite
from typing import Any

from linkwright.expressions.units import ANGLE, LENGTH, TIME
from linkwright.findings import SENTENCES, Joined, Said, Text
from linkwright.presentation.blocks import Section, StudyReport, Table, table
from linkwright.presentation.cells import Cell, NumberCell, Unit
from linkwright.studies.limits.extremes import SignalCourse, Transmission
from linkwright.studies.limits.four_links import FourLinks
from linkwright.studies.limits.outcome import DriveLimits, LimitsOutcome, RunLimits
from linkwright.studies.limits.ranges import End

TINY = 1e-13
"""A place or value below this share of the figures around it is round-off beside zero."""


def limits_entry(outcome: LimitsOutcome) -> dict[str, Any]:
    """What ``summary.json`` says of the limits."""
    second = outcome.compiled.quantities.unit_of(TIME)
    motion = None if outcome.motion is None else _Scale(outcome, *second, 0.0).stretch(outcome.motion)
    return {
        "limits": {
            "samples": outcome.samples,
            "drives": {drive.drive: _drive(outcome, drive) for drive in outcome.drives},
            "motion": motion,
            "four_links": [_loop(outcome, loop) for loop in outcome.loops],
        }
    }


def _drive(outcome: LimitsOutcome, limits: DriveLimits) -> dict[str, Any]:
    turns = bool(outcome.compiled.mechanism.prescribed(limits.drive).turns)
    unit, size = outcome.compiled.quantities.drive_unit(limits.drive)
    ranges = []
    for found, stretch in limits.ranges:
        scale = _Scale(outcome, unit, size, found.sweep.origin)
        ends = {"low": scale.end_entry(found.low), "high": scale.end_entry(found.high)}
        ranges.append({**ends, "full_turn": found.full, **scale.stretch(stretch)})
    return {"unit": unit, "turns": turns, "ranges": ranges}


def _loop(outcome: LimitsOutcome, loop: FourLinks) -> dict[str, Any]:
    unit, size = outcome.compiled.quantities.unit_of(LENGTH)
    return {
        "family": loop.family,
        "kind": loop.kind,
        "links": list(loop.links),
        "fixed": loop.fixed,
        "shortest": loop.shortest,
        "turning": list(loop.turning),
        "lengths": [length / size for length in loop.lengths],
        "margin": loop.margin / size,
        "unit": unit,
    }


class _Scale:
    """Times of a run as values of what moves it, in the file's unit."""

    def __init__(self, outcome: LimitsOutcome, unit: str, size: float, origin: float) -> None:
        self.quantities, self.unit, self.size, self.origin = outcome.compiled.quantities, unit, size, origin

    def in_unit(self, time: float) -> float:
        """A place in the unit."""
        return _near(self.origin + time, abs(self.origin) + abs(time)) / self.size

    def end_entry(self, end: End) -> dict[str, Any]:
        """Where a range ends, and why."""
        at = self.in_unit(end.value - self.origin)
        return {"at": at, "kind": end.kind, "group": end.group, "what": end.beyond.what if end.beyond else None}

    def stretch(self, stretch: RunLimits) -> dict[str, Any]:
        """A stretch's signals, transmission angles and change points."""
        return {
            "unit": self.unit,
            "signals": {course.signal: self.course(course) for course in stretch.courses},
            "transmission": {angle.group: self.angle(angle) for angle in stretch.transmission},
            "change_points": [{"group": t.group, "at": self.in_unit(t.time)} for t in stretch.touches],
        }

    def course(self, course: SignalCourse) -> dict[str, Any]:
        unit, size = self.quantities.unit_of(course.dimension)
        ends = [abs(e.value) for e in (course.low, course.high) if isfinite(e.value)]

        def value_in_unit(value: float) -> float | None:
            return _near(value, max(ends, default=0.0)) / size if isfinite(value) else None

        entry: dict[str, Any] = {
            "unit": unit,
            "min": value_in_unit(course.low.value),
            "min_at": self.in_unit(course.low.time),
            "max": value_in_unit(course.high.value),
            "max_at": self.in_unit(course.high.time),
            "span": value_in_unit(course.stroke),
            "turns": course.turns,
            "limit_positions": [
                {"kind": "max" if r.top else "min", "value": value_in_unit(r.value), "at": self.in_unit(r.time)}
                for r in course.reversals
            ],
        }
        if course.strokes is not None:
            strokes = course.strokes
            entry["strokes"] = {"rising": strokes.rising / self.size, "falling": strokes.falling / self.size}
            entry["time_ratio"] = strokes.ratio
        return entry

    def angle(self, found: Transmission) -> dict[str, Any]:
        unit, size = self.quantities.unit_of(ANGLE)
        at = None if found.time is None else self.in_unit(found.time)
        return {"signature": found.signature, "least": found.angle / size, "unit": unit, "at": at}


def _near(value: float, size: float) -> float:
    return value if abs(value) > TINY * size else 0.0


def report(outcome: LimitsOutcome) -> StudyReport:
    """Tables of all that was found."""
    summary = limits_entry(outcome)
    return StudyReport([Section("limits", tables(summary["limits"]))], summary)


def tables(entry: dict[str, Any]) -> list[Table]:
    """The same as tables."""
    stretches = list(_stretches(entry))
    return [
        table("limits", "ranges", ("drive", "from", "to", "unit", "ends"), _ranges(entry)),
        table("limits", "signals", _SIGNALS, _signals(stretches)),
        table("limits", "limit_positions", ("by", "signal", "end", "value", "unit", "at"), _limit_positions(stretches)),
        table("limits", "transmission", ("by", "group", "signature", "least", "unit", "at"), _transmission(stretches)),
        table("limits", "change_points", ("by", "group", "at"), _change_points(stretches)),
        table("limits", "four_links", ("links", "type", "turning", "margin", "unit"), _loops(entry)),
    ]


_SIGNALS = ("by", "signal", "min", "at", "max", "at", "span", "unit", "ratio")
Stretches = list[tuple[Text, dict[str, Any]]]


def _stretches(entry: dict[str, Any]) -> Iterator[tuple[Text, dict[str, Any]]]:
    """Each stretch with the name of what moves it."""
    for drive, limits in entry["drives"].items():
        several = len(limits["ranges"]) > 1
        for i, stretch in enumerate(limits["ranges"], start=1):
            yield (f"{drive} ({i})" if several else drive), stretch
    if entry["motion"] is not None:
        yield Said("limits.motion"), entry["motion"]


def _ranges(entry: dict[str, Any]) -> Iterator[list[Cell]]:
    for drive, limits in entry["drives"].items():
        several = len(limits["ranges"]) > 1
        for i, found in enumerate(limits["ranges"], start=1):
            name = f"{drive} ({i})" if several else drive
            yield [
                name,
                _number(found["low"]["at"]),
                _number(found["high"]["at"]),
                Unit(limits["unit"]),
                _why(limits, found),
            ]
        if not limits["ranges"]:
            yield [drive, "", "", Unit(limits["unit"]), Said("limits.no_range")]


def _why(limits: dict[str, Any], found: dict[str, Any]) -> Text:
    """What ends a range; the one gap of a turn is told once."""
    if found["full_turn"]:
        return Said("limits.full_turn.change-point" if found["change_points"] else "limits.full_turn")
    ends = [found["low"], found["high"]]
    if limits["turns"] and len(limits["ranges"]) == 1 and ends[0]["kind"] == ends[1]["kind"] == "group":
        ends = ends[1:]
    told = (end["what"] or Said(f"limits.end.{end['kind']}", group=end["group"], at=_number(end["at"])) for end in ends)
    return Joined(told, SENTENCES)


def _signals(stretches: Stretches) -> Iterator[list[Cell]]:
    for by, stretch in stretches:
        for name, s in stretch["signals"].items():
            low, high = ([_number(s[end]), _place(s[f"{end}_at"], stretch)] for end in ("min", "max"))
            span: Cell = Said("limits.whole_turns", turns=abs(s["turns"])) if s["turns"] else _number(s["span"])
            yield [by, name, *low, *high, span, Unit(s["unit"]), _number(s["time_ratio"]) if "time_ratio" in s else ""]


def _limit_positions(stretches: Stretches) -> Iterator[list[Cell]]:
    for by, stretch in stretches:
        for name, s in stretch["signals"].items():
            for r in s["limit_positions"]:
                where = _place(r["at"], stretch)
                yield [by, name, Said(f"measure.{r['kind']}"), _number(r["value"]), Unit(s["unit"]), where]


def _transmission(stretches: Stretches) -> Iterator[list[Cell]]:
    for by, stretch in stretches:
        for group, found in stretch["transmission"].items():
            at = Said("limits.everywhere") if found["at"] is None else _place(found["at"], stretch)
            yield [by, group, found["signature"], _number(found["least"]), Unit(found["unit"]), at]


def _change_points(stretches: Stretches) -> Iterator[list[Cell]]:
    for by, stretch in stretches:
        for found in stretch["change_points"]:
            yield [by, found["group"], _place(found["at"], stretch)]


def _loops(entry: dict[str, Any]) -> Iterator[list[Cell]]:
    for loop in entry["four_links"]:
        kind = Said(f"limits.kind.{loop['kind']}", fixed=loop["fixed"] or "-")
        turning: Text = Joined(loop["turning"]) or Said("limits.none")
        if loop["turning"] and loop["kind"] == "change-point":
            turning = Said("limits.turning.change-point", links=turning)
        yield [Joined(loop["links"]), kind, turning, _number(loop["margin"]), Unit(loop["unit"])]


def _number(value: float | None) -> NumberCell:
    return NumberCell(value, unknown=Said("limits.without_limit"))


def _place(value: float, stretch: dict[str, Any]) -> NumberCell:
    return NumberCell(value, unit=stretch["unit"])
