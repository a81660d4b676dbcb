"""Germs: the behaviour of an expression on one side of a time, as a series in the distance s > 0 from it.

A germ is a truncated Puiseux series ``s^low (c0 + c1 s^step + c2 s^(2 step) + ...)``, with an error bound of each
coefficient. Arithmetic and elementary functions map germs to germs. A coefficient that is zero within its error counts
as zero; the leading exponent then tells poles (and the sign of infinity), jumps, roots and removable singularities
apart. Where the errors are too large for a decision, :class:`Undecided` is raised.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.notation import Jet

Array = NDArray[np.float64]

TERMS = 8
"""Coefficients that a germ holds at most."""
EPS = float(np.finfo(float).eps)
SURE = 16.0
"""A coefficient so many times its error is not zero ..."""
SMALL = 4.0
"""... and one below so many times is; between the two nothing is decided."""
FINEST = 12
"""The finest step of exponents, as a denominator."""


class Undecided(Exception):
    """The coefficients' errors don't let the orders be told."""


class Germ:
    """A series in s^step beginning at s^low; ``c`` and ``e`` (terms,) are coefficients and their errors."""

    __slots__ = ("c", "e", "low", "step")
    __array_priority__ = 1000
    __array_ufunc__ = None

    def __init__(self, c: Array, e: Array, low: Fraction = Fraction(0), step: Fraction = Fraction(1)) -> None:
        self.c, self.e, self.low, self.step = c[:TERMS], e[:TERMS], low, step

    @classmethod
    def constant(cls, value: float, error: float = 0.0) -> Germ:
        """A value that doesn't change."""
        c, e = np.zeros(TERMS), np.zeros(TERMS)
        c[0], e[0] = value, error
        return cls(c, e)

    def leading(self) -> tuple[Fraction, float] | None:
        """Exponent and coefficient of the first term that isn't zero; ``None`` where all known ones are."""
        # Go up the coefficients: clearly zero, clearly not zero, or in between, which decides nothing.
        for k, (c, e) in enumerate(zip(self.c.tolist(), self.e.tolist(), strict=True)):
            if not math.isfinite(c) or SMALL * e < abs(c) <= SURE * e:
                raise Undecided
            if abs(c) > SURE * e:
                return self.low + k * self.step, c
        return None

    def stripped(self) -> Germ:
        """The same without the terms before the leading one. Raises :class:`Undecided` where none is known."""
        lead = self.leading()
        if lead is None:
            raise Undecided
        k = int((lead[0] - self.low) / self.step)
        return Germ(self.c[k:], self.e[k:], lead[0], self.step)

    def shortened(self) -> Germ:
        """The same, :meth:`stripped` where it is known which term leads."""
        try:
            return self.stripped()
        except Undecided:
            return self

    def __call__(self, s: Array) -> Array:
        """Its values at distances s > 0."""
        total = np.zeros_like(s)
        for k, c in enumerate(self.c.tolist()):
            if c:
                total = total + c * s ** float(self.low + k * self.step)
        return total

    @property
    def sign(self) -> float:
        """The sign right beside; 0 where all known terms are zero."""
        lead = self.leading()
        return 0.0 if lead is None else math.copysign(1.0, lead[1])

    def limit(self) -> tuple[float, Fraction]:
        """The value towards s = 0, infinite with its sign for a pole, and the leading exponent. Raises
        :class:`Undecided` where the known terms end before the constant one."""
        lead = self.leading()
        if lead is None:
            # All known terms are zero: the value is too, if they reach as far as the constant term.
            if self.low + self.c.size * self.step <= 0:
                raise Undecided
            return 0.0, Fraction(0)
        if lead[0] > 0:
            return 0.0, lead[0]
        if lead[0] < 0:
            return math.copysign(math.inf, lead[1]), lead[0]
        return lead[1], lead[0]

    @property
    def error(self) -> float:
        """How far the constant term may be off; 0 where it isn't one of the series' terms."""
        place = -self.low / self.step
        return float(self.e[int(place)]) if place.denominator == 1 and 0 <= place < self.e.size else 0.0

    def on(self, step: Fraction) -> Germ:
        """The same on a finer step of exponents."""
        ratio = int(self.step / step)
        if ratio == 1:
            return self
        size = min(self.c.size * ratio, TERMS)
        c, e = np.zeros(size), np.zeros(size)
        count = len(c[::ratio])
        c[::ratio], e[::ratio] = self.c[:count], self.e[:count]
        return Germ(c, e, self.low, step)

    def _aligned(self, other: Germ) -> tuple[Germ, Germ]:
        step = _common(self.step, other.step, self.low - other.low)
        return self.on(step), other.on(step)

    def __add__(self, other: Germ | float) -> Germ:
        if not isinstance(other, Germ):
            return self + Germ.constant(float(other))
        # Bring both to a common step of exponents, then shift the one that begins later.
        a, b = self._aligned(other)
        if a.low > b.low:
            a, b = b, a
        shift = int((b.low - a.low) / a.step)
        size = min(a.c.size, shift + b.c.size, TERMS)
        c, e = a.c[:size].copy(), a.e[:size].copy()
        count = max(0, size - shift)
        c[shift:size] += b.c[:count]
        e[shift:size] += b.e[:count] + EPS * np.abs(c[shift:size])
        return Germ(c, e, a.low, a.step)

    __radd__ = __add__

    def __neg__(self) -> Germ:
        return Germ(-self.c, self.e, self.low, self.step)

    def __sub__(self, other: Germ | float) -> Germ:
        return self + (-other)

    def __rsub__(self, other: float) -> Germ:
        return -self + other

    def __mul__(self, other: Germ | float) -> Germ:
        if not isinstance(other, Germ):
            factor = float(other)
            return Germ(self.c * factor, (self.e + EPS * np.abs(self.c)) * abs(factor), self.low, self.step)
        a, b = self._aligned(other)
        size = min(a.c.size, b.c.size)
        # Product of series by convolution; errors by the product rule, plus round-off.
        c = np.convolve(a.c, b.c)[:size]
        e = np.convolve(np.abs(a.c), b.e)[:size] + np.convolve(a.e, np.abs(b.c) + b.e)[:size]
        return Germ(c, e + EPS * np.convolve(np.abs(a.c), np.abs(b.c))[:size], a.low + b.low, a.step)

    __rmul__ = __mul__

    def __truediv__(self, other: Germ | float) -> Germ:
        if not isinstance(other, Germ):
            return self * (1.0 / float(other)) if float(other) != 0 else _raise()
        return self.shortened() * other._inverse()

    def __rtruediv__(self, other: float) -> Germ:
        return self._inverse() * float(other)

    def _inverse(self) -> Germ:
        """One over it: the coefficients solve d * q = 1 one after the other."""
        d = self.stripped()
        size = d.c.size
        q, e = np.zeros(size), np.zeros(size)
        # Coefficient k of d q = 1 gives q[k] from those before; its error follows the same recursion.
        for k in range(size):
            known = float(np.dot(d.c[1 : k + 1], q[:k][::-1])) if k else 0.0
            spread = float(np.dot(np.abs(d.c[1 : k + 1]), e[:k][::-1] + EPS * np.abs(q[:k][::-1]))) if k else 0.0
            spread += float(np.dot(d.e[1 : k + 1], np.abs(q[:k][::-1]))) if k else 0.0
            q[k] = ((1.0 if k == 0 else 0.0) - known) / d.c[0]
            e[k] = (spread + abs(q[k]) * d.e[0]) / abs(d.c[0]) + 2 * EPS * abs(q[k])
        return Germ(q, e, -d.low, d.step)

    def __pow__(self, power: Any) -> Germ:
        if isinstance(power, Germ):
            value, rest = power.c[0], power.c[1:]
            if power.low == 0 and not rest.any():
                return self ** float(value)
            return (self.elementary("log", self) * power).elementary("exp", self.elementary("log", self) * power)
        if power == int(power) and 0 <= power <= 8:
            # Without the terms that are zero before the leading one, more of the others are kept.
            factor, product = self.shortened(), Germ.constant(1.0)
            for _ in range(int(power)):
                product = product * factor
            return product
        base = self.leading()
        if base is None:
            raise Undecided
        # Factor out the leading term: x = c0 s^low (1 + u).
        unit = self.stripped()
        exponent = Fraction(float(power)).limit_denominator(FINEST)
        if power != int(power) and unit.c[0] < 0:
            return Germ.constant(math.nan)
        # Its power is exact: |c0|^p, with the sign that integer powers have.
        first = abs(unit.c[0]) ** float(power) * (1.0 if unit.c[0] > 0 or int(power) % 2 == 0 else -1.0)
        # (1 + u)^p by the binomial series, as u begins with a positive power of s.
        u = Germ(unit.c / unit.c[0], (unit.e + EPS * np.abs(unit.c)) / abs(unit.c[0]), Fraction(0), unit.step)
        u.c[0], u.e[0] = 0.0, 0.0
        total, term = Germ.constant(1.0), Germ.constant(1.0)
        for k in range(1, unit.c.size):
            term = term * u * ((float(power) - k + 1) / k)
            total = total + term
        # The relative error of c0 is multiplied by the power.
        error = float(unit.e[0] / abs(unit.c[0])) * abs(float(power))
        series = total * first
        series = Germ(series.c, series.e + error * np.abs(series.c), series.low, series.step)
        return Germ(series.c, series.e, series.low + unit.low * exponent, series.step)

    def __rpow__(self, base: float) -> Germ:
        return self.elementary("exp", self * math.log(base)) if base > 0 else _raise()

    def __abs__(self) -> Germ:
        return -self if self.sign < 0 else self

    def __lt__(self, other: Germ | float) -> bool:
        return (self - other).sign < 0

    def __gt__(self, other: Germ | float) -> bool:
        return (self - other).sign > 0

    def regular(self) -> Germ:
        """The same from exponent 0 on. Raises :class:`Undecided` for a pole."""
        if self.low == 0:
            return self
        lead = self.leading()
        if lead is not None and lead[0] < 0:
            raise Undecided
        return Germ.constant(0.0) + (self if lead is None else self.stripped())

    def elementary(self, name: str, *args: Any) -> Germ:
        """An elementary function, by its NumPy name, as :func:`linkwright.notation.jets.call` asks for it."""
        own = _SPECIAL.get(name)
        if own is not None:
            return own(*(arg if isinstance(arg, Germ) else Germ.constant(float(arg)) for arg in args))
        return _smooth(name, *args)


def _raise() -> Germ:
    raise Undecided


def _common(*exponents: Fraction) -> Fraction:
    """The coarsest step of which all are multiples."""
    bottom = math.lcm(*(exponent.denominator for exponent in exponents))
    if bottom > FINEST:
        raise Undecided
    return Fraction(math.gcd(*(int(e * bottom) for e in exponents)) or bottom, bottom)


def _smooth(name: str, *args: Germ) -> Germ:
    """A function that is smooth at the arguments' values, by jets in s^step."""
    (germ,) = args
    # Taylor coefficients of f at the value, by jets: coefficients times k! are derivatives.
    germ = germ.regular()
    at = float(germ.c[0])
    factorials = np.cumprod([1.0, *range(1, germ.c.size)])
    jet = getattr(Jet(list(germ.c * factorials)), name)()
    c = np.array([float(d) for d in jet.d]) / factorials
    slope = getattr(Jet([at, 1.0]), name)().d[1]
    if not np.isfinite(c).all() or not math.isfinite(slope):
        raise Undecided
    # Errors grow with the slope of the function.
    e = np.convolve(germ.e, np.abs(c) + abs(slope))[: c.size] + 4 * EPS * np.abs(c)
    return Germ(c, e, Fraction(0), germ.step)


def _log(x: Germ) -> Germ:
    lead = x.leading()
    if lead is None or lead[0] != 0:
        raise Undecided  # grows like log s
    return _smooth("log", x) if lead[1] > 0 else Germ.constant(math.nan)


def _sqrt(x: Germ) -> Germ:
    return Germ.constant(0.0) if x.leading() is None else x**0.5


def _exp(x: Germ) -> Germ:
    lead = x.leading()
    if lead is not None and lead[0] < 0:
        if lead[1] > 0:
            raise Undecided  # grows faster than any power
        return Germ.constant(0.0)
    return _smooth("exp", x)


def _tan(x: Germ) -> Germ:
    return _smooth("sin", x) / _smooth("cos", x)


def _arcsin(x: Germ) -> Germ:
    x = x.regular()
    # Near +-1 the arc sine has a vertical tangent, so the distance from there decides.
    off = 1.0 - abs(x)
    lead = off.leading()
    if lead is None:
        return Germ(np.array([math.copysign(math.pi / 2, x.c[0])]), np.array([EPS]), Fraction(0), Fraction(1, 2))
    if lead[1] < 0:
        return Germ.constant(math.nan)
    if lead[0] == 0:
        return _smooth("arcsin", x)
    # asin(1 - u) = pi/2 - sqrt(2 u) (1 + u/12 + ...)
    return (Germ.constant(math.pi / 2, EPS) - (off * 2.0) ** 0.5 * (1.0 + off * (1.0 / 12.0))) * math.copysign(
        1.0, x.c[0]
    )


def _arccos(x: Germ) -> Germ:
    return math.pi / 2 - _arcsin(x)


def _arctan2(y: Germ, x: Germ) -> Germ:
    a, b = y.leading(), x.leading()
    if a is None and b is None:
        raise Undecided
    # Divide by the larger component, so that the ratio has no pole.
    if a is not None and (b is None or a[0] < b[0]):  # along the y axis, towards s = 0
        turn, ratio, start = -1.0, x / y, math.copysign(math.pi / 2, a[1])
    else:
        assert b is not None
        turn, ratio = 1.0, y / x
        above = a is None or a[1] >= 0
        start = 0.0 if b[1] > 0 else math.pi if above else -math.pi
    return start + turn * _smooth("arctan", ratio)


def _where(condition: Germ, a: Germ, b: Germ) -> Germ:
    return a if condition.c[0] else b


def _minimum(a: Germ, b: Germ) -> Germ:
    return b if b < a else a


def _maximum(a: Germ, b: Germ) -> Germ:
    return b if b > a else a


def _hypot(a: Germ, b: Germ) -> Germ:
    return _sqrt(a * a + b * b)


_SPECIAL: dict[str, Callable[..., Germ]] = {
    "log": _log,
    "sqrt": _sqrt,
    "exp": _exp,
    "tan": _tan,
    "arcsin": _arcsin,
    "arccos": _arccos,
    "arctan2": _arctan2,
    "hypot": _hypot,
    "abs": abs,
    "minimum": _minimum,
    "maximum": _maximum,
    "where": _where,
}
