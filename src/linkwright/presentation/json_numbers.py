"""Numbers as plain data: what JSON can hold."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite

import numpy as np
from numpy.typing import NDArray


def known(value: float) -> float | None:
    """A number, where it is one."""
    return value if isfinite(value) else None


def finite(data: object) -> object:
    """Plain data in which ``null`` stands for each number that JSON can't hold."""
    if isinstance(data, float):
        return known(data)
    if isinstance(data, Mapping):
        return {key: finite(value) for key, value in data.items()}
    if isinstance(data, list | tuple):
        return [finite(value) for value in data]
    return data


def listed(values: NDArray[np.float64]) -> list[float | None]:
    """An array as plain numbers."""
    return [known(value) for value in values.tolist()]
