"""JSON for the page's scripts, with short numbers."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence

from linkwright.data_classes import dataclass
from linkwright.escape import script
from linkwright.findings import Said

DIGITS = 7
"""Significant digits of a number in the page: finer than any screen or print resolves."""


def compact(value: object) -> object:
    """Copy plain data with its floats rounded to ``DIGITS`` significant digits, not-a-numbers as None, and texts of the
    catalogue in words."""
    if isinstance(value, Said):
        return str(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            return None
        rounded = float(f"{value:.{DIGITS}g}")
        return int(rounded) if rounded.is_integer() and abs(rounded) < 10**DIGITS else rounded
    if isinstance(value, Mapping):
        return {str(key): compact(entry) for key, entry in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [compact(entry) for entry in value]
    return value


@dataclass(frozen=True)
class Exact:
    """Plain data whose numbers keep all their digits."""

    value: object


def script_json(value: object) -> str:
    """JSON text that is safe inside a script element."""
    plain = _worded(value.value) if isinstance(value, Exact) else compact(value)
    return script(json.dumps(plain, ensure_ascii=False, allow_nan=False, separators=(",", ":")))


def _worded(value: object) -> object:
    """Plain data with its texts in words."""
    if isinstance(value, Said):
        return str(value)
    if isinstance(value, Mapping):
        return {str(key): _worded(entry) for key, entry in value.items()}
    if isinstance(value, Sequence) and not isinstance(value, str):
        return [_worded(entry) for entry in value]
    return value


def data_block(name: str, value: object) -> str:
    """Data as an element of a page by its id: text for the page's scripts, no script itself."""
    return f'<script type="application/json" id="{name}">{script_json(value)}</script>'
