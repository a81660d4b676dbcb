"""What is said of a text that is no unit."""

from __future__ import annotations

from typing import Any

from linkwright.findings import Term


def unknown_unit(text: str, error: Exception) -> dict[str, Any]:
    """The data of a finding on a text that is no unit, as ``error`` says: with the unit that is meant, where that is
    found."""
    from linkwright.expressions.respelled import unit_respelled

    meant = unit_respelled(text.strip())
    hint = Term("usual-units") if meant is None else Term("write", text=meant)
    return {"word": str(error)[:40], "hint": hint}
