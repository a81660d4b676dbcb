"""Mechanisms with pins in slots, and their poses and forces from raw geometry alone: no model, no groups, no jets.

The pose of a lever is found by bisection on the slot's own equation, its rates by differences, the forces from the
3 n equations of Newton and Euler (Nikravesh 1988, ch. 9).
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

Array = NDArray[np.float64]
Gap = Callable[[float, float], float]
"""How far a pin at coordinates (m) in the lever's axes lies beside the slot."""

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
R, D, MASS, LONG, SPEED = 0.040, 0.090, 0.5, 0.160, 2 * np.pi
"""The crank, the distance of the pivots (m), the lever's mass (kg) and length (m), the crank's speed (rad/s)."""
PLACES = [(40.0, 0.0), (65.0, 8.0), (90.0, 0.0), (115.0, -8.0), (140.0, 0.0)]
CURVE = CubicSpline(*np.array(PLACES).T * 1e-3, bc_type="natural")
CENTRE, RADIUS = 0.120, 0.100
SLOTS: dict[str, tuple[dict[str, Any], Gap]] = {
    "straight": ({"straight": "C at 0 deg"}, lambda x, y: y),
    "tilted": ({"straight": "C at 10 deg"}, lambda x, y: y * np.cos(np.radians(10)) - x * np.sin(np.radians(10))),
    "arc": ({"arc": {"centre": "M", "radius": 100}}, lambda x, y: RADIUS - np.hypot(x - CENTRE, y)),
    "curve": ({"curve": {"along": "C at 0 deg", "through": PLACES}}, lambda x, y: y - float(CURVE(x))),
}
"""Each as a file has it, and as the raw geometry has it."""
START = {"straight": 66.0, "tilted": 56.0, "arc": 12.6, "curve": 66.0}
"""Where the lever points at the start, about (deg)."""


def lever(slot: str, **more: Any) -> dict[str, Any]:
    """A lever below a crank whose pin runs in its slot."""
    angle = np.radians(START[slot])
    end = [1e3 * LONG * np.cos(angle), 1e3 * (LONG * np.sin(angle) - D)]
    return {
        "linkwright": 1,
        "units": UNITS,
        "parameters": {"r": 1e3 * R, "d": 1e3 * D},
        "links": {
            "frame": {"points": {"O": [0, 0], "C": [0, "-d"]}},
            "crank": {"points": {"O": [0, 0], "B": ["r", 0]}},
            "lever": {"points": {"C": [0, 0], "T": [1e3 * LONG, 0], "M": [1e3 * CENTRE, 0]}, "mass": MASS,
                      "shape": "rod C-T"},
        },
        "joints": {"slot": {"pin_in_slot": ["crank", "lever"], "pin": "B", **copy.deepcopy(SLOTS[slot][0]), **more}},
        "assembly": {"T": end},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 0}},
        "studies": {"cycle": {"period": "1 s", "samples": 60}},
    }  # fmt: skip


def angle_at(slot: str, t: float, near: float) -> float:
    """The lever's angle (rad) at a time, that nearest to one (rad): a zero of the slot's own equation."""
    turn, gap = SPEED * t, SLOTS[slot][1]
    x, y = R * np.cos(turn), R * np.sin(turn) + D

    def missed(angle: float) -> float:
        c, s = np.cos(angle), np.sin(angle)
        return gap(c * x + s * y, -s * x + c * y)

    width = 0.02
    while missed(near - width) * missed(near + width) > 0:
        width *= 1.5
        assert width < 1.0, "no zero nearby"
    return float(brentq(missed, near - width, near + width, xtol=1e-15, rtol=1e-15))


def oracle(slot: str, t: float, near: float) -> tuple[float, float, float, float]:
    """The lever's angle (rad), angular acceleration (rad/s2), the torque on the crank (N m), and the force of the slot
    on the pin along the slot's normal (N); the crank is massless, the lever a rod about its pivot."""
    h = 1e-3
    near = angle_at(slot, t, near)
    angles = [angle_at(slot, t + k * h, near) for k in (-3, -2, -1, 0, 1, 2, 3)]
    weights = np.array([2, -27, 270, -490, 270, -27, 2]) / (180 * h * h)
    alpha = float(weights @ np.array(angles))
    # Unknown: the force of the pin on the lever (x, y), along the gradient of the slot's equation there.
    gap, step = SLOTS[slot][1], 1e-7
    c, s = np.cos(near), np.sin(near)
    pin = np.array([R * np.cos(SPEED * t), R * np.sin(SPEED * t)])
    away = pin - np.array([0.0, -D])
    x, y = c * away[0] + s * away[1], -s * away[0] + c * away[1]
    slope = np.array([gap(x + step, y) - gap(x - step, y), gap(x, y + step) - gap(x, y - step)])
    normal = slope / np.hypot(*slope)
    normal = np.array([c * normal[0] - s * normal[1], s * normal[0] + c * normal[1]])
    inertia = MASS * LONG**2 / 3
    on_lever = inertia * alpha / float(away[0] * normal[1] - away[1] * normal[0])
    on_pin = -on_lever
    torque = -float(pin[0] * normal[1] - pin[1] * normal[0]) * on_pin
    return near, alpha, torque, on_pin
