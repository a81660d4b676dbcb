"""ISO 2768-1:1989, General tolerances, part 1: tables 1 (linear sizes) and 3 (angles).

Table 2 (external radii and chamfer heights) isn't here: a dimension of a mechanism is neither.
"""

from __future__ import annotations

import math
import re
from typing import Self

from linkwright.tolerances.classes import Limits, NoTolerance, ToleranceClass, register

CLASSES = "fmcv"
"""Fine, medium, coarse, very coarse."""

SMALLEST = 0.5
"""mm; below it a tolerance stands beside the size in the drawing (note to table 1)."""

# Up to and including (mm): the tolerance, plus and minus (mm), of f, m, c, v.
_LINEAR: dict[float, tuple[float | None, ...]] = {
    3: (0.05, 0.1, 0.2, None),
    6: (0.05, 0.1, 0.3, 0.5),
    30: (0.1, 0.2, 0.5, 1),
    120: (0.15, 0.3, 0.8, 1.5),
    400: (0.2, 0.5, 1.2, 2.5),
    1000: (0.3, 0.8, 2, 4),
    2000: (0.5, 1.2, 3, 6),
    4000: (None, 2, 4, 8),
}

# Length of the shorter side up to and including (mm): the tolerance, plus and minus (minutes), of f, m, c, v.
_ANGULAR: dict[float, tuple[int, ...]] = {
    10: (60, 60, 90, 180),
    50: (30, 30, 60, 120),
    120: (20, 20, 30, 60),
    400: (10, 10, 15, 30),
    math.inf: (5, 5, 10, 20),
}

# The second letter of "mK" is that of ISO 2768-2, which is withdrawn and says nothing of sizes.
_TEXT = re.compile(r"\s*ISO\s*2768(?:-1)?\s*-\s*([fmcv])[HKL]?\s*")


@register
class General(ToleranceClass):
    """A general tolerance: ``ISO 2768-m``."""

    standard = "ISO 2768-1"
    examples = tuple(f"ISO 2768-{letter}" for letter in CLASSES)

    def __init__(self, letter: str) -> None:
        self.text, self.column = f"ISO 2768-{letter}", CLASSES.index(letter)

    @classmethod
    def read(cls, text: str) -> Self | None:
        match = _TEXT.fullmatch(text)
        return cls(match[1]) if match else None

    def limits(self, size: float) -> Limits:
        mm = round(size * 1e3, 9)
        for end, row in _LINEAR.items():
            if SMALLEST <= mm <= end and (tolerance := row[self.column]) is not None:
                return -tolerance * 1e-3, tolerance * 1e-3
            if mm <= end:
                break
        ends = [SMALLEST, *_LINEAR]
        kept = [i for i, row in enumerate(_LINEAR.values()) if row[self.column] is not None]
        raise NoTolerance("size", low=ends[kept[0]] * 1e-3, high=ends[kept[-1] + 1] * 1e-3)

    def angular(self, side: float) -> Limits:
        mm = round(side * 1e3, 9)
        row = next(row for end, row in _ANGULAR.items() if mm <= end)
        tolerance = math.radians(row[self.column] / 60)
        return -tolerance, tolerance
