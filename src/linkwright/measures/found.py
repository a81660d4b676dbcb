"""What measures give."""

from __future__ import annotations

from linkwright.data_classes import dataclass
from linkwright.expressions.units import Dimension
from linkwright.reductions import FoundFigure, Measure


@dataclass(frozen=True)
class MeasureResult:
    """A measure's numbers; ``unit`` is the one it is shown in, ``size`` that unit in SI."""

    name: str
    measure: Measure
    dimension: Dimension
    unit: str
    size: float
    found: tuple[FoundFigure, ...]
    requirement: str | None = None
    verdict: bool | None = None

    def shown(self, label: str = "") -> float:
        """A number in the measure's unit. Raises KeyError where the measure has none of that label."""
        values = {f.label: f.value for f in self.found}
        return values[label] / self.size
