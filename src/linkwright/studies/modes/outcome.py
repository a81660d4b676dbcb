"""Assembly modes at a time, with their circuits."""

from __future__ import annotations

from dataclasses import field
from typing import ClassVar

from linkwright.data_classes import dataclass
from linkwright.findings import Finding
from linkwright.graph.mode_survey import Circuit, Survey
from linkwright.graph.modes import Mode
from linkwright.model.quantities import Quantities


@dataclass
class ModesOutcome:
    """The modes at a time (s), their circuits, and which of them is the file's own (``None`` where it says none)."""

    quantities: Quantities
    survey: Survey
    time: float
    values: dict[str, float]
    own: int | None = None
    failures: list[Finding] = field(default_factory=list)
    warnings: list[Finding] = field(default_factory=list)

    result: ClassVar[None] = None

    @property
    def done(self) -> bool:
        """Whether there is a mode."""
        return bool(self.modes)

    @property
    def modes(self) -> list[Mode]:
        """The assembly modes."""
        return self.survey.modes

    @property
    def circuits(self) -> list[Circuit]:
        """The circuits on which they lie."""
        return self.survey.circuits

    @property
    def complete(self) -> bool:
        """Whether no mode can be missing."""
        return self.survey.complete
