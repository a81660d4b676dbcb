"""Runs: continuous angles, windows of time that start anywhere, rates."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from helpers.examples import UNITS, feeder, four_bar, slider_crank
from linkwright.kernels import Compiled
from linkwright.results.run import Run

Array = NDArray[np.float64]


def drag_link() -> Compiled:
    """A drag link (ground the shortest): coupler and rocker turn right round with the crank."""
    return compiled_from(four_bar(3, 2.5, 3.2, 1))


@pytest.mark.parametrize("steps", [1, 7, 100, 1000])
def test_angles_run_on_over_several_turns(steps: int) -> None:
    compiled = drag_link()
    turns = 5
    run = Run(compiled, 0.0, turns * 2 * np.pi, steps)
    names = ["crank.angle", "coupler.angle", "rocker.angle"]
    crank, coupler, rocker = run.evaluate(names, np.array([0.0, run.stop]))
    assert crank[1] - crank[0] == pytest.approx(turns * 2 * np.pi, abs=1e-12)
    assert rocker[1] - rocker[0] == pytest.approx(turns * 2 * np.pi, abs=1e-10)
    assert coupler[1] - coupler[0] == pytest.approx(turns * 2 * np.pi, abs=1e-10)


def test_continuous_angles_are_the_integral_of_omega() -> None:
    run = Run(drag_link(), 0.0, 20.0, 50)
    t = np.linspace(0.0, 20.0, 4001)
    for link in ("crank", "coupler", "rocker"):
        angle, omega = run.evaluate([f"{link}.angle", f"{link}.omega"], t)
        assert np.abs(np.diff(angle)).max() < 0.1
        simpson = (omega[0] + 4 * omega[1:-1:2].sum() + 2 * omega[2:-1:2].sum() + omega[-1]) * (t[1] / 3)
        assert angle[-1] - angle[0] == pytest.approx(simpson, abs=1e-6)


def test_angles_do_not_depend_on_the_times_that_are_asked_for() -> None:
    """One instant alone, a few in any order, many: the same angle at the same time."""
    run = Run(drag_link(), 0.0, 30.0, 100)
    t = np.linspace(0.0, 30.0, 301)
    whole = run.evaluate(["rocker.angle"], t)[0]
    for i in (0, 17, 150, 299, 300):
        assert run.evaluate(["rocker.angle"], t[i : i + 1])[0, 0] == whole[i]
    shuffled = np.random.default_rng(1).permutation(t.size)
    assert np.array_equal(run.evaluate(["rocker.angle"], t[shuffled])[0], whole[shuffled])


def test_a_rocker_that_swings_past_half_a_turn_does_not_jump() -> None:
    """The feeder's rocker lies about 90 degrees; a rocker about 180 degrees crosses the cut of atan2."""
    data = four_bar(1, 3, 2, 3)
    data["links"]["rocker"]["points"]["C"] = [-2, 0]
    run = Run(compiled_from(data), 0.0, 2 * np.pi, 20)
    angle = run.evaluate(["rocker.angle"], np.linspace(0.0, 2 * np.pi, 721))[0]
    assert np.abs(np.diff(angle)).max() < 0.05
    assert angle[0] == pytest.approx(angle[-1], abs=1e-12)


def test_driven_angles_are_the_drive_s_own() -> None:
    """-40 rpm for three turns from 23.49 degrees: no wrapping anywhere."""
    run = Run(compiled_from(feeder()), 0.0, 4.5, 30)
    start = np.arctan2(61.78, 142.16)
    angle = run.evaluate(["crank.angle", "motor.angle"], run.t)
    assert np.allclose(angle, start - 40 * np.pi / 30 * run.t, atol=1e-12, rtol=0)


def test_translating_links_keep_their_angle() -> None:
    run = Run(compiled_from(slider_crank()), 0.0, 20.0, 30)
    assert not run.evaluate(["piston.angle", "piston.omega", "piston.alpha"], run.t).any()


def test_a_coarse_grid_still_counts_a_fast_link_s_turns() -> None:
    """As many turns as steps: from one sample to the next the link looks as if it stood still."""
    run = Run(drag_link(), 0.0, 200 * np.pi, 100)
    first, last = run.evaluate(["rocker.angle"], np.array([0.0, run.stop]))[0]
    assert last - first == pytest.approx(200 * np.pi, abs=1e-6)


def test_a_run_may_start_before_or_after_zero() -> None:
    compiled = compiled_from(feeder())
    names = ["E.x", "rocker.omega", "motor.torque"]
    t = np.array([0.7, 0.9])
    whole = Run(compiled, 0.0, 1.5, 100).evaluate(names, t)
    assert np.array_equal(Run(compiled, 0.6, 1.0, 10).evaluate(names, t), whole)
    again = Run(compiled, -1.5, 0.0, 10).evaluate(names, t - 1.5)
    assert np.allclose(again, whole, rtol=1e-9, atol=1e-9)


def test_sampled_times_have_both_ends() -> None:
    run = Run(compiled_from(feeder()), 0.25, 1.75, 6)
    assert np.array_equal(run.t, [0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75])


def test_rates_of_angles_are_omegas() -> None:
    run = Run(drag_link(), 0.0, 20.0, 40)
    names = [f"{link}.angle" for link in ("crank", "coupler", "rocker")]
    _, rates = run.rates(names, run.t)
    omegas = run.evaluate([name.replace("angle", "omega") for name in names], run.t)
    assert np.abs(rates - omegas).max() < 1e-11


def swung(position: str) -> Run:
    data = four_bar(drives={"motor": {"turns": "crank", "on": "frame", "position": position}})
    return Run(compiled_from(data), 0.0, 2.0, 100)


def test_a_drive_that_only_turns_back_needs_no_fine_grid() -> None:
    """Its speed is zero at the start, at 1 s and at the end, which are no rests."""
    assert swung("0.3*cos((3.141592653589793 rad/s)*t)").grid == 100
    assert swung("step5(t, 0 s, 0.1 rad, 2 s, 0.5 rad)").grid == 100


def test_a_short_move_needs_a_fine_grid() -> None:
    assert swung("step5(t, 1 s, 0.1 rad, 1.01 s, 0.5 rad)").grid > 1500


def test_a_drive_that_stands_still() -> None:
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {"frame": {"points": {"A": [0, 0]}}, "fan": {"points": {"A": [0, 0], "T": [1, 0]}}},
        "drives": {"motor": {"turns": "fan", "on": "frame", "position": "1 rad"}},
    }
    run = Run(compiled_from(data), 0.0, 1.0, 4)
    found = run.evaluate(["fan.angle", "fan.omega", "T.x", "T.vx"], run.t)
    assert np.allclose(found[:, 0], [1.0, 0.0, np.cos(1.0), 0.0], atol=1e-15)
    assert np.array_equal(found, np.repeat(found[:, :1], 5, axis=1))


def test_where_nothing_can_be_assembled_all_is_nan() -> None:
    """The rocker is too short for this part of the crank's turn: no angle, no position, and no exception."""
    run = Run(compiled_from(four_bar(2, 3, 1.2, 4)), 2.0, 2.4, 10)
    found = run.evaluate(["rocker.angle", "C.x"], run.t)
    assert np.isnan(found).all()
