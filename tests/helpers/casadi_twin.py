"""A second expression graph, CasADi's (Andersson et al., Math. Program. Comput. 11 (2019) 1-36): what symbols say of
themselves, said again by another's operations, derivatives and virtual machine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import casadi as ca
import numpy as np

from linkwright.symbols import CONSTANT, Symbol, ordered

CODES = {
    "negative": ca.OP_NEG,
    "add": ca.OP_ADD,
    "subtract": ca.OP_SUB,
    "multiply": ca.OP_MUL,
    "divide": ca.OP_DIV,
    "twice": ca.OP_TWICE,
    "square": ca.OP_SQ,
    "reciprocal": ca.OP_INV,
    "power": ca.OP_POW,
    "sqrt": ca.OP_SQRT,
    "sin": ca.OP_SIN,
    "cos": ca.OP_COS,
    "tan": ca.OP_TAN,
    "arcsin": ca.OP_ASIN,
    "arccos": ca.OP_ACOS,
    "arctan": ca.OP_ATAN,
    "arctan2": ca.OP_ATAN2,
    "exp": ca.OP_EXP,
    "log": ca.OP_LOG,
    "hypot": ca.OP_HYPOT,
    "fabs": ca.OP_FABS,
    "sign": ca.OP_SIGN,
    "copysign": ca.OP_COPYSIGN,
    "floor": ca.OP_FLOOR,
    "fmin": ca.OP_FMIN,
    "fmax": ca.OP_FMAX,
    "less": ca.OP_LT,
    "less_equal": ca.OP_LE,
    "equal": ca.OP_EQ,
    "not_equal": ca.OP_NE,
    "logical_not": ca.OP_NOT,
    "logical_and": ca.OP_AND,
    "logical_or": ca.OP_OR,
    "if_else_zero": ca.OP_IF_ELSE_ZERO,
}
"""CasADi's number of each operation."""


class Twin:
    """Rows of free symbols, made again by CasADi."""

    def __init__(self, free: Sequence[Symbol], rows: Sequence[Symbol]) -> None:
        self.free = ca.SX.sym("free", len(free))
        made: dict[Symbol, Any] = {symbol: self.free[i] for i, symbol in enumerate(free)}
        for symbol in ordered(rows):
            if symbol not in made:
                args = [made[arg] for arg in symbol.args]
                made[symbol] = ca.SX(symbol.value) if symbol.op == CONSTANT else _done(CODES[symbol.op], args)
        self.rows = ca.vertcat(*(made[row] for row in rows))

    def function(self, rows: Any) -> Any:
        """A function of numbers for the free symbols."""
        return ca.Function("rows", [self.free], [ca.cse(rows)])

    def along(self, direction: Mapping[int, float]) -> Any:
        """The derivative of the rows along a direction, given by the numbers of free symbols."""
        seed = ca.DM.zeros(self.free.numel())
        for i, value in direction.items():
            seed[i] = value
        return ca.jtimes(self.rows, self.free, seed)

    def jacobian(self) -> Any:
        """The derivatives of all rows by all free symbols, row after row."""
        return ca.reshape(ca.densify(ca.jacobian(self.rows, self.free)).T, -1, 1)


def _done(code: int, args: Sequence[Any]) -> Any:
    return ca.SX.unary(code, *args) if len(args) == 1 else ca.SX.binary(code, *args)


def numbers(function: Any, values: Any) -> np.ndarray:
    """What a function of CasADi gives for a column of numbers."""
    return np.asarray(function(values)).ravel()
