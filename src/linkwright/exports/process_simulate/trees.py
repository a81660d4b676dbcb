"""Expression trees in joint values (rad and mm): the few operations that joint functions are made of.

Trees don't change; what makes them folds numbers, so that no tree holds a sum of two numbers, a factor 1 or a term 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

ROUND = 1e-15
"""A sum of numbers below this share of the largest of them is zero but for round-off."""


@dataclass(frozen=True)
class Tree:
    """``op`` is ``number`` (with its ``value``), ``T`` or ``D`` (the value of a turning or sliding joint, by ``name``),
    ``+ * /``, ``>= <`` (1 where it holds, else 0) or a function's name, on ``args``."""

    op: str
    args: tuple[Tree, ...] = ()
    value: float = 0.0
    name: str = ""

    @property
    def negative(self) -> bool:
        """Whether it is a negative number or a product with one."""
        return (self.args[0] if self.op == "*" else self).value < 0

    def every(self) -> Iterator[Tree]:
        """The tree and all trees in it."""
        yield self
        for arg in self.args:
            yield from arg.every()


SMALL = 1e-3
"""Factors below this aren't made by dividing."""


def number(value: float) -> Tree:
    """A number."""
    return Tree("number", value=float(value))


ZERO, ONE = number(0.0), number(1.0)


def joint(kind: str, name: str) -> Tree:
    """The value of a joint since the zero pose: ``T`` (rad) or ``D`` (mm)."""
    return Tree(kind, name=name)


def add(*terms: Tree) -> Tree:
    """A sum; what is positive stands first, its number last of that."""
    numbers, parts = [], []
    for term in terms:
        for part in term.args if term.op == "+" else (term,):
            if part.op == "number":
                numbers.append(part.value)
            else:
                parts.append(part)
    parts, constant = _collected(parts), sum(numbers)
    if abs(constant) > ROUND * max(map(abs, numbers), default=0.0):
        parts.append(number(constant))
    parts.sort(key=lambda part: part.negative)
    return parts[0] if len(parts) == 1 else Tree("+", tuple(parts)) if parts else ZERO


def _collected(parts: list[Tree]) -> list[Tree]:
    """The same terms, those that differ by a factor only as one."""
    factors: dict[Tree, float] = {}
    for part in parts:
        factor, rest = _split(part)
        factors[rest] = factors.get(rest, 0.0) + factor
    return [multiply(number(factor), rest) for rest, factor in factors.items() if factor]


def _split(part: Tree) -> tuple[float, Tree]:
    """A term as a number and the rest."""
    if part.op == "*" and part.args[0].op == "number":
        rest = part.args[1:]
        return part.args[0].value, rest[0] if len(rest) == 1 else Tree("*", rest)
    return 1.0, part


def multiply(*factors: Tree) -> Tree:
    """A product, its number first; a number goes into a sum."""
    constant, parts = 1.0, []
    for factor in factors:
        for part in factor.args if factor.op == "*" else (factor,):
            if part.op == "number":
                constant *= part.value
            else:
                parts.append(part)
    if constant == 0 or not parts:
        return number(constant)
    if len(parts) == 1:
        (only,) = parts
        if only.op == "+":
            return add(*(multiply(number(constant), arg) for arg in only.args))
        if constant == 1:
            return only
    return Tree("*", tuple(parts) if constant == 1 else (number(constant), *parts))


def negated(tree: Tree) -> Tree:
    """The opposite."""
    return multiply(number(-1.0), tree)


def divide(above: Tree, below: Tree) -> Tree:
    """A quotient; one by a number is a product, unless that makes numbers too small for fixed decimals."""
    factor, rest = _split(below)
    if below.op == "number":
        terms = above.args if above.op == "+" else (above,)
        least = min(abs(_split(term)[0] if term.op != "number" else term.value) for term in terms)
        if least > SMALL * abs(below.value) or above.op == "number":
            return multiply(number(1.0 / below.value), above)
        return Tree("/", (above, below))
    if factor != 1.0:
        return divide(multiply(number(1.0 / factor), above), rest)
    return ZERO if above == ZERO else Tree("/", (above, below))


def call(name: str, *args: Tree) -> Tree:
    """A function of trees; of numbers, a number."""
    if all(arg.op == "number" for arg in args):
        return number(float(_FUNCTIONS[name](*(np.float64(arg.value) for arg in args))))
    return Tree(name, args)


def evaluate(tree: Tree, values: Mapping[str, Array]) -> Array:
    """The tree where joints have ``values`` (poses) since the zero pose; NaN where it has no value."""
    with np.errstate(all="ignore"):
        return _value(tree, values)


def _value(tree: Tree, values: Mapping[str, Array]) -> Array:
    if tree.op == "number":
        return np.asarray(tree.value)
    if tree.op in ("T", "D"):
        return values[tree.name]
    args = [_value(arg, values) for arg in tree.args]
    if tree.op == "+":
        return sum(args[1:], start=args[0])
    if tree.op == "*":
        product = args[0]
        for arg in args[1:]:
            product = product * arg
        return product
    return np.asarray(_FUNCTIONS[tree.op](*args))


_FUNCTIONS: dict[str, Callable[..., Array]] = {
    "/": np.divide,
    "acos": np.arccos,
    "sin": np.sin,
    "cos": np.cos,
    "sqrt": np.sqrt,
    "atan2": np.arctan2,
    ">=": lambda a, b: (a >= b) * 1.0,
    "<": lambda a, b: (a < b) * 1.0,
}
