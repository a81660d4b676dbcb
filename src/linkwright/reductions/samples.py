"""What the sampled rules of reductions get: a measure's signals on samples of a run, as a page has them.

A page computes signals at some hundreds of times whenever a dimension moves. The rules here, and the same in
``web/src/measures/``, take measures from them by :mod:`linkwright.reductions.interpolant`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from itertools import pairwise
from math import floor, isfinite, pi
from typing import NamedTuple

from linkwright.data_classes import dataclass
from linkwright.expressions.fields import Expression
from linkwright.reductions.interpolant import Interpolant, turned_levels

Interval = tuple[float, float]


@dataclass(frozen=True)
class SampledInputs:
    """What a sampled rule asks of a measure: expressions of signals as ``rows`` by their keys ("" for the signal),
    expressions of parameters of the kind of the signal as ``numbers``, and ``words`` of the entry."""

    rows: Mapping[str, Expression]
    numbers: Mapping[str, Expression] = field(default_factory=dict)
    words: Mapping[str, str] = field(default_factory=dict)


class SampledFigure(NamedTuple):
    """A number of a measure (SI) and its time (s), ``None`` where it has no place."""

    value: float
    time: float | None = None


SampledFigures = dict[str, SampledFigure]
"""By label."""


@dataclass(frozen=True)
class OnSamples:
    """A measure's ``rows`` on samples, known all over the ``stretches`` (s) of its window, of which there is one at
    least; the keys of rows that are ``angles``; ``numbers`` in SI."""

    rows: Mapping[str, Interpolant]
    stretches: Sequence[Interval]
    angles: frozenset[str] = frozenset()
    numbers: Mapping[str, float] = field(default_factory=dict)
    words: Mapping[str, str] = field(default_factory=dict)

    @property
    def signal(self) -> Interpolant:
        """What is reduced."""
        return self.rows[""]

    @property
    def length(self) -> float:
        """How long the stretches are together (s)."""
        total = 0.0
        for a, b in self.stretches:
            total += b - a
        return total


def stretches(
    t: Sequence[float], window: Interpolant | None, low: float, high: float, turning: bool
) -> list[Interval] | None:
    """The stretches of time (s) in which a window's signal lies in ``low`` .. ``high``, with ``turning`` also any whole
    turns from there; without a signal, the time itself. ``None`` where the signal isn't known all along, or an end."""
    start, stop = float(t[0]), float(t[-1])
    if not (isfinite(low) and isfinite(high)):
        return None
    if window is None:
        low, high = max(low, start), min(high, stop)
        return [(low, high)] if low < high else []
    if not window.known(start, stop):
        return None
    _, values = window.marks(start, stop)
    least, most = min(values), max(values)
    times = [start, stop]
    for edge in (low, high):
        levels = turned_levels(edge, least, most) if turning else [edge]
        if not levels:
            return None
        for level in levels:
            times += window.crossings(level, start, stop)
    times = sorted(set(times))
    found: list[Interval] = []
    for a, b in pairwise(times):
        # The middle of each piece decides for the whole of it.
        over = window.value((a + b) / 2) - low
        if turning:
            over -= 2 * pi * floor(over / (2 * pi))
        if 0 <= over <= high - low:
            if found and found[-1][1] == a:
                a = found.pop()[0]
            found.append((a, b))
    return found


def wrapped(value: float, low: float, high: float) -> float:
    """A figure in the range of whole turns that a measure states."""
    turn = high - low
    return value - turn * floor((value - low) / turn)


def sound(figures: SampledFigures | None) -> SampledFigures | None:
    """Figures that are all numbers, or none."""
    if figures is None or not all(isfinite(one.value) for one in figures.values()):
        return None
    return figures
