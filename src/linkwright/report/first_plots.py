"""Which plots a live report shows unfolded: drive effort, the largest reaction, velocity and position of the output."""

from __future__ import annotations

import re
from collections.abc import Sequence

from linkwright.findings import Said
from linkwright.report.data import Plot
from linkwright.results import Result

RATES = {"plot.position": "plot.velocity", "plot.angle": "plot.omega"}
"""Titles of places and of their rates."""


def first_plots(plots: Sequence[Plot], result: Result) -> list[int]:
    """The numbers of the four plots, in their order on the page; fewer where a mechanism has none of a kind."""
    keys = [plot["title"].key if isinstance(plot["title"], Said) else "" for plot in plots]
    efforts = [i for i, key in enumerate(keys) if key in ("plot.torque", "plot.effort")]
    reactions = [i for i, key in enumerate(keys) if key == "plot.force"]
    largest = max(reactions, key=lambda i: _largest(plots[i]), default=None)
    position = _output(plots, keys, result)
    found = [*efforts[:1], largest]
    if position is not None:
        rates = [i for i, key in enumerate(keys) if key == RATES[keys[position]]]
        same = [i for i in rates if _owners(plots[i]) & _owners(plots[position])]
        found += [*same[:1], position]
    return [i for i in found if i is not None]


def _output(plots: Sequence[Plot], keys: Sequence[str], result: Result) -> int | None:
    """The plot of the output's place: that of the first measured point or link, else of the last point that moves."""
    places = [i for i, key in enumerate(keys) if key in RATES]
    mechanism = result.run.compiled.mechanism
    required = [*mechanism.require, *(name for name in mechanism.measures if name not in mechanism.require)]
    for name in required:
        if (measure := mechanism.measures.get(name)) is None:
            continue
        for owner in re.findall(r"([\w'′″]+)\.", str(measure.signal.text)):
            for i in places:
                if owner in _owners(plots[i]):
                    return i
    points = [i for i in places if keys[i] == "plot.position"]
    return points[-1] if points else next(iter(places), None)


def _owners(plot: Plot) -> set[str]:
    return {series["name"].rpartition(".")[0] for series in plot["series"]}


def _largest(plot: Plot) -> float:
    return max(
        (abs(value) for series in plot["series"] for value in series["values"] if value is not None), default=0.0
    )
