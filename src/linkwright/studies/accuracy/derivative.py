"""The derivative of a figure by the deviations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Derivative:
    """A figure of a measure: its label, its place (s) if it has one, and its derivatives by the deviations below and
    above their nominal value, (deviations, 2); they differ in a ``tie`` only."""

    label: str
    time: float | None
    sides: Array
    tie: bool = False

    @classmethod
    def smooth(cls, slope: Array, time: float | None = None) -> Derivative:
        """Where both sides are the same."""
        return cls("", time, np.stack([slope, slope], axis=1))
