"""Angles known but for whole turns, over arrays (rad)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

MAX_TURN = 0.5
"""Largest turn (rad) between neighbours of a grid on which an angle is made continuous."""


def wrapped(angle: Array) -> Array:
    """The same angles in -pi..pi; NaN for what is no finite angle."""
    with np.errstate(invalid="ignore"):
        return np.asarray(np.mod(angle + np.pi, 2 * np.pi) - np.pi)


def whole_turns(angle: Array, near: Array | float) -> Array:
    """How many turns are to be added to angles to bring them within half a turn of others."""
    return np.asarray(np.round((near - angle) / (2 * np.pi)))


def steps(places: Array, angle: Array, rate: Array) -> tuple[Array, float]:
    """The steps of an angle from place to place (the last axis), and the largest one that its rates foretell.

    The rates say how far it turned; the angles only have to agree with that but for whole turns. Where a rate is
    infinite, as it is in a dead centre, the step is NaN.
    """
    with np.errstate(invalid="ignore"):
        turned = np.diff(places) * (rate[..., 1:] + rate[..., :-1]) / 2
        return turned + wrapped(np.diff(angle) - turned), float(np.abs(turned).max(initial=0.0))
