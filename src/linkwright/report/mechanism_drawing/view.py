"""From the world to the picture."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, log10

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.report.mechanism_drawing.survey import Survey

Array = NDArray[np.float64]

LEFT, TOP, BOTTOM, LEAST = 46.0, 40.0, 58.0, 200.0
"""Room around the mechanism, and the least height of a picture, in pixels."""


@dataclass(frozen=True)
class View:
    """A scale of ``k`` pixels a length unit, the world's origin in the picture, and the picture's size in pixels."""

    k: float
    origin: tuple[float, float]
    width: float
    height: float

    def to_picture(self, places: Sequence[Sequence[float]] | Array) -> Array:
        """Where places lie in the picture."""
        return np.array(places, float) * [self.k, -self.k] + self.origin

    @property
    def step(self) -> float:
        """A round length of about a hundred pixels: largest of 1, 2, 5 times a power of ten that isn't above it."""
        wanted = 110 / self.k
        power = 10.0 ** floor(log10(wanted) + 1e-9)
        return next((m * power for m in (5, 2) if m * power <= wanted * (1 + 1e-9)), power)


def fit(survey: Survey, width: float, most: float) -> View:
    """The view that fits all the motion in a picture ``width`` wide and at most ``most`` high."""
    x0, y0, x1, y1 = survey.box
    least = 1e-3 * (max(x1 - x0, y1 - y0) or 1.0)
    wide, high = max(x1 - x0, least), max(y1 - y0, least)
    k = min((width - 2 * LEFT) / wide, (most - TOP - BOTTOM) / high)
    height = float(round(max(k * high + TOP + BOTTOM, LEAST)))
    origin = (width / 2 - k * (x0 + x1) / 2, (TOP + height - BOTTOM) / 2 + k * (y0 + y1) / 2)
    return View(k, origin, width, height)
