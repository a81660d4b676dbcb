"""One-sided limits of expressions at places where they need not be continuous.

On one side of such a place the signals themselves are smooth (of a quotient, its numerator and its denominator). A
polynomial fitted to exact values and rates at a few times there gives each signal a germ: a series with error bounds
(:mod:`linkwright.measures.germs`). The expression is then evaluated with germs instead of numbers, and the leading
exponent of the result tells limit, pole or jump. Where germs can't decide, such as for logarithms, values at distances
that are halved again and again are compared; if these don't decide either, the limit counts as unknown.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import FUNCTIONS, Binary, Call, Name, Node, evaluate, is_signal
from linkwright.expressions.trees import children
from linkwright.measures.features import Feature, denominator
from linkwright.measures.germs import EPS, TERMS, Germ, Undecided
from linkwright.results import Run

Array = NDArray[np.float64]

NODES = 6
"""Times at which values and rates are taken for a polynomial of :data:`TERMS` coefficients."""
FITS = 1e-11
"""A polynomial that misses by no more than this share of the values stands for the signal."""
NEARER = 9
"""How often the stretch is cut down to a fifth until it fits."""
VALID = 0.05
"""The share of the stretch on which a germ stands for the expression ..."""
LOOKED = 65
"""... looked at in so many places."""
TRIES, CLOSEST, AGREES = 16, 1e-10, 1e-11
"""Distances at which a germ is compared with values, the nearest over the run's length, and how well they agree."""
LOOKS = 36
"""Distances at which values are compared where germs don't decide."""
FACTOR, SHRINK = 1.05, 0.7
"""Growth over a halving that is a pole's; the last of eight steps over the first that has a limit."""
ALIKE = 1e-7
"""Values that change by less than this share at the nearest distances have a limit."""


@dataclass(frozen=True)
class Side:
    """What an expression does towards a time from one side: its limit (infinite with its sign, NaN where it isn't
    known), the exponent of s with which it grows there (negative of a pole, 0 where it has a limit or grows like a
    logarithm), and its germ, where that is known, which stands for it up to the distance ``radius`` (s)."""

    value: float
    exponent: Fraction = Fraction(0)
    germ: Germ | None = None
    radius: float = 0.0

    @property
    def decided(self) -> bool:
        """Whether it is known what the expression does."""
        return not math.isnan(self.value)

    @property
    def removable(self) -> float:
        """The distance (s) up to which its germ has more digits than its values: terms that vanish cancel there."""
        return self.radius if self.germ is not None and math.isfinite(self.value) else 0.0

    def near(self, most: float) -> tuple[Array, Array]:
        """Distances (s) up to there or to ``most``, and the germ's values."""
        assert self.germ is not None
        s = min(self.radius, most) * np.arange(1, LOOKED + 1) / LOOKED
        values = self.germ(s)
        for best in (int(np.argmin(values)), int(np.argmax(values))):  # once more, closely, about the extremes
            low, high = s[max(best - 1, 0)], s[min(best + 1, LOOKED - 1)]
            s = np.append(s, np.linspace(low, high, LOOKED))
        s = np.unique(s)
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


def _stencil() -> tuple[Array, Array, Array]:
    """Places in 0..1, the matrix from values and rates there to coefficients, and that from these back."""
    # Chebyshev nodes in 0 .. 1, and the matrix of powers and their slopes there; its pseudoinverse fits a polynomial
    # to values and rates.
    x = (1 - np.cos(np.pi * (np.arange(NODES) + 0.5) / NODES)) / 2
    powers = np.arange(TERMS)
    back = np.concatenate([x[:, None] ** powers, powers * x[:, None] ** np.maximum(powers - 1, 0)])
    return x, np.linalg.pinv(back), back


X, FIT, BACK = _stencil()


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
            if not math.isnan(value):
                # Third: the distance up to which the germ agrees with evaluated values.
                germ = germ.stripped() if germ.leading() is not None else Germ.constant(0.0)
                radius = self._valid(germ, time, side, VALID * reach)
                return Side(value, min(exponent, Fraction(0)), germ if radius else None, radius), True
        except (Undecided, ZeroDivisionError, OverflowError):
            pass
        # The germs decide nothing: compare values at smaller and smaller distances.
        return self.compared(time, side), True

    def _valid(self, germ: Germ, time: float, side: int, reach: float) -> float:
        """How far (s) a germ stands for the expression: the distance at which its values agree, or agree best; 0 where
        they never do."""
        # Compare from far to near; the largest distance at which they agree counts.
        s = np.asarray(reach * 0.25 ** np.arange(TRIES), dtype=np.float64)
        s = s[s > CLOSEST * (self.run.stop - self.run.start)]
        t: Array = time + side * s
        inside = (t >= self.run.start) & (t <= self.run.stop)
        s, t = s[inside], t[inside]
        if not s.size:
            return 0.0
        with np.errstate(all="ignore"):
            values = np.asarray(self.run.jets(self.node, t).d[0])
            off = np.abs(germ(s) - values) / np.maximum(np.abs(values), 1e-3 * np.abs(values).max())
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
        atoms = list(self.atoms)
        found: list[dict[Node, Germ]] = [{} for _ in times]
        reach = self._fit_lengths(times, side)
        left = np.arange(times.size) if atoms else np.empty(0, dtype=int)
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
            miss = np.abs(c @ BACK.T - data).max(axis=2)
            size = np.abs(data[:, :, :NODES]).max(axis=2) + 1e-300
            good = (miss <= FITS * size).all(axis=0) | (attempt == NEARER - 1)
            # Errors of the coefficients: round-off of the data, the misfit, and the uncertainty of the time itself.
            noise = 4 * EPS * np.abs(data) + 2 * miss[:, :, None]
            off = np.array([self._sharp(time) for time in times[left].tolist()]) / reach[left]
            noise += off[None, :, None] * np.abs(c[:, :, 1:2])
            e = noise @ np.abs(FIT).T
            scale = reach[left, None] ** -np.arange(TERMS)
            # Accept good fits as germs in s; the others are repeated on a fifth of the stretch.
            for k in np.flatnonzero(good):
                germs = (Germ(c[i, k] * scale[k], e[i, k] * scale[k]) for i in range(len(atoms)))
                found[left[k]] = dict(zip(atoms, germs, strict=True))
            left = left[~good]
            reach[left] /= 5.0
        for some in found:
            self._divided(some)
        return list(zip(found, reach.tolist(), strict=True))

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
        run = self.run
        room = np.full(times.size, (run.stop - run.start) / max(run.grid, 64))
        aside = 1e-9 * (run.stop - run.start)
        breaks = np.concatenate([run.breaks, [run.start, run.stop]])
        for i, t in enumerate(times):
            ahead = side * (breaks - t)
            ahead = ahead[ahead > aside]
            room[i] = min(room[i], float(ahead.min(initial=np.inf)) / 2)
        return room

    def compared(self, time: float, side: int) -> Side:
        """The limit from values at distances that are halved, as near as there are values."""
        run = self.run
        # Values at distances that are halved; the differences of the last eight tell how they behave.
        away = self._fit_lengths(np.array([time]), side)[0] * 0.5 ** np.arange(LOOKS)
        away = away[away > 1e-12 * (run.stop - run.start)]
        with np.errstate(all="ignore"):
            values = np.asarray(run.jets(self.node, time + side * away).d[0])
            values = values[: int(np.argmax(np.isnan(values)))] if np.isnan(values).any() else values
            if values.size < 9:
                return UNKNOWN
            last, near, steps = float(values[-1]), values[-9:], np.diff(values[-9:])
            ratio = np.abs(near[1:] / near[:-1])
            # Growth by equal factors: a pole; past the largest number: what grows even faster.
            if np.isinf(last) or (np.isfinite(ratio).all() and ratio.min() > FACTOR):
                ratio = ratio[np.isfinite(ratio)] if np.isfinite(ratio).any() else np.array([np.inf])
                power = Fraction(-math.log2(float(np.clip(np.median(ratio), 1.0, 2.0**50)))).limit_denominator(12)
                return Side(math.copysign(math.inf, last), min(power, Fraction(-1, 12)))
            if not np.isfinite(near).all():
                return UNKNOWN
            # Steps that vanish or shrink: a limit.
            if np.abs(steps).max() <= ALIKE * np.abs(near).max() or np.abs(steps[-1]) < SHRINK * np.abs(steps[0]):
                return Side(last)
            # Growth by equal steps: a logarithm.
            even = np.abs(steps).min() > 0.5 * np.abs(steps).max() and (np.sign(steps) == np.sign(steps[0])).all()
            return Side(math.copysign(math.inf, float(steps[-1])), Fraction(0)) if even else UNKNOWN
