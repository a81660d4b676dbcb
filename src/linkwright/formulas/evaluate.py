"""An evaluator of what is written for motors, and of nothing else: it refuses what isn't in the dialect.

    expression = ["-"] term {("+" | "-") term}
    term       = power {("*" | "/") power}
    power      = primary ["^" primary]
    primary    = number | "t" | function "(" expression ")" | "(" expression ")"

Numbers have no exponent. Functions are those that PTC lists for the motors of Creo Mechanism ("About the Functions
Dialog Box"), but for the logarithm to base 10; trigonometric ones count in degrees, or in radians.
"""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_TOKEN = re.compile(r"\s*(?:(\d+(?:\.\d+)?)|([a-z]+)|([-+*/^()]))")
_PLAIN: dict[str, Callable[[Array], Array]] = {"sqrt": np.sqrt, "ln": np.log}


class DialectError(ValueError):
    """A text that isn't in the dialect."""


def value(text: str, t: Array, degrees: bool) -> Array:
    """The value of a text at times ``t``; ``degrees`` says what trigonometric functions count in."""
    reader = _FormulaParser(text, t, np.pi / 180 if degrees else 1.0)
    found = reader.expression()
    if reader.tokens:
        raise DialectError(f"{reader.tokens[0]!r} in {text!r}")
    return np.broadcast_to(found, t.shape)


class _FormulaParser:
    def __init__(self, text: str, t: Array, unit: float) -> None:
        self.t, self.unit = t, unit
        self.tokens: list[str] = []
        at = 0
        text = text.rstrip()
        while at < len(text):
            match = _TOKEN.match(text, at)
            if match is None:
                raise DialectError(f"{text[at:]!r}")
            self.tokens.append(match[match.lastindex or 0])
            at = match.end()

    def accept(self, *wanted: str) -> str:
        return self.tokens.pop(0) if self.tokens and self.tokens[0] in wanted else ""

    def expression(self) -> Array:
        total = -self.term() if self.accept("-") else self.term()
        while sign := self.accept("+", "-"):
            total = total + self.term() if sign == "+" else total - self.term()
        return total

    def term(self) -> Array:
        product = self.power()
        while sign := self.accept("*", "/"):
            product = product * self.power() if sign == "*" else product / self.power()
        return product

    def power(self) -> Array:
        base = self.primary()
        return base ** self.primary() if self.accept("^") else base

    def primary(self) -> Array:
        token = self.tokens.pop(0) if self.tokens else "end"
        if token[0].isdigit():
            return np.array(float(token))
        if token == "t":
            return self.t
        if token == "(":
            return self.bracketed()
        if not self.accept("("):
            raise DialectError(token)
        return self.function(token, self.bracketed())

    def bracketed(self) -> Array:
        inner = self.expression()
        if not self.accept(")"):
            raise DialectError("a bracket stays open")
        return inner

    def function(self, name: str, of: Array) -> Array:
        if name in _PLAIN:
            return _PLAIN[name](of)
        if name in ("sin", "cos", "tan"):
            return np.asarray(getattr(np, name)(of * self.unit))
        if name in ("asin", "acos"):
            return np.asarray(getattr(np, f"arc{name[1:]}")(of) / self.unit)
        raise DialectError(name)
