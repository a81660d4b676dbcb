"""Small mechanisms that many tests start from, as the data of model files."""

from __future__ import annotations

import copy
from typing import Any

UNITS = {"length": "m", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}


def four_bar(a: float = 1, b: float = 3, c: float = 3, d: float = 4, **more: Any) -> dict[str, Any]:
    """Crank AB, coupler BC, rocker DC, ground AD (m), without masses; ``more`` replaces entries of the file."""
    data = {
        "linkwright": 1,
        "units": dict(UNITS),
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [d, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [a, 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [b, 0]}},
            "rocker": {"points": {"D": [0, 0], "C": [c, 0]}},
        },
        "assembly": {"C": "left of B-D"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 0.5}},
    }
    return data | more


def heavy_four_bar(**more: Any) -> dict[str, Any]:
    """The same with masses, gravity and a load."""
    data = four_bar(gravity=[0, -9.81], **more)
    data["links"]["crank"] |= {"mass": 1.5, "com": [0.4, 0.1], "inertia": 0.2}
    data["links"]["coupler"] |= {"mass": 2, "shape": "rod B-C"}
    data["links"]["rocker"] |= {"mass": 3, "com": [1, -0.3], "inertia": 1.1}
    data["loads"] = {"tool": {"on": "rocker", "at": "C", "force": [12, -7]}}
    return data


def slider_crank(r: float = 1, rod: float = 3, e: float = 0, **more: Any) -> dict[str, Any]:
    """Crank AB of radius r, rod BC, a piston on a line at height e (m), without masses."""
    data = {
        "linkwright": 1,
        "units": dict(UNITS),
        "links": {
            "frame": {"points": {"A": [0, 0], "F": [0, e]}},
            "crank": {"points": {"A": [0, 0], "B": [r, 0]}},
            "rod": {"points": {"B": [0, 0], "C": [rod, 0]}},
            "piston": {"points": {"C": [0, 0]}},
        },
        "joints": {"bore": {"prismatic": ["frame", "piston"], "line": ["F at 0", "C at 0"]}},
        "assembly": {"C": "ahead of B along bore"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": 0.5}},
    }
    return data | more


FEEDER: dict[str, Any] = {
    "linkwright": 1,
    "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
    "gravity": [0, "-9.80665 m/s^2"],
    "links": {
        "frame": {"points": {"A": [0, 0], "D": [300, 0], "H": [0, 580]}},
        "crank": {"points": {"A": [0, 0], "B": [155, 0]}, "mass": 0.6, "shape": "rod A-B"},
        "coupler": {"points": {"B": [0, 0], "C": [395, 0]}, "mass": 1.5, "shape": "rod B-C"},
        "rocker": {"points": {"D": [0, 0], "C": [300, 0], "E": [500, 0]}, "mass": 2, "shape": "rod D-E"},
        "slider": {"points": {"E": [0, 0]}, "mass": 1, "shape": "point E"},
        "guide": {"points": {"G": [0, 0]}, "mass": 3, "shape": "point G"},
    },
    "joints": {
        "rail": {"prismatic": ["frame", "guide"], "line": ["H at 0", "G at 0"]},
        "slide": {"prismatic": ["guide", "slider"], "line": ["G at 90", "E at 90"]},
    },
    "assembly": {"C": "left of B-D"},
    "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "-40 rpm", "start": "atan2(61.78, 142.16)"}},
}
"""The packaging paper feeder (lengths in mm), with the data of the six-bar paper: see tests/validation."""


def feeder() -> dict[str, Any]:
    return copy.deepcopy(FEEDER)
