"""Features of functions of time with known places, widths and, of some, integrals: poles, peaks, jumps, edges, kinks.

Each maker draws one feature at a place ``a`` with a width ``w`` (s). Numbers in the texts are doubles and count as
exact, so that a place or a cancellation is never a matter of decimals.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import mpmath
import numpy as np
from mpmath import mpf

from helpers.adversary.trees import CLOCK, Tree, call, signal, tree
from helpers.adversary.truths import Mark

Integral = Callable[[Any, Any], Any]
"""The integral over a..b (s), in mpmath."""
ANGLE = signal("(motor.angle/(1 rad))", lambda t: t, lambda t: t, lambda t: 4 * 2.0**-52 * max(1.0, float(t)))
COS = signal("(B.x/(1 m))", mpmath.cos, np.cos)
SIN = signal("(B.y/(1 m))", mpmath.sin, np.sin)
"""The clock's crank: its angle is x, its pin at (cos x, sin x)."""


@dataclass(frozen=True)
class Feature:
    """An expression, where and over how long it does what (s), its integral and that of its square.

    ``width`` is how long the narrowest thing takes (full width at half the height). A mean or rms that diverges is
    named in ``diverging``, with the infinity that it goes to: NaN where both sides go to different ones.
    """

    f: Tree
    marks: tuple[Mark, ...]
    width: float
    integral: Integral | None = None
    square: Integral | None = None
    diverging: dict[str, float] = field(default_factory=dict)


@dataclass
class Draw:
    """The numbers that a feature is made of: a run's length D (s) and samples N, a place, a width, a clock."""

    source: random.Random
    length: float
    samples: int
    a: float = 0.0
    w: float = 0.1
    clock: Tree = CLOCK

    def uniform(self, low: float, high: float) -> float:
        return self.source.uniform(low, high)

    def log(self, low: float, high: float) -> float:
        return 10 ** self.source.uniform(low, high)

    def pick(self, *options: Any) -> Any:
        return self.source.choice(options)

    def sign(self) -> int:
        return int(self.pick(-1, 1))

    @property
    def u(self) -> Tree:
        return self.clock - self.a

    @property
    def inside(self) -> bool:
        """Whether the place is away from the ends of the run."""
        return 0 < self.a < self.length

    def dyadic(self) -> None:
        """Move the place to one whose square is a double, with room for a product."""
        self.a = round(self.a * 2**20) / 2**20

    def elsewhere(self) -> float:
        """Another place, away from this one."""
        while abs((b := self.uniform(0.02, 0.98) * self.length) - self.a) < 0.1 * self.length:
            pass
        return b


def background(d: Draw) -> tuple[Tree, Integral]:
    """A smooth function of size one, with its integral."""
    if d.pick(False, False, False, True):
        c = round(d.uniform(-1, 1), 3)
        return tree(c), lambda a, b: mpf(c) * (b - a)
    c0, c1 = d.uniform(-1, 1), d.uniform(0.2, 1)
    c2, c3 = d.uniform(0.5, 8) / d.length, d.uniform(0, 6)

    def integral(a: Any, b: Any) -> Any:
        return mpf(c0) * (b - a) - mpf(c1) / c2 * (mpmath.cos(mpf(c2) * b + c3) - mpmath.cos(mpf(c2) * a + c3))

    return c0 + c1 * call("sin", c2 * d.clock + c3), integral


# Poles.


def simple_pole(d: Draw) -> Feature:
    r = d.sign() * d.w
    forms: list[Tree] = [r / d.u, r / call("exp", d.u) * call("exp", d.u) / d.u, r / (call("exp", d.u) - 1.0)]
    if d.length <= 3:
        forms += [r / call("sin", d.u), r / call("tan", d.u), r / call("atan", d.u)]
    if d.inside:
        forms += [r / (1.0 - d.clock / d.a), r / call("log", d.clock / d.a), r / (d.u**3), r / (d.u * (d.clock + d.a))]
        forms += [r / (d.u * (1 + d.u * d.u)), (r + d.clock) / d.u]
    return Feature(d.pick(*forms), (Mark(mpf(d.a), d.w),), 2 * d.w, diverging={"mean": math.nan, "rms": math.inf})


def double_pole(d: Draw) -> Feature:
    r = d.sign() * d.w**2
    forms = [r / d.u**2, r / (d.u * d.u), (d.sign() * d.w) / abs(d.u), r / (d.u**4), r / call("hypot", d.u, 0.0) ** 2]
    if d.length <= 3:
        forms += [r / (1.0 - call("cos", d.u)), r / call("sin", d.u) ** 2]
    if d.inside and d.pick(False, True):
        d.dyadic()
        forms = [r / (d.clock**2 - 2 * d.a * d.clock + d.a**2)]
    f = d.pick(*forms)
    sign = float(mpmath.sign(f.exact(mpf(d.a) + (1e-9 if d.a < d.length / 2 else -1e-9))))
    return Feature(f, (Mark(mpf(d.a), d.w),), 2 * d.w, diverging={"mean": sign * math.inf, "rms": math.inf})


def opposite_poles(d: Draw) -> Feature:
    b = d.a + (d.w if d.a + d.w <= d.length else -d.w)
    r = d.sign() * abs(b - d.a)
    f = d.pick(r / d.u - r / (d.clock - b), r * d.w / (d.u * (d.clock - b)))
    marks = Mark(mpf(d.a), d.w), Mark(mpf(b), d.w)
    return Feature(f, marks, abs(b - d.a), diverging={"mean": math.nan, "rms": math.inf})


def cancelling_residues(d: Draw) -> Feature:
    """Two poles at one place whose residues differ by a share w, or two near-poles that leave a share of their peak."""
    share = max(d.w / d.length, 1e-7)
    r = d.uniform(0.5, 2) * d.sign()
    if d.pick(False, True):
        f = r / d.u - r * (1 - share) / d.u
        return Feature(f, (Mark(mpf(d.a), d.w),), 2 * d.w, diverging={"mean": math.nan, "rms": math.inf})
    w2, height = d.w * d.w, 30 / share
    f = height * (w2 / (d.u**2 + w2)) - height * (1 - share) * (w2 / (d.u**2 + w2))
    return Feature(f, (Mark(mpf(d.a), d.w),), 2 * d.w)


def near_pole(d: Draw) -> Feature:
    """Complex-conjugate poles at a +- i w."""
    w2, height = d.w * d.w, d.sign() * d.log(0.5, 3)
    if d.pick(False, True):
        f, c2 = height / (1.0 + (d.u / d.w) ** 2), mpf(d.w) ** 2
    else:
        f, c2 = d.pick(height * (w2 / (d.u**2 + w2)), height / (d.u * d.u + w2) * w2), mpf(w2)
    w = mpmath.sqrt(c2)

    def integral(a: Any, b: Any) -> Any:
        return height * w * (mpmath.atan((b - d.a) / w) - mpmath.atan((a - d.a) / w))

    def square(a: Any, b: Any) -> Any:
        def below(t: Any) -> Any:
            u = t - d.a
            return u / (2 * c2 * (u * u + c2)) + mpmath.atan(u / w) / (2 * w * c2)

        return height**2 * c2**2 * (below(b) - below(a))

    return Feature(f, (Mark(mpf(d.a), d.w),), 2 * d.w, integral, square)


def near_pole_expanded(d: Draw) -> Feature:
    """The same, written out as a polynomial of doubles: its true place and width are those of the doubles."""
    height, p, q = d.sign() * d.log(0.5, 3), 2 * d.a, d.a * d.a + d.w * d.w
    f = height * d.w**2 / (d.clock**2 - p * d.clock + q)
    return Feature(f, (Mark(mpf(p) / 2, d.w),), 2 * d.w)


def other_peak(d: Draw) -> Feature:
    """Narrow peaks that aren't rational."""
    height = d.sign() * d.log(0.5, 3)
    v = d.u / d.w
    kind = d.pick("bell", "root", "cosine", "step")
    if kind == "bell":

        def integral(a: Any, b: Any) -> Any:
            edges = (mpmath.erf((t - d.a) / mpf(d.w)) for t in (b, a))
            return height * mpf(d.w) * mpmath.sqrt(mpmath.pi) / 2 * (next(edges) - next(edges))

        return Feature(height * call("exp", 0.0 - v * v), (Mark(mpf(d.a), d.w),), 1.6 * d.w, integral)
    if kind == "root":
        return Feature(height / call("hypot", v, 1.0), (Mark(mpf(d.a), d.w),), 3.4 * d.w)
    if kind == "cosine" and d.length <= 5:
        half = d.w * d.w / 2
        return Feature(height * half / (1.0 - call("cos", d.u) + half), (Mark(mpf(d.a), d.w),), 2 * d.w)
    return Feature(height * (call("atan", v) - call("atan", v - 1.0)), (Mark(mpf(d.a + d.w / 2), d.w),), 2 * d.w)


# Removable gaps, jumps, edges, kinks.


def removable(d: Draw) -> Feature:
    """0/0 with a finite limit."""
    height, k, marks = d.sign() * d.uniform(1, 5), d.log(0.3, 2.3) / d.length, (Mark(mpf(d.a), d.w),)
    kind = d.pick("sinc", "cosc", "square", "exp", "cancelled", "over sine", "squares", "narrow")
    if kind == "sinc":
        return Feature(height / k * (call("sin", k * d.u) / d.u), marks, 3.7 / k)
    if kind == "cosc":
        return Feature(height * (1.0 - call("cos", d.u)) / d.u**2, marks, d.length)
    if kind == "exp":
        return Feature(height * (call("exp", d.u) - 1.0) / d.u, marks, d.length)
    if kind == "over sine" and d.length <= 3:
        return Feature(height * d.u / call("sin", d.u), marks, d.length)
    if kind == "squares" and d.length <= 3:
        return Feature(height * call("sin", d.u) ** 2 / (1.0 - call("cos", d.u)), marks, d.length)
    if kind == "square" and d.inside:
        d.dyadic()
        f = height * (d.clock**2 - d.a**2) / (d.clock - d.a)
        return Feature(f, (Mark(mpf(d.a), d.w),), d.length)
    if kind == "narrow":  # a peak with a gap in its middle
        w2 = d.w * d.w
        return Feature(10 * height * (w2 * d.u) / (d.u * (d.u**2 + w2)), marks, 2 * d.w)
    b, c = d.elsewhere(), d.length * d.uniform(1.1, 2)
    f = height * (d.u * (d.clock - b)) / (d.u * (d.clock - c))
    return Feature(f, marks, d.length)


def jump(d: Draw) -> Feature:
    """Finite jumps; the extreme is often a limit that isn't reached."""
    height, marks = d.sign() * d.uniform(2, 6), (Mark(mpf(d.a), d.w),)
    b = d.a + (d.w if d.a + d.w <= d.length else -d.w)
    kind = d.pick("sign", "root sign", "cut", "box", "inverse atan", "logistic", "essential")
    if kind == "sign":
        return Feature(height * (d.u / abs(d.u)), marks, d.length)
    if kind == "root sign":
        return Feature(height * (d.u / call("sqrt", d.u**2)), marks, d.length)
    if kind == "cut":
        return Feature(height * call("atan2", d.u, tree(-d.uniform(0.5, 2))), marks, d.length)
    if kind == "box":
        f = height * 3 * (d.u / abs(d.u) - (d.clock - b) / abs(d.clock - b))
        return Feature(f, (*marks, Mark(mpf(b), d.w)), abs(b - d.a))
    if kind == "inverse atan":
        return Feature(height * call("atan", d.w / d.u), marks, d.w)
    if kind == "logistic":
        return Feature(height / (1.0 + call("exp", d.w / d.u)), marks, d.w)
    grows = {"mean": height * math.inf, "rms": math.inf} if d.a < d.length else {}
    return Feature(height * call("exp", d.w / d.u), marks, d.w, diverging=grows)


def weak_pole(d: Draw) -> Feature:
    """Unbounded, but its mean is finite."""
    r, p = d.sign() * d.uniform(0.5, 2), d.pick(0.5, 0.25, 1 / 3)
    c = mpf(p)

    def root(t: Any, power: Any) -> Any:
        u = t - mpf(d.a)
        return mpmath.sign(u) * abs(u) ** (1 - power) / (1 - power)

    def integral(a: Any, b: Any) -> Any:
        return r * (root(b, c) - root(a, c))

    def square(a: Any, b: Any) -> Any:
        return mpf(r) ** 2 * (root(b, 2 * c) - root(a, 2 * c))

    f = (
        d.pick(r / call("sqrt", abs(d.u)), r * abs(d.u) ** -0.5)
        if p == 0.5
        else d.pick(r / abs(d.u) ** p, r * abs(d.u) ** -p)
    )
    diverging = {"rms": math.inf} if p == 0.5 else {}
    return Feature(f, (Mark(mpf(d.a), d.w),), d.w, integral, None if p == 0.5 else square, diverging)


def log_edge(d: Draw) -> Feature:
    r, c = d.sign() * d.uniform(0.5, 2), d.uniform(0.5, 2)

    def below(t: Any) -> Any:
        u = t - mpf(d.a)
        return u * (mpmath.log(abs(u) / mpf(c)) - 1) if u else mpf(0)

    def square(t: Any) -> Any:
        u = t - mpf(d.a)
        if not u:
            return mpf(0)
        log = mpmath.log(abs(u) / mpf(c))
        return u * (log**2 - 2 * log + 2)

    return Feature(
        r * call("log", abs(d.u) / c),
        (Mark(mpf(d.a), d.w),),
        d.w,
        lambda a, b: r * (below(b) - below(a)),
        lambda a, b: mpf(r) ** 2 * (square(b) - square(a)),
    )


def finite_edge(d: Draw) -> Feature:
    """Cusps and vertical tangents with a finite value: roots, x log x, asin at one."""
    height, marks = d.sign() * d.log(0.5, 2), (Mark(mpf(d.a), d.w),)
    v = d.u / d.w
    kind = d.pick("cusp", "narrow cusp", "x log x", "asin", "acos", "asin of cos", "power")
    if kind == "cusp":
        return Feature(height * call("sqrt", abs(d.u)), marks, d.length / 10)
    if kind == "narrow cusp":
        return Feature(height * call("exp", 0.0 - call("sqrt", abs(v))), marks, d.w)
    if kind == "x log x":
        return Feature(height * abs(d.u) * call("log", abs(d.u)), marks, d.length / 10)
    if kind == "power":
        return Feature(height * abs(d.u) ** d.pick(1 / 3, 0.75, 1.5), marks, d.length / 10)
    if kind == "asin of cos":
        return Feature(height * call("asin", call("cos", d.u)), marks, d.length / 10)
    return Feature(height * call(kind, 1.0 / (1.0 + v * v)), marks, d.w)


def kink(d: Draw) -> Feature:
    height, marks, v = d.sign() * d.log(0.7, 3), (Mark(mpf(d.a), d.w),), d.u / d.w
    kind = d.pick("triangle", "notch", "crossing", "sum")
    sides = *marks, Mark(mpf(d.a) + mpf(d.w), d.w), Mark(mpf(d.a) - mpf(d.w), d.w)

    def area(t: Any) -> Any:
        u = max(min((t - mpf(d.a)) / mpf(d.w), mpf(1)), mpf(-1))
        return mpf(d.w) * (u - mpmath.sign(u) * u * u / 2)

    if kind == "triangle":
        f = height * call("max", 0.0, 1.0 - abs(v))
        return Feature(f, sides, d.w, lambda a, b: height * (area(b) - area(a)))
    if kind == "notch":
        return Feature(height * call("min", abs(v), 1.0), sides, d.w)
    if kind == "crossing":
        p, q = d.uniform(0.2, 3), d.uniform(-3, -0.2)
        f = height * call(d.pick("max", "min"), p * d.u, q * d.u)
        return Feature(f, marks, d.length / 10)
    b = d.elsewhere()
    return Feature(height * (abs(d.u) + abs(d.clock - b)), (*marks, Mark(mpf(b), d.w)), d.length / 10)


def waves(d: Draw) -> Feature:
    """A sum of fast sines."""
    f, fastest = tree(0.0), 1.0
    for _ in range(d.pick(2, 3, 5)):
        rate = d.log(0.5, 2.3) / d.length
        fastest = max(fastest, rate)
        f = f + d.uniform(0.3, 1) * call("sin", rate * d.clock + d.uniform(0, 6))
    return Feature(f, (), 1 / fastest)


# Of the clock's crank: its pin at (cos x, sin x).


def _turns(first: Any, step: Any, d: Draw, scale: float) -> tuple[Mark, ...]:
    times = (first + k * step for k in range(-4, 8))
    return tuple(Mark(t, scale) for t in times if -0.1 * d.length <= t <= 1.1 * d.length)


def crank_pole(d: Draw) -> Feature:
    """Tangents and quotients of the pin's coordinates."""
    r, pi = d.sign() * d.w, mpmath.pi
    kind = d.pick("tan", "slope", "inverse slope", "level", "turn")
    if kind == "tan":
        c = d.uniform(0.1, 1.4)
        return Feature(r * call("tan", d.clock + c), _turns(pi / 2 - mpf(c), pi, d, d.w), 2 * d.w)
    if kind == "slope":
        return Feature(r * (SIN / COS), _turns(pi / 2, pi, d, d.w), 2 * d.w)
    if kind == "inverse slope":  # away from the pole at the start, which round-off may hide
        return Feature(r * (COS / (SIN + 1.5) / COS**2), _turns(pi / 2, pi, d, d.w), 2 * d.w)
    if kind == "turn":
        return Feature(r / call("atan2", COS, SIN + 2.0), _turns(pi / 2, pi, d, d.w), 2 * d.w)
    c = d.uniform(-0.95, 0.95)
    first = mpmath.asin(mpf(c))
    marks = _turns(first, 2 * pi, d, d.w) + _turns(pi - first, 2 * pi, d, d.w)
    return Feature(r / (SIN - c), marks, 2 * d.w)


def crank_touch(d: Draw) -> Feature:
    """1/(sin x - c) where c is nearly 1: two poles close together, or a near-pole."""
    gap, r, pi = d.w * d.w / 2, d.sign() * d.w * d.w, mpmath.pi
    if d.pick(False, True):
        c = 1 + gap
        return Feature(r / (SIN - c), _turns(pi / 2, 2 * pi, d, d.w), 2 * d.w)
    c = 1 - gap
    first = mpmath.asin(mpf(c))
    marks = _turns(first, 2 * pi, d, d.w) + _turns(pi - first, 2 * pi, d, d.w)
    return Feature(r / (SIN - c), marks, 2 * d.w)


def crank_jump(d: Draw) -> Feature:
    """The angle of the pin, which jumps over the cut, and other finite jumps and kinks of its coordinates."""
    pi, c = mpmath.pi, d.uniform(-0.9, 0.9)
    kind = d.pick("angle", "other angle", "asin", "sign", "circle")
    if kind == "angle":
        return Feature(call("atan2", SIN, COS), _turns(pi, 2 * pi, d, 0.1), d.length / 10)
    if kind == "other angle":
        first = mpmath.asin(mpf(c))
        marks = _turns(first, 2 * pi, d, 0.1) + _turns(pi - first, 2 * pi, d, 0.1)
        return Feature(call("atan2", SIN - c, COS - 0.2), marks, d.length / 20)
    if kind == "asin":
        return Feature(call("asin", SIN), _turns(pi / 2, pi, d, 0.1), d.length / 10)
    if kind == "sign":
        return Feature(COS / abs(COS), _turns(pi / 2, pi, d, 0.1), d.length / 10)
    return Feature(call("hypot", COS - c, SIN), (), d.length / 10)


# Cancellation of higher order, roots and what rests at zero, poles past the ends, near-poles of roots.


def higher_gap(d: Draw) -> Feature:
    """0/0 where terms of second to sixth order cancel."""
    height, marks = d.sign() * d.uniform(1, 5), (Mark(mpf(d.a), d.w),)
    forms = [
        (d.u - call("sin", d.u)) / d.u**3,
        (call("exp", d.u) - 1.0 - d.u) / d.u**2,
        (1.0 - call("cos", d.u)) ** 2 / d.u**4,
        (d.u - call("sin", d.u)) / (d.u * (1.0 - call("cos", d.u)))
        if d.length <= 3
        else (1.0 - call("cos", d.u)) / d.u**2,
        call("sin", d.u) ** 2 / (call("exp", d.u) - 1.0) ** 2,
    ]
    return Feature(height * d.pick(*forms), marks, d.length / 4)


def root_beside(d: Draw) -> Feature:
    """Roots that rest at zero on one side, powers of magnitudes, quotients with roots that vanish."""
    r, v, marks = d.sign() * d.uniform(1, 3), d.u / d.w, (Mark(mpf(d.a), d.w),)
    kind = d.pick("rest", "power", "quotient", "arch", "two", "step")
    if kind in ("rest", "power"):
        p = d.pick(0.5, 1.5)
        base = call("max", 0.0, d.u) if kind == "rest" else abs(d.u)

        def below(t: Any) -> Any:
            u = t - mpf(d.a)
            return (mpmath.sign(u) if kind == "power" or u > 0 else 0) * abs(u) ** (mpf(p) + 1) / (mpf(p) + 1)

        root = call("sqrt", base) if p == 0.5 else base**p
        return Feature(r * root, marks, d.length / 10, lambda a, b: r * (below(b) - below(a)))
    if kind == "quotient":
        return Feature(r * (call("sin", d.u) / call("sqrt", abs(d.u))), marks, d.length / 10)
    if kind == "arch":
        ends = Mark(mpf(d.a) - mpf(d.w), d.w), Mark(mpf(d.a) + mpf(d.w), d.w)
        return Feature(r * call("sqrt", call("max", 0.0, 1.0 - v**2)), (*marks, *ends), d.w)
    if kind == "two":
        f = r * call("sqrt", call("max", 0.0, d.u)) + call("sqrt", call("max", 0.0, d.a - d.clock))
        return Feature(f, marks, d.length / 10)
    return Feature(r * (d.u / call("sqrt", d.u**2 + d.w**2)), marks, d.w)


def past_end(d: Draw) -> Feature:
    """A pole outside the run, as near as a share w^2 of its length: the last or the first value is the extreme."""
    gap, r = d.length * max((d.w / d.length) ** 2, 1e-11), d.sign() * d.uniform(0.5, 3)
    end, at = d.pick((d.length, d.length + gap), (0.0, 0.0 - gap))
    away = float(abs(mpf(at) - mpf(end)))
    u, marks = at - d.clock, (Mark(mpf(end), away),)
    if d.pick(False, True):

        def below(t: Any) -> Any:
            return -mpmath.log(abs(mpf(at) - t))

        return Feature(r / u, marks, away, lambda a, b: r * (below(b) - below(a)))
    return Feature(d.pick(r / u**2, r * call("log", abs(u)), r / abs(u) ** 0.5), marks, away)


def near_root_pole(d: Draw) -> Feature:
    """Kinks at the top of what falls like the inverse of a root or a magnitude, from a height of 1/w."""
    r, c, marks = d.sign() * d.uniform(0.5, 2), d.w, (Mark(mpf(d.a), d.w),)
    kind = d.pick("root", "magnitude", "log")
    if kind == "log":
        return Feature(r * call("log", abs(d.u) + c), marks, 2 * d.w)

    def below(t: Any) -> Any:
        u = t - mpf(d.a)
        fall = mpmath.sqrt(abs(u) + c) - mpmath.sqrt(mpf(c)) if kind == "root" else mpmath.log(1 + abs(u) / c)
        return mpmath.sign(u) * fall * (2 if kind == "root" else c)

    f = r / call("sqrt", abs(d.u) + c) if kind == "root" else r * c / (abs(d.u) + c)
    return Feature(f, marks, 2 * d.w, lambda a, b: r * (below(b) - below(a)))


def several(d: Draw) -> Feature:
    """Two of the others at places of their own."""
    first, second = (d.pick(removable, finite_edge, kink, root_beside, higher_gap, jump) for _ in range(2))
    one, a, w = first(d), d.a, d.w
    d.a, d.w = d.elsewhere(), d.length * d.log(-6, -1)
    other = second(d)
    narrow = min(one.width, other.width)
    d.a, d.w = a, w
    return Feature(one.f + other.f, (*one.marks, *other.marks), narrow)


FAMILIES: dict[str, Callable[[Draw], Feature]] = {
    maker.__name__.replace("_", " "): maker
    for maker in (
        simple_pole, double_pole, opposite_poles, cancelling_residues, near_pole, near_pole_expanded, other_peak,
        removable, jump, weak_pole, log_edge, finite_edge, kink, waves, crank_pole, crank_touch, crank_jump,
        higher_gap, root_beside, past_end, near_root_pole, several,
    )
}  # fmt: skip
