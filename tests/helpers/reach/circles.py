"""Where circles and lines meet, and whether angles lie in a range; points are complex numbers."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.complex128]
Flags = NDArray[np.bool_]
TURN = 2 * np.pi


def meetings(a: complex | Points, r: float, b: complex | Points, s: float) -> tuple[Points, Points]:
    """The two points at the distance ``r`` from ``a`` and ``s`` from ``b``, the first to the left of a-b; NaN where
    there is none."""
    gap = b - a
    square = np.square(gap.real) + np.square(gap.imag)
    with np.errstate(invalid="ignore", divide="ignore"):
        along = 0.5 + (r * r - s * s) / (2 * square)
        across = np.sqrt(r * r / square - along * along)
        middle, aside = a + gap * along, gap * (1j * across)
    return middle + aside, middle - aside


def on_line(foot: complex, way: complex, centre: Points, r: float) -> tuple[Points, Points]:
    """How far from ``foot`` along the unit vector ``way`` a line has the distance ``r`` from a centre; real, NaN where
    nowhere."""
    gap = (centre - foot) * np.conj(way)
    with np.errstate(invalid="ignore"):
        half = np.sqrt(r * r - gap.imag**2)
    return gap.real - half, gap.real + half


def left(a: Points, b: Points, c: Points) -> Flags:
    """Whether c lies to the left of a-b, as one looks from a to b."""
    ab, ac = b - a, c - a
    return np.asarray(ab.real * ac.imag - ab.imag * ac.real > 0)


def turned(arm: Points, span: tuple[float, float] | None) -> Flags:
    """Whether the direction of an arm lies in a range of angles (rad); ``None`` is a whole turn. False where NaN."""
    if span is None:
        return np.isfinite(arm.real)
    low, high = span
    with np.errstate(invalid="ignore"):
        return np.mod(np.angle(arm) - low, TURN) <= high - low


def within(value: NDArray[np.float64], span: tuple[float, float]) -> Flags:
    """Whether a length lies in a range. False where NaN."""
    return (value >= span[0]) & (value <= span[1])
