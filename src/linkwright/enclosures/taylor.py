"""Taylor models: functions of time enclosed over panels as a polynomial and a bound of what it misses.

Over each panel the function is ``sum c[k] h^k + e`` with h in -1 .. 1 and ``|e| <= r``. The bound counts the terms
beyond the panels' order and all round-off, so it holds for the exact value of the expression at the doubles given.
Makino and Berz, "Taylor models and other validated functional inclusion methods", Int. J. Pure Appl. Math. 4 (2003)
379; Moore, Kearfott, Cloud, Introduction to Interval Analysis (2009), ch. 8; Tucker, Validated Numerics (2011).

A bound that is NaN or infinite says that nothing is known there: a root or logarithm that may leave its domain, a
denominator that may vanish. It goes through all arithmetic, and never becomes a number again.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import singledispatch
from typing import Any

import numpy as np
from numpy.lib.stride_tricks import as_strided
from numpy.typing import NDArray

from linkwright.enclosures.bounds import ROUND, UP, bounds
from linkwright.enclosures.panels import Panels

Array = NDArray[np.float64]

TINY = 1e-300
"""Covers what is lost below the smallest doubles."""

UNITS = {"d": ROUND, "g": float(np.finfo(np.longdouble).eps) / 2}
"""The relative error of one operation, of doubles and long doubles."""
POWERS = np.arange(64, dtype=float)

_kept = threading.local()


class TaylorModel:
    """A function of time over panels: coefficients ``c`` (terms, panels), bounds ``r`` (panels,) of what they miss.

    A number that is the same over all panels has the shapes (1, 1) and (1,), and no panels.
    """

    __slots__ = ("_inverse", "_size", "_tilt", "c", "on", "r")
    __array_priority__ = 1000
    __array_ufunc__ = None

    def __init__(self, c: Array, r: Array, on: Panels | None, size: Array | None = None) -> None:
        self.c, self.r, self.on = c, r, on
        self._size: Array | None = size
        self._tilt: Array | None = None
        self._inverse: TaylorModel | None = None

    @classmethod
    def number(cls, value: float, error: float = 0.0, dtype: Any = np.float64) -> TaylorModel:
        """A number that is the same over all panels, known to an ``error``."""
        return cls(np.full((1, 1), value, dtype=dtype), np.full(1, float(error)), None)

    @classmethod
    def time(cls, on: Panels) -> TaylorModel:
        """The time (s)."""
        return cls(np.stack([on.mid, on.half]), np.zeros(on.count), on)

    @property
    def size(self) -> Array:
        """The sum of the coefficients' magnitudes: a bound of the polynomial."""
        if self._size is None:
            self._size = np.asarray(np.add.reduce(np.abs(self.c), axis=0))
        return self._size

    @property
    def tilt(self) -> Array:
        """The sum of the coefficients' magnitudes times their powers."""
        if self._tilt is None:
            self._tilt = np.asarray(POWERS[: len(self.c)] @ np.abs(self.c))
        return self._tilt

    @property
    def magnitude_bound(self) -> Array:
        """A bound of the magnitude."""
        return np.asarray((self.size + self.r) * UP)

    def is_zero(self) -> bool:
        """Whether it is the number 0, exactly."""
        return self.on is None and self.c[0, 0] == 0.0 and self.r[0] == 0.0

    def spread(self) -> Array:
        """A bound of how far it strays from its first coefficient."""
        return np.asarray((self.size - np.abs(self.c[0]) * (1 - 1e-14) + self.r) * UP)

    def range(self) -> tuple[Array, Array]:
        """Bounds (low, high) on each panel; not the tightest."""
        spread = self.spread()
        low, high = self.c[0] - spread, self.c[0] + spread
        slack = 4 * ROUND * (np.abs(low) + np.abs(high)) + TINY
        return low - slack, high + slack

    def __repr__(self) -> str:
        return f"TaylorModel({self.c!r}, {self.r!r})"

    # Arithmetic.

    def __add__(self, other: Any) -> TaylorModel:
        more = lift(other)
        if more.is_zero():
            return self
        if self.is_zero():
            return more
        # Add the coefficients; the shorter polynomial has no terms of higher powers.
        long, short = (self, more) if len(self.c) >= len(more.c) else (more, self)
        if len(long.c) == len(short.c):
            c = long.c + short.c
        else:
            wide = max(long.c.shape[1], short.c.shape[1])
            c = long.c.copy() if long.c.shape[1] == wide else np.repeat(long.c, wide, axis=1)
            c[: len(short.c)] += short.c
        # Each coefficient is rounded once, which is at most a unit of the sum of their magnitudes.
        size = np.add.reduce(np.abs(c), axis=0)
        return TaylorModel(c, (self.r + more.r + UNITS[c.dtype.char] * size) * UP, self.on or more.on, size)

    __radd__ = __add__

    def __neg__(self) -> TaylorModel:
        return TaylorModel(-self.c, self.r, self.on, self._size)

    def __pos__(self) -> TaylorModel:
        return self

    def __sub__(self, other: Any) -> TaylorModel:
        return self + (-lift(other))

    def __rsub__(self, other: Any) -> TaylorModel:
        return lift(other) + (-self)

    def __mul__(self, other: Any) -> TaylorModel:
        other = lift(other)
        if self.is_zero() or other.is_zero():
            return ZERO
        # All coefficients of the product, also those above the order of the panels.
        c = product(self.c, other.c)
        on = self.on or other.on
        # Remainder: each polynomial times the other's remainder, both remainders, and round-off.
        r = self.size * other.r + self.r * (other.size + other.r) + rounding(self, other)
        # Terms above the order go into the remainder, as |h| <= 1.
        if on is not None and len(c) > on.order + 1:
            r = r + np.add.reduce(np.abs(c[on.order + 1 :]), axis=0)
            c = c[: on.order + 1]
        return TaylorModel(c, r * UP, on)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> TaylorModel:
        return self * lift(other).inverse()

    def __rtruediv__(self, other: Any) -> TaylorModel:
        return lift(other) * self.inverse()

    def inverse(self) -> TaylorModel:
        """1 over it: a series y, and its error from the proof that e = 1 - y b is below 1, as 1/b = y / (1 - e)."""
        if self._inverse is None:
            with np.errstate(all="ignore"):
                # An approximate inverse first: a truncated series in floating point.
                y = reciprocal_series(self.c, self.on.order if self.on is not None else 0)
                found = TaylorModel(y, np.zeros_like(y[0]), self.on)
                # Then its residual e = 1 - y b, bounded with all round-off; it proves how good the series is.
                short = product(self.c, y)
                short[0] -= 1.0
                e = np.add.reduce(np.abs(short), axis=0) * UP + rounding(self, found) + self.r * found.size
                e = e * UP
                # 1/b = y / (1 - e), so y misses at most |y| e / (1 - e); nothing is known where e may reach 1.
                found.r = np.where(e < 1.0, found.size * e / (1.0 - e) * UP + TINY, np.nan)
            self._inverse = found
        return self._inverse

    def __pow__(self, power: Any) -> TaylorModel:
        power = float(power) if isinstance(power, int | float | np.number) else power
        if not isinstance(power, float) and (whole := _plain(power)) is not None:
            power = whole
        if isinstance(power, float):
            if power == int(power) and abs(power) <= 64:
                return self._integer_power(int(power))
            if power == 0.5:
                return self.elementary("sqrt", self)
            if power == -0.5:
                return self.elementary("sqrt", self).inverse()
        return self.elementary("exp", self.elementary("log", self) * power)

    def __rpow__(self, base: Any) -> TaylorModel:
        return lift(base) ** self

    def _integer_power(self, power: int) -> TaylorModel:
        if power < 0:
            return self.inverse()._integer_power(-power)
        # Square and multiply.
        found, square = ONE, self
        while power:
            if power & 1:
                found = square if found is ONE else found * square
            power >>= 1
            if power:
                square = square * square
        return found

    def __abs__(self) -> TaylorModel:
        return self.elementary("abs", self)

    def __le__(self, other: Any) -> TaylorModel:
        return self.elementary("less_equal", self, other)

    def __lt__(self, other: Any) -> TaylorModel:
        return self.elementary("less", self, other)

    def __ge__(self, other: Any) -> TaylorModel:
        return self.elementary("less_equal", other, self)

    def __gt__(self, other: Any) -> TaylorModel:
        return self.elementary("less", other, self)

    @staticmethod
    def elementary(name: str, *args: Any) -> TaylorModel:
        """An elementary function by its NumPy name."""
        found: TaylorModel = FUNCTIONS[name](*args)
        return found

    def __array_function__(self, function: Any, types: Any, args: Any, kwargs: Any) -> Any:
        """``zeros_like`` and ``ones_like``, which drives' laws ask of the time."""
        return {np.zeros_like: ZERO, np.ones_like: ONE}.get(function, NotImplemented)

    def along(self, function: Any, order: int = 0, integral: bool = False) -> TaylorModel:
        """A derivative of a motion law or table at its values; see :mod:`linkwright.enclosures.pieces`."""
        return along(function, self, order, integral)

    # Signs.

    def sign(self) -> Array:
        """1 or -1 where that is the sign all over a panel, the margins to its neighbours apart; 0 where undecided."""
        with np.errstate(invalid="ignore"):
            # The cheap test: the constant term outweighs all others and the remainder.
            clear = np.abs(self.c[0]) > self.spread() * (1 + 1e-14)
            found = np.where(clear, np.sign(self.c[0]), 0.0)
            if self.on is None or len(self.c) < 2 or clear.all():
                return found
            # Where it fails, bound the polynomial more tightly, over the panel without its margins.
            rest = np.flatnonzero(~clear & np.isfinite(self.r))
            r = np.broadcast_to(self.r, clear.shape)[rest]
            low, high = bounds(self.c[:, rest] * self.on.inner[rest] ** POWERS[: len(self.c), None])
            found[rest] = np.where(low > r, 1.0, np.where(high < -r, -1.0, 0.0))
            return found


def lift(value: Any) -> TaylorModel:
    """A number as a model; a model as it is."""
    return value if isinstance(value, TaylorModel) else TaylorModel.number(value)


def rounding(a: TaylorModel, b: TaylorModel) -> Array:
    """A bound of the round-off of a product of polynomials: the coefficient of power k is a sum of k + 1 products at
    most, those of higher powers are small on narrow panels."""
    unit = max(UNITS[a.c.dtype.char], UNITS[b.c.dtype.char]) if a.c.dtype == b.c.dtype else UNITS["g"]
    return np.asarray(unit * (a.size * (b.size + b.tilt) + a.tilt * b.size) + TINY)


ZERO, ONE = TaylorModel.number(0.0), TaylorModel.number(1.0)


def _plain(value: Any) -> float | None:
    """The number that a model is exactly."""
    exact = isinstance(value, TaylorModel) and value.on is None and value.r[0] == 0
    return float(value.c[0, 0]) if exact else None


def product(a: Array, b: Array) -> Array:
    """The coefficients of the products of polynomials, (terms, panels) each, all of them.

    The outer product is written so that what belongs to one power stands in one column of a buffer.
    """
    if len(a) > len(b):
        a, b = b, a
    # A constant factor needs no convolution.
    if len(a) == 1:
        return np.asarray(a * b)
    wide = max(a.shape[1], b.shape[1])
    dtype = np.result_type(a, b)
    key = len(a), len(b), wide, dtype.char
    kept: dict[Any, tuple[Array, Array]] = _kept.__dict__.setdefault("buffers", {})
    if key not in kept:
        if len(kept) > 200:
            kept.clear()
        # A view that shifts row i by i columns: written as an outer product, summed along the rows it is the
        # convolution. The buffers are kept by shape, as their allocation would dominate.
        buffer = np.zeros((len(a), len(a) + len(b) - 1, wide), dtype=dtype)
        row, column, item = buffer.strides
        kept[key] = buffer, as_strided(buffer, (len(a), len(b), wide), (row + column, column, item))
    buffer, slanted = kept[key]
    np.multiply(a[:, None], b[None], out=slanted)
    return np.asarray(np.add.reduce(buffer, axis=0))


def reciprocal_series(b: Array, order: int) -> Array:
    """The first coefficients of 1 / b, to round-off."""
    order = order if len(b) > 1 else 0
    y = np.empty((order + 1, b.shape[1]), dtype=b.dtype)
    y[0] = first = 1.0 / b[0]
    # From b y = 1: coefficient k of the product vanishes for k > 0.
    for k in range(1, order + 1):
        n = min(k, len(b) - 1)
        y[k] = -np.einsum("ip,ip->p", b[1 : n + 1], y[k - n : k][::-1]) * first
    return y


def root_series(a: Array, order: int) -> Array:
    """The first coefficients of the square root of a, to round-off."""
    order = order if len(a) > 1 else 0
    s = np.empty((order + 1, a.shape[1]), dtype=a.dtype)
    s[0] = np.sqrt(a[0])
    half = 0.5 / s[0]
    # From s s = a: solve coefficient k for s[k], the others are known.
    for k in range(1, order + 1):
        given = a[k] if k < len(a) else 0.0
        known = np.einsum("ip,ip->p", s[1:k], s[1:k][::-1]) if k > 1 else 0.0
        s[k] = (given - known) * half
    return s


Function = Callable[..., TaylorModel]
FUNCTIONS: dict[str, Function] = {}
"""Elementary functions by their NumPy names, as :mod:`linkwright.enclosures.functions` registers them."""


@singledispatch
def along(function: Any, x: TaylorModel, order: int, integral: bool = False) -> TaylorModel:
    """A derivative of a function in pieces, or its integral, at the values of a model.

    :mod:`linkwright.enclosures.pieces` registers how, by the function's class.
    """
    raise TypeError(f"no enclosure of a {type(function).__name__}")
