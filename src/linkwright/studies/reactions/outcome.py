"""The reactions of a structure that stands."""

from __future__ import annotations

from dataclasses import field

from linkwright.data_classes import dataclass
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding
from linkwright.kernels.still import Still
from linkwright.results import Result, Run


@dataclass(frozen=True)
class Reaction:
    """One component of what a link does to another, or to the pin where three or more meet.

    ``name`` is the signal's, ``force(frame, beam).x``; of a pin that is determined in one direction alone, the
    component in the ``direction`` (rad, against the frame's x axis). ``value`` (N, N m) is ``None`` where statics
    leaves it open.
    """

    name: str
    joint: str
    dimension: Dimension
    value: float | None
    direction: float | None = None


@dataclass(frozen=True)
class TwoForceLink:
    """A link that is pinned at two places and bears nothing else: its force (N), positive in tension."""

    link: str
    force: float | None


@dataclass
class ReactionsOutcome:
    """What the study gives.

    ``states`` is the number of states of self-stress, the degree of static indeterminacy, ``motions`` how many motions
    the joints leave; ``closure`` and ``equilibrium`` are the residuals of the checks, over the size and over the
    largest force.
    """

    compiled: Still
    time: float = 0.0
    reactions: list[Reaction] = field(default_factory=list)
    bars: list[TwoForceLink] = field(default_factory=list)
    states: int = 0
    motions: int = 0
    closure: float = 0.0
    equilibrium: float = 0.0
    failures: list[Finding] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    @property
    def done(self) -> bool:
        """Whether it stands."""
        return not self.failures

    @property
    def result(self) -> Result:
        """The pose, for a drawing."""
        return Result(Run(self.compiled, self.time, self.time, 0))
