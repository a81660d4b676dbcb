"""The measures of many samples of a mechanism at once.

They are those of :mod:`linkwright.studies.measures`, to round-off. Extremes and places are root-found on exact rates
in brackets of a grid, means integrated on panels; the grid is twice and the panels twice as fine as the nominal run
needs. (A run of its own doubles its grid for itself; here two turning points of a sample that lie between two places
of the grid are missed.) Windows, jumps and corners follow each sample's own parameters.

One sample after the other goes through a run of its own: ``dwell`` and ``straightness``; measures of instant centres;
of forces, where loads act in windows only, and means of forces, where loads ask tables of straight lines; what the
nominal run needs a very fine grid for; and all measures of samples that turn too fast for the grid.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from linkwright.kernels.varied import Varied
from linkwright.model.check import WHERE
from linkwright.model.expressions import Node, parse
from linkwright.model.mechanism import Measure
from linkwright.model.places import figure
from linkwright.results import Run
from linkwright.results.alone import alone
from linkwright.results.breaks import kinks
from linkwright.results.bunch import Bunch, What
from linkwright.results.spans import Spans, spans
from linkwright.results.stationary import fineness
from linkwright.studies.feasible import SINGULAR, TOUCH
from linkwright.studies.means import CLOSE, FIRST_PANELS, MOST_PANELS, corners, mean
from linkwright.studies.measures import bound, measure_all
from linkwright.studies.peaks import Figures, peaks

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

MOST_STEPS = 1 << 12
"""The finest grid that samples share."""
CHUNK = 1 << 17
"""Poses of the grid that are looked at together."""
LABELS = {"extremes": ("min", "max")}
BOTH = {"min": -1.0, "max": 1.0}
EXTREMES = {"max": {"": 1.0}, "min": {"": -1.0}, "extremes": BOTH, "span": BOTH}
POWERS = {"mean": 1, "path": 1, "rms": 2}


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
        self.rows = self._rows()
        self.kinks = kinks(run.compiled)
        self.single = [name for name, measure in self.measures.items() if self._singly(name, measure)]
        self.steps = self._steps()
        self.panels = self._panels()

    # What the nominal run tells.

    def _rows(self) -> list[str]:
        """The rows that tell whether a sample can be followed."""
        structure = self.run.compiled.structure
        found = [f"reach:{group.label}" for group in structure.groups if group.modes > 1]
        found += [f"span:{group.label}" for group in structure.groups if group.has_span]
        labels = [*(group.label for group in structure.groups), *(cluster.label for cluster in structure.clusters)]
        return found + [f"determinant:{label}" for label in labels]

    def _of(self, name: str) -> list[Node]:
        """The expressions of a measure, that of its window among them."""
        keys, window = (name, f"{name} where"), self.measures[name].window
        signal = self.quantities.mechanism.windows[window] if window else ()
        texts = [] if isinstance(signal, tuple) else [*signal]
        return [self.trees[key] for key in keys if key in self.trees] + [
            self.quantities.dimensions.bind(parse(text), None) for text in texts
        ]

    def _singly(self, name: str, measure: Measure) -> bool:
        """Whether a measure is taken of one sample after the other."""
        if measure.reduction not in (*EXTREMES, *POWERS, "value"):
            return True
        signals = [self.graph.signal(text) for text in self.run.signals_of(self._of(name))]
        if any(signal.kind == "pole" for signal in signals):
            return True
        if all(signal.kinematic for signal in signals):
            return False
        actions, tables = self.graph.actions, self.run.compiled.tables
        straight = any(tables[lookup.table].degree == 1 and not lookup.integral for lookup in actions.lookups)
        return bool(actions.windows) or (straight and measure.reduction in POWERS)

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

    def _panels(self) -> dict[str, int]:
        """The panels of each mean; measures that need too many go to the others."""
        found: dict[str, int] = {}
        nominal = self.run.compiled.parameters[:, None]
        bunch = Bunch(self.varied, self.run, nominal, self.steps, kernel=self.kernel)
        for name, measure in self.measures.items():
            if measure.reduction not in POWERS or name in self.single:
                continue
            where, places = spans(bunch, measure.window), corners(bunch, self.trees[name], self.kinks)
            panels, last = FIRST_PANELS, np.full(1, np.inf)
            while panels <= MOST_PANELS:
                now, size = mean(bunch, self.trees[name], where, POWERS[measure.reduction], panels, places)
                if not abs(now - last)[0] > CLOSE * size[0]:
                    break
                panels, last = 2 * panels, now
            if panels > MOST_PANELS:
                self.single.append(name)
            else:
                found[name] = panels
        return found

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
            parts.append(_Taken(self, bunch).many())
        return _joined(parts)

    @cached_property
    def watched(self) -> list[What]:
        """All curves that are looked at on the grid."""
        trees = [tree for name in self.measures if name not in self.single for tree in self._of(name)]
        return [*dict.fromkeys(trees), *self.rows]


class _Taken:
    """The measures of one bunch of samples."""

    def __init__(self, measuring: Measuring, bunch: Bunch) -> None:
        self.measuring, self.bunch = measuring, bunch
        self.windows: dict[str | None, Spans] = {}
        bunch.watch(measuring.watched)

    def many(self) -> Many:
        """All of them."""
        asked = self.measuring
        self.extremes = self.all_extremes()
        many = Many(self.failed())
        for name, measure in asked.measures.items():
            many.figures[name] = self.blank(measure) if name in asked.single else self.figures(name, measure)
        self.singly(many, asked.single, ~many.failed)
        self.singly(many, [name for name in asked.measures if name not in asked.single], self.bunch.fast & ~many.failed)
        for name, found in many.figures.items():
            for figures in found.values():
                unknown = many.failed | ~np.isfinite(figures.values)
                figures.values[unknown] = figures.times[unknown] = np.nan
            if name in self.bunch.quantities.mechanism.require:
                many.met[name] = self.verdict(name, asked.measures[name], found)
        return many

    def window(self, name: str | None) -> Spans:
        """The spans that a window means."""
        if name not in self.windows:
            self.windows[name] = spans(self.bunch, name)
        return self.windows[name]

    def failed(self) -> Mask:
        """Which samples can't be assembled all along their run, or come to a singular pose."""
        bunch = self.bunch
        whole = self.window(None)
        failed = np.asarray(np.isnan(bunch.p).any(axis=0))
        for row in self.measuring.rows:
            value, _ = bunch.on_grid(row)
            least, limit = np.abs(value).min(axis=1), SINGULAR
            if row.startswith("reach:"):
                least, limit = peaks(bunch, row, [(whole, -1.0)])[0].values, TOUCH
            elif row.startswith("span:"):
                limit = SINGULAR * value.max(axis=1)
            failed |= ~(least > limit) | ((value > 0).any(axis=1) & (value < 0).any(axis=1))
        return failed

    def all_extremes(self) -> dict[tuple[Node, str | None, float], Figures]:
        """Every extreme that a measure needs, those of one curve together."""
        asks: dict[Node, dict[tuple[str | None, float], None]] = {}
        for tree, window, sign in self.wanted():
            asks.setdefault(tree, {})[window, sign] = None
        found: dict[tuple[Node, str | None, float], Figures] = {}
        for tree, places in asks.items():
            figures = peaks(self.bunch, tree, [(self.window(window), sign) for window, sign in places])
            found |= {(tree, *place): figure for place, figure in zip(places, figures, strict=True)}
        return found

    def wanted(self) -> Iterator[tuple[Node, str | None, float]]:
        """The extremes that the measures need: curve, window, sign."""
        trees = self.measuring.trees
        for name, measure in self.measuring.measures.items():
            if name in self.measuring.single:
                continue
            for sign in EXTREMES.get(measure.reduction, {}).values():
                yield trees[name], measure.window, sign
            if f"{name} where" in trees:
                yield trees[f"{name} where"], measure.window, _sign(measure)

    def blank(self, measure: Measure) -> dict[str, Figures]:
        """The labels of a measure, without figures yet."""
        size = self.bunch.samples
        return {
            label: Figures(np.full(size, np.nan), np.full(size, np.nan))
            for label in LABELS.get(measure.reduction, ("",))
        }

    def figures(self, name: str, measure: Measure) -> dict[str, Figures]:
        """A measure's figures by label, in its range of angles."""
        found = self.reduced(name, measure)
        values = {label: figures.values for label, figures in found.items()}
        if measure.wrap is not None:
            quantities = self.bunch.quantities
            dimension = quantities.dimensions.resolve(figure(name, measure))
            low, high = (quantities.value(edge, dimension) for edge in measure.wrap)
            with np.errstate(invalid="ignore"):
                values = {label: low + (value - low) % (high - low) for label, value in values.items()}
        return {label: Figures(values[label].copy(), figures.times.copy()) for label, figures in found.items()}

    def reduced(self, name: str, measure: Measure) -> dict[str, Figures]:
        """A measure's figures as its reduction gives them."""
        tree, signs = self.measuring.trees[name], EXTREMES.get(measure.reduction)
        if measure.reduction == "value":
            return {"": self.placed(name, measure)}
        if signs is None:
            return {"": self.integral(name, measure)}
        found = {label: self.extremes[tree, measure.window, sign] for label, sign in signs.items()}
        if measure.reduction == "span":
            values = found["max"].values - found["min"].values
            return {"": Figures(values, np.full_like(values, np.nan))}
        return found

    def placed(self, name: str, measure: Measure) -> Figures:
        """A value at the place that `where` names."""
        trees, window = self.measuring.trees, self.window(measure.window)
        if f"{name} where" in trees:
            times = self.extremes[trees[f"{name} where"], measure.window, _sign(measure)].times
        else:
            times = window.first if (measure.where or "").strip() == "start" else window.last
        who = np.flatnonzero(np.isfinite(times))
        values = np.full_like(times, np.nan)
        values[who] = self.bunch.values(trees[name], who, times[who])
        return Figures(values, times)

    def integral(self, name: str, measure: Measure) -> Figures:
        """A mean or what follows from one."""
        asked, bunch, window = self.measuring, self.bunch, self.window(measure.window)
        places = corners(bunch, asked.trees[name], asked.kinks)
        power, panels = POWERS[measure.reduction], asked.panels[name]
        values, _ = mean(bunch, asked.trees[name], window, power, panels, places)
        if measure.reduction == "rms":
            values = np.sqrt(values)
        if measure.reduction == "path":
            owner, a, b = window.flat()
            values = values * np.bincount(owner, b - a, bunch.samples)
        return Figures(values, np.full_like(values, np.nan))

    def singly(self, many: Many, names: Sequence[str], some: Mask) -> None:
        """Put in what is taken of some samples one after the other."""
        bunch = self.bunch
        for i in np.flatnonzero(some) if names else ():
            run = alone(bunch.varied, bunch.run, bunch.p[:, i], float(bunch.stop[i]), bunch.kernel)
            for result in measure_all(run, names)[0]:
                found = {f.label: f for f in result.found}
                for label, figures in many.figures[result.name].items():
                    value, time = (found[label].value, found[label].time) if label in found else (np.nan, None)
                    figures.values[i], figures.times[i] = value, np.nan if time is None else time

    def verdict(self, name: str, measure: Measure, found: dict[str, Figures]) -> Mask:
        """Which samples meet the requirement on a measure."""
        quantities = self.bunch.quantities
        requirement = quantities.mechanism.require[name]
        dimension = quantities.dimensions.resolve(figure(name, measure))
        low = -np.inf if requirement.low is None else quantities.value(requirement.low, dimension)
        high = np.inf if requirement.high is None else quantities.value(requirement.high, dimension)
        return np.asarray(np.logical_and.reduce([(low <= f.values) & (f.values <= high) for f in found.values()]))


def _sign(measure: Measure) -> float:
    match = WHERE.match(measure.where or "")
    assert match is not None
    return 1.0 if match[1] == "max" else -1.0


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
