"""Mechanisms on which regions were wrong, with what each mode truly reaches.

The areas (mm2) and their errors are those of ``raster(mechanism, first=4096)``, parts and holes those of
``raster(mechanism)``. What was wrong: an area (area); not a number among the results (nan); a second part that isn't
one (parts).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from helpers.reach.mechanisms import FiveBar


@dataclass(frozen=True)
class Known:
    """A mechanism and for its modes, left and right: areas (mm2), the error of these, parts and holes."""

    name: str
    mechanism: FiveBar
    areas: tuple[float, float]
    error: float
    parts: tuple[int, int]
    holes: tuple[int, int]


def bar(*lengths: float, motor: tuple[float, float] | None = None, servo: tuple[float, float] | None = None) -> FiveBar:
    """Lengths l1 .. l5 and r (mm), the angle of P and ranges in degrees."""
    spans = [None if span is None else (math.radians(span[0]), math.radians(span[1])) for span in (motor, servo)]
    return FiveBar(*lengths[:6], math.radians(lengths[6]), *spans)


KNOWN = (
    Known("area 1", bar(6.58, 6.71, 39.97, 27.83, 13.21, 18.05, -170.7), (225.395, 273.095), 0.014, (1, 1), (0, 0)),
    Known("area 4", bar(35.53, 5.65, 29.76, 5.04, 22.62, 18.1, 106.8), (332.302, 338.039), 0.003, (2, 2), (1, 1)),
    Known("area 9", bar(31.52, 15.67, 38.51, 32.49, 34.24, 5.91, 92.8), (1434.382, 1442.720), 0.012, (1, 1), (3, 3)),
    Known("area 14", bar(19.18, 7.57, 35.03, 34.01, 9.89, 20.81, 87.1), (2728.410, 2764.652), 0.025, (2, 2), (2, 2)),
    Known("nan 19", bar(32.11, 32.69, 31.57, 25.89, 37.12, 25.69, -0.1), (5752.698, 5745.372), 0.015, (1, 1), (1, 1)),
    Known("nan 22", bar(22.3, 6.77, 6.5, 23.55, 21.7, 29.99, 172.8), (3153.991, 3144.103), 0.025, (1, 1), (3, 3)),
    Known(
        "parts 10",
        bar(16.08, 35.83, 24.4, 28.71, 22.73, 19.01, 17.6, motor=(14, 282), servo=(123, 408)),
        (2178.938, 3019.692),
        0.017,
        (1, 1),
        (0, 1),
    ),
)
