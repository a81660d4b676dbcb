"""Cost laws: their numbers in the parameter's own unit, their slopes, the hull of processes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError

from linkwright.studies.accuracy.costs import COSTS, AnyCost, Cost, Stepped

MM = 1e-3
LAWS: dict[str, tuple[Any, float, float]] = {  # numbers, a half-width in mm, the cost there
    "reciprocal": ([1, 2], 0.05, 41.0),
    "reciprocal_squared": (0.01, 0.05, 4.0),
    "exponential": ([3, 8, 0.1], 0.05, 3 + 8 * np.exp(-0.5)),
    "table": ([[0.1, 3], [0.02, 9]], 0.05, 9.0),
}


def read(raw: Any) -> Cost:
    cost: Cost = TypeAdapter(AnyCost).validate_python(raw)
    return cost


@pytest.mark.parametrize("name", COSTS)
def test_numbers_are_for_half_widths_in_the_parameters_unit(name: str) -> None:
    numbers, half, cost = LAWS[name]
    law = read({name: numbers}).law(MM, lambda grade: None)
    assert law.cost(half * MM) == pytest.approx(cost, rel=1e-14)
    finer, coarser = law.cost(half * MM * 0.999), law.cost(half * MM * 1.001)
    assert finer >= law.cost(half * MM) >= coarser
    if name != "table":
        slope = law.slopes(half * MM)[0]
        assert slope == pytest.approx((coarser - finer) / (0.002 * half * MM), rel=1e-5)


def test_the_hull_of_processes_is_the_largest_convex_law_below_them() -> None:
    halves, costs = np.array([1.0, 2, 3, 5, 6, 8]), np.array([10.0, 9, 4, 3.5, 3.6, 1])
    law = Stepped(halves, costs, tuple("abcdef"))
    assert law.corners.tolist() == [1, 3, 8]
    intercepts, slopes = law.pieces
    hull = (intercepts[:, None] + slopes[:, None] * halves).max(axis=0)
    assert (hull <= costs + 1e-12).all()
    assert law.slopes(2.0) == (-3.0, -3.0)
    assert law.slopes(3.0) == (-3.0, pytest.approx(-0.6))
    assert law.slopes(1.0) == (-np.inf, -3.0)
    assert law.slopes(8.0) == (pytest.approx(-0.6), 0.0)
    assert law.slopes(9.0) == (0.0, 0.0)
    assert law.cost(0.5) == np.inf


@pytest.mark.parametrize(
    ("raw", "code"),
    [
        ({"reciprocal": 0}, "accuracy.cost"),
        ({"reciprocal": [-1, 2]}, "accuracy.cost"),
        ({"reciprocal": [1, 2, 3]}, "file.expected"),
        ({"reciprocal": float("nan")}, "file.not-finite"),
        ({"reciprocal": "dear"}, "file.expected"),
        ({"exponential": 3}, "file.expected"),
        ({"table": {"IT20": 3}}, "file.expected"),
        ({"table": {}}, "file.expected"),
        ({"table": [[0.1]]}, "file.expected"),
        ({"table": [[0, 1]]}, "accuracy.cost"),
        ({"linear": 2}, "file.expected"),
        (7, "file.expected"),
    ],
)
def test_wrong_laws_are_told(raw: Any, code: str) -> None:
    with pytest.raises(ValidationError) as caught:
        read(raw)
    (error,) = caught.value.errors()
    assert error["ctx"]["code"] == code
