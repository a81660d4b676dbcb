"""What the pages docs/zh/papers show of the five papers on which linkwright is founded: one module a page.

Each has ``tables()``: of every marked table of its page the last cells of each row, as texts. A bound such as
``< 1e-9`` is only returned where it holds.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import linkwright as lw

Array = NDArray[np.float64]
Rows = list[list[str]]
Tables = dict[str, Rows]

GALLERY = Path(lw.__file__).parent / "gallery"


def percent(value: float, printed: float) -> str:
    """The deviation of a value from the printed one, as a share of it."""
    share = round(100 * (value / printed - 1), 2)
    return f"{share:+.2f} %" if share else "0.00 %"


def below(value: Any, bound: float, unit: str = "") -> str:
    """A bound of a deviation that is nothing but round-off; ``value`` may be an array of deviations."""
    assert np.abs(value).max() < bound, (np.abs(value).max(), bound)
    return f"< {bound:.0e} {unit}".rstrip().replace("e-0", "e-")


def inputs(name: str, printed: dict[str, float | str]) -> Rows:
    """Parameters of a model of the gallery, in the units of its file, beside those of the paper."""
    found = lw.load(GALLERY / f"{name}.yaml").model_dump(by_alias=True, exclude_none=True, mode="json")["parameters"]
    assert {key: found[key]["value"] for key in printed} == printed
    texts = {key: value if isinstance(value, str) else f"{value:g}" for key, value in printed.items()}
    return [[text.replace(" deg", "°"), f"`{key}: {text}`"] for key, text in texts.items()]
