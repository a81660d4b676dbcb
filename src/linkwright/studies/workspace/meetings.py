"""Where a platform can be at a place of the working point: at the zeros of its polynomial, where its legs meet.

Between its extrema a polynomial is monotone, and their signs tell whether it has a zero there: so none is missed and
none is found twice. What the nearer extremum leaves is the ``room`` of a zero; two meet where it vanishes.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.notation.harmonics import basis, derivative, zeros
from linkwright.results.stationary import bracketed

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

TOUCH = 1e-8
"""An extremum of less than this share of the coefficients may touch zero."""
PAIRS = ((0, 1), (0, 2), (1, 2))


def zeros_between(coefficients: Array) -> tuple[Array, Array, Rows]:
    """The zeros of polynomials (7, n) between their extrema and the rooms of each, the lesser size of both extrema over
    that of the coefficients, negative where there is no zero: (6, n) both, NaN where there is no such stretch.

    Where an extremum nearly touches zero it is given for a zero, to either side: two poses with one angle may be there.
    Then which of them, 0 or 1, else -1: (6, n)."""
    with np.errstate(all="ignore"):
        coefficients = coefficients / np.abs(coefficients).max(axis=0)
    low = zeros(derivative(coefficients))
    count = np.isfinite(low).sum(axis=0)
    high = np.concatenate([low[1:], np.full_like(low[:1], np.inf)])
    high[np.maximum(count - 1, 0), np.arange(count.size)] = low[0] + 2 * np.pi
    phi, room, which = np.full_like(low, np.nan), np.full_like(low, np.nan), np.full(low.shape, -1)
    slot, of = np.nonzero(np.isfinite(low))

    def values(angle: Array, row: Rows) -> Array:
        return np.asarray((basis(angle) * coefficients[:, of[row]]).sum(axis=0))

    ends = low[slot, of], high[slot, of]
    start, stop = (values(end, np.arange(of.size)) for end in ends)
    nearer = np.abs(stop) <= np.abs(start)
    least = np.where(nearer, np.abs(stop), np.abs(start))
    passed = start * stop < 0
    room[slot, of] = np.where(passed, least, -least)
    some = np.flatnonzero(passed)
    phi[slot[some], of[some]] = bracketed(values, some, ends[0][some], ends[1][some])
    touched = ~passed & (least < TOUCH)
    phi[slot[touched], of[touched]] = np.where(nearer, ends[1], ends[0])[touched]
    which[slot[touched], of[touched]] = nearer[touched]
    return phi, room, which


def meetings(misses: Array, slopes: Array, circles: int) -> tuple[Rows, list[Array]]:
    """Which two of three legs meet at the largest angle, (2, n), and both places where they do, (2, n) each; from what
    they miss at the origin, (3, n), and its slopes there, (3, 2, n). The first legs move on circles, of slopes
    2 (p - m), the others on lines."""
    best, legs = np.full(misses.shape[1], -1.0), np.zeros((2, misses.shape[1]), dtype=int)
    places = np.full((2, 2, misses.shape[1]), np.nan)
    with np.errstate(all="ignore"):
        for i, j in PAIRS:
            normal, off = slopes[j], misses[j]
            if j < circles:  # two circles meet on a line
                normal, off = normal - slopes[i], off - misses[i]
            size = (normal**2).sum(axis=0)
            if i < circles:
                centre = -slopes[i] / 2
                foot = centre - ((normal * centre).sum(axis=0) + off) / size * normal
                rest = (centre**2).sum(axis=0) - misses[i] - ((foot - centre) ** 2).sum(axis=0)
                along = np.sqrt(np.maximum(rest, 0.0) / size) * np.stack([-normal[1], normal[0]])
                found = np.stack([foot + along, foot - along])
            else:
                (a, b), (c, d) = slopes[i], normal
                found = np.stack([b * off - d * misses[i], c * misses[i] - a * off]) / (a * d - b * c)
                found = np.stack([found, np.full_like(found, np.nan)])
            one, other = (slopes[k] + (2 * found[0] if k < circles else 0.0) for k in (i, j))
            sine = (one[0] * other[1] - one[1] * other[0]) ** 2 / ((one**2).sum(axis=0) * (other**2).sum(axis=0))
            better = np.nan_to_num(sine, nan=-1.0) > best
            best = np.where(better, sine, best)
            legs[:, better] = np.array([[i], [j]])
            places[:, :, better] = found[:, :, better]
    return legs, [*places]
