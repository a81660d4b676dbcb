"""A signal between samples: the piecewise cubic with its values and exact rates there (Hermite's interpolant).

Of a smooth signal f it is within h^4/384 max|f''''| for steps h; turning points and integrals of it are exact. It is
written in plain numbers, operation by operation as ``web/src/measures/samples.ts``, which pages use: both have the
same bits.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from math import floor, inf, isfinite, nan, pi, sqrt

Interval = tuple[float, float]
Node = tuple[int, float, float]

GAUSS = (
    (-0.8611363115940526, 0.3478548451374538),
    (-0.3399810435848563, 0.6521451548625461),
    (0.3399810435848563, 0.6521451548625461),
    (0.8611363115940526, 0.3478548451374538),
)
"""Nodes on -1..1 and weights of Gauss's rule with four points: exact for squares of cubics."""
LEVEL = 1e-14
"""A signal that comes back by less than this share of its size hasn't turned."""
MOST_LOOKS = 60
MOST_TURNS = 1000
"""An angle that turns further can't be looked at on samples."""


class Interpolant:
    """A signal at times ``t`` (s, ascending, at least two) with its ``values`` and ``rates`` per second.

    A value that isn't finite makes both steps beside it unknown. A rate that isn't finite, or that would carry the
    signal past its whole range within the step, isn't used: the step is a parabola then, or a line.
    """

    def __init__(self, t: Sequence[float], values: Sequence[float], rates: Sequence[float]) -> None:
        self.t, self.values = [float(x) for x in t], [float(x) for x in values]
        finite = [v for v in self.values if isfinite(v)]
        span = max(finite) - min(finite) if finite else nan
        self.cubics: list[tuple[float, float, float, float]] = []
        for i in range(len(self.t) - 1):
            step, change = self.t[i + 1] - self.t[i], self.values[i + 1] - self.values[i]
            first, last = _ends(change, float(rates[i]) * step, float(rates[i + 1]) * step, span)
            more = 3 * change - 2 * first - last
            self.cubics.append((self.values[i], first, more, first + last - 2 * change))

    @classmethod
    def mixed(cls, x: Interpolant, y: Interpolant, a: float, b: float) -> Interpolant:
        """a x + b y of two signals at the same times."""
        made = cls.__new__(cls)
        made.t = x.t
        made.values = [a * p + b * q for p, q in zip(x.values, y.values, strict=True)]
        made.cubics = [
            (a * p[0] + b * q[0], a * p[1] + b * q[1], a * p[2] + b * q[2], a * p[3] + b * q[3])
            for p, q in zip(x.cubics, y.cubics, strict=True)
        ]
        return made

    def step(self, time: float) -> int:
        """The step in which a time lies, the later one at a sample."""
        return min(max(bisect_right(self.t, time) - 1, 0), len(self.cubics) - 1)

    def share(self, i: int, time: float) -> float:
        """How far a time lies in step i, 0..1."""
        return (time - self.t[i]) / (self.t[i + 1] - self.t[i])

    def at(self, i: int, s: float) -> float:
        """The value in step i at a share of it."""
        if s == 1:
            return self.values[i + 1]
        c = self.cubics[i]
        return ((c[3] * s + c[2]) * s + c[1]) * s + c[0]

    def value(self, time: float) -> float:
        """The value at a time."""
        i = self.step(time)
        return self.at(i, self.share(i, time))

    def known(self, a: float, b: float) -> bool:
        """Whether there is a value all over a .. b (s)."""
        return all(all(map(isfinite, self.cubics[i])) for i in self.steps(a, b))

    def steps(self, a: float, b: float) -> range:
        """The steps of which a .. b (s) has a part."""
        first = self.step(a)
        last = first
        while last + 1 < len(self.cubics) and self.t[last + 1] < b:
            last += 1
        return range(first, last + 1)

    def marks(self, a: float, b: float) -> tuple[list[float], list[float]]:
        """Times and values of a, all samples and turning points in between, and b: monotone from one to the next."""
        times, values = [a], [self.value(a)]
        for i in self.steps(a, b):
            t, step = self.t[i], self.t[i + 1] - self.t[i]
            if a < t:
                times.append(t)
                values.append(self.values[i])
            for s in _turns(self.cubics[i]):
                time = t + s * step
                if times[-1] < time < b:
                    times.append(time)
                    values.append(self.at(i, s))
        times.append(b)
        values.append(self.value(b))
        return times, values

    def turning(self, a: float, b: float) -> tuple[list[float], list[float]]:
        """Times and values of a, the turning points in between, and b: monotone from one to the next to round-off."""
        times, values = self.marks(a, b)
        slack = LEVEL * max(abs(v) for v in values)
        kept, way, top, bottom = [0], 0, 0, 0
        for i, value in enumerate(values):
            if value > values[top]:
                top = i
            if value < values[bottom]:
                bottom = i
            if way >= 0 and values[top] - value > slack:
                if top > kept[-1]:
                    kept.append(top)
                way, bottom = -1, i
            elif way <= 0 and value - values[bottom] > slack:
                if bottom > kept[-1]:
                    kept.append(bottom)
                way, top = 1, i
        kept.append(len(values) - 1)
        return [times[i] for i in kept], [values[i] for i in kept]

    def extreme(self, stretches: Sequence[Interval], sign: float) -> tuple[float, float]:
        """The largest value in some stretches, or with the sign -1 the smallest, and its time, the first of equals."""
        best, place = -inf, nan
        for a, b in stretches:
            for time, value in zip(*self.marks(a, b), strict=True):
                if sign * value > best:
                    best, place = sign * value, time
        return sign * best, place

    def nodes(self, a: float, b: float) -> list[Node]:
        """Of quadrature over a .. b (s): step, share of it, weight (s)."""
        found = []
        for i in self.steps(a, b):
            step = self.t[i + 1] - self.t[i]
            low = self.share(i, a) if a > self.t[i] else 0.0
            high = self.share(i, b) if b < self.t[i + 1] else 1.0
            half = (high - low) / 2
            for place, weight in GAUSS:
                found.append((i, low + half * (1 + place), weight * half * step))
        return found

    def crossings(self, level: float, a: float, b: float) -> list[float]:
        """The times between a and b (s) at which the signal passes a level."""
        times, values = self.marks(a, b)
        found, sign, last = list[float](), 0, 0
        for k, value in enumerate(values):
            new = (value > level) - (value < level)
            if new == 0:
                continue
            if new == -sign:  # passed since the last mark off the level: at the one on it, or in between
                found.append(times[last + 1] if k > last + 1 else self.when(times[last], times[k], level))
            sign, last = new, k
        return found

    def when(self, a: float, b: float, level: float) -> float:
        """The time between a and b (s), where the signal is monotone, at which it has a level; the end nearer to it
        where it hasn't."""
        first, last = self.value(a), self.value(b)
        rising = last > first
        if (level <= first) if rising else (level >= first):
            return a
        if (level >= last) if rising else (level <= last):
            return b
        # The last sample before the level, by bisection.
        low, high = self.step(a), self.steps(a, b)[-1]
        while low < high:
            middle = (low + high + 1) // 2
            if self.values[middle] < level if rising else self.values[middle] > level:
                low = middle
            else:
                high = middle - 1
        i, step = low, self.t[low + 1] - self.t[low]
        start = self.share(i, a) if a > self.t[i] else 0.0
        end = self.share(i, b) if b < self.t[i + 1] else 1.0
        return self.t[i] + self._root(i, start, end, level) * step

    def _root(self, i: int, low: float, high: float, level: float) -> float:
        """The share of step i at which it has a level: Newton's steps inside a bracket, else bisection."""
        below, above = self.at(i, low) - level, self.at(i, high) - level
        if (below < 0) == (above < 0):
            return low if abs(below) <= abs(above) else high
        c, s = self.cubics[i], low + (high - low) * (below / (below - above))
        for _ in range(MOST_LOOKS):
            off = self.at(i, s) - level
            if off == 0:
                break
            if (off < 0) == (below < 0):
                low = s
            else:
                high = s
            slope = (3 * c[3] * s + 2 * c[2]) * s + c[1]
            new = s - off / slope if slope != 0 else low
            if not low < new < high:
                new = (low + high) / 2
            if abs(new - s) <= 1e-16:
                break
            s = new
        return s


def _ends(change: float, first: float, last: float, span: float) -> tuple[float, float]:
    """The slopes at both ends of a step over which a signal changes, from its rates times the step."""
    begins, closes = abs(first - change) <= span, abs(last - change) <= span
    if begins and closes:
        return first, last
    if begins:
        return first, 2 * change - first
    if closes:
        return 2 * change - last, last
    return change, change


def _turns(c: tuple[float, float, float, float]) -> list[float]:
    """The shares of a step at which its cubic turns, ascending."""
    a, b = 3 * c[3], c[2]
    inside = b * b - a * c[1]
    if not inside > 0:
        return []
    q = -(b + sqrt(inside)) if b >= 0 else sqrt(inside) - b
    shares = [*([q / a] if a != 0 else []), *([c[1] / q] if q != 0 else [])]
    return sorted(s for s in shares if 0 < s < 1)


def whole_turns(t: Sequence[float], values: Sequence[float], rates: Sequence[float]) -> list[float]:
    """How many turns an angle that is known without whole turns has made since the first sample, by its rates; NaN
    after a gap or a step of more than a turn, as nobody knows what it did there."""
    turns, found, begun = 0.0, list[float](), False
    for i in range(len(t)):
        known = isfinite(values[i])
        if begun and known:
            turned = (t[i] - t[i - 1]) * (rates[i - 1] + rates[i]) / 2
            turned = turned if isfinite(turned) else 0.0
            change = values[i] - values[i - 1] - turned
            turns -= floor(change / (2 * pi) + 0.5) if isfinite(change) and abs(turned) <= 2 * pi else nan
        elif begun:
            turns = nan
        begun = begun or known
        found.append(turns if known else nan)
    return found


def continuous(t: Sequence[float], values: Sequence[float], rates: Sequence[float]) -> list[float]:
    """Such an angle (rad) without jumps, from its first value."""
    turns = whole_turns(t, values, rates)
    return [v + 2 * pi * k for v, k in zip(values, turns, strict=True)]


def turned_levels(edge: float, least: float, most: float) -> list[float]:
    """The levels that are whole turns from an edge and lie around ``least`` .. ``most``; none of too many."""
    first, last = floor((least - edge) / (2 * pi)), floor((most - edge) / (2 * pi)) + 1
    return [edge + 2 * pi * k for k in range(first, last + 1)] if last - first < MOST_TURNS else []


def integral(stretches: Sequence[Interval], signal: Interpolant, value: Callable[[int, float], float]) -> float:
    """The integral over some stretches (s) of what ``value`` gives at a step and a share of it, on the steps of a
    signal."""
    total = 0.0
    for a, b in stretches:
        for i, s, weight in signal.nodes(a, b):
            total += weight * value(i, s)
    return total
