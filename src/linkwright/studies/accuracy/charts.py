"""Charts of the accuracy study: bands over the cycle, contributions, shares, histograms, convergence."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import MOST_POSES, NARROW, thinned
from linkwright.expressions.units import TIME
from linkwright.findings import Said, Text
from linkwright.presentation.blocks import Chart
from linkwright.presentation.charts import Axis, Band, Bars, Dots, Graph, Limit, Line, Row
from linkwright.studies.accuracy.outcome import AccuracyOutcome, MonteCarlo, OutputDeviations, SignalDeviations
from linkwright.studies.accuracy.summary import WIDE, ranked

Array = NDArray[np.float64]

MARKS, MOST_BARS, MOST_LINES = 25, 8, 5
MOST_SAMPLES = 100
"""Convergence is shown from so small a part of the samples on: before, it only jumps."""
BAR = 0.4
"""Half the width of a bar; bars of names are 1 apart."""


def curve_charts(curve: SignalDeviations, outcome: AccuracyOutcome) -> list[Chart]:
    """A signal's band, once more as deviations where it is narrow, and what its contributors make of it."""
    width, span = np.nanmax(curve.worst[1] - curve.worst[0], initial=0.0), np.ptp(_finite_values(curve.nominal))
    made = [Chart(curve.text, shown=partial(_band, curve, outcome, False))]
    if 0 < width < NARROW * span:
        made.append(
            Chart(Said("accuracy.chart.deviation", name=curve.text), shown=partial(_band, curve, outcome, True))
        )
    title = Said("accuracy.chart.contributions", name=curve.text)
    return [*made, Chart(title, shown=partial(_contributions, curve, outcome))]


def figure_charts(figure: OutputDeviations, outcome: AccuracyOutcome) -> list[Chart]:
    """The shares of a figure's contributors; histogram and convergence of its samples."""
    made: list[Chart | None] = [_pareto(figure, outcome)]
    found = figure.monte_carlo
    if found is not None and found.counts.any():
        title = Said("accuracy.chart.histogram", name=figure.title)
        made.append(Chart(title, shown=partial(_histogram, figure, found)))
        made += [_convergence(figure, found, row) for row in ("sigma", "mean")]
    return [chart for chart in made if chart is not None]


def _finite_values(values: Array) -> Array:
    known = values[np.isfinite(values)]
    return known if known.size else np.zeros(1)


def _over_time(curve: SignalDeviations, outcome: AccuracyOutcome) -> tuple[NDArray[np.intp], Axis, Array]:
    """Some poses of a signal, the axis of the time and their times in its unit."""
    some = thinned(curve.t.size, MOST_POSES)
    unit, second = outcome.compiled.quantities.unit_of(TIME)
    return some, Axis(Said("plot.time"), unit), curve.t[some] / second


def _band(curve: SignalDeviations, outcome: AccuracyOutcome, centred: bool) -> Graph:
    """Nominal value with worst case, RSS, the samples' standard deviation, clearances; ``centred``, the deviations from
    it."""
    some, time, t = _over_time(curve, outcome)
    nominal = curve.nominal[some] / curve.size * (0.0 if centred else 1.0)
    low, high = nominal + curve.worst[:, some] / curve.size
    mean, wide = nominal + curve.mean[some] / curve.size, WIDE * curve.sigma[some] / curve.size
    rows: list[Row] = [
        Band(Said("accuracy.chart.worst"), low, high),
        Band(Said("accuracy.chart.rss"), mean - wide, mean + wide, strong=True),
        Line(Said("accuracy.chart.nominal"), nominal),
    ]
    if curve.play is not None:
        shift, bound = curve.play[:, some] / curve.size
        rows += [
            Line(Said("accuracy.chart.bound-low"), low - bound, 1, dash=1),
            Line(Said("accuracy.chart.bound-high"), high + bound, 1, dash=1),
            Line(Said("accuracy.chart.shift"), nominal + shift, 1, dash=2),
        ]
    if curve.sampled is not None:
        marks = thinned(some.size, MARKS)
        middle, spread = nominal[marks] + curve.sampled[0, some[marks]] / curve.size, curve.sampled[1, some[marks]]
        for key, side in (("low", -WIDE), ("high", WIDE)):
            values = np.full(some.size, np.nan)
            values[marks] = middle + side * spread / curve.size
            rows.append(Dots(Said(f"accuracy.chart.sampled-{key}"), values, 1))
    return Graph(time, t, Axis(curve.text, curve.unit), rows)


def _contributions(curve: SignalDeviations, outcome: AccuracyOutcome) -> Graph:
    """The standard deviations that the largest contributors make, each with the sign of its coefficient."""
    some, time, t = _over_time(curve, outcome)
    parts = curve.coefficients[:, some] * outcome.contributors.sigma[:, None] / curve.size
    first = np.argsort(-np.nanmax(np.abs(parts), axis=1, initial=0.0), kind="stable")[:MOST_LINES].tolist()
    rows = [Line(outcome.contributors.every[i].name, parts[i], k, dash=k) for k, i in enumerate(first)]
    return Graph(time, t, Axis(Said("accuracy.chart.contributions", name=curve.text), curve.unit), rows)


def _pareto(figure: OutputDeviations, outcome: AccuracyOutcome) -> Chart | None:
    """A bar for the share of each contributor in the variance, and the line of their sum."""
    first = ranked(figure)[:MOST_BARS]
    shares = 100 * np.nan_to_num(figure.shares[first])
    if not shares.any():
        return None
    names: list[Text] = [outcome.contributors.every[i].name for i in first]
    if rest := figure.shares.size - len(first):
        names.append(Said("accuracy.rest", count=rest))
        shares = np.append(shares, 100 * np.nansum(figure.shares) - shares.sum())

    def graph() -> Graph:
        places = np.arange(float(len(names))) + 0.5
        share, whole = Said("accuracy.chart.share"), np.cumsum(shares)
        rows: list[Row] = [
            Bars(share, shares, np.stack([places - BAR, places + BAR], axis=1)),
            Line(Said("accuracy.chart.cumulative"), whole, 1, dash=1),
        ]
        return Graph(Axis(Said("accuracy.chart.contributor")), places, Axis(share, "%"), rows, names=names)

    return Chart(Said("accuracy.chart.pareto", name=figure.title), shown=graph)


def _histogram(figure: OutputDeviations, found: MonteCarlo) -> Graph:
    """The samples, the normal distribution of RSS and the limits of the worst case."""
    size, edges, counts = figure.column.size, found.edges / figure.column.size, found.counts.astype(float)
    middle, sigma = (figure.nominal + figure.mean) / size, figure.sigma / size
    pairs = np.stack([edges[:-1], edges[1:]], axis=1)
    x, samples = pairs.mean(axis=1), Said("accuracy.samples")
    rows: list[Row] = [Bars(samples, counts, pairs)]
    if sigma > 0:
        scale = counts.sum() * (edges[1] - edges[0]) / (sigma * np.sqrt(2 * np.pi))
        rows.append(Line(Said("accuracy.chart.normal"), scale * np.exp(-(((x - middle) / sigma) ** 2) / 2), 1))
    ends = [(figure.nominal + end) / size for end in figure.worst]
    limits = [Limit(Said("accuracy.chart.worst"), end, upright=True) for end in ends]
    return Graph(Axis(figure.title, figure.column.unit), x, Axis(samples), rows, limits)


def _convergence(figure: OutputDeviations, found: MonteCarlo, row: str) -> Chart | None:
    """Mean or standard deviation over the number of samples, with what RSS says and the interval of confidence."""
    if len(found.convergence) < 2:
        return None
    rows = found.convergence
    size, (count, means, sigmas) = figure.column.size, rows[rows[:, 0] >= rows[-1, 0] / MOST_SAMPLES].T
    values, last, interval, rss = {
        "mean": (means, found.mean, found.mean_interval, figure.nominal + figure.mean),
        "sigma": (sigmas, found.sigma, found.sigma_interval, figure.sigma),
    }[row]

    def graph() -> Graph:
        every = _finite_values(np.concatenate([values, [rss, *(interval or (last, last))]])) / size
        reach = 0.2 * float(np.ptp(every))
        shown: list[Row] = []
        if interval is not None:
            narrower = np.sqrt(count[-1] / np.maximum(count, 1))
            ends = ((last + (end - last) * narrower) / size for end in interval)
            low, high = (np.clip(end, every.min() - reach, every.max() + reach) for end in ends)
            name = Said("accuracy.chart.confidence", confidence=f"{100 * found.confidence:.6g}")
            shown.append(Band(name, low, high))
        shown.append(Line(Said("accuracy.chart.of-samples"), values / size))
        shown.append(Line(Said("accuracy.chart.of-rss"), np.full(count.size, rss / size), 1, dash=1))
        name = Said(f"accuracy.chart.axis.{row}", name=figure.title)
        return Graph(Axis(Said("accuracy.samples")), count, Axis(name, figure.column.unit), shown)

    return Chart(Said(f"accuracy.chart.convergence.{row}", name=figure.title), shown=graph)
