"""Programs of few operations, and random ones of all: what emitters are tried on besides mechanisms."""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np

from linkwright.graph.program import ExpressionStage, Program
from linkwright.kernels.operations import OPERATIONS, Operation


def spelled(done: Operation, code: int, x: Any, y: Any) -> Any:
    """An operation of one or two symbols."""
    return ca.SX.unary(code, x) if done.operands == 1 else ca.SX.binary(code, x, y)


def of_one(done: Operation, code: int) -> Program:
    """A program of one operation."""
    x = ca.SX.sym("x", 2)
    stage = ExpressionStage(ca.Function("one", [x, ca.SX(0, 1)], [spelled(done, code, x[0], x[1])]))
    return Program((), stage, ("x", "y"), (), (done.name,))


def every_operation() -> Program:
    """A program of all of them; the power of a constant is CasADi's own operation."""
    x = ca.SX.sym("x", 2)
    rows = [spelled(each, code, x[0], x[1]) for each in OPERATIONS.values() for code in each.codes]
    names = tuple(f"{each.name} {code}" for each in OPERATIONS.values() for code in each.codes)
    stage = ExpressionStage(ca.Function("all", [x, ca.SX(0, 1)], [ca.vertcat(*rows)]))
    return Program((), stage, ("x", "y"), (), names)


def beyond_the_table() -> Program:
    """A program of an operation that no emitter has."""
    x = ca.SX.sym("x", 2)
    stage = ExpressionStage(ca.Function("one", [x, ca.SX(0, 1)], [ca.erf(x[0])]))
    return Program((), stage, ("x", "y"), (), ("erf",))


def rows_of(*expressions: Any) -> Program:
    """A program of the given rows of one input and one parameter, written with CasADi."""
    x, p = ca.SX.sym("x", 1), ca.SX.sym("p", 1)
    block = ExpressionStage.from_rows(x, p, [expression(x, p) for expression in expressions])
    return Program((), block, ("x",), ("p",), tuple(f"y{i}" for i in range(len(expressions))))


EVERY = [
    lambda x, p: (-2.5) ** x, lambda x, p: x**3, lambda x, p: x ** (-2), lambda x, p: ca.fabs(x) ** 0.5,
    lambda x, p: ca.fabs(x) ** p, lambda x, p: x**1.5, lambda x, p: 2.0 - (-3.0) * x, lambda x, p: -x / (p - x),
    lambda x, p: ca.sin(x) + ca.cos(x) * ca.tan(x), lambda x, p: ca.asin(x / 9) + ca.acos(x / 9) * ca.atan(x),
    lambda x, p: ca.atan2(x, p), lambda x, p: ca.exp(x) + ca.log(ca.fabs(x)), lambda x, p: ca.sign(x) * ca.floor(x),
    lambda x, p: ca.fmin(x, p) + ca.fmax(x, 2 * p), lambda x, p: ca.hypot(x, p), lambda x, p: ca.copysign(p, x),
    lambda x, p: ca.if_else(x < p, x, -p), lambda x, p: ca.if_else(ca.logic_and(x <= p, x > -p), x * x, p),
    lambda x, p: ca.if_else(ca.logic_or(x == p, x != 1.0), 1.0, 0.0) + ca.logic_not(x > 0),
    lambda x, p: x, lambda x, p: p, lambda x, p: ca.SX(7.25), lambda x, p: 2 * x, lambda x, p: 1 / x,
    lambda x, p: p * p,
]  # fmt: skip
"""What a program may hold: for :func:`rows_of`."""


def nested() -> Program:
    """Each operation of arithmetic and of conditions within each, on either side: what needs brackets, and what not."""
    x = ca.SX.sym("x", 3)
    a, b, c = ca.vertsplit(x)
    names = (
        "negative",
        "add",
        "subtract",
        "multiply",
        "divide",
        "less",
        "equal",
        "logical_not",
        "logical_and",
        "logical_or",
    )
    names += ("if_else_zero", "fabs")
    done = [(OPERATIONS[name], OPERATIONS[name].codes[0]) for name in names]
    rows = []
    for inner, code in done:
        part = spelled(inner, code, a, b)
        rows += [spelled(outer, other, *pair) for outer, other in done for pair in ((part, c), (c, part), (part, -2.5))]
    stage = ExpressionStage(ca.Function("nested", [x, ca.SX(0, 1)], [ca.vertcat(*rows)]))
    return Program((), stage, ("a", "b", "c"), (), tuple(f"y{i}" for i in range(stage.rows)))


def random_program(seed: int, size: int = 250) -> Program:
    """So many operations of three inputs and two parameters, each kind about as often, on values that were made shortly
    before; every tenth is an output. Some go through a sine, so that they keep to sizes at which they have digits."""
    random = np.random.default_rng(seed)
    x, p = ca.SX.sym("x", 3), ca.SX.sym("p", 2)
    values: list[Any] = [*ca.vertsplit(x), *ca.vertsplit(p), *map(ca.SX, (-0.75, 0.0, 2.0, 1e-3))]
    codes = [(each, code) for each in OPERATIONS.values() for code in each.codes]
    rows: list[Any] = []
    for k in range(size):
        done, code = codes[random.integers(len(codes))]
        left, right = (values[random.integers(max(0, len(values) - 40), len(values))] for _ in range(2))
        values.append(spelled(done, code, left, right))
        if k % 3 == 0:  # bring large values back
            values.append(ca.SX.unary(ca.OP_SIN, values[-1]) + values[random.integers(5)])
        if k % 10 == 0:
            rows.append(values[-1])
    stage = ExpressionStage(ca.Function("random", [x, p], [ca.cse(ca.vertcat(*rows, *values[-5:]))]))
    return Program((), stage, ("a", "b", "c"), ("d", "e"), tuple(f"y{i}" for i in range(stage.rows)))
