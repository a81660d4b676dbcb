"""What is simplified as a symbol is made, operation by operation.

Most rules are exact: x + 0, 1 x, -(-x), x + (-y) = x - y, x x = x^2. That 0 x, 0 / x, x - x and a factor of a value
that isn't chosen are 0 keeps a branch that isn't taken from giving NaN. Some rules leave out a rounding:
a (b x) = (a b) x for numbers, (x + y) - y = x, (x y) / y = x, sin^2 + cos^2 = 1.
"""

from __future__ import annotations

from typing import Any

from linkwright.symbols.symbol import CONSTANT, Symbol, applied, constant, simplifies

Simpler = Any
"""A symbol, or ``None`` where nothing is simpler; arithmetic of symbols has no type of its own."""
LARGEST_PRODUCT = 100
"""Whole powers up to this one are products."""
NEVER_NEGATIVE = ("square", "sqrt", "fabs")


def _is(x: Symbol, number: float) -> bool:
    return x.op is CONSTANT and x.value == number


def _of_same(op: str, x: Symbol, y: Symbol) -> bool:
    """Whether both are results of an operation, of one first operand."""
    return x.op == op and y.op == op and x.args[0] is y.args[0]


@simplifies("add")
def _sum(x: Symbol, y: Symbol) -> Simpler:
    if _is(x, 0.0):
        return y
    if _is(y, 0.0):
        return x
    if x is y:
        return applied("twice", x)
    if y.op == "negative":
        return x - y.args[0]
    if x.op == "negative":
        return y - x.args[0]
    if x.op == "subtract" and x.args[1] is y:
        return x.args[0]
    if y.op == "subtract" and y.args[1] is x:
        return y.args[0]
    for one, other in ((x, y), (y, x)):
        if one.op == "twice" and one.args[0] is other:
            return 3.0 * other
    if _of_same("if_else_zero", x, y):
        return x.args[0].do("if_else_zero", x.args[1] + y.args[1])
    return constant(1.0) if _squares_of_sine_and_cosine(x, y) else None


def _squares_of_sine_and_cosine(x: Symbol, y: Symbol) -> bool:
    if x.op == "square" and y.op == "square":
        a, b = x.args[0], y.args[0]
        return {a.op, b.op} == {"sin", "cos"} and a.args[0] is b.args[0]
    return False


@simplifies("subtract")
def _difference(x: Symbol, y: Symbol) -> Simpler:
    if _is(y, 0.0):
        return x
    if _is(x, 0.0):
        return -y
    if x is y:
        return constant(0.0)
    if y.op == "negative":
        return x + y.args[0]
    if x.op == "add" and y in x.args:
        return x.args[0] if x.args[1] is y else x.args[1]
    if y.op == "add" and x in y.args:
        return -(y.args[0] if y.args[1] is x else y.args[1])
    if x.op == "negative":
        return -(x.args[0] + y)
    if x.op == "twice" and x.args[0] is y:
        return y
    return None


@simplifies("negative")
def _opposite(x: Symbol) -> Simpler:
    return x.args[0] if x.op == "negative" else None


@simplifies("multiply")
def _product(x: Symbol, y: Symbol) -> Simpler:
    if x is y:
        return applied("square", x)
    if y.op is CONSTANT:  # numbers come first
        return applied("multiply", y, x)
    if x.op is CONSTANT:
        return _multiple(x, y)
    if x.op == "if_else_zero":
        return x.args[0].do("if_else_zero", x.args[1] * y)
    if y.op == "if_else_zero":
        return y.args[0].do("if_else_zero", x * y.args[1])
    if x.op == "negative":
        return -(x.args[0] * y)
    if y.op == "negative":
        return -(x * y.args[0])
    if x.op == "reciprocal":
        return y / x.args[0]
    if y.op == "reciprocal":
        return x / y.args[0]
    if y.op == "divide" and y.args[1] is x:
        return y.args[0]
    if x.op == "divide" and x.args[1] is y:
        return x.args[0]
    return None


def _multiple(number: Symbol, y: Symbol) -> Simpler:
    """A number times a symbol."""
    k = number.value
    if k == 0:
        return constant(0.0)
    if k in (1, -1):
        return y if k == 1 else -y
    if y.op == "negative":
        return -(number * y.args[0])
    if y.op == "multiply" and y.args[0].op is CONSTANT:
        return constant(k * y.args[0].value) * y.args[1]
    if y.op == "twice":
        return constant(k * 2.0) * y.args[0]
    if y.op == "divide" and y.args[1] is number:
        return y.args[0]
    if y.op == "if_else_zero":
        return y.args[0].do("if_else_zero", number * y.args[1])
    return applied("twice", y) if k == 2 else None


@simplifies("divide")
def _quotient(x: Symbol, y: Symbol) -> Simpler:
    if _is(x, 0.0):
        return constant(0.0)
    if y.op is CONSTANT and y.value in (1, -1):
        return x if y.value == 1 else -x
    if x is y:
        return constant(1.0)
    if _is(x, 1.0):
        return applied("reciprocal", y)
    if x.op == "negative":
        return -(x.args[0] / y)
    if y.op == "negative":
        return -(x / y.args[0])
    if y.op == "reciprocal":
        return x * y.args[0]
    if x.op == "multiply" and y in x.args:
        return x.args[1] if x.args[0] is y else x.args[0]
    if x.op == "twice" and (_is(y, 2.0) or x.args[0] is y):
        return x.args[0] if _is(y, 2.0) else constant(2.0)
    if x.op == "twice" and y.op == "twice":
        return x.args[0] / y.args[0]
    return None


@simplifies("reciprocal")
def _reciprocal(x: Symbol) -> Simpler:
    return x.args[0] if x.op == "reciprocal" else None


@simplifies("twice")
def _double(x: Symbol) -> Simpler:
    return -(applied("twice", x.args[0])) if x.op == "negative" else None


@simplifies("square")
def _square(x: Symbol) -> Simpler:
    if x.op == "sqrt":
        return x.args[0]
    return applied("square", x.args[0]) if x.op in ("negative", "fabs") else None


@simplifies("power")
def _power(x: Symbol, y: Symbol) -> Simpler:
    """Whole powers as products of squares."""
    if y.op is not CONSTANT:
        return None
    power = y.value
    if power == 0.5:
        return applied("sqrt", x)
    if not abs(power) <= LARGEST_PRODUCT or power != int(power):
        return None
    if power < 0:
        return 1.0 / x**-power
    if power in (0, 1):
        return x if power else constant(1.0)
    if power % 2:
        return x * x ** (power - 1.0)
    return applied("square", x ** (power / 2.0))


@simplifies("sqrt")
def _root(x: Symbol) -> Simpler:
    return applied("fabs", x.args[0]) if x.op == "square" else None


@simplifies("fabs")
def _magnitude(x: Symbol) -> Simpler:
    if x.op in NEVER_NEGATIVE:
        return x
    return applied("fabs", x.args[0]) if x.op == "negative" else None


@simplifies("cos")
def _cosine(x: Symbol) -> Simpler:
    return applied("cos", x.args[0]) if x.op == "negative" else None


@simplifies("log")
def _logarithm(x: Symbol) -> Simpler:
    return x.args[0] if x.op == "exp" else None


@simplifies("fmin", "fmax")
def _same(x: Symbol, y: Symbol) -> Simpler:
    return x if x is y else None


@simplifies("less")
def _less(x: Symbol, y: Symbol) -> Simpler:
    never = x is y or (x.op in NEVER_NEGATIVE and y.op is CONSTANT and y.value <= 0)
    return constant(0.0) if never else None


@simplifies("less_equal")
def _less_equal(x: Symbol, y: Symbol) -> Simpler:
    always = x is y or (y.op in NEVER_NEGATIVE and x.op is CONSTANT and x.value <= 0)
    return constant(1.0) if always else None


@simplifies("logical_and")
def _both(x: Symbol, y: Symbol) -> Simpler:
    return constant(0.0) if _is(x, 0.0) or _is(y, 0.0) else None


@simplifies("if_else_zero")
def _chosen(x: Symbol, y: Symbol) -> Simpler:
    if x.op is CONSTANT:
        return y if x.value != 0 else constant(0.0)
    return constant(0.0) if _is(y, 0.0) else None
