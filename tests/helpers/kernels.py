"""The kernels that tests run over, and what each can afford: a compiled one compiles for every program."""

from __future__ import annotations

from typing import Any

import pytest

from linkwright.kernels import KERNELS

UNCOMPILED = ("numpy",)


def every() -> list[Any]:
    """The names of all kernels as parameters; those whose packages aren't installed are skipped."""
    found = []
    for name, kernel in sorted(KERNELS.items()):
        missing = pytest.mark.skipif(not kernel.available(), reason=f"a package that {name} needs is missing")
        found.append(pytest.param(name, marks=missing))
    return found


def examples(kernel: str) -> int:
    """How many random programs a kernel is tried on."""
    return 30 if kernel in UNCOMPILED else 2
