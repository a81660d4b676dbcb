"""Axes of still charts: round numbers, gaps where there is no value."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest

from linkwright.drawing.charts import Axes, round_below, ticks, widened


@pytest.mark.parametrize(
    ("low", "high", "count", "expected"),
    [
        (0.0, 1.5, 6, [0.0, 0.5, 1.0, 1.5]),
        (-48.4, 669.6, 5, [0, 200, 400, 600]),
        (73.66, 73.89, 6, [73.7, 73.75, 73.8, 73.85]),
        (-1e-7, 1e-7, 4, [-1e-7, -5e-8, 0, 5e-8, 1e-7]),
    ],
)
def test_ticks_are_round_numbers(low: float, high: float, count: int, expected: list[float]) -> None:
    assert ticks(low, high, count) == pytest.approx(expected, abs=1e-12 * (high - low))


def test_a_range_of_one_value_lies_about_it() -> None:
    assert widened(1.0, 2.0) == (1, 2)
    for value in (0.0, 5.0, -3e6):
        low, high = widened(value, value)
        assert low < value < high and low + high == pytest.approx(2 * value)


@pytest.mark.parametrize(("value", "expected"), [(0.19, 0.1), (0.2, 0.2), (4.9e-3, 2e-3), (7.0, 5.0), (1e4, 1e4)])
def test_steps_are_round_and_not_above(value: float, expected: float) -> None:
    assert round_below(value) == pytest.approx(expected)


def test_lines_have_gaps() -> None:
    x, gap = np.arange(6.0), np.array([0, 1, np.nan, 3, 4, 5])
    axes = Axes((0.0, 5.0), (0.0, 5.0), "t <s>")
    assert axes.line(x, gap, "mean").count("<polyline") == 2
    root = ElementTree.fromstring(axes.drawing([axes.line(x, gap, "mean")], "B.x & C.x"))
    assert root.get("aria-label") == "B.x & C.x" and "t <s>" in [*root.itertext()]
