"""Jumps and kinks of loads: found where they are, and looked at on both sides."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from linkwright.measures import measure_all
from linkwright.results import Run, certify


def wheel(**sections: Any) -> dict[str, Any]:
    """A wheel without mass that turns at 2 rad/s from 0."""
    data = {
        "linkwright": 1,
        "units": UNITS,
        "links": {"frame": {"points": {"A": [0, 0]}}, "wheel": {"points": {"A": [0, 0], "B": [1, 0]}}},
        "drives": {"motor": {"turns": "wheel", "on": "frame", "speed": 2, "start": 0}},
    }
    return data | sections


def run_of(stop: float = 2.0, steps: int = 7, **sections: Any) -> Run:
    return Run(compiled_from(wheel(**sections)), 0.0, stop, steps)


def brake(law: str, **more: Any) -> dict[str, Any]:
    return {"brake": {"on": "wheel", "torque": law, **more}}


@pytest.mark.parametrize(
    ("window", "edges"),
    [
        (["0.3 s", "0.9 s"], [0.3, 0.9]),
        (["0.3 s", "5 s"], [0.3]),
        (["0 s", "5 s"], []),
        ({"motor.angle": [1, 2]}, [0.5, 1.0]),
        ({"motor.angle": [5, 7]}, [(7 - 2 * np.pi) / 2]),  # 5 rad is beyond the run; 7 rad is a turn and 0.717
        ({"B.y": [0.5, 2]}, [np.pi / 12, 5 * np.pi / 12]),
        ({"wheel.angle": [1, 2]}, [0.5, 1.0]),
    ],
)
def test_a_window_jumps_at_its_ends(window: Any, edges: list[float]) -> None:
    run = run_of(loads=brake("-5", window="w"), windows={"w": window})
    assert run.jumps.mean(axis=1) == pytest.approx(edges, abs=1e-10)
    assert (np.diff(run.jumps, axis=1) < 1e-7).all()
    for before, after in run.jumps:
        torques = run.compiled.evaluate(["motor.torque"], np.array([before, after]))[0]
        assert sorted(torques) == pytest.approx([0.0, 5.0])


def test_extremes_are_taken_on_the_inner_side_of_a_jump() -> None:
    """A torque 5 + t within the window, none outside: its least value within is that right after the jump."""
    sections: dict[str, Any] = {
        "loads": brake("-5 - (1 N*m/s)*t", window="w"),
        "windows": {"w": ["0.3 s", "0.9 s"], "off": ["0.9 s", "2 s"]},
        "measures": {
            "within": {"extremes": "motor.torque", "window": "w"},
            "whole": {"extremes": "motor.torque"},
            "after": {"extremes": "motor.torque", "window": "off"},
            "mean": {"mean": "motor.torque"},
        },
    }
    run = run_of(**sections)
    measures, findings = measure_all(run)
    assert not findings
    values = [[found.value for found in m.found] for m in measures]
    assert values[0] == pytest.approx([5.3, 5.9], abs=1e-9)
    assert values[1] == pytest.approx([0.0, 5.9], abs=1e-9)
    assert values[2] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert values[3] == pytest.approx([(5 * 0.6 + (0.9**2 - 0.3**2) / 2) / 2.0], rel=1e-12)
    assert certify(run).sound(1e-12)


def test_the_points_of_a_linear_table_are_kinks() -> None:
    table = {"points": [[0, 0], ["0.5 rad", "3 N*m"], ["2 rad", "-1 N*m"], ["5 rad", "2 N*m"]], "between": "linear"}
    run = run_of(loads=brake("f(motor.angle)"), tables={"f": table})
    assert run.breaks == pytest.approx([0.25, 1.0], abs=1e-14)
    assert certify(run).sound(1e-12)


@pytest.mark.parametrize("close", [False, True])
def test_a_periodic_table_has_kinks_in_every_period_forwards_and_backwards(close: bool) -> None:
    points = [[0.2, 0], [0.5, 3], [0.9, -1], *([[1.2, 0]] if close else [])]
    table = {"points": [[f"{x} rad", f"{y} N*m"] for x, y in points], "between": "linear", "period": "1 rad"}
    law = "1.05 rad*sin((2 rad/s)*t)"
    run = run_of(
        stop=np.pi, loads=brake("f(motor.angle)"), tables={"f": table},
        drives={"motor": {"turns": "wheel", "on": "frame", "position": law}},
    )  # fmt: skip
    knots = [k + x for k in (-2, -1, 0, 1) for x in (0.2, 0.5, 0.9)]
    ups = [np.arcsin(x / 1.05) for x in knots if abs(x) < 1.05]
    expected = sorted(t % np.pi for a in ups for t in (a / 2, (np.pi - a) / 2))
    assert run.breaks == pytest.approx(expected, abs=1e-9)
    assert certify(run).sound(1e-11)


def test_kinks_of_functions() -> None:
    run = run_of(loads=brake("1 N*(max(0.3*B.y, 0.1) + abs(B.x) - min(2, 3))"))
    expected = [np.arcsin(1 / 3) / 2, np.pi / 4, (np.pi - np.arcsin(1 / 3)) / 2]
    assert run.breaks == pytest.approx(expected, abs=1e-12)
    assert certify(run).sound(1e-12)


def test_the_ends_of_a_drive_s_steps_are_kinks() -> None:
    """Its acceleration has corners there, and so has the torque."""
    law = "step5(t, 0.3 s, 0 rad, 0.7 s, 1 rad) + step5(t, 1.1 s, 0 rad, 1.6 s, -1 rad)"
    run = run_of(stop=2.0, drives={"motor": {"turns": "wheel", "on": "frame", "position": law}})
    assert run.breaks == pytest.approx([0.3, 0.7, 1.1, 1.6], abs=1e-14)


def test_without_varying_loads_there_are_none() -> None:
    run = run_of(loads=brake("-5"))
    assert run.breaks.size == 0
    assert run.jumps.shape == (0, 2)


def test_a_load_that_swings_in_step_with_the_samples_is_seen() -> None:
    """80 whole swings between two samples: each sample, and each of twice and four times as many, looks alike."""
    run = run_of(steps=200, loads=brake("-5 - 2 N*m*sin(2*pi*8000 Hz*t)"), measures={"m": {"extremes": "motor.torque"}})
    measures, _ = measure_all(run)
    assert [found.value for found in measures[0].found] == pytest.approx([3.0, 7.0], rel=1e-6)
