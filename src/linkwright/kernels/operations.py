"""The operations of a program's instructions: of each CasADi's codes, a name and how many operands it takes.

This is the one place that knows CasADi's numbers. An emitter spells operations by name; where NumPy has a function for
one, the name is NumPy's.
"""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import casadi as ca

from linkwright.data_classes import dataclass


@dataclass(frozen=True)
class Operation:
    """An operation: its ``name``, the number of its ``operands``, CasADi's ``codes`` for it."""

    name: str
    operands: int
    codes: tuple[int, ...]


OPERATIONS: Mapping[str, Operation] = MappingProxyType(
    {
        name: Operation(name, operands, tuple(codes))
        for name, operands, *codes in (
            # Arithmetic.
            ("positive", 1, ca.OP_ASSIGN),
            ("negative", 1, ca.OP_NEG),
            ("add", 2, ca.OP_ADD),
            ("subtract", 2, ca.OP_SUB),
            ("multiply", 2, ca.OP_MUL),
            ("divide", 2, ca.OP_DIV),
            ("twice", 1, ca.OP_TWICE),
            ("square", 1, ca.OP_SQ),
            ("reciprocal", 1, ca.OP_INV),
            ("power", 2, ca.OP_POW, ca.OP_CONSTPOW),
            # Elementary functions.
            ("sqrt", 1, ca.OP_SQRT),
            ("sin", 1, ca.OP_SIN),
            ("cos", 1, ca.OP_COS),
            ("tan", 1, ca.OP_TAN),
            ("arcsin", 1, ca.OP_ASIN),
            ("arccos", 1, ca.OP_ACOS),
            ("arctan", 1, ca.OP_ATAN),
            ("arctan2", 2, ca.OP_ATAN2),
            ("exp", 1, ca.OP_EXP),
            ("log", 1, ca.OP_LOG),
            ("hypot", 2, ca.OP_HYPOT),
            # Magnitudes and signs.
            ("fabs", 1, ca.OP_FABS),
            ("sign", 1, ca.OP_SIGN),
            ("copysign", 2, ca.OP_COPYSIGN),
            ("floor", 1, ca.OP_FLOOR),
            ("fmin", 2, ca.OP_FMIN),
            ("fmax", 2, ca.OP_FMAX),
            # Conditions, which are 1 or 0.
            ("less", 2, ca.OP_LT),
            ("less_equal", 2, ca.OP_LE),
            ("equal", 2, ca.OP_EQ),
            ("not_equal", 2, ca.OP_NE),
            ("logical_not", 1, ca.OP_NOT),
            ("logical_and", 2, ca.OP_AND),
            ("logical_or", 2, ca.OP_OR),
            ("if_else_zero", 2, ca.OP_IF_ELSE_ZERO),
        )
    }
)
"""By name. Constants, inputs and outputs are no operations: each emitter has its own way with them."""
_BY_CODE = {code: operation for operation in OPERATIONS.values() for code in operation.codes}


def operation(code: int) -> Operation:
    """The operation of an instruction. Raises NotImplementedError, with CasADi's name, for one beyond the table."""
    if (known := _BY_CODE.get(code)) is not None:
        return known
    name = next((name for name in dir(ca) if name.startswith("OP_") and getattr(ca, name) == code), str(code))
    raise NotImplementedError(f"no emitter has CasADi's operation {name}")
