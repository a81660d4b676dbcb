"""The pieces of which motion laws are made: powers and waves on an interval, with every derivative in closed form."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import perm
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.laws.numbers import backward, largest, plain, zero
from linkwright.notation import Jet, Scalar
from linkwright.notation.duals import Dual, value_of
from linkwright.notation.jets import call, symbolic

Array = NDArray[np.float64]

ROUND_OFF = 1e-14
"""How far a wave's half turns may be off a whole number that they are meant to be, over them."""


class SmoothPart(Protocol):
    """A smooth stretch of a curve from ``start`` to ``stop``."""

    @property
    def start(self) -> Scalar: ...

    @property
    def stop(self) -> Scalar: ...

    @property
    def numbers(self) -> tuple[Scalar, ...]:
        """All of its numbers."""

    @property
    def plain(self) -> bool:
        """Whether all its numbers are floats."""

    @property
    def fineness(self) -> int:
        """In how many steps its turning points are told apart."""

    def at(self, x: Any, order: int) -> Any:
        """A derivative by the argument; order 0 is the value. The argument may be a number of the law's own."""

    def transformed(self, offset: Scalar, width: Scalar, scale: Scalar, base: Scalar) -> SmoothPart:
        """``base + scale * part((x - offset) / width)``; a negative width runs it backwards."""

    def text(self, x: str) -> str:
        """Its formula in ``x``: infix with ``+ - * / ^ ( ) sin cos pi``, numbers as Python writes them."""


class Wave(NamedTuple):
    """``amplitude * sin(rate pi x)``, or the cosine where ``even``."""

    amplitude: Scalar
    rate: Scalar
    even: bool = False


@dataclass(frozen=True)
class Piece:
    """``sum powers[i] z^i + sum of waves in z`` with ``z = x - origin``."""

    start: Scalar
    stop: Scalar
    powers: tuple[Scalar, ...] = ()
    waves: tuple[Wave, ...] = ()
    origin: Scalar = 0.0

    @property
    def numbers(self) -> tuple[Scalar, ...]:
        """All of its numbers."""
        waves = (number for wave in self.waves for number in wave[:2])
        return (self.start, self.stop, self.origin, *self.powers, *waves)

    @property
    def plain(self) -> bool:
        return plain(*self.numbers)

    @property
    def fineness(self) -> int:
        halves = max((largest(wave.rate * (self.stop - self.start)) for wave in self.waves), default=0.0)
        return 16 * (2 + len(self.powers) + int(halves))

    def at(self, x: Any, order: int) -> Any:
        z = x - self.origin
        total = zero(z)
        for i in range(len(self.powers) - 1, order - 1, -1):
            total = total * z + perm(i, order) * self.powers[i]
        for amplitude, rate, even in self.waves:
            quarter = (order + even) % 4  # sin, cos, -sin, -cos
            function = "cos" if quarter % 2 else "sin"
            size = amplitude * (rate * np.pi) ** order
            total = total + (-size if quarter > 1 else size) * call(function, np.pi * (rate * z))
        return total

    def transformed(self, offset: Scalar, width: Scalar, scale: Scalar, base: Scalar) -> Piece:
        turned = -1.0 if backward(width) else 1.0
        start, stop = (offset + width * end for end in (self.start, self.stop)[:: int(turned)])
        powers = [scale * c / width**i for i, c in enumerate(self.powers)] or [0.0]
        powers[0] = powers[0] + base
        waves = tuple(Wave(scale * a * (1.0 if even else turned), r / abs(width), even) for a, r, even in self.waves)
        return Piece(start, stop, tuple(powers), waves, offset + width * self.origin)

    def _from_start(self) -> Piece:
        """One that counts back from its end counted from its start, where its powers and waves stay as short."""
        back = self.origin - self.start
        halves = [wave.rate * back for wave in self.waves]
        whole = all(abs(half - round(half)) <= ROUND_OFF * max(1.0, abs(half)) for half in halves)
        if self.origin != self.stop or len(self.powers) > 2 or not self.waves or not whole:
            return self
        height, slope = (*self.powers, 0.0, 0.0)[:2]
        waves = tuple(
            Wave(-wave.amplitude if round(half) % 2 else wave.amplitude, *wave[1:])
            for wave, half in zip(self.waves, halves, strict=True)
        )
        return replace(self, powers=(height - slope * back, slope), waves=waves, origin=self.start)

    def text(self, x: str) -> str:
        return self._from_start()._text(x)

    def _text(self, x: str) -> str:
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
    offset: Scalar = 0.0
    width: Scalar = 1.0
    scale: Scalar = 1.0
    base: Scalar = 0.0
    given: tuple[Scalar, ...] = ()  # the values of the parameters that stand in it
    turned: bool = False  # it runs backwards: the width is negative

    @property
    def start(self) -> Scalar:
        return self.offset + self.width if self.turned else self.offset

    @property
    def stop(self) -> Scalar:
        return self.offset if self.turned else self.offset + self.width

    @property
    def numbers(self) -> tuple[Scalar, ...]:
        return (self.offset, self.width, self.scale, self.base, *self.given)

    @property
    def plain(self) -> bool:
        return plain(*self.numbers)

    @property
    def fineness(self) -> int:
        return 256

    def at(self, x: Any, order: int) -> Any:
        u: Any = (x - self.offset) / self.width
        if symbolic(u):
            value = self.function(Jet([u, 1.0, *[0.0] * max(0, order - 1)]).truncated(order)).d[order]
            return self.scale / self.width**order * value + (self.base if order == 0 else 0.0)
        like = np.asarray(value_of(u), dtype=float)
        start = Dual(like, u.slope) if isinstance(u, Dual) else like
        jet = Jet([start, np.ones_like(like), *[np.zeros_like(like)] * max(0, order - 1)])
        with np.errstate(all="ignore"):
            value = self.function(jet.truncated(order)).d[order]
        if self.plain:
            value = np.broadcast_to(np.asarray(value, dtype=float), like.shape)
        found = self.scale / self.width**order * value
        return found + self.base if order == 0 else found

    def transformed(self, offset: Scalar, width: Scalar, scale: Scalar, base: Scalar) -> Formula:
        return Formula(
            self.function,
            self.words,
            offset + width * self.offset,
            width * self.width,
            scale * self.scale,
            base + scale * self.base,
            self.given,
            self.turned != backward(width),
        )

    def text(self, x: str) -> str:
        inner = f"(({x} - {self.offset!r})/{self.width!r})" if (self.offset, self.width) != (0.0, 1.0) else x
        return f"{self.base!r} + {self.scale!r}*({self.words(inner)})"
