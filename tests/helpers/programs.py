"""Programs of few operations, and random ones of all: what emitters are tried on besides mechanisms."""

from __future__ import annotations

from typing import Any

import numpy as np

from linkwright.graph.program import Program
from linkwright.symbols import OPERATIONS, ExpressionStage, Operation, Symbol, as_symbol, choice


def spelled(done: Operation, x: Symbol, y: Any) -> Symbol:
    """An operation of one or two symbols."""
    return x.do(done.name, *[y][: done.operands - 1])


def of_one(done: Operation) -> Program:
    """A program of one operation."""
    x, y = Symbol.several("x", 2)
    return Program((), ExpressionStage([x, y], [], [spelled(done, x, y)]), ("x", "y"), (), (done.name,))


def every_operation() -> Program:
    """A program of all of them."""
    x, y = Symbol.several("x", 2)
    rows = [spelled(each, x, y) for each in OPERATIONS.values()]
    return Program((), ExpressionStage([x, y], [], rows), ("x", "y"), (), tuple(OPERATIONS))


def rows_of(*expressions: Any) -> Program:
    """A program of the given rows of one input and one parameter."""
    x, p = Symbol.named("x"), Symbol.named("p")
    block = ExpressionStage([x], [p], [expression(x, p) for expression in expressions])
    return Program((), block, ("x",), ("p",), tuple(f"y{i}" for i in range(len(expressions))))


EVERY = [
    lambda x, p: (-2.5) ** x, lambda x, p: x**3, lambda x, p: x ** (-2), lambda x, p: abs(x) ** 0.5,
    lambda x, p: abs(x) ** p, lambda x, p: x**1.5, lambda x, p: 2.0 - (-3.0) * x, lambda x, p: -x / (p - x),
    lambda x, p: x.do("sin") + x.do("cos") * x.do("tan"),
    lambda x, p: (x / 9).do("arcsin") + (x / 9).do("arccos") * x.do("arctan"),
    lambda x, p: x.do("arctan2", p), lambda x, p: x.do("exp") + abs(x).do("log"),
    lambda x, p: x.do("sign") * x.do("floor"), lambda x, p: x.do("fmin", p) + x.do("fmax", 2 * p),
    lambda x, p: x.do("hypot", p), lambda x, p: p.do("copysign", x),
    lambda x, p: choice(x < p, x, -p), lambda x, p: choice((x <= p).do("logical_and", x > -p), x * x, p),
    lambda x, p: choice(x.do("equal", p).do("logical_or", x.do("not_equal", 1.0)), 1.0, 0.0),
    lambda x, p: (x > 0).do("logical_not"),
    lambda x, p: x, lambda x, p: p, lambda x, p: 7.25, lambda x, p: 2 * x, lambda x, p: 1 / x,
    lambda x, p: p * p,
]  # fmt: skip
"""What a program may hold: for :func:`rows_of`."""


def nested() -> Program:
    """Each operation of arithmetic and of conditions within each, on either side: what needs brackets, and what not."""
    a, b, c = x = Symbol.several("x", 3)
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
        "if_else_zero",
        "fabs",
    )
    done = [OPERATIONS[name] for name in names]
    rows = []
    for inner in done:
        part = spelled(inner, a, b)
        number = as_symbol(-2.5)
        rows += [spelled(outer, *pair) for outer in done for pair in ((part, c), (c, part), (part, number))]
    stage = ExpressionStage(x, [], rows)
    return Program((), stage, ("a", "b", "c"), (), tuple(f"y{i}" for i in range(stage.rows)))


def random_rows(seed: int, x: list[Symbol], p: list[Symbol], size: int = 250) -> list[Symbol]:
    """So many operations of inputs and parameters, each kind about as often, on values that were made shortly
    before; every tenth is a row. Some go through a sine, so that they keep to sizes at which they have digits."""
    random = np.random.default_rng(seed)
    values: list[Symbol] = [*x, *p, *map(as_symbol, (-0.75, 0.0, 2.0, 1e-3))]
    every = list(OPERATIONS.values())
    rows: list[Symbol] = []
    for k in range(size):
        left, right = (values[random.integers(max(0, len(values) - 40), len(values))] for _ in range(2))
        values.append(spelled(every[random.integers(len(every))], left, right))
        if k % 3 == 0:  # bring large values back
            values.append(values[-1].do("sin") + values[random.integers(5)])
        if k % 10 == 0:
            rows.append(values[-1])
    return [*rows, *values[-5:]]


def random_program(seed: int, size: int = 250) -> Program:
    """The program of :func:`random_rows` of three inputs and two parameters."""
    x, p = Symbol.several("x", 3), Symbol.several("p", 2)
    stage = ExpressionStage(x, p, random_rows(seed, x, p, size))
    return Program((), stage, ("a", "b", "c"), ("d", "e"), tuple(f"y{i}" for i in range(stage.rows)))
