"""The convex hull of points of the plane."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.complex128]


def hull(points: Points) -> Points:
    """The corners of the convex hull, counter-clockwise (Andrew's monotone chain)."""
    ordered = np.unique(points)  # by x, then by y
    sides: list[complex] = []
    for row in (ordered.tolist(), ordered[::-1].tolist()):
        side: list[complex] = []
        for p in row:
            while len(side) > 1 and ((side[-1] - side[-2]).conjugate() * (p - side[-2])).imag <= 0:
                side.pop()
            side.append(p)
        sides += side[:-1]
    return np.array(sides or ordered)
