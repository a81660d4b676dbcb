"""Duals: a number with its derivative in one direction, as the entry of a jet in time.

A jet of duals carries mixed derivatives: in time, and by a parameter. Duals are a type of their own so that the two
are never taken for one another (Siskind and Pearlmutter, "Perturbation confusion and referential transparency",
IFL 2005). Values and slopes are floats or arrays that broadcast.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from linkwright.notation.jets import Jet


class Dual:
    """``value`` and ``slope``; arithmetic is that of a jet of order 1."""

    __slots__ = ("jet",)
    __array_ufunc__ = None

    def __init__(self, value: Any, slope: Any) -> None:
        self.jet = Jet((value, slope))

    @property
    def value(self) -> Any:
        """The number."""
        return self.jet.d[0]

    @property
    def slope(self) -> Any:
        """Its derivative."""
        return self.jet.d[1]

    def __repr__(self) -> str:
        return f"Dual({self.value}, {self.slope})"

    def __add__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, Jet) else _dual(self.jet + _jet(other))

    __radd__ = __add__

    def __neg__(self) -> Dual:
        return _dual(-self.jet)

    def __sub__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, Jet) else _dual(self.jet - _jet(other))

    def __rsub__(self, other: Any) -> Any:
        return _dual(_jet(other) - self.jet)

    def __mul__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, Jet) else _dual(self.jet * _jet(other))

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        return NotImplemented if isinstance(other, Jet) else _dual(self.jet / _jet(other))

    def __rtruediv__(self, other: Any) -> Any:
        return _dual(_jet(other) / self.jet)

    def __pow__(self, power: Any) -> Any:
        if isinstance(power, Jet):
            return NotImplemented
        return _dual(self.jet ** (power.jet if isinstance(power, Dual) else power))

    def __rpow__(self, base: Any) -> Dual:
        return _dual(base**self.jet)

    def raised(self, base: Jet) -> Jet:
        """``base ** self``; its slope by the power is base^power log(base), NaN where that grows without bound at 0."""
        found, plain = base**self.value, Jet([value_of(d) for d in base.d])
        power, start = plain**self.value, plain.d[0] == 0
        log, grows, entries = Jet([np.where(start, 1.0, plain.d[0]), *plain.d[1:]]).log(), False, []
        for k, more in enumerate((power * log).d):
            grows = grows | (power.d[k] != 0)
            slope = np.where(start & grows, np.nan, more) * self.slope
            entries.append(Dual(value_of(found.d[k]), slope_of(found.d[k]) + slope))
        return Jet(entries)

    def __abs__(self) -> Dual:
        return _dual(abs(self.jet))

    def __lt__(self, other: Any) -> Any:
        return self.value < value_of(other)

    def __le__(self, other: Any) -> Any:
        return self.value <= value_of(other)

    def __gt__(self, other: Any) -> Any:
        return self.value > value_of(other)

    def __ge__(self, other: Any) -> Any:
        return self.value >= value_of(other)

    @staticmethod
    def elementary(name: str, *args: Any) -> Any:
        """An elementary function by its NumPy name; some of the arguments are duals."""
        if name == "copysign":  # only the sign of the second counts
            return np.copysign(*map(value_of, args))
        if name == "where":
            return _dual(_jet(args[1]).where(args[0], _jet(args[2])))
        if name == "abs":
            return abs(args[0])
        first, *others = map(_jet, args)
        return _dual(getattr(first, {"fmin": "minimum", "fmax": "maximum"}.get(name, name))(*others))


def value_of(number: Any) -> Any:
    """The value of a dual, or the number itself."""
    return number.value if isinstance(number, Dual) else number


def slope_of(number: Any) -> Any:
    """The slope of a dual; of other numbers 0."""
    return number.slope if isinstance(number, Dual) else 0.0


def _jet(number: Any) -> Jet:
    return number.jet if isinstance(number, Dual) else Jet((number, 0.0))


def _dual(jet: Jet) -> Dual:
    return Dual(*jet.d)
