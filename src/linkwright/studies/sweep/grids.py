"""Measures of a sweep over every combination of values: along one parameter, over the plane of two."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property, partial
from itertools import product
from math import prod

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.drawing.levels import band_stops, levels_of
from linkwright.findings import Said
from linkwright.presentation.blocks import Chart, Slider
from linkwright.presentation.charts import Axis, Dots, Field, Graph, Layer, Limit, Line, Plane, Row, Spots
from linkwright.studies.sweep.outcome import SweepOutcome

Array = NDArray[np.float64]

MOST_SLICES = 60
"""The most planes of a measure, where more than two parameters vary."""


def parameter_axis(outcome: SweepOutcome, name: str) -> tuple[Axis, float]:
    """A parameter as an axis, and the SI value of its unit."""
    quantities = outcome.compiled.quantities
    unit, size = quantities.unit_of(quantities.dimensions.of(name))
    return Axis(name, unit), size


def limits(outcome: SweepOutcome, index: int, upright: bool = False) -> list[Limit]:
    """The limits that a requirement sets to a measure, in its unit."""
    column, quantities = outcome.measures[index].column, outcome.compiled.quantities
    required = outcome.compiled.mechanism.require.get(column.measure)
    if required is None:
        return []
    ends = [end for end in (required.low, required.high) if end is not None]
    values = (quantities.value(end, column.dimension) / column.size for end in ends)
    return [Limit(f"{column.measure} {required.raw}", float(value), upright) for value in values]


@dataclass
class ParameterGrid:
    """The samples of a plan that has a grid: its parameters in the order of the file."""

    outcome: SweepOutcome

    @cached_property
    def axes(self) -> tuple[Array, ...]:
        """The values that each parameter takes (SI), of a grid whose rows are kept."""
        return (self.outcome.table is not None and self.outcome.plan.axes) or ()

    @property
    def regular(self) -> bool:
        """Whether there is a grid, of distinct values."""
        return bool(self.axes) and all(np.unique(axis).size == axis.size for axis in self.axes)

    @property
    def slices(self) -> int:
        """How many planes of the first two parameters there are."""
        return prod(axis.size for axis in self.axes[2:])

    def values(self, number: int) -> tuple[Axis, Array, NDArray[np.intp]]:
        """A parameter's axis, its values rising and their places in the plan."""
        axis, size = parameter_axis(self.outcome, self.outcome.names[number])
        order = np.argsort(self.axes[number])
        return axis, self.axes[number][order] / size, order

    def figures(self, index: int) -> Array:
        """A measure's values in its unit, by the numbers of the values of all parameters, rising."""
        assert self.outcome.table is not None
        found = self.outcome.table.figures[index].reshape([axis.size for axis in self.axes])
        found = found[np.ix_(*(self.values(i)[2] for i in range(len(self.axes))))]
        found = found / self.outcome.measures[index].column.size
        return np.where(np.isfinite(found), found, np.nan)

    def sliders(self) -> list[Slider]:
        """Those of the parameters beyond the first two; each starts at the value nearest to the file's own."""
        made = []
        for i in range(2, len(self.axes)):
            axis, values, _ = self.values(i)
            size = parameter_axis(self.outcome, self.outcome.names[i])[1]
            own = self.outcome.compiled.quantities.parameters[self.outcome.names[i]] / size
            texts = [f"{value:.6g} {axis.unit}".strip() for value in values.tolist()]
            made.append(Slider(self.outcome.names[i], texts, int(np.abs(values - own).argmin())))
        return made

    def charts(self, index: int) -> Iterator[Chart]:
        """A measure along the only parameter, or over the first two for each combination of the others."""
        column, found = self.outcome.measures[index].column, self.figures(index)
        first, *others = self.outcome.names
        if not others:
            title = Said("sweep.chart.over", name=column.title, parameter=first)
            yield Chart(title, shown=partial(self._graph, index, found))
            return
        title = Said("sweep.chart.plane", name=column.title, first=first, second=others[0])
        levels = levels_of(found)
        planes = found.reshape(*found.shape[:2], -1).T
        for rows, step in zip(planes, product(*map(range, found.shape[2:])), strict=True):
            yield Chart(title, shown=partial(self._plane, index, rows, levels), stack=f"grid {index}", step=step)

    def _graph(self, index: int, values: Array) -> Graph:
        axis, at, _ = self.values(0)
        column = self.outcome.measures[index].column
        rows: list[Row] = [Line(column.title, values), Dots(Said("sweep.chart.samples"), values)]
        return Graph(axis, at, Axis(column.title, column.unit), rows, limits(self.outcome, index))

    def _plane(self, index: int, values: Array, levels: list[float]) -> Plane:
        """``values`` (values of the second parameter, of the first)."""
        column = self.outcome.measures[index].column
        (x_axis, x, _), (y_axis, y, _) = (self.values(i) for i in range(2))
        axis = Axis(column.title, column.unit)
        lines = limits(self.outcome, index)
        field = Field(axis, x, y, values, levels, band_stops(len(levels) + 1), lines, family=True)
        layers: list[Layer] = [field]
        rows, columns = np.nonzero(np.isnan(values))
        if rows.size:
            layers.append(Spots(Said("sweep.chart.missing"), x[columns], y[rows], colour="muted", cross=True))
        return Plane(x_axis, y_axis, layers, equal=False)
