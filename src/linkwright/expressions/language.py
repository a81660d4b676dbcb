"""The arithmetic of model files: numbers with units, names, calls; parsed and walked, never executed.

    expression = term {("+" | "-") term}
    term       = factor {("*" | "/") factor}
    factor     = ["+" | "-"] power
    power      = primary ["^" factor]
    primary    = number [unit] | name {"." name} | name "(" arguments ")" {"." name} | "(" expression ")"
    unit       = word ["^" digit] {("*" | "/") word ["^" digit]}

A unit binds to the number before it, so ``1/20 mm`` is 1/(20 mm).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from linkwright.data_classes import dataclass
from linkwright.expressions.parser import ExpressionError, parse
from linkwright.expressions.trees import (
    Binary,
    Call,
    Name,
    Negative,
    Node,
    Number,
    is_signal,
    nodes,
    signal_text,
    signals_in,
    text_of,
)
from linkwright.laws.step import step5
from linkwright.notation import Jet
from linkwright.notation.jets import call, symbolic

__all__ = [
    "FUNCTIONS",
    "Binary",
    "Call",
    "ExpressionError",
    "Function",
    "Name",
    "Negative",
    "Node",
    "Number",
    "evaluate",
    "is_signal",
    "nodes",
    "parse",
    "signal_text",
    "signals_in",
    "text_of",
]


def _elementary(name: str) -> Callable[..., Any]:
    def apply(*args: Any) -> Any:
        if any(isinstance(arg, Jet) for arg in args):
            order = min(arg.order for arg in args if isinstance(arg, Jet))
            jets = [arg if isinstance(arg, Jet) else Jet.constant(arg, order) for arg in args]
            return getattr(jets[0], name)(*jets[1:])
        return call(name, *args)

    return apply


def _pick(name: str, numbers: Callable[[Any, Any], Any]) -> Callable[..., Any]:
    def apply(a: Any, b: Any) -> Any:
        if isinstance(a, Jet) or isinstance(b, Jet):
            return _elementary(name)(a, b)
        if symbolic(a) or symbolic(b):
            return call({"minimum": "fmin", "maximum": "fmax"}[name], a, b)
        if isinstance(a, int | float) and isinstance(b, int | float):
            return numbers(a, b)
        return call(name, a, b)

    return apply


@dataclass(frozen=True)
class Function:
    """A function of expressions: its number of arguments, its rule of dimensions, its evaluation."""

    arity: int
    rule: str
    apply: Callable[..., Any]


# The rules of dimensions, used by model.forms: "trig" takes an angle and gives a pure number, "angle"
# the reverse; "pure" maps pure to pure; "same" gives what it takes; "ratio" an angle of two alike; "root".
FUNCTIONS: dict[str, Function] = {
    **{name: Function(1, "trig", _elementary(name)) for name in ("sin", "cos", "tan")},
    "asin": Function(1, "angle", _elementary("arcsin")),
    "acos": Function(1, "angle", _elementary("arccos")),
    "atan": Function(1, "angle", _elementary("arctan")),
    "atan2": Function(2, "ratio", _elementary("arctan2")),
    "exp": Function(1, "pure", _elementary("exp")),
    "log": Function(1, "pure", _elementary("log")),
    "sqrt": Function(1, "root", _elementary("sqrt")),
    "hypot": Function(2, "same", _elementary("hypot")),
    "abs": Function(1, "same", lambda a: abs(a) if isinstance(a, Jet | int | float) else call("abs", a)),
    "min": Function(2, "same", _pick("minimum", min)),
    "max": Function(2, "same", _pick("maximum", max)),
    "step5": Function(5, "step", step5),
}


def evaluate(node: Node, name: Callable[[Name], Any], other: Callable[[Call], Any] | None = None) -> Any:
    """The value of a bound tree (numbers in SI): ``name`` gives names' values, ``other`` tables and signals.

    Works alike on floats, NumPy arrays inside jets, and symbols. Of floats, what has no finite real
    value (1/0, (-1)^0.5) comes out as NaN or infinity.
    """
    if isinstance(node, Number):
        return node.value
    if isinstance(node, Name):
        return math.pi if node.text == "pi" else name(node)
    if isinstance(node, Negative):
        return -evaluate(node.of, name, other)
    if isinstance(node, Call):
        if node.attribute is None and node.name in FUNCTIONS:
            return FUNCTIONS[node.name].apply(*(evaluate(arg, name, other) for arg in node.args))
        if other is None:
            raise ExpressionError("place", name=node.name)
        return other(node)
    left, right = evaluate(node.left, name, other), evaluate(node.right, name, other)
    return _OPERATORS[node.op](left, right)


def _quotient(a: Any, b: Any) -> Any:
    if isinstance(b, int | float) and b == 0:
        return a * math.nan
    return a / b


def _power(a: Any, b: Any) -> Any:
    if any(isinstance(value, int | float) and not math.isfinite(value) for value in (a, b)):
        return a * b * math.nan
    if not (isinstance(a, int | float) and isinstance(b, int | float)):
        return a**b
    try:
        value = float(a) ** float(b)
    except OverflowError:
        return math.inf
    except ZeroDivisionError:
        return math.nan
    return math.nan if isinstance(value, complex) else value


_OPERATORS: dict[str, Callable[[Any, Any], Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": _quotient,
    "^": _power,
}
