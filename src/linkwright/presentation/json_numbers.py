"""Numbers as plain data: what JSON can hold."""

from __future__ import annotations

from math import isfinite

import numpy as np
from numpy.typing import NDArray


def known(value: float) -> float | None:
    """A number, where it is one."""
    return value if isfinite(value) else None


def listed(values: NDArray[np.float64]) -> list[float | None]:
    """An array as plain numbers."""
    return [known(value) for value in values.tolist()]
