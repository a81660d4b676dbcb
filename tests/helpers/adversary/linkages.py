"""Cases of mechanisms with closed forms: four-bars, near their change points too, and the guide of a slider-crank."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from functools import lru_cache
from typing import Any

import mpmath
import numpy as np
from mpmath import mpf

from helpers.adversary.cases import RELATIVE, ROUNDS, UNITS, Batch, Case, Wanted, reduced, sound
from helpers.adversary.features import Draw, background
from helpers.adversary.trees import CLOCK, ROUND, Tree, call, signal
from helpers.adversary.truths import Mark, bounds

ROD = {"mass": 1.5, "shape": "rod D-C"}


class FourBar:
    """Crank a at A = 0, coupler b, rocker c at D = (d, 0) (m), C to the left of B-D; the crank's angle is phi0 + t.

    Its methods take mpmath numbers or NumPy arrays of times (s); rates are by the crank's angle.
    """

    def __init__(self, a: float, b: float, c: float, d: float, phi0: float) -> None:
        self.lengths, self.phi0 = (a, b, c, d), phi0
        self._exact = lru_cache(maxsize=1000)(self._pose)

    def pose(self, t: Any) -> tuple[Any, Any, Any]:
        """B, C - B and C - D as complex numbers."""
        return self._exact(t) if isinstance(t, mpmath.mpf) else self._pose(t)

    def _pose(self, t: Any) -> tuple[Any, Any, Any]:
        exact = isinstance(t, mpmath.mpf)
        a, b, c, d = map(mpf, self.lengths) if exact else self.lengths
        turned = mpmath.expj(t + mpf(self.phi0)) if exact else np.exp(1j * (t + self.phi0))
        pin = a * turned
        gap = d - pin
        square = abs(gap) ** 2
        along = (b**2 - c**2 + square) / (2 * square)
        across = (mpmath.sqrt if exact else np.sqrt)(b**2 / square - along**2)
        arm = gap * (along + 1j * across)
        return pin, arm, pin + arm - d

    def omega(self, t: Any) -> Any:
        """The rocker's speed, that of the crank being 1."""
        pin, arm, rocker = self.pose(t)
        return _cross(arm, pin) / _cross(arm, rocker)

    def alpha(self, t: Any) -> Any:
        pin, arm, rocker = self.pose(t)
        omega = self.omega(t)
        spin = _dot(rocker * omega - pin, arm) / abs(arm) ** 2
        return (abs(arm) ** 2 * spin**2 - omega**2 * _dot(rocker, arm) + _dot(pin, arm)) / _cross(arm, rocker)

    def torque(self, t: Any) -> Any:
        """The crank's torque for a rocker that is a rod of ROD's mass."""
        c = self.lengths[2]
        return self.alpha(t) * self.omega(t) * ROD["mass"] * c**2 / 3

    def document(self, cycle: dict[str, Any], speed: str = "1 rad/s") -> dict[str, Any]:
        a, b, c, d = self.lengths
        return {
            "linkwright": 1,
            "units": UNITS,
            "links": {
                "frame": {"points": {"A": [0, 0], "D": [d, 0]}},
                "crank": {"points": {"A": [0, 0], "B": [a, 0]}},
                "coupler": {"points": {"B": [0, 0], "C": [b, 0]}},
                "rocker": {"points": {"D": [0, 0], "C": [c, 0]}, **ROD},
            },
            "assembly": {"C": "left of B-D"},
            "drives": {"motor": {"turns": "crank", "on": "frame", "speed": speed, "start": f"{self.phi0!r} rad"}},
            "windows": {},
            "measures": {},
            "studies": {"cycle": cycle},
        }


def _cross(a: Any, b: Any) -> Any:
    return a.real * b.imag - a.imag * b.real


def _dot(a: Any, b: Any) -> Any:
    return a.real * b.real + a.imag * b.imag


def roots(f: Callable[[Any], Any], length: float, steps: int = 1500) -> list[Any]:
    """The zeros of a smooth function about 0..length (s), by its signs on a grid."""
    t = np.linspace(-0.05 * length, 1.05 * length, steps)
    values = f(t)
    return [
        root(f, mpf(float(t[i])), mpf(float(t[i + 1])))
        for i in np.flatnonzero(np.sign(values[:-1]) * np.sign(values[1:]) < 0)
    ]


def root(f: Callable[[Any], Any], a: Any, b: Any) -> Any:
    """The zero between two times of different sign: halved to a share of 2^-20, then by secants."""
    fa = f(a)
    for _ in range(20):
        middle = (a + b) / 2
        if (f(middle) < 0) == (fa < 0):
            a = middle
        else:
            b = middle
    fa, fb = f(a), f(b)
    for _ in range(12):
        if fa == fb:
            break
        a, fa, b = b, fb, b - fb * (b - a) / (fb - fa)
        fb = f(b)
    return b


# A four-bar in general positions.


def four_bar_batch(seed: int, source: random.Random, count: int) -> Batch:
    length, samples = source.choice((3.0, 6.3, 7.9)), source.choice((6, 24, 90, 200))
    while True:
        a, b, c = source.uniform(0.2, 0.4), source.uniform(0.7, 1.3), source.uniform(0.6, 1.2)
        longest = max(b, c, 1.0)
        if a + longest < (b + c + 1.0 - longest) - 0.1:
            break
    bar = FourBar(a, b, c, 1.0, source.uniform(-3, 3))
    batch = Batch(seed, bar.document({"duration": f"{length!r} s", "samples": samples}))
    linkage = Linkage(bar, length)
    while len(batch.cases) < min(count, 24):
        d = Draw(source, length, samples)
        d.w = length * d.log(-7, -1)
        kind = list(Linkage.KINDS)[len(batch.cases) % len(Linkage.KINDS)]
        f, marks, width = getattr(linkage, kind)(d)
        if d.pick(False, True):
            f = f + background(d)[0]
        b_ = bounds(f, [(mpf(0), mpf(length))], marks)
        if not sound(b_):
            continue
        measure, numbers = reduced(d.pick("extremes", "extremes", "max", "min", "span"), f.text, b_, length)
        name = f"m{len(batch.cases)}"
        case = Case(f"four-bar {kind}", name, measure, numbers, width, width / length, f, (0.0, length))
        batch.add(case)
    return batch


class Linkage:
    """Expressions in the signals of a four-bar, with what they do where."""

    KINDS = ("advantage", "turning_back", "log_speed", "tangent", "centre", "touch", "cut", "smooth")

    def __init__(self, bar: FourBar, length: float) -> None:
        self.bar, self.length = bar, length
        self.dead = roots(bar.omega, length)
        noise = lambda t: 64 * ROUND  # noqa: E731
        self.speed = signal("(rocker.omega/crank.omega)", bar.omega, bar.omega, noise)
        self.alpha = signal("(rocker.alpha/(1 rad/s^2))", bar.alpha, bar.alpha, noise)
        self.cx = signal("(C.x/(1 m))", lambda t: self.joint(t).real, lambda t: self.joint(t).real, noise)
        self.cy = signal("(C.y/(1 m))", lambda t: self.joint(t).imag, lambda t: self.joint(t).imag, noise)
        self.heights = bounds(self.cy, [(mpf(0), mpf(length))], ())
        pin = bar.pose
        self.bx = signal("(B.x/(1 m))", lambda t: pin(t)[0].real, lambda t: pin(t)[0].real)
        self.by = signal("(B.y/(1 m))", lambda t: pin(t)[0].imag, lambda t: pin(t)[0].imag)

    def joint(self, t: Any) -> Any:
        return self.bar.pose(t)[2] + self.bar.lengths[3]

    def marks(self, times: list[Any], scale: float) -> tuple[Mark, ...]:
        return tuple(Mark(time, scale) for time in times)

    def advantage(self, d: Draw) -> Any:
        gain = d.pick(1.0, d.w)
        return gain * (1 / self.speed), self.marks(self.dead, min(gain, 0.05)), 2 * gain

    def turning_back(self, d: Draw) -> Any:
        form = d.pick(self.speed / abs(self.speed), call("sqrt", abs(self.speed)), abs(self.speed) ** (1 / 3))
        return d.uniform(1, 3) * form, self.marks(self.dead, 0.05), 0.1 * self.length

    def log_speed(self, d: Draw) -> Any:
        return call("log", abs(self.speed)), self.marks(self.dead, 0.05), 0.05

    def tangent(self, d: Draw) -> Any:
        ground = self.bar.lengths[3]
        at = roots(lambda t: self.bar.pose(t)[2].real, self.length)
        angle = signal("(rocker.angle)", lambda t: _angle(self.bar.pose(t)[2]), lambda t: _angle(self.bar.pose(t)[2]))
        f = d.pick(d.w * call("tan", angle), d.w * self.cy / (self.cx - ground))
        return f, self.marks(at, d.w), 2 * d.w

    def centre(self, d: Draw) -> Any:
        """The instant centre of the coupler: where the lines A-B and D-C meet."""

        def apart(t: Any) -> Any:
            pin, _, rocker = self.bar.pose(t)
            return _cross(pin, rocker)

        def x(t: Any) -> Any:
            pin, _, rocker = self.bar.pose(t)
            return self.bar.lengths[3] * rocker.imag / apart(t) * pin.real

        f = signal("(pole(coupler, frame).x/(1 m))", x, x, lambda t: 64 * ROUND * (1 + abs(float(x(t)))))
        gain = d.pick(1.0, d.w)
        return gain * f, self.marks(roots(apart, self.length), min(gain, 0.05)), 2 * gain

    def touch(self, d: Draw) -> Any:
        """1/(C.y - c) where C.y comes within w^2/2 of c, or just passes it."""
        f = self.cy
        one, way = d.pick((self.heights.high, 1), (self.heights.low, -1))
        gap = d.w * d.w / 2
        c = one.value + way * gap * d.pick(-1, 1)
        at = roots(lambda t: self.joint(t).imag - (mpf(c) if isinstance(t, mpmath.mpf) else c), self.length)
        every = [mpf(one.time) + 2 * mpmath.pi * turn for turn in (-1, 0, 1)]
        centres = [centre for centre in every if 0 <= centre <= self.length]
        for centre in centres:
            if not any(abs(time - centre) < 10 * d.w for time in at):
                near = [centre + side * mpf(d.w) * k / 8 for side in (-1, 1) for k in range(65)]
                at += _near_roots(lambda t: self.joint(t).imag - mpf(c), sorted(near))
        return d.w**2 / (f - c), (*self.marks(at, d.w), *(Mark(centre, d.w) for centre in centres)), 2 * d.w

    def cut(self, d: Draw) -> Any:
        pi, phi0 = mpmath.pi, mpf(self.bar.phi0)
        return call("atan2", self.by, self.bx), self.marks([pi - phi0 + 2 * k * pi for k in (-1, 0, 1)], 0.1), 0.3

    def smooth(self, d: Draw) -> Any:
        form = d.pick(self.alpha, self.cx * self.cy, self.speed, call("hypot", self.cx - self.bx, self.cy))
        return form + 0.1 * CLOCK, (), self.length / 20


def _angle(z: Any) -> Any:
    return mpmath.arg(z) if isinstance(z, mpmath.mpc) else np.angle(z)


def _near_roots(f: Callable[[Any], Any], t: list[Any]) -> list[Any]:
    values = [f(at) for at in t]
    pairs = ((a, b) for a, b, fa, fb in zip(t, t[1:], values, values[1:], strict=False) if fa * fb < 0)
    return [root(f, *pair) for pair in pairs]


# A four-bar near its change point.


def near_change_batch(seed: int, source: random.Random, count: int) -> Batch:
    """Grashof margins of 1e-1 to 1e-7: AB + BC falls short of CD + DA by it, the links are nearly in line at 0.

    A torque over a turn, or its rms over many turns at a handful of samples.
    """
    share = 10 ** source.uniform(-7, -1)
    a, c = source.uniform(0.2, 0.45), source.uniform(0.6, 1.1)
    bar = FourBar(a, c + 1.0 - a - share, c, 1.0, source.uniform(0.3, 6))
    turns = source.choice((1, 1, source.randrange(13, 41)))
    samples = source.choice((30, 200)) if turns == 1 else source.randrange(3, 6)
    batch = Batch(seed, bar.document({"turns": f"{turns} motor", "samples": samples}))
    wide = math.sqrt(2 * share * (1.0 - a) / a)
    width, length = 0.3 * min(wide, 1.0), 2 * math.pi * turns
    centre = 2 * mpmath.pi * math.ceil(bar.phi0 / (2 * math.pi)) - mpf(bar.phi0)
    for name, text, f in (
        ("torque", "motor.torque", bar.torque),
        ("alpha", "rocker.alpha", bar.alpha),
        ("omega", "rocker.omega", bar.omega),
    ):
        tree = signal(text, f, f, lambda t, f=f: abs(float(f(t))) * 2 * ROUND / share)
        b = bounds(tree, [(centre - mpmath.pi, centre + mpmath.pi)], (Mark(centre, wide),))
        for reduction in ("extremes", "span"):
            measure, numbers = reduced(reduction, text, b, length)
            batch.add(Case("near change point", f"{name}_{reduction}", measure, numbers, width, width / length))
        size = _rms(f, bar.phi0, wide)
        number = Wanted(size, size * (RELATIVE + ROUNDS * 2 * ROUND / share))
        batch.add(Case("near change point", f"{name}_rms", {"rms": text}, {"": number}, width, width / length))
    return batch


def _rms(f: Callable[[Any], Any], phi0: float, wide: float) -> float:
    """Over a turn, by Gauss-Legendre panels that get finer towards the change point, in doubles."""
    near = np.geomspace(min(wide, 1.0) / 16, math.pi, 120)
    edges = np.concatenate([-near[::-1], np.linspace(-near[0], near[0], 9)[1:-1], near])
    x, w = np.polynomial.legendre.leggauss(20)
    middle, half = (edges[1:] + edges[:-1]) / 2, np.diff(edges) / 2
    t = middle[:, None] + half[:, None] * x
    values = f(t - phi0)
    return float(np.sqrt(((values**2) @ w) @ half / (2 * math.pi)))


# The guide of a slider-crank.


def guide_batch(seed: int, source: random.Random, count: int) -> Batch:
    """The arm of a guide's reaction: unbounded where the rod lies in the guide's line; 0/0 where nothing presses."""
    length, samples = source.choice((2.9, 6.2, 9.0)), source.choice((6, 24, 90, 200))
    r, rod, lever = source.uniform(0.2, 0.5), source.uniform(1.2, 2), source.uniform(0.05, 0.3)
    phi0 = source.uniform(0.2, 2.9)

    def arm(t: Any) -> Any:
        exact = isinstance(t, mpmath.mpf)
        angle = t + (mpf(phi0) if exact else phi0)
        sine = (mpf(r) if exact else r) * (mpmath.sin if exact else np.sin)(angle)
        return -lever * (mpmath.sqrt if exact else np.sqrt)((mpf(rod) if exact else rod) ** 2 - sine**2) / sine

    document = {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [r, 0]}},
            "rod": {"points": {"B": [0, 0], "C": [rod, 0]}},
            "slider": {"points": {"C": [0, 0]}, "mass": 1.2, "com": [0.1, lever], "inertia": 0.3},
        },
        "joints": {"guide": {"prismatic": ["frame", "slider"], "line": ["A at 0 deg", "C at 0 deg"]}},
        "assembly": {"C": "ahead of B along guide"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "1 rad/s", "start": f"{phi0!r} rad"}},
        "windows": {},
        "measures": {},
        "studies": {"cycle": {"duration": f"{length!r} s", "samples": samples}},
    }
    batch = Batch(seed, document)
    f = signal("(force(frame, slider).arm/(1 m))", arm, arm, lambda t: 64 * ROUND * (1 + abs(float(arm(t)))))
    at = [k * mpmath.pi - mpf(phi0) for k in range(-1, 5)]
    forms: list[tuple[Tree, float]] = [(f, 1.0), (1.0 / f, 1.0), (call("atan", f), 1.0)]
    for _ in range(count):
        d = Draw(source, length, samples)
        d.w = length * d.log(-7, -1)
        form, gain = d.pick(*forms, (d.w * f, d.w), (d.w * f, d.w))
        if gain != 1.0 or d.pick(False, True):
            form = form + background(d)[0]
        window = d.pick(None, None, _beside(d, at))
        spans = [(mpf(0), mpf(length))] if window is None else [(mpf(window[0]), mpf(window[1]))]
        b = bounds(form, spans, tuple(Mark(time, min(gain, 0.1)) for time in at))
        if not sound(b):
            continue
        measure, numbers = reduced(d.pick("extremes", "max", "min", "span"), form.text, b, length)
        name, width, span = f"m{len(batch.cases)}", 2 * gain, window or (0.0, length)
        case = Case("guide's arm", name, measure, numbers, width, width / length, form, span)
        batch.add(case, window)
    return batch


def _beside(d: Draw, at: list[Any]) -> tuple[float, float] | None:
    """A window that begins right after a pole."""
    first = next(float(time) for time in at if time > 0)
    low = first + d.w
    return (low, low + 0.2 * d.length) if low + 0.2 * d.length < d.length else None
