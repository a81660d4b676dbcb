"""What a radius does doesn't depend on how the axes of the wheel's link are drawn.

The closure counts from the pose in which the wheels are drawn. It was kept as a length: with another radius, which
samples have, that turned the wheel by an angle that depends on its axes (0.247 mm became 0.330 mm).
"""

from __future__ import annotations

import math
from typing import Any

import pytest

from studies.models import UNITS, job_of

ARM = {"points": {"A": [0, 0], "B": [90, 0]}}
MOTOR = {"turns": "arm", "on": "frame", "speed": "60 rpm", "start": "0 deg"}


def mark(x: float, y: float, axes: float) -> list[float]:
    """A place at (x, y) from the wheel's centre in the drawing, in axes that lie at an angle (rad)."""
    return [x * math.cos(axes) + y * math.sin(axes), y * math.cos(axes) - x * math.sin(axes)]


def rolling_on_a_line(axes: float) -> dict[str, Any]:
    return {
        "links": {
            "frame": {"points": {"A": [0, 60], "G": [300, 0]}},
            "arm": ARM,
            "rod": {"points": {"B": [0, 0], "C": [260, 0]}},
            "wheel": {"points": {"C": [0, 0], "P": mark(0, -50, axes)}},
        },
        "joints": {"ground": {"rolling": ["wheel", "frame"], "centre": "C", "radius": "r", "on_line": "G at 0 deg"}},
        "assembly": {"C": [350, 60], "P": [350, 10]},
        "drives": {"motor": MOTOR},
    }


def rolling_on_a_circle(axes: float) -> dict[str, Any]:
    ring = {"rolling": ["wheel", "frame"], "centre": "C", "radius": "r", "on_circle": {"centre": "E", "radius": 40}}
    model = rolling_on_a_line(axes)
    model["links"]["frame"]["points"]["E"] = [350, -40]
    return {**model, "joints": {"ring": ring}}


def rack(axes: float) -> dict[str, Any]:
    """A slider-crank whose slider is a rack for a wheel on the frame."""
    return {
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [350, 60], "G": [0, 0]}},
            "arm": ARM,
            "rod": {"points": {"B": [0, 0], "C": [260, 0]}},
            "bar": {"points": {"C": [0, 0]}},
            "wheel": {"points": {"D": [0, 0], "P": mark(0, -50, axes)}},
        },
        "joints": {
            "guide": {"prismatic": ["frame", "bar"], "line": ["G at 0 deg", "C at 0 deg"]},
            "mesh": {"rack": ["wheel", "bar"], "centre": "D", "radius": "r", "pitch_line": "C at 0 deg"},
        },
        "assembly": {"C": [350, 0], "P": [350, 10]},
        "drives": {"motor": MOTOR},
    }


def gear(axes: float, joint: dict[str, Any]) -> dict[str, Any]:
    """A crank with a wheel that turns another one on the frame."""
    return {
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [150, 0]}},
            "arm": ARM,
            "wheel": {"points": {"D": [0, 0], "P": mark(0, -50, axes)}},
        },
        "joints": {"mesh": joint},
        "assembly": {"P": [150, -50]},
        "drives": {"motor": MOTOR},
    }


def gears(axes: float) -> dict[str, Any]:
    return gear(axes, {"gears": ["arm", "wheel"], "centres": ["A", "D"], "radii": ["r", "150 mm - r"]})


def belt(axes: float) -> dict[str, Any]:
    return gear(axes, {"belt": ["arm", "wheel"], "centres": ["A", "D"], "radii": ["r", 40]})


MODELS = [rolling_on_a_line, rolling_on_a_circle, gears, belt, rack]


@pytest.mark.parametrize("model", MODELS)
def test_coefficients_of_radii_do_not_depend_on_axes(model: Any) -> None:
    every = []
    for axes in (0.0, 1.0, -2.5):
        data = {
            "units": UNITS,
            "parameters": {"r": {"value": 60, "tolerance": 0.1}},
            **model(axes),
            "studies": {"cycle": {"duration": "0.15 s", "samples": 8}, "accuracy": {"outputs": ["P.x"], "samples": 0}},
        }
        job = job_of(data)
        assert job.exit_code == 0
        every.append(job.outcomes["accuracy"].curves["P.x"].coefficients)
    assert abs(every[0]).max() > 0.01
    for other in every[1:]:
        assert other == pytest.approx(every[0], abs=1e-9)


def test_coefficients_of_a_wheel_on_a_line_are_those_of_its_geometry() -> None:
    """P = C + 50 mm at an angle of (x - x0) / r from straight down, and C as high as r over the line."""
    data = {
        "units": UNITS,
        "parameters": {"r": {"value": 60, "tolerance": 0.1}},
        **rolling_on_a_line(1.0),
        "studies": {"cycle": {"turns": "1 motor", "samples": 8}, "accuracy": {"outputs": ["P.x"], "samples": 0}},
    }
    curve = job_of(data).outcomes["accuracy"].curves["P.x"]

    def place(time: float, r: float) -> float:
        bx, by = 90 * math.cos(2 * math.pi * time), 60 + 90 * math.sin(2 * math.pi * time)
        x = bx + math.sqrt(260**2 - (r - by) ** 2)
        return x - 50 * math.sin((x - 350) / r)

    for time, coefficient in zip(curve.t.tolist(), curve.coefficients[0].tolist(), strict=True):
        slope = (place(time, 60.001) - place(time, 59.999)) / 0.002
        assert coefficient == pytest.approx(slope, abs=1e-6)
