"""Searched extremes where terms cancel, at roots that rest at zero, right before a pole past the end of the run, beside
other measures: what trials found wrong under a tick, against limits by hand and mpmath."""

from __future__ import annotations

import math
from typing import Any

import mpmath
import numpy as np
import pytest

import linkwright as lw
from helpers.examples import UNITS as METRES
from linkwright.enclosures.intervals import Intervals, exp
from linkwright.measures.germs import Germ
from linkwright.model.document import parse_document
from linkwright.reductions import ProofKind
from measures.test_germs import s as series
from studies.models import UNITS, job_of

SI = {**UNITS, "length": "m", "angle": "rad"}
X, T = "(crank.angle/(1 rad))", "(t/(1 s))"


def turning(**measures: str) -> dict[str, Any]:
    """A crank that turns from 0 to 5 rad at 1 rad/s, and extremes of expressions."""
    return {
        "units": SI,
        "links": {"frame": {"points": {"A": [0, 0]}}, "crank": {"points": {"A": [0, 0], "P": [0.1, 0]}}},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 0}},
        "measures": {name: {"extremes": text} for name, text in measures.items()},
        "studies": {"cycle": {"duration": 5, "samples": 200}},
    }


def at_dead_centre(**measures: str) -> dict[str, Any]:
    """A slider-crank, r = 50 mm and l = 160 mm, from 1 rad before its outer dead centre to 1 rad after it, 2 rad/s."""
    return {
        "units": {**UNITS, "angle": "rad"},
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [50, 0]}},
            "rod": {"points": {"B": [0, 0], "C": [160, 0]}},
            "ram": {"points": {"C": [0, 0]}},
        },
        "joints": {"guide": {"prismatic": ["frame", "ram"], "line": ["A at 0 rad", "C at 0 rad"]}},
        "assembly": {"C": "ahead of B along guide"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 2, "start": -1.0}},
        "measures": {name: {"extremes": text} for name, text in measures.items()},
        "studies": {"cycle": {"duration": 1.0, "samples": 100}},
    }


def bounds(data: dict[str, Any], name: str = "m") -> tuple[float, float]:
    """The minimum and the maximum that are reported, with no finding."""
    job = job_of(data)
    assert [finding.code for finding in (*job.cycle.failures, *job.cycle.warnings)] == []
    low, high = next(measure for measure in job.cycle.measures if measure.name == name).found
    return low.value, high.value


def near(wanted: Any, share: float = 1e-9) -> Any:
    return pytest.approx(float(wanted), rel=share, abs=1e-12)


def gap(angle: Any) -> Any:
    """What the slider is short of its outer dead centre (mm), without cancellation."""
    rod, rise = mpmath.mpf(160), 50 * mpmath.sin(angle)
    return 100 * mpmath.sin(mpmath.mpf(angle) / 2) ** 2 + rise**2 / (rod + mpmath.sqrt(rod**2 - rise**2))


def speed(angle: Any) -> Any:
    """The slider's speed (mm/s) where the crank turns at 2 rad/s."""
    sine, cosine = mpmath.sin(angle), mpmath.cos(angle)
    return -100 * sine * (1 + 50 * cosine / mpmath.sqrt(160**2 - (50 * sine) ** 2))


# Where terms cancel: 50 (1 + 50/160)/2 mm/rad^2 is what the stroke falls by near the dead centre.

CURVE = 32.8125


def test_a_quotient_of_fourth_powers_at_a_dead_centre() -> None:
    low, high = bounds(at_dead_centre(m="(210 mm - guide.s)^2/crank.angle^4/(1 mm^2)"))
    assert low == near(gap(1) ** 2)  # 818.86, where 0 was said
    assert high == near(CURVE**2)


def test_a_squared_speed_over_the_gap_is_bounded_at_a_dead_centre() -> None:
    low, high = bounds(at_dead_centre(m="guide.v^2/(210 mm - guide.s)/(1 mm/s^2)"))
    assert low == near(speed(1) ** 2 / gap(1))
    assert high == near(16 * CURVE)  # 525, where it was called unbounded


def test_a_gap_of_third_order() -> None:
    u = f"({X} - 1.25)"
    low, high = bounds(turning(m=f"({u} - sin({u}))/{u}^3"))
    assert low == near((3.75 - math.sin(3.75)) / 3.75**3)
    assert high == near(1 / 6)


# Beside other measures in one file.


def test_an_extreme_does_not_depend_on_the_other_measures() -> None:
    """A root that rests at zero until 1.25 s made the other measure's maximum 1e298."""
    u = f"({T} - 1.25)"
    some = {"m": f"acos(1 - {u}^2/20) + atan(1/{u})", "root": f"sqrt(max(0, {u}))"}
    assert bounds(turning(**some)) == bounds(turning(m=some["m"])) == (near(-math.pi / 2), near(math.pi / 2))
    assert bounds(turning(**some), "root") == (0.0, near(math.sqrt(3.75)))


def test_a_root_is_never_negative() -> None:
    some = {"m": f"2.822039102555915*sqrt(max(0, ({X} - 1.25)))", "power": f"abs({X} - 1.25)^1.5"}
    assert bounds(turning(**some)) == (0.0, near(2.822039102555915 * math.sqrt(3.75)))
    assert bounds(turning(**some), "power") == (near(0.0), near(3.75**1.5))


# Roots and poles near by.


def test_no_sample_lies_outside_of_the_extremes_of_roots() -> None:
    """The minimum is between the samples after the root begins, the maximum before it."""
    job = job_of(
        turning(
            m=f"(0 - 1.4654626061836153)*sqrt(max(0, {X} - 1.5))"
            f" + (0 - 1.327008624744343)*sin({T} - 1.9)/sqrt(abs({T} - 1.9))"
        )
    )
    low, high = job.cycle.measures[0].found

    def f(x: Any) -> Any:
        root = mpmath.sqrt(max(x - mpmath.mpf(1.5), 0))
        v = x - mpmath.mpf(1.9)
        return -mpmath.mpf(1.4654626061836153) * root - mpmath.mpf(1.327008624744343) * mpmath.sin(v) / mpmath.sqrt(
            abs(v)
        )

    with mpmath.workdps(40):
        tops = [mpmath.findroot(lambda x: mpmath.diff(f, x), near_by) for near_by in (0.73, 3.7)]
        assert high.value == near(f(tops[0]))
        assert low.value == near(f(tops[1]))
    assert (high.time, low.time) == (pytest.approx(float(tops[0]), abs=1e-6), pytest.approx(float(tops[1]), abs=1e-6))


def test_a_kink_of_1e_10_is_not_a_pole() -> None:
    low, high = bounds(turning(m=f"1/sqrt(abs({X} - 3.3) + 1e-10)"))
    assert low == near(1 / math.sqrt(3.3 + 1e-10))
    assert high == near(1e5, 1e-6)  # the crank's angle is known to 4e-16: the top to 2e-6 of it


@pytest.mark.parametrize("gap", [1e-9, 1e-7, 1e-4])
def test_a_pole_past_the_end_of_the_run(gap: float) -> None:
    low, high = bounds(turning(m=f"2.662514334578657/({5 + gap!r} - {X})"))
    assert low == near(2.662514334578657 / (5 + gap))
    assert high == near(2.662514334578657 / ((5 + gap) - 5))


def test_a_narrow_peak_of_an_acceleration() -> None:
    """A lever whose slot passes its crank's pin at 0.1 mm: peaks of 2.6e6 rad/s^2 over 0.3 ms, from the closed form
    tan(angle) = (r sin q + d)/(r cos q) of the pin seen from the lever's pivot."""
    r, d, w = 0.1001, 0.1, 2.0
    data = {
        "units": SI,
        "links": {
            "frame": {"points": {"O": [0, 0], "C": [0, -d]}},
            "crank": {"points": {"O": [0, 0], "B": [r, 0]}},
            "lever": {"points": {"C": [0, 0], "D": [0.4, 0]}},
        },
        "joints": {"slot": {"pin_in_slot": ["crank", "lever"], "pin": "B", "straight": "C at 0 rad"}},
        "assembly": {"D": [0.20417538733534193, 0.24396571225408956]},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": w, "start": 0.5}},
        "measures": {"m": {"extremes": "lever.alpha"}},
        "studies": {"cycle": {"duration": 4.0, "samples": 200}},
    }

    # alpha = w^2 r d (d^2 - r^2) cos q/(r^2 + d^2 + 2 r d sin q)^2, which turns where sin q solves a quadratic.
    with mpmath.workdps(40):
        r_, d_ = mpmath.mpf(r), mpmath.mpf(d)
        a, b, square = r_**2 + d_**2, 2 * r_ * d_, d_**2 - r_**2
        sine = (a - mpmath.sqrt(a**2 + 8 * b**2)) / (2 * b)
        peak = w**2 * b / 2 * abs(square) * mpmath.sqrt(1 - sine**2) / (a + b * sine) ** 2
    assert bounds(data) == (near(-peak), near(peak))


# What they stand on.


def test_a_root_of_a_series_keeps_its_steps() -> None:
    """sqrt(s + s^2) = s^(1/2) (1 + s/2 - ...): the next term is one step of s further, not half of one."""
    root = (series() * series(1.0)) ** 0.5
    s = np.array([1e-3, 1e-2])
    assert isinstance(root, Germ)
    assert root(s) == pytest.approx(np.sqrt(s + s**2), rel=1e-12)


def test_intervals_past_the_largest_number_are_bounded_from_inside() -> None:
    found = exp(Intervals(800.0, 801.0))
    assert 1e308 < found.low < math.inf
    assert found.high == math.inf
    assert (1.0 / (1.0 + found)).high < 1e-300


@pytest.mark.parametrize("exponent", [3, 4, 5, 6, 7])
def test_a_peak_beside_a_change_point_of_a_group_solved_by_newton(exponent: int) -> None:
    """A pin passes the pivot of the slotted lever that it turns at 10^-k m: the lever turns by half a turn in 10^-k of
    the time, and its acceleration grows with the square of that."""
    r, c, speed, start = 0.1 + 10.0**-exponent, 0.1, 2.0, 0.5
    data = slotted_lever(r, c, start, speed)
    (found,) = lw.run(parse_document(data)).outcomes["cycle"].measures
    # The second derivative of atan2(r sin a + c, r cos a) by the angle x past the pivot is r c (r^2 - c^2) sin x over
    # the square of D = (r - c)^2 + 4 r c sin^2(x/2); its largest value is looked for on a fine grid about the pivot.
    x = np.linspace(0.0, 40.0, 400_001) * (r - c) / c
    distance = (r - c) ** 2 + 4 * r * c * np.sin(x / 2) ** 2
    peak = speed**2 * float((r * c * (r * r - c * c) * np.sin(x) / distance**2).max())
    assert [one.value for one in found.found] == pytest.approx([-peak, peak], rel=1e-6)
    assert {one.grade.kind for one in found.found if one.grade} == {ProofKind.ENCLOSED}


def slotted_lever(r: float, c: float, start: float, speed: float) -> dict[str, Any]:
    """A crank of radius r whose pin turns a slotted lever about a pivot at c below the crank's (m)."""
    at = np.array([r * math.cos(start), r * math.sin(start) + c])
    tip = 0.4 * at / np.hypot(*at) - [0, c]
    return {
        "linkwright": 1,
        "units": dict(METRES),
        "links": {
            "frame": {"points": {"O": [0, 0], "C": [0, -c]}},
            "crank": {"points": {"O": [0, 0], "B": [r, 0]}},
            "lever": {"points": {"C": [0, 0], "D": [0.4, 0]}},
        },
        "joints": {"slot": {"pin_in_slot": ["crank", "lever"], "pin": "B", "straight": "C at 0 rad"}},
        "assembly": {"D": [float(tip[0]), float(tip[1])]},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": speed, "start": start}},
        "measures": {"alpha": {"extremes": "lever.alpha"}},
        "studies": {"cycle": {"duration": 4, "samples": 100}},
    }


def test_where_the_pin_meets_the_pivot_the_motion_stops() -> None:
    """There the lever turns freely about the pin, and any way on is as good: the finding has the time and the value."""
    job = lw.run(parse_document(slotted_lever(0.1, 0.1, 0.5, 2.0)))
    (finding,) = job.found
    assert (finding.code, job.exit_code) == ("motion.stuck", 1)
    assert f"{(1.5 * math.pi - 0.5) / 2:.6g} s" in finding.what and f"{1.5 * math.pi:.6g} rad" in finding.what
