"""What the limits study gives."""

from __future__ import annotations

from dataclasses import field

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.results import Result, Run
from linkwright.studies.limits.extremes import ModeChange, SignalCourse, Transmission
from linkwright.studies.limits.four_links import FourLinks
from linkwright.studies.limits.ranges import Range

DRAWN = 720
"""The most steps of a sweep that is drawn."""


@dataclass(frozen=True)
class RunLimits:
    """What a run comes to: its signals, dyads and change points."""

    run: Run
    courses: list[SignalCourse]
    transmission: list[Transmission]
    touches: list[ModeChange]


@dataclass(frozen=True)
class DriveLimits:
    """One drive moved alone from the start pose: its ranges, and what happens over each."""

    drive: str
    ranges: list[tuple[Range, RunLimits]]


@dataclass
class LimitsOutcome:
    """What the limits study gives; times of sweeps are drive values less ``Sweep.origin`` (rad or m)."""

    compiled: Compiled
    samples: int
    drives: list[DriveLimits] = field(default_factory=list)
    motion: RunLimits | None = None
    loops: list[FourLinks] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)
    failures: list[Finding] = field(default_factory=list)

    @property
    def done(self) -> bool:
        """Whether nothing went wrong. A range that ends is a result, no failure."""
        return not self.failures

    @property
    def result(self) -> Result | None:
        """The first sweep as arrays over the drive's value, for a drawing."""
        sweep = next((found.sweep for drive in self.drives for found, _ in drive.ranges), None)
        return None if sweep is None else Result(sweep.on(min(self.samples, DRAWN)))
