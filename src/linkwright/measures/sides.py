"""One-sided limits of expressions at places where they need not be continuous.

On one side of such a place the signals themselves are smooth (of a quotient, its numerator and its denominator). A
polynomial fitted to exact values and rates at a few times there gives each signal a germ: a series with error bounds
(:mod:`linkwright.measures.germs`). The expression is then evaluated with germs instead of numbers, and the leading
exponent of the result tells limit, pole or jump. Where germs can't decide, such as for logarithms, values at distances
that are halved again and again are compared; if these don't decide either, the limit counts as unknown.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import FUNCTIONS, Binary, Call, Name, Node, evaluate, is_signal
from linkwright.expressions.trees import children
from linkwright.measures.features import Feature, denominator
from linkwright.measures.germs import EPS, SMALL, TERMS, Germ, Undecided
from linkwright.measures.round_off import DIGITS, spreads
from linkwright.results import Run

Array = NDArray[np.float64]

NODES = 6
"""Times at which values and rates are taken for a polynomial of :data:`TERMS` coefficients."""
FITS = 1e-11
"""A polynomial that misses by no more than this share of the values stands for the signal."""
ROUGH = 1e-14
"""So does one that misses by this share of what is usual of the signal's dimension: near a zero that is round-off."""
NEARER = 12
"""How often the stretch is cut down to a fifth until it fits."""
FARTHEST = 1 / 64
"""The longest stretch, over the run's length: the longer it is, the less round-off counts in higher coefficients."""
HUGE = 1e100
"""Coefficients of higher powers are known no better than that on very short stretches."""
FITTED = 3
"""So many stretches on which it fits are compared."""
LENGTHS: Array = np.array([16.0, 4.0, 1.0, 0.25, 0.0625])
"""Stretches on which polynomials are fitted to an expression's own values, over that on which its signals are."""
LEAST = 1e-200
"""Values below this one tell nothing of a series."""
LEAST_NOISE = 0.05
"""Round-off is no less than this share of its bound."""
VALID = 0.3
"""The share of the stretch on which a germ stands for the expression ..."""
LOOKED, CLOSER = 65, 3
"""... looked at in so many places, so often about its extremes."""
SPREAD: Array = np.arange(1, LOOKED + 1) / LOOKED
"""The places, in 0..1; at them an expression's own values are taken, too."""
TRIES, CLOSEST, AGREES = 16, 1e-10, 1e-11
"""Distances at which a germ is compared with values, the nearest over the run's length, and how well they agree."""
LOOKS, COMPARED = 36, 9
"""Distances at which values are compared where germs don't decide; the nearest so many tell what they do."""
FACTOR, SHRINK = 1.05, 0.7
"""Growth over a halving that is a pole's; the last of eight steps over the first that has a limit."""
ALIKE = 1e-7
"""Values that change by less than this share at the nearest distances have a limit."""
NOISY = 1e-9
"""The share of an expression's usual value above which what comes of its signals' round-off spoils its values."""


@dataclass(frozen=True)
class Side:
    """What an expression does towards a time from one side: its limit (infinite with its sign, NaN where it isn't
    known), the exponent of s with which it grows there (negative of a pole, 0 where it has a limit or grows like a
    logarithm), and its germ, where that is known, which stands for it up to the distance ``radius`` (s). Up to the
    distance ``spoilt`` (s) its values are round-off of terms that cancel."""

    value: float
    exponent: Fraction = Fraction(0)
    germ: Germ | None = None
    radius: float = 0.0
    spoilt: float = 0.0

    @property
    def decided(self) -> bool:
        """Whether it is known what the expression does."""
        return not math.isnan(self.value)

    @property
    def removable(self) -> float:
        """The distance (s) up to which its germ or its limit has more digits than its values: terms that vanish cancel
        there. Beside a pole that is where the values are no more than round-off."""
        if not math.isfinite(self.value):
            return self.spoilt
        return max(self.radius if self.germ is not None else 0.0, self.spoilt)

    def near(self, most: float) -> tuple[Array, Array]:
        """Distances (s) up to there or to ``most``, and the germ's values."""
        if self.germ is None or not min(self.radius, most) > 0:
            return np.empty(0), np.empty(0)
        every = [min(self.radius, most) * SPREAD]
        for sign in (-1.0, 1.0):
            s = every[0]
            for _ in range(CLOSER):  # again and again, closely, about the extreme
                best = int(np.argmax(sign * self.germ(s)))
                low, high = s[best - 1] if best else 0.0, s[min(best + 1, s.size - 1)]
                s = low + (high - low) * SPREAD
                every.append(s)
        s = np.unique(np.concatenate(every))
        return s, self.germ(s)

    def integral(self, width: float, power: int) -> float:
        """The integral of a power from the place to the distance ``width`` (s); infinite or NaN where it diverges."""
        if self.exponent * power <= -1:
            return math.inf if power % 2 == 0 else self.value
        if self.germ is None:
            return self.value**power * width if math.isfinite(self.value) else math.nan
        # Integrate the series term by term.
        germ = self.germ**power if power > 1 else self.germ
        exponents = [float(germ.low + k * germ.step) + 1.0 for k in range(germ.c.size)]
        return math.fsum(c * width**e / e for c, e in zip(germ.c.tolist(), exponents, strict=True) if e > 0)


UNKNOWN = Side(math.nan)


def _polynomials() -> tuple[list[Any], Array]:
    """Chebyshev polynomials on 0..1, whose least squares are well conditioned, and their coefficients as powers."""
    basis = [np.polynomial.Chebyshev.basis(k, domain=[0, 1]) for k in range(TERMS)]
    powers = np.zeros((TERMS, TERMS))
    for k, one in enumerate(basis):  # integers
        powers[: k + 1, k] = np.rint(one.convert(kind=np.polynomial.Polynomial, domain=[-1, 1], window=[-1, 1]).coef)
    return basis, powers


def _stencil() -> tuple[Array, Array, Array]:
    """Places in 0..1, the matrix from values and rates there to coefficients, and that to what these miss there."""
    x = (1 - np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)) / 2
    back = np.array([np.concatenate([one(x), one.deriv()(x)]) for one in BASIS]).T
    fit = np.linalg.pinv(back)
    return x, POWERS @ fit, back @ fit - np.eye(2 * NODES)


BASIS, POWERS = _polynomials()
X, FIT, MISS = _stencil()
POLYNOMIALS: Array = np.array([one(SPREAD) for one in BASIS]).T


def _agrees(series: Germ, value: float, error: float) -> bool:
    """Whether the constant term of a power series is a value within the errors of both."""
    return abs(float(series.c[0]) - value) <= SMALL * (series.error + error)


def _farthest(away: Array) -> float:
    """The largest of some distances (s), 0 of none."""
    return float(away.max(initial=0.0))


class Sides:
    """One-sided limits of some expressions of a run, with their break functions."""

    def __init__(self, run: Run, node: Node, some: Sequence[Feature]) -> None:
        self.run, self.node, self.features = run, node, some
        self.trees = [node, *(feature.node for feature in some)]
        self.atoms: dict[Node, Node | None] = {}
        for tree in self.trees:
            self._collect(tree)
        self._numbers = run.compiled.quantities.parameters

    def _collect(self, node: Node) -> None:
        """The parts that are smooth beside a place: signals (with what they are divided by), tables, steps."""
        if is_signal(node):
            assert isinstance(node, Name | Call)
            divisor = denominator(self.run.compiled.quantities.signals.find(node))
            self.atoms[node] = divisor
            if divisor is not None:
                self._collect(divisor)
        elif isinstance(node, Call) and (node.name not in FUNCTIONS or node.name == "step5"):
            self.atoms[node] = None
        else:
            for child in children(node):
                self._collect(child)

    def limits_at(self, times: Array, side: int) -> list[tuple[Side, bool]]:
        """Towards each time from before (-1) or after (1): the limit, and whether any break function vanishes there."""
        if not times.size:
            return []
        fits = self._fitted(times, side)
        return [self._limit_at(float(t), side, *fits[i]) for i, t in enumerate(times)]

    def _limit_at(self, time: float, side: int, atoms: dict[Node, Germ], reach: float) -> tuple[Side, bool]:
        try:
            with np.errstate(all="ignore"):
                # First: does any break function vanish here on this side? If none does, the expression is smooth and
                # needs no limit.
                vanishing = [self._germ(f.node, time, side, atoms).leading() for f in self.features]
            touched = any(lead is None or lead[0] > 0 for lead in vanishing)
        except (Undecided, ZeroDivisionError):
            touched = True
        if not touched:
            return UNKNOWN, False
        try:
            with np.errstate(all="ignore"):
                # Second: the germ of the expression itself. Its leading exponent gives limit or pole.
                germ = self._germ(self.node, time, side, atoms)
            value, exponent = germ.limit()
            if math.isfinite(value) and germ.step == 1 and germ.low.denominator == 1:
                # A removable place: values farther away, where less cancels, may tell the series more sharply.
                farther = [one for one in self._smooth_series(time, side, reach) if _agrees(one, value, germ.error)]
                germ = min([germ, *farther], key=lambda one: one.error)
                value = germ.limit()[0]
            error = germ.error if math.isfinite(value) else 0.0
            if not math.isnan(value):
                # Third: the distance up to which the germ agrees with evaluated values, where these have digits.
                away, values, noise = self._beside(time, side, reach)
                blurred = noise > ALIKE * np.abs(values)
                spoilt = self._spoilt(away, values, noise) if math.isfinite(value) else _farthest(away[blurred])
                lasting = ~blurred if math.isfinite(value) else np.full(away.size, True)
                size = max(abs(value), float(np.abs(values[lasting]).max(initial=0.0)))
                germ = germ.stripped() if germ.leading() is not None else Germ.constant(0.0)
                near = lasting & (away <= VALID * reach)
                radius = self._valid(germ, away[near], values[near], noise[near])
                if error <= ALIKE * size and (radius or not lasting.any() or not spoilt):
                    return Side(value, min(exponent, Fraction(0)), germ if radius else None, radius, spoilt), True
        except (Undecided, ZeroDivisionError, OverflowError):
            pass
        # The germs decide nothing: compare values at smaller and smaller distances.
        return self.compared(time, side), True

    def _smooth_series(self, time: float, side: int, reach: float) -> Iterator[Germ]:
        """Polynomials fitted to the expression's own values beside a place, each weighted by its round-off."""
        for length in reach * LENGTHS[reach * LENGTHS <= self._room(time, side)]:
            s = length * SPREAD
            values, noise = self._values(time + side * s)
            noise += 4 * EPS * np.abs(values)
            known = np.isfinite(values) & np.isfinite(noise)
            size = float(np.abs(values[known]).max(initial=0.0))
            sound = known & (noise > EPS**2 * size)
            if np.count_nonzero(sound) < 2 * TERMS or not size > LEAST:
                continue
            weighted = POLYNOMIALS[sound] / noise[sound, None]
            inverse = np.linalg.pinv(weighted)
            c = inverse @ (values[sound] / noise[sound])
            miss = float(np.abs(weighted @ c - values[sound] / noise[sound]).max())
            # What the values scatter by about the polynomial tells their round-off; it is bounded rather widely.
            e = np.abs(POWERS @ inverse).sum(axis=1) * max(miss, LEAST_NOISE)
            scale = length ** -np.arange(TERMS, dtype=np.float64)
            yield Germ(POWERS @ c * scale, e * scale)

    def _beside(self, time: float, side: int, reach: float) -> tuple[Array, Array, Array]:
        """Distances (s) from far to near, the values there, and what round-off may change them by."""
        s = np.asarray(reach * 0.25 ** np.arange(TRIES), dtype=np.float64)
        s = s[s > CLOSEST * (self.run.stop - self.run.start)]
        t: Array = time + side * s
        inside = (t >= self.run.start) & (t <= self.run.stop)
        return s[inside], *self._values(t[inside])

    def _values(self, t: Array) -> tuple[Array, Array]:
        """The expression at times, and what round-off may change it by."""
        if not t.size:
            return np.empty(0), np.empty(0)
        with np.errstate(all="ignore"):
            values = np.asarray(self.run.jets(self.node, t).d[0])
            (spread,) = spreads(self.run, [self.node], t, DIGITS)
            noise = np.maximum(spread.high - values, values - spread.low)
        return values, np.where(np.isnan(noise), np.inf, noise)

    @staticmethod
    def _spoilt(away: Array, values: Array, noise: Array) -> float:
        """The largest distance (s) at which round-off spoils the values."""
        sound = np.isfinite(values) & np.isfinite(noise)
        usual = float(np.median(np.abs(values[sound]))) if sound.any() else 0.0
        return _farthest(away[~(noise <= NOISY * usual)])

    def _valid(self, germ: Germ, s: Array, values: Array, noise: Array) -> float:
        """How far (s) a germ stands for the expression: the distance, of some from far to near, at which its values
        agree, or agree best; 0 where they never do."""
        # Compare from far to near; the largest distance at which they agree counts.
        if not s.size:
            return 0.0
        with np.errstate(all="ignore"):
            size = np.maximum(np.abs(values), 1e-3 * np.abs(values).max())
            off = np.maximum(np.abs(germ(s) - values) - noise, 0.0) / size
        off = np.where(np.isnan(off), np.inf, off)
        close = np.flatnonzero(off <= AGREES)
        best = int(close[0]) if close.size else int(np.argmin(off))
        return float(s[best]) if off[best] <= ALIKE else 0.0

    def _germ(self, node: Node, time: float, side: int, atoms: dict[Node, Germ]) -> Germ:
        """The germ of an expression from those of its atoms."""

        def germ(part: Node) -> Germ:
            if part in atoms:
                return atoms[part]
            if isinstance(part, Name) and part.text == "t":
                c, e = np.zeros(TERMS), np.zeros(TERMS)
                c[0], c[1], e[0] = time, side, self._sharp(time)
                return Germ(c, e)
            if isinstance(part, Call) and part.attribute is None:
                found = FUNCTIONS[part.name].apply(*(germ(arg) for arg in part.args))
            elif isinstance(part, Binary):
                placed = {Name("left"): germ(part.left), Name("right"): germ(part.right)}
                found = evaluate(Binary(part.op, Name("left"), Name("right")), placed.__getitem__)
            elif children(part):
                found = -germ(children(part)[0])
            else:
                found = evaluate(part, lambda name: self._numbers[name.text])
            return found if isinstance(found, Germ) else Germ.constant(float(found), 0.5 * EPS * abs(float(found)))

        return germ(node)

    def _sharp(self, time: float) -> float:
        """How far off (s) a place may be that was root-found."""
        return EPS * max(abs(time), self.run.stop - self.run.start)

    def _fitted(self, times: Array, side: int) -> list[tuple[dict[Node, Germ], float]]:
        """The atoms' germs at each time with the stretch (s) that they hold on, cut down until a polynomial fits."""
        run, atoms = self.run, list(self.atoms)
        found: list[dict[Node, Germ]] = [{} for _ in times]
        reach = self._fit_lengths(times, side)
        kept, least, fits = reach.copy(), np.full(times.size, np.inf), np.zeros(times.size, dtype=int)
        left = np.arange(times.size) if atoms else np.empty(0, dtype=int)
        # What a signal may miss a polynomial by; of quotients their numerators are fitted.
        round_off = np.array([ROUGH * run.cancelling(node) if self.atoms[node] is None else 0.0 for node in atoms])
        for attempt in range(NEARER):
            if not left.size:
                break
            # Sample each atom at Chebyshev nodes on this side of the time, values and rates.
            t = times[left, None] + side * reach[left, None] * X
            values, slopes = self._smooth(atoms, t.ravel())
            # Rates count per stretch, so that they have the unit of the values.
            data = np.concatenate(
                [values.reshape(len(atoms), *t.shape), side * reach[left, None] * slopes.reshape(len(atoms), *t.shape)],
                axis=2,
            )
            # Fit, and measure what the polynomial misses at the nodes.
            c = data @ FIT.T
            miss = np.abs(data @ MISS.T).max(axis=2)
            size = np.abs(data[:, :, :NODES]).max(axis=2) + 1e-300
            good = (miss <= np.maximum(FITS * size, round_off[:, None])).all(axis=0) | (attempt == NEARER - 1)
            # Errors of the coefficients: round-off of the data, the misfit, and the uncertainty of the time itself.
            noise = 4 * EPS * np.abs(data) + 2 * miss[:, :, None]
            off = np.array([self._sharp(time) for time in times[left].tolist()]) / reach[left]
            noise += off[None, :, None] * np.abs(c[:, :, 1:2])
            e = noise @ np.abs(FIT).T
            with np.errstate(over="ignore"):
                scale = np.minimum(reach[left, None] ** -np.arange(TERMS), HUGE)
            # Of good fits on stretches cut down to a fifth each time, that with the sharpest curvature is taken.
            with np.errstate(over="ignore"):
                sharp = (e[:, :, 2] / size).max(axis=0) * scale[:, 2]
            for k in np.flatnonzero(good & (~(sharp >= least[left]) | np.isinf(least[left]))):
                germs = (Germ(c[i, k] * scale[k], e[i, k] * scale[k]) for i in range(len(atoms)))
                found[left[k]] = dict(zip(atoms, germs, strict=True))
                least[left[k]], kept[left[k]] = sharp[k], reach[left[k]]
            fits[left] += good
            left = left[fits[left] < FITTED]
            reach[left] /= 5.0
        for some in found:
            self._divided(some)
        return list(zip(found, kept.tolist(), strict=True))

    def _divided(self, atoms: dict[Node, Germ]) -> None:
        """Signals that are quotients: their numerators over their denominators."""
        for node, divisor in self.atoms.items():
            if divisor is not None and node in atoms:
                try:
                    atoms[node] = atoms[node] / self._germ(divisor, 0.0, 1, atoms)
                except Undecided:
                    atoms[node] = Germ.constant(math.nan, math.inf)

    def _smooth(self, atoms: Sequence[Node], t: Array) -> tuple[Array, Array]:
        """Values and rates of the atoms, of quotients those of their numerators."""
        products = [node if (by := self.atoms[node]) is None else Binary("*", node, by) for node in atoms]
        return self.run.all_rates(products, t)

    def _fit_lengths(self, times: Array, side: int) -> Array:
        """How far (s) a polynomial may reach: a step of the grid, half the way to the next break of a load or law."""
        room: Array = np.array([self._room(time, side) for time in times.tolist()])
        room[:] = np.minimum(room, (self.run.stop - self.run.start) * FARTHEST)
        return room

    def _room(self, time: float, side: int) -> float:
        """Half the way (s) to the next break of a load or law, or to the end of the run."""
        run = self.run
        ahead = side * (np.concatenate([run.breaks, [run.start, run.stop]]) - time)
        return float(ahead[ahead > 1e-9 * (run.stop - run.start)].min(initial=np.inf)) / 2

    def compared(self, time: float, side: int) -> Side:
        """The limit from values at distances that are halved, as near as these are more than round-off."""
        run = self.run
        away = self._fit_lengths(np.array([time]), side)[0] * 0.5 ** np.arange(LOOKS)
        away = away[away > 1e-12 * (run.stop - run.start)]
        values, noise = self._values(time + side * away)
        values = values[: int(np.argmax(np.isnan(values)))] if np.isnan(values).any() else values
        with np.errstate(all="ignore"):
            # Nearer than this values are round-off, compared to what is usual some way off: they tell nothing.
            size = np.maximum(np.abs(values), np.median(np.abs(values[:COMPARED]))) if values.size else values
            for share in (NOISY, ALIKE):
                bad = np.flatnonzero(noise[: values.size] > share * size)
                count = int(bad[0]) if bad.size else values.size
                if count >= COMPARED:
                    return self._compared(values[:count], noise[:count], float(away[count]) if bad.size else 0.0)
        return UNKNOWN

    @staticmethod
    def _compared(values: Array, noise: Array, spoilt: float) -> Side:
        """The limit of values at distances that are halved; nearer than the distance ``spoilt`` there are none."""
        last, near, steps = float(values[-1]), values[-COMPARED:], np.diff(values[-COMPARED:])
        ratio = np.abs(near[1:] / near[:-1])
        # Growth by equal factors: a pole; past the largest number: what grows even faster.
        grows = np.isfinite(ratio).all() and ratio.min() > FACTOR
        if np.isinf(last) or (grows and noise[-1] <= ALIKE * abs(last)):
            ratio = ratio[np.isfinite(ratio)] if np.isfinite(ratio).any() else np.array([np.inf])
            power = Fraction(-math.log2(float(np.clip(np.median(ratio), 1.0, 2.0**50)))).limit_denominator(12)
            return Side(math.copysign(math.inf, last), min(power, Fraction(-1, 12)), spoilt=spoilt)
        if not np.isfinite(near).all():
            return UNKNOWN
        # Steps that vanish or shrink: a limit.
        if np.abs(steps).max() <= ALIKE * np.abs(near).max() or np.abs(steps[-1]) < SHRINK * np.abs(steps[0]):
            return Side(last, spoilt=spoilt) if not spoilt else Sides._extrapolated(near, spoilt)
        # Growth by equal steps: a logarithm.
        even = np.abs(steps).min() > 0.5 * np.abs(steps).max() and (np.sign(steps) == np.sign(steps[0])).all()
        return Side(math.copysign(math.inf, float(steps[-1])), spoilt=spoilt) if even else UNKNOWN

    @staticmethod
    def _extrapolated(near: Array, spoilt: float) -> Side:
        """The limit past the last value, by Aitken's rule; unknown where two of its results differ."""
        steps = np.diff(near)
        share = steps[1:] / steps[:-1]
        rest = np.where(np.abs(share) < 1, steps[1:] * share / (1 - share), 0.0)
        limits = near[2:] + rest
        sure = abs(limits[-1] - limits[-2]) <= NOISY * np.abs(near).max()
        return Side(float(limits[-1]), spoilt=spoilt) if sure else UNKNOWN
