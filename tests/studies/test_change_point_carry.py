"""Motions carried through change points, held to closed forms that know of none."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from linkwright.app import write
from linkwright.kernels.change_points import GAP, Passage, Passages
from linkwright.measures import Measurer, misfit
from studies.models import CRANK, UNITS, at, codes, cycle_of, four_bar, job_of, slider_crank, speakable

TURN = 2 * np.pi


def parallelogram(
    start: str = "30 deg", a: float = 40, b: float = 100, turns: float = 2, **cycle: Any
) -> dict[str, Any]:
    drives = {"motor": {**CRANK, "start": start}}
    studies = {"cycle": {"turns": f"{turns} motor", "samples": 73, "through": "keep", **cycle}}
    return four_bar(a, b, a, b, drives=drives, studies=studies)


def fine(run: Any) -> np.ndarray:
    """Times all over the run, dense around each change point, the very instant among them."""
    around = np.concatenate([[0.0], *(s * np.geomspace(1e-12, 0.05, 40) for s in (1, -1))])
    t = np.concatenate([run.t, *(p.time + around for p in run.compiled.passages.every)])
    return np.sort(t[(t >= run.start) & (t <= run.stop)])


# A parallelogram: the rocker does what the crank does, the coupler only translates.


@pytest.mark.parametrize(("a", "b"), [(40, 100), (40, 120), (33.3, 71.9), (100, 40)])
@pytest.mark.parametrize("start", ["30 deg", "0 deg", "360 deg", "1 rad", "-1 deg"])
def test_a_parallelogram_stays_one(a: float, b: float, start: str) -> None:
    data = parallelogram(start, a, b)
    if start == "-1 deg":
        data["assembly"] = {"B": "right of A-O4"}
    outcome = cycle_of(data)
    assert not outcome.failures
    run = outcome.result.run
    t = fine(run)
    assert at(run, "coupler.angle", t) == pytest.approx(0, abs=1e-12)
    lag = at(run, "rocker.angle", t) - at(run, "crank.angle", t)
    assert lag == pytest.approx(TURN * round(lag[0] / TURN), abs=1e-12)
    assert at(run, "rocker.omega", t) == pytest.approx(TURN, rel=1e-11)
    assert at(run, "rocker.alpha", t) == pytest.approx(0, abs=1e-9 * TURN**2)
    assert at(run, "rocker.jerk", t) == pytest.approx(0, abs=1e-7 * TURN**3)
    assert outcome.result.certificate is not None
    assert outcome.result.certificate.sound()


def test_rates_of_signals_hold_in_the_band_too() -> None:
    run = cycle_of(parallelogram()).result.run
    t = fine(run)
    values, slopes = run.rates(["B.x", "rocker.angle", "B.ax"], t)
    angle = math.radians(30) + TURN * t
    assert values[0] == pytest.approx(0.1 + 0.04 * np.cos(angle), abs=1e-13)
    assert slopes[0] == pytest.approx(-0.04 * TURN * np.sin(angle), abs=1e-11)
    assert slopes[1] == pytest.approx(TURN, rel=1e-11)
    assert slopes[2] == pytest.approx(0.04 * TURN**3 * np.sin(angle), abs=1e-6)


def test_an_antiparallelogram_stays_one() -> None:
    """The rocker turns against the crank: tan(rocker/2) = -tan(crank/2) (b + a)/(b - a)."""
    data = parallelogram()
    data["assembly"] = {"B": "right of A-O4"}
    outcome = cycle_of(data)
    assert not outcome.failures
    run = outcome.result.run
    t = fine(run)
    crank, rocker = at(run, "crank.angle", t), at(run, "rocker.angle", t)
    k = (100 - 40) / (100 + 40)
    assert np.sin(rocker / 2) * np.cos(crank / 2) * k == pytest.approx(
        -np.sin(crank / 2) * np.cos(rocker / 2), abs=1e-11
    )
    assert rocker[-1] - rocker[0] == pytest.approx(-2 * TURN, abs=1e-11)
    half = crank / 2  # tan(rocker/2) = -tan(half)/k, differentiated
    rate = -k / (k**2 * np.cos(half) ** 2 + np.sin(half) ** 2) * TURN
    assert at(run, "rocker.omega", t) == pytest.approx(rate, rel=1e-10)


def test_instant_centres_are_told_in_the_band_or_blank() -> None:
    """Kennedy: that of crank and rocker is on the ground line, at w_c x = w_r (x - d); of parallel cranks, none."""
    data = parallelogram()
    data["assembly"] = {"B": "right of A-O4"}
    run = cycle_of(data).result.run
    t = fine(run)
    crank, rocker = at(run, "crank.omega", t), at(run, "rocker.omega", t)
    assert at(run, "pole(crank, rocker).y", t) == pytest.approx(0, abs=1e-9)
    assert at(run, "pole(crank, rocker).x", t) == pytest.approx(-0.1 * rocker / (crank - rocker), rel=1e-8)
    run = cycle_of(parallelogram()).result.run
    assert not np.isfinite(at(run, "pole(crank, rocker).x", fine(run))).any()


def test_a_slider_crank_with_a_rod_as_long_as_its_crank() -> None:
    """C.x = 2 r cos(angle), through C = A at 90 and 270 deg."""
    data = slider_crank(50, 50, 0)
    data["studies"]["cycle"]["through"] = "keep"
    outcome = cycle_of(data)
    run = outcome.result.run
    t = fine(run)
    angle = TURN * t
    assert codes(outcome.failures) == []
    assert at(run, "C.x", t) == pytest.approx(0.1 * np.cos(angle), abs=1e-13)
    assert at(run, "C.vx", t) == pytest.approx(-0.1 * TURN * np.sin(angle), abs=1e-11)
    assert at(run, "C.ax", t) == pytest.approx(-0.1 * TURN**2 * np.cos(angle), abs=1e-9)
    # Here the forces have limits: torque by the virtual power of the masses.
    # Rod's middle at (0.075 cos, 0.025 sin); crank and rod turn at constant speed.
    power = TURN**3 * np.sin(angle) * np.cos(angle) * (1.2 * 0.1**2 + 0.8 * (0.075**2 - 0.025**2))
    assert at(run, "motor.power", t) == pytest.approx(power, abs=1e-9 * np.abs(power).max())


def test_a_piston_drives_its_crank_through_both_dead_centres() -> None:
    """The law is the slider-crank's own travel: the crank turns on evenly, where its speed can't be told by s alone."""
    data = slider_crank(50, 160, 0)
    s = "50 mm*cos(360 deg*t/(1 s)) + sqrt((160 mm)^2 - (50 mm*sin(360 deg*t/(1 s)))^2)"
    data["drives"] = {"piston": {"slides": "slider", "on": "frame", "position": s}}
    data["assembly"] = {"B": "right of A-C"}
    data["studies"] = {"cycle": {"period": "1 s", "samples": 40, "through": "keep"}}
    outcome = cycle_of(data)
    assert not outcome.failures
    run = outcome.result.run
    t = np.linspace(0, 1, 501)
    turned = at(run, "crank.omega", t)
    assert turned == pytest.approx(np.full(501, turned[0]), rel=1e-9)
    assert abs(turned[0]) == pytest.approx(TURN, rel=1e-9)
    assert at(run, "crank.alpha", t) == pytest.approx(0, abs=1e-6)


# Several groups at once.


def six_bar(arm: str) -> dict[str, Any]:
    """Two parallelograms in a row; the arm of the second crank is turned against the first rocker."""
    links = {
        "frame": {"points": {"O2": [0, 0], "O4": [100, 0], "O6": [220, 0]}},
        "crank": {"points": {"O2": [0, 0], "A": [40, 0]}, "mass": 0.2, "shape": "rod O2-A"},
        "coupler": {"points": {"A": [0, 0], "B": [100, 0]}, "mass": 0.5, "shape": "rod A-B"},
        "rocker": {"points": {"O4": [0, 0], "B": [40, 0], "C": f"50 at {arm}"}, "mass": 0.3, "shape": "rod O4-B"},
        "second": {"points": {"C": [0, 0], "D": [120, 0]}, "mass": 0.4, "shape": "rod C-D"},
        "follower": {"points": {"O6": [0, 0], "D": [50, 0]}, "mass": 0.3, "shape": "rod O6-D"},
    }
    return {
        **parallelogram(),
        "links": links,
        "parameters": {},
        "assembly": {"B": "left of A-O4", "D": "left of C-O6"},
    }


@pytest.mark.parametrize(("arm", "count"), [("0 deg", 4), ("90 deg", 8)])
def test_two_parallelograms_in_a_row(arm: str, count: int) -> None:
    """In line at the same instants, or a quarter of a turn apart."""
    outcome = cycle_of(six_bar(arm))
    assert not outcome.failures
    run = outcome.result.run
    assert len(run.compiled.passages.every) == count
    t = fine(run)
    for name in ("coupler.angle", "second.angle"):
        assert at(run, name, t) == pytest.approx(0, abs=1e-11)
    assert at(run, "follower.omega", t) == pytest.approx(TURN, rel=1e-9)
    assert at(run, "follower.alpha", t) == pytest.approx(0, abs=1e-7 * TURN**2)
    assert outcome.result.certificate is not None
    assert outcome.result.certificate.sound()


def test_change_points_too_near_each_other_are_refused() -> None:
    outcome = cycle_of(six_bar("1 deg"))
    assert set(codes(outcome.failures)) == {"motion.cannot-carry"}
    assert all(speakable(f) for f in outcome.failures)


# Forces.


def test_forces_that_grow_without_bound_are_named_and_have_no_value_there(tmp_path: Any) -> None:
    data = parallelogram("0 deg", turns=1, samples=8)
    data["measures"] = {
        "pull": {"max": "abs(force(rocker, coupler).x)"},
        "away": {"max": "abs(force(rocker, coupler).x)", "window": "before"},
        "torque": {"max": "motor.torque"},
    }
    data["windows"] = {"before": ["0.1 s", "0.4 s"]}
    job = job_of(data)
    outcome = job.cycle
    assert outcome is not None
    assert codes(outcome.failures) == ["measure.unbounded"]
    assert outcome.failures[0].path == ("measures", "pull")
    assert [(found.value, found.time) for found in outcome.measures[0].found] == [(np.inf, 0.0)]
    told = [f for f in outcome.warnings if f.code == "motion.unbounded-forces"]
    assert [float(f.data["value"]) for f in told] == pytest.approx([0, 180, 360])
    assert all(
        "force(coupler, rocker).x" in str(f.data["signals"]) and "torque" not in str(f.data["signals"]) for f in told
    )
    assert all(speakable(f) for f in outcome.warnings)
    result = outcome.result
    for name in ("force(coupler, rocker).x", "force(rocker, coupler).x"):
        assert np.isnan(result[name]).tolist() == [i % 4 == 0 for i in range(9)]
    for name in ("force(coupler, rocker).y", "motor.torque", "shaking.x"):
        assert np.isfinite(result[name]).all()
    assert result.certificate is not None
    assert result.certificate.sound()
    write(job, tmp_path)
    assert "nan" not in (tmp_path / "cycle.csv").read_text("utf-8")


def test_the_pull_of_the_coupler_by_moments() -> None:
    """Coupler and rocker cut free: moments about A and O4 give the force at B in closed form, pole and all."""
    run = cycle_of(parallelogram()).result.run
    t = run.compiled.passages.every[0].time + np.array([-0.02, -1e-3, -1e-6, 1e-6, 1e-3, 0.02])
    angle, g = math.radians(30) + TURN * t, 9.80665
    fy = -0.5 * (g - 0.04 * TURN**2 * np.sin(angle)) / 2  # the coupler about A: half its weight and inertia
    # Rocker about O4: r x F - m g r/2 cos = 0 at constant speed.
    fx = (0.04 * np.cos(angle) * fy - 0.3 * g * 0.02 * np.cos(angle)) / (0.04 * np.sin(angle))
    assert at(run, "force(coupler, rocker).y", t) == pytest.approx(fy, rel=1e-9)
    assert at(run, "force(coupler, rocker).x", t) == pytest.approx(fx, rel=1e-8)
    step = 1e-30j  # complex step: the rate of the same formula
    z = math.radians(30) + TURN * (t + step)
    force = -0.5 * (g - 0.04 * TURN**2 * np.sin(z)) / 2
    rate = (np.cos(z) * (0.04 * force - 0.3 * g * 0.02) / (0.04 * np.sin(z))).imag / step.imag
    assert run.rates(["force(coupler, rocker).x"], t)[1][0] == pytest.approx(rate, rel=1e-7)


# Near and not met.


@pytest.mark.parametrize("power", range(-15, -2))
@pytest.mark.parametrize("which", "abcd")
def test_a_length_that_is_off_is_kept_or_told(power: int, which: str) -> None:
    """Within round-off a parallelogram, else told to be none: never an antiparallelogram in silence."""
    for sign in (1, -1):
        lengths = {"a": 40.0, "b": 100.0, "c": 40.0, "d": 100.0}
        lengths[which] *= 1 + sign * 10.0**power
        drives = {"motor": {**CRANK, "start": f"{90 + 5 * power} deg"}}
        studies = {"cycle": {"turns": "1 motor", "samples": 20, "through": "keep"}}
        outcome = cycle_of(four_bar(**lengths, drives=drives, studies=studies))
        if outcome.failures:
            assert power >= -13
            told = {"motion.cannot-assemble", "motion.cannot-carry", "motion.unproven"}
            assert set(codes(outcome.failures)) <= told
        elif np.abs(outcome.result["coupler.angle"]).max() > 1e-9:
            assert "motion.near-change-point" in codes(outcome.warnings)
        else:
            assert power <= -13


def test_stop_names_the_choice() -> None:
    outcome = cycle_of(parallelogram(through="stop"))
    assert codes(outcome.failures) == ["motion.singular"] * 4
    assert all("through: keep" in f.mend and "third crank" in f.mend for f in outcome.failures)


def test_the_start_in_a_change_point_is_told() -> None:
    outcome = cycle_of(parallelogram("0 deg"))
    (start,) = [f for f in outcome.warnings if f.code == "motion.starts-at-change-point"]
    assert "left of A-O4" in start.what


@pytest.mark.parametrize(
    "law",
    [
        "150 deg + 30 deg*sin(360 deg*t/(1 s))",  # turns back there
        "step5(t, 0.2 s, 150 deg, 0.6 s, 180 deg)",  # rests there
        "step5(t, 0.2 s, 180 deg, 0.6 s, 250 deg)",  # starts from there
    ],
)
def test_a_drive_that_stays_or_turns_back_there_is_refused(law: str) -> None:
    data = parallelogram()
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "position": law}}
    data["studies"] = {"cycle": {"duration": "1 s", "through": "keep"}}
    outcome = cycle_of(data)
    assert set(codes(outcome.failures)) == {"motion.cannot-carry"}
    assert all(speakable(f) for f in outcome.failures)


def test_a_lever_whose_block_passes_its_pivot_turns_at_half_the_speed() -> None:
    """The crank pin passes through the pivot: an isosceles triangle, the lever square to its axis. The lever's inertia
    does no work at constant speed."""
    data = {
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [50, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [50, 0]}},
            "block": {"points": {"B": [0, 0]}},
            "lever": {"points": {"D": [0, 0]}, "mass": 1, "com": [0, 0], "inertia": 100},
        },
        "joints": {"slot": {"prismatic": ["lever", "block"], "line": ["D at 0 deg", "B at 0 deg"]}},
        "assembly": {"B": "ahead of D along slot"},
        "drives": {"motor": {**CRANK, "start": "90 deg"}},
        "studies": {"cycle": {"turns": "1 motor", "through": "keep"}},
    }
    outcome = cycle_of(data)
    assert not outcome.failures
    run = outcome.result.run
    (passage,) = run.compiled.passages.every
    assert passage.time == pytest.approx(0.75, abs=1e-12)
    t = fine(run)
    angle = math.pi / 2 + TURN * t
    assert at(run, "lever.angle", t) == pytest.approx(angle / 2 + math.pi / 2, abs=1e-11)
    assert at(run, "slot.s", t) == pytest.approx(0.1 * np.sin(angle / 2), abs=1e-12)
    assert at(run, "lever.omega", t) == pytest.approx(TURN / 2, rel=1e-10)
    assert at(run, "motor.torque", t) == pytest.approx(0, abs=1e-9)


def test_a_rhombus_stays_one_where_its_pins_meet() -> None:
    """At 0 deg the crank pin meets the rocker's pivot: coupler and rocker may turn about it as they like, and go on as
    a parallelogram."""
    run = cycle_of(parallelogram("90 deg", 40, 40, 2)).result.run
    assert [p.time for p in run.compiled.passages.every] == pytest.approx([0.25, 0.75, 1.25, 1.75], abs=1e-12)
    t = fine(run)
    assert at(run, "rocker.angle", t) == pytest.approx(math.pi / 2 + TURN * t, abs=1e-11)
    assert at(run, "rocker.omega", t) == pytest.approx(TURN, rel=1e-10)
    assert at(run, "coupler.angle", t) == pytest.approx(0, abs=1e-11)


def test_pins_that_meet_stop_a_motion_without_keep() -> None:
    outcome = cycle_of(parallelogram("90 deg", 40, 40, 1, through="stop"))
    assert codes(outcome.failures) == ["motion.singular"] * 2
    assert [float(f.data["value"]) for f in outcome.failures] == pytest.approx([180, 360])


def test_a_beam_on_two_rails_is_singular_in_all_poses() -> None:
    """Pinned to two slides exactly its length apart: the links are in line across the rails all the time."""
    data = {
        "units": UNITS,
        "links": {
            "frame": {"points": {"F1": [0, 0], "F2": [800, 0]}},
            "s1": {"points": {"T1": [0, 0]}},
            "s2": {"points": {"T2": [0, 0]}},
            "beam": {"points": {"T1": [0, 0], "T2": [800, 0]}},
        },
        "joints": {
            f"g{i}": {"prismatic": ["frame", f"s{i}"], "line": [f"F{i} at 90 deg", f"T{i} at 90 deg"]} for i in (1, 2)
        },
        "assembly": {"T2": "ahead of T1 along g2"},
        "drives": {"ram": {"slides": "s1", "on": "frame", "position": "300 mm + 50 mm*t/(1 s)"}},
        "studies": {"cycle": {"duration": "2 s", "through": "keep"}},
    }
    for through in ("keep", "stop"):
        data["studies"]["cycle"]["through"] = through
        (failure,) = cycle_of(data).failures
        assert failure.code == "motion.singular-throughout"
        assert speakable(failure)


@pytest.mark.parametrize("lengths", [(40, 80, 60, 100), (40, 120, 60, 100), (37.3, 111.9, 81.1, 155.7)])
def test_four_bars_with_one_change_point(lengths: tuple[float, ...]) -> None:
    """a + d = b + c, or d - a = c - b reversed: one change of sides a turn, so that only two turns close."""
    drives = {"motor": {**CRANK, "start": "77 deg"}}
    studies = {"cycle": {"turns": "2 motor", "samples": 72, "through": "keep"}}
    outcome = cycle_of(four_bar(*lengths, drives=drives, studies=studies))
    assert not outcome.failures
    run = outcome.result.run
    t = fine(run)
    x, y = at(run, "B.x", t) - lengths[3] / 1e3, at(run, "B.y", t)
    ax, ay = at(run, "A.x", t), at(run, "A.y", t)
    assert np.hypot(x, y) == pytest.approx(lengths[2] / 1e3, rel=1e-12)
    assert np.hypot(at(run, "B.x", t) - ax, y - ay) == pytest.approx(lengths[1] / 1e3, rel=1e-12)
    start, half, end = outcome.result["B.y"][[0, 36, 72]]
    assert end == pytest.approx(start, abs=1e-12)
    assert abs(half - start) > 1e-3


# The certificate and the way the branch is carried.


def test_the_certificate_says_where_the_branch_changes() -> None:
    job = job_of(parallelogram())
    assert job.cycle is not None
    certificate = job.cycle.result.certificate
    assert certificate is not None
    times = [5 / 12 + k / 2 for k in range(4)]
    assert certificate.changes == {"coupler-rocker": pytest.approx(times, abs=1e-12)}
    assert "0.416667" in str(certificate.branches["coupler-rocker"])
    assert job.summary["certificate"]["branch_changes"]["coupler-rocker"] == pytest.approx(times, abs=1e-12)


def test_the_branch_over_time() -> None:
    first, second = (Passage(time, ("g",), 0.1, at_start=time == 0) for time in (0.0, 1.0))
    passages = Passages((first, second))
    assert passages.sign("g", np.array([-0.5, 0.5, 1.5])).tolist() == [-1.0, 1.0, -1.0]
    assert passages.sign("other", np.array([0.5, 1.5])).tolist() == [1.0, 1.0]


@pytest.mark.parametrize("pole", [0, 1, 2])
def test_interpolation_of_what_is_known_outside_the_band(pole: int) -> None:
    passage = Passage(3.0, ("g",), 0.4)
    t = 3.0 + GAP * 0.4 * np.linspace(-0.99, 0.99, 12)
    assert passage.inside(t).all()
    assert not passage.inside(passage.nodes).any()

    def f(t: np.ndarray) -> np.ndarray:
        return np.exp(np.sin(t)) / (t - 3.0) ** pole

    assert passage.between(t, f(passage.nodes)[None], pole)[0] == pytest.approx(f(t), rel=1e-11)


# Verification: round-off beside change points is no contradiction, nor do equal steps hide the mobility.


def test_a_constant_rate_is_verified() -> None:
    """Right values, and closed forms that lose digits beside the change points."""
    data = parallelogram("30 deg", 60, 180, 1, samples=240)
    data["measures"] = {"w": {"extremes": "rocker.omega"}, "a": {"extremes": "rocker.alpha"}, "lag": {"max": LAG}}
    outcome = cycle_of(data)
    assert codes(outcome.failures) == []
    (w, _, _) = outcome.measures
    assert [figure.value for figure in w.found] == pytest.approx([TURN] * 2, rel=1e-11)


LAG = "abs(rocker.angle - crank.angle)"


def test_a_row_of_louvres() -> None:
    """Twelve slats of 0.5 kg and 40 mm, each a uniform rod: the torque is 12 m g (c/2) cos(angle)."""
    slats, pitch = 12, 90
    links: dict[str, Any] = {"frame": {"points": {f"A{i}": [0, pitch * i] for i in range(slats)}}}
    for i in range(slats):
        points = {f"A{i}": [0, 0], f"B{i}": [40, 0]}
        links[f"s{i}"] = {"points": points, "mass": 0.5, "shape": f"rod A{i}-B{i}"}
    for i in range(slats - 1):
        links[f"r{i}"] = {"points": {f"B{i}": [0, 0], f"B{i + 1}": [pitch, 0]}}
    data = {
        "units": UNITS,
        "gravity": "earth",
        "links": links,
        "assembly": {f"B{i}": [35, pitch * i + 20] for i in range(1, slats)},
        "drives": {"motor": {"turns": "s0", "on": "frame", "speed": "60 rpm", "start": "30 deg"}},
        "measures": {"tq": {"extremes": "motor.torque"}, "lag": {"max": "abs(s11.angle - s0.angle)"}},
        "studies": {"cycle": {"turns": "1 motor", "samples": 100, "through": "keep"}},
    }
    outcome = cycle_of(data)
    assert codes(outcome.failures) == []
    most = slats * 0.5 * 9.80665 * 0.02
    assert [figure.value for figure in outcome.measures[0].found] == pytest.approx([-most, most], rel=1e-9)


@pytest.mark.parametrize("turns", [1, 2, 4, 8])
def test_mobility_isnt_taken_at_change_points_alone(turns: int) -> None:
    outcome = cycle_of(parallelogram("0 deg", 60, 180, turns, samples=100))
    assert not outcome.failures
    assert outcome.result.certificate is not None
    assert outcome.result.certificate.mobility == 1


def test_a_wrong_extreme_beside_a_change_point_is_still_seen() -> None:
    """The digits lost there are measured: they excuse no more."""
    data = parallelogram("30 deg", 60, 180, 1, samples=240)
    data["measures"] = {"w": {"extremes": "rocker.omega"}, "x": {"max": "B.x"}}
    run = cycle_of(data).result.run
    measurer = Measurer(run)
    results = measurer.all()
    assert (misfit(measurer, results) or 0.0) < 1e-9
    for result in results:
        top = result.found[-1]
        low = replace(top, value=top.value * (1 - 1e-9))
        wrong = [replace(result, found=(*result.found[:-1], low))]
        assert (misfit(measurer, wrong) or 0.0) > 1e-9


@pytest.mark.parametrize("driven", ["w1", "w2", "w3"])
@pytest.mark.parametrize("start", [30, 90])
def test_a_third_crank_in_line_goes_along_over_a_full_turn(driven: str, start: int) -> None:
    """Three coupled wheels, whichever is driven: all turn alike. The rod's weight hangs on the middle pin, so that in
    line only the middle wheel can hold it: driven at an end, forces grow without bound there, and none is reported at
    that instant."""
    angle = math.radians(start)
    pins = {f"K{i + 1}": [149 * i + 30 * math.cos(angle), 30 * math.sin(angle)] for i in range(3)}
    wheels = {
        f"w{i}": {"points": {f"O{i}": [0, 0], f"K{i}": [30, 0]}, "mass": 2, "com": [0, 0], "inertia": 4900}
        for i in (1, 2, 3)
    }
    rod = {"points": {"K1": [0, 0], "K2": [149, 0], "K3": [298, 0]}, "mass": 1, "com": [149, 0], "inertia": 1000}
    data = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "gravity": "earth",
        "links": {"frame": {"points": {f"O{i + 1}": [149 * i, 0] for i in range(3)}}, **wheels, "rod": rod},
        "assembly": pins,
        "drives": {"motor": {"turns": driven, "on": "frame", "speed": "60 rpm", "start": f"{start} deg"}},
        "studies": {"cycle": {"turns": "1 motor", "samples": 36, "through": "keep"}},
    }
    job = job_of(data)
    assert job.exit_code == 0
    result = job.outcomes["cycle"].result
    assert result.certificate.equilibrium < 1e-9
    for wheel in wheels:
        assert result[f"{wheel}.omega"] == pytest.approx(2 * math.pi, rel=1e-9)
    # The power of the weight of the rod, which moves along a circle of 30 mm.
    torque = 9.80665 * 0.03 * np.cos(angle + 2 * math.pi * result.t)
    known = np.isfinite(result["motor.torque"])
    assert known.sum() >= 35
    assert result["motor.torque"][known] == pytest.approx(torque[known], abs=1e-9)
