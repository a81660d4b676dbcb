"""Trees of expressions in the time t alone, made so that constants fold, and their text.

Numbers are written without exponent, 15 digits of them: what a field of a CAD system takes, and all that a float holds.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping
from decimal import Decimal
from functools import reduce
from math import isfinite, pi

from linkwright.expressions.language import FUNCTIONS, Binary, Call, Name, Negative, Node, Number

T = Name("t")
ONE = Number(1.0)


def function_call(name: str, *args: Node) -> Node:
    """A function of trees; of numbers, its value."""
    numbers = [arg.value for arg in args if isinstance(arg, Number)]
    if len(numbers) == len(args) and isfinite(value := FUNCTIONS[name].apply(*numbers)):
        return Number(float(value))
    return Call(name, args)


def plus(a: Node, b: Node) -> Node:
    """The sum of two trees, term after term, a number first; terms that are alike are one."""
    factors: dict[Node, float] = {ONE: 0.0}
    for term in (*_terms(a), *_terms(b)):
        factor, of = _factor(term)
        factors[of] = factors.get(of, 0.0) + factor
    terms = [times(Number(factor), of) for of, factor in factors.items() if factor]
    return reduce(lambda left, right: Binary("+", left, right), terms) if terms else Number(0.0)


def _factor(term: Node) -> tuple[float, Node]:
    """A term as a number times something."""
    if isinstance(term, Number):
        return float(term.value), ONE
    if isinstance(term, Binary) and term.op == "*" and isinstance(term.left, Number):
        return float(term.left.value), term.right
    return 1.0, term


def _terms(node: Node) -> Iterator[Node]:
    if isinstance(node, Binary) and node.op == "+":
        yield from _terms(node.left)
        yield from _terms(node.right)
    else:
        yield node


def times(a: Node, b: Node) -> Node:
    """The product of two trees, a number first."""
    if isinstance(b, Number):
        a, b = b, a
    if isinstance(a, Number):
        if isinstance(b, Number):
            return Number(a.value * b.value)
        if isinstance(b, Binary) and b.op == "*" and isinstance(b.left, Number):
            return times(Number(a.value * b.left.value), b.right)
        if isinstance(b, Binary) and b.op == "/" and isinstance(b.left, Number):
            return over(Number(a.value * b.left.value), b.right)
        return Number(0.0) if a.value == 0 else b if a.value == 1 else Binary("*", a, b)
    for one, other in ((a, b), (b, a)):
        if isinstance(one, Binary) and one.op == "*" and isinstance(one.left, Number):
            return times(one.left, times(one.right, other))
    return Binary("*", a, b)


def over(a: Node, b: Node) -> Node:
    """The quotient of two trees."""
    if isinstance(b, Number) and b.value != 0:
        return times(Number(1 / b.value), a)
    return Binary("/", a, b)


def power(a: Node, b: Node) -> Node:
    """A power; of a number times something, the powers of both."""
    if isinstance(a, Number) and isinstance(b, Number):
        return Number(a.value**b.value) if a.value > 0 or b.value == int(b.value) >= 0 else Binary("^", a, b)
    if b in (Number(0.0), Number(1.0)):
        return a if b == Number(1.0) else Number(1.0)
    if isinstance(a, Binary) and _is_whole_number(b):
        if a.op == "*" and isinstance(a.left, Number):
            return times(power(a.left, b), power(a.right, b))
        if a.op == "^" and _is_whole_number(a.right):
            return power(a.left, times(a.right, b))
    return Binary("^", a, b)


def _is_whole_number(node: Node) -> bool:
    return isinstance(node, Number) and node.value == int(node.value)


MADE: dict[str, Callable[[Node, Node], Node]] = {
    "+": plus,
    "-": lambda a, b: plus(a, times(Number(-1.0), b)),
    "*": times,
    "/": over,
    "^": power,
}


def plain(node: Node, names: Mapping[str, Node], kept: Container[str] = ()) -> Node:
    """A tree anew, with trees for its names, and without differences and signs; functions ``kept`` don't fold."""
    if isinstance(node, Number):
        return node
    if isinstance(node, Name):
        return Number(pi) if node.text == "pi" else names[node.text]
    if isinstance(node, Negative):
        return times(Number(-1.0), plain(node.of, names, kept))
    if isinstance(node, Binary):
        return MADE[node.op](plain(node.left, names, kept), plain(node.right, names, kept))
    args = [plain(arg, names, kept) for arg in node.args]
    return Call(node.name, tuple(args)) if node.name in kept else function_call(node.name, *args)


def scaled(node: Node, by: float) -> Node:
    """A tree times a number, which goes into each term of a sum, and of one that is multiplied already; but not into
    ``b (t - t0)``."""
    if isinstance(node, Binary) and node.op == "+":
        return plus(scaled(node.left, by), scaled(node.right, by))
    factor, of = _factor(node)
    if factor != 1 and affine(of) is None:
        return scaled(of, by * factor)
    return times(Number(by), node)


def affine(node: Node) -> tuple[float, float] | None:
    """``a`` and ``b`` where a tree is ``a + b t``, else None."""
    if isinstance(node, Number):
        return node.value, 0.0
    if node == T:
        return 0.0, 1.0
    if isinstance(node, Binary) and node.op in "+*":
        left, right = affine(node.left), affine(node.right)
        if left is None or right is None:
            return None
        if node.op == "+":
            return left[0] + right[0], left[1] + right[1]
        if left[1] == 0:
            return left[0] * right[0], left[0] * right[1]
    return None


def shifted(node: Node, stop: float) -> Node:
    """A tree ``a + b t`` as ``b (t - t0)`` where t0 lies in 0 .. ``stop``; others as they are."""
    line = affine(node)
    if line is None or line[1] == 0 or not 0 <= -line[0] / line[1] <= stop:
        return node
    return times(Number(line[1]), plus(T, Number(line[0] / line[1])))


def text(node: Node) -> str:
    """The text of a tree, with the operators + - * / ^ and brackets."""
    return _text(node)[0]


def number(value: float) -> str:
    """A number with 15 digits, without exponent."""
    digits = format(Decimal(f"{value:.15g}"), "f")
    digits = digits.rstrip("0").rstrip(".") if "." in digits else digits
    return "0" if digits in ("-0", "") else digits


_LEVELS = {"+": 1, "*": 2, "/": 2, "^": 4}


def _text(node: Node) -> tuple[str, int]:
    """The text and how tightly its outermost operation binds."""
    if isinstance(node, Number):
        return number(node.value), 5 if node.value >= 0 else 0
    if isinstance(node, Name):
        return node.text, 5
    if isinstance(node, Call):
        return f"{node.name}({', '.join(text(arg) for arg in node.args)})", 5
    assert not isinstance(node, Negative)
    level = _LEVELS[node.op]
    if node.op == "+":
        left, right = (
            (node.right, node.left) if _falls(node.left) and not _falls(node.right) else (node.left, node.right)
        )
        sign, right = (" - ", scaled(right, -1.0)) if _falls(right) else (" + ", right)
        return f"{_text(left)[0]}{sign}{_within(right, 2)}", level
    if node.op == "*" and isinstance(node.left, Number) and node.left.value < 0:
        return f"-{_within(times(Number(-node.left.value), node.right), 2)}", 0
    least = level + 1 if node.op in "/^" else level
    return f"{_within(node.left, level + (node.op == '^'))}{node.op}{_within(node.right, least)}", level


def _falls(node: Node) -> bool:
    """Whether a tree begins with a negative number."""
    first = node.left if isinstance(node, Binary) and node.op == "*" else node
    return isinstance(first, Number) and first.value < 0


def _within(node: Node, least: int) -> str:
    written, level = _text(node)
    return written if level >= least else f"({written})"
