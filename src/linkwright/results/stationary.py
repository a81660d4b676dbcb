"""Where signals are stationary: roots of exact rates between brackets of a grid that is doubled until it holds."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

FIRST_STEPS, LATEST_FIRST, MAX_STEPS = 1 << 6, 1 << 13, 1 << 15
HUGE = 1e150
MOST_LOOKS = 200
EDGE = 1e-3
"""A first look is no nearer to an end of its bracket than this share of it."""
NOISE = 1e-10
"""A rate below this share of its largest magnitude doesn't count as a sign."""
STILL = 1e-11
"""A row whose rate lets it vary by less than this share of its size only varies by round-off."""


@dataclass(frozen=True)
class Changes:
    """Changes of sign between neighbouring places of a grid: row, index before, index after, each (n,)."""

    who: Rows
    before: Rows
    after: Rows


def changes(f: Array, counts: NDArray[np.bool_] | None = None) -> Changes:
    """Where rows (rows, places) clearly change sign, of those rows that count. Values within round-off of zero have no
    reliable sign and are passed over."""
    largest = _largest(f)[:, None]
    with np.errstate(invalid="ignore"):
        clear = np.abs(f) > NOISE * largest  # never of NaN
    if counts is not None:
        clear &= counts[:, None]
    # Of each place, the last clear one up to it.
    last = np.maximum.accumulate(np.where(clear, np.arange(f.shape[1]), -1), axis=1)
    who, after = np.nonzero(clear[:, 1:] & (last[:, :-1] >= 0))
    before, after = last[who, after], after + 1
    turned = (f[who, before] > 0) != (f[who, after] > 0)
    return Changes(who[turned], before[turned], after[turned])


def turns(values: Array, slopes: Array, length: Array | float, scales: Array | float = 0.0) -> Changes:
    """Where the rates of rows change sign, of those rows that vary by more than round-off over their ``length`` (s);
    ``scales`` (rows,) are the sizes of what cancels in each row where the row itself is smaller."""
    return changes(slopes, _largest(slopes) * length > STILL * np.maximum(_largest(values), scales))


def _largest(values: Array) -> Array:
    """The largest finite magnitude of each row."""
    return np.asarray(np.where(np.isfinite(values), np.abs(values), 0.0).max(axis=1, initial=0.0))


def stationary(
    rates: Callable[[Array], tuple[Array, Array]],
    start: float,
    stop: float,
    steps: int,
    scales: Sequence[float] | None = None,
    alone: bool = False,
) -> list[Array]:
    """The times in ``start`` .. ``stop`` at which each row's rate changes sign, to round-off. ``scales`` (rows,) are
    the sizes of what cancels in each row where the row itself is smaller.

    ``rates(t)`` gives (values, rates), each (rows, times). The grid starts near ``steps`` and is doubled until each
    row's count of brackets has stayed the same twice; rows that only vary by round-off have none. With ``alone`` each
    row has the grid that it would have by itself.
    """
    found = _settled(_turning_brackets(rates, scales), start, stop, steps, alone)
    return roots(lambda at: rates(at)[1], [brackets for brackets, _ in found])


def fineness(
    rates: Callable[[Array], tuple[Array, Array]],
    start: float,
    stop: float,
    steps: int,
    scales: Sequence[float] | None = None,
) -> list[int]:
    """The steps on which the count of each row's brackets has stayed the same twice; :data:`MAX_STEPS` if never.
    ``scales`` are the sizes of what cancels in each row, as :func:`turns` has them."""
    return [needed for _, needed in _settled(_turning_brackets(rates, scales), start, stop, steps, alone=True)]


def _turning_brackets(
    rates: Callable[[Array], tuple[Array, Array]], scales: Sequence[float] | None = None
) -> Callable[[Array], list[Array]]:
    """What gives the brackets of each row's turning points on a grid."""

    def look(t: Array) -> list[Array]:
        values, slopes = rates(t)
        scale = 0.0 if scales is None else np.asarray(scales)
        return _brackets(t, turns(values, slopes, t[-1] - t[0], scale), len(values))

    return look


def magnitude(values: Array, slopes: Array) -> tuple[Array, Array]:
    """Magnitudes with their rates, so that a passage through zero is a turning point too."""
    with np.errstate(invalid="ignore"):
        return np.abs(values), np.sign(values) * slopes


def crossings(values: Callable[[Array], Array], start: float, stop: float, steps: int) -> Array:
    """The times at which one function of time changes sign, found the same way without its rate."""
    ((brackets, _),) = _settled(lambda t: _brackets(t, changes(values(t)[None]), 1), start, stop, steps)
    return roots(lambda at: values(at)[None, :], [brackets])[0]


def _settled(
    look: Callable[[Array], list[Array]], start: float, stop: float, steps: int, alone: bool = False
) -> list[tuple[Array, int]]:
    """The brackets that ``look`` finds on a grid, doubled until their counts have stayed the same twice: of all rows
    at once, or with ``alone`` of each; and the steps of that grid, :data:`MAX_STEPS` where they never have."""
    counts: list[list[int]] = []
    settled: dict[int, tuple[Array, int]] = {}
    steps = min(max(steps, FIRST_STEPS), LATEST_FIRST)
    while True:
        t = np.linspace(start, stop, steps + 1)
        # Look at the grid and count the sign changes of each row.
        brackets = look(t)
        counts.append([len(b) for b in brackets])
        # Three equal counts on grids that were doubled each time: no sign change has been missed so far.
        same = [len(last) == 3 and len(set(last)) == 1 for last in zip(*counts[-3:], strict=True)]
        for row, found in enumerate(brackets):
            if same[row] and (alone or all(same)):
                settled.setdefault(row, (found, steps))
        if len(settled) == len(brackets) or steps >= MAX_STEPS:
            return [settled.get(row, (found, MAX_STEPS)) for row, found in enumerate(brackets)]
        steps *= 2


def _brackets(t: Array, found: Changes, rows: int) -> list[Array]:
    """The pairs of neighbouring times at which each row clearly has opposite signs: (brackets, 2) each."""
    ends = np.stack([t[found.before], t[found.after]], axis=1)
    return [ends[found.who == row] for row in range(rows)]


def roots(f: Callable[[Array], Array], brackets: list[Array]) -> list[Array]:
    """One root in each bracket of each row, all at once."""
    rows = np.repeat(np.arange(len(brackets)), [len(b) for b in brackets])
    if rows.size == 0:
        return [np.empty(0) for _ in brackets]

    def chosen(t: Array, row: Rows) -> Array:
        return np.asarray(f(t)[row, np.arange(t.size)])

    x = bracketed(chosen, rows, *np.concatenate(brackets).T)
    return [np.sort(x[rows == row]) for row in range(len(brackets))]


def bracketed(
    f: Callable[[Array, Rows], Array],
    rows: Rows,
    low: Array,
    high: Array,
    first: Array | float = 0.5,
    near: Array | float = 4e-16,
) -> Array:
    """One root of ``f(t, row)`` in each bracket (n,), each by itself; ``first`` is where to look first, as a share of
    it, ``near`` how near to look, as a share of its ends: to round-off.

    Inverse quadratic interpolation where it is safe, else bisection: Chandrupatla, Advances in Engineering Software
    28 (1997) 145, as written out by Scherer, Computational Physics (2010), 6.1.7.3.
    """

    def finite(t: Array, row: Rows) -> Array:
        return np.asarray(np.nan_to_num(f(t, row), posinf=HUGE, neginf=-HUGE))

    # a and b always enclose the root; c is the third point that inverse quadratic interpolation needs.
    a, b, c = low, high, high
    fa, fb = finite(a, rows), finite(b, rows)
    fc = fb
    share = np.broadcast_to(np.clip(np.nan_to_num(first, nan=0.5), EDGE, 1 - EDGE), low.shape)
    tolerance = near * np.maximum(np.abs(low), np.abs(high))
    open_ = np.arange(low.size)  # the brackets that are looked at, and which of them aren't closed yet
    # An end whose sign is round-off had the other one when it was looked at before: it is the root.
    going = np.sign(fa) * np.sign(fb) < 0
    found = np.where(np.abs(fa) <= np.abs(fb), a, b)
    for _ in range(MOST_LOOKS):
        if not going.any():
            break
        # Once less than half of the brackets are open, continue with those alone.
        if 2 * np.count_nonzero(going) < going.size:  # rarely, as kernels like calls of the same size
            some = going
            open_, rows, going = open_[some], rows[some], going[some]
            a, b, c, fa, fb, fc, share, tolerance = (v[some] for v in (a, b, c, fa, fb, fc, share, tolerance))
        # Evaluate at the chosen share of the bracket.
        x = a + share * (b - a)
        fx = finite(x, rows)
        # Keep the pair of points with opposite signs as the new bracket; the discarded one becomes c.
        same = np.sign(fx) == np.sign(fa)
        c, fc = np.where(same, a, b), np.where(same, fa, fb)
        b, fb = np.where(same, b, a), np.where(same, fb, fa)
        a, fa = x, fx
        # The better end is the current estimate. A bracket is closed when it is narrower than its tolerance or a root
        # is hit.
        found[open_[going]] = np.where(np.abs(fa) <= np.abs(fb), a, b)[going]
        width = np.abs(b - a)
        going = going & (width > tolerance) & (fa != 0)
        with np.errstate(all="ignore"):
            # Chandrupatla's criterion: interpolate only if the inverse parabola through the three points is monotone
            # in the bracket, else bisect.
            xi, phi = (a - b) / (c - b), (fa - fb) / (fc - fb)
            safe = (phi**2 < xi) & ((1 - phi) ** 2 < 1 - xi)
            inverse = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
            least = 0.5 * tolerance / width
            share = np.where(safe, np.clip(inverse, least, 1 - least), 0.5)
    return found
