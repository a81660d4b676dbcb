"""What the machine has: packages that only some work needs, imported where it does; processors."""

from __future__ import annotations

import os
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
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


SHARE = 4
"""What is kept at once may take one part in so many of the memory that the process may use."""
_LIMITS = ("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes")
_UNKNOWN = 4 << 30
"""The memory (bytes) that is assumed where the system doesn't tell it."""


def memory() -> int:
    """The memory (bytes) that this process may use: that of the machine, of its container, or its own limit."""
    limits = [_physical_memory(), *map(_limit_in, _LIMITS), _own_limit()]
    return min((limit for limit in limits if limit), default=_UNKNOWN)


def memory_to_keep() -> int:
    """The share of it (bytes) that what a study keeps at once may take."""
    return memory() // SHARE


def _physical_memory() -> int | None:
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):  # not on Windows
        return None


def _limit_in(file: str) -> int | None:
    """The limit of a container, where there is one."""
    try:
        text = Path(file).read_text("ascii").strip()
    except OSError:
        return None
    return int(text) if text.isdigit() else None


def _own_limit() -> int | None:
    try:
        import resource
    except ImportError:  # not on Windows
        return None
    limit = resource.getrlimit(resource.RLIMIT_AS)[0]
    return None if limit == resource.RLIM_INFINITY else limit


def processors() -> int:
    """The processors that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
