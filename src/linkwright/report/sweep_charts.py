"""Charts of a sweep as SVG: bands of signals over time, histograms of measures, measures over a parameter."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np
from numpy.typing import NDArray

from linkwright.model.units import TIME
from linkwright.report.data import Chart
from linkwright.studies import SweepOutcome
from linkwright.studies.histograms import widened
from linkwright.studies.sweep_outcome import Statistics
from linkwright.words import say

Array = NDArray[np.float64]

WIDTH, HEIGHT = 400.0, 220.0
LEFT, RIGHT, TOP, BOTTOM = 58.0, 12.0, 8.0, 36.0
MOST_POSES, MOST_DOTS, MOST_CHARTS = 400, 1000, 24
NARROW = 0.2
"""A band narrower than this share of the signal's span is hardly seen."""


def charts(outcome: SweepOutcome) -> list[Chart]:
    """All charts, of each kind the first few."""
    made = [chart for text in [*outcome.bands][:MOST_CHARTS] for chart in _bands(outcome, text)]
    for i, found in enumerate(outcome.measures[:MOST_CHARTS]):
        if found.count:
            made += [_histogram(found), *_over(outcome, i)]
    return made


class _Axes:
    """Places of values in a drawing, with the axes' lines and numbers."""

    def __init__(self, x: tuple[float, float], y: tuple[float, float], label: str) -> None:
        self.x, self.y, self.label = widened(*x), widened(*y), label

    def across(self, values: Array) -> Array:
        low, high = self.x
        return np.asarray(LEFT + (values - low) / (high - low) * (WIDTH - LEFT - RIGHT))

    def up(self, values: Array) -> Array:
        low, high = self.y
        return np.asarray(HEIGHT - BOTTOM - (values - low) / (high - low) * (HEIGHT - TOP - BOTTOM))

    def drawing(self, shapes: Sequence[str], title: str) -> str:
        lines, numbers = [], []
        for value in ticks(*self.x, 6):
            x = float(self.across(np.array(value)))
            lines.append(f"M{x:.1f} {TOP:.0f}V{HEIGHT - BOTTOM:.0f}")
            numbers.append(
                f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 14:.0f}" text-anchor="middle">{_shown(value)}</text>'
            )
        for value in ticks(*self.y, 5):
            y = float(self.up(np.array(value)))
            lines.append(f"M{LEFT:.0f} {y:.1f}H{WIDTH - RIGHT:.0f}")
            numbers.append(f'<text x="{LEFT - 6:.0f}" y="{y + 4:.1f}" text-anchor="end">{_shown(value)}</text>')
        middle = (LEFT + WIDTH - RIGHT) / 2
        numbers.append(f'<text x="{middle:.0f}" y="{HEIGHT - 5:.0f}" text-anchor="middle">{escape(self.label)}</text>')
        return (
            f'<svg class="lw still" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img" aria-label="{escape(title)}">'
            f'<path class="grid" d="{"".join(lines)}"/>{"".join(shapes)}{"".join(numbers)}</svg>'
        )


def ticks(low: float, high: float, count: int) -> list[float]:
    """Round numbers in a range, some ``count`` of them."""
    rough = (high - low) / count
    base = 10.0 ** np.floor(np.log10(rough))
    step = float(base * next(m for m in (1, 2, 5, 10) if m * base >= rough * (1 - 1e-9)))
    first = int(np.ceil(low / step - 1e-9))
    last = int(np.floor(high / step + 1e-9))
    return [k * step for k in range(first, last + 1)]


def _shown(value: float) -> str:
    return f"{value:.7g}".replace("-", "−")


def _points(x: Array, y: Array) -> str:
    return " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x.tolist(), y.tolist(), strict=True))


def _named(name: str, unit: str) -> str:
    return f"{name}, {unit.replace('*', '·')}" if unit else name


def _stretches(known: NDArray[np.bool_]) -> list[NDArray[np.intp]]:
    """The unbroken runs of poses with a value."""
    places = np.flatnonzero(known)
    return [run for run in np.split(places, np.flatnonzero(np.diff(places) > 1) + 1) if run.size]


def _bands(outcome: SweepOutcome, text: str) -> list[Chart]:
    """A signal's band, and once more about its mean where it is narrow."""
    band = outcome.bands[text]
    width = np.fmax.reduce(band.largest - band.least)
    span = np.fmax.reduce(band.largest) - np.fmin.reduce(band.least)
    about = [_band(outcome, text, centred=True)] if 0 < width < NARROW * span else []
    return [_band(outcome, text), *about]


def _band(outcome: SweepOutcome, text: str, centred: bool = False) -> Chart:
    band, quantities = outcome.bands[text], outcome.compiled.quantities
    some = np.unique(np.linspace(0, outcome.t.size - 1, MOST_POSES).round().astype(int))
    unit, size = quantities.unit_of(band.dimension)
    time_unit, second = quantities.unit_of(TIME)
    t = outcome.t[some] / second
    least, largest, mean = (row[some] / size for row in (band.least, band.largest, band.mean))
    half = np.nan_to_num(band.deviation[some] / size)
    title = _named(say("sweep.chart.about", name=text) if centred else text, unit)
    if centred:
        least, largest, mean = least - mean, largest - mean, 0 * mean
    if not np.isfinite(mean).any():
        return {"title": title, "drawing": ""}
    ends = float(np.fmin.reduce(least)), float(np.fmax.reduce(largest))
    axes = _Axes((float(t[0]), float(t[-1])), ends, _named(say("plot.time"), time_unit))
    shapes = []
    for run in _stretches(np.isfinite(mean)):
        x, back = axes.across(t[run]), axes.across(t[run[::-1]])
        for kind, low, high in (("range", least, largest), ("spread", mean - half, mean + half)):
            outline = f"{_points(x, axes.up(high[run]))} {_points(back, axes.up(low[run[::-1]]))}"
            shapes.append(f'<polygon class="{kind}" points="{outline}"/>')
        shapes.append(f'<polyline class="mean" points="{_points(x, axes.up(mean[run]))}"/>')
    return {"title": title, "drawing": axes.drawing(shapes, title)}


def _histogram(found: Statistics) -> Chart:
    edges, counts = found.edges / found.column.size, found.counts
    title = _named(found.column.name, found.column.unit)
    axes = _Axes((float(edges[0]), float(edges[-1])), (0.0, float(max(counts.max(), 1))), title)
    left, right = axes.across(edges[:-1]), axes.across(edges[1:])
    top, floor = axes.up(counts.astype(float)), HEIGHT - BOTTOM
    shapes = [
        f'<rect class="bar" x="{a:.1f}" y="{y:.1f}" width="{max(b - a - 0.5, 0.5):.1f}" height="{floor - y:.1f}"/>'
        for a, b, y in zip(left.tolist(), right.tolist(), top.tolist(), strict=True)
    ]
    return {"title": say("sweep.chart.histogram", name=found.column.name), "drawing": axes.drawing(shapes, title)}


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
    some = known[np.unique(np.linspace(0, known.size - 1, MOST_DOTS).round().astype(int))]
    x, y = table.parameters[best, some] / size, table.figures[index, some] / column.size
    axes = _Axes((float(x.min()), float(x.max())), (float(y.min()), float(y.max())), _named(name, unit))
    title = say("sweep.chart.over", name=_named(column.name, column.unit), parameter=name)
    radius = 2.5 if some.size < 200 else 1.5
    dots = zip(axes.across(x).tolist(), axes.up(y).tolist(), strict=True)
    shapes = [f'<circle class="dot" cx="{a:.1f}" cy="{b:.1f}" r="{radius}"/>' for a, b in dots]
    return [{"title": title, "drawing": axes.drawing(shapes, title)}]
