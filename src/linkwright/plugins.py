"""Kinds of things that other packages bring: modules that register them, named by entry points."""

from __future__ import annotations

from functools import cache

GROUPS = {"elements": "linkwright.elements", "studies": "linkwright.studies", "measures": "linkwright.measures"}
"""The groups of entry points by what their modules register."""


@cache
def load(kinds: str) -> None:
    """Load the modules by which other packages make such kinds known, once."""
    from importlib.metadata import entry_points

    for point in sorted(entry_points(group=GROUPS[kinds]), key=lambda point: point.name):
        point.load()


@cache
def named(kinds: str) -> bool:
    """Whether other packages bring such kinds."""
    from importlib.metadata import entry_points

    return bool(entry_points(group=GROUPS[kinds]))
