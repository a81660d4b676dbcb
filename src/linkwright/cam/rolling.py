"""The follower over a given contour: the lift that a cam as it is made gives, whatever made it."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import Disc

Array = NDArray[np.float64]
Rows = NDArray[np.intp]
Held = Callable[[Array, Rows], Array]
"""The lift (angles, points) to which points hold the follower at cam angles, by their rows (angles, points)."""

COARSE = 32
"""First every so manieth point is looked at, then all beside the one that holds the follower highest."""
ABOUT = 1.5
"""How far about the roller's centre (roller radii) the outer flank is looked for: not as far as its other side."""
TOGETHER = 1 << 21
"""Pairs of cam angle and point that are looked at together."""


def rolled(disc: Disc, contour: Array, theta: Array) -> Array:
    """The lift (n,) at cam angles (n,) on a closed contour (2, points) in the cam's frame, m: the follower rests on the
    point that holds it highest. Points so near to each other that the chords between them don't matter; a spike may be
    passed over that is narrower than ``COARSE`` of them."""
    if not disc.follower.faced and disc.follower.radius == 0:
        return np.array([_on_edge(disc, contour, angle) for angle in theta.tolist()])

    def resting_lift(some: Array, rows: Rows) -> Array:
        return _against(disc.follower.resting, disc, contour, some, rows)

    return _highest(resting_lift, contour.shape[1], theta)


def rolled_within(disc: Disc, contour: Array, theta: Array) -> Array:
    """Likewise of a roller that lies against the outer flank of a groove from within: on the point that holds it lowest
    of those about its place on an exact cam, as the groove goes around; infinity where there are none."""
    radius = disc.follower.radius

    def hanging_lift(some: Array, rows: Rows) -> Array:
        centre = [np.broadcast_to(c.d[0], some.shape)[:, None] for c in disc.look(some).centre]
        x, y = _fixed(disc, contour, some, rows)
        near = np.hypot(x - centre[0], y - centre[1]) < ABOUT * radius
        return np.where(near, -_against(disc.follower.hanging, disc, contour, some, rows, np.inf), -np.inf)

    return -_highest(hanging_lift, contour.shape[1], theta)


def _highest(held: Held, count: int, theta: Array) -> Array:
    """The largest lift (n,) to which any of ``count`` points holds at cam angles (n,)."""
    lift = np.empty(theta.size)
    every = np.arange(0, count, COARSE)
    beside = np.arange(-2 * COARSE, 2 * COARSE + 1)
    step = max(1, TOGETHER // max(every.size, beside.size))
    for first in range(0, theta.size, step):
        some = theta[first : first + step]
        best = every[held(some, np.broadcast_to(every, (some.size, every.size))).argmax(axis=1)]
        lift[first : first + step] = held(some, (best[:, None] + beside) % count).max(axis=1)
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


def _fixed(disc: Disc, contour: Array, theta: Array, rows: Rows) -> tuple[Array, Array]:
    """Points in the fixed frame at cam angles, both (angles, points)."""
    cosine, sine = np.cos(theta)[:, None], disc.sense * np.sin(theta)[:, None]
    x, y = contour[0][rows], contour[1][rows]
    return cosine * x - sine * y, sine * x + cosine * y


def _against(
    of: Callable[[Array, Array], Array], disc: Disc, contour: Array, theta: Array, rows: Rows, never: float = -np.inf
) -> Array:
    """The lift (angles, points) at which the follower touches points; ``never`` where it doesn't."""
    with np.errstate(invalid="ignore"):
        held = of(*_fixed(disc, contour, theta, rows))
    return np.where(np.isnan(held), never, held)
