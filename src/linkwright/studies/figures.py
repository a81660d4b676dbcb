"""The figures of a sweep's measures as rows of numbers, a column a sample."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.units import Dimension
from linkwright.findings import Said, Text
from linkwright.kernels import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.measures import BoundMeasure
from linkwright.results import Run
from linkwright.results.dataset import Variable, si_unit
from linkwright.studies.batch_plan import Measuring

Array = NDArray[np.float64]


@dataclass(frozen=True)
class FigureColumn:
    """One figure of each sample: of which measure, which of its figures ("", min, max), its unit with its SI value."""

    measure: str
    label: str
    dimension: Dimension
    unit: str
    size: float
    placed: Said | None = None
    """What is shown for a signal at a position."""

    @property
    def name(self) -> str:
        """How files call it."""
        return " ".join(filter(None, (self.measure, self.label)))

    @property
    def title(self) -> Text:
        """How it is called where it is shown."""
        if self.label:
            return Said("measure.figure", name=self.measure, label=Said(f"measure.{self.label}"))
        return self.placed or self.measure

    def variable(self, values: Array) -> Variable:
        """Its values (samples,) for a file."""
        unit = si_unit(self.dimension)
        return Variable(f"measure {self.name}", "sample", values, self.unit, self.size, unit, column=self.name)


def columns(compiled: Compiled, measure: BoundMeasure) -> list[FigureColumn]:
    """The figures of a measure."""
    text, size = measure.unit(compiled.quantities)
    return [FigureColumn(measure.name, label, measure.dimension, text, size) for label in measure.kind.labels]


class SampleFigures:
    """Measures of many samples of a run; the ``required`` ones have a requirement."""

    def __init__(self, run: Run, varied: Varied, measures: Sequence[BoundMeasure], kernel: str) -> None:
        self.run, self.varied, self.measures, self.kernel = run, varied, measures, kernel
        self.columns = [column for measure in measures for column in columns(run.compiled, measure)]
        self.required = [measure.name for measure in measures if measure.requirement is not None]

    @cached_property
    def _measuring(self) -> Measuring:
        return Measuring(self.varied, self.run, self.measures, self.kernel)

    def evaluate(self, p: Array) -> tuple[Array, Array]:
        """(figures, samples) in SI, NaN where a sample has none, and whether requirements are met, 1 or 0:
        (required, samples); from all parameters (parameters, samples)."""
        if not self.measures:
            return np.empty((0, p.shape[1])), np.empty((0, p.shape[1]))
        many = self._measuring.evaluate(p)
        rows = [many.figures[column.measure][column.label].values for column in self.columns]
        met = [many.met[name].astype(float) for name in self.required]
        return np.stack(rows), np.stack(met) if met else np.empty((0, p.shape[1]))


def per(unit: str, other: str) -> str:
    """The unit of one quantity over another."""
    below = f"({other})" if "/" in other or "*" in other else other
    return f"{unit or 1}/{below}" if other else unit
