"""Means by Gauss quadrature between places, with what lies right beside a singular place taken from its germ."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.measures.sides import Side
from linkwright.results.quadrature import panel_points

Array = NDArray[np.float64]

CLOSE = 1e-14
"""How near a panel's integral is to be to those of its halves, over the integral of the magnitude."""
UNSETTLED = 1e-9
"""A mean of which more than this share, over the mean magnitude, still changed has not converged."""
MOST_PANELS = 1 << 16
TOGETHER = 1 << 12
"""So many panels are evaluated at once, which bounds the memory."""
BESIDE = 1e-6
"""How much of a stretch beside a place with a limit but without a germ is taken to have that limit."""


@dataclass(frozen=True)
class StretchEnd:
    """An end of a stretch (s): over ``width`` from it the integral comes from ``side``, which has a limit or a pole."""

    time: float
    width: float
    side: Side | None

    @classmethod
    def beside(cls, time: float, side: Side | None, length: float) -> StretchEnd:
        """The end of a stretch of some length."""
        if side is None:
            return cls(time, 0.0, None)
        return cls(time, min(side.radius, length / 8) if side.germ is not None else BESIDE * length, side)

    def integral(self, power: int) -> float:
        """That of a power over the width."""
        return 0.0 if self.side is None else self.side.integral(self.width, power)


@dataclass(frozen=True)
class MeanValue:
    """A mean, how much of it still changed when its panels were halved, over the mean magnitude, and that ``size``."""

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
) -> MeanValue:
    """The mean of a power of a function over the panels of stretches, each halved until its integral stands.

    ``edges(count)`` gives the panels of each stretch, ``ends`` the integral over what lies between them and singular
    places.
    """
    if not math.isfinite(ends):
        return MeanValue(ends, 0.0, abs(ends))
    factor, points = RULES[rule]

    def integrals(lows: Array, highs: Array) -> Array:
        """Of the power and of its magnitude on each panel: (2, panels)."""
        parts = []
        for start in range(0, lows.size, TOGETHER):
            some = slice(start, start + TOGETHER)
            t, weight = panel_points(lows[some], highs[some], points)
            height = values(t) ** power * weight
            parts.append(np.array([height, np.abs(height)]).reshape(2, -1, points).sum(axis=2))
        return np.concatenate(parts, axis=1)

    every = edges(max(16, int(first * factor)))
    lows, highs = (np.concatenate([part[cut] for part in every]) for cut in (slice(None, -1), slice(1, None)))
    here, total, panels = integrals(lows, highs), np.zeros(2), lows.size
    left = 0.0
    while lows.size:
        middle = (lows + highs) / 2
        halves = integrals(np.append(lows, middle), np.append(middle, highs))
        sums = halves[:, : lows.size] + halves[:, lows.size :]
        size = float(total[1] + sums[1].sum()) + abs(ends)
        off = np.abs(sums[0] - here[0])
        stands = ~(off > CLOSE * size)
        panels += 2 * int(np.count_nonzero(~stands))
        if panels > MOST_PANELS:
            left = float(off[~stands].sum())
            stands[:] = True
        total += sums[:, stands].sum(axis=1)
        more = np.tile(~stands, 2)
        lows, highs, here = np.append(lows, middle)[more], np.append(middle, highs)[more], halves[:, more]
    size = float(total[1]) + abs(ends)
    return MeanValue((float(total[0]) + ends) / length, left / size if size > 0 else 0.0, size / length)
