"""Motions of segments: joins, matching, what comes beyond, refusals, splines and formulas."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.differences import derivatives
from laws.texts import value
from linkwright.laws import (
    LAWS,
    Blend,
    Curve,
    Dwell,
    Formula,
    Motion,
    MotionError,
    Rise,
    Segment,
    Shape,
    b_spline,
    motion,
    series,
    spline,
)
from linkwright.notation import Jet

LINE, CYCLOID, EIGHTH = LAWS["constant_velocity"], LAWS["cycloidal"], LAWS["eighth_degree"]
OPEN = (None, None)


def faults(*segments: Segment, **more: float) -> list[tuple[str, int | None]]:
    with pytest.raises(MotionError) as error:
        motion(segments, **more)
    return [(fault.code, fault.segment) for fault in error.value.faults]


def test_joins_of_a_dwell_rise_dwell_return_motion() -> None:
    made = motion([Rise(90, 12, CYCLOID), Dwell(180), Rise(75, -12, CYCLOID), Dwell(15)], 3.0, 360)
    assert [join.at for join in made.joins] == [0, 90, 270, 345]
    assert made.continuity == 2
    jerk = 4 * math.pi**2 * 12
    assert [join.jumps[3] for join in made.joins] == pytest.approx(
        [jerk / 90**3, -jerk / 90**3, -jerk / 75**3, jerk / 75**3], rel=1e-12
    )
    assert made.at([0, 90, 200, 345, 359, 450, -15]) == pytest.approx([3, 15, 15, 3, 3, 15, 3], abs=1e-13)
    low, high = made.extremes(1)
    assert (high.value, high.at) == pytest.approx((2 * 12 / 90, 45))
    assert (low.value, low.at) == pytest.approx((-2 * 12 / 75, 307.5))


def test_weld_on_the_fly() -> None:
    """The tool runs along at 50 mm/s; both blends take velocity and acceleration from it."""
    made = motion([Dwell(1), Blend(1, 20, OPEN, OPEN), Rise(2, 100, LINE), Blend(1.5, -120, OPEN, OPEN)])
    assert made.continuity >= 2
    assert made.at([2.0, 3.0, 4.0], 1) == pytest.approx([50, 50, 50], rel=1e-12)
    smoother = motion(
        [Dwell(1), Blend(1, 22, (None,) * 3, (None,) * 3), Rise(2, 100, LINE), Blend(1.5, -122, OPEN, OPEN)]
    )
    jerks = {join.at: join.jumps[3] for join in smoother.joins}
    assert jerks[1.0] == jerks[2.0] == 0
    assert jerks[4.0] != 0


@settings(max_examples=25, deadline=None)
@given(
    st.floats(0.1, 5),
    st.floats(-20, 20),
    st.lists(st.floats(-9, 9), max_size=3),
    st.lists(st.floats(-9, 9), max_size=3),
)
def test_a_polynomial_meets_its_conditions(over: float, lift: float, start: list[float], end: list[float]) -> None:
    blend = Blend(over, lift, tuple(start), tuple(end), ((0.4 * over, 1.5),))
    curve = blend.curve(start, end)
    first, last = curve.end_derivatives()
    big = max(1.0, *(abs(v) * over**k for rates in (start, end) for k, v in enumerate(rates, 1)), abs(lift))
    for k, rate in enumerate(start, 1):
        assert first[k] * over**k == pytest.approx(rate * over**k, abs=1e-9 * big)
    for k, rate in enumerate(end, 1):
        assert last[k] * over**k == pytest.approx(rate * over**k, abs=1e-9 * big)
    assert curve.at([0, 0.4 * over, over]) == pytest.approx([0, 1.5, lift], abs=1e-10 * big)


def test_repeat_advance_hold() -> None:
    indexing = motion([Rise(1, 60, CYCLOID), Dwell(2)], 5, beyond="advance")
    assert indexing.at([0.5, 3.5, 7, -1]) == pytest.approx([35, 95, 185, 5])
    assert indexing.continuity == 2
    once = motion([Dwell(1), Rise(1, 60, CYCLOID)], 5, beyond="hold")
    assert once.at([-9, 1.5, 9]) == pytest.approx([5, 35, 65])
    assert once.at([-9, 9, 1.5], 1) == pytest.approx([0, 0, 120])
    assert [join.continuity for join in once.joins] == [4, 2, 2]
    assert np.isnan(once.at([np.nan], 1)).all()
    assert np.isnan(indexing.at([1e300, np.nan, np.inf], 3)).all()


def test_derivatives_across_a_motion_against_differences() -> None:
    bend = b_spline([0, 0, 0, -2, 1, 3, 3, 3], 5)
    made = motion(
        [Rise(2, 3, LAWS["modified_sine"].skewed(0.35)), Blend(1, -2, (0.0, 0.0), (0.0, 0.0), ((0.3, 1),), 5),
         Shape(2, bend), Shape(1, series([0.4, -0.1], [0.0, 0.2])), Blend(2, -4, OPEN, OPEN)]
    )  # fmt: skip
    x = np.array([0.21, 1.13, 2.17, 2.55, 3.4, 4.61, 5.37, 6.9])
    for k in range(4):
        wanted = derivatives(lambda at, k=k: made.at(at, k), x, 2e-3)
        assert made.at(x, k + 1) == pytest.approx(wanted, rel=1e-7, abs=1e-6 * np.abs(wanted).max())
    assert made.continuity == 0  # the series' velocity meets that of no neighbour but the last
    with mp.workdps(30):
        for start, stop, text in made.pieces():
            middle = (start + stop) / 2
            assert float(value(text, mp.mpf(middle))) == pytest.approx(float(made.at(middle)), rel=1e-12, abs=1e-12)


def test_in_other_units() -> None:
    made = motion([Rise(math.pi, 0.02, CYCLOID), Rise(math.pi, -0.02, CYCLOID)])
    timed = made.restated(2 * math.pi, 1e-3)  # over seconds at one turn a second, in mm
    assert timed.at([0.25, 0.5]) == pytest.approx([10, 20])
    assert timed.extremes(1)[1].value == pytest.approx(80)


def test_b_splines_and_splines() -> None:
    """The rest at both ends that three equal control values give; Schoenberg: a line's control values give the line."""
    curve = b_spline([1, 1, 1, 4, 4, 4], 3)
    first, last = curve.end_derivatives()
    assert (*first[:3], *last[:3]) == pytest.approx([1, 0, 0, 4, 0, 0], abs=1e-12)
    knots = np.array([0, 0, 0, 0.5, 1, 1, 1])
    greville = np.array([knots[i + 1 : i + 3].mean() for i in range(4)])
    assert b_spline(greville.tolist(), 2).at([0.1, 0.6, 0.9]) == pytest.approx([0.1, 0.6, 0.9])
    x = np.array([0.0, 0.7, 1.5, 2.0])
    through = spline(x, x**5 - x, 5, (-1.0, 0.0), (79.0, 160.0))
    at = np.linspace(0, 2, 9)
    assert through.at(at) == pytest.approx(at**5 - at, abs=1e-12)


def test_a_formula_of_ones_own() -> None:
    """u^2 (3 - 2u) as a user writes it, run backwards too, against the registered law."""
    own = Curve((Formula(lambda u: u * u * (3.0 - 2.0 * u), lambda x: f"({x})^2*(3 - 2*({x}))"),))
    made = motion([Rise(2, 5, own), Dwell(1), Rise(2, -5, own, fall=True)], 1)
    same = motion([Rise(2, 5, LAWS["poly_23"]), Dwell(1), Rise(2, -5, LAWS["poly_23"])], 1)
    x = np.linspace(0.05, 4.95, 12)
    for k in range(5):
        assert made.at(x, k) == pytest.approx(same.at(x, k), abs=1e-12)
    jet = made(Jet([x, np.ones(12), np.zeros(12)]))
    assert jet.d[2] == pytest.approx(same.at(x, 2), abs=1e-12)
    for start, stop, text in made.pieces():
        x = (start + 2 * stop) / 3
        assert float(value(text, mp.mpf(x))) == pytest.approx(float(same.at(x)), rel=1e-14)


def test_laws_that_end_with_an_acceleration() -> None:
    mirrored = motion([Rise(120, 10, EIGHTH), Rise(120, -10, EIGHTH, fall=True), Dwell(120)])
    assert mirrored.continuity == 2
    double = LAWS["double_harmonic"]
    assert motion([Rise(90, 7, double), Rise(90, -7, double, fall=True)]).continuity == 4  # one period of two cosines
    early = [Rise(120, 10, EIGHTH), Dwell(100), Rise(120, -10, EIGHTH, fall=True), Dwell(20)]
    assert faults(*early) == [("law.end-acceleration", 0), ("law.end-acceleration", 2)]
    uneven = [Rise(120, 10, EIGHTH), Rise(100, -10, EIGHTH, fall=True), Dwell(140)]
    assert faults(*uneven) == [("law.end-acceleration", 0), ("law.end-acceleration", 1)]
    assert faults(Rise(120, 10, EIGHTH), Rise(120, -10, EIGHTH)) == [
        ("law.end-acceleration", 0),
        ("law.end-acceleration", 1),
    ]


def test_refusals() -> None:
    assert faults(Rise(90, 12, CYCLOID), Dwell(260), period=360) == [("law.period", None), ("law.not-closed", None)]
    assert faults(Dwell(0.0), Rise(math.nan, 3, CYCLOID), Dwell(1e200)) == [("law.over", i) for i in range(3)]
    assert faults(Blend(1, 2, OPEN, OPEN), Blend(1, -2, OPEN, OPEN))[0] == ("law.open-end", 0)
    assert faults(Blend(1, 0, (), (), ((1.2, 3),)), Dwell(1)) == [("law.via", 0)]
    assert faults(Blend(1, 0, (0.0,), (0.0, 0.0), ((0.2, 3),), 5), Dwell(1)) == [("law.end-rates", 0)]
    crowd = tuple((k / 20, 1.0) for k in range(1, 18))
    assert faults(Blend(1, 0, (), (), crowd), Dwell(1)) == [("law.conditions", 0)]
    assert faults(Rise(1, 0, Curve((Formula(lambda u: u + 1.0, str),))), Dwell(1)) == [("law.not-normal", 0)]


def test_a_velocity_jump_is_a_join_of_class_0() -> None:
    made: Motion = motion([Rise(2, 10, LINE), Rise(3, -10, LINE)])
    assert made.continuity == 0
    assert [join.jumps[1] for join in made.joins] == pytest.approx([5 + 10 / 3, -5 - 10 / 3])
