"""Scissor lifts of any number of stages under a platform that a mast guides, and their motion in closed form."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
LENGTH, ARM, PLATFORM, LOAD, G = 1.0, 10.0, 50.0, 1000.0, 9.81
START = math.radians(15.0)
SPEEDS = {"foot": 0.02, "arm": math.radians(1.0), "platform": 0.005}
"""By what is driven: the roller at the foot towards the mast (m/s), the first arm (rad/s), the platform upward, per
stage (m/s)."""


def lift(stages: int, driven: str) -> dict[str, Any]:
    """Arms a1, a2, ... rise to the right from the mast, b1, b2, ... to the left."""
    c, s = 1000 * math.cos(START), 1000 * math.sin(START)
    links: dict[str, Any] = {"frame": {"points": {"P0": [0, 0], "R": [0, 0], "H": [0, 0]}}}
    sketch = {"Q0": [c, 0.0]}
    for k in range(1, stages + 1):
        for name, tail, tip in ((f"a{k}", f"P{k - 1}", f"Q{k}"), (f"b{k}", f"Q{k - 1}", f"P{k}")):
            points = {tail: [0, 0], f"M{k}": ["L/2", 0], tip: ["L", 0]}
            links[name] = {"points": points, "mass": ARM, "shape": f"rod {tail}-{tip}"}
        sketch |= {f"M{k}": [c / 2, s * (k - 0.5)], f"P{k}": [0, s * k], f"Q{k}": [c, s * k]}
    top = {f"P{stages}": [0, 0], "S": [0, 0], "C": [400, 0]}
    links["platform"] = {"points": top, "mass": PLATFORM, "com": [400, 0], "inertia": 4e6}
    joints = {
        "rail": {"pin_in_slot": ["b1", "frame"], "pin": "Q0", "straight": "R at 0 deg"},
        "top": {"pin_in_slot": [f"a{stages}", "platform"], "pin": f"Q{stages}", "straight": "S at 0 deg"},
        "guide": {"pin_in_slot": ["platform", "frame"], "pin": "S", "straight": "H at 90 deg"},
    }
    foot = {"moves": "b1", "at": "Q0", "on": "frame", "along": "R at 0 deg", "position": f"{c!r} mm - 20 mm*t/(1 s)"}
    mast = {"moves": "platform", "at": "S", "on": "frame", "along": "H at 90 deg"}
    drives = {
        "foot": foot,
        "arm": {"turns": "a1", "on": "frame", "position": "15 deg + 1 deg*t/(1 s)"},
        "platform": {**mast, "position": f"{s * stages!r} mm + {stages}*5 mm*t/(1 s)"},
    }
    return {
        "units": UNITS, "gravity": [0, f"-{G} m/s^2"], "parameters": {"L": 1000}, "links": links, "joints": joints,
        "assembly": sketch, "drives": {"ram": drives[driven]},
        "loads": {"crate": {"on": "platform", "at": "C", "force": [0, -LOAD]}},
    }  # fmt: skip


def angle(driven: str, t: Any) -> tuple[Any, Any]:
    """The angle of the arms (rad) and its rate (rad/s)."""
    v = SPEEDS[driven]
    if driven == "arm":
        return START + v * t, v + 0.0 * t
    if driven == "foot":
        alpha = np.arccos(math.cos(START) - v * t / LENGTH)
        return alpha, v / (LENGTH * np.sin(alpha))
    alpha = np.arcsin(math.sin(START) + v * t / LENGTH)
    return alpha, v / (LENGTH * np.cos(alpha))


def energy(stages: int, driven: str, t: Any) -> Any:
    """Kinetic and potential energy, also of the crate (J)."""
    alpha, rate = angle(driven, t)
    kinetic: Any = 0.0
    potential: Any = 0.0
    for k in range(1, stages + 1):
        x, y = -LENGTH / 2 * np.sin(alpha), (k - 0.5) * LENGTH * np.cos(alpha)  # of the crossing, over the rate
        kinetic = kinetic + ARM * (x * x + y * y + LENGTH**2 / 12) * rate * rate
        potential = potential + 2 * ARM * G * (k - 0.5) * LENGTH * np.sin(alpha)
    rise = stages * LENGTH * np.cos(alpha) * rate
    kinetic = kinetic + PLATFORM / 2 * rise * rise
    return kinetic + potential + (PLATFORM * G + LOAD) * stages * LENGTH * np.sin(alpha)


def effort(stages: int, driven: str, t: np.ndarray) -> np.ndarray:
    """The drive's force (N) or torque (N m), from the energy's rate by a complex step."""
    speed = {"foot": -SPEEDS["foot"], "arm": SPEEDS["arm"], "platform": stages * SPEEDS["platform"]}[driven]
    return np.asarray(energy(stages, driven, t + 1e-30j).imag / 1e-30 / speed)
