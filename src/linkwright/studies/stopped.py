"""An interrupted study that keeps what it has done."""

from __future__ import annotations

from typing import Any


class Stopped(KeyboardInterrupt):
    """A study was interrupted; ``outcome`` holds what of it is done, ``what`` says how far it came."""

    def __init__(self, outcome: Any, what: str) -> None:
        super().__init__(what)
        self.outcome, self.what = outcome, what
