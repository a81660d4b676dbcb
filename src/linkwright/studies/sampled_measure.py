"""The measures of one bunch of samples, by a plan that the nominal run has made (:class:`many.Measuring`)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Node
from linkwright.measures import BoundMeasure, measure_all
from linkwright.model.bound_window import BoundWindow
from linkwright.reductions import Figures, Measure
from linkwright.results.batch_run import Bunch, What
from linkwright.results.batch_windows import Spans, Windows, spans
from linkwright.results.claims import SINGULAR
from linkwright.results.single_sample import sample_run
from linkwright.studies.assembly_checks import TOUCH
from linkwright.studies.batch_extremes import peaks
from linkwright.studies.batch_quadrature import corners, mean
from linkwright.studies.follower_locking import square
from linkwright.studies.one_sided_limits import sides

if TYPE_CHECKING:
    from linkwright.studies.batch_plan import Measuring

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Extreme = tuple[Node, BoundWindow | None, float]
"""An expression, the window over which it is looked at, 1 for its largest value and -1 for its smallest."""

SETTLED = 1e-9
"""A mean that differs by more than this share of the mean magnitude from that on half as many panels isn't settled."""
STEEP = 3.0
"""A curve whose neighbours are so many times its least magnitude on the grid comes too near to zero for it."""


@dataclass
class Many:
    """The measures of samples: ``figures[measure][label]`` in SI, the label "" or min and max.

    ``failed`` (samples,) are those that can't be assembled all along the run or come to a singular pose: all their
    figures are NaN. ``met`` says of each measure with a requirement whether a sample meets it; NaN doesn't.
    """

    failed: Mask
    figures: dict[str, dict[str, Figures]] = field(default_factory=dict)
    met: dict[str, Mask] = field(default_factory=dict)

    @property
    def good(self) -> Mask:
        """Which samples run and meet all requirements: (samples,)."""
        return np.asarray(np.logical_and.reduce([~self.failed, *self.met.values()]))


class Taken:
    """The measures of one bunch of samples."""

    def __init__(self, measuring: Measuring, bunch: Bunch) -> None:
        self.measuring, self.bunch = measuring, bunch
        bunch.watch(measuring.watched)
        self.windows = Windows(bunch, measuring.jumping)
        self.sides = sides(bunch, measuring.joins, self.windows.gaps)
        self.means: dict[tuple[Node, BoundWindow | None, int, int], tuple[Array, Array]] = {}

    def evaluate_all(self) -> Many:
        """All of them."""
        asked = self.measuring
        self.extremes, self.coarse = self.all_extremes(), dict[str, Mask]()
        many = Many(self.failed())
        single = [measure for measure in asked.measures if measure.name in asked.single]
        for measure in asked.measures:
            many.figures[measure.name] = self.blank(measure) if measure in single else self.figures(measure)
        self.singly(many, single, ~many.failed)
        near = self.bunch.fast | self.close([*asked.reaches, *asked.determinants])
        for measure in asked.shared:
            some = near | self.close(asked.hard(measure)) | self.coarse.get(measure.name, False)
            self.singly(many, [measure], some & ~many.failed)
        for measure in asked.measures:
            found = many.figures[measure.name].values()
            for figures in found:
                unknown = many.failed | ~np.isfinite(figures.values)
                figures.values[unknown] = figures.times[unknown] = np.nan
            if measure.requirement is not None:
                many.met[measure.name] = measure.requirement_met(
                    self.bunch.quantities, [figures.values for figures in found]
                )
        return many

    def close(self, what: Sequence[What]) -> Mask:
        """In which samples some curve changes its sign, or comes so near to zero that the grid is too coarse there."""
        found = np.zeros(self.bunch.samples, dtype=bool)
        for curve in what:
            value, _ = self.bunch.on_grid(curve)
            size = np.abs(value)
            least = np.where(np.isfinite(size), size, np.inf)[:, 1:-1].argmin(axis=1) + 1
            around = np.stack([np.take_along_axis(size, (least + k)[:, None], axis=1)[:, 0] for k in (-1, 0, 1)])
            found |= (value > 0).any(axis=1) & (value < 0).any(axis=1)
            found |= ~(around.max(axis=0) <= STEEP * around[1]) | (size[:, [0, -1]].min(axis=1) < around[1] / STEEP)
        return found

    def failed(self) -> Mask:
        """Which samples can't be assembled all along their run, or come to a singular pose."""
        asked, bunch = self.measuring, self.bunch
        whole = spans(bunch, None)
        failed = np.asarray(np.isnan(bunch.p).any(axis=0))
        for row in (*asked.reaches, *asked.spans, *asked.determinants):
            value, _ = bunch.on_grid(row)
            failed |= (value > 0).any(axis=1) & (value < 0).any(axis=1)
        for reach in asked.reaches:
            failed |= ~(peaks(bunch, reach, [(whole, -1.0)])[0].values > TOUCH)
        for span in asked.spans:
            size = bunch.on_grid(span)[0]
            failed |= ~(np.abs(size).min(axis=1) > SINGULAR * size.max(axis=1))
        for determinant in asked.determinants:
            failed |= ~(np.abs(bunch.on_grid(determinant)[0]).min(axis=1) > SINGULAR)
        for pressure in asked.pressures:
            failed |= square(bunch.on_grid(pressure)[0]).any(axis=1)
        return failed

    def all_extremes(self) -> dict[Extreme, Figures]:
        """Every extreme that a measure needs, those of one curve together."""
        asks: dict[Node, dict[tuple[BoundWindow | None, float], None]] = {}
        for tree, window, sign in self.needed_extremes():
            asks.setdefault(tree, {})[window, sign] = None
        found: dict[Extreme, Figures] = {}
        jumping = [tree for tree in asks if self.sides is not None and self.measuring.run.may_jump(tree)]
        beside = self.sides.candidates(self.bunch, jumping) if self.sides is not None and jumping else {}
        for tree, places in asks.items():
            asked = [(self.windows[window], sign) for window, sign in places]
            figures = peaks(
                self.bunch, tree, asked, self.windows.gaps, beside.get(tree), self.measuring.run.cancelling(tree)
            )
            found |= {(tree, *place): figure for place, figure in zip(places, figures, strict=True)}
        return found

    def needed_extremes(self) -> Iterator[Extreme]:
        """The extremes that the measures need: curve, window, sign."""
        for measure in self.measuring.shared:
            for key, sign in measure.kind.needed_extremes(measure.entry) or ():
                yield measure.trees[key], measure.window, sign

    def blank(self, measure: BoundMeasure) -> dict[str, Figures]:
        """The labels of a measure, without figures yet."""
        size = self.bunch.samples
        return {label: Figures(np.full(size, np.nan), np.full(size, np.nan)) for label in measure.kind.labels}

    def figures(self, measure: BoundMeasure) -> dict[str, Figures]:
        """A measure's figures by label, in its range of angles."""
        found, quantities = measure.kind.figures(SampledMeasure(self, measure)), self.bunch.quantities
        return {
            label: Figures(measure.wrapped(quantities, figures.values).copy(), figures.times.copy())
            for label, figures in found.items()
        }

    def singly(self, many: Many, measures: Sequence[BoundMeasure], some: Mask) -> None:
        """Put in what is taken of some samples one after the other."""
        bunch = self.bunch
        for i in np.flatnonzero(some) if measures else ():
            run = sample_run(bunch.varied, bunch.run, bunch.p[:, i], float(bunch.stop[i]), bunch.kernel)
            for result in measure_all(run, measures)[0]:
                found = {f.label: f for f in result.found}
                for label, figures in many.figures[result.name].items():
                    value, time = (found[label].value, found[label].time) if label in found else (np.nan, None)
                    figures.values[i], figures.times[i] = value, np.nan if time is None else time


@dataclass(frozen=True)
class SampledMeasure:
    """One measure of a bunch of samples, as :class:`~linkwright.reductions.InSamples` has it."""

    taken: Taken
    asked: BoundMeasure

    @property
    def measure(self) -> Measure:
        """The entry."""
        return self.asked.entry

    @property
    def _window(self) -> Spans:
        return self.taken.windows[self.asked.window]

    @property
    def length(self) -> Array:
        """How long each one's window is (s)."""
        owner, a, b = self._window.flat()
        return np.asarray(np.bincount(owner, b - a, self.taken.bunch.samples), dtype=float)

    @property
    def window_ends(self) -> tuple[Array, Array]:
        """Where each one's window begins and ends (s)."""
        return self._window.first, self._window.last

    def extreme(self, sign: float, key: str = "") -> Figures:
        """The largest values of an expression, or with the sign -1 the smallest."""
        return self.taken.extremes[self.asked.trees[key], self.asked.window, sign]

    def mean(self, key: str = "") -> Array:
        """The mean of the kind's power of an expression; samples for which its panels are too coarse are noted."""
        return self._means(key)[0]

    def magnitude(self, key: str = "") -> Array:
        """The mean of the magnitude of that."""
        return self._means(key)[1]

    def _means(self, key: str) -> tuple[Array, Array]:
        plan, bunch, tree, power = self.taken.measuring, self.taken.bunch, self.asked.trees[key], self.asked.kind.power
        assert power is not None
        panels, known = plan.panels[self.asked.name], self.taken.means
        for count in (panels, panels // 2):  # measures that compare works share most of theirs
            if (key_of := (tree, self.asked.window, power, count)) not in known:
                known[key_of] = mean(bunch, tree, self._window, power, count, corners(bunch, tree, plan.kinks))
        values, size = known[tree, self.asked.window, power, panels]
        half, _ = known[tree, self.asked.window, power, panels // 2]
        with np.errstate(invalid="ignore"):
            coarse = ~(np.abs(values - half) <= SETTLED * size)
        self.taken.coarse[self.asked.name] = coarse | self.taken.coarse.get(self.asked.name, False)
        return values, size

    def values(self, times: Array) -> Array:
        """The signal of each at a time (s) of its own."""
        who = np.flatnonzero(np.isfinite(times))
        values = np.full_like(times, np.nan)
        values[who] = self.taken.bunch.values(self.asked.signal, who, times[who])
        return values
