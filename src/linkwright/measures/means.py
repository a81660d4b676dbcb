"""Means by Gauss quadrature between places, with what lies right beside a singular place taken from its germ."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.measures.sides import Side
from linkwright.results.quadrature import panel_points

Array = NDArray[np.float64]

CLOSE = 1e-12
"""How near two means on panels of which one has twice as many are to be, over the mean magnitude."""
UNSETTLED = 1e-9
"""A mean that still changes by more than this share of the mean magnitude has not converged."""
MOST_PANELS = 1 << 14
BESIDE = 1e-6
"""How much of a stretch beside a place with a limit but without a germ is taken to have that limit."""


@dataclass(frozen=True)
class Edge:
    """An end of a stretch (s): over ``width`` from it the integral comes from ``side``, which has a limit or a pole."""

    time: float
    width: float
    side: Side | None

    @classmethod
    def beside(cls, time: float, side: Side | None, length: float) -> Edge:
        """The end of a stretch of some length."""
        if side is None:
            return cls(time, 0.0, None)
        return cls(time, min(side.radius, length / 8) if side.germ is not None else BESIDE * length, side)

    def integral(self, power: int) -> float:
        """That of a power over the width."""
        return 0.0 if self.side is None else self.side.integral(self.width, power)


@dataclass(frozen=True)
class Mean:
    """A mean, how much it changed on the last doubling of panels over the mean magnitude, and that ``size``."""

    value: float
    change: float
    size: float

    @property
    def settled(self) -> bool:
        """Whether it has converged."""
        return not self.change > UNSETTLED


# (panels at first, points a panel): the second rule has other nodes, on other panels.
RULES = ((1.0, 8), (1.37, 11))


def mean(
    values: Callable[[Array], Array],
    edges: Callable[[int], list[Array]],
    ends: float,
    length: float,
    power: int,
    first: int,
    rule: int = 0,
) -> Mean:
    """The mean of a power of a function over stretches whose panels ``edges(count)`` gives, doubled until it stands.

    ``ends`` is the integral over what lies between the panels and singular places.
    """
    if not math.isfinite(ends):
        return Mean(ends, 0.0, abs(ends))
    factor, points = RULES[rule]
    panels, last = max(16, int(first * factor)), math.inf
    while True:
        every = edges(panels)
        lows, highs = (np.concatenate([part[cut] for part in every]) for cut in (slice(None, -1), slice(1, None)))
        t, weight = panel_points(lows, highs, points)
        height = values(t) ** power
        now = (float(height @ weight) + ends) / length
        size = (float(np.abs(height) @ weight) + abs(ends)) / length
        change = abs(now - last) / size if size > 0 else 0.0
        if not change > CLOSE or panels >= MOST_PANELS:
            return Mean(now, change, size)
        panels, last = panels * 2, now
