"""An interrupted study that keeps what it has done."""

from __future__ import annotations

from typing import Any

from linkwright.findings import Finding


class Stopped(KeyboardInterrupt):
    """A study was interrupted; ``outcome`` holds what of it is done, ``finding`` says how far it came."""

    def __init__(self, outcome: Any, finding: Finding) -> None:
        super().__init__(outcome, finding)
        self.outcome, self.finding = outcome, finding

    @property
    def what(self) -> str:
        """How far it came, in words."""
        return self.finding.what

    def __str__(self) -> str:
        return self.what
