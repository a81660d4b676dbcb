"""What reductions give: numbers of one run, of many samples; why there is none."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.reductions.grades import SAMPLED, Grade

Array = NDArray[np.float64]


class Peak(NamedTuple):
    """An extreme: its value (SI; infinite where the expression is unbounded), its time (s), and the side, "before" or
    "after", from which it is approached where it isn't reached."""

    value: float
    time: float
    side: str


@dataclass(frozen=True)
class FoundFigure:
    """One number of a measure: its label ("" or min, max), value in SI, and the time (s) where it happens.

    Unbounded values are infinite. ``side`` ("before", "after") is from where a value is approached that isn't reached
    at its time. ``grade`` says how sure it is.
    """

    label: str
    value: float
    time: float | None
    side: str = ""
    grade: Grade = SAMPLED

    @property
    def unbounded(self) -> bool:
        """Whether the expression grows without bound there."""
        return bool(np.isinf(self.value))


@dataclass(frozen=True)
class Figures:
    """One figure of each sample, SI, and where it happens (s), NaN where there is none: (samples,) each."""

    values: Array
    times: Array

    @classmethod
    def anywhere(cls, values: Array) -> Figures:
        """Figures without a place."""
        return cls(values, np.full_like(values, np.nan))


class Unmeasured(Exception):
    """A measure has no value: the code of the finding that says why, and the time (s) where that shows."""

    def __init__(self, code: str, time: float | None = None) -> None:
        super().__init__(code)
        self.code, self.time = code, time
