"""The operators of CasADi's symbols, each as the one operation that it is.

``x * y`` of two SX looks through all functions of its name for one that takes them, which converts them to matrices of
numbers for a try: 15 us. ``SX.binary`` makes the same node in 2 us, and a graph is thousands of them. A number that
comes again and again is made a symbol once. For anything but symbols and plain numbers the operators are CasADi's own.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from math import copysign
from typing import Any

import casadi as ca

CODES = {"add": ca.OP_ADD, "sub": ca.OP_SUB, "mul": ca.OP_MUL, "truediv": ca.OP_DIV}
"""CasADi's operations by the names of Python's operators."""

Operator = Callable[[Any, Any], Any]


@lru_cache(1024)
def _constant(number: float, _sign: float) -> Any:
    return ca.SX(number)


def _operators(code: int, own: Operator, own_reflected: Operator) -> tuple[Operator, Operator]:
    """x op y and y op x of a symbol x."""
    binary, known = ca.SX.binary, (ca.SX, int)

    def operator(x: Any, y: Any) -> Any:
        if isinstance(y, float):
            return binary(code, x, _constant(y, copysign(1.0, y)))
        return binary(code, x, y) if isinstance(y, known) else own(x, y)

    def reflected(x: Any, y: Any) -> Any:
        if isinstance(y, float):
            return binary(code, _constant(y, copysign(1.0, y)), x)
        return binary(code, y, x) if isinstance(y, known) else own_reflected(x, y)

    return operator, reflected


for _name, _code in CODES.items():
    _names = f"__{_name}__", f"__r{_name}__"
    for _each, _operator in zip(_names, _operators(_code, *(getattr(ca.SX, n) for n in _names)), strict=True):
        setattr(ca.SX, _each, _operator)
