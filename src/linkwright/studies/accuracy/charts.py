"""Charts of the accuracy study: bands over the cycle, contributions, shares, histograms, convergence."""

from __future__ import annotations

from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwright.drawing.charts import LEFT, LETTER, MOST_POSES, NARROW, TOP, Axes, named, shortened, thinned
from linkwright.escape import markup
from linkwright.expressions.units import TIME
from linkwright.findings import Joined, Said, Term, Text
from linkwright.presentation.blocks import Chart
from linkwright.presentation.lettering import columns
from linkwright.studies.accuracy.outcome import AccuracyOutcome, MonteCarlo, OutputDeviations, SignalDeviations
from linkwright.studies.accuracy.summary import WIDE, ranked

Array = NDArray[np.float64]

MARKS, MOST_BARS, MOST_LINES = 25, 8, 5
MOST_SAMPLES = 100
"""Convergence is shown from so small a part of the samples on: before, it only jumps."""


def curve_charts(curve: SignalDeviations, outcome: AccuracyOutcome) -> list[Chart]:
    """A signal's band, once more as deviations where it is narrow, and what its contributors make of it."""
    width, span = np.nanmax(curve.worst[1] - curve.worst[0], initial=0.0), np.ptp(_finite_values(curve.nominal))
    apart = [_band(curve, outcome, centred=True)] if 0 < width < NARROW * span else []
    return [_band(curve, outcome), *apart, _contributions(curve, outcome)]


def figure_charts(figure: OutputDeviations, outcome: AccuracyOutcome) -> list[Chart]:
    """The shares of a figure's contributors; histogram and convergence of its samples."""
    made: list[Chart | None] = [_pareto(figure, outcome)]
    found = figure.monte_carlo
    if found is not None and found.counts.any():
        made += [_histogram(figure, found), *(_convergence(figure, found, row) for row in ("sigma", "mean"))]
    return [chart for chart in made if chart is not None]


def _finite_values(values: Array) -> Array:
    known = values[np.isfinite(values)]
    return known if known.size else np.zeros(1)


def _band(curve: SignalDeviations, outcome: AccuracyOutcome, centred: bool = False) -> Chart:
    """Nominal value with worst case (light), RSS (dark), the samples' standard deviation (dots), clearances (dashed);
    ``centred``, the deviations from it."""
    quantities, some = outcome.compiled.quantities, thinned(curve.t.size, MOST_POSES)
    time_unit, second = quantities.unit_of(TIME)
    t, nominal = curve.t[some] / second, curve.nominal[some] / curve.size * (0.0 if centred else 1.0)
    low, high = nominal + curve.worst[:, some] / curve.size
    mean, wide = nominal + curve.mean[some] / curve.size, WIDE * curve.sigma[some] / curve.size
    shift, bound = np.zeros((2, some.size)) if curve.play is None else curve.play[:, some] / curve.size
    title = named(Said("accuracy.chart.deviation", name=curve.text) if centred else curve.text, curve.unit)
    every = _finite_values(np.stack([nominal, low - bound, high + bound, mean - wide, mean + wide, nominal + shift]))
    axes = Axes((t[0], t[-1]), (float(every.min()), float(every.max())), named(Said("plot.time"), time_unit))
    shapes = [axes.area(t, low, high, "range"), axes.area(t, mean - wide, mean + wide, "spread")]
    shapes.append(axes.line(t, nominal, "mean"))
    if curve.play is not None:
        shapes += [axes.line(t, low - bound, "limit"), axes.line(t, high + bound, "limit")]
        shapes.append(axes.line(t, nominal + shift, "shift"))
    if curve.sampled is not None:
        marks = thinned(some.size, MARKS)
        middle, spread = nominal[marks] + curve.sampled[0, some[marks]] / curve.size, curve.sampled[1, some[marks]]
        for side in (-WIDE, WIDE):
            shapes += axes.dots(t[marks], middle + side * spread / curve.size, 2.0, "sampled")
    return Chart(title, partial(axes.drawing, shapes, title))


def _contributions(curve: SignalDeviations, outcome: AccuracyOutcome) -> Chart:
    """The standard deviations that the largest contributors make, each with the sign of its coefficient."""
    time_unit, second = outcome.compiled.quantities.unit_of(TIME)
    some = thinned(curve.t.size, MOST_POSES)
    parts = curve.coefficients[:, some] * outcome.contributors.sigma[:, None] / curve.size
    title = named(Said("accuracy.chart.contributions", name=curve.text), curve.unit)
    first = np.argsort(-np.nanmax(np.abs(parts), axis=1, initial=0.0), kind="stable")[:MOST_LINES].tolist()
    known, t = _finite_values(parts[first]), curve.t[some] / second
    top = float(known.max() + 0.12 * np.ptp(known))  # room for the names
    axes = Axes((t[0], t[-1]), (float(known.min()), top), named(Said("plot.time"), time_unit))
    shapes, x = [], LEFT + 4
    for k, i in enumerate(first):
        name = shortened(outcome.contributors.every[i].name, 10)
        shapes.append(axes.line(t, parts[i], f"line lw-c{k}"))
        shapes.append(f'<path class="line lw-c{k}" d="M{x:.0f} {TOP + 7:.0f}h10"/>')
        shapes.append(f'<text x="{x + 13:.0f}" y="{TOP + 11:.0f}">{markup(name)}</text>')
        x += 20 + LETTER * columns(name)
    return Chart(title, partial(axes.drawing, shapes, title))


def _pareto(figure: OutputDeviations, outcome: AccuracyOutcome) -> Chart | None:
    """A bar for the share of each contributor in the variance, and the line of their sum."""
    title = Said("accuracy.chart.pareto", name=figure.title)
    first = ranked(figure)[:MOST_BARS]
    shares = 100 * np.nan_to_num(figure.shares[first])
    if not shares.any():
        return None
    names: list[Text] = [outcome.contributors.every[i].name for i in first]
    if rest := figure.shares.size - len(first):
        names.append(Said("accuracy.rest", count=rest))
        shares = np.append(shares, 100 * np.nansum(figure.shares) - shares.sum())
    whole = np.cumsum(shares)
    axes = Axes((0.0, len(names)), (min(0.0, shares.min()), 1.1 * max(100.0, whole.max())), "", names)
    places = np.arange(float(len(names))) + 0.5
    edges = np.stack([places - 0.4, places + 0.4], axis=1)
    shapes = [bar for pair, share in zip(edges, shares, strict=True) for bar in axes.bars(pair, np.array([share]))]
    shapes += [axes.line(places + 0.4, whole, "limit"), *axes.dots(places + 0.4, whole, 2.0, "sampled")]
    for x, share in zip(axes.across(places).tolist(), shares.tolist(), strict=True):
        y, text = float(axes.up(np.array(share))) - 5, f"{share:.3g}".replace("-", "−")
        shapes.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="middle">{text}</text>')
    told = Joined(Joined([name, f"{share:.3g} %"], " ") for name, share in zip(names, shares.tolist(), strict=True))
    return Chart(title, partial(axes.drawing, shapes, Term("colon", first=title, then=told)))


def _histogram(figure: OutputDeviations, found: MonteCarlo) -> Chart:
    """The samples, the normal distribution of RSS and the limits of the worst case."""
    size, edges, counts = figure.column.size, found.edges / figure.column.size, found.counts.astype(float)
    middle, sigma = (figure.nominal + figure.mean) / size, figure.sigma / size
    limits = [(figure.nominal + end) / size for end in figure.worst]
    x = np.linspace(edges[0], edges[-1], 101)
    curve = np.zeros(0)
    if sigma > 0:
        scale = counts.sum() * (edges[1] - edges[0]) / (sigma * np.sqrt(2 * np.pi))
        curve = scale * np.exp(-(((x - middle) / sigma) ** 2) / 2)
    top = max(counts.max(), curve.max(initial=0.0))
    axes = Axes(
        (min(edges[0], limits[0]), max(edges[-1], limits[1])),
        (0.0, top),
        named(figure.title, figure.column.unit),
    )
    shapes = axes.bars(edges, counts)
    if curve.size:
        shapes.append(axes.line(x, curve, "normal"))
    shapes += [axes.line(np.full(2, limit), np.array([0.0, top]), "limit") for limit in limits]
    title = Said("accuracy.chart.histogram", name=figure.title)
    return Chart(title, partial(axes.drawing, shapes, title))


def _convergence(figure: OutputDeviations, found: MonteCarlo, row: str) -> Chart | None:
    """Mean or standard deviation over the number of samples, with what RSS says and the interval of confidence."""
    title = Said(f"accuracy.chart.convergence.{row}", name=named(figure.title, figure.column.unit))
    if len(found.convergence) < 2:
        return None
    rows = found.convergence
    size, (count, means, sigmas) = figure.column.size, rows[rows[:, 0] >= rows[-1, 0] / MOST_SAMPLES].T
    values, last, interval, rss = {
        "mean": (means, found.mean, found.mean_interval, figure.nominal + figure.mean),
        "sigma": (sigmas, found.sigma, found.sigma_interval, figure.sigma),
    }[row]
    ends = (last, last) if interval is None else interval
    every = _finite_values(np.concatenate([values, [rss, *ends]])) / size
    reach = float(np.ptp(every))
    axes = Axes(
        (0.0, float(count[-1])),
        (float(every.min()) - 0.2 * reach, float(every.max()) + 0.2 * reach),
        Said("accuracy.samples"),
    )
    narrower = np.sqrt(count[-1] / np.maximum(count, 1))
    low, high = (np.clip((last + (end - last) * narrower) / size, *axes.y) for end in ends)
    shapes = [
        "" if interval is None else axes.area(count, low, high, "range"),
        axes.line(np.array([0.0, count[-1]]), np.full(2, rss / size), "limit"),
        axes.line(count, values / size, "mean"),
    ]
    return Chart(title, partial(axes.drawing, shapes, title))
