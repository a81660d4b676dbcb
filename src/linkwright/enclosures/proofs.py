"""Proofs by branch and bound over time: an expression stays between two limits over all of some spans.

The run is cut into panels, over each of which the expression is enclosed by a Taylor model. A panel is decided where
the enclosure lies within the limits; it refutes the claim where a value is proven to lie outside; else it is halved.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.enclosures.bounds import ROUND, above, evaluated
from linkwright.enclosures.motion import Enclosure
from linkwright.enclosures.panels import MARGIN, PRECISE
from linkwright.enclosures.taylor import TaylorModel
from linkwright.expressions.language import Node
from linkwright.kernels.change_points import GAP
from linkwright.results import Run

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
Whole = NDArray[np.intp]
Span = tuple[float, float]

FIRST, MOST_FIRST = 48, 1 << 13
"""Panels to begin with: over the run, or over a turn of the drive that turns most; and of all at most."""
NARROWEST = 2.0**-34
"""No panel is cut below this share of the run."""
VAGUEST = 2.0**-24
"""Nor one below this share of it of which nothing is known."""
BUDGET = 40
"""Panels evaluated at most, over those to begin with."""
OVERHEAD = 8
"""What a round of evaluations costs besides, in panels."""
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
    """A time (s) at which the value lies outside a claim, and a bound beyond the limit that it is proven to pass."""

    time: float
    value: float


@dataclass(frozen=True)
class Proof:
    """What is known of a claim: ``low`` and ``high`` hold all values over the panels that are decided.

    ``open`` are the panels (s) of which nothing is proven, for the caller to look at; ``reason`` says why there are
    any: "change-point", "undefined" (a denominator that may vanish, a root that may leave its domain), "round-off" (the
    bounds don't fall any further), "budget" (panels are left, or too narrow to be cut); or "refuted".
    """

    low: float
    high: float
    open: tuple[Span, ...] = ()
    reason: str = ""
    panels: int = 0
    refuted: Refuted | None = None

    @property
    def is_proven(self) -> bool:
        """Whether the claim is proven."""
        return not self.open and self.refuted is None and not self.reason


def prove(
    run: Run,
    node: Node,
    spans: Sequence[Span],
    low: float,
    high: float,
    edges: Sequence[float] = (),
    budget: int | None = None,
) -> Proof:
    """Prove that an expression stays between two values; see :func:`prove_all`."""
    return prove_all(run, [Claim(node, tuple(spans), low, high)], edges, budget)[0]


def prove_all(run: Run, claims: Sequence[Claim], edges: Sequence[float] = (), budget: int | None = None) -> list[Proof]:
    """Prove claims on expressions of one run together: every panel is evaluated once for all of them.

    Panels also end at ``edges`` (s): times at which something may jump or bend, to round-off. Within 1e-13 of the run
    of an edge, values count as those of both sides. ``budget`` is the number of panels that are evaluated at most, by
    default some 2000 a turn of the drives.
    """
    return _proofs(run, claims, edges, budget, False)


def sign(
    run: Run, node: Node, spans: Sequence[Span], edges: Sequence[float] = (), budget: int | None = None
) -> tuple[tuple[Span, ...], str]:
    """Where an expression may have a zero (spans, s), and why that isn't known better; elsewhere it has none."""
    (proof,) = _proofs(run, [Claim(node, tuple(spans), -np.inf, np.inf)], edges, budget, True)
    return proof.open, proof.reason


def _first(run: Run) -> int:
    """The number of panels over the run to begin with."""
    t = np.linspace(run.start, run.stop, 1025)
    turns = [1.0]
    for name in run.compiled.graph.motors:
        if run.compiled.mechanism.prescribed(name).turns:
            rate = np.abs(np.broadcast_to(run.compiled.laws[name](t).d[1], t.shape))
            turns.append(float(rate.mean()) * (run.stop - run.start) / (2 * np.pi))
    return int(min(FIRST * max(turns), MOST_FIRST))


def _proofs(run: Run, claims: Sequence[Claim], edges: Sequence[float], budget: int | None, zeros: bool) -> list[Proof]:
    """In doubles; what round-off leaves open there, in long doubles."""
    # Most claims are decided in double precision.
    first = _first(run)
    budget = BUDGET * first if budget is None else budget
    search = _PanelSearch(run, Enclosure(run, [claim.node for claim in claims]), claims, edges, zeros, first)
    search.search(budget)
    found = search.proofs()
    # Repeat those that only round-off left open with long doubles, on the open spans alone.
    left = [i for i, proof in enumerate(found) if proof.reason == "round-off"]
    spent = max(proof.panels for proof in found)
    if not left or not PRECISE or spent >= budget:
        return found
    again = [replace(claims[i], spans=found[i].open) for i in left]
    search = _PanelSearch(run, Enclosure(run, [claim.node for claim in again], True), again, edges, zeros, 1)
    search.search(budget - spent)
    for i, proof in zip(left, search.proofs(), strict=True):
        low, high = min(found[i].low, proof.low), max(found[i].high, proof.high)
        found[i] = replace(proof, low=low, high=high, panels=found[i].panels + proof.panels)
    return found


class _PanelSearch:
    def __init__(
        self,
        run: Run,
        enclosure: Enclosure,
        claims: Sequence[Claim],
        edges: Sequence[float],
        zeros: bool,
        first: int,
    ) -> None:
        self.run, self.enclosure, self.claims, self.zeros = run, enclosure, claims, zeros
        # Initial panels: equal steps, cut also at the ends of spans, at edges, and around change points.
        length = run.stop - run.start
        ends = [end for claim in claims for span in claim.spans for end in span]
        bands = [(p.time - GAP * p.width, p.time + GAP * p.width) for p in run.compiled.passages.every]
        ends += [end for band in bands for end in band]
        every = np.unique(np.clip([*ends, *edges, *np.linspace(run.start, run.stop, first + 1)], run.start, run.stop))
        # Edges nearer to one another than the panels' margin are one.
        every = every[np.append(True, np.diff(every) > MARGIN * length)]
        start, stop = every[:-1], every[1:]
        self.closed: list[tuple[int, Span]] = []  # panels that aren't looked at further
        self.panels = enclosure.panels(start, stop)
        # Which claim has to be shown on which panel.
        self.asked = np.array([_covered(start, stop, claim.spans, 1e-11 * length) for claim in claims])
        # Inside the band of a change point nothing can be enclosed: leave these panels open.
        barred = _covered(start, stop, bands, 0.0)
        self.closed += [(int(i), self._span(int(p))) for i, p in zip(*np.nonzero(self.asked & barred), strict=True)]
        self.passed = {i for i, _ in self.closed}
        self.asked &= ~barred
        self.last = np.full((2, *self.asked.shape), np.inf)  # the bounds on the panels cut last, and before
        self.stalled: set[int] = set()
        self.tolerances = np.array([c.tolerance for c in claims])
        self._keep_panels(np.any(self.asked, axis=0))
        self.low, self.high = np.full(len(claims), np.inf), np.full(len(claims), -np.inf)
        self.refuted: dict[int, Refuted] = {}
        self.count = np.zeros(len(claims), dtype=int)
        self.undefined = np.zeros(len(claims), dtype=bool)
        self.limits = np.array([(c.low - c.tolerance, c.high + c.tolerance) for c in claims])

    def _keep_panels(self, which: Flags) -> None:
        self.panels, self.asked, self.last = self.panels.select(which), self.asked[:, which], self.last[:, :, which]

    def search(self, budget: int) -> None:
        """Evaluate and cut panels until all are decided."""
        spent = 0
        while self.panels.count and (cost := spent + self.panels.count + OVERHEAD) <= budget:
            spent = cost
            self.count += self.asked.sum(axis=1)
            # Evaluate all panels at once and drop those on which every claim is decided.
            self.decide()
            undecided = np.any(self.asked, axis=0)
            self._keep_panels(undecided)
            width = (self.panels.stop - self.panels.start) / (self.run.stop - self.run.start)
            # Give up on panels that became too narrow, sooner where the enclosure is undefined.
            narrow = self.asked & ((width < NARROWEST) | ((width < VAGUEST) & np.isnan(self.last[0])))
            for claim, panel in zip(*np.nonzero(narrow), strict=True):
                self.closed.append((int(claim), self._span(int(panel))))
                self.undefined[claim] |= np.isnan(self.last[0, claim, panel])
            self.asked &= ~narrow
            self._keep_panels(np.any(self.asked, axis=0))
            # Halve all others.
            self.panels, self.asked = self.panels.halves(), np.concatenate([self.asked, self.asked], axis=1)
            self.last = np.concatenate([self.last, self.last], axis=2)

    def _span(self, panel: int) -> Span:
        return float(self.panels.start[panel]), float(self.panels.stop[panel])

    def decide(self) -> None:
        """Take off all that the panels decide."""
        # Enclose all expressions over all panels; collect the pairs of claim and panel in one model.
        models = self.enclosure(self.panels)
        claim, panel = np.nonzero(self.asked)
        terms = max(len(m.c) for m in models)
        c = np.zeros((terms, claim.size), dtype=self.panels.dtype)
        r = np.empty(claim.size, dtype=self.panels.dtype)
        for i, model in enumerate(models):
            here = claim == i
            c[: len(model.c), here], r[here] = model.c[:, panel[here]], model.r[panel[here]]
        # First a cheap range of each model.
        low, high = TaylorModel(c, r, self.panels.select(panel)).range()
        known = np.isfinite(low) & np.isfinite(high)
        limits = self.limits[claim]
        if self.zeros:
            with np.errstate(invalid="ignore"):
                loose = known & ~((low > 0) | (high < 0))
        else:
            with np.errstate(invalid="ignore"):
                loose = known & ((low < limits[:, 0]) | (high > limits[:, 1]))
        # Only where that leaves the claim open, compute the tight range of the polynomial. Its extremes are also the
        # places to test for a counterexample.
        if loose.any():
            some = c[:, loose]
            top, at = above(some)
            bottom, place = above(-some)
            high[loose] = np.minimum(high[loose], top + r[loose])
            low[loose] = np.maximum(low[loose], -bottom - r[loose])
            self._refute(claim[loose], panel[loose], some, r[loose], at, 1.0)
            self._refute(claim[loose], panel[loose], -some, r[loose], place, -1.0)
        with np.errstate(invalid="ignore"):
            if self.zeros:
                decided = known & ((low > 0) | (high < 0))
            else:
                decided = known & (low >= limits[:, 0]) & (high <= limits[:, 1])
        # Decided panels contribute to the proven range of their claim.
        np.minimum.at(self.low, claim[decided], low[decided])
        np.maximum.at(self.high, claim[decided], high[decided])
        # Where the bound of what a polynomial misses doesn't fall any more, and is what hinders, it is round-off.
        noise = ~decided & known & (r > 0.7 * self.last[1, claim, panel])
        noise &= r > (np.abs(c[1:]).sum(axis=0) if self.zeros else 0.25 * self.tolerances[claim])
        for i, on in zip(claim[noise], panel[noise], strict=True):
            self.closed.append((int(i), self._span(int(on))))
            self.stalled.add(int(i))
        # Remember the remainders, to notice on the next level whether they still fall.
        self.last[1] = self.last[0]
        self.last[0, claim, panel] = np.where(np.isfinite(r), r, np.nan)
        self.asked[claim[decided | noise], panel[decided | noise]] = False
        for i in self.refuted:
            self.asked[i] = False

    def _refute(self, claim: Whole, panel: Whole, c: Array, r: Array, h: Array, way: float) -> None:
        """Note which claims a polynomial passes at places h of its panel, clear of the margins."""
        # Evaluate rigorously at the place: the value minus remainder and round-off must pass the limit.
        h = np.clip(h, -self.panels.inner[panel], self.panels.inner[panel])
        value = evaluated(c, h)
        value = value - r - 8 * len(c) * ROUND * np.abs(c).sum(axis=0)
        limit = self.limits[claim, 1] if way > 0 else -self.limits[claim, 0]
        for k in np.flatnonzero(value > limit):
            time = float(self.panels.mid[panel[k]] + self.panels.half[panel[k]] * h[k])
            self.refuted.setdefault(int(claim[k]), Refuted(time, float(way * value[k])))

    def proofs(self) -> list[Proof]:
        """What came out."""
        found = []
        for i in range(len(self.claims)):
            spans = [span for claim, span in self.closed if claim == i]
            spans += [self._span(int(panel)) for panel in np.flatnonzero(self.asked[i])]
            low, high = (float(np.nextafter(v, w)) for v, w in ((self.low[i], -np.inf), (self.high[i], np.inf)))
            reason = ""
            if i in self.refuted:
                reason, spans = "refuted", []
            elif spans:
                reason = self._why(i)
            elif low > high:  # no panel lies in the spans
                reason, spans = "budget", [*self.claims[i].spans]
            found.append(Proof(low, high, _merged_spans(spans), reason, int(self.count[i]), self.refuted.get(i)))
        return found

    def _why(self, claim: int) -> str:
        if claim in self.passed:
            return "change-point"
        if claim in self.stalled:
            return "round-off"
        vague = self.undefined[claim] or np.isnan(self.last[0, claim, self.asked[claim]]).any()
        return "undefined" if vague else "budget"


def _covered(start: Array, stop: Array, spans: Sequence[Span], close: float) -> Flags:
    """Which panels lie in one of some spans."""
    middle = 0.5 * (start + stop)
    inside = np.zeros(len(start), dtype=bool)
    for a, b in spans:
        inside |= (middle > a - close) & (middle < b + close)
    return inside


def _merged_spans(spans: list[Span]) -> tuple[Span, ...]:
    """Neighbouring panels put together."""
    found: list[Span] = []
    for a, b in sorted(spans):
        if found and a <= found[-1][1]:
            found[-1] = found[-1][0], max(b, found[-1][1])
        else:
            found.append((a, b))
    return tuple(found)
