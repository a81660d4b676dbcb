"""What `check` and the report say of drives, springs and gravity."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import four_bar, slider_crank
from helpers.heat_seal import heat_seal
from linkwright.report import understood

DEG = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}


def said(**law: Any) -> str:
    drives = {"motor": {"turns": "crank", "on": "frame", **law}}
    (text,) = map(str, understood.drives(compiled_from(four_bar(units=DEG, drives=drives))))
    return text


@pytest.mark.parametrize(
    ("law", "text"),
    [
        ({"speed": 45, "start": 90}, "45 deg/s = 7.5 rpm, 8 s per revolution, starts at 90 deg"),
        ({"speed": "-40 rpm", "start": 0}, "-240 deg/s = -40 rpm, 1.5 s per revolution, starts at 0 deg"),
        ({"speed": 0, "start": 30}, "fixed at 30 deg"),
        (
            {"speed": 6, "start": 30, "acceleration": 5},
            "starts at 30 deg with 6 deg/s = 1 rpm, acceleration 5 deg/s²",
        ),
        (
            {"position": "10 + 60*t/(1 s)"},
            "position 10 + 60*t/(1 s), starts at 10 deg with 60 deg/s = 10 rpm",
        ),
        ({"position": "10 + " + 30 * "0*" + "1"}, "position by its motion law, starts at 10 deg with 0 deg/s"),
    ],
)
def test_turning_drives(law: dict[str, Any], text: str) -> None:
    assert said(**law) == f"motor: crank on frame, {text}"


@pytest.mark.parametrize(
    ("position", "speed"),
    [
        ("30*cos(2*pi*t/(1 s))", "0 deg/s"),
        ("30*sin(2*pi*t/(1 s) + pi/2)", "0 deg/s"),  # 2e-16 of its maximum speed
        ("30 + 1e-9*t/(1 s)", "1e-09 deg/s = 1.66667e-10 rpm"),  # slow all the time
        ("exp(50*t/(1 s))", "2864.79 deg/s = 477.465 rpm"),  # soon much faster
    ],
)
def test_round_off_is_no_speed(position: str, speed: str) -> None:
    assert said(position=position).endswith(f" with {speed}")


def test_a_follower_that_begins_with_a_dwell_has_no_speed() -> None:
    *_, text = map(str, understood.drives(compiled_from(heat_seal())))
    assert text.endswith("starts at 140.725 deg with 0 deg/s")


def test_slides_cylinders_and_outputs() -> None:
    push = {"push": {"slides": "piston", "on": "frame", "speed": 20, "start": 3500}}
    sliding = compiled_from(slider_crank(units=DEG, assembly={"B": "left of A-C"}, drives=push, links=LINKS))
    assert [*map(str, understood.drives(sliding))] == ["push: piston on frame, 20 mm/s, starts at 3500 mm"]
    follows = {"motor": {"turns": "crank", "on": "frame", "output": "bore", "speed": 20, "start": 3500}}
    data = slider_crank(units=DEG, assembly={"B": "left of A-C"}, drives=follows, links=LINKS)
    assert [*map(str, understood.drives(compiled_from(data)))] == [
        "motor: crank on frame, such that bore follows the law, 20 mm/s, starts at 3500 mm"
    ]
    data = four_bar(units=DEG, cylinders={"ram": {"from": "A", "to": "C"}}, links=BAR)
    data["drives"] = {"pump": {"extends": "ram", "speed": 50, "start": 3500}}
    data["assembly"] = {"B": "left of A-C", "C": "left of A-D"}
    assert [*map(str, understood.drives(compiled_from(data)))] == ["pump: cylinder ram, 50 mm/s, starts at 3500 mm"]


LINKS = {
    "frame": {"points": {"A": [0, 0], "F": [0, 0]}},
    "crank": {"points": {"A": [0, 0], "B": [1000, 0]}},
    "rod": {"points": {"B": [0, 0], "C": [3000, 0]}},
    "piston": {"points": {"C": [0, 0]}},
}
BAR = {
    "frame": {"points": {"A": [0, 0], "D": [4000, 0]}},
    "crank": {"points": {"A": [0, 0], "B": [1000, 0]}},
    "coupler": {"points": {"B": [0, 0], "C": [3000, 0]}},
    "rocker": {"points": {"D": [0, 0], "C": [3000, 0]}},
}


def test_springs_at_the_start() -> None:
    """Hooke's law at the start pose, worked out here: B stands at (cos 30 deg, sin 30 deg) m, the spring's end at D."""
    springs = {
        "pull": {"from": "B", "to": "D", "stiffness": "2 N/mm", "free": 2000},
        "push": {"from": "B", "to": "D", "stiffness": "2 N/mm", "free": 4000},
        "wound": {"turns": "crank", "on": "frame", "stiffness": "3 N*m/rad", "free": 90},
    }
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": 360, "start": 30}}
    length = 1000 * np.hypot(4 - np.cos(np.pi / 6), np.sin(np.pi / 6))
    force = 2 * (length - np.array([2000, 4000]))
    compiled = compiled_from(four_bar(units=DEG, links=BAR, springs=springs, drives=drives))
    assert [*map(str, understood.acting(compiled)["springs"])] == [
        f"pull from B to D, pulls with {force[0]:.6g} N at the start",
        f"push from B to D, pushes with {-force[1]:.6g} N at the start",
        f"wound between crank and frame, turns crank counter-clockwise with {np.pi:.6g} N·m at the start",
    ]


@pytest.mark.parametrize(
    ("gravity", "text"),
    [
        (None, "none"),
        ([0, 0], "none"),
        ("earth", "9.80665 m/s² along -y"),
        ([0, -9.81], "0.00981 m/s² along -y"),
        (["2 m/s^2", 0], "2 m/s² along +x"),
        ("earth along [3, -4]", "9.80665 m/s² along [0.6, -0.8]"),
    ],
)
def test_gravity(gravity: Any, text: str) -> None:
    assert str(understood.gravity(compiled_from(four_bar(units=DEG, gravity=gravity)))) == text
