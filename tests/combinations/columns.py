"""All columns of the matrix: those of studies, of forms of drives, and others, in this order."""

from __future__ import annotations

from combinations import drives, others, studies
from combinations.motions import COLUMNS

__all__ = ["COLUMNS", "drives", "others", "studies"]
