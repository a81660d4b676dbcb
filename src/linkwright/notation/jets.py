"""Jets: a quantity together with its successive time derivatives.

A jet ``(f, f', f'', ...)`` carries univariate automatic differentiation (Griewank and Walther,
*Evaluating Derivatives*, 2nd ed., ch. 13): each operation maps jets to jets exactly, and its cost grows
with the square of the order instead of doubling at each one. The entries may be floats, NumPy arrays
(motion laws, measures) or symbols (the mechanism's graph); the code is the same.
"""

from __future__ import annotations

from collections.abc import Callable
from math import comb
from typing import Any

import numpy as np

from linkwright.symbols import Symbol

Scalar = Any
"""A float, a NumPy array, a dual or a symbol."""

MAX_ORDER = 3
"""The highest order reported: position 0, velocity 1, acceleration 2, jerk 3."""


def is_zero(value: Scalar) -> bool:
    """Whether a coefficient is the structural number 0 (an array or a free symbol never is)."""
    if isinstance(value, (int, float)):  # asked of each number of a graph: twice as fast as int | float
        return value == 0
    known = getattr(value, "is_zero", None)
    return bool(known()) if known is not None else False


def symbolic(value: Scalar) -> bool:
    """Whether a value is a symbol of an expression graph."""
    return isinstance(value, Symbol)


def varies(value: Scalar) -> bool:
    """Whether a value depends on free symbols."""
    return isinstance(value, Symbol) and not value.is_constant()


def call(name: str, *args: Scalar) -> Scalar:
    """Apply an elementary function by its NumPy name to numbers, arrays, duals or symbols."""
    for arg in args:
        if (own := getattr(arg, "elementary", None)) is not None:
            return own(name, *args)
    return getattr(np, name)(*args)


class Jet:
    """A value and its time derivatives, lowest order first; arithmetic keeps the lower of two orders."""

    __slots__ = ("d",)
    __array_priority__ = 1000
    __array_ufunc__ = None

    def __init__(self, d: tuple[Scalar, ...] | list[Scalar]) -> None:
        self.d = tuple(d)

    @classmethod
    def constant(cls, value: Scalar, order: int = MAX_ORDER) -> Jet:
        """A quantity that does not change in time."""
        return cls((value, *(0.0,) * order))

    @property
    def order(self) -> int:
        """The highest derivative carried."""
        return len(self.d) - 1

    def rate(self) -> Jet:
        """The time derivative, one order shorter."""
        return Jet(self.d[1:])

    def truncated(self, order: int) -> Jet:
        """The same quantity carried to at most ``order``."""
        return Jet(self.d[: order + 1])

    def __repr__(self) -> str:
        return f"Jet{self.d}"

    def _lift(self, other: Jet | Scalar) -> Jet:
        return other if isinstance(other, Jet) else Jet.constant(other, self.order)

    def __add__(self, other: Jet | Scalar) -> Jet:
        pairs = zip(self.d, self._lift(other).d, strict=False)
        return Jet([b if is_zero(a) else a if is_zero(b) else a + b for a, b in pairs])

    __radd__ = __add__

    def __neg__(self) -> Jet:
        return Jet([-a for a in self.d])

    def __sub__(self, other: Jet | Scalar) -> Jet:
        return self + (-other)

    def __rsub__(self, other: Jet | Scalar) -> Jet:
        return -self + other

    def __mul__(self, other: Jet | Scalar) -> Jet:
        if not isinstance(other, Jet):
            return Jet([0.0 if is_zero(a) or is_zero(other) else a * other for a in self.d])
        order = min(self.order, other.order)
        return Jet([leibniz(self.d, other.d, k, range(k + 1)) for k in range(order + 1)])

    __rmul__ = __mul__

    def __truediv__(self, other: Jet | Scalar) -> Jet:
        if not isinstance(other, Jet):
            return self.__mul__(1.0 / other)
        quotient: list[Scalar] = []
        for k in range(min(self.order, other.order) + 1):
            known = leibniz([*quotient, 0.0], other.d, k, range(k))
            quotient.append((self.d[k] - known) / other.d[0])
        return Jet(quotient)

    def __rtruediv__(self, other: Scalar) -> Jet:
        return Jet.constant(other, self.order) / self

    def __pow__(self, power: Any) -> Jet:
        if isinstance(power, Jet):
            if all(is_zero(d) for d in power.d[1:]) and np.ndim(power.d[0]) == 0:
                return self ** float(power.d[0])
            return (self.log() * power).exp()
        if isinstance(power, np.ndarray):
            return self._powers(power)
        if (raised := getattr(power, "raised", None)) is not None:
            return raised(self)  # type: ignore[no-any-return]
        if not isinstance(power, int | float | np.number):
            return (self.log() * Jet.constant(power, self.order)).exp()
        if power == 0:
            return Jet.constant(1.0, self.order)
        if power == int(power) and 0 < power <= 4:
            product = self
            for _ in range(int(power) - 1):
                product = product * self
            return product
        return self.chain(self.d[0] ** power, lambda f: power * f ** (power - 1))

    def _powers(self, power: np.ndarray) -> Jet:
        """A power that differs from sample to sample."""
        found = self.chain(self.d[0] ** power, lambda f: power * f._powers(power - 1))
        for whole in range(5):  # here the chain meets 0/0 where the base is 0
            found = (self**whole).where(power == whole, found)
        return found

    def __rpow__(self, base: Scalar) -> Jet:
        return self.__mul__(call("log", base)).exp()

    def chain(self, value: Scalar, slope: Callable[[Jet], Jet]) -> Jet:
        """g(f) from its value and g'(f): (g(f))' = g'(f) f', taken one order lower each time."""
        if self.order == 0:
            return Jet([value])
        return Jet([value, *(slope(self.truncated(self.order - 1)) * self.rate()).d])

    def sin(self) -> Jet:
        return self.chain(call("sin", self.d[0]), Jet.cos)

    def cos(self) -> Jet:
        return self.chain(call("cos", self.d[0]), lambda f: -f.sin())

    def tan(self) -> Jet:
        return self.sin() / self.cos()

    def exp(self) -> Jet:
        return self.chain(call("exp", self.d[0]), Jet.exp)

    def log(self) -> Jet:
        return self.chain(call("log", self.d[0]), lambda f: 1.0 / f)

    def sqrt(self) -> Jet:
        found = self.chain(call("sqrt", self.d[0]), lambda f: 0.5 / f.sqrt())
        if self.order > 0 and isinstance(self.d[0], np.ndarray):
            return found._resting(self)
        return found

    def _resting(self, argument: Jet) -> Jet:
        """Zero with all derivatives where the argument rests at zero, as on the flat side of sqrt(max(0, x)): there
        the chain meets 0/0."""
        rests = np.logical_and.reduce(np.broadcast_arrays(*(np.asarray(d) == 0 for d in argument.d)))
        if not np.any(rests):
            return self
        return Jet([np.where(rests, 0.0, d) for d in self.d])

    def arcsin(self) -> Jet:
        return self.chain(call("arcsin", self.d[0]), lambda f: 1.0 / (1.0 - f * f).sqrt())

    def arccos(self) -> Jet:
        return self.chain(call("arccos", self.d[0]), lambda f: -1.0 / (1.0 - f * f).sqrt())

    def arctan(self) -> Jet:
        return self.chain(call("arctan", self.d[0]), lambda f: 1.0 / (1.0 + f * f))

    def arctan2(self, x: Jet) -> Jet:
        """The angle of the vector (x, self); its derivative is (x y' - y x') / (x^2 + y^2)."""
        value = call("arctan2", self.d[0], x.d[0])
        order = min(self.order, x.order)
        if order == 0:
            return Jet([value])
        low_y, low_x = self.truncated(order - 1), x.truncated(order - 1)
        rate = (low_x * self.rate() - low_y * x.rate()) / (low_x * low_x + low_y * low_y)
        return Jet([value, *rate.d])

    def hypot(self, other: Jet) -> Jet:
        return (self * self + other * other).sqrt()

    def __abs__(self) -> Jet:
        sign = call("copysign", 1.0, self.d[0] + 0.0)  # + 0.0 makes a minus zero a plain one
        return Jet([sign * a for a in self.d])

    def where(self, condition: Any, other: Jet) -> Jet:
        """This jet where ``condition`` holds, ``other`` elsewhere."""
        return Jet([call("where", condition, a, b) for a, b in zip(self.d, other.d, strict=False)])

    def minimum(self, other: Jet) -> Jet:
        return self.where(self.d[0] <= other.d[0], other)

    def maximum(self, other: Jet) -> Jet:
        return self.where(self.d[0] >= other.d[0], other)


def leibniz(f: Any, g: Any, k: int, terms: range) -> Scalar:
    """The chosen terms of (f g)^(k) = sum_j C(k, j) f^(j) g^(k-j)."""
    total: Scalar = 0.0
    for j in terms:
        a, b = f[j], g[k - j]
        if is_zero(a) or is_zero(b):
            continue
        term = a * b if comb(k, j) == 1 else comb(k, j) * (a * b)
        total = term if is_zero(total) else total + term
    return total
