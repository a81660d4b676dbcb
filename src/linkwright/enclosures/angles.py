"""The zeros of trigonometric polynomials over cells: stretches of angles that hold all of them, and how many at most.

The coefficients are linear forms over a cell (:mod:`linkwright.enclosures.forms`). Stretches in which Taylor's formula
leaves no zero are dropped. Of the rest, those over which the first derivative keeps its sign have one zero at most, and
the signs at their ends tell; those over which the second does have two or none, as the extremum between tells. What is
neither is cut on (interval Newton's method and its tests: Moore, Kearfott, Cloud, Introduction to Interval Analysis,
2009, ch. 8).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import factorial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.enclosures.forms import FEW, UNIT, AffineForm, joined_forms
from linkwright.notation.harmonics import ORDERS, WEIGHTS, basis

Array = NDArray[np.float64]
Rows = NDArray[np.intp]
Mask = NDArray[np.bool_]

PANELS, LEVELS, MOST = 32, 9, 64
"""A turn is cut into panels, these are halved where they are undecided; no stretch is cut into more at a time."""
TERMS = 4
"""Terms of Taylor's formula before what bounds the rest."""
HUGE = 1e200
"""Coefficients without bound count as this, so that no sum of them is without value."""
STEPS = 6
"""Steps of Newton's method, at the cell's middle."""
Local = Callable[[Rows, Array], list[AffineForm]]
"""Some polynomials (n,) at angles (n,): their values and first derivatives."""


@dataclass(frozen=True)
class Stretches:
    """Stretches of angles, of the polynomials ``of`` (n,), from ``low`` to ``high`` (rad), that hold all their zeros:
    no more than ``most`` each, where that is known (else 0), and within ``half`` of ``middle``. ``room`` is negative
    where there is none, positive where there is one in any case."""

    of: Rows
    low: Array
    high: Array
    most: Rows
    middle: Array
    half: Array
    room: AffineForm

    def select(self, which: Rows | Mask) -> Stretches:
        """Some of them."""
        of, low, high, most, middle, half = (part[which] for part in self._arrays)
        return Stretches(of, low, high, most, middle, half, self.room.select(which))

    @property
    def _arrays(self) -> tuple[Any, ...]:
        return self.of, self.low, self.high, self.most, self.middle, self.half

    @staticmethod
    def concatenated(parts: Sequence[Stretches]) -> Stretches:
        """Several sets of them as one."""
        arrays = zip(*(one._arrays for one in parts), strict=True)
        of, low, high, most, middle, half = (np.concatenate(row) for row in arrays)
        return Stretches(of, low, high, most, middle, half, joined_forms([one.room for one in parts]))


def stretches(polynomials: Polynomials) -> Stretches:
    """Stretches that hold all zeros of polynomials."""
    with np.errstate(all="ignore"):
        of, low, high = polynomials.stretches()
        parts: list[Stretches] = []
        hopeful = np.ones(of.size, dtype=bool)
        for level in range(1, LEVELS + 2):
            counts = _ZeroCounts(polynomials, of, low, high)
            vague = counts.vague & hopeful
            parts += [counts.single(), counts.double(), counts.undecided(counts.vague & ~vague)]
            if not vague.any():
                break
            width = 2 * np.pi / PANELS * 2.0 ** (1 - level)
            of, low, high, hopeful = polynomials.subdivided(of[vague], low[vague], high[vague], width, level < LEVELS)
    return Stretches.concatenated(parts)


def numbered(count: Rows) -> Rows:
    """0, 1, 2, ... as often as each count says, one after the other."""
    return np.asarray(np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count))


class Polynomials:
    """Polynomials of which forms, arrays (n,), are known: their ``values`` at the equally spaced angles of
    :mod:`linkwright.notation.harmonics`, and what they are at any (``local``). Both are used, as a polynomial is often
    small where it is looked at."""

    def __init__(self, values: list[AffineForm], local: Local) -> None:
        self._local = local
        rows = [np.broadcast_arrays(one.value, one.u, one.v, one.rest, one.magnitude_bound) for one in values]
        value, u, v, rest, reach = (np.stack(row).astype(float) for row in zip(*rows, strict=True))
        rest = np.where(np.isfinite(rest), rest, HUGE)
        self.value, self.u, self.v = WEIGHTS @ value, WEIGHTS @ u, WEIGHTS @ v
        self.rest = np.abs(WEIGHTS) @ (rest + FEW * reach)
        size = np.abs(self.value) + np.abs(self.u) + np.abs(self.v) + self.rest
        size = np.where(np.isfinite(size).all(axis=0), size, HUGE)  # what has no bound tells nothing
        self.most = [size[0] * (k == 0) + ORDERS[1:] ** k @ size[1:] for k in range(TERMS + 1)]

    def middle(self, of: Rows, phi: Array, derivative: int = 0) -> Array:
        """Their values at angles (n,) in the middle of the cell, or those of a derivative."""
        return np.asarray((basis(phi, derivative) * self.value[:, of]).sum(axis=0))

    def about(self, of: Rows, phi: Array) -> _About:
        """All about angles (n,)."""
        found = self._local(of, phi)
        for k in range(len(found), TERMS):
            row = basis(phi, k)
            value, u, v = ((row * part[:, of]).sum(axis=0) for part in (self.value, self.u, self.v))
            found.append(AffineForm(value, u, v, (np.abs(row) * self.rest[:, of]).sum(axis=0) + FEW * self.most[k][of]))
        return _About(found, self.most[TERMS][of])

    def stretches(self) -> tuple[Rows, Array, Array]:
        """Stretches that hold all zeros: the polynomial of each, its ends; beyond these the signs are sure."""
        half = np.pi / PANELS
        away = self.most[TERMS][:, None] * half**TERMS / factorial(TERMS)
        for k in reversed(range(TERMS)):
            row = basis(_MIDDLES, k)
            size, u, v = (np.abs(part.T @ row) for part in (self.value, self.u, self.v))
            rest = u + v + self.rest.T @ np.abs(row) + FEW * self.most[k][:, None]
            away = away + (size * (k > 0) + rest) * half**k / factorial(k)
        free = size > away * (1 + FEW)
        # Begun at a panel without zero; where there is none the whole turn is a stretch.
        first = free.argmax(axis=1)
        turned = np.take_along_axis(free, (first[:, None] + np.arange(PANELS)) % PANELS, axis=1)
        begun = _MIDDLES[first] - half
        edges = np.diff(np.pad(~turned, ((0, 0), (1, 1))).astype(np.int8), axis=1)
        (of, start), stop = np.nonzero(edges == 1), np.nonzero(edges == -1)[1]
        return of, begun[of] + 2 * half * start, begun[of] + 2 * half * stop

    def subdivided(
        self, of: Rows, low: Array, high: Array, width: float, more: bool
    ) -> tuple[Rows, Array, Array, NDArray[np.bool_]]:
        """What is left of stretches when they are cut into parts of some width; and whether cutting them once ``more``
        can help: in some part the angle leaves more open than the cell does."""
        count = np.clip(np.ceil((high - low) / width), 1, MOST).astype(int)
        half = (high - low) / (2 * count)
        row = np.repeat(np.arange(of.size), count)
        part = numbered(count)
        about = self.about(of[row], low[row] + half[row] * (2 * part + 1))
        down, up = about.over(0, half[row])
        free = (down > 0) | (up < 0)
        hopeful = ~free & (up - down > 4 * about.rest[0]) & more
        new = row[1:] != row[:-1]
        start = np.flatnonzero(~free & np.append(True, free[:-1] | new))
        stop = np.flatnonzero(~free & np.append(free[1:] | new, True))
        hope = np.logical_or.reduceat(hopeful, start) if start.size else hopeful[:0]
        row = row[start]
        return of[row], low[row] + 2 * half[row] * part[start], low[row] + 2 * half[row] * (part[stop] + 1), hope


_MIDDLES = (2 * np.arange(PANELS) + 1) * np.pi / PANELS - np.pi


class _About:
    """Polynomials about angles: their derivatives there from the 0th on, and what bounds the next anywhere."""

    def __init__(self, derivatives: list[AffineForm], most: Array) -> None:
        self.derivatives, self.most = derivatives, most
        self.rest = [one.lean + one.rest for one in derivatives]
        self.size = [one.magnitude_bound + one.rest for one in derivatives]

    def over(self, order: int, half: Array) -> tuple[Array, Array]:
        """Bounds of a derivative up to ``half`` to both sides."""
        away = self.rest[order] + self.most * half ** (TERMS - order) / factorial(TERMS - order)
        for k in range(order + 1, TERMS):
            away = away + self.size[k] * half ** (k - order) / factorial(k - order)
        value, away = self.derivatives[order].value, away * (1 + FEW)
        return value - away, value + away


class _ZeroCounts:
    """What the signs of the derivatives tell of the zeros in stretches."""

    def __init__(self, polynomials: Polynomials, of: Rows, low: Array, high: Array) -> None:
        self.polynomials, self.of, self.low, self.high = polynomials, of, low, high
        about, half = polynomials.about(of, (low + high) / 2), (high - low) / 2
        (down, up), self.bend = about.over(1, half), about.over(2, half)
        ends = [np.sign(polynomials.middle(of, end)) for end in (low, high)]
        known, same = high - low < 2 * np.pi - 1e-9, ends[0] == ends[1]  # of a whole turn the ends aren't known
        self.sign = np.where(self.bend[0] > 0, 1.0, -1.0)
        monotone = known & ((down > 0) | (up < 0))
        bent = known & same & ~monotone & ((self.bend[0] > 0) | (self.bend[1] < 0))
        extremum = polynomials.middle(of, low, 1) * polynomials.middle(of, high, 1) <= 0
        bent &= extremum | (ends[0] != self.sign)
        self._one = monotone & ~same
        self._two = bent & (ends[0] == self.sign)
        self.vague = ~monotone & ~bent

    def _stretches(self, which: Rows, most: int, middle: Array, half: Array, room: AffineForm) -> Stretches:
        of, low, high = self.of[which], self.low[which], self.high[which]
        return Stretches(of, low, high, np.full(which.size, most), middle, half, room)

    def _middle_and_half(self, which: Rows) -> tuple[Array, Array]:
        return (self.low + self.high)[which] / 2, (self.high - self.low)[which] / 2

    def single(self) -> Stretches:
        """Stretches with one zero."""
        which = np.flatnonzero(self._one)
        return self._stretches(which, 1, *self._middle_and_half(which), AffineForm(np.ones(which.size)))

    def double(self) -> Stretches:
        """Stretches with one extremum, that may lie beyond zero."""
        which = np.flatnonzero(self._two)
        of, low, high, sign = self.of[which], self.low[which], self.high[which], self.sign[which]
        phi = (low + high) / 2
        for _ in range(STEPS):
            step = self.polynomials.middle(of, phi, 1) / self.polynomials.middle(of, phi, 2)
            phi = np.clip(phi - np.nan_to_num(step), low, high)
        here, slope = self.polynomials.about(of, phi).derivatives[:2]
        bend = np.min(np.abs([one[which] for one in self.bend]), axis=0)
        steep = (slope.magnitude_bound + slope.rest) * (1 + FEW)
        # The extremum lies beyond the value here by no more than this.
        beyond = steep**2 / (2 * bend) * (1 + FEW)
        room = here * AffineForm(-sign) + AffineForm(beyond / 2, rest=beyond / 2 * (1 + FEW))
        top = room.bounds[1]
        # The parabola of the least bend lies within the polynomial.
        far = (steep + np.sqrt(steep**2 + 2 * bend * np.maximum(top, 0.0))) / bend * (1 + FEW)
        half = np.minimum(far, np.maximum(high - phi, phi - low))
        some = top >= 0
        return self._stretches(which[some], 2, phi[some], half[some], room.select(some))

    def undecided(self, vague: Mask) -> Stretches:
        """Stretches of which nothing is known."""
        which = np.flatnonzero(vague)
        unknown = AffineForm(np.zeros(which.size), rest=np.full(which.size, np.inf))
        return self._stretches(which, 0, *self._middle_and_half(which), unknown)


def cosine_and_sine(phi: Array, away: AffineForm) -> tuple[AffineForm, AffineForm]:
    """Cosine and sine of angles ``phi`` + ``away``, by Taylor's formula."""
    most = (away.magnitude_bound + away.rest) * (1 + FEW)
    wide, most = most > 1.0, np.minimum(most, 1.0)
    cosine = AffineForm(1.0) + away.square() * AffineForm(-0.5)
    cosine.rest = cosine.rest + most**4 / 24
    sine = AffineForm(away.value, away.u, away.v, away.rest + most**3 / 6)
    c, s = (AffineForm(part, rest=UNIT) for part in (np.cos(phi), np.sin(phi)))
    return _within(cosine * c - sine * s, wide), _within(cosine * s + sine * c, wide)


def _within(form: AffineForm, wide: Mask) -> AffineForm:
    """The form, or where that is ``wide`` all from -1 to 1."""
    value, u, v = (np.where(wide, 0.0, part) for part in (form.value, form.u, form.v))
    return AffineForm(value, u, v, np.where(wide, 1.0, form.rest))
