"""Panels: stretches of time over which functions are enclosed."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ORDER = 7
"""The degree of the polynomials: chosen by measurement (benchmarks/enclosures.py)."""
MARGIN = 1e-12
"""A panel overlaps its neighbours by this share of the run, as break times are known to round-off only."""


@dataclass(frozen=True, eq=False)
class Panels:
    """Stretches ``start`` .. ``stop`` (s), (panels,) each, widened by ``margin`` (s) on both sides.

    On each, the time is ``mid + half * h`` with h in -1 .. 1. Functions are enclosed as polynomials of degree
    ``order`` in h.
    """

    start: Array
    stop: Array
    margin: float = 0.0
    order: int = ORDER

    @cached_property
    def mid(self) -> Array:
        """The middles (s)."""
        return 0.5 * (self.start + self.stop)

    @cached_property
    def half(self) -> Array:
        """Half the widths (s), rounded up so that h in -1 .. 1 covers the widened panel."""
        reach = np.maximum(self.stop - self.mid, self.mid - self.start) + self.margin
        return reach * (1.0 + 1e-15) + 1e-16 * np.abs(self.mid)

    @cached_property
    def inner(self) -> Array:
        """The h up to which a panel is clear of its neighbours: less than 1 by twice the margin."""
        return np.maximum(1.0 - 2.0 * self.margin / self.half, 0.0)

    @property
    def count(self) -> int:
        """The number of panels."""
        return len(self.start)

    def some(self, which: NDArray[np.bool_] | NDArray[np.intp]) -> Panels:
        """Some of them."""
        return Panels(self.start[which], self.stop[which], self.margin, self.order)

    def halves(self) -> Panels:
        """Each cut in two: all first halves, then all second halves."""
        start, stop = np.concatenate([self.start, self.mid]), np.concatenate([self.mid, self.stop])
        return Panels(start, stop, self.margin, self.order)
