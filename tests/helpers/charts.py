"""What charts show, for tests: their content by title, and their data read back as a page's script does."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from linkwright.presentation.blocks import Chart, Charts
from linkwright.presentation.chart_data import LETTERS, STEPS
from linkwright.presentation.charts import Graph, Plane

Array = NDArray[np.float64]
Kind = TypeVar("Kind")


def titled(charts: Iterable[Chart | Charts]) -> dict[str, Any]:
    """The contents of charts by their titles."""
    every = [one for each in charts for one in (each.charts if isinstance(each, Charts) else [each])]
    return {str(chart.title): chart.content for chart in every if chart.content is not None}


def graph(content: Any) -> Graph:
    assert isinstance(content, Graph)
    return content


def plane(content: Any) -> Plane:
    assert isinstance(content, Plane)
    return content


def only(kind: type[Kind], parts: Iterable[object]) -> Kind:
    """The only part of a kind."""
    (found,) = (part for part in parts if isinstance(part, kind))
    return found


def values(data: Any) -> Array:
    """Numbers as they are in a page: listed, or by their ends."""
    if isinstance(data, dict):
        return np.linspace(data["from"], data["to"], data["count"])
    return np.array([np.nan if value is None else value for value in data], dtype=float)


def line(path: str, fine: float) -> Array:
    """A line of a page: (2, n)."""
    steps, number, size = [], 0, 1
    for letter in path:
        digit = LETTERS.index(letter)
        number, size = number + digit % 32 * size, size * 32
        if digit < 32:
            steps.append(-(number + 1) // 2 if number % 2 else number // 2)
            number, size = 0, 1
    return np.cumsum(np.array(steps).reshape(-1, 2), axis=0).T * fine


def unpacked(data: dict[str, Any]) -> Array:
    """The values of a coarse field."""
    numbers = np.array([LETTERS.index(letter) for letter in data["packed"]]).reshape(-1, 2) @ [64, 1]
    share, low, high = (numbers - 1) / STEPS, data["low"], data["high"]
    found = low * (high / low) ** share if data["ratios"] else low + share * (high - low)
    return np.where(numbers == 0, np.nan, found)
