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

from linkwright.expressions.language import Node, parse
from linkwright.graph.rows import determinants, reaches, spans
from linkwright.kernels.parameter_batch import Varied
from linkwright.measures import MeasureResult, bound, measure_all
from linkwright.measures.features import features
from linkwright.reductions import Figures, Measure, kind_of
from linkwright.results import Run
from linkwright.results.batch_run import Bunch, What
from linkwright.results.batch_windows import Windows
from linkwright.results.discontinuities import kinks, law_joins
from linkwright.results.stationary import fineness
from linkwright.studies.batch_quadrature import CLOSE, FIRST_PANELS, MOST_PANELS, corners, mean
from linkwright.studies.follower_locking import angles
from linkwright.studies.taken import Many, Taken

Array = NDArray[np.float64]

MOST_STEPS = 1 << 12
"""The finest grid that samples share."""
ALIKE = 1e-9
"""How near a measure of one sample is to be to that of a run of its own, over its size."""
CHUNK = 1 << 17
"""Poses of the grid that are looked at together."""


def measure_many(
    varied: Varied, run: Run, p: Array, names: Sequence[str] | None = None, stop: Array | None = None
) -> Many:
    """The measures of some names, or all, of the samples ``p`` (parameters, samples) as :meth:`Varied.parameters`
    gives them. ``run`` is the nominal one; ``stop`` (samples,) are the ends of their runs (s) where these differ.

    To ask again and again keep a :class:`Measuring`.
    """
    return Measuring(varied, run, names).of(p, stop)


class Measuring:
    """What the nominal run tells of how to measure many others; :meth:`of` may be called from several threads."""

    def __init__(self, varied: Varied, run: Run, names: Sequence[str] | None = None, kernel: str = "numpy") -> None:
        self.varied, self.run, self.kernel = varied, run, kernel
        self.quantities, self.graph = run.compiled.quantities, run.compiled.graph
        measures = self.quantities.mechanism.measures
        self.measures = {name: measures[name] for name in (measures if names is None else names)}
        self.trees = {key: tree for name in self.measures for key, tree in bound(self.quantities, name).items()}
        structure = run.compiled.structure
        self.reaches, self.spans, self.determinants = reaches(structure), spans(structure), determinants(structure)
        self.pressures = [row for row, _ in angles(run.compiled)]
        varying = varied.joins(run.compiled.parameters[:, None])
        self.kinks, self.joins = kinks(run.compiled, varying), law_joins(run.compiled, varying)
        self.single = [name for name, measure in self.measures.items() if self._singly(name, measure)]
        self.steps = self._steps()
        self.jumping = self._jumping()
        self.panels = self._panels()
        self.single += self._apart()

    # What the nominal run tells.

    def _of(self, name: str) -> list[Node]:
        """The expressions of a measure, that of its window among them."""
        measure = self.measures[name]
        keys, window = (name, *(f"{name} {key}" for key in measure.also)), measure.window
        signal = self.quantities.mechanism.windows[window] if window else ()
        texts = [] if isinstance(signal, tuple) else [*signal]
        return [self.trees[key] for key in keys] + [
            self.quantities.dimensions.bind(parse(text), None) for text in texts
        ]

    def _singly(self, name: str, measure: Measure) -> bool:
        """Whether a measure is taken of one sample after the other."""
        kind = kind_of(measure)
        if kind.needs(measure) is None:
            return True
        signals = [self.graph.signal(text) for text in self.run.signals_of(self._of(name))]
        if any(signal.kind == "pole" for signal in signals):
            return True
        if all(signal.kinematic for signal in signals):
            return False
        tables, lookups = self.run.compiled.tables, self.graph.actions.lookups
        straight = any(tables[lookup.table].degree == 1 and not lookup.integral for lookup in lookups)
        return straight and kind.power is not None

    def _steps(self) -> int:
        """The steps of the grid; measures that the nominal run needs a finer one for go to the others."""
        run, steps = self.run, [min(self.run.grid, MOST_STEPS)]
        trees = {name: self._of(name) for name in self.measures if name not in self.single}
        every = [*dict.fromkeys(tree for some in trees.values() for tree in some)]
        fine = fineness(partial(run.all_rates, every), run.start, run.stop, run.grid) if every else []
        needed = dict(zip(every, fine, strict=True))
        for name, some in trees.items():
            finest = max((needed[tree] // 2 for tree in some), default=0)  # half would do, and a quarter just so
            if finest > MOST_STEPS:
                self.single.append(name)
            else:
                steps.append(finest)
        return max(steps)

    def _jumping(self) -> bool:
        """Whether something may jump that is measured of all samples together: forces do where a load's window ends."""
        shared = [tree for name in self.measures if name not in self.single for tree in self._of(name)]
        forces = any(not self.graph.signal(text).kinematic for text in self.run.signals_of(shared))
        return forces and bool(self.graph.actions.windows or self.graph.actions.jumps)

    def _panels(self) -> dict[str, int]:
        """The panels of each mean; measures that need too many go to the others."""
        found: dict[str, int] = {}
        nominal = self.run.compiled.parameters[:, None]
        bunch = Bunch(self.varied, self.run, nominal, self.steps, kernel=self.kernel)
        windows = Windows(bunch, self.jumping)
        for name, measure in self.measures.items():
            power = kind_of(measure).power
            if power is None or name in self.single:
                continue
            where, places = windows[measure.window], corners(bunch, self.trees[name], self.kinks)
            panels, last = FIRST_PANELS, np.full(1, np.inf)
            while panels <= MOST_PANELS:
                now, size = mean(bunch, self.trees[name], where, power, panels, places)
                if not abs(now - last)[0] > CLOSE * size[0]:
                    break
                panels, last = 2 * panels, now
            if panels > MOST_PANELS:
                self.single.append(name)
            else:
                found[name] = panels
        return found

    def _apart(self) -> list[str]:
        """The measures for which the shared grid is too coarse already at the nominal parameters: what is taken of
        these together differs from the run's own measures."""
        shared = [name for name in self.measures if name not in self.single]
        nominal = Bunch(self.varied, self.run, self.run.compiled.parameters[:, None], self.steps, kernel=self.kernel)
        many = Taken(self, nominal).many()
        if not shared or many.failed.any():
            return []
        own = {result.name: result for result in measure_all(self.run, shared)[0]}
        sizes = {name: float(np.abs(nominal.on_grid(self.trees[name])[0]).max()) for name in shared}
        return [name for name in shared if not _alike(own[name], many.figures[name], sizes[name])]

    def hard(self, name: str) -> list[Node]:
        """The break functions of a measure at whose zeros it need not be continuous."""
        find = self.quantities.signals.find
        found = [feature for tree in self._of(name) for feature in features(tree, find)]
        return [feature.node for feature in found if feature.kind.hard]

    # Many samples.

    def of(self, p: Array, stop: Array | None = None) -> Many:
        """The measures of samples; what one gives doesn't depend on the others, to the last bit."""
        step = max(1, CHUNK // (self.steps + 1))
        parts = []
        for first in range(0, p.shape[1], step):
            some = slice(first, first + step)
            bunch = Bunch(
                self.varied, self.run, p[:, some], self.steps, None if stop is None else stop[some], self.kernel
            )
            parts.append(Taken(self, bunch).many())
        return _joined(parts)

    @cached_property
    def watched(self) -> list[What]:
        """All curves that are looked at on the grid."""
        trees = [tree for name in self.measures if name not in self.single for tree in self._of(name)]
        breaking = [node for name in self.measures if name not in self.single for node in self.hard(name)]
        followed = (*self.reaches, *self.spans, *self.determinants)  # they tell whether a sample can be followed
        return [*dict.fromkeys([*trees, *breaking]), *followed, *self.pressures]


def _alike(own: MeasureResult, found: dict[str, Figures], size: float) -> bool:
    """Whether a measure of a run and that of one sample agree; ``size`` is that of the expression."""
    known = {f.label: f.value for f in own.found}
    size = max(size, *(abs(value) for value in known.values()), 0.0)
    return {*known} == {*found} and all(
        abs(known[label] - float(figures.values[0])) <= ALIKE * size for label, figures in found.items()
    )


def _joined(parts: Sequence[Many]) -> Many:
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
