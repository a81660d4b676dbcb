"""Expressions that know their text in a model file, their exact value (mpmath), their value in doubles (NumPy), and how
far round-off carries; nothing here is the product's.

A leaf is a number (a double, taken as exact), the clock, or a signal with a closed form. The clock is x = t/(1 s).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath
import numpy as np
from mpmath import mp

DIGITS = 60
ROUND = 2.0**-53


@dataclass(frozen=True)
class Signal:
    """A signal's text in a model file, its closed form by the time (mpmath and NumPy), its round-off (absolute)."""

    text: str
    exact: Callable[[Any], Any]
    plain: Callable[[Any], Any] | None = None
    noise: Callable[[Any], float] = lambda t: 8 * ROUND


@dataclass(frozen=True)
class Tree:
    """A node: ``op`` is ``number``, ``clock``, ``signal``, an operator or a function's name."""

    op: str
    args: tuple[Any, ...] = ()

    def __add__(self, other: Any) -> Tree:
        return Tree("+", (self, tree(other)))

    def __radd__(self, other: Any) -> Tree:
        return tree(other) + self

    def __sub__(self, other: Any) -> Tree:
        return Tree("-", (self, tree(other)))

    def __rsub__(self, other: Any) -> Tree:
        return tree(other) - self

    def __mul__(self, other: Any) -> Tree:
        return Tree("*", (self, tree(other)))

    def __rmul__(self, other: Any) -> Tree:
        return tree(other) * self

    def __truediv__(self, other: Any) -> Tree:
        return Tree("/", (self, tree(other)))

    def __rtruediv__(self, other: Any) -> Tree:
        return tree(other) / self

    def __pow__(self, other: Any) -> Tree:
        return Tree("^", (self, tree(other)))

    def __neg__(self) -> Tree:
        return 0.0 - self

    def __abs__(self) -> Tree:
        return Tree("abs", (self,))

    @cached_property
    def text(self) -> str:
        """As it stands in a model file."""
        if self.op == "number":
            value = self.args[0]
            return repr(value) if value >= 0 else f"(-{-value!r})"
        if self.op == "clock":
            return "(t/(1 s))"
        if self.op == "signal":
            return str(self.args[0].text)
        parts = [arg.text for arg in self.args]
        if self.op in OPERATORS:
            return f"({parts[0]}{self.op}{parts[1]})"
        return f"{self.op}({', '.join(parts)})"

    def exact(self, t: Any) -> Any:
        """The value at a time, in mpmath; NaN where there is none (mpmath then divides by zero, or goes complex)."""
        try:
            value = _evaluated(self, mpmath.mpf(t), EXACT, "exact")
        except (ZeroDivisionError, ValueError, OverflowError, TypeError):
            return mp.nan
        return mp.nan if isinstance(value, mpmath.mpc) and value.imag != 0 else mp.re(value)

    def plain(self, t: Any) -> Any:
        """The values at many times, in doubles."""
        with np.errstate(all="ignore"):
            value = _evaluated(self, np.asarray(t, dtype=float), PLAIN, "plain")
            return np.broadcast_to(np.asarray(value, dtype=float), np.shape(t))

    def noise(self, t: Any) -> float:
        """A bound on the round-off of the value in doubles at a time, to first order; infinite where there is none."""
        try:
            return float(_noise(self, mpmath.mpf(t))[1])
        except (ZeroDivisionError, ValueError, OverflowError, TypeError):
            return float("inf")


def tree(value: Any) -> Tree:
    """A number as a leaf."""
    return value if isinstance(value, Tree) else Tree("number", (float(value),))


CLOCK = Tree("clock")


def signal(*args: Any, **words: Any) -> Tree:
    return Tree("signal", (Signal(*args, **words),))


def call(name: str, *args: Any) -> Tree:
    return Tree(name, tuple(tree(arg) for arg in args))


def _power(a: Any, b: Any) -> Any:
    return mpmath.power(a, int(b)) if b == int(b) else mpmath.power(a, b)


OPERATORS = ("+", "-", "*", "/", "^")
EXACT: dict[str, Callable[..., Any]] = {
    "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b, "/": lambda a, b: a / b, "^": _power,
    "sin": mpmath.sin, "cos": mpmath.cos, "tan": mpmath.tan, "asin": mpmath.asin, "acos": mpmath.acos,
    "atan": mpmath.atan, "atan2": mpmath.atan2, "exp": mpmath.exp, "log": mpmath.log, "sqrt": mpmath.sqrt,
    "hypot": mpmath.hypot, "abs": abs, "min": min, "max": max,
}  # fmt: skip
PLAIN: dict[str, Callable[..., Any]] = {
    "+": np.add, "-": np.subtract, "*": np.multiply, "/": np.divide, "^": np.power, "sin": np.sin, "cos": np.cos,
    "tan": np.tan, "asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "atan2": np.arctan2, "exp": np.exp,
    "log": np.log, "sqrt": np.sqrt, "hypot": np.hypot, "abs": np.abs, "min": np.minimum, "max": np.maximum,
}  # fmt: skip


def _evaluated(node: Tree, t: Any, functions: dict[str, Callable[..., Any]], way: str) -> Any:
    if node.op == "number":
        return mpmath.mpf(node.args[0]) if way == "exact" else node.args[0]
    if node.op == "clock":
        return t
    if node.op == "signal":
        (leaf,) = node.args
        if way == "exact":
            return leaf.exact(t)
        return leaf.plain(t) if leaf.plain else np.array([float(leaf.exact(mpmath.mpf(one))) for one in t])
    return functions[node.op](*(_evaluated(arg, t, functions, way) for arg in node.args))


# The partial derivatives of each function, by value and arguments: what carries the round-off of the arguments on.
SLOPES: dict[str, Callable[..., tuple[Any, ...]]] = {
    "+": lambda v, a, b: (1, 1),
    "-": lambda v, a, b: (1, 1),
    "*": lambda v, a, b: (b, a),
    "/": lambda v, a, b: (1 / b, v / b),
    "^": lambda v, a, b: (b * v / a if a else (1 if b == 1 else 0), v * mpmath.log(abs(a)) if a else 0),
    "sin": lambda v, a: (mpmath.cos(a),),
    "cos": lambda v, a: (mpmath.sin(a),),
    "tan": lambda v, a: (1 + v * v,),
    "asin": lambda v, a: (1 / mpmath.sqrt(abs(1 - a * a)),),
    "acos": lambda v, a: (1 / mpmath.sqrt(abs(1 - a * a)),),
    "atan": lambda v, a: (1 / (1 + a * a),),
    "atan2": lambda v, a, b: (b / (a * a + b * b), a / (a * a + b * b)),
    "exp": lambda v, a: (v,),
    "log": lambda v, a: (1 / a,),
    "sqrt": lambda v, a: (1 / (2 * v),),
    "hypot": lambda v, a, b: (a / v, b / v),
    "abs": lambda v, a: (1,),
    "min": lambda v, a, b: (1, 1),
    "max": lambda v, a, b: (1, 1),
}


def _noise(node: Tree, t: Any) -> tuple[Any, Any]:
    if node.op == "number":
        return mpmath.mpf(node.args[0]), mpmath.mpf(0)
    if node.op == "clock":
        return t, abs(t) * ROUND
    if node.op == "signal":
        (leaf,) = node.args
        return leaf.exact(t), mpmath.mpf(leaf.noise(t))
    values, noises = zip(*(_noise(arg, t) for arg in node.args), strict=True)
    value = EXACT[node.op](*values)
    if node.op == "sqrt" or (node.op == "^" and 0 < values[1] < 1):  # steep at zero, but never by more than this
        power = mpmath.mpf(1) / 2 if node.op == "sqrt" else values[1]
        linear = power * abs(value) / abs(values[0]) * noises[0] if values[0] else mp.inf
        return value, min(linear, noises[0] ** power) + abs(value) * 2 * ROUND
    slopes = SLOPES[node.op](value, *values)
    return value, sum((abs(s) * n for s, n in zip(slopes, noises, strict=True)), abs(value) * 2 * ROUND)
