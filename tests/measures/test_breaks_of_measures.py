"""Measures over poles, jumps, near-singular poses, narrow peaks and very many turns: what trials found wrong."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import linkwright as lw
from linkwright.measures import Measurer, enclose, misfit
from linkwright.measures.places import _to_nearest
from linkwright.measures.probe import Probe
from linkwright.reductions import Peak, ProofKind
from linkwright.reductions.efficiency import Efficiency
from linkwright.reductions.mean import Mean, Rms
from studies.models import TURN, UNITS, cycle_of, four_bar, job_of, measured, slider_crank, value


def crank(position: str, duration: str = "1 s", **sections: Any) -> dict[str, Any]:
    """A crank of 100 mm whose angle follows an expression."""
    return {
        "units": UNITS,
        "links": {"frame": {"points": {"A": [0, 0]}}, "crank": {"points": {"A": [0, 0], "B": [100, 0]}}},
        "drives": {"motor": {"turns": "crank", "on": "frame", "position": position}},
        "studies": {"cycle": {"duration": duration, "samples": 12}},
        **sections,
    }


PAST_A_POLE = crank("30 deg + 120 deg*t/(1 s)")
PAST_A_CUT = crank("30 deg + 240 deg*t/(1 s)")


def codes(job: Any) -> list[str]:
    return [finding.code for finding in job.cycle.failures]


def test_a_quotient_past_a_zero_of_its_denominator_is_unbounded() -> None:
    """tan from 30 to 150 deg: to +infinity before 90 deg, from -infinity after it, at 0.5 s."""
    job = job_of({**PAST_A_POLE, "measures": {"slope": {"extremes": "B.y/B.x"}, "mean": {"mean": "B.y/B.x"}}})
    assert codes(job) == ["measure.unbounded", "measure.diverges"]
    low, high = job.cycle.measures[0].found
    assert (low.value, low.side, high.value, high.side) == (-math.inf, "after", math.inf, "before")
    assert low.time == pytest.approx(0.5, abs=1e-12)
    entry = job.summary["measures"]["slope"]
    assert (entry["min"], entry["max"]) == (None, None)
    assert entry["unbounded"]["max"] == {"side": "before", "t": pytest.approx(0.5), "to": "+infinity"}
    assert job.summary["schema"] == 2
    assert job.exit_code == 1


@pytest.mark.parametrize(
    ("window", "met"), [([0, 0.4], True), ([0.6, 1], True), ([0, 0.6], False), ([0.4, 0.5], False)]
)
def test_only_places_inside_the_window_count(window: list[float], met: bool) -> None:
    data = {**PAST_A_POLE, "windows": {"part": [f"{edge} s" for edge in window]}}
    data |= {"measures": {"m": {"extremes": "B.y/B.x", "window": "part"}}, "require": {"m": "-10 .. 10"}}
    job = job_of(data)
    assert job.cycle.measures[0].verdict is met
    assert bool(codes(job)) is not met


@pytest.mark.parametrize(("requirement", "met"), [(">= 0", True), ("<= 100", False)])
def test_a_requirement_fails_only_on_the_side_that_it_bounds(requirement: str, met: bool) -> None:
    """1/x^2 is unbounded above only."""
    job = job_of({**PAST_A_POLE, "measures": {"m": {"extremes": "(1 mm/B.x)^2"}}, "require": {"m": requirement}})
    assert job.cycle.measures[0].verdict is met
    assert job.exit_code == 1


def test_the_arm_of_a_reaction_is_unbounded_where_the_normal_force_vanishes() -> None:
    data = slider_crank(r=50, l=160, e=0)
    data["links"]["slider"] = {"points": {"C": [0, 0]}, "mass": 1.2, "com": [15, 4], "inertia": 500}
    job = job_of(
        {**data, "measures": {"arm": {"extremes": "force(frame, slider).arm"}}, "require": {"arm": "-100 .. 100"}}
    )
    low, high = job.cycle.measures[0].found
    assert (low.value, high.value) == (-math.inf, math.inf)
    assert not job.cycle.measures[0].verdict
    normal = job.cycle.result.run.evaluate(["force(frame, slider).normal"], np.array([low.time]))[0, 0]
    assert abs(normal) < 1e-10


def test_a_ratio_of_speeds_is_unbounded_at_the_dead_centres() -> None:
    data = four_bar(measures={"ma": {"extremes": "crank.omega/rocker.omega"}}, require={"ma": "-3 .. 3"})
    job = job_of({**data, "studies": {**data["studies"], "limits": {"signals": ["crank.omega/rocker.omega"]}}})
    assert [f.value for f in job.cycle.measures[0].found] == [-math.inf, math.inf]
    course = next(c for c in job.limits.motion.courses if "/" in c.signal)
    assert (course.low.value, course.high.value) == (-math.inf, math.inf)


def test_a_jump_of_the_expression_counts_with_both_sides() -> None:
    """atan2 from 30 deg over 180 deg to 270 - 360 = -90 deg, its mean (30+180)/2*15/24 + (-180-90)/2*9/24 = 15 deg."""
    found = measured(
        PAST_A_CUT,
        both={"extremes": "atan2(B.y, B.x)"},
        span={"span": "atan2(B.y, B.x)"},
        mean={"mean": "atan2(B.y, B.x)"},
    )
    assert [found["both"].shown(label) for label in ("min", "max")] == pytest.approx([-180, 180], abs=1e-10)
    assert [f.side for f in found["both"].found] == ["after", "before"]
    assert found["span"].shown() == pytest.approx(360, abs=1e-10)
    assert found["mean"].shown() == pytest.approx(15, abs=1e-9)


def test_a_removable_place_has_its_limit() -> None:
    """sin(2 v)/sin(v) = 2 cos(v) also at v = 180 deg."""
    data = crank("30 deg + 240 deg*t/(1 s)")
    found = measured(data, m={"extremes": "sin(2*crank.angle)/sin(crank.angle)"})["m"]
    assert [found.shown(label) for label in ("min", "max")] == pytest.approx([-2, math.sqrt(3)], abs=1e-10)


@pytest.mark.parametrize("power", [-0.5, -1 / 3, -0.75])
def test_a_mean_over_an_integrable_pole(power: float) -> None:
    """|t - 0.3|^p over 0..1: (0.3^(p+1) + 0.7^(p+1))/(p + 1)."""
    expected = (0.3 ** (power + 1) + 0.7 ** (power + 1)) / (power + 1)
    assert value(PAST_A_POLE, mean=f"abs(t/(1 s) - 0.3)^({power!r})") == pytest.approx(expected, rel=1e-9)


def near_change_point(samples: int, turns: str = "1 motor", **measures: Any) -> dict[str, Any]:
    """A crank-rocker whose Grashof margin is 0.09 um."""
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [91.57726897569388, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [42.06229780229771, 0]}},
            "rod": {"points": {"B": [0, 0], "C": [147.4418718806158, 0]}},
            "arm": {"points": {"D": [0, 0], "C": [97.92699228448859, 0]}, "mass": 1, "shape": "rod D-C"},
        },
        "assembly": {"C": "left of B-D"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "10 deg"}},
        "measures": measures,
        "studies": {"cycle": {"turns": turns, "samples": samples}},
    }


@pytest.mark.parametrize("samples", [3, 60, 200, 360])
def test_a_torque_near_a_change_point(samples: int) -> None:
    """The closed form gives -144.4 .. 11.13 N*m."""
    outcome = cycle_of(near_change_point(samples, torque={"extremes": "motor.torque"}))
    low, high = (found.value for found in outcome.measures[0].found)
    assert (low, high) == (pytest.approx(-144.40, abs=0.01), pytest.approx(11.130, abs=0.001))


@pytest.mark.parametrize(("samples", "turns"), [(3, 13), (5, 40)])
def test_a_mean_square_near_a_change_point_does_not_depend_on_samples(samples: int, turns: int) -> None:
    many = cycle_of(near_change_point(samples, f"{turns} motor", m={"rms": "arm.omega"})).measures[0].found[0].value
    one = cycle_of(near_change_point(360, m={"rms": "arm.omega"})).measures[0].found[0].value
    assert many == pytest.approx(one, rel=1e-9)


def test_a_narrow_peak_of_a_linear_table_is_the_maximum() -> None:
    points = [[0, 0], [137.11, 0], [137.31, 10], [137.51, 0], [360, 0]]
    table = {"points": [[f"{x} deg", f"{y} N*m"] for x, y in points], "period": "360 deg", "between": "linear"}
    data = slider_crank(tables={"peak": table}, loads={"x": {"on": "crank", "torque": "-peak(motor.angle)"}})
    for link in ("crank", "rod", "slider"):
        data["links"][link] = {"points": data["links"][link]["points"]}
    found = measured(data, top={"max": "motor.torque"}, mean={"mean": "motor.torque"})
    assert found["top"].shown() == pytest.approx(10, rel=1e-9)
    assert found["mean"].shown() == pytest.approx(0.2 * 10 / 360, rel=1e-9)


@pytest.mark.parametrize("turns", [10_000_000, 1_000_000_000])
def test_angles_run_on_over_very_many_turns(turns: int) -> None:
    data = slider_crank(measures={"slope": {"extremes": "rod.angle"}}, studies={"cycle": {"turns": f"{turns} motor"}})
    low, high = (math.degrees(found.value) for found in cycle_of(data).measures[0].found)
    assert low == pytest.approx(math.degrees(math.asin((20 - 50) / 160)), abs=1e-6)
    assert high == pytest.approx(math.degrees(math.asin((20 + 50) / 160)), abs=1e-6)


def test_an_angle_that_can_not_be_followed_is_said_to_be_lost() -> None:
    data = slider_crank(studies={"cycle": {"duration": "1e7 s"}}, measures={"m": {"max": "rod.angle"}})
    data["drives"] = {
        "motor": {"turns": "crank", "on": "frame", "position": "360 deg*t/(1 s) + 1 deg*sin(t*(1 rad)/(1 s))"}
    }
    job = job_of(data)
    assert "motion.too-many-turns" in codes(job)
    assert job.exit_code == 1


def test_a_value_where_a_drive_has_a_position() -> None:
    data = slider_crank()
    found = measured(
        data, x={"value": "B.y", "where": "motor.angle = 24 deg"}, y={"value": "B.y", "where": "B.x = 0 mm"}
    )
    assert found["x"].shown() == pytest.approx(50 * math.sin(math.radians(24)), rel=1e-12)
    assert found["y"].shown() == pytest.approx(50, rel=1e-12)
    assert found["x"].found[0].time == pytest.approx(24 / 360, rel=1e-12)


def test_a_place_that_is_not_reached_is_an_error() -> None:
    job = job_of(slider_crank(measures={"m": {"value": "B.y", "where": "C.x = 900 mm"}}))
    assert codes(job) == ["measure.no-instant"]


# Grades and the check.


def test_smooth_measures_are_enclosed_and_means_searched() -> None:
    found = measured(
        slider_crank(), a={"extremes": "motor.torque"}, b={"mean": "motor.torque"}, c={"value": "B.x", "where": "start"}
    )
    kinds = {name: result.found[0].grade.kind for name, result in found.items()}
    assert kinds == {"a": ProofKind.ENCLOSED, "b": ProofKind.SEARCHED, "c": ProofKind.SAMPLED}
    width = found["b"].found[0].grade.width
    assert width is not None and 0 < width <= 1 / 256


def test_a_peak_that_the_search_misses_is_found_by_its_proof() -> None:
    """A hump of width 1e-4 of the run without any break function lies between all grids."""
    hump = "B.x/(1 mm) + 300*exp(-((t/(1 s) - 0.4321)/1e-4)^2)"
    result = measured(slider_crank(), m={"max": hump})["m"]
    assert result.shown() == pytest.approx(300 + 50 * math.cos(2 * math.pi * 0.4321), abs=1e-2)
    assert result.found[0].grade.kind is ProofKind.ENCLOSED


FAULTS = {
    "top": (Probe, "top", lambda p: Peak(p.bottom().value, 0.0, "")),
    "a little low": (Probe, "top", lambda p: Peak(sorted(p.peaks)[-1].value * (1 - 1e-3), 0.0, "")),
    "mean": (Mean, "run_figures", lambda kind, run: (run.graded_figure("", 1.001 * run.mean()),)),
    "efficiency": (Efficiency, "run_figures", lambda kind, run: (run.graded_figure("", 1.0),)),
    "rms": (Rms, "run_figures", lambda kind, run: (run.graded_figure("", 10 * run.top().value),)),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_planted_faults_are_caught_by_the_check(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    owner, name, wrong = FAULTS[fault]
    measures = {"a": {"max": "B.x"}, "b": {"mean": "B.x + 60 mm"}, "c": {"rms": "B.x"}, "d": {"efficiency": ["press"]}}
    loads = {
        "press": {"on": "slider", "at": "C", "force": ["-5 N*C.vx/(1 m/s)", 0]},
        "brake": {"on": "rod", "torque": "-0.01 N*m*rod.omega/(1 rad/s)"},
    }
    data = slider_crank(measures=measures, loads=loads)
    run = cycle_of(data).result.run
    measurer = Measurer(run)
    assert misfit(measurer, measurer.all()) < 1e-12
    monkeypatch.setattr(owner, name, wrong)
    measurer = Measurer(run)
    assert misfit(measurer, measurer.all()) > 1e-7


def test_a_failed_check_fails_the_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Probe, "top", lambda p: Peak(p.bottom().value, 0.0, ""))
    monkeypatch.setattr("linkwright.studies.cycle.study.enclose", lambda measurer, results: results)
    job = job_of(slider_crank(measures={"a": {"max": "B.x"}}))
    assert "motion.unproven" in codes(job)
    assert not job.cycle.result.certificate.sound()


def test_a_proof_refutes_what_is_planted(monkeypatch: pytest.MonkeyPatch) -> None:
    run = cycle_of(slider_crank(measures={"a": {"max": "B.x"}})).result.run
    measurer = Measurer(run)
    true = Probe.top
    monkeypatch.setattr(Probe, "top", lambda p: Peak(true(p).value * (1 - 1e-6), 0.0, ""))
    (result,) = enclose(measurer, measurer.all())
    assert result.found[0].grade.kind is ProofKind.SEARCHED
    assert result.found[0].grade.reason == "refuted"


def test_python_has_grades() -> None:
    job = lw.run(lw.Document.model_validate(slider_crank(measures={"m": {"max": "B.x"}}, studies={"cycle": TURN})))
    assert job.summary["measures"]["m"]["grade"] == {"kind": "enclosed"}


@given(st.lists(st.floats(-9, 9), max_size=9), st.lists(st.floats(-9, 9), min_size=1, max_size=9))
def test_the_distance_to_the_nearest_place(places: list[float], times: list[float]) -> None:
    """As comparing all with all gives it, without the memory that this takes where there are very many."""
    found = _to_nearest(np.array(times), np.array(places))
    apart = np.abs(np.subtract.outer(times, places))
    assert np.array_equal(found, apart.min(axis=1, initial=np.inf))


def test_millions_of_turns_take_bounded_memory() -> None:
    many = np.linspace(0.0, 1.0, 80_000)
    assert _to_nearest(many, many).max() == 0.0
