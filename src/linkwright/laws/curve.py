"""Curves of pieces in sequence: values and derivatives, on jets too; how smooth their joins are; their extremes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.laws.numbers import backward, largest_of, plain, settled
from linkwright.laws.pieces import Piece, SmoothPart
from linkwright.laws.stacked import Stack
from linkwright.notation import Jet, Scalar
from linkwright.notation.duals import Dual, slope_of, value_of
from linkwright.notation.jets import call, symbolic

Array = NDArray[np.float64]

SMOOTH = 4
"""The highest derivative whose continuity is looked at: value 0, velocity 1, acceleration 2, jerk 3, its rate 4."""
ROUND_OFF = 1e-9
"""A jump smaller than this share of the derivative's natural size is round-off."""

SMALL = 1 << 13
"""Up to so many places of samples it is faster to let each pick its piece's numbers than to ask piece by piece."""
FEW = 16
"""Places of each piece at which the sizes of many samples are taken."""


class Extreme(NamedTuple):
    """A largest or smallest value, and where it is first reached."""

    value: float
    at: float


@dataclass(frozen=True)
class Join:
    """Where two pieces meet: the derivatives 0 to :data:`SMOOTH` right before and right after."""

    at: float
    before: tuple[float, ...]
    after: tuple[float, ...]
    sizes: tuple[float, ...]

    @cached_property
    def jumps(self) -> tuple[float, ...]:
        """By how much each derivative jumps, 0 where it doesn't."""
        return tuple(
            after - before if abs(after - before) > ROUND_OFF * size else 0.0
            for before, after, size in zip(self.before, self.after, self.sizes, strict=True)
        )

    @property
    def continuity(self) -> int:
        """The last derivative up to which nothing jumps; -1 where the value itself does."""
        return next((order - 1 for order, jump in enumerate(self.jumps) if jump), SMOOTH)


@dataclass(frozen=True)
class Curve:
    """Pieces that follow one another without gaps."""

    parts: tuple[SmoothPart, ...]

    @property
    def start(self) -> Scalar:
        return self.parts[0].start

    @property
    def stop(self) -> Scalar:
        return self.parts[-1].stop

    @cached_property
    def plain(self) -> bool:
        """Whether all its numbers are floats."""
        return all(part.plain for part in self.parts)

    @cached_property
    def symbolic(self) -> bool:
        """Whether some of its numbers are symbols."""
        return any(symbolic(number) for part in self.parts for number in part.numbers)

    @cached_property
    def _starts(self) -> Array:
        return np.array([part.start for part in self.parts[1:]])

    def at(self, x: Any, order: int = 0) -> Any:
        """A derivative by the argument, at places within the curve; at a join that of the piece behind it.

        Of numbers of samples or with slopes it comes out as such, in the shape of the places with these in front; at a
        symbol as an expression.
        """
        if symbolic(x):
            return switched(x, [(part.start, part.at(x, order)) for part in self.parts])
        if not self.plain:
            return self._spread(np.atleast_1d(x), order)
        x = np.asarray(x, dtype=float)
        which = np.searchsorted(self._starts, x, side="right")
        found = np.full(x.shape, np.nan)
        for i in np.unique(which):
            here = which == i
            found[here] = self.parts[i].at(x[here], order)
        return found

    def _spread(self, x: Array, order: int) -> Any:
        """The same where pieces begin elsewhere in each sample: each is asked at the columns that some sample needs."""
        which = np.zeros(x.shape, dtype=np.intp)
        for part in self.parts[1:]:
            which = which + (x >= value_of(part.start))
        if self._stack is not None and which.size <= SMALL:
            return self._stack.at(x, which, order)
        found = []
        for i, part in enumerate(self.parts):
            here = which == i
            some = here.any(axis=(*range(here.ndim - 1),))
            if some.any():
                found.append((some, here[..., some], part.at(x[..., some], order)))
        values = _merged([(some, here, value_of(part)) for some, here, part in found], which.shape)
        if not any(isinstance(part, Dual) for _, _, part in found):
            return values
        return Dual(values, _merged([(some, here, slope_of(part)) for some, here, part in found], which.shape))

    @cached_property
    def _stack(self) -> Stack | None:
        """Its pieces side by side, unless a formula or a dual is among them."""
        pieces = [part for part in self.parts if isinstance(part, Piece)]
        slopes = any(isinstance(number, Dual) for piece in pieces for number in piece.numbers)
        return None if slopes or len(pieces) < len(self.parts) else Stack(pieces)

    def transformed(self, offset: Scalar, width: Scalar, scale: Scalar = 1.0, base: Scalar = 0.0) -> Curve:
        """``base + scale * curve((x - offset) / width)``; a negative width runs it backwards."""
        parts = tuple(part.transformed(offset, width, scale, base) for part in self.parts)
        return Curve(parts[::-1] if backward(width) else parts)

    def pieces(self, x: str = "x") -> tuple[tuple[float, float, str], ...]:
        """Start, stop and formula of each piece."""
        return tuple((part.start, part.stop, part.text(x)) for part in self.parts)

    def end_derivatives(self) -> tuple[tuple[Scalar, ...], tuple[Scalar, ...]]:
        """The derivatives 0 to :data:`SMOOTH` at the start and at the end."""
        return rates(self.parts[0], self.start), rates(self.parts[-1], self.stop)

    @cached_property
    def sizes(self) -> tuple[Any, ...]:
        """The natural size of each derivative, against which jumps are judged; of samples up to the acceleration."""
        if not self.plain:
            return self._sizes()
        width, height = self.stop - self.start, self.extremes(0)
        span = max(abs(height[1].value - height[0].value), 1e-12 * max(abs(e.value) for e in height), 1e-300)
        found = [span]
        for order in range(1, SMOOTH + 1):
            largest = max(float(np.abs(part.at(_grid(part), order)).max()) for part in self.parts)
            found.append(max(largest, span / width**order))
        return tuple(found)

    def _sizes(self) -> tuple[Any, ...]:
        """The same of each sample (samples, 1), or of symbols, from few places."""
        width = value_of(self.stop - self.start)
        if self.symbolic:
            values, *others = ([*self._places(order)] for order in range(3))
            span = largest_of(values) + largest_of([-value for value in values])
            sizes = [span, *(largest_of([call("abs", value) for value in row]) for row in others)]
        else:
            rows = [self._looked(order, value_of) for order in range(3)]
            span = np.ptp(rows[0], axis=-1, keepdims=True)
            sizes = [span, *(np.abs(row).max(axis=-1, keepdims=True) for row in rows[1:])]
        return tuple(largest_of([size, span / width**k, 1e-300]) for k, size in enumerate(sizes))

    def _places(self, order: int) -> Iterator[Any]:
        """The expressions of a derivative at few places of each piece."""
        for part in self.parts:
            for share in np.linspace(0.0, 1.0, FEW + 1).tolist():
                yield part.at(part.start + (part.stop - part.start) * share, order)

    def jumps(self, step: Scalar, order: int, close: float) -> Any:
        """Of each sample, whether a step of a derivative is more than round-off; that of a dual must not begin."""
        wrong = call("abs", value_of(step)) > close * self.sizes[order]
        if isinstance(step, Dual):
            wrong = wrong | np.any(np.abs(step.slope) > close * np.abs(self._looked(order, slope_of)).max())
        return wrong

    def _looked(self, order: int, part_of: Any) -> Array:
        """The values or slopes of a derivative at few places of each piece: (..., places)."""
        share = np.linspace(0.0, 1.0, FEW + 1)
        found = []
        for part in self.parts:
            places = value_of(part.start) + value_of(part.stop - part.start) * share
            found.append(np.atleast_2d(part_of(part.at(places, order)) + 0.0 * places))
        shape = np.broadcast_shapes(*(each.shape for each in found))
        return np.concatenate([np.broadcast_to(each, shape) for each in found], axis=-1)

    def joins(self) -> Iterator[Join]:
        """The joins inside."""
        for before, after in pairwise(self.parts):
            yield Join(after.start, rates(before, before.stop), rates(after, after.start), self.sizes)

    def extremes(self, order: int) -> tuple[Extreme, Extreme]:
        """The smallest and the largest value of a derivative, root-found between the ends of the pieces."""
        places = [_candidates(part, order) for part in self.parts]
        values = np.concatenate([part.at(x, order) for part, x in zip(self.parts, places, strict=True)])
        at, low, high = np.concatenate(places), int(np.argmin(values)), int(np.argmax(values))
        return Extreme(float(values[low]), float(at[low])), Extreme(float(values[high]), float(at[high]))

    def __call__(self, x: Any) -> Any:
        """The value at plain numbers, or on a jet with its derivatives."""
        return composed(x, self.at) if isinstance(x, Jet) else self.at(x)


def composed(x: Jet, at: Any, order: int = 0) -> Jet:
    """A function of a jet from ``at(places, order)``, the function's derivatives; the jet's entries and what the
    function gives may be duals."""
    return x.chain(evaluate_chained(x.d[0], at, order), lambda low: composed(low, at, order + 1))


def evaluate_chained(x: Any, at: Any, order: int) -> Any:
    """``at(places, order)`` where the places may be duals, enclosures or a symbol."""
    if hasattr(x, "along") or symbolic(x):
        return at(x, order)
    places = np.asarray(value_of(x), dtype=float)
    value: Any = at(places, order)
    if isinstance(x, Dual):
        value = Dual(value_of(value), slope_of(value) + value_of(at(places, order + 1)) * x.slope)
    return value


def switched(x: Any, pieces: Sequence[tuple[Any, Any]]) -> Any:
    """The expression of pieces, each from its start on, at a symbol."""
    found = pieces[0][1]
    for start, value in pieces[1:]:
        found = call("where", x >= start, value, found)
    return found


def rates(part: SmoothPart, x: Scalar, highest: int = SMOOTH) -> tuple[Scalar, ...]:
    """The derivatives 0 to ``highest`` of a piece at one place."""
    at = np.asarray(x) if plain(x) else x
    return tuple(settled(part.at(at, order)) for order in range(highest + 1))


def _merged(found: list[tuple[Any, Any, Any]], shape: tuple[int, ...]) -> Array:
    """Columns of several pieces put together."""
    lead = np.broadcast_shapes(shape[:-1], *(np.shape(part)[:-1] for _, _, part in found))
    merged = np.full((*lead, shape[-1]), np.nan)
    for some, here, part in found:
        merged[..., some] = np.where(here, part, merged[..., some])
    return merged


def _grid(part: SmoothPart) -> Array:
    return np.linspace(part.start, part.stop, part.fineness + 1)


def _candidates(part: SmoothPart, order: int) -> Array:
    """Where a derivative of a piece may be largest or smallest: its ends, and the zeros of the next derivative."""
    grid = _grid(part)
    slope = part.at(grid, order + 1)
    sign = np.signbit(slope)
    low, high = grid[:-1][sign[1:] != sign[:-1]], grid[1:][sign[1:] != sign[:-1]]
    falls = np.signbit(part.at(low, order + 1))
    for _ in range(60):  # bisection, all at once, down to neighbouring floats
        middle = (low + high) / 2
        left = np.signbit(part.at(middle, order + 1)) == falls
        low, high = np.where(left, middle, low), np.where(left, high, middle)
    return np.concatenate([grid[[0, -1]], low])
