"""Splines as curves: through points, and B-splines of control points."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import factorial
from typing import Any

import numpy as np

from linkwright.laws.curve import Curve
from linkwright.laws.numbers import plain, solve
from linkwright.laws.pieces import Piece
from linkwright.notation import Scalar


def spline(
    x: Sequence[Scalar], y: Sequence[Scalar], degree: int, start: Sequence[Scalar], end: Sequence[Scalar]
) -> Curve:
    """The spline of odd degree through points with ascending x; ``start`` and ``end`` are its first derivatives there,
    (degree - 1)/2 of them."""
    if not plain(*x, *y, *start, *end):
        return Curve(tuple(_pieces(x, y, degree, start, end)))
    from scipy.interpolate import make_interp_spline

    conditions = tuple([(order, value) for order, value in enumerate(ends, start=1)] for ends in (start, end))
    return _curve(make_interp_spline(np.array(x), np.array(y), k=degree, bc_type=conditions))


def b_spline(control: Sequence[Scalar], degree: int) -> Curve:
    """The curve over 0..1 of evenly spread control values, the first and last of which it meets.

    Its end velocities are degree/(knot step) times the first and last difference of these; more equal values at an end
    make more derivatives zero there.
    """
    from scipy.interpolate import BSpline

    inner = np.linspace(0, 1, len(control) - degree + 1)
    knots = np.concatenate([np.zeros(degree), inner, np.ones(degree)])
    if plain(*control):
        return _curve(BSpline(knots, np.array(control, dtype=float), degree))
    each = [_curve(BSpline(knots, row, degree)).parts for row in np.eye(len(control))]
    pieces = []
    for parts in zip(*each, strict=True):
        powers = zip(*(part.powers for part in parts), strict=True)
        mixed = tuple(sum(c * value for c, value in zip(row, control, strict=True) if c) for row in powers)
        pieces.append(Piece(parts[0].start, parts[0].stop, mixed, (), parts[0].origin))
    return Curve(tuple(pieces))


def _curve(made: Any) -> Curve:
    """SciPy's spline as pieces of powers."""
    from scipy.interpolate import PPoly

    form = PPoly.from_spline(made)
    pieces = [
        Piece(float(a), float(b), tuple(map(float, powers[::-1])), (), float(a))
        for a, b, powers in zip(form.x[:-1], form.x[1:], form.c.T, strict=True)
        if b > a
    ]
    return Curve(tuple(pieces))


def _pieces(
    x: Sequence[Scalar], y: Sequence[Scalar], degree: int, start: Sequence[Scalar], end: Sequence[Scalar]
) -> Iterator[Piece]:
    """The same spline from its derivatives at the points: those that the Hermite polynomials of each two neighbours
    share, such that the higher ones run on. Derivatives are by the argument over the whole width."""
    half, last, whole = (degree - 1) // 2, len(x) - 1, x[-1] - x[0]
    steps = [(b - a) / whole for a, b in pairwise(x)]
    ends = [[rate * whole**k for k, rate in enumerate(side, start=1)] for side in (start, end)]
    weights = _hermite(half)

    def share(i: int, side: int, power: int) -> tuple[list[Scalar], Scalar]:
        """A coefficient of piece i: factors of the unknown derivatives, and what is known."""
        row: list[Scalar] = [0.0] * (half * (last - 1))
        known: Scalar = 0.0
        for k in range(half + 1):
            factor = float(weights[power, side * (half + 1) + k]) * steps[i] ** k
            at = i + side
            if k == 0:
                known = known + factor * y[at]
            elif at in (0, last):
                known = known + factor * ends[at == last][k - 1]
            else:
                row[half * (at - 1) + k - 1] = row[half * (at - 1) + k - 1] + factor
        return row, known

    def coefficient(i: int, power: int) -> tuple[list[Scalar], Scalar]:
        (before, a), (after, b) = share(i, 0, power), share(i, 1, power)
        return [p + q for p, q in zip(before, after, strict=True)], a + b

    rows, right = [], []
    for i in range(1, last):
        for order in range(half + 1, degree):
            # The derivative of the piece before at its end, less that of the piece behind at its start.
            terms = [(coefficient(i - 1, p), factorial(p) / factorial(p - order)) for p in range(order, degree + 1)]
            behind, known = coefficient(i, order)
            scale, other = 1 / steps[i - 1] ** order, factorial(order) / steps[i] ** order
            row = [-(other * b) for b in behind]
            for (part, _), factor in terms:
                row = [r + scale * factor * p for r, p in zip(row, part, strict=True)]
            rows.append(row)
            right.append(other * known - scale * sum(factor * c for (_, c), factor in terms))
    found = solve(rows, right) if rows else []
    for i, (a, b) in enumerate(pairwise(x)):
        powers = []
        for power in range(degree + 1):
            factors, known = coefficient(i, power)
            value = known + sum(f * u for f, u in zip(factors, found, strict=True))
            powers.append(value / (b - a) ** power)
        yield Piece(a, b, tuple(powers), (), a)


def _hermite(half: int) -> Any:
    """Powers of s over 0..1 (rows) from the derivatives 0 to ``half`` at 0, then at 1 (columns)."""
    count = 2 * (half + 1)
    rows = np.zeros((count, count))
    for k in range(half + 1):
        rows[k, k] = factorial(k)
        rows[half + 1 + k] = [factorial(p) / factorial(p - k) if p >= k else 0.0 for p in range(count)]
    return np.linalg.inv(rows)
