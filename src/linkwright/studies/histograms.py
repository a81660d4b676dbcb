"""Histograms of figures: of rows that are kept, or of counts between fine edges."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import widened

Array = NDArray[np.float64]
Counts = NDArray[np.int64]

FINE = 4096
"""The least number of bins where no rows are kept: quantiles are read off them."""
MARGIN = 0.5
"""How far these bins reach beyond the first samples' figures, in their width."""


def histogram(values: Array, bins: int) -> tuple[Array, Counts]:
    """Edges and counts of the finite ones of some values."""
    counts, edges = np.histogram(values[np.isfinite(values)], bins, finite_range(values))
    return edges, counts.astype(np.int64)


def finite_range(values: Array) -> tuple[float, float]:
    """The least and the largest of the finite ones of some values, apart where they are all the same."""
    known = values[np.isfinite(values)]
    return widened(float(known.min()), float(known.max())) if known.size else widened(0.0, 0.0)


def histogram_range(values: Array) -> tuple[float, float]:
    """The ends of a histogram of many samples, from the values of the first ones."""
    low, high = finite_range(values)
    return low - MARGIN * (high - low), high + MARGIN * (high - low)


def fine(low: float, high: float, bins: int) -> Array:
    """The edges of fine bins, a whole number of which makes each of so many ``bins``."""
    return np.linspace(low, high, bins * -(-FINE // bins) + 1)


def coarse(edges: Array, counts: Counts, bins: int) -> tuple[Array, Counts]:
    """So many bins of fine ones."""
    return edges[:: counts.size // bins], counts.reshape(bins, -1).sum(axis=1)
