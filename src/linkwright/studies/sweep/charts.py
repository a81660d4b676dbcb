"""Charts of a sweep: bands of signals over time, histograms of measures, measures over parameters."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import MOST_CHARTS, MOST_POSES, NARROW, thinned
from linkwright.drawing.levels import band_stops
from linkwright.expressions.units import TIME
from linkwright.findings import Said
from linkwright.presentation.blocks import Chart, Charts
from linkwright.presentation.charts import Axis, Band, Bars, ColourScale, Graph, Line, Plane, Row, Spots
from linkwright.studies.sweep.grids import MOST_SLICES, ParameterGrid, limits, parameter_axis
from linkwright.studies.sweep.outcome import Statistics, SweepOutcome

Array = NDArray[np.float64]

MOST_DOTS = 1000
STOPS = 12
"""Colours of a scale."""


def charts(outcome: SweepOutcome) -> list[Charts]:
    """All charts, of each kind the first few: those of signals, those of measures, with sliders where a grid has more
    than two parameters."""
    signals = [chart for text in [*outcome.bands][:MOST_CHARTS] for chart in _bands(outcome, text)]
    grid, single = ParameterGrid(outcome), list[Chart]()
    planes: list[Chart] = []
    for i, found in enumerate(outcome.measures[:MOST_CHARTS]):
        if not found.count:
            continue
        if grid.regular and grid.slices <= MOST_SLICES:
            planes += grid.charts(i)
        else:
            single += _over(outcome, i)
        single.append(_histogram(outcome, i, found))
    sliders = grid.sliders() if planes else []
    return [Charts(planes, sliders), Charts([*single, *signals])]


def _bands(outcome: SweepOutcome, text: str) -> list[Chart]:
    """A signal's band, and once more about its mean where it is narrow."""
    band = outcome.bands[text]
    if not np.isfinite(band.mean).any():
        return []
    width = np.fmax.reduce(band.largest - band.least)
    span = np.fmax.reduce(band.largest) - np.fmin.reduce(band.least)
    about = 0 < width < NARROW * span
    made = [Chart(text, shown=partial(_band, outcome, text, False))]
    return (
        [*made, Chart(Said("sweep.chart.about", name=text), shown=partial(_band, outcome, text, True))]
        if about
        else made
    )


def _band(outcome: SweepOutcome, text: str, centred: bool) -> Graph:
    band, quantities = outcome.bands[text], outcome.compiled.quantities
    some = thinned(outcome.t.size, MOST_POSES)
    unit, size = quantities.unit_of(band.dimension)
    time_unit, second = quantities.unit_of(TIME)
    least, largest, mean = (row[some] / size for row in (band.least, band.largest, band.mean))
    half = np.nan_to_num(band.deviation[some] / size)
    if centred:
        least, largest, mean = least - mean, largest - mean, 0 * mean
    rows: list[Row] = [
        Band(Said("sweep.chart.range"), least, largest),
        Band(Said("sweep.chart.spread"), mean - half, mean + half, strong=True),
        Line(Said("sweep.chart.mean"), mean),
    ]
    return Graph(Axis(Said("plot.time"), time_unit), outcome.t[some] / second, Axis(text, unit), rows)


def _histogram(outcome: SweepOutcome, index: int, found: Statistics) -> Chart:
    column, edges = found.column, found.edges / found.column.size

    def graph() -> Graph:
        pairs = np.stack([edges[:-1], edges[1:]], axis=1)
        bars = Bars(Said("sweep.chart.samples"), found.counts.astype(float), pairs)
        name = Axis(Said("sweep.chart.samples"))
        x = Axis(column.title, column.unit)
        return Graph(x, pairs.mean(axis=1), name, [bars], limits(outcome, index, upright=True))

    return Chart(Said("sweep.chart.histogram", name=column.title), shown=graph)


def _over(outcome: SweepOutcome, index: int) -> list[Chart]:
    """A measure over the parameter that it follows most closely (by Pearson's correlation); where two parameters vary,
    its values in their plane."""
    table = outcome.table
    if table is None:
        return []
    known = np.flatnonzero(np.isfinite(table.figures[index]))
    y = table.figures[index, known]
    if known.size < 2 or np.ptp(y) == 0:
        return []
    with np.errstate(all="ignore"):
        alike = [abs(float(np.corrcoef(row[known], y)[0, 1])) for row in table.parameters]
    name = outcome.names[int(np.nanargmax(np.nan_to_num(alike)))]
    title, some = outcome.measures[index].column.title, known[thinned(known.size, MOST_DOTS)]
    over = Said("sweep.chart.over", name=title, parameter=name)
    made = [Chart(over, shown=partial(_dots, outcome, index, name, some))]
    if len(outcome.names) == 2:
        first, second = outcome.names
        plane = Said("sweep.chart.plane", name=title, first=first, second=second)
        made.append(Chart(plane, shown=partial(_coloured, outcome, index, some)))
    return made


def _dots(outcome: SweepOutcome, index: int, name: str, some: NDArray[np.intp]) -> Plane:
    table, column = outcome.table, outcome.measures[index].column
    assert table is not None
    axis, size = parameter_axis(outcome, name)
    x, y = table.parameters[outcome.names.index(name), some] / size, table.figures[index, some] / column.size
    spots = Spots(Said("sweep.chart.samples"), x, y)
    return Plane(axis, Axis(column.title, column.unit), [spots], equal=False, limits=limits(outcome, index))


def _coloured(outcome: SweepOutcome, index: int, some: NDArray[np.intp]) -> Plane:
    """The samples in the plane of two parameters, coloured by their values."""
    table, column = outcome.table, outcome.measures[index].column
    assert table is not None
    (x_axis, x_size), (y_axis, y_size) = (parameter_axis(outcome, name) for name in outcome.names)
    values = table.figures[index, some] / column.size
    ends = float(values.min()), float(values.max())
    scale = ColourScale(Axis(column.title, column.unit), *ends, band_stops(STOPS))
    x, y = table.parameters[0, some] / x_size, table.parameters[1, some] / y_size
    return Plane(x_axis, y_axis, [Spots(Said("sweep.chart.samples"), x, y, values, scale)], equal=False)
