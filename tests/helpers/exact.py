"""Every elementary function in exact arithmetic, by its NumPy name: its domain's arguments, its value by mpmath."""

from collections.abc import Callable
from typing import Any

from mpmath import mp, mpf

mp.dps = 50


def _atan2(y: Any, x: Any) -> Any:
    return mp.atan2(y, x) if y or x else mpf(0)


def _pick(smaller: bool) -> Callable[..., Any]:
    return lambda a, b: min(a, b) if smaller else max(a, b)


EXACT: dict[str, Callable[..., Any]] = {
    "sin": mp.sin,
    "cos": mp.cos,
    "tan": mp.tan,
    "exp": mp.exp,
    "log": lambda x: mp.log(x) if x > 0 else None,
    "sqrt": lambda x: mp.sqrt(x) if x >= 0 else None,
    "arcsin": lambda x: mp.asin(x) if abs(x) <= 1 else None,
    "arccos": lambda x: mp.acos(x) if abs(x) <= 1 else None,
    "arctan": mp.atan,
    "arctan2": _atan2,
    "hypot": lambda x, y: mp.sqrt(x * x + y * y),
    "square": lambda x: x * x,
    "abs": abs,
    "fabs": abs,
    "absolute": abs,
    "minimum": _pick(True),
    "fmin": _pick(True),
    "maximum": _pick(False),
    "fmax": _pick(False),
    "sign": lambda x: mpf((x > 0) - (x < 0)),
    "copysign": lambda x, y: abs(x) if y >= 0 else -abs(x),
    "floor": mp.floor,
    "less": lambda x, y: mpf(x < y),
    "less_equal": lambda x, y: mpf(x <= y),
    "equal": lambda x, y: mpf(x == y),
    "not_equal": lambda x, y: mpf(x != y),
    "logical_and": lambda x, y: mpf(bool(x) and bool(y)),
    "logical_or": lambda x, y: mpf(bool(x) or bool(y)),
    "logical_not": lambda x: mpf(not x),
    "where": lambda c, x, y: x if c else y,
    "if_else_zero": lambda c, x: x if c else mpf(0),
}
"""None where there is no value."""

CONDITIONS = ("logical_and", "logical_or", "logical_not", "where", "if_else_zero")
"""Functions whose first argument is 1 or 0; of the logical ones every argument is."""


def arity(name: str) -> int:
    """The number of a function's arguments."""
    function = EXACT[name]
    two = ("arctan2", "minimum", "fmin", "maximum", "fmax")
    return (
        2
        if name in two
        else 3
        if name == "where"
        else 1
        if name in ("sin", "cos", "tan", "exp", "arctan", "abs", "fabs", "absolute", "floor")
        else function.__code__.co_argcount
    )


BINARY: dict[str, Callable[[Any, Any], Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
}
