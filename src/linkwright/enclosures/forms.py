"""Linear forms over boxes: numbers that depend on a place (u, v) of the square from -1 to 1, enclosed by a plane.

A form says value + u slope_u + v slope_v with an error of no more than ``rest``. Sums and products keep the linear
part, so that what depends on itself isn't counted twice (affine arithmetic: Stolfi and de Figueiredo, Self-Validated
Numerical Methods, 1997, ch. 3; here with two noise symbols that are kept, and one bound of all else). Roots and
reciprocals are replaced by the line of minimum error over the range. What has no bound has an infinite ``rest``. Each
operation makes a few roundings of numbers no larger than its operands' ``magnitude_bound`` makes possible.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

UNIT = 2.0**-52
"""Twice the rounding of one operation."""
FEW = 16 * UNIT
TINY = 1e-290


class AffineForm:
    """value + u slope_u + v slope_v, off by no more than rest: arrays of one shape, or numbers."""

    def __init__(self, value: Any, u: Any = 0.0, v: Any = 0.0, rest: Any = 0.0) -> None:
        self.value, self.u, self.v, self.rest = value, u, v, rest

    @property
    def constant(self) -> bool:
        """Whether it is the same everywhere."""
        return isinstance(self.u, float)

    @cached_property
    def lean(self) -> Any:
        """How far the linear part takes it from its value."""
        return abs(self.u) + abs(self.v)

    @cached_property
    def magnitude_bound(self) -> Any:
        """A bound of its linear part."""
        return abs(self.value) + self.lean

    @cached_property
    def bounds(self) -> tuple[Any, Any]:
        """Between which numbers it lies: infinite ones where it has no bound."""
        away = (self.lean + self.rest) * (1 + FEW) + FEW * abs(self.value)
        with np.errstate(invalid="ignore"):
            low, high = self.value - away, self.value + away
        return np.where(np.isnan(low), -np.inf, low), np.where(np.isnan(high), np.inf, high)

    def parts(self, count: int) -> Array:
        """Its numbers, value, slopes and rest, for ``count`` forms: (4, count)."""
        return np.stack([np.broadcast_to(part, count) for part in (self.value, self.u, self.v, self.rest)]).astype(
            float
        )

    def select(self, which: Any) -> AffineForm:
        """Some of its forms, of which its value has one each."""
        return AffineForm(*self.parts(self.value.size)[:, which])

    def __neg__(self) -> AffineForm:
        return AffineForm(-self.value, -self.u, -self.v, self.rest)

    def __add__(self, other: AffineForm) -> AffineForm:
        rest = self.rest + other.rest + FEW * (self.magnitude_bound + other.magnitude_bound)
        return AffineForm(self.value + other.value, self.u + other.u, self.v + other.v, rest)

    def __sub__(self, other: AffineForm) -> AffineForm:
        rest = self.rest + other.rest + FEW * (self.magnitude_bound + other.magnitude_bound)
        return AffineForm(self.value - other.value, self.u - other.u, self.v - other.v, rest)

    def __mul__(self, other: AffineForm) -> AffineForm:
        a, b, size = self.value, other.value, self.magnitude_bound * other.magnitude_bound
        if self.constant or other.constant:
            one, many = (self, other) if self.constant else (other, self)
            rest = abs(one.value) * many.rest + FEW * size + TINY
            if np.any(one.rest):
                rest = rest + (many.magnitude_bound + many.rest) * one.rest
            return AffineForm(a * b, many.u * one.value, many.v * one.value, rest * (1 + FEW))
        rest = (
            self.lean * other.lean
            + self.magnitude_bound * other.rest
            + (other.magnitude_bound + other.rest) * self.rest
        )
        rest = rest * (1 + FEW) + (FEW * size + TINY)
        return AffineForm(a * b, a * other.u + b * self.u, a * other.v + b * self.v, rest)

    def square(self) -> AffineForm:
        """Its square."""
        if self.constant:
            return self * self
        # The linear part's square lies between 0 and that of its bound: half of that is the middle.
        half, twice = self.lean * self.lean / 2, 2 * self.value
        rest = half + (2 * self.magnitude_bound + self.rest) * self.rest
        rest = rest * (1 + FEW) + (FEW * self.magnitude_bound * self.magnitude_bound + TINY)
        return AffineForm(self.value * self.value + half, twice * self.u, twice * self.v, rest)

    def _along(self, slope: Any, middle: Any, off: Any) -> AffineForm:
        """The form ``slope`` times it + ``middle``, off by ``off`` besides."""
        value, u, v = slope * self.value + middle, slope * self.u, slope * self.v
        size = abs(slope) * self.magnitude_bound + abs(middle)
        return AffineForm(value, u, v, (abs(slope) * self.rest + off) * (1 + FEW) + (FEW * size + TINY))

    def sqrt(self) -> AffineForm:
        """The square root where it is real; what it says elsewhere means nothing."""
        low, high = (np.maximum(end, 0.0) for end in self.bounds)
        # The chord and the tangent along it: the root lies between, their middle is the best line.
        a, b = np.sqrt(low), np.sqrt(high)
        both = np.maximum(a + b, TINY)
        chord, tangent = a * b / both, both / 4
        return self._along(1.0 / both, (chord + tangent) / 2, (tangent - chord) / 2 + FEW * b)

    def inverse(self) -> AffineForm:
        """Its reciprocal; of a range that holds 0 without bound."""
        low, high = self.bounds
        good = (low > 0) | (high < 0)
        sign = np.where(low > 0, 1.0, -1.0)
        ends = np.where(good, [np.minimum(abs(low), abs(high)), np.maximum(abs(low), abs(high))], 1.0)
        a, b = ends
        chord, tangent = 1.0 / a + 1.0 / b, 2.0 / np.sqrt(a * b)
        slope, middle = np.where(good, -1.0 / (a * b), 0.0), np.where(good, sign * (chord + tangent) / 2, 0.0)
        return self._along(slope, middle, np.where(good, (chord - tangent) / 2 + FEW / a, np.inf))

    def __truediv__(self, other: AffineForm) -> AffineForm:
        return self * other.inverse()

    def magnitude(self) -> AffineForm:
        """Its magnitude."""
        low, high = self.bounds
        known, sign = (low >= 0) | (high <= 0), np.where(low >= 0, 1.0, -1.0)
        most = np.maximum(abs(low), abs(high)) / 2
        parts = ((sign * self.value, most), (sign * self.u, 0.0), (sign * self.v, 0.0), (self.rest, most * (1 + FEW)))
        return AffineForm(*(np.where(known, one, other) for one, other in parts))


def joined_forms(forms: list[AffineForm]) -> AffineForm:
    """Several arrays of forms as one."""
    return AffineForm(*np.concatenate([one.parts(one.value.size) for one in forms], axis=1))
