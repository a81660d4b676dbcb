"""Sizes of a plate cam from limits: the smallest base circle, and where over two lengths the limits are kept."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.checks import CamLimits, worst
from linkwright.cam.disc import Disc
from linkwright.cam.followers import NoFollower
from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

SEEN = 16
"""Places between the smallest and the largest length at which the limits are looked at."""
CLOSE = 1e-12


def resized(disc: Disc, lengths: Mapping[str, float]) -> Disc:
    """The cam with other lengths of its follower (m)."""
    follower: Any = disc.follower
    return replace(disc, follower=replace(follower, **lengths))


def margin(disc: Disc, limits: CamLimits, exact: bool = True) -> float:
    """The least margin of the limits as a share; minus infinity where the follower doesn't reach or locks."""
    try:
        found = worst(disc, limits, exact)
    except (NoFollower, ValueError):
        return -math.inf
    return found if not math.isnan(found) else -math.inf


def smallest(disc: Disc, limits: CamLimits, low: float, high: float, length: str = "base") -> float | None:
    """The smallest length within ``low`` .. ``high`` (m) from which on the limits are kept, up to the next failure;
    ``None`` where they are nowhere kept."""

    def margin_at(value: float, exact: bool = True) -> float:
        return margin(resized(disc, {length: value}), limits, exact)

    return first_kept(margin_at, low, high)


def first_kept(kept: Callable[..., float], low: float, high: float) -> float | None:
    """The least argument at which a margin isn't negative, from ``SEEN`` places at which it is looked at roughly."""
    from scipy.optimize import brentq

    places = np.geomspace(low, high, SEEN)
    margins = [kept(float(place), False) for place in places]
    good = next((k for k, value in enumerate(margins) if value >= 0), None)
    if good is None:
        return None
    if good == 0:
        return float(places[0])
    a, b = float(places[good - 1]), float(places[good])
    while kept(a, False) == -math.inf and b - a > CLOSE * b:
        middle = (a + b) / 2
        a, b = (a, middle) if kept(middle, False) >= 0 else (middle, b)
    if (below := kept(a)) == -math.inf or below >= 0:
        return a if below >= 0 else b
    if kept(b) < 0:  # it was kept only roughly
        return first_kept(kept, b, high) if b < high else None
    root = float(brentq(kept, a, b, xtol=CLOSE * b))
    return root if kept(root) >= 0 else min(b, root * (1 + 4 * CLOSE))


@dataclass(frozen=True)
class Feasible:
    """Margins (len(second), len(first)) over two lengths of the follower (m); negative where a limit isn't kept, minus
    infinity where the follower doesn't reach."""

    names: tuple[str, str]
    first: Array
    second: Array
    margins: Array


def feasible(
    disc: Disc, limits: CamLimits, first: tuple[str, float, float], second: tuple[str, float, float], steps: int = 24
) -> Feasible:
    """The margins of the limits over two lengths, each ``(name, low, high)``, each looked at roughly."""
    a, b = (np.linspace(low, high, steps + 1) for _, low, high in (first, second))
    margins = np.array([[margin(resized(disc, {first[0]: x, second[0]: y}), limits, False) for x in a] for y in b])
    return Feasible((first[0], second[0]), a, b, margins)
