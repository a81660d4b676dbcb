"""What the machine has: packages that only some work needs, imported where it does; processors."""

from __future__ import annotations

import os
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from linkwright.findings import Finding, ModelError


def needed(package: str, extra: str) -> Any:
    """The package. Raises :class:`~linkwright.findings.ModelError`, with the extra that brings it, for none, and
    for one that can't be loaded."""
    try:
        return import_module(package)
    except ImportError:
        raise ModelError([Finding("file.needs-package", (), {"package": package, "extra": extra})]) from None
    except RuntimeError as error:  # some look for the user's home, which there may not be
        raise ModelError([Finding("file.package-fails", (), {"package": package, "reason": str(error)})]) from None


def installed(package: str) -> bool:
    """Whether there is a package; it isn't loaded for that."""
    return find_spec(package) is not None


def processors() -> int:
    """The processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
