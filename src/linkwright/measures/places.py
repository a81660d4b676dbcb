"""The places of a run at which expressions need a close look.

*Cuts* are zeros of break functions, kinks of loads, joins of laws, knots of tables: between two of them an expression
is smooth. *Narrow* places are where a break function, or the radicand or determinant of a group, nearly vanishes: what
is divided by it changes fast there, over the width in which it doubles.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from functools import partial

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Call, Name, Node, nodes
from linkwright.graph.rows import Determinant, ReachRow, Row, Sharpness, spans
from linkwright.measures.features import Feature, Find, ZeroKind, features
from linkwright.measures.round_off import DIGITS, LITTLE, spreads
from linkwright.measures.search import Rates, RunPieces, turning, zeros
from linkwright.results import Run
from linkwright.results.discontinuities import ASIDE, argument_of, knots, law_joins, positions
from linkwright.results.discontinuities import zeros as zeros_of
from linkwright.results.stationary import STILL

Array = NDArray[np.float64]

HALVINGS = 44
"""How often the distance to a narrow place is halved, from a step of the grid on."""
CLOSEST = 4e-12
"""The nearest that is looked at beside a place, over the run's length."""
SHARE = 0.2
"""Nearer than this share of the width over which a break function doubles nothing changes fast any more."""
LOW = 0.2
"""A least magnitude above this share of the usual one isn't narrow."""
TOUCH = 1e-6
"""A break function that comes this near to zero, over its largest value, may touch it."""
MOST = 1 << 10
"""The most narrow places of one break function that are looked at closely."""
SMOOTH = 9
"""The continuity from which on a join of a motion law hinders no quadrature."""
MOSTLY = 0.9
"""At which share of the times an expression that is no more than what comes of its signals' round-off is that."""
BETWEEN = np.array([0.0, 0.25, 0.5, 0.75])
"""Where between the knots of a table is looked, as shares."""


@dataclass
class Marks:
    """Times (s) that cut, further times to look at, and whether the search for them has stood still."""

    cuts: list[Array] = field(default_factory=list)
    more: list[Array] = field(default_factory=list)
    settled: bool = True

    def add(self, other: Marks | None) -> None:
        """Those of another besides."""
        if other is not None:
            self.cuts += other.cuts
            self.more += other.more
            self.settled &= other.settled


@dataclass(frozen=True)
class Hard:
    """A time (s) at which expressions need not be continuous: the break functions that may vanish there."""

    time: float
    features: tuple[Feature, ...]


@dataclass
class BreakPlaces:
    """The places of a run for some expressions (bound to SI): ``hard`` ones of each, and ``pieces`` of each between its
    cuts. What is known of an expression comes from the run and from its own break functions, never from another's.

    ``noticed`` are times (s) to look at closely besides, by expression. ``settled``: whether the searches for an
    expression's places have stood still.
    """

    run: Run
    trees: Sequence[Node]
    noticed: Mapping[Node, Sequence[float]] = field(default_factory=dict)
    hard: dict[Node, list[Hard]] = field(default_factory=dict)
    pieces: dict[Node, RunPieces] = field(init=False)
    settled: dict[Node, bool] = field(init=False)

    def __post_init__(self) -> None:
        run = self.run
        self._zeros: dict[Feature, Array] = {}
        self._marks: dict[Feature, Marks] = {}
        self._tables: dict[Node, Marks] = {}
        self._same: dict[tuple[bytes, ...], RunPieces] = {}
        # What belongs to the run itself: breaks of loads and laws, knots of tables in them, singular groups.
        self._base = Marks([run.breaks], [zeros_of(run, node) for node in law_joins(run.compiled, rough=SMOOTH)])
        self._base.add(self._lookups())
        acting = [*dict.fromkeys(f for tree in _acting(run) for f in features(tree, self._find))]
        self._search(acting, _groups(run))
        for feature in acting:
            self._base.add(self._marks.get(feature))
        own = {tree: features(tree, self._find) for tree in self.trees}
        every = dict.fromkeys(f for some in own.values() for f in some)
        self._search([f for f in every if f not in self._marks], [])
        self.hard = {tree: self._hard(some) for tree, some in own.items()}
        self.pieces = {tree: self._pieces(tree, some) for tree, some in own.items()}
        self.settled = {tree: self._marks_of(tree, some).settled for tree, some in own.items()}

    @property
    def _find(self) -> Find:
        return self.run.compiled.quantities.signals.find

    def _lookups(self) -> Marks:
        """Knots of tables of loads: of those that aren't linear the grid is to see each stretch between two."""
        run, tables, marks = self.run, self.run.compiled.tables, Marks()
        for i, lookup in enumerate(run.compiled.graph.actions.lookups):
            table = tables[lookup.table]
            if table.degree > 1:
                marks.more.append(self._between(knots(argument_of(run, i), table, run.start, run.stop, run.grid)))
        return marks

    def _knots(self, tree: Node) -> Marks:
        """Knots of tables in an expression: linear ones cut, of others the grid is to see each stretch between two."""
        run, tables, marks = self.run, self.run.compiled.tables, Marks()
        for node in nodes(tree):
            if isinstance(node, Call) and node.attribute is None and node.name in tables:
                if node not in self._tables:
                    table, argument = tables[node.name], node.args[0]
                    at = knots(partial(_values, run, argument), table, run.start, run.stop, run.grid)
                    self._tables[node] = Marks([at]) if table.degree == 1 else Marks([], [self._between(at)])
                marks.add(self._tables[node])
        return marks

    def _between(self, at: Array) -> Array:
        edges = np.unique(np.concatenate([[self.run.start], at, [self.run.stop]]))
        return np.asarray(edges[:-1, None] + np.diff(edges)[:, None] * BETWEEN).ravel()

    def _search(self, found: list[Feature], rows: list[Row]) -> None:
        """Search for zeros and narrow places of break functions, inner ones first, and of the groups' radicands."""
        left = found
        inner = {f: [g for g in features(f.node, self._find) if g.node != f.node] for f in found}
        while left or rows:
            waiting = {f.node for f in left}
            now = [f for f in left if not {g.node for g in inner[f]} & waiting] or left
            left = [f for f in left if f not in now]
            self._level(now, rows, inner)
            rows = []

    def _level(self, some: list[Feature], rows: list[Row], inner: Mapping[Feature, list[Feature]]) -> None:
        run = self.run
        pieces = [self._base_pieces()] * len(rows) + [self._pieces(f.node, inner[f]) for f in some]
        trees = [f.node for f in some]

        def rates(t: Array) -> tuple[Array, Array]:
            parts = [run.compiled.rates(rows, t)] if rows else []
            parts += [run.all_rates(trees, t)] if trees else []
            values, slopes = (np.concatenate(part) for part in zip(*parts, strict=True))
            return values, slopes

        def clear(i: int, t: Array) -> NDArray[np.bool_]:
            if i < len(rows):
                return np.ones(t.size, dtype=bool)
            (spread,) = spreads(run, [trees[i - len(rows)]], t, DIGITS)
            return ~spread.contains(0.0)

        if not rows and not trees:
            return
        turning_points = turning(rates, pieces, run.grid)
        crossed = zeros(rates, pieces, turning_points, run.grid, clear)
        times = np.linspace(run.start, run.stop, 257)
        usual = np.abs(rates(times)[0])
        still = [bool(np.ptp(row) <= STILL * np.nanmax(row, initial=0.0)) for row in usual[: len(rows)]]
        unclear = still + vague(run, trees, times)
        for i, row in enumerate([*rows, *some]):
            known = usual[i][np.isfinite(usual[i])]
            marks = self._marks.setdefault(row, Marks()) if isinstance(row, Feature) else self._base
            if not known.size or not known.max() > 0 or unclear[i]:
                continue
            marks.settled &= turning_points.settled[i]
            cuts = (pieces[i].before + pieces[i].after) / 2
            corners = np.concatenate([[run.start, run.stop], np.clip(cuts, run.start, run.stop)])
            least = np.union1d(turning_points.times[i], corners)
            size = np.abs(_row(rates, i, least))
            near = least[size < LOW * np.median(known)]
            if isinstance(row, Feature):
                apart = 2 * ASIDE[0] * (run.stop - run.start)
                alone = _to_nearest(least, crossed[i]) > apart
                # It touches zero where no more than round-off is left of it.
                touched = least[(size <= TOUCH * known.max()) & alone]
                touched = touched[~clear(i, touched)] if touched.size else touched
                self._zeros[row] = np.union1d(crossed[i], touched)
                marks.cuts.append(self._zeros[row] if row.kind.hard else crossed[i])
                near = near if row.kind is ZeroKind.KINK else np.union1d(near, crossed[i])
            if near.size:
                more, within = self._narrow(rates, i, near, turning_points.widths[i])
                marks.more.append(more)
                marks.settled &= within

    def _narrow(self, rates: Rates, i: int, places: Array, step: float) -> tuple[Array, bool]:
        """Times beside narrow places, nearer and nearer, down to where the break function doesn't change any more, and
        whether that is done for all places."""
        run = self.run
        within = places.size <= MOST
        places = places[:MOST]
        away = 2.0 * step * 0.5 ** np.arange(HALVINGS)
        away = away[away > CLOSEST * (run.stop - run.start)]
        t = places[:, None, None] + np.array([-1.0, 1.0])[:, None] * away
        inside = (t >= run.start) & (t <= run.stop)
        here = np.abs(_row(rates, i, places))[:, None, None]
        beside = np.abs(_row(rates, i, np.where(inside, t, places[:, None, None]).ravel())).reshape(t.shape)
        wide = away * (beside < 2.0 * here)
        width = np.nanmax(np.where(inside, wide, 0.0), axis=2, keepdims=True)
        return np.asarray(t[inside & (away >= SHARE * width)]), within

    def _around(self, places: Array) -> Array:
        """Times beside places, nearer and nearer."""
        run, step = self.run, (self.run.stop - self.run.start) / self.run.grid
        away = step * 0.5 ** np.arange(HALVINGS)
        t = (places[:, None, None] + np.array([-1.0, 1.0])[:, None] * away[away > CLOSEST * step]).ravel()
        return np.concatenate([places, t[(t >= run.start) & (t <= run.stop)]])

    def _hard(self, some: list[Feature]) -> list[Hard]:
        """The places of an expression's own break functions, those at one time together."""
        at = sorted((float(t), k) for k, f in enumerate(some) if f.kind.hard for t in self._zeros.get(f, ()))
        near, found = 2 * ASIDE[0] * (self.run.stop - self.run.start), list[tuple[float, list[int]]]()
        for t, k in at:
            if found and t - found[-1][0] <= near:
                found[-1][1].append(k)
            else:
                found.append((t, [k]))
        return [Hard(t, tuple(some[k] for k in which)) for t, which in found]

    def _marks_of(self, tree: Node, some: Sequence[Feature]) -> Marks:
        """What belongs to the run, to an expression and to its break functions."""
        marks = Marks()
        marks.add(self._base)
        marks.add(self._knots(tree))
        if tree in self.noticed:
            marks.more.append(self._around(np.array(self.noticed[tree])))
        for feature in some:
            marks.add(self._marks.get(feature))
        return marks

    def _pieces(self, tree: Node, some: Sequence[Feature]) -> RunPieces:
        """What lies between all cuts of an expression that are known so far."""
        return self._between_cuts(self._marks_of(tree, some))

    def _base_pieces(self) -> RunPieces:
        return self._between_cuts(self._base)

    def _between_cuts(self, marks: Marks) -> RunPieces:
        run = self.run
        aside = ASIDE[0] * (run.stop - run.start)
        cuts = np.unique(np.concatenate([*marks.cuts, np.empty(0)]))
        before, after = cuts - aside, cuts + aside
        if run.jumps.size:
            inside = ((cuts[:, None] >= run.jumps[:, 0]) & (cuts[:, None] <= run.jumps[:, 1])).any(axis=1)
            before = np.concatenate([before[~inside], run.jumps[:, 0]])
            after = np.concatenate([after[~inside], run.jumps[:, 1]])
            order = np.argsort(before)
            before, after = before[order], after[order]
        apart = np.append(True, before[1:] > np.maximum.accumulate(after)[:-1]) if before.size else np.empty(0, bool)
        first = np.flatnonzero(apart)
        after = np.maximum.reduceat(after, first) if first.size else after
        low, high = np.clip(before[apart], run.start, run.stop), np.clip(after, run.start, run.stop)
        pieces = RunPieces(run.start, run.stop, low, high, np.unique(np.concatenate([*marks.more, np.empty(0)])))
        # Expressions with the same places share one object, and so one grid.
        return self._same.setdefault((low.tobytes(), high.tobytes(), pieces.more.tobytes()), pieces)


def vague(run: Run, trees: Sequence[Node], t: Array) -> list[bool]:
    """Which expressions are round-off all along: they change by their own size where their signals change by a little
    of theirs."""
    names = run.signals_of(trees)
    if not names:
        return [False] * len(trees)
    values, slopes = run.possible_rates(names, t)
    sizes = np.array(run.usual(run.dimension(name) for name in names))[:, None]
    found = []
    with np.errstate(all="ignore"):
        shift = LITTLE * np.sin(1.0 + np.arange(len(names)))[:, None] * np.maximum(np.abs(values), sizes)
        for tree in trees:
            plain, other = (
                run.combine(tree, t, dict(zip(names, zip(rows, slopes, strict=True), strict=True))).d[0]
                for rows in (values, values + shift)
            )
            found.append(bool((np.abs(plain) <= np.abs(other - plain)).mean() > MOSTLY))
    return found


def _row(rates: Rates, i: int, t: Array) -> Array:
    return np.asarray(rates(t)[0][i])


def _values(run: Run, node: Node, t: Array) -> Array:
    return np.asarray(run.jets(node, t.ravel()).d[0]).reshape(t.shape)


def _groups(run: Run) -> list[Row]:
    """The rows that vanish where a group is singular: rates and forces are divided by them."""
    structure = run.compiled.structure
    rows = [(ReachRow if group.modes > 1 else Determinant)(group.label) for group in structure.groups]
    return [*rows, *spans(structure), *(Sharpness(higher_group.label) for higher_group in structure.higher_groups)]


def _acting(run: Run) -> Iterator[Node]:
    """The expressions that act on the mechanism: of loads, and of drives whose laws are expressions."""
    known = {*run.compiled.tables}
    for tree in (*run.compiled.graph.actions.laws, *positions(run.compiled)):
        calls = {n.name for n in nodes(tree) if isinstance(n, Call) and n.attribute is None}
        functions = {*run.compiled.mechanism.tables, *run.compiled.mechanism.laws}
        if calls & functions <= known and not any(n == Name("sketch") for n in nodes(tree)):
            yield tree


def _to_nearest(times: Array, places: Array) -> Array:
    """The distance of each time to the nearest of some places; infinite where there are none."""
    known = np.concatenate([[-np.inf], np.sort(places), [np.inf]])
    after = np.searchsorted(known, times)
    return np.asarray(np.minimum(known[after] - times, times - known[after - 1]))
