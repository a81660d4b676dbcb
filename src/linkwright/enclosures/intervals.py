"""Intervals: arrays of lower and upper ends, rounded outward, with the elementary functions.

Moore, Kearfott, Cloud, Introduction to Interval Analysis (2009), ch. 2 to 5. The ends of sums, products, quotients and
square roots are moved by one floating-point number, those of NumPy's elementary functions by 8 units in the last
place: their vector forms state 4. What leaves a function's domain, be it by round-off, is the whole line: undecided,
never NaN and never cut off in silence.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Operation = Callable[..., "Intervals"]

ULPS = 8 * 2.0**-52
TINY, LARGEST = 1e-300, float(np.finfo(float).max)
HALF_TURN = 3.1415926535897936
"""A number just above pi."""
FARTHEST = 1e9
"""Angles beyond this one have any sine."""

FUNCTIONS: dict[str, Operation] = {}


def register(*names: str) -> Callable[[Operation], Operation]:
    """Register a function under its NumPy names."""

    def add(function: Operation) -> Operation:
        FUNCTIONS.update(dict.fromkeys(names, function))
        return function

    return add


class Intervals:
    """Sets of numbers between ``low`` and ``high``, arrays of one shape; either may be infinite, none is NaN."""

    __slots__ = ("high", "low")
    __array_priority__ = 1000
    __array_ufunc__ = None

    def __init__(self, low: Any, high: Any = None) -> None:
        low = np.asarray(low, dtype=float)
        high = low if high is None else np.asarray(high, dtype=float)
        unknown = np.isnan(low) | np.isnan(high)
        self.low: Array = np.where(unknown, -np.inf, low)
        self.high: Array = np.where(unknown, np.inf, high)

    def __repr__(self) -> str:
        return f"Intervals({self.low!r}, {self.high!r})"

    def contains(self, value: Any) -> NDArray[np.bool_]:
        """Which of them hold a number."""
        return np.asarray((self.low <= value) & (value <= self.high))

    def __add__(self, other: Any) -> Intervals:
        other = lift(other)
        with np.errstate(all="ignore"):
            return _rounded(self.low + other.low, self.high + other.high)

    __radd__ = __add__

    def __neg__(self) -> Intervals:
        return Intervals(-self.high, -self.low)

    def __sub__(self, other: Any) -> Intervals:
        return self + (-lift(other))

    def __rsub__(self, other: Any) -> Intervals:
        return lift(other) + (-self)

    def __mul__(self, other: Any) -> Intervals:
        other = lift(other)
        with np.errstate(all="ignore"):
            ends = [a * b for a in (self.low, self.high) for b in (other.low, other.high)]
        four = np.stack(np.broadcast_arrays(*ends))
        four = np.where(np.isnan(four), 0.0, four)  # 0 times an infinite end
        return _rounded(four.min(axis=0), four.max(axis=0))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Intervals:
        other = lift(other)
        zero = (other.low <= 0) & (other.high >= 0)
        with np.errstate(all="ignore"):
            turned = _rounded(1.0 / other.high, 1.0 / other.low)
            found = self * Intervals(np.where(zero, -np.inf, turned.low), np.where(zero, np.inf, turned.high))
        every = np.broadcast_to(zero, found.low.shape)
        return Intervals(np.where(every, -np.inf, found.low), np.where(every, np.inf, found.high))

    def __rtruediv__(self, other: Any) -> Intervals:
        return lift(other) / self

    def __pow__(self, power: Any) -> Intervals:
        if isinstance(power, int | float | np.number) and float(power) == int(power):
            return self._integer_power(int(power))
        if isinstance(power, float) and power == 0.5:
            return sqrt(self)
        return exp(log(self) * power)

    def __rpow__(self, base: Any) -> Intervals:
        return lift(base) ** self

    def _integer_power(self, power: int) -> Intervals:
        if power < 0:
            return 1.0 / self._integer_power(-power)
        size = absolute(self) if power % 2 == 0 else self
        with np.errstate(all="ignore"):
            low, high = (end**power for end in (size.low, size.high))
        found = _widened(low, high, max(power, 1) * ULPS)
        return Intervals(np.maximum(found.low, 0.0), found.high) if power % 2 == 0 else found

    def __abs__(self) -> Intervals:
        return absolute(self)

    def __le__(self, other: Any) -> Intervals:
        return less_equal(self, other)

    def __lt__(self, other: Any) -> Intervals:
        return less(self, other)

    def __ge__(self, other: Any) -> Intervals:
        return less_equal(other, self)

    def __gt__(self, other: Any) -> Intervals:
        return less(other, self)

    @staticmethod
    def elementary(name: str, *args: Any) -> Intervals:
        """An elementary function by its NumPy name."""
        return FUNCTIONS[name](*args)


def lift(value: Any) -> Intervals:
    """A number or array as intervals; intervals as they are."""
    return value if isinstance(value, Intervals) else Intervals(value)


def hull(*parts: Intervals) -> Intervals:
    """The intervals that hold several."""
    lows, highs = ([getattr(part, end) for part in parts] for end in ("low", "high"))
    return Intervals(np.minimum.reduce(np.broadcast_arrays(*lows)), np.maximum.reduce(np.broadcast_arrays(*highs)))


def _rounded(low: Any, high: Any) -> Intervals:
    return Intervals(np.nextafter(low, -np.inf), np.nextafter(high, np.inf))


def _widened(low: Any, high: Any, share: float = ULPS) -> Intervals:
    # An end that has overflowed still bounds from inside: what is past the largest number is no less than it.
    with np.errstate(all="ignore"):
        low = np.minimum(low, LARGEST) - share * np.minimum(np.abs(low), LARGEST) - TINY
        high = np.maximum(high, -LARGEST) + share * np.minimum(np.abs(high), LARGEST) + TINY
    return Intervals(low, high)


def _between(x: Intervals, least: float, most: float) -> Intervals:
    """What is known to lie between two numbers besides."""
    return Intervals(np.clip(x.low, least, most), np.clip(x.high, least, most))


def _where(known: Any, found: Intervals) -> Intervals:
    """The whole line where something isn't known."""
    return Intervals(np.where(known, found.low, -np.inf), np.where(known, found.high, np.inf))


def _rising(x: Intervals, function: Any, known: Any = True) -> Intervals:
    """A function that rises all over its domain."""
    with np.errstate(all="ignore"):
        return _where(known, _widened(function(x.low), function(x.high)))


@register("square")
def square(x: Any) -> Intervals:
    """Square."""
    return lift(x) ** 2


@register("sqrt")
def sqrt(x: Any) -> Intervals:
    """Square root; the whole line where the argument may be below 0."""
    x = lift(x)
    with np.errstate(all="ignore"):
        found = _rounded(np.sqrt(x.low), np.sqrt(x.high))
    return _where(x.low >= 0, Intervals(np.maximum(found.low, 0.0), found.high))


@register("exp")
def exp(x: Any) -> Intervals:
    """Power of e."""
    found = _rising(lift(x), np.exp)
    return Intervals(np.maximum(found.low, 0.0), found.high)


@register("log")
def log(x: Any) -> Intervals:
    """Natural logarithm; the whole line where the argument may be 0 or below."""
    x = lift(x)
    return _rising(x, np.log, x.low > 0)


@register("sin")
def sin(x: Any) -> Intervals:
    """Sine: of the ends, 1 or -1 where a top or bottom lies between, to round-off."""
    return _wave(lift(x), np.sin, 0.25)


@register("cos")
def cos(x: Any) -> Intervals:
    """Cosine."""
    return _wave(lift(x), np.cos, 0.0)


def _wave(x: Intervals, function: Any, top: float) -> Intervals:
    """A wave of period 2 pi with a top at ``top`` turns."""
    far = ~((np.abs(x.low) < FARTHEST) & (np.abs(x.high) < FARTHEST))
    low, high = np.where(far, 0.0, x.low), np.where(far, 0.0, x.high)
    ends = function(low), function(high)
    found = _widened(np.minimum(*ends), np.maximum(*ends))
    # In turns, widened by far more than their round-off: 1e9 rad are known to 1e-7.
    first, last = (end / (2 * np.pi) + way * 4e-16 * (1 + np.abs(end)) for end, way in ((low, -1), (high, 1)))

    def between(at: float) -> Any:
        return np.floor(last - at) >= np.ceil(first - at)

    low = np.where(far | between(top + 0.5), -1.0, found.low)
    high = np.where(far | between(top), 1.0, found.high)
    return _between(Intervals(low, high), -1.0, 1.0)


@register("tan")
def tan(x: Any) -> Intervals:
    """Tangent; the whole line where a pole may lie between the ends."""
    x = lift(x)
    near = (np.abs(x.low) < FARTHEST) & (np.abs(x.high) < FARTHEST)
    low, high = np.where(near, x.low, 0.0), np.where(near, x.high, 0.0)
    first, last = (end / np.pi - 0.5 + way * 8e-16 * (1 + np.abs(end)) for end, way in ((low, -1), (high, 1)))
    return _rising(Intervals(low, high), np.tan, near & (np.floor(first) == np.floor(last)))


@register("arcsin")
def arcsin(x: Any) -> Intervals:
    """Arc sine; the whole line where the argument may lie beyond -1 and 1."""
    x = lift(x)
    return _rising(x, np.arcsin, (x.low >= -1) & (x.high <= 1))


@register("arccos")
def arccos(x: Any) -> Intervals:
    """Arc cosine; the whole line where the argument may lie beyond -1 and 1."""
    x = lift(x)
    return _rising(Intervals(-x.high, -x.low), lambda end: np.arccos(-end), (x.low >= -1) & (x.high <= 1))


@register("arctan")
def arctan(x: Any) -> Intervals:
    """Arc tangent."""
    return _rising(lift(x), np.arctan)


@register("arctan2")
def arctan2(y: Any, x: Any) -> Intervals:
    """The angle of the vector (x, y); all angles where the vector may lie on the cut."""
    y, x = lift(y), lift(x)
    ends = [np.arctan2(b, a) for b in (y.low, y.high) for a in (x.low, x.high)]
    corners = np.stack(np.broadcast_arrays(*ends))
    found = _widened(corners.min(axis=0), corners.max(axis=0))
    cut = (x.low <= 0) & (y.low <= 0) & (y.high >= 0)
    low, high = np.where(cut, -HALF_TURN, found.low), np.where(cut, HALF_TURN, found.high)
    return _between(Intervals(low, high), -HALF_TURN, HALF_TURN)


@register("hypot")
def hypot(x: Any, y: Any) -> Intervals:
    """The length of a vector."""
    x, y = absolute(x), absolute(y)
    found = _widened(np.hypot(x.low, y.low), np.hypot(x.high, y.high))
    return Intervals(np.maximum(found.low, 0.0), found.high)


@register("abs", "fabs", "absolute")
def absolute(x: Any) -> Intervals:
    """Magnitude."""
    x = lift(x)
    over = (x.low <= 0) & (x.high >= 0)
    ends = np.abs(x.low), np.abs(x.high)
    return Intervals(np.where(over, 0.0, np.minimum(*ends)), np.maximum(*ends))


@register("minimum", "fmin")
def minimum(x: Any, y: Any) -> Intervals:
    """The smaller."""
    x, y = lift(x), lift(y)
    return Intervals(np.minimum(x.low, y.low), np.minimum(x.high, y.high))


@register("maximum", "fmax")
def maximum(x: Any, y: Any) -> Intervals:
    """The larger."""
    x, y = lift(x), lift(y)
    return Intervals(np.maximum(x.low, y.low), np.maximum(x.high, y.high))


@register("sign")
def sign(x: Any) -> Intervals:
    """-1, 0 or 1."""
    x = lift(x)
    return Intervals(np.sign(x.low), np.sign(x.high))


@register("copysign")
def copysign(x: Any, y: Any) -> Intervals:
    """The size of x with the sign of y, plus for 0."""
    y, size = lift(y), absolute(x)
    some = hull(size, -size)
    return Intervals(
        np.where(y.low >= 0, size.low, np.where(y.high < 0, -size.high, some.low)),
        np.where(y.low >= 0, size.high, np.where(y.high < 0, -size.low, some.high)),
    )


@register("floor")
def floor(x: Any) -> Intervals:
    """The whole number below."""
    x = lift(x)
    return Intervals(np.floor(x.low), np.floor(x.high))


# Conditions: [1, 1] where they hold, [0, 0] where not, [0, 1] where that is undecided.


def _flag(sure: Any, never: Any) -> Intervals:
    return Intervals(np.where(sure, 1.0, 0.0), np.where(never, 0.0, 1.0))


@register("less")
def less(x: Any, y: Any) -> Intervals:
    """Whether x < y."""
    x, y = lift(x), lift(y)
    return _flag(x.high < y.low, x.low >= y.high)


@register("less_equal")
def less_equal(x: Any, y: Any) -> Intervals:
    """Whether x <= y."""
    x, y = lift(x), lift(y)
    return _flag(x.high <= y.low, x.low > y.high)


@register("equal")
def equal(x: Any, y: Any) -> Intervals:
    """Whether x = y."""
    x, y = lift(x), lift(y)
    same = (x.low == x.high) & (y.low == y.high) & (x.low == y.low)
    return _flag(same, (x.high < y.low) | (y.high < x.low))


@register("not_equal")
def not_equal(x: Any, y: Any) -> Intervals:
    """Whether x isn't y."""
    return logical_not(equal(x, y))


@register("logical_not")
def logical_not(x: Any) -> Intervals:
    """Whether it is 0."""
    x = lift(x)
    return _flag((x.low == 0) & (x.high == 0), (x.low > 0) | (x.high < 0))


@register("logical_and")
def logical_and(x: Any, y: Any) -> Intervals:
    """Whether neither is 0."""
    x, y = (logical_not(logical_not(part)) for part in (x, y))
    return minimum(x, y)


@register("logical_or")
def logical_or(x: Any, y: Any) -> Intervals:
    """Whether one isn't 0."""
    x, y = (logical_not(logical_not(part)) for part in (x, y))
    return maximum(x, y)


@register("where")
def where(condition: Any, x: Any, y: Any) -> Intervals:
    """x where a condition holds, y where not, both where that is undecided."""
    never, x, y = logical_not(condition), lift(x), lift(y)
    both = hull(x, y)
    sure, not_ = never.high == 0, never.low == 1
    return Intervals(
        np.where(sure, x.low, np.where(not_, y.low, both.low)),
        np.where(sure, x.high, np.where(not_, y.high, both.high)),
    )


@register("if_else_zero")
def if_else_zero(condition: Any, x: Any) -> Intervals:
    """x where a condition holds, 0 elsewhere."""
    return where(condition, x, 0.0)
