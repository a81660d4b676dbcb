"""The follower over a given contour: the lift that a cam as it is made gives, whatever made it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import Disc

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

COARSE = 32
"""First every so manieth point is looked at, then all beside the one that holds the follower highest."""
TOGETHER = 1 << 21
"""Pairs of cam angle and point that are looked at together."""


def rolled(disc: Disc, contour: Array, theta: Array) -> Array:
    """The lift (n,) at cam angles (n,) on a closed contour (2, points) in the cam's frame, m: the follower rests on the
    point that holds it highest. Points so near to each other that the chords between them don't matter; a spike may be
    passed over that is narrower than ``COARSE`` of them."""
    lift = np.empty(theta.size)
    every = np.arange(0, contour.shape[1], COARSE)
    beside = np.arange(-2 * COARSE, 2 * COARSE + 1)
    step = max(1, TOGETHER // max(every.size, beside.size))
    for first in range(0, theta.size, step):
        some = theta[first : first + step]
        best = every[_held(disc, contour, some, np.broadcast_to(every, (some.size, every.size))).argmax(axis=1)]
        fine = (best[:, None] + beside) % contour.shape[1]
        lift[first : first + step] = _held(disc, contour, some, fine).max(axis=1)
    return lift


def _held(disc: Disc, contour: Array, theta: Array, rows: Rows) -> Array:
    """The lift to which points hold the follower: (angles, points)."""
    cosine, sine = np.cos(theta)[:, None], disc.sense * np.sin(theta)[:, None]
    x, y = contour[0][rows], contour[1][rows]
    with np.errstate(invalid="ignore"):
        held = disc.follower.resting(cosine * x - sine * y, sine * x + cosine * y)
    return np.where(np.isnan(held), -np.inf, held)
