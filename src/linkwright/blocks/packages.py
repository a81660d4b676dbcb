"""Packages that only some work needs: imported where it does."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from linkwright.model.findings import Finding, ModelError


def needed(package: str, extra: str) -> Any:
    """The package. Raises :class:`~linkwright.model.findings.ModelError`, with the extra that brings it, for none."""
    try:
        return import_module(package)
    except ImportError:
        raise ModelError([Finding("file.needs-package", (), {"package": package, "extra": extra})]) from None
