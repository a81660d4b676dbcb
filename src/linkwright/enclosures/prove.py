"""Branch and bound over time: that no value of an expression lies outside what is said of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures.bounds import above
from linkwright.enclosures.motion import Enclosure
from linkwright.enclosures.panels import MARGIN
from linkwright.enclosures.taylor import TaylorModel
from linkwright.kernels.passages import GAP
from linkwright.model.expressions import Node
from linkwright.results import Run

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Span = tuple[float, float]

FIRST = 24
"""Panels over the run to begin with."""
NARROWEST = 2.0**-34
"""No panel is cut below this share of the run."""
BUDGET = 4000
"""Panels evaluated at most."""
CLOSE, ROUND_OFF = 1e-9, 1e-10
"""How far values may lie outside: over the distance of the limits, and over their magnitude."""


@dataclass(frozen=True)
class Claim:
    """That an expression (bound to SI) stays between ``low`` and ``high`` over ``spans`` (s); either may be infinite.

    ``slack`` is what it may lie outside besides 1e-9 of their distance, for values that are round-off themselves.
    """

    node: Node
    spans: tuple[Span, ...]
    low: float
    high: float
    slack: float = 0.0

    @property
    def tolerance(self) -> float:
        """How far values may lie outside."""
        ends = [abs(end) for end in (self.low, self.high) if np.isfinite(end)]
        wide = self.high - self.low
        return CLOSE * (wide if np.isfinite(wide) else 0.0) + ROUND_OFF * max(ends, default=0.0) + self.slack


@dataclass(frozen=True)
class Refuted:
    """A time (s) at which the value lies outside a claim, and a bound on the near side of it: one proven to be passed."""

    time: float
    value: float


@dataclass(frozen=True)
class Proof:
    """What is known of a claim: ``low`` and ``high`` hold all values over the panels that are decided.

    ``open`` are the panels (s) of which nothing is proven, for the caller to look at; ``reason`` says why there are
    any: "change-point", "undefined" (a denominator that may vanish, a root that
    may leave its domain), "budget"; or "refuted".
    """

    low: float
    high: float
    open: tuple[Span, ...] = ()
    reason: str = ""
    panels: int = 0
    refuted: Refuted | None = None

    @property
    def done(self) -> bool:
        """Whether the claim is proven."""
        return not self.open and self.refuted is None and not self.reason


def prove(
    run: Run,
    node: Node,
    spans: Sequence[Span],
    low: float,
    high: float,
    edges: Sequence[float] = (),
    budget: int = BUDGET,
) -> Proof:
    """Prove that an expression stays between two values; see :func:`prove_all`."""
    return prove_all(run, [Claim(node, tuple(spans), low, high)], edges, budget)[0]


def prove_all(run: Run, claims: Sequence[Claim], edges: Sequence[float] = (), budget: int = BUDGET) -> list[Proof]:
    """Prove claims on expressions of one run together: every panel is evaluated once for all of them.

    Panels also end at ``edges`` (s): times at which something may jump or bend, to round-off. Within 1e-12 of the run
    of an edge, values count as those of both sides. ``budget`` is the number of panels that are evaluated at most.
    """
    enclosure = Enclosure(run, [claim.node for claim in claims])
    search = _Search(run, enclosure, claims, edges)
    search.go(budget)
    return search.proofs()


def sign(
    run: Run, node: Node, spans: Sequence[Span], edges: Sequence[float] = (), budget: int = BUDGET
) -> tuple[tuple[Span, ...], str]:
    """Where an expression may have a zero (spans, s), and why that isn't known better; elsewhere it has none."""
    enclosure = Enclosure(run, [node])
    search = _Search(run, enclosure, [Claim(node, tuple(spans), -np.inf, np.inf)], edges, zeros=True)
    search.go(budget)
    (proof,) = search.proofs()
    return proof.open, proof.reason


class _Search:
    def __init__(
        self, run: Run, enclosure: Enclosure, claims: Sequence[Claim], edges: Sequence[float], zeros: bool = False
    ) -> None:
        self.run, self.enclosure, self.claims, self.zeros = run, enclosure, claims, zeros
        length = run.stop - run.start
        ends = [end for claim in claims for span in claim.spans for end in span]
        bands = [(p.time - GAP * p.width, p.time + GAP * p.width) for p in run.compiled.passages.every]
        ends += [end for band in bands for end in band]
        every = np.unique(np.clip([*ends, *edges, *np.linspace(run.start, run.stop, FIRST + 1)], run.start, run.stop))
        # Edges nearer to one another than the panels' margin are one.
        every = every[np.append(True, np.diff(every) > MARGIN * length)]
        start, stop = every[:-1], every[1:]
        self.closed: list[tuple[int, Span]] = []  # panels that aren't looked at further
        self.panels = enclosure.panels(start, stop)
        self.asked = np.array([_covered(start, stop, claim.spans, 1e-11 * length) for claim in claims])
        barred = _covered(start, stop, bands, 0.0)
        self.closed += [(int(i), self._span(p)) for i, p in zip(*np.nonzero(self.asked & barred), strict=True)]
        self.passed = {i for i, _ in self.closed}
        self.asked &= ~barred
        self._keep(self.asked.any(axis=0))
        self.low, self.high = np.full(len(claims), np.inf), np.full(len(claims), -np.inf)
        self.refuted: dict[int, Refuted] = {}
        self.count = np.zeros(len(claims), dtype=int)
        self.undefined = np.zeros(len(claims), dtype=bool)
        self.limits = np.array([(c.low - c.tolerance, c.high + c.tolerance) for c in claims])

    def _keep(self, which: Flags) -> None:
        self.panels, self.asked = self.panels.some(which), self.asked[:, which]

    def go(self, budget: int) -> None:
        """Evaluate and cut panels until all are decided."""
        spent = 0
        while self.panels.count and spent + self.panels.count <= budget:
            spent += self.panels.count
            self.count += self.asked.sum(axis=1)
            self.decide()
            undecided = self.asked.any(axis=0)
            self._keep(undecided)
            narrow = self.panels.stop - self.panels.start < NARROWEST * (self.run.stop - self.run.start)
            for claim, panel in zip(*np.nonzero(self.asked & narrow), strict=True):
                self.closed.append((int(claim), self._span(panel)))
            self._keep(~narrow)
            self.panels, self.asked = self.panels.halves(), np.concatenate([self.asked, self.asked], axis=1)

    def _span(self, panel: int) -> Span:
        return float(self.panels.start[panel]), float(self.panels.stop[panel])

    def decide(self) -> None:
        """Take off all that the panels decide."""
        models = self.enclosure(self.panels)
        claim, panel = np.nonzero(self.asked)
        terms = max(len(m.c) for m in models)
        c = np.zeros((terms, claim.size))
        r = np.empty(claim.size)
        for i, model in enumerate(models):
            here = claim == i
            c[: len(model.c), here], r[here] = model.c[:, panel[here]], model.r[panel[here]]
        low, high = TaylorModel(c, r, self.panels.some(panel)).range()
        known = np.isfinite(low) & np.isfinite(high)
        self.undefined[claim[~known]] = True
        limits = self.limits[claim]
        if self.zeros:
            with np.errstate(invalid="ignore"):
                loose = known & ~((low > 0) | (high < 0))
        else:
            with np.errstate(invalid="ignore"):
                loose = known & ((low < limits[:, 0]) | (high > limits[:, 1]))
        if loose.any():
            some = c[:, loose]
            top, reached, at = above(some)
            bottom, sunk, place = above(-some)
            high[loose] = np.minimum(high[loose], top + r[loose])
            low[loose] = np.maximum(low[loose], -bottom - r[loose])
            for wrong, sign_, value, h in (
                (reached - r[loose] > limits[loose, 1], 1.0, reached - r[loose], at),
                (sunk - r[loose] > -limits[loose, 0], -1.0, sunk - r[loose], place),
            ):
                for k in np.flatnonzero(wrong):
                    which = np.flatnonzero(loose)[k]
                    i, on = int(claim[which]), panel[which]
                    time = float(self.panels.mid[on] + self.panels.half[on] * h[k])
                    self._refute(i, Refuted(time, float(sign_ * value[k])))
        with np.errstate(invalid="ignore"):
            if self.zeros:
                decided = known & ((low > 0) | (high < 0))
            else:
                decided = known & (low >= limits[:, 0]) & (high <= limits[:, 1])
        np.minimum.at(self.low, claim[decided], low[decided])
        np.maximum.at(self.high, claim[decided], high[decided])
        self.asked[claim[decided], panel[decided]] = False
        for i in self.refuted:
            self.asked[i] = False

    def _refute(self, claim: int, by: Refuted) -> None:
        self.refuted.setdefault(claim, by)

    def proofs(self) -> list[Proof]:
        """What came out."""
        found = []
        for i in range(len(self.claims)):
            spans = [span for claim, span in self.closed if claim == i]
            spans += [self._span(panel) for panel in np.flatnonzero(self.asked[i])]
            low, high = (float(np.nextafter(v, w)) for v, w in ((self.low[i], -np.inf), (self.high[i], np.inf)))
            reason = ""
            if i in self.refuted:
                reason, spans = "refuted", []
            elif spans:
                reason = "change-point" if i in self.passed else "undefined" if self.undefined[i] else "budget"
            found.append(Proof(low, high, _joined(spans), reason, int(self.count[i]), self.refuted.get(i)))
        return found


def _covered(start: Array, stop: Array, spans: Sequence[Span], close: float) -> Flags:
    """Which panels lie in one of some spans."""
    middle = 0.5 * (start + stop)
    inside = np.zeros(len(start), dtype=bool)
    for a, b in spans:
        inside |= (middle > a - close) & (middle < b + close)
    return inside


def _joined(spans: list[Span]) -> tuple[Span, ...]:
    """Neighbouring panels put together."""
    found: list[Span] = []
    for a, b in sorted(spans):
        if found and a <= found[-1][1]:
            found[-1] = found[-1][0], max(b, found[-1][1])
        else:
            found.append((a, b))
    return tuple(found)
