"""The follower over a given contour: the lift that a cam as it is made gives, whatever made it."""

from __future__ import annotations

import math

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
    if not disc.follower.faced and disc.follower.radius == 0:
        return np.array([_on_edge(disc, contour, angle) for angle in theta.tolist()])
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


def _on_edge(disc: Disc, contour: Array, angle: float) -> float:
    """The lift of an edge at a cam angle, where its way meets the contour's chords; minus infinity where nowhere."""
    cosine, sine = math.cos(angle), disc.sense * math.sin(angle)
    x, y = contour
    aside, lift = disc.follower.edge(cosine * x - sine * y, sine * x + cosine * y)
    other, after = np.roll(aside, -1), np.roll(lift, -1)
    across = np.flatnonzero((aside <= 0) != (other <= 0))
    share = aside[across] / (aside[across] - other[across])
    return float((lift[across] + share * (after[across] - lift[across])).max(initial=-math.inf))


def _held(disc: Disc, contour: Array, theta: Array, rows: Rows) -> Array:
    """The lift to which points hold the follower: (angles, points)."""
    cosine, sine = np.cos(theta)[:, None], disc.sense * np.sin(theta)[:, None]
    x, y = contour[0][rows], contour[1][rows]
    with np.errstate(invalid="ignore"):
        held = disc.follower.resting(cosine * x - sine * y, sine * x + cosine * y)
    return np.where(np.isnan(held), -np.inf, held)
