"""The operations of symbols, in one table: of each its name, what it makes of numbers, and its slopes.

Where NumPy has a function for an operation, the name is NumPy's. A slope is the derivative by one operand, as an
expression of the operands and of the result; ``None`` stands for one that is 0 wherever it exists. Slopes are chosen
for few operations: that of a root is 1 / (2 root), with the root that is there already.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

Slope = Callable[..., Any] | None


class Operation(NamedTuple):
    """An operation: its ``name``; what it makes of ``operands`` numbers, by IEEE 754; its slope by each operand."""

    name: str
    number: Callable[..., float]
    slopes: tuple[Slope, ...]

    def array(self, *operands: Any) -> Any:
        """What it makes of NumPy's arrays."""
        own = _ARRAYS.get(self.name)
        return getattr(np, self.name)(*operands) if own is None else own(*operands)

    @property
    def operands(self) -> int:
        """How many operands it takes."""
        return len(self.slopes)


def _ieee(plain: Callable[..., float], careful: Callable[..., Any]) -> Callable[..., float]:
    """A function of floats: Python's, or NumPy's where that raises an error and IEEE 754 has infinities and NaN."""

    def number(*operands: float) -> float:
        try:
            return plain(*operands)
        except (ArithmeticError, ValueError):
            with np.errstate(all="ignore"):
                return float(careful(*map(np.float64, operands)))

    return number


def _flag(condition: Callable[..., bool]) -> Callable[..., float]:
    return lambda *operands: 1.0 if condition(*operands) else 0.0


def _sign(x: float) -> float:
    return x if x != x else float((x > 0) - (x < 0))


def _lesser(x: float, y: float) -> float:
    """The lesser of two numbers; of a number and NaN the number, as in C."""
    return y if x != x or y < x else x


def _greater(x: float, y: float) -> float:
    return y if x != x or y > x else x


def _share_of_lesser(x: Any, y: Any, f: Any) -> Any:
    """The slope of the lesser of two by the first: 1 or 0, and 1/2 where they are equal."""
    first, second = x <= y, y <= x
    return first / (first + second)


def _share_of_greater(x: Any, y: Any, f: Any) -> Any:
    return _share_of_lesser(y, x, f)


_ARRAYS: Mapping[str, Callable[..., Any]] = {
    "twice": lambda x: 2.0 * x,
    "if_else_zero": lambda x, y: np.where(x, y, 0.0),
}
"""The operations for which NumPy has no function."""

_TABLE: tuple[tuple[str, Callable[..., float], tuple[Slope, ...]], ...] = (
    # Arithmetic.
    ("negative", lambda x: -x, (lambda x, f: -1.0,)),
    ("add", lambda x, y: x + y, (lambda x, y, f: 1.0, lambda x, y, f: 1.0)),
    ("subtract", lambda x, y: x - y, (lambda x, y, f: 1.0, lambda x, y, f: -1.0)),
    ("multiply", lambda x, y: x * y, (lambda x, y, f: y, lambda x, y, f: x)),
    ("divide", _ieee(lambda x, y: x / y, np.divide), (lambda x, y, f: 1.0 / y, lambda x, y, f: -(f / y))),
    ("twice", lambda x: 2.0 * x, (lambda x, f: 2.0,)),
    ("square", lambda x: x * x, (lambda x, f: 2.0 * x,)),
    ("reciprocal", _ieee(lambda x: 1.0 / x, np.reciprocal), (lambda x, f: -(f / x),)),
    (
        "power",
        _ieee(math.pow, np.power),
        (lambda x, y, f: y * x ** (y - 1.0), lambda x, y, f: x.do("log") * f),
    ),
    # Elementary functions.
    ("sqrt", _ieee(math.sqrt, np.sqrt), (lambda x, f: 1.0 / (2.0 * f),)),
    ("sin", _ieee(math.sin, np.sin), (lambda x, f: x.do("cos"),)),
    ("cos", _ieee(math.cos, np.cos), (lambda x, f: -x.do("sin"),)),
    ("tan", _ieee(math.tan, np.tan), (lambda x, f: 1.0 / x.do("cos").do("square"),)),
    ("arcsin", _ieee(math.asin, np.arcsin), (lambda x, f: 1.0 / (1.0 - x.do("square")).do("sqrt"),)),
    ("arccos", _ieee(math.acos, np.arccos), (lambda x, f: -1.0 / (1.0 - x.do("square")).do("sqrt"),)),
    ("arctan", math.atan, (lambda x, f: 1.0 / (1.0 + x.do("square")),)),
    (
        "arctan2",
        math.atan2,
        (
            lambda y, x, f: x / (y.do("square") + x.do("square")),
            lambda y, x, f: -(y / (y.do("square") + x.do("square"))),
        ),
    ),
    ("exp", _ieee(math.exp, np.exp), (lambda x, f: f,)),
    ("log", _ieee(math.log, np.log), (lambda x, f: 1.0 / x,)),
    ("hypot", math.hypot, (lambda x, y, f: x / f, lambda x, y, f: y / f)),
    # Magnitudes and signs.
    ("fabs", math.fabs, (lambda x, f: x.do("sign"),)),
    ("sign", _sign, (None,)),
    ("copysign", math.copysign, (lambda x, y, f: x.do("sign") * f.do("sign"), None)),
    ("floor", _ieee(lambda x: float(math.floor(x)), np.floor), (None,)),
    ("fmin", _lesser, (_share_of_lesser, _share_of_greater)),
    ("fmax", _greater, (_share_of_greater, _share_of_lesser)),
    # Conditions, which are 1 or 0, and the choice by one: the value where it holds, 0 elsewhere.
    ("less", _flag(lambda x, y: x < y), (None, None)),
    ("less_equal", _flag(lambda x, y: x <= y), (None, None)),
    ("equal", _flag(lambda x, y: x == y), (None, None)),
    ("not_equal", _flag(lambda x, y: x != y), (None, None)),
    ("logical_not", _flag(lambda x: x == 0), (None,)),
    ("logical_and", _flag(lambda x, y: x != 0 and y != 0), (None, None)),
    ("logical_or", _flag(lambda x, y: x != 0 or y != 0), (None, None)),
    ("if_else_zero", lambda x, y: y if x != 0 else 0.0, (None, lambda x, y, f: x.do("if_else_zero", 1.0))),
)

OPERATIONS: Mapping[str, Operation] = MappingProxyType({name: Operation(name, *rest) for name, *rest in _TABLE})  # type: ignore[arg-type]
"""By name."""
