"""Elementary functions of Taylor models: a Taylor polynomial around the middle value, with Lagrange's remainder."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import factorial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures.bounds import UP
from linkwright.enclosures.panels import PRECISE
from linkwright.enclosures.taylor import (
    FUNCTIONS,
    ONE,
    TINY,
    UNITS,
    ZERO,
    Function,
    TaylorModel,
    lift,
    product,
    root_series,
    rounding,
)

Array = NDArray[np.float64]


def ulps(x: TaylorModel) -> float:
    """The relative error of NumPy's elementary functions, whose vector forms state 4 units in the last place: 8."""
    return 16 * UNITS[x.c.dtype.char]


def register(*names: str) -> Callable[[Function], Function]:
    """Register a function under its NumPy names."""

    def add(function: Function) -> Function:
        for name in names:
            assert name not in FUNCTIONS
            FUNCTIONS[name] = function
        return function

    return add


def composed(x: TaylorModel, terms: Sequence[Array], error: Array | float, last: Array) -> TaylorModel:
    """g(x) from the Taylor coefficients ``terms`` of g at x's first coefficient, each known to an ``error``, and a
    bound ``last`` of the next one all over x's range."""
    away = TaylorModel(np.concatenate([np.zeros_like(x.c[:1]), x.c[1:]]), x.r, x.on)
    bound = away.magnitude_bound
    found = TaylorModel(terms[-1][None], np.zeros_like(bound), x.on)
    for term in terms[-2::-1]:
        found = found * away + TaylorModel(term[None], np.zeros_like(bound), x.on)
    powers = sum((bound**k for k in range(1, len(terms))), np.ones_like(bound))
    r = found.r + error * powers + last * bound ** len(terms) + TINY
    return TaylorModel(found.c, r * UP, x.on)


def _order(x: TaylorModel) -> int:
    """How many terms beyond the first are worth their while."""
    return x.on.order if x.on is not None and len(x.c) > 1 else 1


@register("sin")
def sin(x: Any) -> TaylorModel:
    """Sine."""
    return wave(lift(x), 0)


@register("cos")
def cos(x: Any) -> TaylorModel:
    """Cosine."""
    return wave(lift(x), 1)


def wave(x: TaylorModel, order: Any) -> TaylorModel:
    """A derivative of the sine by its argument; the order may differ from panel to panel."""
    n = _order(x)
    s, c = np.sin(x.c[0]), np.cos(x.c[0])
    four = np.stack([s, c, -s, -c])
    if np.ndim(order):
        four = four[(np.arange(4)[:, None] + order) % 4, np.arange(s.size)]
        order = 0
    terms = [four[(k + order) % 4] / factorial(k) for k in range(n + 1)]
    return composed(x, terms, ulps(x), np.full_like(x.c[0], 1 / factorial(n + 1)))


@register("tan")
def tan(x: Any) -> TaylorModel:
    """Tangent."""
    return sin(x) / cos(x)


@register("exp")
def exp(x: Any) -> TaylorModel:
    """Power of e."""
    x = lift(x)
    n = _order(x)
    value = np.exp(x.c[0])
    most = np.exp(x.c[0] + x.spread()) * (1 + 1e-12)
    return composed(x, [value / factorial(k) for k in range(n + 1)], 2 * ulps(x) * value, most / factorial(n + 1))


@register("log")
def log(x: Any) -> TaylorModel:
    """Natural logarithm: that of the first coefficient, and that of the argument over it, which is near 1."""
    x = lift(x)
    n = _order(x)
    with np.errstate(all="ignore"):
        value, over = np.log(x.c[0]), 1.0 / x.c[0]
        none = np.zeros_like(over)
        near = x * TaylorModel(over[None], none, x.on)
        least = near.c[0] - near.spread()
        least = np.where((least > 0) & (x.c[0] > 0), least * (1 - 1e-12), np.nan)
        terms = [np.log(near.c[0]), *(-((-1.0 / near.c[0]) ** k) / k for k in range(1, n + 1))]
        rest = composed(near, terms, 16 * ulps(x), 1 / ((n + 1) * least ** (n + 1)))
    # The logarithm of the rounded inverse is that of the first coefficient to round-off, which is counted here.
    return rest + TaylorModel(value[None], none + 3 * ulps(x) * (np.abs(value) + 1), x.on)


@register("sqrt")
def sqrt(x: Any) -> TaylorModel:
    """Square root: a series s, and its error from what s^2 misses, over s. Undecided where the argument may be 0."""
    x = lift(x)
    with np.errstate(all="ignore"):
        s = root_series(x.c, x.on.order if x.on is not None else 0)
        found = TaylorModel(s, np.zeros_like(s[0]), x.on)
        off = -product(s, s)
        off[: len(x.c)] += x.c
        d = np.add.reduce(np.abs(off), axis=0) * UP + rounding(found, found) + x.r
        d = d * UP
        least = (2 * np.abs(s[0]) - found.size) * (1 - 1e-13)
        found.r = np.where((least > 0) & (least * least * (1 - 1e-13) > d), d / least * UP + TINY, np.nan)
    return ZERO if x.is_zero() else found


@register("arctan")
def arctan(x: Any) -> TaylorModel:
    """Arc tangent: its slope is the imaginary part of w = 1 / (x - i), its k-th coefficient that of -(-w)^k / k."""
    x = lift(x)
    n = _order(x)
    w = 1.0 / (x.c[0] - 1j)
    powers = [w]
    for _ in range(n - 1):
        powers.append(powers[-1] * -w)
    terms = [np.arctan(x.c[0]), *(power.imag / k for k, power in enumerate(powers, start=1))]
    least = np.maximum(np.abs(x.c[0]) - x.spread(), 0.0)
    last = (1 + 1e-12) / (n + 1) * (1.0 + least * least) ** (-0.5 * (n + 1))
    return composed(x, terms, 4 * ulps(x), last)


@register("arctan2")
def arctan2(y: Any, x: Any) -> TaylorModel:
    """The angle of the vector (x, y); across the cut it lies between -pi and pi."""
    y, x = lift(y), lift(x)
    found = continuous_angle(y, x)
    on = y.on or x.on
    if on is None:
        return found
    low, high = found.range()
    with np.errstate(invalid="ignore"):
        # Away from the negative axis, or on one side of it all over the panel.
        sure = (np.maximum(np.abs(low), np.abs(high)) < 3.141592) | (y.sign() != 0)
    if sure.all():
        return found
    c = np.where(sure, found.c, 0.0)
    return TaylorModel(c, where_bounded(np.where(sure, found.r, 3.1415926535897936), y, x), on)


def continuous_angle(y: TaylorModel, x: TaylorModel) -> TaylorModel:
    """The angle of a vector, from its value in the middle on without jumps: past pi where it goes there.

    The vector is turned back by that value; what is left is an arc tangent.
    """
    start = np.arctan2(y.c[0], x.c[0])
    on = y.on or x.on
    none = np.zeros_like(start)
    c, s = (TaylorModel(f(start)[None], none + ulps(y + x), on) for f in (np.cos, np.sin))
    ahead, aside = x * c + y * s, y * c - x * s
    clear = ahead.sign() > 0
    found = arctan(aside / ahead) + TaylorModel(start[None], none, on)
    return TaylorModel(found.c, np.where(clear, found.r, np.nan), on)


@register("arcsin")
def arcsin(x: Any) -> TaylorModel:
    """Arc sine; undecided where the argument may be 1 or -1."""
    x = lift(x)
    return arctan(x / sqrt((1.0 - x) * (1.0 + x)))


HALF_PI = TaylorModel.number(np.arctan(np.longdouble(1.0)) * 2, 1e-18 if PRECISE else 2e-16, np.longdouble)


@register("arccos")
def arccos(x: Any) -> TaylorModel:
    """Arc cosine; undecided where the argument may be 1 or -1."""
    angle = arcsin(x)
    return TaylorModel.number(np.pi / 2, 6.2e-17) - angle if angle.c.dtype.char == "d" else HALF_PI - angle


@register("hypot")
def hypot(x: Any, y: Any) -> TaylorModel:
    """The length of a vector, 0 included."""
    squares = square(x) + square(y)
    found = sqrt(squares)
    if np.isfinite(found.r).all():
        return found
    with np.errstate(invalid="ignore"):
        most = np.sqrt(squares.magnitude_bound) * UP
    clear = np.isfinite(found.r)
    c = np.where(clear, found.c, 0.0)
    c[0] = np.where(clear, found.c[0], 0.5 * most)
    return TaylorModel(c, where_bounded(np.where(clear, found.r, 0.5 * most * UP + TINY), squares), found.on)


@register("square")
def square(x: Any) -> TaylorModel:
    """Square."""
    found = lift(x)
    return found * found


# What has kinks or jumps: decided by signs, bounded where these aren't.


def where_bounded(r: Array, *args: TaylorModel) -> Array:
    """A bound, where all arguments are bounded; NaN where one may have no value."""
    for x in args:
        r = np.where(np.isfinite(x.r), r, np.nan)
    return r


@register("abs", "fabs", "absolute")
def absolute(x: Any) -> TaylorModel:
    """Magnitude."""
    x = lift(x)
    sign = x.sign()
    if x.on is None and x.is_zero():
        return ZERO
    low, high = x.range()
    clear = sign != 0
    c = np.where(clear, sign * x.c, 0.0)
    most = np.maximum(np.abs(low), np.abs(high))
    c[0] = np.where(clear, c[0], 0.5 * most)
    return TaylorModel(c, where_bounded(np.where(clear, x.r, 0.5 * most * UP + TINY), x), x.on)


@register("maximum", "fmax")
def maximum(a: Any, b: Any) -> TaylorModel:
    """The larger."""
    return _picked(lift(a), lift(b), (lift(a) - b).sign(), 1.0)


@register("minimum", "fmin")
def minimum(a: Any, b: Any) -> TaylorModel:
    """The smaller."""
    return _picked(lift(a), lift(b), (lift(b) - a).sign(), -1.0)


def _picked(a: TaylorModel, b: TaylorModel, sign: Array, way: float) -> TaylorModel:
    """a where the sign is 1, b where it is -1; else both with half their distance: (a + b +- |a - b|) / 2."""
    if (sign > 0).all():
        return a
    if (sign < 0).all():
        return b
    both = 0.5 * (a + b + way * absolute(a - b))
    return _chosen(sign, (a, b, both), a.on or b.on)


def _chosen(sign: Array, cases: tuple[TaylorModel, TaylorModel, TaylorModel], on: Any) -> TaylorModel:
    """The first where a sign is 1, the second where it is -1, else the third."""
    terms, wide = max(len(m.c) for m in cases), max(m.c.shape[1] for m in cases)
    wide = max(wide, sign.size)
    c, r = np.zeros((terms, wide), dtype=np.result_type(*(m.c for m in cases))), np.zeros(wide)
    for model, here in zip(cases, (sign > 0, sign < 0, sign == 0), strict=True):
        here = np.broadcast_to(here, (wide,))
        c[: len(model.c)] = np.where(here, model.c, c[: len(model.c)])
        r = np.where(here, model.r, r)
    return TaylorModel(c, r, on)


@register("where")
def where(condition: Any, first: Any, second: Any) -> TaylorModel:
    """One of two by a condition of 1 or 0; both where that is undecided."""
    flag, a, b = lift(condition), lift(first), lift(second)
    with np.errstate(invalid="ignore"):
        low, high = flag.range()
        sign = np.where(low > 0.5, 1.0, np.where(high < 0.5, -1.0, 0.0))
    on = flag.on or a.on or b.on
    if (sign > 0).all():
        return a
    if (sign < 0).all():
        return b
    # Between the two: their middle and half their distance.
    half = 0.5 * (a - b)
    middle = 0.5 * (a + b)
    return _chosen(
        sign, (a, b, TaylorModel(middle.c, where_bounded(middle.r + half.magnitude_bound, flag), middle.on)), on
    )


@register("less")
def less(a: Any, b: Any) -> TaylorModel:
    """1 where a < b, 0 where not."""
    return _truth((lift(b) - a), 0.0)


@register("less_equal")
def less_equal(a: Any, b: Any) -> TaylorModel:
    """1 where a <= b, 0 where not."""
    return _truth((lift(b) - a), 1.0)


@register("equal")
def equal(a: Any, b: Any) -> TaylorModel:
    """1 where a = b, 0 where not."""
    away = lift(a) - b
    return ONE if away.is_zero() else _flag(np.where(away.sign() != 0, 0.0, 0.5), away)


@register("not_equal")
def not_equal(a: Any, b: Any) -> TaylorModel:
    """1 where a isn't b, 0 where it is."""
    return ONE - equal(a, b)


def _truth(above: TaylorModel, at_zero: float) -> TaylorModel:
    if above.is_zero():
        return TaylorModel.number(at_zero)
    sign = above.sign()
    return _flag(np.where(sign > 0, 1.0, np.where(sign < 0, 0.0, 0.5)), above)


def _flag(value: Array, of: TaylorModel) -> TaylorModel:
    """1, 0, or 0.5 where either may be."""
    return TaylorModel(value[None], where_bounded(np.where(value == 0.5, 0.5, 0.0), of), of.on)


@register("logical_and")
def logical_and(a: Any, b: Any) -> TaylorModel:
    """1 where both are."""
    return where(a, where(b, ONE, ZERO), ZERO)


@register("logical_or")
def logical_or(a: Any, b: Any) -> TaylorModel:
    """1 where one is."""
    return where(a, ONE, where(b, ONE, ZERO))


@register("logical_not")
def logical_not(a: Any) -> TaylorModel:
    """1 where it is 0."""
    return where(a, ZERO, ONE)


@register("sign")
def sign(x: Any) -> TaylorModel:
    """-1, 0 or 1."""
    x = lift(x)
    if x.is_zero():
        return ZERO
    found = x.sign()
    return TaylorModel(found[None], where_bounded(np.where(found == 0, 1.0, 0.0), x), x.on)


@register("copysign")
def copysign(x: Any, y: Any) -> TaylorModel:
    """The size of x with the sign of y."""
    x, y = lift(x), lift(y)
    if y.is_zero():
        return absolute(x)
    return absolute(x) * sign(y)


@register("floor")
def floor(x: Any) -> TaylorModel:
    """The whole number below."""
    x = lift(x)
    with np.errstate(invalid="ignore"):
        whole = np.floor(x.c[0])
        below = x - TaylorModel(whole[None], np.zeros_like(whole), x.on)
        above = ONE - below
        sure = (below.sign() >= 0) & (above.sign() > 0) & ((below.sign() > 0) | (below.size + below.r == 0))
        low, high = (np.floor(end) for end in x.range())
    r = where_bounded(np.where(sure, 0.0, 0.5 * (high - low) + TINY), x)
    return TaylorModel(np.where(sure, whole, 0.5 * (low + high))[None], r, x.on)


@register("if_else_zero")
def if_else_zero(condition: Any, value: Any) -> TaylorModel:
    """The value where a condition holds, 0 elsewhere."""
    return where(condition, value, ZERO)
