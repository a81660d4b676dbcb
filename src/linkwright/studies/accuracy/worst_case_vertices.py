"""The nonlinear worst case, by evaluating the mechanism itself where the linear worst case can't be trusted.

First the two vertices of the tolerance box at which the linear worst case lies are evaluated, and all their neighbours
that differ in one coordinate. If the results differ from the linear worst case by more than a stated share of its
width, the search goes on: over all vertices, or if these are too many, from several of them by the best flip of one or
two coordinates until none helps; finally by steps inside the box, since the worst case need not be at a vertex.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.findings import Finding
from linkwright.kernels.parameter_batch import Varied
from linkwright.measures import BoundMeasure
from linkwright.results import Run
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.accuracy.deviations import Shift
from linkwright.studies.accuracy.outcome import OutputDeviations, SearchedWorstCase
from linkwright.studies.accuracy.worst_case_local import DeviationBox, Evaluate
from linkwright.studies.figures import SampleFigures

Array = NDArray[np.float64]

ALL_OF = 12
"""The most contributors of which all vertices are evaluated."""
INSIDE = 256
"""Places inside the box that are looked at before the search, and vertices where these are too many."""
STARTS = 3
"""Places from which an extreme is searched."""
VERTICES = 5
"""Those from which others are reached by flips."""
ROUND = 1e-9
"""Of the figure's size: what is no more counts as round-off."""


def evaluating(
    run: Run, contributors: Contributors, measures: Sequence[BoundMeasure], kernel: str = "numpy"
) -> Evaluate:
    """What evaluates the figures of some measures, by the names of their columns."""
    shift = Shift(run.compiled, contributors)
    varied = Varied(run.compiled, shift.names)
    figures = SampleFigures(run, varied, measures, kernel)

    def evaluate(deviations: Array) -> dict[str, Array]:
        rows, _ = figures.evaluate(varied.parameters(shift.values(deviations)))
        return dict(zip((column.name for column in figures.columns), rows, strict=True))

    return evaluate


def search(
    evaluate: Evaluate, contributors: Contributors, figures: Mapping[str, OutputDeviations], share: float
) -> dict[str, SearchedWorstCase]:
    """The worst case of each figure: the deviation at the linear worst vertices, and what a search finds where one of
    these is off by more than ``share`` of the linear width."""
    if not figures or not len(contributors):
        return {}

    def cleared(deviations: Array) -> dict[str, Array]:
        found = evaluate(deviations)
        return {name: figures[name].cleared(row) for name, row in found.items() if name in figures}

    return _VertexSearch(cleared, contributors, figures).worst_cases(share)


def check_searched(found: Mapping[str, SearchedWorstCase]) -> Iterator[Finding]:
    """That places inside the tolerances can't be assembled or followed."""
    worst = max(found.values(), key=lambda one: one.lost, default=None)
    if worst is not None and worst.lost:
        data = {"lost": worst.lost, "looked": worst.looked}
        yield Finding("accuracy.vertices-fail", ("studies", "accuracy"), data, severity="warning")


class _VertexSearch:
    def __init__(self, evaluate: Evaluate, contributors: Contributors, figures: Mapping[str, OutputDeviations]) -> None:
        low, width = contributors.low, contributors.high - contributors.low
        nominal = {name: figure.nominal for name, figure in figures.items()}
        self.figures, self.box = figures, DeviationBox(evaluate, low, width, nominal)
        self.free, self.random = self.box.free, np.random.default_rng(0)
        self.nominal = np.zeros(low.size)  # the place, or what comes next to it
        self.nominal[self.free] = np.clip(-low[self.free] / width[self.free], 0, 1)

    def worst_cases(self, share: float) -> dict[str, SearchedWorstCase]:
        """The worst case of each figure."""
        # Step 1: the two vertices of each figure that the linear coefficients name, and all neighbours that differ in
        # one coordinate, in one batch.
        corners = {name: self.corners(figure) for name, figure in self.figures.items()}
        every = np.concatenate([*corners.values()], axis=1)
        flips = np.eye(len(every), dtype=bool)[:, self.free]
        beside = np.where(flips[:, None], 1 - every[:, :, None], every[:, :, None]).reshape(len(every), -1)
        box = self.box
        first = box.look(np.concatenate([every, beside], axis=1))
        # Step 2: how wrong the linear worst case is for each figure.
        off = {}
        for k, name in enumerate(self.figures):
            off[name] = self.off(name, first[name][2 * k : 2 * k + 2])
        # Step 3: search further only for figures where it is off by more than the stated share.
        wanted = [extreme for name, both in box.extremes.items() if off[name] > share for extreme in both]
        if wanted and self.free.size:
            # Samples inside the box give starts, as an extreme need not be at a vertex.
            inside = self.inside()
            starts = [*box.best(wanted, inside, box.look(inside), STARTS - 1)]
            # With few contributors all vertices are evaluated; else random ones, improved by flipping coordinates.
            if self.free.size <= ALL_OF:
                vertices = self.vertices(2**self.free.size)
                starts += box.best(wanted, vertices, box.look(vertices), 1)
            else:
                some = np.concatenate([self.vertices(INSIDE), *corners.values()], axis=1)
                starts += box.flipped([*box.best(wanted, some, box.look(some), VERTICES)])
            # Step 4: continuous local search from the best places.
            box.climb(starts)
        return {name: self.searched(name, off[name]) for name in self.figures}

    def searched(self, name: str, off: float) -> SearchedWorstCase:
        """What was found for a figure. A box without a width is the one that is looked at all over."""
        low, high = self.box.extremes[name]
        proven = not self.free.size and np.isfinite(low.value)
        nowhere = np.full(self.nominal.size, np.nan)
        return SearchedWorstCase(
            low=-low.value if low.at.size else np.nan,
            high=high.value if high.at.size else np.nan,
            low_at=low.at if low.at.size else nowhere,
            high_at=high.at if high.at.size else nowhere,
            off=off,
            proven=bool(proven),
            looked=self.box.looked,
            lost=self.box.lost[name],
        )

    # Places, in shares of the box: (contributors, places).

    def corners(self, figure: OutputDeviations) -> Array:
        """Where the linear figure is least and largest; in a tie that may be the nominal place of a coordinate."""
        n = self.nominal.size
        # For each contributor choose lower limit, nominal or upper limit, whichever moves the figure most.
        places = np.stack([np.zeros(n), self.nominal, np.ones(n)])
        ends = self.box.low + self.box.width * places
        moved = np.where(ends < 0, figure.coefficients[:, 0], figure.coefficients[:, 1]) * ends
        found = np.stack([moved.argmin(axis=0), moved.argmax(axis=0)])
        return np.take_along_axis(places, found, axis=0).T

    def off(self, name: str, found: Array) -> float:
        """How far the linear worst case is off where it should be, or passed elsewhere, over its width."""
        figure, (low, high) = self.figures[name], self.box.extremes[name]
        width, nothing = figure.worst[1] - figure.worst[0], ROUND * abs(figure.nominal)
        # Two errors: at the vertices themselves, and any other place found beyond the linear worst case.
        there = np.abs(found - figure.nominal - np.array(figure.worst))  # NaN where it can't be assembled
        apart = float(np.max([*there, figure.worst[0] + low.value, high.value - figure.worst[1]]))
        if apart <= nothing:
            return 0.0
        return apart / width if np.isfinite(apart) and width > 0 else np.inf

    def vertices(self, count: int) -> Array:
        """All of them, or so many at random."""
        n = self.free.size
        places = np.zeros((self.nominal.size, count))
        every = np.arange(count) >> np.arange(n)[:, None] & 1 if count == 2**n else None
        places[self.free] = self.random.integers(0, 2, (n, count)) if every is None else every
        return places

    def inside(self) -> Array:
        """The nominal place, the middle, and a Latin hypercube."""
        n = self.nominal.size
        slices = np.stack([self.random.permutation(INSIDE) for _ in range(n)])
        hypercube = (slices + self.random.random((n, INSIDE))) / INSIDE
        return np.concatenate([self.nominal[:, None], np.full((n, 1), 0.5), hypercube], axis=1)
