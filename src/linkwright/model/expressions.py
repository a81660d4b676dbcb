"""The arithmetic of model files: numbers with units, names, calls; parsed here, never executed.

    expression = term {("+" | "-") term}
    term       = factor {("*" | "/") factor}
    factor     = ["+" | "-"] power
    power      = primary ["^" factor]
    primary    = number [unit] | name {"." name} | name "(" arguments ")" {"." name} | "(" expression ")"
    unit       = word ["^" integer] {("*" | "/") word ["^" integer]}

A unit binds to the number before it, so ``1/20 mm`` is 1/(20 mm).
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from linkwright.laws.step import step5
from linkwright.model.units import is_unit
from linkwright.notation import Jet
from linkwright.notation.jets import call

MAX_TEXT = 2000
MAX_DEPTH = 60


class ExpressionError(ValueError):
    """The text is not an expression; the message says why in a few words."""


@dataclass(frozen=True)
class Number:
    """A literal; ``unit`` is ``None`` for a bare number, whose unit then comes from where it stands."""

    value: float
    unit: str | None = None


@dataclass(frozen=True)
class Name:
    """A parameter (``AB``), the time ``t``, ``pi``, or a signal (``E.x``)."""

    text: str


@dataclass(frozen=True)
class Call:
    """A function or table of its arguments; with ``attribute``, a signal such as ``force(a, b).x``."""

    name: str
    args: tuple[Node, ...]
    attribute: str | None = None


@dataclass(frozen=True)
class Negative:
    of: Node


@dataclass(frozen=True)
class Binary:
    op: str
    left: Node
    right: Node


Node = Number | Name | Call | Negative | Binary

_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)"
    r"|(?P<word>[^\W\d][\w']*|°|µm|%)"
    r"|(?P<op>\*\*|[-+*/^().,]))"
)


@dataclass
class _Parser:
    text: str
    shadowed: Callable[[str], bool]
    tokens: list[tuple[str, str]] = field(default_factory=list)
    at: int = 0
    depth: int = 0

    def scan(self) -> None:
        position, text = 0, self.text.rstrip()
        while position < len(text):
            match = _TOKEN.match(text, position)
            if match is None:
                raise ExpressionError(f"unexpected character {text[position:].lstrip()[:1]!r}")
            kind = match.lastgroup or ""
            value = match.group(kind)
            self.tokens.append((kind, "^" if value == "**" else value))
            position = match.end()
        self.tokens.append(("end", ""))

    @property
    def token(self) -> tuple[str, str]:
        return self.tokens[self.at]

    def take(self, *ops: str) -> str | None:
        kind, value = self.token
        if kind == "op" and value in ops:
            self.at += 1
            return value
        return None

    def expect(self, op: str) -> None:
        if self.take(op) is None:
            raise ExpressionError(f"{op!r} expected" + (f" before {self.token[1]!r}" if self.token[1] else " at the end"))

    def whole(self) -> Node:
        self.scan()
        node = self.expression()
        if self.token[0] != "end":
            raise ExpressionError(f"an operator is missing before {self.token[1]!r}")
        return node

    def expression(self) -> Node:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise ExpressionError("nested too deeply")
        node = self.term()
        while op := self.take("+", "-"):
            node = Binary(op, node, self.term())
        self.depth -= 1
        return node

    def term(self) -> Node:
        node = self.factor()
        while op := self.take("*", "/"):
            node = Binary(op, node, self.factor())
        return node

    def factor(self) -> Node:
        sign = 1
        while op := self.take("+", "-"):
            sign = -sign if op == "-" else sign
        node = self.power()
        return node if sign > 0 else Negative(node)

    def power(self) -> Node:
        node = self.primary()
        if self.take("^"):
            self.depth += 1
            if self.depth > MAX_DEPTH:
                raise ExpressionError("nested too deeply")
            node = Binary("^", node, self.factor())
            self.depth -= 1
        return node

    def primary(self) -> Node:
        kind, value = self.token
        self.at += 1
        if kind == "number":
            return Number(_finite(value), self.unit())
        if kind == "word":
            return self.named(value)
        if (kind, value) == ("op", "("):
            node = self.expression()
            self.expect(")")
            return node
        raise ExpressionError(f"a value expected before {value!r}" if value else "a value expected at the end")

    def named(self, word: str) -> Node:
        if self.take("("):
            args = [self.expression()]
            while self.take(","):
                args.append(self.expression())
            self.expect(")")
            return Call(word, tuple(args), self.word() if self.take(".") else None)
        while self.take("."):
            word = f"{word}.{self.word()}"
        return Name(word)

    def word(self) -> str:
        kind, value = self.token
        if kind != "word":
            raise ExpressionError("a name expected after '.'")
        self.at += 1
        return value

    def unit(self) -> str | None:
        kind, value = self.token
        if kind != "word":
            return None
        if not is_unit(value):
            raise ExpressionError(f"unknown unit {value!r}")
        self.at += 1
        unit = value + self.unit_power()
        while self.token in (("op", "*"), ("op", "/")) and self._unit_follows():
            op = self.token[1]
            self.at += 2
            unit += op + self.tokens[self.at - 1][1] + self.unit_power()
        return unit

    def unit_power(self) -> str:
        if self.token != ("op", "^"):
            return ""
        kind, value = self.tokens[self.at + 1]
        if kind != "number" or not value.isdigit():
            raise ExpressionError("a unit's power must be a whole number")
        self.at += 2
        return f"^{value}"

    def _unit_follows(self) -> bool:
        kind, value = self.tokens[self.at + 1]
        after = self.tokens[self.at + 2] if self.at + 2 < len(self.tokens) else ("end", "")
        return kind == "word" and is_unit(value) and not self.shadowed(value) and after not in (("op", "("), ("op", "."))


def _finite(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ExpressionError(f"{text} is too large")
    return value


# After "mm*" or "mm/" these one-letter words are the time and nothing else; tonnes are written "tonne".
_NEVER_UNITS = frozenset({"t", "pi"})


@lru_cache(maxsize=4096)
def parse(text: str) -> Node:
    """The syntax tree of ``text``. Raises :class:`ExpressionError` with a short reason."""
    if len(text) > MAX_TEXT:
        raise ExpressionError(f"longer than {MAX_TEXT} characters")
    if not text.strip():
        raise ExpressionError("empty")
    return _Parser(text, _NEVER_UNITS.__contains__).whole()


def nodes(node: Node) -> Iterator[Node]:
    """The node and all nodes below it."""
    yield node
    below: tuple[Node, ...] = ()
    if isinstance(node, Call):
        below = node.args if node.attribute is None else ()
    elif isinstance(node, Negative):
        below = (node.of,)
    elif isinstance(node, Binary):
        below = (node.left, node.right)
    for child in below:
        yield from nodes(child)


def signal_text(node: Name | Call) -> str:
    """The canonical spelling of a signal: ``E.x``, ``force(frame, crank).x``."""
    if isinstance(node, Name):
        return node.text
    args = ", ".join(signal_text(arg) if isinstance(arg, Name | Call) else "?" for arg in node.args)
    return f"{node.name}({args}).{node.attribute}"


def is_signal(node: Node) -> bool:
    """Whether the node names a signal of the mechanism rather than a parameter or a function."""
    return (isinstance(node, Name) and "." in node.text) or (isinstance(node, Call) and node.attribute is not None)


def _elementary(name: str) -> Callable[..., Any]:
    def apply(*args: Any) -> Any:
        if any(isinstance(arg, Jet) for arg in args):
            order = min(arg.order for arg in args if isinstance(arg, Jet))
            jets = [arg if isinstance(arg, Jet) else Jet.constant(arg, order) for arg in args]
            return getattr(jets[0], name)(*jets[1:])
        return call(name, *args)

    return apply


def _pick(name: str, numbers: Callable[[Any, Any], Any]) -> Callable[..., Any]:
    def apply(a: Any, b: Any) -> Any:
        if isinstance(a, Jet) or isinstance(b, Jet):
            return _elementary(name)(a, b)
        if type(a).__module__.startswith("casadi") or type(b).__module__.startswith("casadi"):
            return call({"minimum": "fmin", "maximum": "fmax"}[name], a, b)
        return numbers(a, b)

    return apply


@dataclass(frozen=True)
class Function:
    """A function of expressions: its number of arguments, its rule of dimensions, its evaluation."""

    arity: int
    rule: str
    apply: Callable[..., Any]


# The rules of dimensions, used by model.dimensions: "trig" takes an angle and gives a pure number, "angle"
# the reverse; "pure" maps pure to pure; "same" gives what it takes; "ratio" an angle of two alike; "root".
FUNCTIONS: dict[str, Function] = {
    **{name: Function(1, "trig", _elementary(name)) for name in ("sin", "cos", "tan")},
    "asin": Function(1, "angle", _elementary("arcsin")),
    "acos": Function(1, "angle", _elementary("arccos")),
    "atan": Function(1, "angle", _elementary("arctan")),
    "atan2": Function(2, "ratio", _elementary("arctan2")),
    "exp": Function(1, "pure", _elementary("exp")),
    "log": Function(1, "pure", _elementary("log")),
    "sqrt": Function(1, "root", _elementary("sqrt")),
    "hypot": Function(2, "same", _elementary("hypot")),
    "abs": Function(1, "same", lambda a: abs(a) if isinstance(a, Jet | int | float) else call("abs", a)),
    "min": Function(2, "same", _pick("minimum", min)),
    "max": Function(2, "same", _pick("maximum", max)),
    "step5": Function(5, "step", step5),
}


def evaluate(node: Node, name: Callable[[Name], Any], other: Callable[[Call], Any] | None = None) -> Any:
    """The value of a bound tree (numbers in SI): ``name`` gives names' values, ``other`` tables' and signals'.

    Works alike on floats, NumPy arrays inside jets, and CasADi symbols.
    """
    if isinstance(node, Number):
        return node.value
    if isinstance(node, Name):
        return math.pi if node.text == "pi" else name(node)
    if isinstance(node, Negative):
        return -evaluate(node.of, name, other)
    if isinstance(node, Call):
        if node.attribute is None and node.name in FUNCTIONS:
            return FUNCTIONS[node.name].apply(*(evaluate(arg, name, other) for arg in node.args))
        if other is None:
            raise ExpressionError(f"{node.name} can't stand here")
        return other(node)
    left, right = evaluate(node.left, name, other), evaluate(node.right, name, other)
    return _OPERATORS[node.op](left, right)


_OPERATORS: dict[str, Callable[[Any, Any], Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
    "^": lambda a, b: a**b,
}
