"""Changes of sign of rows on a grid, against a plain search of each row."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from linkwright.results.stationary import NOISE, changes

Array = NDArray[np.float64]


def plain(row: Array) -> list[tuple[int, int]]:
    """Pairs of clear places of opposite sign with nothing clear between them."""
    finite = np.abs(row[np.isfinite(row)])
    floor = NOISE * (finite.max() if finite.size else 0.0)
    clear = [i for i, f in enumerate(row) if abs(f) > floor]
    return [(i, j) for i, j in pairwise(clear) if np.sign(row[i]) != np.sign(row[j])]


NUMBERS = st.sampled_from([-2.0, -1.0, -1e-12, 0.0, 1e-12, 1.0, 3.0, np.nan, np.inf, -np.inf])


@given(st.lists(st.lists(NUMBERS, min_size=7, max_size=7), min_size=1, max_size=5))
def test_changes_of_sign(rows: list[list[float]]) -> None:
    f = np.array(rows)
    found = changes(f)
    expected = [(who, *pair) for who, row in enumerate(f) for pair in plain(row)]
    assert list(zip(found.who, found.before, found.after, strict=True)) == expected


def test_rows_that_do_not_count() -> None:
    f = np.array([[1.0, -1.0], [1.0, -1.0]])
    assert changes(f, np.array([False, True])).who.tolist() == [1]
