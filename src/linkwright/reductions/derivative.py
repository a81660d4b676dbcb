"""Derivatives by the deviations: of expressions at some times, of a figure."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Local:
    """Expressions at some times, SI: ``value`` and its time derivative ``rate`` (expressions, times), both by the
    deviations in ``slope`` and ``twist`` (expressions, deviations, times)."""

    value: Array
    rate: Array
    slope: Array
    twist: Array


@dataclass(frozen=True)
class Derivative:
    """A figure of a measure: its label, its place (s) if it has one, and the slopes by the deviations at each place
    that has the same extreme, ``places`` (places, deviations).

    The figure follows the largest of these, or with the ``sign`` -1 the smallest; of one place it is smooth.
    """

    label: str
    time: float | None
    places: Array
    sign: float = 1.0

    @classmethod
    def smooth(cls, slope: Array, time: float | None = None) -> Derivative:
        """Of a figure with one place."""
        return cls("", time, slope[None])

    def without_round_off(self, reach: Array, least: float) -> Derivative:
        """The same without slopes by which deviations up to ``reach`` (deviations,) change the figure by less than
        ``least``."""
        return replace(self, places=np.where(np.abs(self.places) * reach < least, 0.0, self.places))

    @property
    def tie(self) -> bool:
        """Whether several places have the extreme: both sides of the nominal value have slopes of their own."""
        return len(self.places) > 1

    @property
    def sides(self) -> Array:
        """The slopes below and above the nominal value of each deviation alone: (deviations, 2)."""
        least, largest = self.places.min(axis=0), self.places.max(axis=0)
        return np.stack([least, largest] if self.sign > 0 else [largest, least], axis=1)

    def limits(self, low: Array, high: Array) -> tuple[float, float]:
        """The least and the largest change while every deviation stays within ``low`` .. ``high`` (deviations,).

        Of a tie the outer one is reached, the inner one (the least change of a largest value) can't be exceeded.
        """
        terms = np.stack([self.places * low, self.places * high])
        pick = np.max if self.sign > 0 else np.min
        return float(pick(terms.min(axis=0).sum(axis=1))), float(pick(terms.max(axis=0).sum(axis=1)))
