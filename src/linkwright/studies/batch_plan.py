"""The measures of many samples of a mechanism at once.

They are those of :mod:`linkwright.measures`, to round-off. Extremes and places are root-found on exact rates
in brackets of a grid, means integrated on panels; the grid is twice and the panels twice as fine as the nominal run
needs. (A run of its own doubles its grid for itself; here two turning points of a sample that lie between two places
of the grid are missed.) Windows, jumps and corners follow each sample's own parameters.

One sample after the other goes through a run of its own: reductions that can't be taken of many at once; measures of
instant centres; means of forces, where loads ask tables of straight lines; what the nominal run needs a very fine grid
for, or gives otherwise; measures of samples in which one of their break functions vanishes or nearly does; and all
measures of samples that turn too fast for the grid, or come near to a singular pose.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import Node
from linkwright.graph.rows import determinants, reaches, spans
from linkwright.kernels.parameter_batch import Varied
from linkwright.measures import BoundMeasure, MeasureResult, bound_measures, measure_all
from linkwright.measures.features import features
from linkwright.reductions import Figures
from linkwright.results import Run
from linkwright.results.batch_run import Bunch, What
from linkwright.results.batch_windows import Windows
from linkwright.results.discontinuities import kinks, law_joins
from linkwright.results.run import ROUND_OFF
from linkwright.results.stationary import fineness
from linkwright.studies.batch_quadrature import CLOSE, FIRST_PANELS, MOST_PANELS, corners, mean
from linkwright.studies.follower_locking import angles
from linkwright.studies.sampled_measure import Many, Taken

Array = NDArray[np.float64]

MOST_STEPS = 1 << 12
"""The finest grid that samples share."""
ALIKE = 1e-9
"""How near a measure of one sample is to be to that of a run of its own, over its size."""
SLIGHT = ROUND_OFF / ALIKE
"""The share of what cancels in an expression below which its size doesn't count: a share :data:`ALIKE` of it is
round-off."""
CHUNK = 1 << 17
"""Poses of the grid that are looked at together."""


class Measuring:
    """What the nominal run tells of how to measure many others; :meth:`of` may be called from several threads."""

    def __init__(
        self, varied: Varied, run: Run, measures: Sequence[BoundMeasure] | None = None, kernel: str = "numpy"
    ) -> None:
        self.varied, self.run, self.kernel = varied, run, kernel
        self.quantities, self.graph = run.compiled.quantities, run.compiled.graph
        self.measures = bound_measures(self.quantities) if measures is None else measures
        structure = run.compiled.structure
        self.reaches, self.spans, self.determinants = reaches(structure), spans(structure), determinants(structure)
        self.pressures = [row for row, _ in angles(run.compiled)]
        varying = varied.joins(run.compiled.parameters[:, None])
        self.kinks, self.joins = kinks(run.compiled, varying), law_joins(run.compiled, varying)
        self.single = {measure.name for measure in self.measures if self._singly(measure)}
        self.steps = self._steps()
        self.jumping = self._jumping()
        self.panels = self._panels()
        self.single |= self._coarse_measures()

    # What the nominal run tells.

    @property
    def shared(self) -> list[BoundMeasure]:
        """The measures that are taken of all samples together."""
        return [measure for measure in self.measures if measure.name not in self.single]

    def _singly(self, measure: BoundMeasure) -> bool:
        """Whether a measure is taken of one sample after the other."""
        if measure.kind.needed_extremes(measure.entry) is None:
            return True
        signals = [self.graph.signal(text) for text in self.run.signals_of(measure.nodes)]
        if any(signal.kind == "pole" for signal in signals):
            return True
        if all(signal.kinematic for signal in signals):
            return False
        tables, lookups = self.run.compiled.tables, self.graph.actions.lookups
        straight = any(tables[lookup.table].degree == 1 and not lookup.integral for lookup in lookups)
        return straight and measure.kind.power is not None

    def _steps(self) -> int:
        """The steps of the grid; measures that the nominal run needs a finer one for go to the others."""
        run, steps = self.run, [min(self.run.grid, MOST_STEPS)]
        every = [*dict.fromkeys(node for measure in self.shared for node in measure.nodes)]
        scales = [run.cancelling(node) for node in every]
        fine = fineness(partial(run.all_rates, every), run.start, run.stop, run.grid, scales) if every else []
        needed = dict(zip(every, fine, strict=True))
        for measure in self.shared:
            # Half of what it needs would do, and a quarter just so.
            finest = max((needed[node] // 2 for node in measure.nodes), default=0)
            if finest > MOST_STEPS:
                self.single.add(measure.name)
            else:
                steps.append(finest)
        return max(steps)

    def _jumping(self) -> bool:
        """Whether something may jump that is measured of all samples together: forces do where a load's window ends."""
        shared = self.run.signals_of([node for measure in self.shared for node in measure.nodes])
        forces = any(not self.graph.signal(text).kinematic for text in shared)
        return forces and bool(self.graph.actions.windows or self.graph.actions.jumps)

    def _panels(self) -> dict[str, int]:
        """The panels of each mean; measures that need too many go to the others."""
        found: dict[str, int] = {}
        nominal = self.run.compiled.parameters[:, None]
        bunch = Bunch(self.varied, self.run, nominal, self.steps, kernel=self.kernel)
        windows = Windows(bunch, self.jumping)
        for measure in self.shared:
            power = measure.kind.power
            if power is None:
                continue
            needed = [FIRST_PANELS]
            for tree in (measure.trees[key] for key in measure.kind.averaged):
                where, places = windows[measure.window], corners(bunch, tree, self.kinks)
                panels, last = FIRST_PANELS, np.full(1, np.inf)
                while panels <= MOST_PANELS:
                    now, size = mean(bunch, tree, where, power, panels, places)
                    if not abs(now - last)[0] > CLOSE * size[0]:
                        break
                    panels, last = 2 * panels, now
                needed.append(panels)
            if max(needed) > MOST_PANELS:
                self.single.add(measure.name)
            else:
                found[measure.name] = max(needed)
        return found

    def _coarse_measures(self) -> set[str]:
        """The measures for which the shared grid is too coarse already at the nominal parameters: what is taken of
        these together differs from the run's own measures."""
        nominal = Bunch(self.varied, self.run, self.run.compiled.parameters[:, None], self.steps, kernel=self.kernel)
        many = Taken(self, nominal).evaluate_all()
        if not self.shared or many.failed.any():
            return set()
        sizes = [
            max(float(np.abs(nominal.on_grid(measure.signal)[0]).max()), SLIGHT * self.run.cancelling(measure.signal))
            for measure in self.shared
        ]
        own = measure_all(self.run, self.shared)[0]
        pairs = zip(own, sizes, strict=True)
        return {one.name for one, size in pairs if not _alike(one, many.figures[one.name], size)}

    def hard(self, measure: BoundMeasure) -> list[Node]:
        """The break functions of a measure at whose zeros it need not be continuous."""
        find = self.quantities.signals.find
        found = [feature for node in measure.nodes for feature in features(node, find)]
        return [feature.node for feature in found if feature.kind.hard]

    # Many samples.

    def evaluate(self, p: Array, stop: Array | None = None) -> Many:
        """The measures of samples; what one gives doesn't depend on the others, to the last bit."""
        step = max(1, CHUNK // (self.steps + 1))
        parts = []
        for first in range(0, p.shape[1], step):
            some = slice(first, first + step)
            bunch = Bunch(
                self.varied, self.run, p[:, some], self.steps, None if stop is None else stop[some], self.kernel
            )
            parts.append(Taken(self, bunch).evaluate_all())
        return _concatenated_samples(parts)

    @cached_property
    def watched(self) -> list[What]:
        """All curves that are looked at on the grid."""
        trees = [node for measure in self.shared for node in measure.nodes]
        breaking = [node for measure in self.shared for node in self.hard(measure)]
        followed = (*self.reaches, *self.spans, *self.determinants)  # they tell whether a sample can be followed
        return [*dict.fromkeys([*trees, *breaking]), *followed, *self.pressures]


def _alike(own: MeasureResult, found: dict[str, Figures], size: float) -> bool:
    """Whether a measure of a run and that of one sample agree; ``size`` is that of the expression."""
    known = {f.label: f.value for f in own.found}
    size = max(size, *(abs(value) for value in known.values()), 0.0)
    return {*known} == {*found} and all(
        abs(known[label] - float(figures.values[0])) <= ALIKE * size for label, figures in found.items()
    )


def _concatenated_samples(parts: Sequence[Many]) -> Many:
    """Some samples after others."""
    many = Many(np.concatenate([part.failed for part in parts]))
    for name, found in parts[0].figures.items():
        many.figures[name] = {
            label: Figures(
                np.concatenate([part.figures[name][label].values for part in parts]),
                np.concatenate([part.figures[name][label].times for part in parts]),
            )
            for label in found
        }
    many.met = {name: np.concatenate([part.met[name] for part in parts]) for name in parts[0].met}
    return many
