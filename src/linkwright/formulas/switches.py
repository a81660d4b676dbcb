"""Functions for which a motor's text has other words, or several by cases."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import copysign, e, pi

from linkwright.expressions.language import Node, Number
from linkwright.formulas.functions import polynomial
from linkwright.formulas.terms import MADE, function_call, over, plus, power, times

MINUS = MADE["-"]

SWITCHES: dict[str, Callable[..., list[Node]]] = {
    "abs": lambda a: [a],
    "min": lambda a, b: [MINUS(a, b)],
    "max": lambda a, b: [MINUS(a, b)],
    "step5": lambda x, x0, h0, x1, h1: [MINUS(x, x0), MINUS(x, x1)],
    "atan2": lambda y, x: [y, x, MINUS(y, x), plus(y, x)],
}
"""What is zero where another case begins, of the arguments."""


def _step5(args: Sequence[Node], now: Sequence[float]) -> Node:
    (x, x0, h0, x1, h1), (a, a0, _, a1, _) = args, now
    share = (a - a0) / (a1 - a0)
    if share <= 0 or share >= 1:
        return h0 if share <= 0 else h1
    u = over(MINUS(x, x0), MINUS(x1, x0))
    return plus(h0, times(MINUS(h1, h0), polynomial((0.0, 0.0, 0.0, 10.0, -15.0, 6.0), u)))


def _atan2(args: Sequence[Node], now: Sequence[float]) -> Node:
    (y, x), (v, u) = args, now
    if abs(u) >= abs(v):
        return plus(Number(0.0 if u > 0 else copysign(pi, v)), _atan([over(y, x)], ()))
    return MINUS(Number(copysign(pi / 2, v)), _atan([over(x, y)], ()))


def _atan(args: Sequence[Node], now: Sequence[float]) -> Node:
    (z,) = args
    return function_call("asin", over(z, _hypot([Number(1.0), z], ())))


def _hypot(args: Sequence[Node], now: Sequence[float]) -> Node:
    return function_call("sqrt", plus(*(power(arg, Number(2.0)) for arg in args)))


FORMULAS: dict[str, Callable[[Sequence[Node], Sequence[float]], Node]] = {
    "abs": lambda args, now: times(Number(copysign(1.0, now[0])), args[0]),
    "min": lambda args, now: args[now[0] > now[1]],
    "max": lambda args, now: args[now[0] < now[1]],
    "step5": _step5,
    "atan2": _atan2,
    "atan": _atan,
    "hypot": _hypot,
    "exp": lambda args, now: power(Number(e), args[0]),
}
"""Formulas in the arguments, from these and their values in the middle of the piece."""
