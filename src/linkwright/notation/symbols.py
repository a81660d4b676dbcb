"""Symbols of graphs: CasADi's scalars whose operators name their operation.

CasADi's own operators find their operation by trying the types of both operands anew each time: 15 us a product, where
``SX.binary`` with the operation's number takes 2 us and makes the same node. A graph is tens of thousands of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache
from math import copysign
from typing import Any

import casadi as ca

_NAMES = {
    "arctan2": "atan2",
    "arcsin": "asin",
    "arccos": "acos",
    "arctan": "atan",
    "abs": "fabs",
    "where": "if_else",
    "logical_or": "logic_or",
    "logical_and": "logic_and",
    "maximum": "fmax",
    "minimum": "fmin",
}
"""The functions that CasADi calls otherwise than NumPy."""

_UNARY = {
    "sin": ca.OP_SIN,
    "cos": ca.OP_COS,
    "sqrt": ca.OP_SQRT,
    "abs": ca.OP_FABS,
    "arcsin": ca.OP_ASIN,
    "arccos": ca.OP_ACOS,
    "arctan": ca.OP_ATAN,
    "exp": ca.OP_EXP,
    "log": ca.OP_LOG,
    "floor": ca.OP_FLOOR,
}
_BINARY = {"arctan2": ca.OP_ATAN2, "copysign": ca.OP_COPYSIGN}


class Symbol(ca.SX):
    """A scalar of a graph; whatever an operator makes of one is one, too."""

    @classmethod
    def named(cls, name: str) -> Symbol:
        """A free one."""
        return _own(ca.SX.sym(name))

    @staticmethod
    def elementary(name: str, *args: Any) -> Any:
        """An elementary function by its NumPy name, of symbols and numbers."""
        if name in _UNARY:
            return _own(ca.SX.unary(_UNARY[name], *args))
        if name in _BINARY:
            return _own(ca.SX.binary(_BINARY[name], *args))
        return getattr(ca, _NAMES.get(name, name))(*args)

    def __neg__(self) -> Symbol:
        return _own(ca.SX.unary(ca.OP_NEG, self))


def column(rows: Iterable[Any]) -> Any:
    """Symbols and numbers as a column."""
    return ca.SX(ca.vertcat(*rows))


def _own(made: Any) -> Symbol:
    made.__class__ = Symbol
    return made  # type: ignore[no-any-return]


def _direct(op: int, dispatched: Callable[..., Any], reflected: bool) -> Callable[[Symbol, Any], Any]:
    """An operator that names its operation, where the other operand is a scalar; the rest is CasADi's to dispatch."""

    def operator(self: Symbol, other: Any) -> Any:
        if isinstance(other, float):
            other = _constant(other, copysign(1.0, other))
        elif not isinstance(other, _SCALARS):
            return dispatched(self, other)
        return _own(ca.SX.binary(op, other, self) if reflected else ca.SX.binary(op, self, other))

    return operator


_SCALARS = (ca.SX, int)


@lru_cache(1024)
def _constant(number: float, _sign: float) -> Any:
    """A number as a symbol; a length or a mass comes again in a hundred products."""
    return ca.SX(number)


for _name, _op in (("add", ca.OP_ADD), ("sub", ca.OP_SUB), ("mul", ca.OP_MUL), ("truediv", ca.OP_DIV)):
    for _letter in ("", "r"):
        _method = f"__{_letter}{_name}__"
        setattr(Symbol, _method, _direct(_op, getattr(ca.SX, _method), bool(_letter)))
