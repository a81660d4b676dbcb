"""Straight-line code in some language: what emitters that write code have in common.

A language has words for a few primitive operations (:data:`PRIMITIVES`); the operations of programs, the elementary
functions of :mod:`linkwright.kernels.elementary` and the steps of Newton's method are written with them. So all
emitters do the same arithmetic in the same order.
"""

from __future__ import annotations

import ast
import inspect
import math
from collections.abc import Callable, Mapping, Sequence
from typing import Protocol

from linkwright.graph.program import NewtonStage
from linkwright.kernels import elementary
from linkwright.symbols import OPERATIONS

PRIMITIVES: Mapping[str, int] = {
    "add": 2,
    "subtract": 2,
    "multiply": 2,
    "divide": 2,
    "negative": 1,
    "sqrt": 1,
    "fabs": 1,
    "floor": 1,
    "less": 2,
    "less_equal": 2,
    "greater": 2,
    "greater_equal": 2,
    "equal": 2,
    "not_equal": 2,
    "and": 2,
    "or": 2,
    "select": 3,
    "power_of_two": 1,
    "binary_exponent": 1,
    "binary_fraction": 1,
}
"""The primitive operations and the number of their operands. Comparisons give conditions, of which one is selected by;
the last three are functions of :mod:`linkwright.kernels.elementary` that look at a number's bits."""

BITS: Mapping[str, tuple[tuple[tuple[str, int], ...], float]] = {
    "power_of_two": ((("add", 1023), ("shift left", 52)), 0.0),
    "binary_exponent": (
        (("add", 0x95F619980C433), ("shift right", 52), ("or", 0x4330000000000000)),
        4503599627371519.0,
    ),
    "binary_fraction": ((("add", 0x95F619980C433), ("and", 0xFFFFFFFFFFFFF), ("add", 0x3FE6A09E667F3BCD)), 1.0),
}
"""Of those three: what is done to the bits as a whole number of 64, and the number that is taken away afterwards."""


class Code(Protocol):
    """Straight-line code that is being written. Operands are text; what is written once is named and used again."""

    def number(self, value: float) -> str:
        """A number as an operand."""

    def do(self, primitive: str, *operands: str) -> str:
        """Write a primitive operation; its result as an operand."""

    def function(self, name: str, operands: Sequence[str]) -> str:
        """Write an elementary function, out (:func:`written_out`) or as a call; its result as an operand."""


def written(code: Code, name: str, operands: Sequence[str]) -> str:
    """Write an operation of a program; its result as an operand."""
    if name in _WRITTEN:
        return _WRITTEN[name](code, *operands)
    if name in PRIMITIVES:
        return code.do(name, *operands)
    return code.function(_CALLED.get(name, name), operands)


def written_out(code: Code, name: str, operands: Sequence[str]) -> str:
    """Write all operations of an elementary function; its result as an operand."""
    (result,) = _Body(code, name, operands).results
    return result


def _flag(code: Code, condition: str) -> str:
    """A condition as 1 or 0."""
    return code.do("select", condition, code.number(1.0), code.number(0.0))


def _holds(code: Code, x: str, comparison: str = "not_equal") -> str:
    """The condition that a number stands for."""
    return code.do(comparison, x, code.number(0.0))


_WRITTEN: dict[str, Callable[..., str]] = {
    "twice": lambda code, x: code.do("multiply", code.number(2.0), x),
    "square": lambda code, x: code.do("multiply", x, x),
    "reciprocal": lambda code, x: code.do("divide", code.number(1.0), x),
    **{
        name: lambda code, x, y, name=name: _flag(code, code.do(name, x, y))
        for name in ("less", "less_equal", "equal", "not_equal")
    },
    "logical_not": lambda code, x: _flag(code, _holds(code, x, "equal")),
    "logical_and": lambda code, x, y: _flag(code, code.do("and", _holds(code, x), _holds(code, y))),
    "logical_or": lambda code, x, y: _flag(code, code.do("or", _holds(code, x), _holds(code, y))),
    "if_else_zero": lambda code, x, y: code.do("select", _holds(code, x), y, code.number(0.0)),
}
_CALLED = {"arcsin": "asin", "arccos": "acos", "arctan": "atan", "arctan2": "atan2"}
WRITABLE = frozenset(
    name for name in OPERATIONS if {name, _CALLED.get(name)} & {*_WRITTEN, *PRIMITIVES, *elementary.FUNCTIONS}
)
"""The operations of programs that can be written."""


def whole_power(code: Code, x: str, power: int) -> str:
    """A power of few factors, by squares."""
    result = ""
    while power:
        if power & 1:
            result = code.do("multiply", result, x) if result else x
        power >>= 1
        if power:
            x = code.do("multiply", x, x)
    return result


def newton_step(
    code: Code, stage: NewtonStage, u: Sequence[str], misses: Sequence[str], slopes: Sequence[Sequence[str]]
) -> tuple[list[str], str]:
    """Write one step of Newton's method from the coordinates ``u``: the new ones, and how far it went as a share of
    what the stage measures steps over.

    Elimination with the largest pivots, rows exchanged by selects, so that it runs over many poses at once.
    """
    do, n = code.do, len(u)
    a = [[*slopes[r], misses[r]] for r in range(n)]
    for k in range(n):
        for r in range(k + 1, n):
            less = do("less", do("fabs", a[k][k]), do("fabs", a[r][k]))
            for q in range(k, n + 1):
                low, high = do("select", less, a[k][q], a[r][q]), do("select", less, a[r][q], a[k][q])
                a[r][q], a[k][q] = low, high
        for r in range(k + 1, n):
            f = do("divide", a[r][k], a[k][k])
            for q in range(k + 1, n + 1):
                a[r][q] = do("subtract", a[r][q], do("multiply", f, a[k][q]))
    steps: dict[int, str] = {}
    for k in reversed(range(n)):
        rest = a[k][n]
        for q in range(k + 1, n):
            rest = do("subtract", rest, do("multiply", a[k][q], steps[q]))
        steps[k] = do("divide", rest, a[k][k])
    new, moved = [], code.number(0.0)
    for k, (scale, slides) in enumerate(zip(stage.scale, stage.sliding, strict=True)):
        new.append(do("subtract", u[k], steps[k]))
        size = code.number(scale)
        if slides:
            far = do("fabs", new[k])
            size = do("select", do("less", far, size), size, far)
        share = do("divide", do("fabs", steps[k]), size)
        # NaN counts as the farthest.
        farther = do("or", do("not_equal", share, share), do("greater", share, moved))
        moved = do("select", farther, share, moved)
    return new, moved


class _Body:
    """An elementary function written out where it is called, from its Python text."""

    def __init__(self, code: Code, name: str, operands: Sequence[str]) -> None:
        self.code = code
        function = _FUNCTIONS[name]
        self.names: dict[str, str] = dict(zip((a.arg for a in function.args.args), operands, strict=True))
        self.results: tuple[str, ...] = ()
        for line in function.body:
            if isinstance(line, ast.Assign):
                values = self.values(line.value)
                target = line.targets[0]
                names = target.elts if isinstance(target, ast.Tuple) else [target]
                for to, value in zip(names, values, strict=True):
                    assert isinstance(to, ast.Name)
                    self.names[to.id] = value
            elif isinstance(line, ast.Return):
                assert line.value is not None
                self.results = self.values(line.value)

    def values(self, node: ast.expr) -> tuple[str, ...]:
        """What an expression gives: one value, or those of a tuple."""
        if isinstance(node, ast.Tuple):
            return tuple(map(self.value, node.elts))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id not in PRIMITIVES:
            return _Body(self.code, node.func.id, [self.value(arg) for arg in node.args]).results
        return (self.value(node),)

    def value(self, node: ast.expr) -> str:
        """What an expression of one value gives."""
        match node:
            case ast.Name(id=name) if name in self.names:
                return self.names[name]
            case ast.Constant() | ast.Name() | ast.Attribute() | ast.UnaryOp(operand=ast.Constant() | ast.Attribute()):
                return self.code.number(_number(node))
            case ast.BinOp():
                return self.code.do(_OPERATORS[type(node.op)], self.value(node.left), self.value(node.right))
            case ast.UnaryOp():
                return self.code.do("negative", self.value(node.operand))
            case ast.Compare():
                left, right = self.value(node.left), self.value(node.comparators[0])
                return self.code.do(_OPERATORS[type(node.ops[0])], left, right)
            case ast.IfExp():
                return self.code.do("select", *map(self.value, (node.test, node.body, node.orelse)))
            case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name)) if name in PRIMITIVES:
                return self.code.do(name, *map(self.value, node.args))
        (result,) = self.values(node)
        return result


def _number(node: ast.expr) -> float:
    """A constant: a number, one of this module's or of ``math``, or the opposite of one."""
    match node:
        case ast.Constant(value=float(number)):
            return number
        case ast.Name(id=name):
            return float(getattr(elementary, name))
        case ast.Attribute(attr=name):
            return float(getattr(math, name))
        case ast.UnaryOp():
            return -_number(node.operand)
    raise NotImplementedError(ast.unparse(node))


_OPERATORS: dict[type, str] = {
    ast.Add: "add", ast.Sub: "subtract", ast.Mult: "multiply", ast.Div: "divide", ast.BitAnd: "and", ast.BitOr: "or",
    ast.Lt: "less", ast.LtE: "less_equal", ast.Gt: "greater", ast.GtE: "greater_equal", ast.Eq: "equal",
    ast.NotEq: "not_equal",
}  # fmt: skip


_FUNCTIONS: dict[str, ast.FunctionDef] = {
    node.name: node for node in ast.parse(inspect.getsource(elementary)).body if isinstance(node, ast.FunctionDef)
}
"""The elementary functions and their parts, by name; read here, as Python 3.11 can't in several threads at once."""
