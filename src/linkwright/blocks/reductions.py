"""Reductions over samples: the contract, and several of them over the same values.

A reduction is *tallied* inside an atom, sample after sample, and the states of atoms are *folded* in the order of
their units. Both orders are fixed, so the figures don't depend on who computed what, to the last bit. How an
atom's samples are handed to its tally (at once or in strips that fit the cache) changes nothing either.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks.work import Arrays

Array = NDArray[np.float64]


class Tally(Protocol):
    """A reduction at work on the samples of one atom."""

    def add(self, y: Array, first: int) -> None:
        """Count in ``y`` (outputs, samples, poses), whose first sample has the number ``first`` in the study."""

    def state(self) -> Arrays:
        """What was counted, as arrays with the poses on their last axis."""


class Reduction(Protocol):
    """A figure of each output and pose over all samples. Values that aren't finite don't count and are told apart."""

    def tally(self, outputs: int, poses: int) -> Tally:
        """A fresh tally."""

    def fold(self, state: Arrays, later: Arrays) -> Arrays:
        """The state of both, ``later`` holding the later samples. Neither is changed."""

    def result(self, state: Arrays) -> Arrays:
        """The figures, as arrays with the poses on their last axis."""


class Tallies:
    """Several named reductions over the same values; their states in one flat dict, ``NAME.ARRAY``."""

    def __init__(self, reductions: Mapping[str, Reduction], outputs: int, poses: int) -> None:
        self._tallies = {name: reduction.tally(outputs, poses) for name, reduction in reductions.items()}

    def add(self, y: Array, first: int) -> None:
        """Count in ``y`` (outputs, samples, poses), whose first sample has the number ``first`` in the study."""
        for tally in self._tallies.values():
            tally.add(y, first)

    def state(self) -> Arrays:
        """The states of all: what an atom's ``perform`` gives to a :class:`~linkwright.blocks.sinks.Folding`."""
        return {f"{name}.{key}": value for name, tally in self._tallies.items() for key, value in tally.state().items()}


def part(state: Mapping[str, NDArray[Any]], name: str) -> Arrays:
    """The state of one reduction out of a flat dict."""
    return {key.removeprefix(f"{name}."): value for key, value in state.items() if key.startswith(f"{name}.")}
