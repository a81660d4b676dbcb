"""The range of the driving joint: what is asked for, or all that is reached from the start pose, short of toggles."""

from __future__ import annotations

import math

from linkwright.data_classes import dataclass
from linkwright.findings import Finding, Joined, Text
from linkwright.kernels import Compiled
from linkwright.kernels.laws import values_at
from linkwright.studies.limits.extremes import touches
from linkwright.studies.limits.ranges import Range, ranges

SAMPLES = 360
SHORT = {"pole": 1e-2}
SHORTER = 1e-3
"""How far before a toggle a range ends, over its width; where a slide runs away, more."""
SAME = 1e-6
"""Ends closer than this share of the range are one."""
PATH = ("exports", "process-simulate", "range")


@dataclass(frozen=True)
class DriveReach:
    """Values of the drive (rad or m): the least, the largest, that at the zero pose, that at the model's start."""

    low: float
    high: float
    zero: float
    start: float
    full: bool = False


def drive_reach(
    compiled: Compiled,
    drive: str,
    zero: float | None,
    window: tuple[float, float] | None,
    stops: tuple[str, float] | None = None,
) -> DriveReach | Finding:
    """The range of a drive, or why there is none. ``stops`` has the joint that the window's ends are stops of, with -1
    where it counts against the drive."""
    start = float(values_at(compiled.laws, 0.0)[drive])
    zero = start if zero is None else zero
    if window is None:
        found = _home(ranges(compiled, drive, None, SAMPLES), start)
        if found is None:
            return _none(compiled, drive, start)
        if found.full:
            return DriveReach(zero, zero + 2 * math.pi, zero, start, full=True)
        if not found.contains(zero):
            return _zero_beyond(compiled, drive, zero, found)
        low, high = found.allowed
        return DriveReach(min(low, zero), max(high, zero), zero, start)
    low, high = min(*window, zero, start), max(*window, zero, start)
    found = _home(ranges(compiled, drive, (low, high), SAMPLES), start)
    if found is None:
        return _none(compiled, drive, start)
    tiny = SAME * (high - low)
    if found.low > low + tiny or found.high < high - tiny or found.dead[0] or found.dead[1]:
        whole = _home(ranges(compiled, drive, None, SAMPLES), start) or found
        if not whole.full and not whole.contains(zero):
            return _zero_beyond(compiled, drive, zero, whole)
        met = found.groups or whole.groups
        return _beyond(compiled, drive, window, found if whole.full else whole, met, zero, stops)
    return DriveReach(*window, zero, start)


@dataclass(frozen=True)
class _Home:
    """The values of the drive (rad or m) around the start pose in which no group changes its assembly mode.

    ``dead`` is whether each end is a toggle, ``kinds`` of which kind, ``groups`` those that are at one.
    """

    low: float
    high: float
    dead: tuple[bool, bool]
    kinds: tuple[str, str]
    groups: tuple[str, ...]
    full: bool

    def contains(self, value: float) -> bool:
        """Whether a value lies within, short of toggles."""
        low = self.low < value or (self.low == value and not self.dead[0])
        return low and (value < self.high or (value == self.high and not self.dead[1]))

    @property
    def allowed(self) -> tuple[float, float]:
        """The range without what is next to its toggles."""
        width = self.high - self.low
        cuts = [width * SHORT.get(k, SHORTER) if dead else 0.0 for dead, k in zip(self.dead, self.kinds, strict=True)]
        return self.low + cuts[0], self.high - cuts[1]


def _home(found: list[Range], start: float) -> _Home | None:
    """The range that holds the start pose, between its change points."""
    home = next((r for r in found if r.low.value <= start <= r.high.value), None)
    if home is None:
        return None
    low, high, dead, kinds = (
        home.low.value,
        home.high.value,
        [home.low.dead, home.high.dead],
        [home.low.kind, home.high.kind],
    )
    groups = [end.group for end in (home.low, home.high) if end.dead and end.group]
    meeting = [(home.sweep.origin + touch.time, touch.group) for touch in touches(home.sweep)]
    if home.full and meeting:
        meeting += [(value - 2 * math.pi, group) for value, group in meeting]
        low -= 2 * math.pi
    for value, group in meeting:
        if low <= value <= start:
            low, dead[0], kinds[0] = value, True, "touch"
            groups.append(group)
        elif start < value <= high:
            high, dead[1], kinds[1] = value, True, "touch"
            groups.append(group)
    return _Home(low, high, (dead[0], dead[1]), (kinds[0], kinds[1]), tuple(groups), home.full and not meeting)


def _zero_beyond(compiled: Compiled, drive: str, zero: float, found: _Home) -> Finding:
    unit, size = compiled.quantities.drive_unit(drive)
    data = {"drive": drive, "unit": unit, "zero": f"{zero / size:.6g}", "groups": _named(found.groups)}
    return Finding("functions.zero", (*PATH[:-1], "zero"), data | offered(found.allowed, size))


def _beyond(
    compiled: Compiled,
    drive: str,
    asked: tuple[float, float],
    found: _Home,
    groups: tuple[str, ...],
    zero: float,
    stops: tuple[str, float] | None,
) -> Finding:
    unit, size = compiled.quantities.drive_unit(drive)
    of, key, allowed = drive, "range", found.allowed
    if stops is not None:
        of, key, sign = stops[0], "stops", stops[1]
        asked, allowed = (
            (min(ends), max(ends)) for ends in ([sign * (end - zero) for end in pair] for pair in (asked, allowed))
        )
    data = {
        "of": of, "unit": unit, "from": f"{asked[0] / size + 0.0:.6g}", "to": f"{asked[1] / size + 0.0:.6g}",
        "key": key, "groups": _named(groups),
    }  # fmt: skip
    return Finding("functions.toggle", (*PATH[:-1], key), data | offered(allowed, size))


def _named(groups: tuple[str, ...]) -> Text:
    return Joined(dict.fromkeys(groups)) or "-"


def offered(allowed: tuple[float, float], size: float) -> dict[str, str]:
    """A range in a unit, rounded inwards, so that what is offered is taken."""
    fine = 10.0 ** (math.floor(math.log10(max(allowed[1] - allowed[0], 1e-12) / size)) - 4)
    low, high = math.ceil(allowed[0] / size / fine) * fine, math.floor(allowed[1] / size / fine) * fine
    return {"low": f"{low:.8g}", "high": f"{high:.8g}"}


def _none(compiled: Compiled, drive: str, start: float) -> Finding:
    unit, size = compiled.quantities.drive_unit(drive)
    return Finding("functions.no-range", PATH, {"drive": drive, "start": f"{start / size:.6g}", "unit": unit})
