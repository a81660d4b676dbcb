"""What measures give."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from linkwright.expressions.units import Dimension
from linkwright.measures.grades import SAMPLED, Grade
from linkwright.model.mechanism import Measure


@dataclass(frozen=True)
class Found:
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
class MeasureResult:
    """A measure's numbers; ``unit`` is the one it is shown in, ``size`` that unit in SI."""

    name: str
    measure: Measure
    dimension: Dimension
    unit: str
    size: float
    found: tuple[Found, ...]
    requirement: str | None = None
    verdict: bool | None = None

    def shown(self, label: str = "") -> float:
        """A number in the measure's unit. Raises KeyError where the measure has none of that label."""
        values = {f.label: f.value for f in self.found}
        return values[label] / self.size


class Unmeasured(Exception):
    """A measure has no value: the code of the finding that says why, and the time (s) where that shows."""

    def __init__(self, code: str, time: float | None = None) -> None:
        super().__init__(code)
        self.code, self.time = code, time
