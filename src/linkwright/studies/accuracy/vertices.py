"""The worst case by evaluating the mechanism itself, where the linear one isn't to be trusted.

First the two vertices of the tolerance box that the linear coefficients name, and their neighbours by one coordinate.
Where the figure at the two is off the linear worst case, or a neighbour beyond it, by more than a stated share of its
width: all vertices, or where these are too many, from several of them the best flip of one or two coordinates until
none helps; then steps inside the box, since the worst need not be at a vertex: a pattern search (Hooke and Jeeves, J.
ACM 8 (1961) 212-229) from the best places, all coordinates tried at once. Places are evaluated many at a time, and what
is found for one figure serves all of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels.varied import Varied
from linkwright.model.findings import Finding
from linkwright.results import Run
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.deviations import Shift
from linkwright.studies.accuracy.outcome import Figure, Searched
from linkwright.studies.figures import Figures

Array = NDArray[np.float64]
Evaluate = Callable[[Array], Mapping[str, Array]]
"""Figures by name, (samples,) in SI, NaN where a sample has none, of deviations (contributors, samples)."""

ALL_OF = 12
"""The most contributors of which all vertices are evaluated."""
INSIDE = 256
"""Places inside the box that are looked at before the search, and vertices where these are too many."""
STARTS = 3
"""Places from which an extreme is searched."""
VERTICES = 5
"""Those from which others are reached by flips."""
PAIRS = 300
"""The most pairs of coordinates that are flipped together."""
ROUNDS = 100
"""The most rounds of a search."""
FIRST, LAST = 0.25, 1e-4
"""The first and the last step inside, over the width of the box."""
ROUND = 1e-9
"""Of the figure's size: what is no more counts as round-off."""


def evaluating(run: Run, contributors: Contributors, names: Sequence[str], kernel: str = "numpy") -> Evaluate:
    """What evaluates the figures of some measures, by the names of their columns."""
    shift = Shift(run.compiled, contributors)
    varied = Varied(run.compiled, shift.names)
    figures = Figures(run, varied, names, kernel)

    def evaluate(deviations: Array) -> dict[str, Array]:
        rows, _ = figures.of(varied.parameters(shift.values(deviations)))
        return dict(zip((column.name for column in figures.columns), rows, strict=True))

    return evaluate


def search(
    evaluate: Evaluate, contributors: Contributors, figures: Mapping[str, Figure], share: float
) -> dict[str, Searched]:
    """The worst case of each figure: the deviation at the linear worst vertices, and what a search finds where one of
    these is off by more than ``share`` of the linear width."""
    if not figures:
        return {}
    return _Search(evaluate, contributors, figures).found(share)


def check_searched(found: Mapping[str, Searched]) -> Iterator[Finding]:
    """That places inside the tolerances can't be assembled or followed."""
    worst = max(found.values(), key=lambda one: one.lost, default=None)
    if worst is not None and worst.lost:
        data = {"lost": worst.lost, "looked": worst.looked}
        yield Finding("accuracy.vertices-fail", ("studies", "accuracy"), data, severity="warning")


@dataclass
class _Extreme:
    """One side of one figure: the largest of ``sign`` times its deviation. ``step`` is that of a search under way."""

    name: str
    sign: float
    value: float = -np.inf
    at: Array = field(default_factory=lambda: np.empty(0))


@dataclass
class _Climb:
    """A search for an extreme from a place ``at`` (contributors,), in shares of the box."""

    extreme: _Extreme
    at: Array
    value: float
    step: float = FIRST


class _Search:
    def __init__(self, evaluate: Evaluate, contributors: Contributors, figures: Mapping[str, Figure]) -> None:
        self.evaluate, self.figures = evaluate, figures
        self.low, self.width = contributors.low, contributors.high - contributors.low
        self.free = np.flatnonzero(self.width > 0)
        self.nominal = np.zeros(self.low.size)  # or what comes next to it
        self.nominal[self.free] = np.clip(-self.low[self.free] / self.width[self.free], 0, 1)
        self.random = np.random.default_rng(0)
        self.extremes = {name: (_Extreme(name, -1.0), _Extreme(name, 1.0)) for name in figures}
        self.looked = 0
        self.lost = dict.fromkeys(figures, 0)

    def found(self, share: float) -> dict[str, Searched]:
        """The worst case of each figure."""
        corners = {name: self.corners(figure) for name, figure in self.figures.items()}
        every = np.concatenate([*corners.values()], axis=1)
        flips = np.eye(len(every), dtype=bool)[:, self.free]
        beside = np.where(flips[:, None], 1 - every[:, :, None], every[:, :, None]).reshape(len(every), -1)
        first = self.look(np.concatenate([every, beside], axis=1))
        off = {}
        for k, name in enumerate(self.figures):
            off[name] = self.off(name, first[name][2 * k : 2 * k + 2])
        wanted = [extreme for name, both in self.extremes.items() if off[name] > share for extreme in both]
        if wanted and self.free.size:
            inside = self.inside()
            starts = [*self.best(wanted, inside, self.look(inside), STARTS - 1)]
            if self.free.size <= ALL_OF:
                vertices = self.vertices(2**self.free.size)
                starts += self.best(wanted, vertices, self.look(vertices), 1)
            else:
                some = np.concatenate([self.vertices(INSIDE), *corners.values()], axis=1)
                starts += self.flipped([*self.best(wanted, some, self.look(some), VERTICES)])
            self.climb(starts)
        return {name: self.searched(name, off[name]) for name in self.figures}

    def searched(self, name: str, off: float) -> Searched:
        """What was found for a figure. A box without a width is the one that is looked at all over."""
        low, high = self.extremes[name]
        proven = not self.free.size and np.isfinite(low.value)
        lost = np.full(self.low.size, np.nan)
        return Searched(
            low=-low.value if low.at.size else np.nan,
            high=high.value if high.at.size else np.nan,
            low_at=low.at if low.at.size else lost,
            high_at=high.at if high.at.size else lost,
            off=off,
            proven=bool(proven),
            looked=self.looked,
            lost=self.lost[name],
        )

    # Places, in shares of the box: (contributors, places).

    def corners(self, figure: Figure) -> Array:
        """Where the linear figure is least and largest; in a tie that may be the nominal place of a coordinate."""
        places = np.stack([np.zeros(self.low.size), self.nominal, np.ones(self.low.size)])
        ends = self.low + self.width * places
        moved = np.where(ends < 0, figure.coefficients[:, 0], figure.coefficients[:, 1]) * ends
        found = np.stack([moved.argmin(axis=0), moved.argmax(axis=0)])
        return np.take_along_axis(places, found, axis=0).T

    def off(self, name: str, found: Array) -> float:
        """How far the linear worst case is off where it should be, or passed elsewhere, over its width."""
        figure, (low, high) = self.figures[name], self.extremes[name]
        width, nothing = figure.worst[1] - figure.worst[0], ROUND * abs(figure.nominal)
        apart = float(
            np.abs(found - figure.nominal - np.array(figure.worst)).max()
        )  # NaN where it can't be assembled there
        apart = float(np.max([apart, figure.worst[0] + low.value, high.value - figure.worst[1]]))
        if apart <= nothing:
            return 0.0
        return apart / width if np.isfinite(apart) and width > 0 else np.inf

    def vertices(self, count: int) -> Array:
        """All of them, or so many at random."""
        n = self.free.size
        places = np.zeros((self.low.size, count))
        every = np.arange(count) >> np.arange(n)[:, None] & 1 if count == 2**n else None
        places[self.free] = self.random.integers(0, 2, (n, count)) if every is None else every
        return places

    def inside(self) -> Array:
        """The nominal place, the middle, and a Latin hypercube."""
        n = self.low.size
        slices = np.stack([self.random.permutation(INSIDE) for _ in range(n)])
        hypercube = (slices + self.random.random((n, INSIDE))) / INSIDE
        return np.concatenate([self.nominal[:, None], np.full((n, 1), 0.5), hypercube], axis=1)

    def look(self, places: Array) -> dict[str, Array]:
        """Evaluate some places; extremes take what is better."""
        deviations = self.low[:, None] + self.width[:, None] * places
        found = {name: np.asarray(row) for name, row in self.evaluate(deviations).items() if name in self.figures}
        self.looked += places.shape[1]
        for name, row in found.items():
            self.lost[name] += int(np.count_nonzero(~np.isfinite(row)))
            for extreme in self.extremes[name]:
                value = self.value(extreme, row)
                k = int(value.argmax())
                if value[k] > extreme.value:
                    extreme.value, extreme.at = float(value[k]), deviations[:, k]
        return found

    def value(self, extreme: _Extreme, row: Array) -> Array:
        """What an extreme wants to be large, of values of its figure."""
        known = extreme.sign * (row - self.figures[extreme.name].nominal)
        return np.where(np.isfinite(known), known, -np.inf)

    def best(
        self, wanted: Sequence[_Extreme], places: Array, found: Mapping[str, Array], count: int
    ) -> Iterator[_Climb]:
        """Searches from the best places for each extreme that is wanted."""
        for extreme in wanted:
            value = self.value(extreme, found[extreme.name])
            for k in np.argsort(-value, kind="stable")[:count].tolist():
                if value[k] > -np.inf:
                    yield _Climb(extreme, places[:, k], float(value[k]))

    # Searches, all of them a round at a time.

    def flipped(self, climbs: Sequence[_Climb]) -> list[_Climb]:
        """From vertex to vertex, by the flip of a coordinate that helps most; where none does, of two."""
        eye = np.eye(self.low.size, dtype=bool)[:, self.free]
        i, j = np.triu_indices(self.free.size, 1)
        pairs = eye[:, i] | eye[:, j] if i.size <= PAIRS else eye[:, :0]
        flips, alive = dict.fromkeys(range(len(climbs)), 0), [*range(len(climbs))]
        for _ in range(ROUNDS):
            if not alive:
                break
            tried = [np.where((eye, pairs)[flips[k]], 1 - climbs[k].at[:, None], climbs[k].at[:, None]) for k in alive]
            better = self.moved([climbs[k] for k in alive], tried)
            for k, helped in zip(alive, better, strict=True):
                flips[k] = 0 if helped else flips[k] + 1
            alive = [k for k in alive if flips[k] < 2]
        return [*climbs]

    def climb(self, climbs: Sequence[_Climb]) -> None:
        """Inside the box, by steps along each coordinate, then along all that helped; smaller ones where none did."""
        directions = np.eye(self.low.size)[:, self.free]
        directions = np.concatenate([directions, -directions], axis=1)
        for _ in range(ROUNDS):
            climbs = [one for one in climbs if one.step >= LAST]
            if not climbs:
                break
            before = [(one.at, one.value) for one in climbs]
            tried = [np.clip(one.at[:, None] + one.step * directions, 0, 1) for one in climbs]
            rows = self.rows(climbs, tried)
            along = []
            for one, places, values, (at, value) in zip(climbs, tried, rows, before, strict=True):
                gain = np.where(np.isfinite(values), np.maximum(values - value, 0.0), 0.0)
                moves = (places - at[:, None]) * (gain > 0)
                slope = moves * (gain / max(float(gain.max()), 1e-300))
                along.append(np.clip(at[:, None] + np.stack([moves.sum(axis=1), slope.sum(axis=1)], axis=1), 0, 1))
                self.take(one, places, values)
            for one, (_, value), places, values in zip(climbs, before, along, self.rows(climbs, along), strict=True):
                self.take(one, places, values)
                if not one.value > value:
                    one.step /= 2

    def moved(self, climbs: Sequence[_Climb], tried: Sequence[Array]) -> list[bool]:
        """Whether each search is helped by one of the places that it tries; it goes to the best."""
        found = zip(climbs, tried, self.rows(climbs, tried), strict=True)
        return [self.take(one, places, values) for one, places, values in found]

    def rows(self, climbs: Sequence[_Climb], tried: Sequence[Array]) -> list[Array]:
        """What each search wants to be large, at the places that it tries; all are evaluated together."""
        found = self.look(np.concatenate(tried, axis=1))
        ends = np.cumsum([places.shape[1] for places in tried])
        cut = {name: np.split(row, ends[:-1]) for name, row in found.items()}
        return [self.value(one.extreme, cut[one.extreme.name][k]) for k, one in enumerate(climbs)]

    def take(self, climb: _Climb, places: Array, values: Array) -> bool:
        """Go to the best of some places if it's better."""
        k = int(values.argmax()) if values.size else -1
        if k < 0 or not values[k] > climb.value:
            return False
        climb.at, climb.value = places[:, k], float(values[k])
        return True
