"""What a cycle gives."""

from __future__ import annotations

from dataclasses import dataclass, field

from linkwright.findings import Finding
from linkwright.measures import MeasureResult
from linkwright.results import Result


@dataclass
class CycleOutcome:
    """What a cycle gives: its result, the measures, and notes that don't stop it."""

    result: Result
    measures: list[MeasureResult] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    @property
    def failures(self) -> list[Finding]:
        """Why the run is not whole."""
        return self.result.failures

    @property
    def done(self) -> bool:
        """Whether the motion could be followed and every requirement is met."""
        return not self.failures and all(measure.verdict is not False for measure in self.measures)
