"""What a sweep gives: bands of signals, statistics of measures, a table of the samples, shares that meet the limits."""

from __future__ import annotations

from dataclasses import field
from functools import cached_property
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from linkwright.blocks.work import Arrays
from linkwright.data_classes import dataclass
from linkwright.expressions.language import parse
from linkwright.expressions.units import TIME, Dimension
from linkwright.findings import Finding, Term
from linkwright.kernels import Compiled
from linkwright.results import Result, Run
from linkwright.results.dataset import Dataset, Variable, described, times, variable_of
from linkwright.studies.figures import FigureColumn
from linkwright.studies.plans import Plan
from linkwright.studies.shares import Share
from linkwright.studies.sweep.options import SweepOptions

Array = NDArray[np.float64]

BANDS = ("mean", "deviation", "least", "largest")
"""The values of a band in files, by their attributes."""


@dataclass(frozen=True)
class Band:
    """A signal over all samples at each pose: arrays (poses,) in SI, NaN where no sample has a value.

    ``deviation`` is that of the sample (n - 1), ``count`` how many samples have a value.
    """

    signal: str
    dimension: Dimension
    mean: Array
    deviation: Array
    least: Array
    largest: Array
    count: NDArray[np.int64]
    least_at: NDArray[np.int64]
    largest_at: NDArray[np.int64]


@dataclass(frozen=True)
class Statistics:
    """A figure of a measure over all samples, in SI; ``count`` of them have it. ``least_at`` and ``largest_at`` are the
    samples with the extremes, -1 for none; ``counts`` those between the ``edges`` of the histogram, ``under`` and
    ``over`` those beyond."""

    column: FigureColumn
    count: int
    mean: float
    deviation: float
    least: float
    largest: float
    least_at: int
    largest_at: int
    edges: Array
    counts: NDArray[np.int64]
    under: int = 0
    over: int = 0


@dataclass(frozen=True)
class SampleTable:
    """A column a sample: the varied ``parameters`` (names, samples), ``figures`` (figures, samples) and whether
    requirements are ``met`` (requirements, samples), in SI. Samples that have ``failed`` (samples,) lack a value,
    ``since`` (samples,) some time (s), NaN where that isn't known."""

    parameters: Array
    figures: Array
    met: NDArray[np.bool_]
    failed: NDArray[np.bool_]
    since: Array


@dataclass
class SweepOutcome:
    """A sweep's figures. Samples count from 0; ``run`` is the motion with the nominal parameters.

    ``table`` is ``None`` where there are too many samples to keep a row of each. ``values`` (signals, samples, poses)
    are all values where they are kept and no folder takes them, ``store`` is the name of the Zarr store that has them
    else. ``poses`` were computed in ``seconds`` this time; ``state`` are files from which the same sweep would go on.
    """

    compiled: Compiled
    options: SweepOptions
    plan: Plan
    run: Run
    kernel: str
    why: Term
    bands: dict[str, Band] = field(default_factory=dict)
    measures: list[Statistics] = field(default_factory=list)
    shares: dict[str, Share] = field(default_factory=dict)
    table: SampleTable | None = None
    values: Array | None = None
    failed: int = 0
    poses: int = 0
    seconds: float = 0.0
    store: str | None = None
    state: tuple[Path, ...] = ()
    failures: list[Finding] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    @property
    def result(self) -> Result:
        """The nominal motion, for a drawing."""
        return Result(self.run)

    @property
    def t(self) -> Array:
        """The times (s) of the bands: (poses,)."""
        return self.run.t

    def settle(self) -> None:
        """Remove the files of the state: all that came out is written."""
        for path in self.state:
            path.unlink(missing_ok=True)

    @property
    def samples(self) -> int:
        """How many samples there are."""
        return self.plan.samples

    @property
    def performed(self) -> bool:
        """Whether samples were computed at all; where they weren't, ``failures`` says why."""
        return bool(self.bands or self.measures)

    @property
    def names(self) -> tuple[str, ...]:
        """The varied parameters."""
        return tuple(self.options.vary)

    @property
    def files(self) -> list[str]:
        """The files that the outcome fills in a folder."""
        there = {"sweep.csv": self.table is not None, "sweep_bands.csv": bool(self.bands), "sweep.zarr": self.store}
        return [name for name, here in there.items() if here]

    @cached_property
    def dataset(self) -> Dataset:
        """The numbers for files. Over ``sample``, where rows are kept: its number, the varied parameters, the measures'
        figures, whether each requirement is met, whether the sample lacks a value and since when. Over ``time``: of
        each signal mean, deviation, least and largest value and how many samples have one."""
        quantities, table = self.compiled.quantities, self.table
        made: list[Variable] = []
        if table is not None:
            made.append(Variable("sample", "sample", np.arange(self.samples)))
            for name, values in zip(self.names, table.parameters, strict=True):
                made.append(variable_of(quantities, name, "sample", values, quantities.dimensions.of(name)))
            for measure, values in zip(self.measures, table.figures, strict=True):
                made.append(measure.column.variable(values))
            made += [Variable(f"{name} met", "sample", met) for name, met in zip(self.shares, table.met, strict=True)]
            made.append(Variable("failed", "sample", table.failed))
            made.append(variable_of(quantities, "since", "sample", table.since, TIME))
        if self.bands:
            made.append(times(quantities, self.t))
        for text, band in self.bands.items():
            for kind in BANDS:
                made.append(variable_of(quantities, f"{text} {kind}", "time", getattr(band, kind), band.dimension))
            made.append(Variable(f"{text} count", "time", band.count))
        facts = described(self.compiled, (*self.failures, *self.warnings))
        facts |= {"plan": self.plan.name, "seed": str(self.options.seed), "kernel": self.kernel}
        return Dataset(made, facts)

    @property
    def done(self) -> bool:
        """Whether a sample has values. A requirement that some samples miss is a result, no failure."""
        return not self.failures


def bands(texts: list[str], compiled: Compiled, moments: Arrays) -> dict[str, Band]:
    """The bands of signals from their moments (signals, poses)."""
    keys = (*BANDS, "count", "least_at", "largest_at")
    quantities = compiled.quantities
    return {
        text: Band(text, quantities.dimensions.dimension(parse(text)), *(moments[key][i] for key in keys))
        for i, text in enumerate(texts)
    }
