"""Numbers in cells: signs, ranges that are opposite."""

from __future__ import annotations

import pytest

from linkwright.presentation.cells import NumberCell, Numbers


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (-0.25, 0.25, "±0.2500 deg"),
        (-0.25, 0.5, "-0.2500 .. +0.5000 deg"),
        (0.0, 0.0, "±0.0000 deg"),
        (-0.0, 0.0, "±0.0000 deg"),
        (None, None, "–"),
        (0.25, 0.25, "+0.2500 .. +0.2500 deg"),
    ],
)
def test_ranges(low: float | None, high: float | None, expected: str) -> None:
    cells = [NumberCell(value, 4, form="f", signed=True) for value in (low, high)]
    assert str(Numbers(cells, "deg" if low is not None else "")).replace("– .. –", "–") == expected


def test_no_minus_before_zero() -> None:
    assert str(NumberCell(-0.0, 5, "deg/mm")) == "0 deg/mm"
    assert str(NumberCell(0.0, 5, signed=True)) == "0"
