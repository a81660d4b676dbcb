"""The check that covers every reported signal: what each one misses of its formula from raw geometry, and each rate of
the change of what it is the rate of."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.joint import Restated
from linkwright.expressions.language import Call, Name, parse
from linkwright.expressions.units import Dimension
from linkwright.model.signals import BREAKAWAY, POWER, TOTALS, Signal, Signals
from linkwright.results.independent_check import Reports
from linkwright.results.margins import LEAST_MARGIN, margins
from linkwright.results.quadrature import panel_points
from linkwright.results.reported_rates import rates
from linkwright.results.restated_signals import restated
from linkwright.results.run import Run

Array = NDArray[np.float64]

PANELS = 8
"""The stretches of the motion over which rates are integrated."""
STEPS = 4
"""The steps of the motion to a panel: over a wide one round-off counts less."""
INSIDE = 0.01
"""The share of a panel by which it keeps away from the ends of its step."""
RESOLVED = 1e-11
"""Two quadratures of a rate agree so closely, relative to its scale, where they are trusted."""
ROUND_OFF = 64 * np.finfo(float).eps
"""What the change of a signal loses, relative to its size or the mechanism's; more near a singular pose."""
FAINT = 1e-3
"""The least scale of a signal, over that of the mechanism's length, speed and forces."""
GOLDEN = (np.sqrt(5.0) - 1) / 2


class SignalCheck:
    """The reported signals of a run at its samples and on some panels between them, held against their formulas."""

    def __init__(self, run: Run, reports: Reports) -> None:
        self.run, self.reports = run, reports
        signals = run.compiled.quantities.signals
        self.signals: dict[str, Signal] = {**signals.by_text, **_totals(signals)}
        self.names, self.named_only = [*signals.by_text], [*_totals(signals)]
        """The names that results list, and those of powers and sums, which are asked by name."""
        self.rates = rates(signals)
        self.loaded = bool(reports.masses or any(one.kind.acts for one in reports.every))
        self.lows, self.highs = panels(run)
        nodes = [panel_points(*ends)[0] for ends in self._quadratures]
        self._t = np.concatenate([reports.t, self.lows, self.highs, *nodes])
        every = run.compiled.evaluate(self.names, self._t)
        self.values = dict(zip(self.names, every, strict=True))
        if self.named_only:
            more = run.compiled.evaluate(self.named_only, reports.t)
            self.values |= dict(zip(self.named_only, more, strict=True))

    @cached_property
    def _quadratures(self) -> list[tuple[Array, Array]]:
        """The ends of the panels, and those of their halves."""
        middle = (self.lows + self.highs) / 2
        return [(self.lows, self.highs), (self.lows, middle), (middle, self.highs)]

    def worst(self) -> tuple[float, str]:
        """The largest misfit of a signal, NaN where one isn't a number, and whose it is."""
        with np.errstate(all="ignore"):  # what isn't a number is told by the check
            misfits = self.misfits()
        return max(((misfit, name) for name, misfit in misfits.items()), default=(0.0, ""), key=_unless_number)

    def misfits(self) -> dict[str, float]:
        """By signal what it misses, over its scale; signals that equilibrium proves, and those of kinds of other
        packages that restate none, are left out."""
        every = ((name, self.misfit(name)) for name in self.signals)
        return {name: misfit for name, misfit in every if misfit is not None}

    def misfit(self, name: str) -> float | None:
        """The worst by which a signal misses its formulas, or as a rate the change of what it is the rate of; ``None``
        where there are none, NaN where it isn't a number."""
        told, scale = self.sampled(name), self.scales[name]
        missed = [self._missed(told, formula, scale) for formula in self.formulas(self.signals[name])]
        missed += [self._rate_misfit(value, name) for value in self.rates.get(name, ())]
        return max(missed, key=_large, default=None)

    def formulas(self, signal: Signal) -> list[Restated]:
        """Those of a signal; without masses and loads all that has to do with forces is zero."""
        found = [*restated(self.reports, signal)]
        if not self.loaded and signal.dimension.mass:
            found.append(Restated(np.zeros(self.reports.count)))
        return found

    def proven(self) -> set[str]:
        """The signals that some check of the certificate covers."""
        efforts = {f"{name}.{mover.effort}" for name, mover in self.reports.mechanism.movers.items()}
        starts = {name for name, signal in self.signals.items() if signal.attribute in BREAKAWAY}
        return {
            *self.misfits(),
            *efforts,
            *starts,
            *(name for name, one in self.signals.items() if one.kind == "shaking"),
        }

    def sampled(self, name: str) -> Array:
        """A signal at the samples."""
        return np.asarray(self.values[name][: self.reports.count])

    @cached_property
    def scales(self) -> dict[str, float]:
        """By signal the size against which it is judged: the largest value of its dimension, or its faint scale."""
        largest: dict[Dimension, float] = {}
        for name, signal in self.signals.items():
            value, key = np.abs(self.sampled(name)), signal.dimension.physical
            largest[key] = max(largest.get(key, 0.0), float(value[np.isfinite(value)].max(initial=0.0)))
        faint = self.faint_scales
        return {name: max(largest[signal.dimension.physical], faint[name]) for name, signal in self.signals.items()}

    @cached_property
    def faint_scales(self) -> dict[str, float]:
        """By signal a thousandth of what the mechanism's extent, its speeds and its forces make of its dimension."""
        length, force, rate = self.reports.size(), self._largest_force, self._fastest
        scales = {}
        for name, signal in self.signals.items():
            key = signal.dimension.physical
            mass, time = float(key.mass), float(key.time)
            made = force**mass * length ** (float(key.length) - mass) * rate ** -(time + 2 * mass) if rate else 0.0
            scales[name] = FAINT * made
        return scales

    @cached_property
    def _largest_force(self) -> float:
        """The largest force, moments over the mechanism's size (N)."""
        acting = [(np.hypot(*force), moment) for _, force, _, moment in self.reports.acting()]
        sizes = [float(np.nanmax(force, initial=0.0)) for force, _ in acting]
        for name, signal in self.signals.items():
            if signal.kind in ("force", "shaking"):
                value = np.abs(self.sampled(name))
                reach = self.reports.size() if signal.attribute == "moment" else 1.0
                if signal.attribute != "arm":
                    sizes.append(float(value[np.isfinite(value)].max(initial=0.0)) / reach)
        return max([*sizes, self.reports.centrifugal()], default=0.0)

    @cached_property
    def _fastest(self) -> float:
        """The largest angular velocity, speeds over the mechanism's size (1/s)."""
        r = self.reports
        rates = [np.abs(r.omega(link)) for link in r.topology.moving]
        rates += [np.hypot(*r.vector(f"{r.some_point(link)}.v")) / r.size() for link in r.topology.moving]
        return max((float(rate[np.isfinite(rate)].max(initial=0.0)) for rate in rates), default=0.0)

    def _missed(self, told: Array, formula: Restated, scale: float) -> float:
        """The worst misfit at the samples at which the formula says something."""
        says = np.isfinite(formula.value) & np.ones(told.shape, dtype=bool)
        off = (told - formula.value)[says]
        if formula.period:
            off = off - formula.period * np.round(off / formula.period)
        return _share(off, scale)

    def _rate_misfit(self, value: str, rate: str) -> float:
        """What the integrals of a rate over the panels miss of the changes, over the panels and the rates' size there;
        panels on which two quadratures don't agree say nothing."""
        count, panels = self.reports.count, self.lows.size
        if not np.isfinite(self.sampled(rate)[np.isfinite(self.sampled(value))]).all():
            return np.nan
        start, end = self.values[value][count : count + 2 * panels].reshape(2, panels)
        nodes = self._at_nodes(rate)
        once, *halves = (
            (row * panel_points(*ends)[1].reshape(panels, -1)).sum(axis=1)
            for row, ends in zip(nodes, self._quadratures, strict=True)
        )
        twice, width = sum(halves), self.highs - self.lows
        change = end - start
        if (period := self._period(value)) is not None:
            change = change - period * np.round((change - twice) / period)
        scale = self._scales_on_panels[self.signals[rate].dimension.physical]
        trusted = np.abs(twice - once) <= RESOLVED * scale * width
        size = np.maximum(np.maximum(np.abs(start), np.abs(end)), self.faint_scales[value] / FAINT)
        off = np.maximum(np.abs(change - twice) - ROUND_OFF * size / self._margins**2, 0.0) / width
        return _share((off / scale)[trusted], 1.0)

    def _at_nodes(self, name: str) -> Array:
        """A signal at the points of both quadratures: (panels and their halves, panels, points)."""
        return np.asarray(self.values[name][self.reports.count + 2 * self.lows.size :].reshape(3, self.lows.size, -1))

    @cached_property
    def _margins(self) -> Array:
        """The smallest margin to singularity on each panel: a velocity loses digits by it, an acceleration by its
        square."""
        t = np.array([self.lows, (self.lows + self.highs) / 2, self.highs])
        least = margins(self.run, t.ravel()).min(axis=0, initial=1.0).reshape(t.shape).min(axis=0)
        return np.asarray(np.maximum(least, LEAST_MARGIN))

    @cached_property
    def _scales_on_panels(self) -> dict[Dimension, Array]:
        """By dimension the largest rate on each panel, or the faint scale."""
        faint, found = self.faint_scales, dict[Dimension, Array]()
        for rate in self.rates:
            key, size = (
                self.signals[rate].dimension.physical,
                np.abs(self._at_nodes(rate)).max(axis=(0, 2), initial=0.0),
            )
            least = max(faint[rate], float(np.finfo(float).tiny))
            found[key] = np.fmax(np.fmax(size, least), found.get(key, least))
        return found

    def _period(self, name: str) -> float | None:
        """That of a signal whose values repeat."""
        signal = self.signals[name]
        if signal.attribute == "angle":
            return 2 * np.pi
        periods = (one.period for one in restated(self.reports, signal) if one.period)
        return next(periods, None)


def panels(run: Run) -> tuple[Array, Array]:
    """The ends of some stretches of a run (s), all over it, on which forces and laws are smooth."""
    bands = [passage.band for passage in run.compiled.passages.every]
    steps = np.linspace(run.start, run.stop, run.grid // STEPS + 2)
    edges = np.unique(np.clip(np.concatenate([steps, run.breaks, *bands]), run.start, run.stop))
    lows, highs = edges[:-1], edges[1:]
    wide = highs - lows > 1e-6 * (run.stop - run.start)
    # About a change point values are interpolated, to fewer digits than a rate can be held to.
    places = np.flatnonzero(wide & run.compiled.passages.outside((lows + highs) / 2))
    chosen = np.unique(places[(np.mod(GOLDEN * np.arange(1, PANELS + 1), 1.0) * places.size).astype(int)])
    aside = (highs - lows)[chosen] * INSIDE  # where something jumps at an end, that has the value of the other side
    return lows[chosen] + aside, highs[chosen] - aside


def _totals(signals: Signals) -> dict[str, Signal]:
    """The signals that are asked only by name: sums over the mechanism, and the power of each element that has one."""
    names = [f"energy.{total}" for total in TOTALS]
    for name, every in signals.powered.items():
        if len(every) == 1:
            names += [f"power({name}).{part}" for part in (POWER if every[0] is not None else ["supplied"])]
    trees = {name: parse(name) for name in names}
    return {name: signals.find(tree) for name, tree in trees.items() if isinstance(tree, Name | Call)}


def _share(off: Array, scale: float) -> float:
    """The largest of what is off, over a scale; of what should be zero and isn't, infinite."""
    worst = float(np.max(np.abs(off), initial=0.0))
    if scale == 0.0:
        return np.inf if worst else 0.0
    return worst / scale


def _large(misfit: float) -> float:
    """The order of misfits: what isn't a number is the largest."""
    return misfit if misfit == misfit else np.inf


def _unless_number(one: tuple[float, str]) -> float:
    return _large(one[0])
