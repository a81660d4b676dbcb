"""From the text of an expression to its tree; the grammar stands in :mod:`linkwright.expressions.language`."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import field
from functools import lru_cache
from typing import Any, Literal, NamedTuple

from linkwright.data_classes import dataclass
from linkwright.expressions.trees import Binary, Call, Name, Negative, Node, Number, height
from linkwright.expressions.units import is_unit
from linkwright.findings import Term

Role = Literal["element", "function", "parameter"]
MAX_TEXT = 2000
MAX_DEPTH = 60
MAX_HEIGHT = 200


class ExpressionError(ValueError):
    """The text is not an expression; ``reason`` says why in a few words."""

    def __init__(self, key: str, **data: Any) -> None:
        super().__init__(key)
        self.reason = Term(f"syntax-{key}", **data)


_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)"
    r"|(?P<word>[^\W\d][\w']*|°|%)"
    r"|(?P<op>\*\*|[-+*/^().,−·×]))"
)
_SPELLINGS = {"**": "^", "−": "-", "·": "*", "×": "*"}

# After "mm*" or "mm/" these words are the time and the number and nothing else; tonnes are written "tonne".
_NEVER_UNITS = ("t", "pi")


def tokens(text: str) -> Iterator[tuple[str, str, int, int]]:
    """The numbers, words and operators of a text, each with its kind and place; what is none of these has no kind."""
    position, text = 0, text.rstrip()
    while position < len(text):
        match = _TOKEN.match(text, position)
        kind = (match.lastgroup or "") if match else ""
        start, end = match.span(kind) if match else (position + text[position:].index(text[position:].lstrip()[0]), 0)
        position = end or start + 1
        yield kind, text[start:position], start, position


class NameAt(NamedTuple):
    """A name in the text of an expression, from ``start`` to ``end``: of an ``element`` of the mechanism (the owner of
    a signal), of a ``function`` or table, or of a ``parameter``."""

    start: int
    end: int
    role: Role


@lru_cache(maxsize=4096)
def names_at(text: str) -> tuple[NameAt, ...]:
    """The names in an expression, in their order; units aren't names. Raises :class:`ExpressionError`."""
    parser = _Parser(text)
    parser.parse()
    return tuple(sorted(parser.names))


@lru_cache(maxsize=4096)
def parse(text: str) -> Node:
    """The syntax tree of ``text``. Raises :class:`ExpressionError` with a short reason."""
    if len(text) > MAX_TEXT:
        raise ExpressionError("long", limit=MAX_TEXT)
    if not text.strip():
        raise ExpressionError("empty")
    node = _Parser(text).parse()
    # Everything downstream walks the tree by recursion.
    if height(node) > MAX_HEIGHT:
        raise ExpressionError("deep")
    return node


def reads(text: str) -> bool:
    """Whether a text is an expression."""
    try:
        parse(text)
    except ExpressionError:
        return False
    return True


@dataclass
class _Parser:
    text: str
    tokens: list[tuple[str, str]] = field(default_factory=list)
    places: list[tuple[int, int]] = field(default_factory=list)
    names: list[NameAt] = field(default_factory=list)
    at: int = 0
    depth: int = 0

    def scan(self) -> None:
        for kind, value, start, end in tokens(self.text):
            if not kind:
                raise ExpressionError("character", given=value)
            self.places.append((start, end))
            self.tokens.append((kind, _SPELLINGS.get(value, value)))
        self.tokens.append(("end", ""))

    @property
    def token(self) -> tuple[str, str]:
        return self.tokens[self.at]

    def accept(self, *ops: str) -> str | None:
        kind, value = self.token
        if kind == "op" and value in ops:
            self.at += 1
            return value
        return None

    def close(self) -> None:
        if self.accept(")") is None:
            value = self.token[1]
            raise ExpressionError("close", before=value) if value else ExpressionError("close-end")

    def parse(self) -> Node:
        self.scan()
        node = self.expression()
        if self.token[0] != "end":
            raise ExpressionError("open" if self.token[1] == ")" else "operator", before=self.token[1])
        return node

    def deeper(self) -> None:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise ExpressionError("deep")

    def expression(self) -> Node:
        self.deeper()
        node = self.term()
        while op := self.accept("+", "-"):
            node = Binary(op, node, self.term())
        self.depth -= 1
        return node

    def term(self) -> Node:
        node = self.factor()
        while op := self.accept("*", "/"):
            node = Binary(op, node, self.factor())
        return node

    def factor(self) -> Node:
        sign = 1
        while op := self.accept("+", "-"):
            sign = -sign if op == "-" else sign
        node = self.power()
        return node if sign > 0 else Negative(node)

    def power(self) -> Node:
        node = self.primary()
        if self.accept("^"):
            self.deeper()
            node = Binary("^", node, self.factor())
            self.depth -= 1
        return node

    def primary(self) -> Node:
        kind, value = self.token
        if kind == "number":
            self.at += 1
            return Number(_finite(value), self.unit())
        if kind == "word":
            self.at += 1
            return self.named(value)
        if self.accept("("):
            node = self.expression()
            self.close()
            return node
        raise ExpressionError("value", before=value) if value else ExpressionError("value-end")

    def named(self, word: str) -> Node:
        place, before = self.places[self.at - 1], len(self.names)
        if self.accept("("):
            args = [self.expression()]
            while self.accept(","):
                args.append(self.expression())
            self.close()
            attribute = self.word() if self.accept(".") else None
            if attribute is None:
                self.names.append(NameAt(*place, "function"))
            else:  # a signal: its arguments are elements
                self.names[before:] = [name._replace(role="element") for name in self.names[before:]]
            return Call(word, tuple(args), attribute)
        owner = word
        while self.accept("."):
            word = f"{word}.{self.word()}"
        self.names.append(NameAt(*place, "parameter" if word == owner else "element"))
        return Name(word)

    def word(self) -> str:
        kind, value = self.token
        if kind != "word":
            raise ExpressionError("attribute")
        self.at += 1
        return value

    def unit(self) -> str | None:
        kind, value = self.token
        if kind != "word":
            return None
        if not is_unit(value):
            raise ExpressionError("unit", word=value)
        self.at += 1
        unit = value + self.unit_power()
        while self.token in (("op", "*"), ("op", "/")) and self.unit_follows():
            op = self.token[1]
            self.at += 2
            unit += op + self.tokens[self.at - 1][1] + self.unit_power()
        return unit

    def unit_power(self) -> str:
        if self.token != ("op", "^"):
            return ""
        kind, value = self.tokens[self.at + 1]
        if kind != "number" or not re.fullmatch("[1-9]", value):
            raise ExpressionError("unit-power")
        self.at += 2
        return f"^{value}"

    def unit_follows(self) -> bool:
        kind, value = self.tokens[self.at + 1]
        after = self.tokens[self.at + 2] if self.at + 2 < len(self.tokens) else ("end", "")
        is_word = kind == "word" and is_unit(value) and value not in _NEVER_UNITS
        return is_word and after not in (("op", "("), ("op", "."))


def _finite(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ExpressionError("large", given=text[:40])
    return value
