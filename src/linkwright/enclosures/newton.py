"""Solutions of two or three equations over cells: where there is one near a place, and that it is the only one there.

The unknowns z, 0 near a solution in the middle of a cell, follow a line L over the cell but for w. With the equations
F, their slopes J, and Y the inverse of J in the middle, w = -Y F(L) - (Y J(L + w) - 1) w. If that maps a box of w into
its inside there is one solution in the box, for each place of the cell, and it lies in the image (Krawczyk's operator:
Moore, Kearfott, Cloud, Introduction to Interval Analysis, 2009, ch. 8.2).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures.forms import FEW, TINY, AffineForm

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

WIDER = 2.0
"""The box is so many times wider than what the line leaves."""

Equations = Callable[[list[AffineForm]], list[AffineForm]]
"""The equations and, row by row, their slopes by the unknowns, where these are forms (n,)."""


def solved(equations: Equations, unknowns: int, count: int) -> tuple[list[AffineForm], Mask]:
    """The unknowns, forms (n,), of ``count`` systems; where that is proven, (n,)."""
    found = equations([AffineForm(np.zeros(count))] * unknowns)
    inverse = inverted(_Rows(found[unknowns:], count).value.reshape(unknowns, unknowns, -1))
    with np.errstate(all="ignore"):
        line = _Rows(found[:unknowns], count).times(inverse)
        away = [AffineForm(-line.value[k], -line.u[k], -line.v[k]) for k in range(unknowns)]
        left = _Rows(equations(away)[:unknowns], count).times(inverse)
        box = WIDER * left.magnitude_bound
        found = equations([AffineForm(one.value, one.u, one.v, more) for one, more in zip(away, box, strict=True)])
        spread = np.stack(
            [_Rows(found[unknowns + k :: unknowns], count).times(inverse).away(k) for k in range(unknowns)]
        )
        more = (spread * box[:, None]).sum(axis=0) * (1 + FEW)
        image = left.magnitude_bound + more
        proven = (image < box).all(axis=0)
        more = (spread * image[:, None]).sum(axis=0) * (1 + FEW)
    rest = left.rest + more
    return [one - AffineForm(left.value[k], left.u[k], left.v[k], rest[k]) for k, one in enumerate(away)], proven


class _Rows:
    """Forms as arrays (rows, n)."""

    def __init__(self, forms: Sequence[AffineForm], count: int) -> None:
        self.value, self.u, self.v, self.rest = np.stack([one.parts(count) for one in forms], axis=1)

    @property
    def magnitude_bound(self) -> Array:
        """Bounds of their sizes."""
        return np.asarray((np.abs(self.value) + np.abs(self.u) + np.abs(self.v) + self.rest) * (1 + FEW) + TINY)

    def times(self, matrix: Array) -> _Rows:
        """Mixed by matrices (3, 3, n)."""
        found = _Rows.__new__(_Rows)
        found.value, found.u, found.v = ((matrix * part).sum(axis=1) for part in (self.value, self.u, self.v))
        found.rest = (np.abs(matrix) * (self.rest + FEW * self.magnitude_bound)).sum(axis=1) * (1 + FEW)
        return found

    def away(self, column: int) -> Array:
        """By how much at most a column of matrices differs from that of the unit matrix."""
        self.value[column] -= 1.0
        return self.magnitude_bound


def inverted(rows: Array) -> Array:
    """The inverses of matrices, (2, 2, n) or (3, 3, n)."""
    with np.errstate(all="ignore"):
        if len(rows) == 2:
            (a, b), (c, d) = rows
            return np.asarray(np.array([[d, -b], [-c, a]]) / (a * d - b * c))
        a, b, c = rows
        columns = [_across(one, other) for one, other in ((b, c), (c, a), (a, b))]
        return np.asarray(np.stack(columns, axis=1) / (a * columns[0]).sum(axis=0))


def _across(one: Array, other: Array) -> Array:
    """The cross products of vectors (3, n); NumPy's own spends most of its time on axes."""
    (a, b, c), (d, e, f) = one, other
    return np.stack([b * f - c * e, c * d - a * f, a * e - b * d])
