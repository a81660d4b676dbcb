"""Scissor lifts of many stages, raised at the platform: one group, against the geometry of one stage."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from studies.models import UNITS, job_of

BAR, START, SPEED, DURATION = 1.0, math.radians(15), 0.02, 2.0
"""Length of the bars (m), their angle at the start, speed of the platform (m/s), how long it is raised (s)."""


def lift(stages: int) -> dict[str, Any]:
    """The lower right end rolls on the ground, the upper right one under the platform; the platform is raised."""
    width, height = 1e3 * BAR * math.cos(START), 1e3 * BAR * math.sin(START)
    sketch = {f"A{i}": [0.0, i * height] for i in range(stages + 1)}
    sketch |= {f"B{i}": [width, i * height] for i in range(stages + 1)}
    sketch |= {f"M{i}": [width / 2, (i + 0.5) * height] for i in range(stages)}
    links: dict[str, Any] = {"frame": {"points": {"A0": "sketch", "R": [0, 0]}}}
    for i in range(stages):
        links[f"up{i}"] = {"points": [f"A{i}", f"B{i + 1}", f"M{i}"], "mass": 10, "shape": f"rod A{i}-B{i + 1}"}
        links[f"down{i}"] = {"points": [f"B{i}", f"A{i + 1}", f"M{i}"], "mass": 10, "shape": f"rod B{i}-A{i + 1}"}
    links["platform"] = {"points": {f"A{stages}": [0, 0], "C": [500, 0]}, "mass": 50, "com": [500, 0], "inertia": 4e6}
    top = f"{stages * height!r} mm + {1e3 * SPEED} mm*t/(1 s)"
    return {
        "linkwright": 1,
        "units": UNITS,
        "gravity": "earth",
        "sketch": sketch,
        "links": links,
        "joints": {
            "rail": {"pin_in_slot": ["down0", "frame"], "pin": "B0", "straight": "R at 0 deg"},
            "top": {
                "pin_in_slot": [f"up{stages - 1}", "platform"],
                "pin": f"B{stages}",
                "straight": f"A{stages} at 0 deg",
            },
        },
        "drives": {
            "ram": {"moves": "platform", "at": f"A{stages}", "on": "frame", "along": "R at 90 deg", "position": top}
        },
        "loads": {"weight": {"on": "platform", "at": "C", "force": [0, -1000]}},
        "studies": {"cycle": {"duration": f"{DURATION} s", "samples": 20}},
    }


def ram_force(stages: int, times: np.ndarray) -> np.ndarray:
    """What the ram pushes with (N), by the power of weights and of the kinetic energy."""
    bar, rate = BAR, SPEED / stages
    sine = math.sin(START) + rate * times / bar
    cosine = np.sqrt(1 - sine**2)
    turn, turned = rate / (bar * cosine), sine * rate**2 / (bar**2 * cosine**3)  # of the bars: angular speed, its rate
    # Two bars a stage: their centres rise with the middle of the stage and shift sideways by half the roller's way.
    lifted = 2 * 10 * sum(i + 0.5 for i in range(stages))
    weight = (lifted / stages + 50) * 9.80665 + 1000
    inertia = 10 * bar**2 / 12
    across, across_rate = -bar * sine * turn / 2, -bar * (cosine * turn**2 + sine * turned) / 2
    kinetic_rate = 2 * stages * (10 * across * across_rate + inertia * turn * turned)
    return weight + kinetic_rate / SPEED


@pytest.mark.parametrize("stages", [1, 2, 3, 4, 6, *(pytest.param(n, marks=pytest.mark.long) for n in (5, 8, 10, 12))])
def test_the_margin_does_not_shrink_with_the_stages(stages: int) -> None:
    job = job_of(lift(stages))
    assert job.exit_code == 0
    run = job.cycle.result
    bars = np.arcsin(math.sin(START) + SPEED / stages * run.t / BAR)
    width = BAR * np.cos(bars)
    assert np.abs(run["B0.x"] - width).max() < 1e-10
    assert np.abs(run["up0.angle"] - bars).max() < 1e-9
    assert np.abs(run["B0.vx"] + SPEED / stages * np.tan(bars)).max() < 1e-10
    assert run["ram.force"] == pytest.approx(ram_force(stages, run.t), rel=1e-9)
    # The product of the columns' lengths lies far above the determinant of many equations: 1e-9 for ten stages.
    nearest = run.certificate.nearest
    assert 0.03 < nearest.determinant <= 1.0
