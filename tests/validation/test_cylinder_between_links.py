"""A cylinder between crank and coupler against the law of cosines.

The triangle of the cylinder's two pins and the crank pin turns the cylinder's length into the angle between crank and
coupler: cos(PBQ) = (p^2 + q^2 - s^2) / (2 p q). The same four-bar driven by that angle is a mechanism of other links,
solved another way (one dyad, where the cylinder's takes Newton's method on five links). A massless cylinder's force
follows from the torque at the pin by power: F s' = M beta'. Tolerance: round-off over the nearest determinant (0.3).
"""

from __future__ import annotations

import copy
from typing import Any

import numpy as np

from helpers.compiled import compiled_from

PLACES = {"A": [0, 0], "B": [60, 120], "C": [330, 190], "D": [300, 0], "P": [55, 40], "Q": [180, 90]}
T = np.linspace(0.0, 3.0, 31)
SPEED = 10.0


def four_bar() -> dict[str, Any]:
    return {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*mm"},
        "gravity": [0, "-9.80665 m/s^2"],
        "sketch": copy.deepcopy(PLACES),
        "links": {
            "frame": {"points": ["A", "D"]},
            "crank": {"points": ["A", "B", "P"], "mass": 2, "shape": "rod A-B"},
            "coupler": {"points": ["B", "C", "Q"], "mass": 4, "shape": "rod B-C"},
            "rocker": {"points": ["D", "C"], "mass": 3, "shape": "rod D-C"},
        },
        "loads": {"weight": {"on": "rocker", "at": "C", "force": [0, -400]}},
    }


def by_cylinder() -> dict[str, Any]:
    drives = {"pump": {"extends": "ram", "speed": SPEED, "start": "sketch"}}
    return {**four_bar(), "cylinders": {"ram": {"from": "P", "to": "Q"}}, "drives": drives}


def by_angle() -> dict[str, Any]:
    """The angle between crank and coupler as the law of cosines gives it over time."""
    a, b, c, p, q = (complex(*PLACES[name]) for name in "ABCPQ")
    bp, bq, s = abs(p - b), abs(q - b), abs(q - p)
    side = np.sign(np.angle((q - b) / (p - b)))
    # The angle from the crank's axis to the coupler's: that from BP to BQ, with those of P and Q on their links.
    rest = np.angle((p - b) / (b - a)) - np.angle((q - b) / (c - b))
    cosine = f"({bp**2 + bq**2!r} - ({s!r} + {SPEED!r}*t/(1 s))^2)/{2 * bp * bq!r}"
    law = f"{float(rest)!r} + {float(side)!r}*acos({cosine})"
    return {**four_bar(), "drives": {"motor": {"turns": "coupler", "on": "crank", "position": law}}}


def test_motion() -> None:
    names = ["C.x", "C.y", "C.vx", "C.ay", "crank.omega", "crank.alpha", "rocker.omega", "Q.jx"]
    found, expected = (compiled_from(data()).evaluate(names, T) for data in (by_cylinder, by_angle))
    assert (np.abs(found - expected).max(axis=1) < 1e-11 * np.maximum(1, np.abs(expected).max(axis=1))).all()


def test_the_force_of_the_cylinder() -> None:
    force, speed = compiled_from(by_cylinder()).evaluate(["pump.force", "pump.v"], T)
    torque, omega = compiled_from(by_angle()).evaluate(["motor.torque", "motor.omega"], T)
    assert np.abs(force * speed - torque * omega).max() < 1e-11 * np.abs(force * speed).max()
    assert np.abs(force).min() > 50
