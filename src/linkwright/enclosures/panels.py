"""Panels: stretches of time over which functions are enclosed."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

ORDER = 7
"""The degree of the polynomials: chosen by measurement (benchmarks/proofs.py)."""
MARGIN = 1e-13
"""A panel overlaps its neighbours by this share of the run, as break times are known to round-off only."""


PRECISE = np.finfo(np.longdouble).nmant in (63, 112)
"""Whether long doubles have more digits here: 64 or 113 bits."""


@dataclass(frozen=True, eq=False)
class Panels:
    """Stretches ``start`` .. ``stop`` (s), (panels,) each, widened by ``margin`` (s) on both sides.

    On each, the time is ``mid + half * h`` with h in -1 .. 1. Functions are enclosed as polynomials of degree
    ``order`` in h. ``precise`` ones compute with NumPy's long doubles.
    """

    start: Array
    stop: Array
    margin: float = 0.0
    order: int = ORDER
    precise: bool = False

    @cached_property
    def mid(self) -> Array:
        """The middles (s)."""
        return 0.5 * (self.start + self.stop).astype(self.dtype)

    @property
    def dtype(self) -> type[np.floating[Any]]:
        """What is computed with."""
        return np.longdouble if self.precise else np.float64

    @cached_property
    def half(self) -> Array:
        """Half the widths (s), rounded up so that h in -1 .. 1 covers the widened panel."""
        reach = np.maximum(self.stop - self.mid, self.mid - self.start) + self.margin
        return np.asarray(reach * (1.0 + 1e-15) + 1e-16 * np.abs(self.mid))

    @cached_property
    def inner(self) -> Array:
        """The h up to which a panel is clear of its neighbours: less than 1 by twice the margin."""
        return np.asarray(np.maximum(1.0 - 2.0 * self.margin / self.half, 0.0))

    @property
    def count(self) -> int:
        """The number of panels."""
        return len(self.start)

    def select(self, which: NDArray[np.bool_] | NDArray[np.intp]) -> Panels:
        """Some of them."""
        return Panels(self.start[which], self.stop[which], self.margin, self.order, self.precise)

    def halves(self) -> Panels:
        """Each cut in two: all first halves, then all second halves."""
        middle = self.mid.astype(float)
        start, stop = np.concatenate([self.start, middle]), np.concatenate([middle, self.stop])
        return Panels(start, stop, self.margin, self.order, self.precise)
