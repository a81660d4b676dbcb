"""The profile as cubic splines within a tolerance: one for each piece of the law, smooth within it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import Disc, inside
from linkwright.cam.nc.path import Sharp
from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

FIRST, MOST = 8, 4096
"""Spans of a spline: they are doubled until it is close enough."""
BETWEEN = 8
"""Places of a span at which the spline is held against the profile."""


@dataclass(frozen=True)
class Spline:
    """A clamped cubic B-spline in the disc's axes: ``knots`` (n + 4,) and control points ``points`` (2, n), m."""

    knots: Array
    points: Array


def splines(disc: Disc, tolerance: float, offset: float | None = None) -> list[Spline]:
    """The profile, or the curve ``offset`` (m) outward of the pitch curve, end to end, within ``tolerance`` (m); with
    growing cam angle. Directions at the ends of each are exact. Raises Sharp where no spline comes so near."""
    by = -disc.follower.radius if offset is None else offset
    return [_spline(disc, start, stop, tolerance, by) for start, stop in disc.pieces]


def _spline(disc: Disc, start: float, stop: float, tolerance: float, by: float) -> Spline:
    from scipy.interpolate import make_interp_spline

    spans = FIRST
    while True:
        theta = np.linspace(start, stop, spans * BETWEEN + 1)
        look = disc.look(inside(theta, start, stop))
        places, normal = look.offset(by), look.offset(by + 1.0) - look.offset(by)
        rates = np.array([p.d[1] + by * n.d[1] for p, n in zip(look.pitch, look.normal, strict=True)])
        ends = ([(1, rates[:, 0])], [(1, rates[:, -1])])
        made = make_interp_spline(theta[::BETWEEN], places[:, ::BETWEEN].T, k=3, bc_type=ends)
        off = np.abs(((made(theta).T - places) * normal).sum(axis=0)).max()
        if off <= tolerance:
            return Spline(made.t, made.c.T)
        if spans >= MOST:
            raise Sharp(start)
        spans *= 2
