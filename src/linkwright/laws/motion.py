"""Motions: segments in sequence over an angle or a time, closed or not, with every join looked at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from linkwright.laws.curve import SMOOTH, Curve, Extreme, Join, composed
from linkwright.laws.segments import Fault, MotionError, Segment
from linkwright.notation import Jet

Array = NDArray[np.float64]

Beyond = Literal["repeat", "advance", "hold"]
"""What comes after the last segment: all again; all again from where it ended; rest, as before the first one."""
CLOSE = 1e-9
"""How closely values and widths must agree, over the largest of them."""
FAR = 1e12
"""Further periods away a place within the period is round-off, and the motion has no value."""
SHORTEST, LONGEST = 1e-12, 1e12
"""Between these lie the lengths of segments (s, rad), whose high powers must not overflow."""
ALIKE = 1e-4
"""How closely two accelerations that are to be one must agree; published coefficients have five digits."""


@dataclass(frozen=True)
class Motion:
    """A value over an axis (angle or time) that starts at 0. Made by :func:`motion`."""

    curve: Curve
    places: tuple[float, ...]  # where segments start, and the end
    beyond: Beyond = "repeat"

    @property
    def period(self) -> float:
        """The length of all segments."""
        return self.places[-1]

    @property
    def advance(self) -> float:
        """By how much one period ends above its start."""
        return float(self.curve.at(self.period) - self.curve.at(0.0))

    def at(self, x: Any, order: int = 0) -> Array:
        """A derivative by the axis at any places."""
        x = np.asarray(x, dtype=float)
        if self.beyond == "hold":
            inside = (x >= 0) & (x <= self.period)
            found = self.curve.at(np.clip(x, 0.0, self.period), order)
            return found if order == 0 else np.where(inside, found, np.where(np.isnan(x), np.nan, 0.0))
        with np.errstate(invalid="ignore"):
            whole = np.floor_divide(x, self.period)
        near = np.abs(whole) < FAR
        within = np.clip(np.where(near, x - np.where(near, whole, 0.0) * self.period, 0.0), 0.0, self.period)
        found = np.where(near, self.curve.at(within, order), np.nan)
        return found + whole * self.advance if self.beyond == "advance" and order == 0 else found

    def __call__(self, x: Any) -> Any:
        """The value at plain numbers, or on a jet with its derivatives; the jet's entries may be duals."""
        return self.on(x) if isinstance(x, Jet) else self.at(x)

    def on(self, x: Jet, order: int = 0) -> Jet:
        """The value, or a derivative by the axis, on a jet."""
        return composed(x, self.at, order)

    def pieces(self, x: str = "x") -> tuple[tuple[float, float, str], ...]:
        """Start, stop and formula of each piece, in the units of the axis and the value."""
        return self.curve.pieces(x)

    def restated(self, axis: float, value: float = 1.0) -> Motion:
        """The same in other units: ``axis`` and ``value`` are their sizes in the units so far.

        Of a motion over an angle, at w rad/s: with ``axis = w`` one over the time.
        """
        curve = self.curve.moved(0.0, 1 / axis, 1 / value)
        return Motion(curve, tuple(place / axis for place in self.places), self.beyond)

    @cached_property
    def joins(self) -> tuple[Join, ...]:
        """All joins of pieces, that from the end to the start among them, or those with the rest outside."""
        curve = self.curve
        first, last = curve.ends()
        if self.beyond == "hold":
            still = (0.0,) * SMOOTH
            ends = [
                Join(0.0, (first[0], *still), first, curve.sizes),
                Join(self.period, last, (last[0], *still), curve.sizes),
            ]
        else:
            lower = last[0] - (self.advance if self.beyond == "advance" else 0.0)
            ends = [Join(0.0, (lower, *last[1:]), first, curve.sizes)]
        return tuple(sorted([*ends, *curve.joins()], key=lambda join: join.at))

    @property
    def continuity(self) -> int:
        """The class of the whole: the last derivative up to which nothing jumps anywhere."""
        return min(join.continuity for join in self.joins)

    @property
    def breaks(self) -> tuple[float, ...]:
        """Where pieces meet."""
        return tuple(join.at for join in self.joins)

    def extremes(self, order: int) -> tuple[Extreme, Extreme]:
        """The smallest and the largest value of a derivative over the segments, with their places."""
        return self.curve.extremes(order)


def motion(
    segments: Sequence[Segment], start: float = 0.0, period: float | None = None, beyond: Beyond = "repeat"
) -> Motion:
    """Segments in sequence from the value ``start`` on; ``period`` is what they must add up to, where it is given.

    Raises :class:`MotionError` with all that is wrong.
    """
    faults = [Fault("law.over", i) for i, segment in enumerate(segments) if not SHORTEST <= segment.over <= LONGEST]
    if faults:
        raise MotionError(faults)
    if faults := [Fault(code, i, data) for i, segment in enumerate(segments) for code, data in segment.faults()]:
        raise MotionError(faults)
    whole = sum(segment.over for segment in segments)
    if period is not None and abs(whole - period) > CLOSE * period:
        faults.append(Fault("law.period", None, {"sum": whole, "period": period}))
    heights = np.cumsum([start, *(segment.lift for segment in segments)])
    span = max(float(np.ptp(heights)), CLOSE * float(np.abs(heights).max()), max(abs(s.lift) for s in segments))
    if beyond == "repeat" and abs(heights[-1] - heights[0]) > CLOSE * span:
        faults.append(Fault("law.not-closed", None, {"start": float(heights[0]), "end": float(heights[-1])}))
    ends, unsettled = _ends(segments, beyond)
    if faults or unsettled:
        raise MotionError([*faults, *unsettled])
    places = [0.0, *np.cumsum([segment.over for segment in segments]).tolist()]
    if period is not None:
        places[-1] = period
    if beyond == "repeat":
        heights[-1] = heights[0]
    curves = [
        segment.curve(*asked).moved(at, 1.0, 1.0, float(height))
        for segment, asked, at, height in zip(segments, ends, places, heights, strict=False)
    ]
    made = Motion(Curve(tuple(part for curve in curves for part in curve.parts)), tuple(places), beyond)
    if faults := _unmirrored(segments, made):
        raise MotionError(faults)
    return made


def _ends(
    segments: Sequence[Segment], beyond: Beyond
) -> tuple[list[tuple[tuple[float, ...], tuple[float, ...]]], list[Fault]]:
    """The rates that each segment asks for at both ends, those of its neighbours where it leaves them open."""
    known: list[list[dict[int, float]]] = []  # of each segment and end: rates by order
    for segment in segments:
        own = [[rate for rate in end if rate is not None] for end in segment.open]
        if any(None in end for end in segment.open):
            known.append([{k: r for k, r in enumerate(end, start=1) if r is not None} for end in segment.open])
        else:
            known.append([dict(enumerate(end[1:], start=1)) for end in segment.curve(*own).ends()])
    count = len(segments)
    at_rest = dict.fromkeys(range(1, SMOOTH + 1), 0.0)
    found, faults = [], []
    for i, segment in enumerate(segments):
        asked = []
        for side, end in enumerate(segment.open):
            other = i + (1 if side else -1)
            outside = beyond == "hold" and not 0 <= other < count
            beside = at_rest if outside else known[other % count][1 - side]
            given = [beside.get(k) if rate is None else rate for k, rate in enumerate(end, start=1)]
            if None in given:
                faults.append(
                    Fault("law.open-end", i, {"side": "end" if side else "start", "other": other % count + 1})
                )
            asked.append(tuple(0.0 if rate is None else rate for rate in given))
        found.append((asked[0], asked[1]))
    return found, faults


def _unmirrored(segments: Sequence[Segment], made: Motion) -> list[Fault]:
    """Laws that end with an acceleration where no mirror image of theirs goes on with it."""
    jumps = {join.at for join in made.joins if abs(join.jumps[2]) > ALIKE * join.sizes[2]}
    found = []
    for i, segment in enumerate(segments):
        ends = [at % made.period if made.beyond != "hold" else at for at in made.places[i : i + 2]]
        if segment.mirrored and jumps & {*ends}:
            found.append(Fault("law.end-acceleration", i, {"law": segment.mirrored}))
    return found
