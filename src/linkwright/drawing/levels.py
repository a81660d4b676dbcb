"""Levels of a map over a plane, and the colours of the bands between them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import ticks

Array = NDArray[np.float64]

COLOURS = np.array(
    [[68, 1, 84], [65, 68, 135], [42, 120, 142], [34, 168, 132], [122, 209, 81], [253, 231, 37]], dtype=float
)
"""From least to greatest: viridis, which is told apart in grey and by the colour-blind."""
MOST_LEVELS = 10
EVEN = 8.0
"""A map whose values are all within this factor has even levels."""


def levels_of(values: Array) -> list[float]:
    """Round values between which a map's lie, but for the outermost hundredths."""
    known = values[np.isfinite(values)]
    if not known.size:
        return []
    low, high = np.percentile(known, [1, 99])
    if not high - low > 1e-9 * max(abs(low), abs(high)):
        return []
    if low <= 0 or high / low < EVEN:
        return [level for level in ticks(float(low), float(high), 7) if low < level < high]
    decades = 10.0 ** np.arange(np.floor(np.log10(low)), np.ceil(np.log10(high)) + 1)
    for steps in ((1, 2, 5), (1, 3), (1,)):
        found = sorted(float(f"{step * decade:.3g}") for step in steps for decade in decades)
        found = [level for level in found if low < level < high]
        if len(found) <= MOST_LEVELS:
            return found
    return found[:: -(-len(found) // MOST_LEVELS)]


def band_colours(count: int) -> NDArray[np.uint8]:
    """The colours of so many bands (count, 3), red, green, blue."""
    at = np.linspace(0, len(COLOURS) - 1, count) if count > 1 else np.array([len(COLOURS) / 2])
    rows = [np.interp(at, np.arange(len(COLOURS)), row) for row in COLOURS.T]
    return np.stack(rows, axis=1).round().astype(np.uint8)


def band_stops(count: int) -> list[str]:
    """The same as ``#rrggbb``."""
    return [f"#{r:02x}{g:02x}{b:02x}" for r, g, b in band_colours(count).tolist()]
