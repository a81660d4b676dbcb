"""Passages through change points: where a group's branch changes sign, and its values near by, by their limit.

At a change point the closed forms lose their digits (positions by eps/s, each rate by another 1/s, with s the
square root of the group's reach). In a band around it values are taken from poses on both sides of the band, which
are exact, by polynomial interpolation in time (barycentric formula: Berrut and Trefethen, SIAM Review 46, 2004).
What grows without bound is multiplied by the power of the time from the change point that makes it finite, and
divided again.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

SIDE = 8
"""Poses on each side of a band."""
GAP = 0.25
"""Half the band's width over the distance of the farthest pose."""
PROOF = np.array([-0.9, -0.6, 0.6, 0.9])
COMPARED = 32
"""Times on each side of a change point at which limits and closed forms are compared."""
AT = 1e-9
"""What grows without bound has no value this near (over the same distance)."""


@dataclass(frozen=True, eq=False)
class Passage:
    """A change point at ``time`` (s) where the ``groups`` change branch.

    ``width`` (s) is how far away the farthest pose is taken; ``poles`` has the signals that grow without bound,
    with the power of 1/time by which they do. One ``at_start`` of the motion leaves the branch that the model states
    to what follows.
    """

    time: float
    groups: tuple[str, ...]
    width: float
    at_start: bool = False
    poles: Mapping[str, int] = field(default_factory=dict)

    @cached_property
    def places(self) -> Array:
        """The poses' distances from the change point over ``width``, ascending: Chebyshev points of their squares."""
        low, high = GAP**2, 1.0
        k = np.cos(np.pi * (np.arange(SIDE) + 0.5) / SIDE)
        side = np.sort(np.sqrt((high + low) / 2 + (high - low) / 2 * k))
        return np.concatenate([-side[::-1], side])

    @property
    def nodes(self) -> Array:
        """The times of the poses (s)."""
        return self.time + self.width * self.places

    @property
    def proof(self) -> Array:
        """Times in the band at which the closed forms still are good enough to prove the interpolation (s)."""
        return self.time + GAP * self.width * PROOF

    @property
    def compared(self) -> Array:
        """Times in the outer half of the band, on both sides, at which limits and closed forms are compared (s)."""
        side = np.linspace(0.5, 0.98, COMPARED)
        return self.time + GAP * self.width * np.concatenate([-side[::-1], side])

    @property
    def band(self) -> Array:
        """The times at which the band begins and ends (s)."""
        return self.time + GAP * self.width * np.array([-1.0, 1.0])

    def inside(self, t: Array) -> NDArray[np.bool_]:
        """Which times lie in the band."""
        return np.asarray(np.abs(t - self.time) < GAP * self.width)

    def blank(self, t: Array) -> NDArray[np.bool_]:
        """At which times what grows without bound has no value."""
        return np.asarray((np.abs(t - self.time) < AT * self.width) & bool(self.poles))

    def between(self, t: Array, values: Array, poles: Array | int = 0) -> Array:
        """Rows at times in the band, from ``values`` (rows, nodes); ``poles`` is the power of each row's pole."""
        x, places = (t - self.time) / self.width, self.places
        weights = 1.0 / np.prod(places[:, None] - places + np.eye(places.size), axis=1)
        shares = weights / (x[:, None] - places)
        shares /= shares.sum(axis=1, keepdims=True)
        power = np.broadcast_to(np.asarray(poles), len(values))[:, None]
        with np.errstate(divide="ignore", invalid="ignore"):
            found = (values * places**power) @ shares.T
            return np.asarray(np.where((power > 0) & (np.abs(x) < AT), np.nan, found / x**power))


@dataclass(frozen=True)
class Passages:
    """All passages of a motion, in order of time."""

    every: tuple[Passage, ...] = ()

    def of_group(self, group: str) -> list[Passage]:
        """Those in which a group takes part."""
        return [p for p in self.every if group in p.groups]

    def outside(self, t: Array, group: str | None = None) -> NDArray[np.bool_]:
        """Which times lie in no band, or in none of a group."""
        kept = np.full(t.shape, True)
        for passage in self.every if group is None else self.of_group(group):
            kept &= ~passage.inside(t)
        return kept

    def bounded(self, t: Array) -> NDArray[np.bool_]:
        """At which times everything has a value."""
        kept = np.full(t.shape, True)
        for passage in self.every:
            kept &= ~passage.blank(t)
        return kept

    def sign(self, group: str, t: Array) -> Array:
        """The group's branch at times ``t`` over that which the model states."""
        if not (own := self.of_group(group)):
            return np.ones(t.shape)
        passed = np.searchsorted(np.array([p.time for p in own]), t, side="right")
        return np.asarray(1.0 - 2.0 * ((passed - sum(p.at_start for p in own)) % 2))


def unwrapped(values: Array, rows: Sequence[int]) -> Array:
    """The same values with some rows, angles in -pi..pi, made continuous."""
    values = values.copy()
    values[rows] = np.unwrap(values[rows])
    return values
