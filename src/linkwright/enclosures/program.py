"""A program's instructions run on Taylor models: every output enclosed over panels."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures.functions import FUNCTIONS, turned
from linkwright.enclosures.taylor import TaylorModel
from linkwright.graph.program import ExpressionStage

Array = NDArray[np.float64]
Operation = Callable[..., TaylorModel]

OPERATIONS: dict[int, Operation] = {
    ca.OP_ADD: lambda a, b: a + b, ca.OP_SUB: lambda a, b: a - b, ca.OP_MUL: lambda a, b: a * b,
    ca.OP_DIV: lambda a, b: a / b, ca.OP_NEG: lambda a: -a, ca.OP_ASSIGN: lambda a: a,
    ca.OP_TWICE: lambda a: a + a, ca.OP_INV: lambda a: a.inverse(), ca.OP_SQ: lambda a: a * a,
    ca.OP_POW: lambda a, b: a**b, ca.OP_CONSTPOW: lambda a, b: a**b,
    ca.OP_ATAN2: turned,
    **{op: FUNCTIONS[name] for op, name in {
        ca.OP_SQRT: "sqrt", ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_TAN: "tan", ca.OP_ASIN: "arcsin",
        ca.OP_ACOS: "arccos", ca.OP_ATAN: "arctan", ca.OP_EXP: "exp", ca.OP_LOG: "log", ca.OP_FABS: "fabs",
        ca.OP_SIGN: "sign", ca.OP_FLOOR: "floor", ca.OP_NOT: "logical_not", ca.OP_FMIN: "fmin", ca.OP_FMAX: "fmax",
        ca.OP_HYPOT: "hypot", ca.OP_COPYSIGN: "copysign", ca.OP_LT: "less", ca.OP_LE: "less_equal",
        ca.OP_EQ: "equal", ca.OP_NE: "not_equal", ca.OP_AND: "logical_and", ca.OP_OR: "logical_or",
        ca.OP_IF_ELSE_ZERO: "if_else_zero",
    }.items()},
}  # fmt: skip
"""What each instruction does to models. Angles of vectors run on past pi, from their values in the middle."""


class Stage:
    """A block of expressions on Taylor models: of its ``wanted`` rows, with what depends on parameters alone done.

    ``strict`` angles of vectors jump at pi instead of running on; ``dtype`` is what constants are computed with.
    """

    def __init__(
        self, stage: ExpressionStage, p: Array, wanted: Sequence[int], strict: bool = False, dtype: Any = np.float64
    ) -> None:
        operations = {**OPERATIONS, ca.OP_ATAN2: FUNCTIONS["arctan2"]} if strict else OPERATIONS
        self.values: list[TaylorModel | None] = []  # of each number that is made, where it is the same at all times
        self.work: list[tuple[Operation, tuple[int, ...], int]] = []
        self.inputs: list[tuple[int, int]] = []  # (number, input row)
        slots: dict[int, int] = {}
        results: dict[int, int] = {}
        lines: list[tuple[Operation, tuple[int, ...], int]] = []
        for i in stage.instructions:
            if i.op == ca.OP_OUTPUT:
                results[i.out] = slots[i.args[0]]
                continue
            value = None
            if i.op == ca.OP_CONST:
                value = TaylorModel.number(i.value, dtype=dtype)
            elif i.op == ca.OP_INPUT:
                which, row = i.args
                if which == 1:
                    value = TaylorModel.number(float(p[row]), dtype=dtype)
                else:
                    self.inputs.append((len(self.values), row))
            else:
                args = tuple(slots[a] for a in i.args)
                known = [self.values[a] for a in args]
                if i.op not in operations:
                    raise NotImplementedError(f"no enclosure of instruction {i.op}")
                if all(k is not None for k in known):
                    value = operations[i.op](*known)
                else:
                    lines.append((operations[i.op], args, len(self.values)))
            slots[i.out] = len(self.values)
            self.values.append(value)
        self.results = [results[row] for row in wanted]
        needed = set(self.results)
        for line in reversed(lines):
            if line[2] in needed:
                needed.update(line[1])
                self.work.append(line)
        self.work.reverse()
        self.inputs = [(number, row) for number, row in self.inputs if number in needed]

    @property
    def used(self) -> set[int]:
        """The input rows that the wanted rows depend on."""
        return {row for _, row in self.inputs}

    def __call__(self, x: Callable[[int], TaylorModel]) -> list[TaylorModel]:
        """The wanted rows, from the inputs by their rows."""
        values: list[Any] = [*self.values]
        for number, row in self.inputs:
            values[number] = x(row)
        with np.errstate(all="ignore"):
            for operation, args, to in self.work:
                values[to] = operation(*[values[a] for a in args])
        return [values[number] for number in self.results]
