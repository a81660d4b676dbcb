"""Cases: a measure of a mechanism, what it must say, and how narrow its narrowest feature is; many to a document."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import mpmath
import numpy as np
from mpmath import mpf

from helpers.adversary.features import ANGLE, CLOCK, FAMILIES, Draw, Feature, background
from helpers.adversary.trees import ROUND, Tree
from helpers.adversary.truths import Bounds, Extreme, Mark, bounds, grid

UNITS = {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
RELATIVE = 1e-9
"""The most that a finite value may be off, over the range of the values."""
ROUNDS = 64
"""And over the round-off that its expression carries on."""
LENGTHS = (1.0, 2.0, 2.5, 5.0, 7.3)
SAMPLES = (6, 12, 24, 48, 97, 200)


@dataclass(frozen=True)
class Wanted:
    """A number that a measure must give (SI): NaN is an integral that diverges without a sign.

    An infinite one must be told at one of ``places`` (time in s, side -1 before or +1 after), to ``slack`` s.
    """

    value: float
    tolerance: float = 0.0
    places: tuple[tuple[float, int], ...] = ()
    slack: float = 0.0


@dataclass(frozen=True)
class Case:
    """A measure as it stands in the document, by its name there; ``width`` is that of its narrowest feature (s)."""

    family: str
    name: str
    measure: dict[str, Any]
    wanted: dict[str, Wanted]
    width: float
    share: float
    """The width over the length of the run."""
    f: Tree | None = field(default=None, compare=False, repr=False)
    """The expression itself, over the span (s) that it is taken over."""
    span: tuple[float, float] | None = None


@dataclass
class Batch:
    """A document and its cases."""

    seed: int
    document: dict[str, Any]
    cases: list[Case] = field(default_factory=list)

    def add(self, case: Case, window: tuple[float, float] | None = None) -> None:
        measure = dict(case.measure)
        if window is not None:
            name = f"w{len(self.document['windows'])}"
            self.document["windows"][name] = [f"{edge!r} s" for edge in window]
            measure["window"] = name
        self.document["measures"][case.name] = measure
        self.cases.append(case)


def wanted(one: Extreme, size: float, length: float) -> Wanted:
    """What an extreme must be told as."""
    if math.isinf(one.value):
        return Wanted(one.value, places=one.places, slack=1e-8 * length)
    return Wanted(one.value, RELATIVE * max(size, abs(one.value)) + ROUNDS * one.noise + 1e-15)


def spanned(b: Bounds, length: float) -> Wanted:
    """What the span must be told as."""
    if math.isinf(b.low.value) or math.isinf(b.high.value):
        return Wanted(math.inf)
    low, high = wanted(b.low, b.size, length), wanted(b.high, b.size, length)
    return Wanted(b.high.value - b.low.value, low.tolerance + high.tolerance)


def reduced(reduction: str, text: str, b: Bounds, length: float) -> tuple[dict[str, Any], dict[str, Wanted]]:
    """A measure of extremes, and what it must give."""
    low, high = wanted(b.low, b.size, length), wanted(b.high, b.size, length)
    numbers = {
        "extremes": {"min": low, "max": high},
        "max": {"": high},
        "min": {"": low},
        "span": {"": spanned(b, length)},
    }[reduction]
    return {reduction: text}, numbers


# Functions of the clock.


def clock_batch(seed: int, source: Any, count: int) -> Batch:
    """Cases in t, the angle of a crank at 1 rad/s and the coordinates of its pin at 1 m."""
    length, samples = source.choice(LENGTHS), source.choice(SAMPLES)
    batch = Batch(seed, clock_document(length, samples))
    names = list(FAMILIES)
    while len(batch.cases) < count:
        family = names[(seed + len(batch.cases)) % len(names)]
        draw = Draw(source, length, samples)
        while (made := clock_case(family, f"m{len(batch.cases)}", draw)) is None:
            pass
        batch.add(*made)
    return batch


def clock_document(length: float, samples: int) -> dict[str, Any]:
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {"frame": {"points": {"A": [0, 0]}}, "crank": {"points": {"A": [0, 0], "B": [1, 0]}}},
        "drives": {"motor": {"turns": "crank", "on": "frame", "position": "t/(1 s)"}},
        "windows": {},
        "measures": {},
        "studies": {"cycle": {"duration": f"{length!r} s", "samples": samples}},
    }


def clock_case(family: str, name: str, d: Draw) -> tuple[Case, tuple[float, float] | None] | None:
    """One case, or None where round-off alone decides what it is."""
    d.w = d.length * d.log(-7, -1)
    d.a, exact = place(d)
    d.clock = CLOCK if exact or d.pick(False, True, True) else ANGLE
    made = FAMILIES[family](d)
    window = windowed(d) if d.pick(False, False, True) else None
    span = (mpf(0), mpf(d.length)) if window is None else (mpf(window[0]), mpf(window[1]))
    reductions = ["extremes"] * 4 + ["max", "min", "span"]
    if made.integral or "mean" in made.diverging:
        reductions += ["mean"] * 3
    if made.square or "rms" in made.diverging:
        reductions += ["rms"] * 2
    if family in ("near pole", "other peak"):
        reductions += ["value"]
    reduction = d.pick(*reductions)
    if reduction in ("mean", "rms"):
        return integrated(family, name, d, made, reduction, span), window
    f = made.f + background(d)[0] if d.pick(False, True, True) else made.f
    b = bounds(f, [span], made.marks)
    if not sound(b):
        return None
    share = made.width / d.length
    if reduction == "value":
        return top(family, name, d, made, f, b, share), window
    measure, numbers = reduced(reduction, f.text, b, d.length)
    return Case(family, name, measure, numbers, made.width, share, f, _plain(span)), window


def sound(b: Bounds) -> bool:
    """Whether the truth stands clear of round-off, and of what a single point counts for."""
    return not b.lone and all(
        ROUNDS * one.noise <= 1e-3 * max(b.size, 1e-300) or math.isinf(one.value) for one in (b.low, b.high)
    )


def place(d: Draw) -> tuple[float, bool]:
    """Where a feature is: anywhere, at an end or near it, on a sample, between two; and whether the clock must be t."""
    kind = d.pick("any", "any", "any", "end", "near an end", "sample", "between")
    if kind == "end":
        return d.pick(0.0, d.length), True
    if kind == "near an end":
        off = d.w * d.uniform(0.3, 3)
        return (off if d.pick(False, True) else d.length - off), False
    grid_ = np.linspace(0.0, d.length, d.samples + 1)
    k = d.source.randrange(1, d.samples)
    if kind == "sample":
        return float(grid_[k]), True
    if kind == "between":
        return float((grid_[k] + grid_[k + 1]) / 2), False
    return d.uniform(0.03, 0.97) * d.length, False


def windowed(d: Draw) -> tuple[float, float]:
    """A window about the place, or with an edge right before, after or, in t, at it."""
    a, w = d.a, d.w
    kinds = ["about", "just after", "just before"] + ["at"] * (d.clock is CLOCK)
    kind = d.pick(*kinds)
    if kind == "about":
        low, high = a - d.uniform(0.05, 0.4) * d.length, a + d.uniform(0.05, 0.4) * d.length
    elif kind == "at":
        low, high = (a, a + 0.3 * d.length) if a < d.length / 2 else (a - 0.3 * d.length, a)
    else:
        off = w * d.log(-1, 1) * (1 if kind == "just after" else -1)
        low, high = (a + off, a + off + 0.3 * d.length) if a < d.length / 2 else (a + off - 0.3 * d.length, a + off)
    low, high = max(low, 0.0), min(high, d.length)
    return (low, high) if high - low > 0.02 * d.length else (0.0, d.length)


def integrated(family: str, name: str, d: Draw, made: Feature, reduction: str, span: tuple[Any, Any]) -> Case:
    """A mean or rms."""
    a, b = span
    g, of_g = background(d)
    f, integral = made.f, made.integral
    if reduction == "mean" and d.pick(False, True):
        f = f + g
        integral = made.integral and (lambda a, b, part=made.integral: part(a, b) + of_g(a, b))  # type: ignore[misc]
    share = made.width / d.length
    singular = any(a <= mark.time <= b for mark in made.marks)

    def case(number: Wanted) -> Case:
        return Case(family, name, {reduction: f.text}, {"": number}, made.width, share, f, _plain(span))

    if reduction in made.diverging and singular:
        return case(Wanted(made.diverging[reduction]))
    closed = integral if reduction == "mean" else made.square
    power = 1 if reduction == "mean" else 2
    # Without a closed form the pole lies outside the window.
    value = closed(a, b) / (b - a) if closed else numeric(f, made.marks, a, b, power)
    value = value if power == 1 else mpmath.sqrt(value)
    return case(Wanted(float(value), _integral_tolerance(f, made.marks, span, float(value))))


def _plain(span: tuple[Any, Any]) -> tuple[float, float]:
    return float(span[0]), float(span[1])


def _integral_tolerance(f: Tree, marks: tuple[Mark, ...], span: tuple[Any, Any], value: float) -> float:
    t, values = grid(f, [span], marks)
    fine = np.isfinite(values)
    size = np.trapezoid(np.abs(values[fine]), t[fine]) / float(span[1] - span[0])
    some = t[:: max(1, t.size // 80)]
    noise = np.array([f.noise(at) for at in some])
    known = np.isfinite(noise)
    carried = np.trapezoid(noise[known], some[known]) / float(span[1] - span[0])
    return float(RELATIVE * max(size, abs(value)) + ROUNDS * (carried + ROUND * size) + 1e-15)


def numeric(f: Tree, marks: tuple[Mark, ...], a: Any, b: Any, power: int) -> Any:
    """The mean of a power by Gauss-Legendre panels that halve towards each mark, in mpmath."""
    edges = {a, b}
    for mark in marks:
        for side in (-1, 1):
            step = (b - a) / 2
            for _ in range(60):
                at = mark.time + side * step
                if a < at < b:
                    edges.add(at)
                step /= 2
                if step < mark.scale / 64 and step < min(abs(mark.time - a), abs(mark.time - b)) / 4:
                    break
    base = [a + (b - a) * k / 8 for k in range(1, 8)]
    ordered = sorted(edges | set(base))
    total = mpf(0)
    for low, high in pairwise(ordered):
        middle, half = (low + high) / 2, (high - low) / 2
        total += half * sum(w * f.exact(middle + half * x) ** power for x, w in _GAUSS)
    return total / (b - a)


_GAUSS = [(mpf(float(x)), mpf(float(w))) for x, w in zip(*np.polynomial.legendre.leggauss(16), strict=True)]


def top(family: str, name: str, d: Draw, made: Feature, f: Tree, b: Bounds, share: float) -> Case:
    """The time at which a narrow peak is highest (or lowest)."""
    label, one = max((("max", b.high), ("min", b.low)), key=lambda pair: abs(pair[1].value))
    tolerance = d.w * (1e-5 + math.sqrt(ROUNDS * one.noise / max(b.size, 1e-300))) + 1e-12 * d.length
    measure = {"value": "t", "where": f"{label} {f.text}"}
    return Case(family, name, measure, {"": Wanted(one.time, tolerance)}, made.width, share)
