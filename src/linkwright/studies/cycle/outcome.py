"""What a cycle gives."""

from __future__ import annotations

from dataclasses import field
from functools import cached_property
from typing import TYPE_CHECKING

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.measures import MeasureResult
from linkwright.results import Result

if TYPE_CHECKING:
    from linkwright.blocks import Progress
    from linkwright.studies.cycle.overview import Overview


@dataclass
class CycleOutcome:
    """What a cycle gives: its result, the measures, and notes that don't stop it."""

    result: Result
    measures: list[MeasureResult] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)
    progress: Progress | None = field(default=None, repr=False, compare=False)
    """Is told how far the overview is, which is computed when it is first asked for."""

    @cached_property
    def overview(self) -> Overview | None:
        """What the run comes to, where the file has no measures and the motion could be followed."""
        certificate = self.result.certificate
        if self.measures or self.failures or certificate is None:
            return None
        from linkwright.studies.cycle.overview import overview

        return overview(self.result.run, certificate.equilibrium is not None, self.progress)

    @property
    def failures(self) -> list[Finding]:
        """Why the run is not whole."""
        return self.result.failures

    @property
    def done(self) -> bool:
        """Whether the motion could be followed and every requirement is met."""
        return not self.failures and all(measure.verdict is not False for measure in self.measures)
