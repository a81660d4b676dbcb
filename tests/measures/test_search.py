"""The search for turning points: complete where it settles, bounded where a function turns too often for it."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from linkwright.measures import search
from linkwright.measures.search import MANY, RunPieces, turning

Array = NDArray[np.float64]

NONE = np.empty(0)
ALL = RunPieces(0.0, 1.0, NONE, NONE, NONE)


def waves(*rates: float) -> search.Rates:
    """Sines of so many rad/s, the amplitude of each growing with time."""

    def look(t: Array) -> tuple[Array, Array]:
        w = np.array(rates)[:, None]
        sine, cosine, size = np.sin(w * t), np.cos(w * t), 1 + t
        return size * sine, sine + size * w * cosine

    return look


def test_a_row_that_never_settles_is_bounded_and_the_others_are_complete() -> None:
    found = turning(waves(20.0, 6e4), [ALL, ALL], 64)
    assert found.settled == [True, False]
    assert found.times[0].size == 6  # maxima and minima of sin(20 t) in 0 .. 1
    assert found.times[1].size == MANY
    assert (np.diff(found.times[1]) > 0).all()


def test_of_too_many_the_highest_and_the_lowest_are_located(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a bound of 8 on some 20 000 turns the values found are those of the end of the run, the largest."""
    monkeypatch.setattr(search, "MANY", 8)
    rates = waves(6e4)
    found = turning(rates, [ALL], 64)
    assert not found.settled[0]
    values = rates(found.times[0])[0][0]
    assert found.times[0].size == 8
    assert values.max() == pytest.approx(2.0, abs=2e-3)
    assert values.min() == pytest.approx(-2.0, abs=2e-3)
