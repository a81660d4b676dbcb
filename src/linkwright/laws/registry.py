"""Normalised motion laws by name: s(u) from 0 to 1 over u from 0 to 1, at rest at both ends but where said."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.laws.curve import ROUND_OFF, SMOOTH, Curve, Extreme
from linkwright.laws.numbers import plain
from linkwright.laws.pieces import Piece, SmoothPart
from linkwright.notation import Scalar
from linkwright.notation.duals import value_of
from linkwright.notation.jets import call
from linkwright.notation.registry import Registry


@dataclass(frozen=True)
class Law(Curve):
    """A normalised law. ``mirrored`` laws end with an acceleration: only before or behind their own mirror image."""

    name: str = ""
    mirrored: bool = False

    @cached_property
    def continuity(self) -> tuple[int, int, int]:
        """The class at the start, inside and at the end, the ends as joined to a dwell; at most :data:`SMOOTH`.

        0 is a jump of the velocity, 1 of the acceleration, 2 of the jerk.
        """
        inside = min((join.continuity for join in self.joins()), default=SMOOTH)
        start, stop = (self._at_dwell(end) for end in self.end_derivatives())
        return start, inside, stop

    def _at_dwell(self, end: Sequence[float]) -> int:
        jumps = [abs(rate) > ROUND_OFF * size for rate, size in zip(end, self.sizes, strict=True)]
        return next((order - 1 for order, jump in enumerate(jumps) if jump and order), SMOOTH)

    def peaks(self, order: int) -> tuple[Extreme, Extreme]:
        """The smallest and the largest velocity (1), acceleration (2) or jerk (3), jumps at joins apart."""
        return self.extremes(order)

    def factor(self, order: int) -> float:
        """The largest magnitude of a derivative: Cv, Ca, Cj; infinite where the one below it jumps, between dwells."""
        if min(self.continuity) < order - 1:
            return math.inf
        return max(abs(extreme.value) for extreme in self.peaks(order))

    def skewed(self, share: Scalar) -> Law:
        """A symmetric law with its greatest velocity at ``share`` of the way instead of the middle.

        2p s(u/2p) up to p and 1 - 2q s((1-u)/2q) behind it, q = 1 - p: the velocities meet, and the accelerations
        are as q to p.
        """
        p, q = share, 1 - share
        before = [cut for part in self.parts if (cut := clipped(part, 0.0, 0.5))]
        behind = [cut for part in self.parts if (cut := clipped(part, 0.5, 1.0))]
        first = [part.transformed(0.0, 2 * p, 2 * p, 0.0) for part in before]
        second = [part.transformed(1 - 2 * q, 2 * q, 2 * q, 1 - 2 * q) for part in behind]
        return Law((*first, *second), self.name, self.mirrored)

    @property
    def symmetric(self) -> bool:
        """Whether s(u) + s(1 - u) = 1."""
        return not np.any(self.uneven)

    @cached_property
    def uneven(self) -> Any:
        """Of each sample, whether s(u) + s(1 - u) isn't 1."""
        u = np.linspace(0, 1, 101)
        return np.any(np.abs(value_of(self.at(u) + self.at(1 - u)) - 1) >= ROUND_OFF, axis=-1, keepdims=not self.plain)


def clipped(part: SmoothPart, low: float, high: float) -> Piece | None:
    """A piece of a closed form between two places, None where nothing of it lies there."""
    assert isinstance(part, Piece)
    if plain(part.start, part.stop):
        start, stop = max(part.start, low), min(part.stop, high)
    else:
        start, stop = (call("fmin", call("fmax", end, low), high) for end in (part.start, part.stop))
    return Piece(start, stop, part.powers, part.waves, part.origin) if np.any(value_of(start < stop)) else None


LAWS: Registry[Law] = Registry()


def register(name: str, mirrored: bool = False) -> Callable[[Callable[[], Curve]], Callable[[], Curve]]:
    """Register what a function makes as the law ``name``."""

    def add(make: Callable[[], Curve]) -> Callable[[], Curve]:
        LAWS[name] = Law(make().parts, name, mirrored)
        return make

    return add
