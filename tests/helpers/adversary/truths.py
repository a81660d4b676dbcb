"""The true extremes of an expression whose features are known: where they are, and over how long each goes.

Doubles choose the brackets on a grid that gets finer towards each feature; mpmath finds the value in them, the limits
from both sides of each feature, and whether they are finite.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import mpmath
import numpy as np
from mpmath import mp
from numpy.typing import NDArray

from helpers.adversary.trees import ROUND, Tree

Array = NDArray[np.float64]
NEAR = mpmath.mpf("1e-20"), mpmath.mpf("1e-18")
"""How near to a feature limits are taken, over the length of the run."""
BASE = 600
"""Grid points over a window, besides those near the features."""


@dataclass(frozen=True)
class Mark:
    """A place (s) at which an expression does something, and over how long (s)."""

    time: Any
    scale: float


@dataclass(frozen=True)
class Place:
    """A one-sided limit: ``side`` is -1 before and +1 after the time (s); ``value`` may be infinite."""

    time: Any
    side: int
    value: Any


@dataclass(frozen=True)
class Extreme:
    """A lowest or highest value; its places where it is infinite, its time and its round-off where it is finite."""

    value: float
    time: float
    noise: float
    places: tuple[tuple[float, int], ...] = ()


@dataclass(frozen=True)
class Bounds:
    """The lowest and the highest value over a window, and the size of the finite values between them."""

    low: Extreme
    high: Extreme
    size: float
    lone: bool = False
    """Whether it has a value somewhere that it doesn't come near: that may count or not."""


def bounds(f: Tree, spans: Sequence[tuple[Any, Any]], marks: Sequence[Mark]) -> Bounds:
    """The true bounds of an expression over some spans of time (s); limits from one side count."""
    limits = [place for mark in marks for place in _limits(f, spans, mark)]
    t, values = grid(f, spans, marks)
    inner = values[np.isfinite(values)]
    middle = float(np.median(inner)) if inner.size else 0.0
    low, high = (_extreme(f, spans, marks, limits, t, values, sign) for sign in (-1, 1))
    finite = [one.value for one in (low, high) if np.isfinite(one.value)]
    size = max((abs(one - other) for one in (*finite, middle) for other in (*finite, middle)), default=0.0)
    spread = float(np.median(np.abs(inner - middle))) if inner.size else 0.0
    return Bounds(low, high, max(size, spread), _lone(f, spans, marks, limits))


def _lone(f: Tree, spans: Sequence[tuple[Any, Any]], marks: Sequence[Mark], limits: Sequence[Place]) -> bool:
    for mark in marks:
        beside = [place.value for place in limits if place.time == mark.time]
        value = f.exact(mark.time)
        if (
            beside
            and all(map(mpmath.isfinite, (value, *beside)))
            and not any(abs(value - one) < 1e-6 * (1 + abs(value)) for one in beside)
        ):
            return True
    return False


def grid(f: Tree, spans: Sequence[tuple[Any, Any]], marks: Sequence[Mark]) -> tuple[Array, Array]:
    """Times inside the spans, finer towards each mark, and the values in doubles."""
    parts = []
    for a, b in spans:
        low, high = float(a), float(b)
        near = [np.linspace(low, high, BASE + 1)]
        for mark in marks:
            p, reach = float(mark.time), high - low
            start = max(mark.scale * 1e-3, 4 * np.spacing(abs(p) + reach))
            far = max(2 * start, abs(low - p), abs(high - p))
            steps = np.geomspace(start, far, 16 * int(np.log10(far / start) + 2))
            near += [p - steps, p + steps, np.linspace(p - 2 * mark.scale, p + 2 * mark.scale, 81)]
        t = np.unique(np.concatenate(near))
        parts.append(t[(t >= low) & (t <= high)])
    t = np.concatenate(parts)
    return t, f.plain(t)


def _limits(f: Tree, spans: Sequence[tuple[Any, Any]], mark: Mark) -> list[Place]:
    """The limits from those sides of a mark that lie inside a span."""
    found = []
    for a, b in spans:
        for side in (-1, 1):
            near, far = (mark.time + side * (b - a) * step for step in NEAR)
            if not a <= far <= b or not a <= near <= b:
                continue
            value, before = f.exact(near), f.exact(far)
            if mpmath.isnan(value):
                continue
            infinite = mpmath.isinf(value) or abs(value) > abs(before) + abs(value) * mpmath.mpf("1e-3")
            found.append(Place(mark.time, side, mp.inf * mpmath.sign(value) if infinite else value))
    return found


def _extreme(
    f: Tree,
    spans: Sequence[tuple[Any, Any]],
    marks: Sequence[Mark],
    limits: Sequence[Place],
    t: Array,
    values: Array,
    sign: int,
) -> Extreme:
    infinite = [place for place in limits if place.value == sign * mp.inf]
    if infinite:
        places = tuple(dict.fromkeys((float(place.time), place.side) for place in infinite))
        return Extreme(sign * np.inf, places[0][0], 0.0, places)
    found = [(place.value, place.time) for place in limits if mpmath.isfinite(place.value)]
    edges = [edge for span in spans for edge in span]
    poles = {place.time for place in limits if mpmath.isinf(place.value)}
    inside = [m.time for m in marks if m.time not in poles and any(a <= m.time <= b for a, b in spans)]
    found += [(value, at) for at in (*edges, *inside) if mpmath.isfinite(value := f.exact(at))]
    found += _peaks(f, spans, t, values, sign)
    value, time = max(found, key=lambda one: sign * one[0])
    return Extreme(float(value), float(time), _noise(f, time, value))


def _noise(f: Tree, time: Any, value: Any) -> float:
    """The round-off of a value; of a limit or at an edge, that of its size and of its time."""
    plain = f.noise(time)
    if np.isfinite(plain):
        return plain
    step = max(2 * abs(time) * ROUND, mpmath.mpf("1e-300"))
    beside = [one for at in (time - step, time + step) if mpmath.isfinite(one := f.exact(at))]
    return float(8 * ROUND * abs(value) + min((abs(one - value) for one in beside), default=0) / 8)


def _peaks(f: Tree, spans: Sequence[tuple[Any, Any]], t: Array, values: Array, sign: int) -> list[tuple[Any, Any]]:
    """The values at the best few tops of the grid, found to many digits."""
    y = np.where(np.isfinite(values), sign * values, -np.inf)
    padded = np.concatenate([[-np.inf], y, [-np.inf]])
    tops = np.flatnonzero((padded[1:-1] >= padded[:-2]) & (padded[1:-1] >= padded[2:]) & np.isfinite(y))
    if not tops.size:
        return []
    # Highest first. Round-off may have made some of them: only exact values count, until no other can be higher.
    middle = float(np.median(y[np.isfinite(y)]))
    exact: list[tuple[Any, int]] = []
    for i in tops[np.argsort(-y[tops], kind="stable")]:
        best = max((value for value, _ in exact), default=-mp.inf)
        if y[i] < best - 0.05 * abs(best - middle):
            break
        value = sign * f.exact(t[i])
        if mpmath.isfinite(value):
            exact.append((value, int(i)))
    found: list[tuple[Any, Any]] = []
    for _, i in sorted(exact, reverse=True)[:4]:
        a, b = next(span for span in spans if float(span[0]) <= t[i] <= float(span[1]))
        left, right = max(a, mpmath.mpf(t[max(i - 2, 0)])), min(b, mpmath.mpf(t[min(i + 2, t.size - 1)]))
        if not any(left <= at <= right for _, at in found):
            found.append(climb(f, left, mpmath.mpf(t[i]), right, sign))
    return [one for one in found if mpmath.isfinite(one[0])]


def climb(f: Tree, a: Any, x: Any, b: Any, sign: int) -> tuple[Any, Any]:
    """The top near x in a..b, by Newton's method on differences, by golden section where that doesn't climb."""
    h = (b - a) * mpmath.mpf("1e-12")
    value = sign * f.exact(x)
    for _ in range(30):
        if not a + h < x < b - h or mpmath.isnan(value):
            break
        before, after = sign * f.exact(x - h), sign * f.exact(x + h)
        curve = (after - 2 * value + before) / h**2
        if mpmath.isnan(curve) or curve >= 0:
            break
        step = -(after - before) / (2 * h) / curve
        if abs(step) < mpmath.mpf("1e-12") * (b - a):
            return sign * value, x
        goal = x + step
        if not a < goal < b or not (higher := sign * f.exact(goal)) >= value:
            break
        x, value = goal, higher
    return _golden(f, a, b, sign)


def _golden(f: Tree, a: Any, b: Any, sign: int) -> tuple[Any, Any]:
    def height(at: Any) -> Any:
        value = f.exact(at)
        return -mp.inf if mpmath.isnan(value) else sign * value

    ratio = (mpmath.sqrt(5) - 1) / 2
    c, d = b - ratio * (b - a), a + ratio * (b - a)
    fc, fd = height(c), height(d)
    for _ in range(80):
        if fc > fd:
            b, d, fd = d, c, fc
            c = b - ratio * (b - a)
            fc = height(c)
        else:
            a, c, fc = c, d, fd
            d = a + ratio * (b - a)
            fd = height(d)
    value, x = max((fc, c), (fd, d), key=lambda one: one[0])
    return sign * value, x
