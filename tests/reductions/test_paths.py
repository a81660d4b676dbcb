"""Length and straightness of paths: closed forms, and the narrowest strip against a search by brute force."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar
from scipy.special import ellipe

from linkwright.notation.hull import hull
from linkwright.reductions.straightness import narrowest, strip
from linkwright.results.stationary import stationary
from studies.models import four_bar, job_of, measured, slider_crank, trammel, value

R, L, E = 50.0, 160.0, 20.0  # mm of the slider-crank
TOP, BOTTOM = math.sqrt((L + R) ** 2 - E**2), math.sqrt((L - R) ** 2 - E**2)


def near(wanted: float, tolerance: float = 1e-12) -> Any:
    return pytest.approx(wanted, rel=tolerance, abs=tolerance)


# Length.


@pytest.mark.parametrize("turns", [1, 3])
def test_length_of_a_circle(turns: int) -> None:
    data = slider_crank(studies={"cycle": {"turns": f"{turns} motor", "samples": 20}})
    assert value(data, path="B") == near(2 * math.pi * R * turns)


def test_length_there_and_back() -> None:
    """The speed vanishes at both ends of the stroke: the kinks of |v| must not cost digits."""
    assert value(slider_crank(), path="C") == near(2 * (TOP - BOTTOM))


def test_length_of_an_ellipse() -> None:
    """Semi-axes of 80 and 20 mm: 4 a E(1 - b^2/a^2)."""
    assert value(trammel(), path="K") == near(4 * 80 * float(ellipe(1 - (20 / 80) ** 2)))


def test_length_in_windows() -> None:
    windows = {"arc": {"motor.angle": ["0 deg", "60 deg"]}, "high": {"B.y": ["30 mm", "60 mm"]}}
    data = slider_crank(windows=windows, studies={"cycle": {"turns": "2 motor", "samples": 50}})
    assert value(data, path="B", window="arc") == near(2 * R * math.pi / 3)
    assert value(data, path="B", window="high") == near(2 * R * 2 * math.acos(30 / R))


def test_length_with_dwells() -> None:
    """Rest, a 3-4-5 move of 90 deg, rest: a quarter of a circle, its length no matter of speed."""
    drive = {"turns": "crank", "on": "frame", "position": "step5(t, 0.3 s, 0 deg, 0.55 s, 90 deg)"}
    data = slider_crank(drives={"motor": drive}, studies={"cycle": {"duration": "1 s", "samples": 40}})
    assert value(data, path="B") == near(R * math.pi / 2)
    assert value(data, path="A") == 0.0


def test_units_bounds_and_wording() -> None:
    outcome = measured(slider_crank(), p={"path": "B", "unit": "m"}, s={"straightness": "B"})
    assert (outcome["p"].shown(), outcome["p"].unit) == (near(0.1 * math.pi), "m")
    assert (outcome["s"].shown(), outcome["s"].unit) == (near(2 * R), "mm")
    assert outcome["p"].measure.subject == "B"
    job = job_of(slider_crank(measures={"p": {"path": "B"}}, require={"p": "314 .. 0.3142 m"}))
    assert job.cycle is not None
    assert job.cycle.measures[0].verdict is True


# Straightness.


@pytest.mark.parametrize("degrees", [1, 20, 60, 179])
def test_straightness_of_an_arc_is_its_rise(degrees: float) -> None:
    data = slider_crank(windows={"arc": {"motor.angle": ["7 deg", f"{7 + degrees} deg"]}})
    rise = 2 * R * math.sin(math.radians(degrees) / 4) ** 2
    assert value(data, straightness="B", window="arc") == pytest.approx(rise, rel=1e-11, abs=1e-13)


def test_straightness_of_whole_curves() -> None:
    """The narrowest strip around an ellipse is as wide as its short axis, around a circle as its diameter."""
    assert value(trammel(), straightness="K") == near(40.0)
    assert value(slider_crank(), straightness="B") == near(2 * R)


def test_a_straight_path() -> None:
    guide = {"prismatic": ["frame", "slider"], "line": ["F at 33 deg", "C at 0 deg"]}
    assert value(slider_crank(joints={"guide": guide}), straightness="C") == pytest.approx(0.0, abs=1e-12)
    assert value(slider_crank(), straightness="A") == 0.0


def test_straightness_of_a_coupler_curve_against_brute_force() -> None:
    """20 001 points of the closed-form path, the strip's direction by a search over all angles: never wider."""
    data = four_bar(windows={"part": {"motor.angle": ["200 deg", "290 deg"]}})
    crank = np.radians(np.linspace(200, 290, 20001))
    a = 40 * np.exp(1j * crank)
    span = 100 - a
    along = (120**2 - 80**2 + np.abs(span) ** 2) / (2 * np.abs(span))
    arm = span / np.abs(span) * (along + 1j * np.sqrt(120**2 - along**2)) / 120
    path = a + (60 + 30j) * arm
    found = value(data, straightness="P", window="part")
    assert found == pytest.approx(brute(path), rel=1e-7)


def brute(path: Any) -> float:
    """The least extent across any of 720 directions, refined around the best of them."""

    def extent(angle: float) -> float:
        return float(np.ptp((path * np.exp(-1j * angle)).imag))

    coarse = np.linspace(0, np.pi, 720)
    best = coarse[int(np.argmin([extent(angle) for angle in coarse]))]
    step = coarse[1]
    found = minimize_scalar(extent, bounds=(best - step, best + step), method="bounded", options={"xatol": 1e-12})
    return float(found.fun)


coefficients = st.lists(st.complex_numbers(max_magnitude=1, allow_nan=False), min_size=3, max_size=6)


@settings(max_examples=30, deadline=None)
@given(coefficients, st.floats(0.3, 6.2))
def test_straightness_of_random_curves(factors: list[complex], stop: float) -> None:
    """Arcs of random trigonometric curves: as wide as brute force says, to what its samples resolve."""
    orders = np.arange(len(factors)) - 2

    def curve(t: Any, power: int) -> Any:
        return sum(f * (1j * k) ** power * np.exp(1j * k * t) for f, k in zip(factors, orders, strict=True))

    size = float(np.abs(curve(np.linspace(0, stop, 200), 1)).max()) or 1.0

    def turning(along: Any) -> Any:
        inner = stationary(lambda t: tuple(row[None] for row in along(t)), 0.0, stop, 100)[0]
        return np.concatenate([[0.0], inner, [stop]])

    found, *_ = narrowest(lambda t: curve(t, 0), lambda t: curve(t, 1), np.linspace(0.0, stop, 101), turning)
    wanted = brute(curve(np.linspace(0, stop, 8001), 0))
    assert found <= wanted + 1e-6 * size
    assert found >= wanted - 1e-6 * size


@settings(max_examples=50)
@given(st.lists(st.tuples(st.integers(-5, 5), st.integers(-5, 5)), min_size=1, max_size=12))
def test_hull_and_strip_of_grid_points(corners: list[tuple[int, int]]) -> None:
    """Every point lies inside the hull; the strip is the least extent across any edge between two points."""
    points = np.array([complex(*corner) for corner in corners])
    ring = hull(points)
    assert set(ring) <= set(points)
    if ring.size < 3:
        return
    edges = np.roll(ring, -1) - ring
    assert (((points[None] - ring[:, None]) * edges.conj()[:, None]).imag >= 0).all()
    lines = [b - a for a in points for b in points if a != b]
    assert strip(ring)[0] == pytest.approx(min(np.ptp((points / (d / abs(d))).imag) for d in lines), abs=1e-12)
