"""The pieces of which motion laws are made: powers and waves on an interval, with every derivative in closed form."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import perm
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.notation import Jet

Array = NDArray[np.float64]


class Part(Protocol):
    """A smooth stretch of a curve from ``start`` to ``stop``."""

    @property
    def start(self) -> float: ...

    @property
    def stop(self) -> float: ...

    @property
    def fineness(self) -> int:
        """In how many steps its turning points are told apart."""

    def at(self, x: Array, order: int) -> Array:
        """A derivative by the argument; order 0 is the value."""

    def moved(self, offset: float, width: float, scale: float, base: float) -> Part:
        """``base + scale * part((x - offset) / width)``; a negative width runs it backwards."""

    def text(self, x: str) -> str:
        """Its formula in ``x``: infix with ``+ - * / ^ ( ) sin cos pi``, numbers as Python writes them."""


class Wave(NamedTuple):
    """``amplitude * sin(rate pi x)``, or the cosine where ``even``."""

    amplitude: float
    rate: float
    even: bool = False


@dataclass(frozen=True)
class Piece:
    """``sum powers[i] z^i + sum of waves in z`` with ``z = x - origin``."""

    start: float
    stop: float
    powers: tuple[float, ...] = ()
    waves: tuple[Wave, ...] = ()
    origin: float = 0.0

    @property
    def fineness(self) -> int:
        halves = max((wave.rate for wave in self.waves), default=0.0) * (self.stop - self.start)
        return 16 * (2 + len(self.powers) + int(halves))

    def at(self, x: Array, order: int) -> Array:
        z = x - self.origin
        total = np.zeros_like(z)
        for i in range(len(self.powers) - 1, order - 1, -1):
            total = total * z + perm(i, order) * self.powers[i]
        for amplitude, rate, even in self.waves:
            quarter = (order + even) % 4  # sin, cos, -sin, -cos
            function = np.cos if quarter % 2 else np.sin
            size = amplitude * (rate * np.pi) ** order
            total = total + (-size if quarter > 1 else size) * function(np.pi * (rate * z))
        return total

    def moved(self, offset: float, width: float, scale: float, base: float) -> Piece:
        start, stop = sorted((offset + width * self.start, offset + width * self.stop))
        powers = [scale * c / width**i for i, c in enumerate(self.powers)] or [0.0]
        powers[0] += base
        turned = -1.0 if width < 0 else 1.0
        waves = tuple(Wave(scale * a * (1.0 if even else turned), r / abs(width), even) for a, r, even in self.waves)
        return Piece(start, stop, tuple(powers), waves, offset + width * self.origin)

    def text(self, x: str) -> str:
        z = x if self.origin == 0 else f"({x} {'-' if self.origin > 0 else '+'} {abs(self.origin)!r})"
        terms = [(c, f"{z}^{i}" if i > 1 else z if i else "") for i, c in enumerate(map(float, self.powers)) if c]
        for amplitude, rate, even in self.waves:
            angle = f"pi*{z}" if rate == 1 else f"{float(rate)!r}*pi*{z}"
            terms.append((float(amplitude), f"{'cos' if even else 'sin'}({angle})"))
        return _sum(terms)


def _sum(terms: list[tuple[float, str]]) -> str:
    """A sum of factors times something; nothing is 1."""
    text = ""
    for factor, of in terms:
        sign = "-" if factor < 0 else "+"
        size = abs(factor)
        term = (of if size == 1 else f"{size!r}*{of}") if of else repr(size)
        text = f"{text} {sign} {term}" if text else term if factor > 0 else f"-{term}"
    return text or "0.0"


@dataclass(frozen=True)
class Formula:
    """A user's function on jets, from 0 to 1: ``base + scale * function((x - offset) / width)``.

    ``words`` gives its text in the argument.
    """

    function: Callable[[Jet], Jet]
    words: Callable[[str], str]
    offset: float = 0.0
    width: float = 1.0
    scale: float = 1.0
    base: float = 0.0

    @property
    def start(self) -> float:
        return min(self.offset, self.offset + self.width)

    @property
    def stop(self) -> float:
        return max(self.offset, self.offset + self.width)

    @property
    def fineness(self) -> int:
        return 256

    def at(self, x: Array, order: int) -> Array:
        u = np.asarray((x - self.offset) / self.width, dtype=float)
        jet = Jet([u, np.ones_like(u), *[np.zeros_like(u)] * max(0, order - 1)]).cut(order)
        with np.errstate(all="ignore"):
            value = np.asarray(self.function(jet).d[order], dtype=float)
        found = self.scale / self.width**order * np.broadcast_to(value, u.shape)
        return found + self.base if order == 0 else found

    def moved(self, offset: float, width: float, scale: float, base: float) -> Formula:
        return Formula(
            self.function,
            self.words,
            offset + width * self.offset,
            width * self.width,
            scale * self.scale,
            base + scale * self.base,
        )

    def text(self, x: str) -> str:
        inner = f"(({x} - {self.offset!r})/{self.width!r})" if (self.offset, self.width) != (0.0, 1.0) else x
        return f"{self.base!r} + {self.scale!r}*({self.words(inner)})"
