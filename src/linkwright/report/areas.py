"""The unit of areas, as the tables of the report have it."""

from __future__ import annotations


def square(unit: str) -> str:
    """The unit of areas where lengths have a unit; nothing where they have none."""
    return f"{unit}\N{SUPERSCRIPT TWO}" if unit else ""
