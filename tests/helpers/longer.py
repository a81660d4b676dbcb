"""Cases of which some are tested in every run, and all before a release (``python3 dev.py test -m long``)."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import pytest

Case = TypeVar("Case")


def mostly_long(cases: Iterable[Case], usual: Callable[[Case], bool]) -> list[Any]:
    """All cases as parameters; those that aren't ``usual`` are long."""
    return [case if usual(case) else pytest.param(case, marks=pytest.mark.long) for case in cases]
