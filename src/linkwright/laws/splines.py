"""Splines as curves: through points, and B-splines of control points."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.laws.curve import Curve
from linkwright.laws.pieces import Piece

Array = NDArray[np.float64]


def spline(x: Array, y: Array, degree: int, start: Sequence[float], end: Sequence[float]) -> Curve:
    """The spline of odd degree through points with ascending x; ``start`` and ``end`` are its first derivatives there,
    (degree - 1)/2 of them."""
    from scipy.interpolate import make_interp_spline

    conditions = tuple([(order, value) for order, value in enumerate(ends, start=1)] for ends in (start, end))
    return _curve(make_interp_spline(x, y, k=degree, bc_type=conditions))


def b_spline(control: Sequence[float], degree: int) -> Curve:
    """The curve over 0..1 of evenly spread control values, the first and last of which it meets.

    Its end velocities are degree/(knot step) times the first and last difference of these; more equal values at an end
    make more derivatives zero there.
    """
    from scipy.interpolate import BSpline

    inner = np.linspace(0, 1, len(control) - degree + 1)
    knots = np.concatenate([np.zeros(degree), inner, np.ones(degree)])
    return _curve(BSpline(knots, np.asarray(control, dtype=float), degree))


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
