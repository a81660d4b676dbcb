"""What the accuracy study gives, in SI."""

from __future__ import annotations

from dataclasses import field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, Text
from linkwright.kernels import Compiled
from linkwright.results import Result, Run
from linkwright.results.dataset import Dataset, Variable, described, si_unit, times
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.figures import FigureColumn, per

if TYPE_CHECKING:
    from linkwright.studies.accuracy.options import AccuracyOptions

Array = NDArray[np.float64]


@dataclass(frozen=True)
class SearchedWorstCase:
    """The worst case found by evaluating the mechanism itself: deviations of the figure from the nominal one.

    ``low_at`` and ``high_at`` (contributors,) are the deviations at which it was found; ``off`` is how far the linear
    one is away, over its width. ``proven`` where it can't be exceeded, else it is a lower bound. ``lost`` of the
    ``looked`` mechanisms that were evaluated can't be assembled or followed.
    """

    low: float
    high: float
    low_at: Array
    high_at: Array
    off: float
    proven: bool
    looked: int = 0
    lost: int = 0


@dataclass(frozen=True)
class MonteCarlo:
    """A figure over random samples. ``interval`` holds ``coverage`` of the samples; ``mean_interval`` and
    ``sigma_interval`` hold mean and standard deviation of all that might be made, with ``confidence``; ``None`` where
    the plan (Sobol' points) or too few samples allow no such statement.

    ``convergence`` has rows (samples, mean, sigma) as the number of samples grows. ``edges`` and ``counts`` are the
    histogram. ``failed`` samples have no such figure: they are in nothing else here.
    """

    samples: int
    failed: int
    mean: float
    sigma: float
    least: float
    largest: float
    interval: tuple[float, float]
    mean_interval: tuple[float, float] | None
    sigma_interval: tuple[float, float] | None
    convergence: Array
    edges: Array
    counts: NDArray[np.int64]
    coverage: float = 0.9973
    confidence: float = 0.95


@dataclass(frozen=True)
class PlayEffect:
    """What the clearances do to a figure: ``shift`` with each joint resting where its reaction presses it, ``bound``
    (half width) over all directions of all joints; both by joint in ``shifts`` and ``bounds``."""

    shift: float
    bound: float
    shifts: dict[str, float]
    bounds: dict[str, float]


@dataclass
class OutputDeviations:
    """One figure and what deviations do to it.

    ``coefficients`` (contributors, 2) are its derivatives by each deviation, below and above the nominal value; they
    differ only in a ``tie``, where two places have the same extreme value. ``time`` (s) is where it happens, ``None``
    where it has no single place.
    ``worst`` are the least and largest deviation of the figure, linear; ``mean`` and ``sigma`` its linear mean
    deviation and standard deviation (RSS); ``shares`` (contributors,) are those of each in sigma squared. A change
    below ``round_off`` is what computing leaves of none.
    """

    column: FigureColumn
    nominal: float
    time: float | None
    coefficients: Array
    tie: bool = False
    worst: tuple[float, float] = (0.0, 0.0)
    mean: float = 0.0
    sigma: float = 0.0
    shares: Array = field(default_factory=lambda: np.empty(0))
    searched: SearchedWorstCase | None = None
    monte_carlo: MonteCarlo | None = None
    play: PlayEffect | None = None
    round_off: float = 0.0

    def cleared(self, values: Array) -> Array:
        """Values of the figure, those that are the nominal one but for round-off as that."""
        return np.where(np.abs(values - self.nominal) < self.round_off, self.nominal, values)

    def with_samples(self, found: MonteCarlo | None) -> MonteCarlo | None:
        """What random samples gave of the figure; where they only vary by round-off, they don't vary."""
        if found is None or max(abs(found.least - self.nominal), abs(found.largest - self.nominal)) >= self.round_off:
            return found
        both, known = (self.nominal, self.nominal), found.mean_interval is not None
        return replace(
            found,
            mean=self.nominal,
            sigma=0.0,
            least=self.nominal,
            largest=self.nominal,
            interval=both,
            mean_interval=both if known else None,
            sigma_interval=(0.0, 0.0) if known else None,
        )

    @property
    def name(self) -> str:
        """How files call it."""
        return self.column.name

    @property
    def title(self) -> Text:
        """How it is called where it is shown."""
        return self.column.title

    @property
    def half(self) -> float:
        """Half the width of the linear worst case."""
        return (self.worst[1] - self.worst[0]) / 2


@dataclass
class SignalDeviations:
    """A signal over the run: ``nominal`` (poses,), ``coefficients`` (contributors, poses), the linear worst case
    ``worst`` (2, poses), ``mean`` and ``sigma`` (poses,) of the deviation; all deviations from the nominal value.

    ``sampled`` are mean deviation and standard deviation over the random samples, least and largest deviation, and how
    many have a value: (5, poses). ``play`` (2, poses) are shift and bound by the clearances. ``widest`` is the index of
    the pose with the widest worst case, ``figure`` the figure there, ``positions`` those at the named positions.
    """

    text: str
    dimension: Dimension
    unit: str
    size: float
    t: Array
    nominal: Array
    coefficients: Array
    worst: Array
    mean: Array
    sigma: Array
    widest: int
    figure: OutputDeviations = field(init=False)
    positions: dict[str, OutputDeviations] = field(default_factory=dict)
    sampled: Array | None = None
    play: Array | None = None

    @property
    def rows(self) -> dict[str, Array]:
        """What is known of it at each pose, by its name in tables."""
        rows = {"nominal": self.nominal, "worst low": self.worst[0], "worst high": self.worst[1]}
        rows |= {"mean": self.mean, "sigma": self.sigma}
        if self.sampled is not None:
            names = ("sampled mean", "sampled sigma", "sampled least", "sampled largest")
            rows |= dict(zip(names, self.sampled, strict=False))
        if self.play is not None:
            rows |= {"play shift": self.play[0], "play bound": self.play[1]}
        return rows


@dataclass(frozen=True)
class JointPlay:
    """A joint with clearance over the run: magnitude of its ``reaction`` (N) at each pose ``t`` (s), displacement
    ``shift`` (2, poses) of the second link from the first in the frame (m) (of a guide: normal offset (m) and tilt
    (rad); of a flank that along its normal (m) alone, (1, poses)), and the spans of time in which contact may be
    ``lost``, each with its cause (a key of the words)."""

    joint: str
    links: tuple[str, str]
    clearance: float
    t: Array
    reaction: Array
    shift: Array
    lost: tuple[tuple[float, float, str], ...] = ()


@dataclass
class AccuracyOutcome:
    """The accuracy of a mechanism: ``figures`` of measures by name, ``curves`` of signals by their text."""

    compiled: Compiled
    options: AccuracyOptions
    run: Run
    contributors: Contributors
    figures: dict[str, OutputDeviations] = field(default_factory=dict)
    curves: dict[str, SignalDeviations] = field(default_factory=dict)
    joints: list[JointPlay] = field(default_factory=list)
    allocation: Any = None
    calibration: Any = None
    kernel: str = ""
    samples: int = 0
    failed: int = 0
    state: tuple[Path, ...] = ()
    failures: list[Finding] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    @property
    def done(self) -> bool:
        """Whether the nominal motion could be followed."""
        return not self.failures

    @property
    def result(self) -> Result:
        """The nominal motion, for a drawing."""
        return Result(self.run)

    @property
    def every(self) -> dict[str, OutputDeviations]:
        """All figures by name: those of measures, those of signals at the widest pose, those at named positions."""
        found = dict(self.figures)
        for text, curve in self.curves.items():
            found[text] = curve.figure
            found |= {figure.name: figure for figure in curve.positions.values()}
        return found

    @cached_property
    def dataset(self) -> Dataset:
        """The numbers for files. Over ``time``: of each signal the nominal value, deviations from it (worst case, mean
        and standard deviation of RSS, those of the samples, shift and bound by clearances), and each coefficient. Over
        ``contributor``, whose names are among the facts: coefficients (above the nominal value) and shares of all
        outputs."""
        every = self.contributors.every
        made = [times(self.compiled.quantities, self.run.t)] if self.curves else []
        for curve in self.curves.values():
            si = si_unit(curve.dimension)
            for name, values in curve.rows.items():
                made.append(Variable(f"{curve.text} {name}", "time", values, curve.unit, curve.size, si))
            if curve.sampled is not None:
                made.append(Variable(f"{curve.text} count", "time", curve.sampled[-1].astype(np.int64)))
            for one, values in zip(every, curve.coefficients, strict=True):
                units = (per(curve.unit, one.unit), curve.size / one.size, per(si, si_unit(one.dimension)))
                made.append(Variable(f"d({curve.text})/d({one.name})", "time", values, *units))
        for name, figure in self.every.items() if every else ():
            made.append(Variable(f"{name}: coefficients", "contributor", figure.coefficients[:, 1], si=None))
            made.append(Variable(f"{name}: shares", "contributor", figure.shares))
        facts = described(self.compiled, (*self.failures, *self.warnings))
        facts |= {"contributors": "\n".join(one.name for one in every), "kernel": self.kernel or "none"}
        return Dataset(made, facts)

    def settle(self) -> None:
        """Remove the files from which an interrupted study goes on: all that came out is written."""
        for path in self.state:
            path.unlink(missing_ok=True)
