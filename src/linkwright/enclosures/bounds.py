"""Bounds of polynomials over h in -1 .. 1 that are tight to round-off at smooth extremes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ROUND = 2.0**-53
"""The relative error of one operation."""
UP = 1.0 + 1e-13
"""Bounds are sums and products of a few dozen numbers that aren't negative: this covers their own round-off."""

PARTS = 16
"""Into how many parts of h each panel is cut."""
STEPS = 3
"""Newton steps towards a part's stationary point."""


def evaluated(c: Array, h: Any) -> Array:
    """Polynomials at places, by Horner's rule."""
    total = c[-1]
    for row in c[-2::-1]:
        total = total * h + row
    return np.asarray(total)


def bounds(c: Array) -> tuple[Array, Array]:
    """Bounds (low, high) of polynomials (terms, panels)."""
    return -above(-c)[0], above(c)[0]


def above(c: Array) -> tuple[Array, Array]:
    """An upper bound of each polynomial, and the h of a value near it: (panels,) each.

    On each part the polynomial is monotone or convex, with its largest value at an end; or concave, below any of its
    tangents; or else below its Taylor polynomial there.
    """
    terms = len(c)
    if terms == 1:
        return c[0], np.zeros_like(c[0])
    size = np.add.reduce(np.abs(c), axis=0) * UP
    slack = 4 * (terms + 2) * ROUND * size
    k = np.arange(terms, dtype=float)[:, None]
    first, second = (k * c)[1:], (k * (k - 1) * c)[2:] if terms > 2 else np.zeros_like(c[:1])
    third = np.add.reduce(np.abs((k * (k - 1) * (k - 2) * c)[3:]), axis=0) if terms > 3 else np.zeros_like(size)
    ends = np.linspace(-1.0, 1.0, PARTS + 1)
    middles, d = 0.5 * (ends[:-1] + ends[1:]), 1.0 / PARTS
    at_ends = evaluated(c[:, None, :], ends[:, None])
    slope, bend = (
        np.broadcast_to(evaluated(f[:, None, :], middles[:, None]), (PARTS, c.shape[1])) for f in (first, second)
    )
    # Of the derivatives' own round-off: they only decide, so they are asked to be clear of it.
    noise = terms * terms * slack
    low, high = bend - third * d - noise, bend + third * d + noise
    steep = np.abs(slope) > (np.maximum(np.abs(low), np.abs(high)) * d + noise) * UP
    bound = np.maximum(at_ends[:-1], at_ends[1:])
    place = np.argmax(at_ends, axis=0)
    reached, at = np.take_along_axis(at_ends, place[None], axis=0)[0], ends[place]
    rest = ~steep & (low <= 0)
    part, panel = np.nonzero(rest)
    if part.size:
        some, h = c[:, panel], middles[part]
        left, right = ends[part], ends[part + 1]
        concave = high[part, panel] < 0
        for _ in range(STEPS):
            with np.errstate(all="ignore"):
                step = evaluated(first[:, panel], h) / evaluated(second[:, panel], h)
            h = np.where(concave, np.clip(h - np.nan_to_num(step), left, right), h)
        value, tilt = evaluated(some, h), evaluated(first[:, panel], h)
        most = np.maximum(np.abs(low), np.abs(high))[part, panel]
        # Below the tangent; below the Taylor polynomial, whose curvature is at most that much.
        tangent = np.abs(tilt) + noise[panel]
        far = np.maximum(right - h, h - left)
        over = value + tangent * far + np.where(concave, 0.0, 0.5 * most * far * far)
        bound[part, panel] = np.maximum(bound[part, panel], over)
        best = np.argsort(value, kind="stable")  # the largest is written last
        better = value[best] > reached[panel[best]]
        reached[panel[best][better]], at[panel[best][better]] = value[best][better], h[best][better]
    return bound.max(axis=0) + slack, at
