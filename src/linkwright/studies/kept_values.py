"""What studies keep at once, held against the share of the memory that it may take."""

from __future__ import annotations

from linkwright._machine import SHARE, memory_to_keep
from linkwright.findings import Finding

BYTES = 128
"""The memory (bytes) that a value of a table takes at most while it is computed, kept, and written as text."""
GIGABYTE = 1e9


def too_many(study: str, key: str, rows: int, columns: int) -> list[Finding]:
    """A finding where a table of so many rows and columns would take more than the share of the memory."""
    needed, allowed = rows * columns * BYTES, memory_to_keep()
    if needed <= allowed:
        return []
    data = {
        "rows": f"{rows:,}",
        "columns": f"{columns:,}",
        "needed": f"{needed / GIGABYTE:.2g}",
        "allowed": f"{allowed / GIGABYTE:.2g}",
        "share": SHARE,
        "key": key,
        "most": f"{max(allowed // (columns * BYTES), 0):,}",
    }
    return [Finding("study.too-many-values", ("studies", study, key), data)]
