"""A program's instructions run on enclosures: Taylor models over panels of time, or intervals over boxes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures import intervals
from linkwright.enclosures.forms import FEW, UNIT, Form
from linkwright.enclosures.functions import turned
from linkwright.enclosures.intervals import Intervals
from linkwright.enclosures.taylor import FUNCTIONS, TaylorModel
from linkwright.graph.program import ExpressionStage

Array = NDArray[np.float64]
Operation = Callable[..., Any]

ARITHMETIC: dict[int, Operation] = {
    ca.OP_ADD: lambda a, b: a + b, ca.OP_SUB: lambda a, b: a - b, ca.OP_MUL: lambda a, b: a * b,
    ca.OP_DIV: lambda a, b: a / b, ca.OP_NEG: lambda a: -a, ca.OP_ASSIGN: lambda a: a,
    ca.OP_TWICE: lambda a: a + a, ca.OP_POW: lambda a, b: a**b, ca.OP_CONSTPOW: lambda a, b: a**b,
}  # fmt: skip
NAMES = {
    ca.OP_SQRT: "sqrt", ca.OP_SIN: "sin", ca.OP_COS: "cos", ca.OP_TAN: "tan", ca.OP_ASIN: "arcsin",
    ca.OP_ACOS: "arccos", ca.OP_ATAN: "arctan", ca.OP_EXP: "exp", ca.OP_LOG: "log", ca.OP_FABS: "fabs",
    ca.OP_SIGN: "sign", ca.OP_FLOOR: "floor", ca.OP_NOT: "logical_not", ca.OP_FMIN: "fmin", ca.OP_FMAX: "fmax",
    ca.OP_HYPOT: "hypot", ca.OP_COPYSIGN: "copysign", ca.OP_LT: "less", ca.OP_LE: "less_equal",
    ca.OP_EQ: "equal", ca.OP_NE: "not_equal", ca.OP_AND: "logical_and", ca.OP_OR: "logical_or",
    ca.OP_IF_ELSE_ZERO: "if_else_zero",
}  # fmt: skip


@dataclass(frozen=True)
class Kind:
    """A kind of enclosure: what each instruction does to it, and a number as one."""

    operations: Mapping[int, Operation]
    number: Callable[[float], Any]


def taylor(strict: bool = False, dtype: Any = np.float64) -> Kind:
    """Taylor models. Angles of vectors run on past pi, from their values in the middle; ``strict`` ones jump there.
    ``dtype`` is what constants are computed with."""
    own = {ca.OP_INV: lambda a: a.inverse(), ca.OP_SQ: lambda a: a * a}
    angle = FUNCTIONS["arctan2"] if strict else turned
    named = {op: FUNCTIONS[name] for op, name in NAMES.items()}
    return Kind({**ARITHMETIC, **named, **own, ca.OP_ATAN2: angle}, lambda v: TaylorModel.number(v, dtype=dtype))


def _constant(function: Operation, *args: Form) -> Form:
    """A function of parameters alone."""
    if any(np.any(x.lean) for x in args):
        raise NotImplementedError("no enclosure of such a function over boxes")
    found = function(*(Intervals(*x.ends) for x in args))
    middle = (found.low + found.high) / 2
    return Form(middle, rest=(found.high - found.low) / 2 + UNIT * abs(middle))


def _power(x: Intervals, y: Intervals) -> Intervals:
    """Whole powers of any number, others of positive ones."""
    middle = float((y.low + y.high) / 2)
    whole = middle == np.floor(middle) and y.high - y.low <= FEW * abs(middle)
    return x ** (int(middle) if whole else y)


BOXES = Kind(
    {
        **{op: partial(_constant, intervals.FUNCTIONS[name]) for op, name in NAMES.items()},
        **ARITHMETIC,
        ca.OP_POW: partial(_constant, _power),
        ca.OP_CONSTPOW: partial(_constant, _power),
        ca.OP_ATAN2: partial(_constant, intervals.arctan2),
        ca.OP_SQ: Form.square,
        ca.OP_SQRT: Form.sqrt,
        ca.OP_INV: Form.inverse,
        ca.OP_FABS: Form.magnitude,
    },
    Form,
)
"""Linear forms over boxes of the inputs, of what follows from them by sums, products, quotients and roots, as the
closed forms of dyads do. They hold for the places of a box at which every root is real."""


class Stage:
    """A block of expressions on a kind of enclosures: its ``wanted`` rows, what depends on parameters alone done."""

    def __init__(self, stage: ExpressionStage, p: Array, wanted: Sequence[int], kind: Kind) -> None:
        operations = kind.operations
        self.values: list[Any] = []  # of each number that is made, where it is the same at all times
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
                value = kind.number(i.value)
            elif i.op == ca.OP_INPUT:
                which, row = i.args
                if which == 1:
                    value = kind.number(float(p[row]))
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

    def __call__(self, x: Callable[[int], Any]) -> list[Any]:
        """The wanted rows, from the inputs by their rows."""
        values: list[Any] = [*self.values]
        for number, row in self.inputs:
            values[number] = x(row)
        with np.errstate(all="ignore"):
            for operation, args, to in self.work:
                values[to] = operation(*[values[a] for a in args])
        return [values[number] for number in self.results]
