"""Charts of a sweep as SVG: bands of signals over time, histograms of measures, measures over a parameter."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import MOST_CHARTS, MOST_POSES, NARROW, Axes, named, thinned
from linkwright.expressions.units import TIME
from linkwright.findings import Said
from linkwright.presentation.blocks import Chart
from linkwright.studies.sweep.outcome import Statistics, SweepOutcome

Array = NDArray[np.float64]

MOST_DOTS = 1000


def charts(outcome: SweepOutcome) -> list[Chart]:
    """All charts, of each kind the first few."""
    made = [chart for text in [*outcome.bands][:MOST_CHARTS] for chart in _bands(outcome, text)]
    for i, found in enumerate(outcome.measures[:MOST_CHARTS]):
        if found.count:
            made += [_histogram(found), *_over(outcome, i)]
    return made


def _bands(outcome: SweepOutcome, text: str) -> list[Chart]:
    """A signal's band, and once more about its mean where it is narrow."""
    band = outcome.bands[text]
    width = np.fmax.reduce(band.largest - band.least)
    span = np.fmax.reduce(band.largest) - np.fmin.reduce(band.least)
    about = [_band(outcome, text, centred=True)] if 0 < width < NARROW * span else []
    return [_band(outcome, text), *about]


def _band(outcome: SweepOutcome, text: str, centred: bool = False) -> Chart:
    band, quantities = outcome.bands[text], outcome.compiled.quantities
    some = thinned(outcome.t.size, MOST_POSES)
    unit, size = quantities.unit_of(band.dimension)
    time_unit, second = quantities.unit_of(TIME)
    t = outcome.t[some] / second
    least, largest, mean = (row[some] / size for row in (band.least, band.largest, band.mean))
    half = np.nan_to_num(band.deviation[some] / size)
    title = named(Said("sweep.chart.about", name=text) if centred else text, unit)
    if centred:
        least, largest, mean = least - mean, largest - mean, 0 * mean
    if not np.isfinite(mean).any():
        return Chart(title, str)
    ends = float(np.fmin.reduce(least)), float(np.fmax.reduce(largest))
    axes = Axes((float(t[0]), float(t[-1])), ends, named(Said("plot.time"), time_unit))
    shapes = [
        axes.area(t, least, largest, "range"),
        axes.area(t, mean - half, mean + half, "spread"),
        axes.line(t, mean, "mean"),
    ]
    return Chart(title, partial(axes.drawing, shapes, title))


def _histogram(found: Statistics) -> Chart:
    edges, counts = found.edges / found.column.size, found.counts
    title = named(found.column.title, found.column.unit)
    axes = Axes((float(edges[0]), float(edges[-1])), (0.0, float(max(counts.max(), 1))), title)
    bars = axes.bars(edges, counts.astype(float))
    return Chart(Said("sweep.chart.histogram", name=found.column.title), partial(axes.drawing, bars, title))


def _over(outcome: SweepOutcome, index: int) -> list[Chart]:
    """A measure over the parameter that it follows most closely (by Pearson's correlation)."""
    table, column, quantities = outcome.table, outcome.measures[index].column, outcome.compiled.quantities
    if table is None:
        return []
    known = np.flatnonzero(np.isfinite(table.figures[index]))
    y = table.figures[index, known]
    if known.size < 2 or np.ptp(y) == 0:
        return []
    with np.errstate(all="ignore"):
        alike = [abs(float(np.corrcoef(row[known], y)[0, 1])) for row in table.parameters]
    best = int(np.nanargmax(np.nan_to_num(alike)))
    name = outcome.names[best]
    unit, size = quantities.unit_of(quantities.dimensions.of(name))
    some = known[thinned(known.size, MOST_DOTS)]
    x, y = table.parameters[best, some] / size, table.figures[index, some] / column.size
    axes = Axes((float(x.min()), float(x.max())), (float(y.min()), float(y.max())), named(name, unit))
    title = Said("sweep.chart.over", name=named(column.title, column.unit), parameter=name)
    radius = 2.5 if some.size < 200 else 1.5
    return [Chart(title, partial(axes.drawing, axes.dots(x, y, radius), title))]
