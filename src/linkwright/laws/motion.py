"""Motions: segments in sequence over an angle or a time, closed or not, with every join looked at."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import accumulate, pairwise
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.laws.curve import ROUND_OFF, SMOOTH, Curve, Extreme, Join, composed, evaluate_chained, rates
from linkwright.laws.numbers import either, first, largest_of, off, plain, possible
from linkwright.laws.pieces import SmoothPart
from linkwright.laws.segments import MotionError, MotionFault, Segment
from linkwright.notation import Jet, Scalar
from linkwright.notation.duals import value_of
from linkwright.notation.jets import call, symbolic

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
    places: tuple[Scalar, ...]  # where segments start, and the end
    beyond: Beyond = "repeat"

    @property
    def period(self) -> Scalar:
        """The length of all segments."""
        return self.places[-1]

    @property
    def advance(self) -> Scalar:
        """By how much one period ends above its start."""
        if not self.plain:
            return self.curve.parts[-1].at(self.period, 0) - self.curve.parts[0].at(0.0, 0)
        return float(self.curve.at(self.period) - self.curve.at(0.0))

    @cached_property
    def plain(self) -> bool:
        """Whether all its numbers are floats."""
        return self.curve.plain and plain(*self.places)

    def at(self, x: Any, order: int = 0) -> Any:
        """A derivative by the axis at any places; see :meth:`Curve.at`. Enclosures follow it by their own ``along``."""
        if (own := getattr(x, "along", None)) is not None:
            return own(self, order)
        if symbolic(x):
            return self._expression(x, order)
        x = np.asarray(x, dtype=float)
        if not self.plain:
            return self._spread(x, order)
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

    def _expression(self, x: Any, order: int) -> Any:
        """The same at a symbol."""
        if self.beyond == "hold":
            found = self.curve.at(_clamped(x, self.period), order)
            return found if order == 0 else call("where", call("logical_and", x >= 0, x <= self.period), found, 0.0)
        whole = call("floor", x / self.period)
        found = self.curve.at(_clamped(x - whole * self.period, self.period), order)
        return found + whole * self.advance if self.beyond == "advance" and order == 0 else found

    def _spread(self, x: Array, order: int) -> Any:
        """The same with a period that may be other in each sample, or have slopes."""
        if self.beyond == "hold":
            found = evaluate_chained(_clamped(x, self.period), self.curve.at, order)
            inside = (x >= 0) & (x <= value_of(self.period))
            return found if order == 0 else call("where", inside, found, np.where(np.isnan(x), np.nan, 0.0))
        with np.errstate(invalid="ignore"):
            whole = np.floor_divide(x, value_of(self.period))
        near = np.abs(whole) < FAR
        within = _clamped(x - np.where(near, whole, 0.0) * self.period, self.period)
        found = call("where", near, evaluate_chained(within, self.curve.at, order), np.nan)
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
        curve = self.curve.transformed(0.0, 1 / axis, 1 / value)
        return Motion(curve, tuple(place / axis for place in self.places), self.beyond)

    @cached_property
    def joins(self) -> tuple[Join, ...]:
        """All joins of pieces, that from the end to the start among them, or those with the rest outside."""
        curve = self.curve
        first, last = curve.end_derivatives()
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


def _clamped(x: Any, period: Scalar) -> Any:
    """Places within a period."""
    return call("fmin", call("fmax", x, 0.0), period)


def motion(
    segments: Sequence[Segment],
    start: Scalar = 0.0,
    period: Scalar | None = None,
    beyond: Beyond = "repeat",
    checked: bool = True,
    found: list[MotionFault] | None = None,
) -> Motion:
    """Segments in sequence from the value ``start`` on; ``period`` is what they must add up to, where it is given.

    Raises :class:`MotionError` with all that is wrong; unless ``checked``, what makes no sense comes out as it may.
    Of segments of symbols, what may be wrong is added to those ``found``.
    """
    if checked:
        _check_each(segments, found)
    ends, unsettled = _end_rates(segments, beyond)
    if checked:
        _raise([*_unequal(segments, start, period, beyond), *unsettled], found)
    heights = [*accumulate((segment.lift for segment in segments), initial=start)]
    places = [*accumulate((segment.over for segment in segments), initial=0.0)]
    if period is not None:
        places[-1] = period
    curves = [
        segment.curve(*asked).transformed(at, 1.0, 1.0, height)
        for segment, asked, at, height in zip(segments, ends, places, heights, strict=False)
    ]
    made = Motion(Curve(tuple(part for curve in curves for part in curve.parts)), tuple(places), beyond)
    if checked:
        _raise(_unmirrored(segments, curves, made), found)
    return made


def _check_each(segments: Sequence[Segment], found: list[MotionFault] | None) -> None:
    """Raises what is wrong with segments by themselves."""
    wrong = [_out_of_range(value_of(segment.over)) for segment in segments]
    _raise([MotionFault("law.over", i, where=where) for i, where in enumerate(wrong)], found)
    _raise([fault for i, segment in enumerate(segments) for fault in segment.faults(i)], found)


def _out_of_range(length: Any) -> Any:
    if symbolic(length):
        return either(length < SHORTEST, length > LONGEST)
    x = np.asarray(length)
    return ~((x >= SHORTEST) & (x <= LONGEST)) & ~((np.ndim(x) > 0) & np.isnan(x))


def _unequal(
    segments: Sequence[Segment], start: Scalar, period: Scalar | None, beyond: Beyond
) -> Iterator[MotionFault]:
    """Segments that don't add up."""
    if period is not None:
        widths = [segment.over for segment in segments]
        whole: Scalar = sum(widths)
        wrong = off(whole - period, period, CLOSE, [*widths, period])
        told = {"sum": first(whole, wrong), "period": first(period, wrong)} if possible(wrong) else {}
        yield MotionFault("law.period", None, told, wrong)
    lifts = [segment.lift for segment in segments]
    heights = [*accumulate(lifts, initial=start)]
    if beyond == "repeat":
        sizes = [value_of(height) for height in heights]
        lengths = [call("abs", size) for size in sizes], [call("abs", value_of(lift)) for lift in lifts]
        whole_span = largest_of(sizes) + largest_of([-size for size in sizes])
        span = largest_of([whole_span, CLOSE * largest_of(lengths[0]), *lengths[1]])
        wrong = off(heights[-1] - heights[0], span, CLOSE, lifts)
        told = {"start": first(heights[0], wrong), "end": first(heights[-1], wrong)} if possible(wrong) else {}
        yield MotionFault("law.not-closed", None, told, wrong)


def _raise(faults: Sequence[MotionFault], found: list[MotionFault] | None) -> None:
    faults = [fault for fault in faults if possible(fault.where)]
    if found is not None:
        found += (fault for fault in faults if symbolic(fault.where))
        faults = [fault for fault in faults if not symbolic(fault.where)]
    if faults:
        raise MotionError(faults)


def _end_rates(
    segments: Sequence[Segment], beyond: Beyond
) -> tuple[list[tuple[tuple[Scalar, ...], tuple[Scalar, ...]]], list[MotionFault]]:
    """The rates that each segment asks for at both ends, those of its neighbours where it leaves them open."""
    if all(rate is not None for segment in segments for end in segment.open for rate in end):
        return [segment.open for segment in segments], []
    known: list[list[dict[int, Scalar]]] = []  # of each segment and end: rates by order
    for segment in segments:
        own = [[rate for rate in end if rate is not None] for end in segment.open]
        if any(rate is None for end in segment.open for rate in end):
            known.append([{k: r for k, r in enumerate(end, start=1) if r is not None} for end in segment.open])
        else:
            known.append([dict(enumerate(end[1:], start=1)) for end in segment.curve(*own).end_derivatives()])
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
            if any(rate is None for rate in given):
                faults.append(
                    MotionFault("law.open-end", i, {"side": "end" if side else "start", "other": other % count + 1})
                )
            asked.append(tuple(0.0 if rate is None else rate for rate in given))
        found.append((asked[0], asked[1]))
    return found, faults


def _unmirrored(segments: Sequence[Segment], curves: Sequence[Curve], made: Motion) -> list[MotionFault]:
    """Laws that end with an acceleration where no mirror image of theirs goes on with it; where they end without one,
    a jump is that of their neighbour."""
    if not any(segment.mirrored for segment in segments):
        return []

    def jump(step: Scalar) -> Any:
        return made.curve.jumps(step, 2, ALIKE)

    still = (0.0,) * 3
    ends = [tuple(rates(part, at, 2) for part, at in _outer(curve)) for curve in curves]
    around = ((still, still),) if made.beyond == "hold" else ()
    row = [*(around or ends[-1:]), *ends, *(around or ends[:1])]
    joins = [jump(after[0][2] - before[1][2]) for before, after in pairwise(row)]
    faults = []
    for i, segment in enumerate(segments):
        if segment.mirrored:
            own = [call("logical_and", join, jump(end[2])) for join, end in zip(joins[i : i + 2], ends[i], strict=True)]
            faults.append(MotionFault("law.end-acceleration", i, {"law": segment.mirrored}, either(*own)))
    return faults


def _outer(curve: Curve) -> tuple[tuple[SmoothPart, Scalar], tuple[SmoothPart, Scalar]]:
    """The pieces at its ends, with these."""
    return (curve.parts[0], curve.start), (curve.parts[-1], curve.stop)


def jumping(motion: Motion) -> Any:
    """Of each sample, whether the value or velocity of a motion jumps somewhere."""
    parts = motion.curve.parts
    joins = [(rates(a, a.stop, 1), rates(b, b.start, 1)) for a, b in pairwise(parts)]
    front, back = rates(parts[0], motion.curve.start, 1), rates(parts[-1], motion.curve.stop, 1)
    if motion.beyond == "hold":
        joins += [((front[0], 0.0), front), (back, (back[0], 0.0))]
    else:
        joins.append(((back[0] - (motion.advance if motion.beyond == "advance" else 0.0), back[1]), front))
    wrong: Any = False
    for before, after in joins:
        for order, (a, b) in enumerate(zip(before, after, strict=True)):
            wrong = either(wrong, motion.curve.jumps(b - a, order, ROUND_OFF))
    return wrong
