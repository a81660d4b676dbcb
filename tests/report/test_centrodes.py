"""The centrodes that a report draws: which links have some, and where they are cut."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from linkwright.report.centrodes import _cut, centrodes
from studies.models import cycle_of, four_bar, slider_crank, trammel


def drawn(data: Any) -> dict[str, np.ndarray]:
    """x, y, u, v by link, in mm: (4, poses), NaN where nothing is drawn."""
    found = centrodes(cycle_of(data).result, 1e-3)
    return {c["link"]: np.array([c[key] for key in "xyuv"], dtype=float) for c in found}  # type: ignore[literal-required]


def test_couplers_have_centrodes_and_others_none() -> None:
    """A crank and a rocker turn about a fixed point, a slider doesn't turn."""
    assert set(drawn(four_bar())) == {"coupler"}
    assert set(drawn(slider_crank())) == {"rod"}


def test_the_circles_of_cardan() -> None:
    x, y, u, v = drawn(trammel())["bar"]
    assert np.hypot(x, y) == pytest.approx(100)
    assert np.hypot(u - 50, v) == pytest.approx(50)


def test_no_line_across_infinity() -> None:
    """The rod's centre goes to infinity upwards and comes back from below: the two parts are apart."""
    result = cycle_of(slider_crank()).result
    x, y, u, _ = drawn(slider_crank())["rod"]
    known = np.isfinite(x)
    assert (known == np.isfinite(u)).all()
    assert 10 < known.sum() < known.size
    assert np.abs(y[known]).max() < 300
    assert y[known] == pytest.approx(result["pole(rod, frame).y"][known] * 1e3)
    jumps = np.flatnonzero(known[:-1] & known[1:] & (np.diff(np.sign(result["rod.omega"])) != 0))
    assert jumps.size == 0


def test_infinite_speeds_bring_no_warnings() -> None:
    """A pole is cut where the relative speed changes its sign, also beside a pose at which that is infinite."""
    pole = np.zeros((4, 4))
    cut = _cut(pole, np.array([1.0, np.inf, 0.0, -1.0]), np.zeros(2), np.ones(2))
    assert np.isnan(cut[0]).tolist() == [False, False, True, True]
