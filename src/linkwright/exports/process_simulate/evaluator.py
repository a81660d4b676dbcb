"""A reader of joint functions that knows exactly what a dialect has, and refuses the rest: how the tool is taken to
read a text. It shares nothing with what writes them.

    sum    = ["-"] term {("+" | "-") term}                 "-" in the seed dialect only
    term   = factor {("*" | "/") factor}
    factor = number | ("T" | "D") "(" joint ")" | function "(" sum {"," sum} ")" | "(" sum ")"
           | "(" sum (">=" | "<") sum ")"                  1 where it holds, else 0
           | "(-1)" "(" sum ")"                            in the wizard dialect only
    number = digits ["." digits]
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]
Value = Callable[[Mapping[str, Array]], Array]
_TOKEN = re.compile(r"\s*(?:(\d+(?:\.\d+)?)(?![\w.])|([A-Za-z_]\w*)|(>=|\S))")


class NotInDialect(ValueError):
    """A text that the dialect doesn't have, with the place where that shows."""

    def __init__(self, text: str, at: int, wanted: str) -> None:
        super().__init__(f"at {at + 1} of {text[:80]!r}: {wanted}")
        self.at = at


@dataclass(frozen=True)
class Grammar:
    """The functions with their numbers of arguments, and whether there are differences; where not, ``(-1)(x)``."""

    functions: Mapping[str, tuple[int, Callable[..., Array]]]
    minus: bool


GRAMMARS: dict[str, Grammar] = {
    "seed": Grammar(
        {"acos": (1, np.arccos), "sqrt": (1, np.sqrt), "sin": (1, np.sin), "cos": (1, np.cos)},
        minus=True,
    ),
    "wizard": Grammar({"acos": (1, np.arccos), "sin": (1, np.sin), "atan2": (2, np.arctan2)}, minus=False),
}


COMPARED: dict[str, Callable[..., Array]] = {
    ">=": lambda a, b: np.where(a >= b, 1.0, 0.0),
    "<": lambda a, b: np.where(a < b, 1.0, 0.0),
}


def read(text: str, dialect: str, joints: Mapping[str, str]) -> Value:
    """A text as a function of the joints' values (rad and mm) by name; ``joints`` says which are ``T``, which ``D``.

    Raises :class:`NotInDialect` for whatever the dialect doesn't have.
    """
    reader = _FormulaParser(text, GRAMMARS[dialect], joints)
    value = reader.sum()
    if reader.next_token[0]:
        raise reader.fault("the end")
    return value


def evaluate(texts: Sequence[tuple[str, str]], dialect: str, joints: Mapping[str, str], drive: str, at: Array) -> Array:
    """The values of functions, (name, text) each, over values of the driving joint: (functions, values). A function
    may ask for joints before it."""
    values: dict[str, Array] = {drive: at}
    for name, text in texts:
        known = {joint: kind for joint, kind in joints.items() if joint in values}
        with np.errstate(all="ignore"):
            values[name] = np.broadcast_to(read(text, dialect, known)(values), at.shape)
    return np.array([values[name] for name, _ in texts]).reshape(len(texts), at.size)


class _FormulaParser:
    def __init__(self, text: str, grammar: Grammar, joints: Mapping[str, str]) -> None:
        self.text, self.grammar, self.joints = text, grammar, joints
        self.tokens = [(m.group(m.lastindex or 0), m.start(m.lastindex or 0)) for m in _TOKEN.finditer(text)]
        self.next = 0

    @property
    def next_token(self) -> tuple[str, int]:
        """The next token and its place; empty at the end."""
        return self.tokens[self.next] if self.next < len(self.tokens) else ("", len(self.text))

    def fault(self, wanted: str) -> NotInDialect:
        token, at = self.next_token
        return NotInDialect(self.text, at, f"{wanted} is wanted, not {token or 'the end'}")

    def take(self, *wanted: str) -> str:
        """The next token, which must be one of those wanted."""
        token, _ = self.next_token
        if token not in wanted:
            raise self.fault(" or ".join(wanted))
        self.next += 1
        return token

    def sum(self) -> Value:
        minus = self.grammar.minus
        opposite = minus and self.next_token[0] == "-" and bool(self.take("-"))
        total = self.term()
        if opposite:
            total = _composed(np.negative, total)
        while self.next_token[0] in (("+", "-") if minus else ("+",)):
            total = _composed(np.add if self.take("+", "-") == "+" else np.subtract, total, self.term())
        return total

    def term(self) -> Value:
        product = self.factor()
        while self.next_token[0] in ("*", "/"):
            product = _composed(np.multiply if self.take("*", "/") == "*" else np.divide, product, self.factor())
        return product

    def factor(self) -> Value:
        token, _ = self.next_token
        if re.fullmatch(r"\d+(\.\d+)?", token):
            self.next += 1
            constant = np.asarray(float(token))
            return lambda values: constant
        if token in ("T", "D") and self.tokens[self.next + 1 : self.next + 2] and self.tokens[self.next + 1][0] == "(":
            return self.joint(self.take("T", "D"))
        if token in self.grammar.functions:
            return self.call(self.take(token))
        if not self.grammar.minus and [t for t, _ in self.tokens[self.next : self.next + 4]] == ["(", "-", "1", ")"]:
            self.next += 4
            return _composed(np.negative, self.bracket())
        return self.bracket()

    def bracket(self) -> Value:
        self.take("(")
        inner = self.sum()
        if self.next_token[0] in COMPARED:
            inner = _composed(COMPARED[self.take(*COMPARED)], inner, self.sum())
        self.take(")")
        return inner

    def joint(self, kind: str) -> Value:
        self.take("(")
        name, _ = self.next_token
        if self.joints.get(name) != kind:
            raise self.fault(f"a joint of {kind} that is known here")
        self.next += 1
        self.take(")")
        return lambda values: values[name]

    def call(self, name: str) -> Value:
        count, function = self.grammar.functions[name]
        self.take("(")
        args = [self.sum()]
        for _ in range(count - 1):
            self.take(",")
            args.append(self.sum())
        self.take(")")
        return _composed(function, *args)


def _composed(function: Callable[..., Array], *args: Value) -> Value:
    return lambda values: function(*(arg(values) for arg in args))
