"""Tables of another program: four-bar, slider-crank and six-bar kinematics, and static gravity torques.

Source: linkage_sim (see data/linkage_sim_tables.json). Tolerances are the accuracy of its figures as recomputed
independently: 2e-9 for the four-bar, 1e-12 for the slider-crank, 1e-11 for the six-bar, 1e-9 for static torques.
Static torques are had with a crank so slow that inertia vanishes (1e-6 rad/s: 1e-12 of the torque).
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.compiled import compiled_from
from helpers.examples import UNITS, four_bar, slider_crank
from linkwright.results.run import Run

Array = NDArray[np.float64]
TABLES: dict[str, Any] = json.loads((Path(__file__).parent / "data" / "linkage_sim_tables.json").read_text())
SLOW = 1e-6


def columns(table: str) -> dict[str, Array]:
    entry = TABLES[table]
    return dict(zip(entry["columns"], np.array(entry["rows"]).T, strict=True))


def evaluated(data: dict[str, Any], names: list[str], theta: Array, speed: float = 1.0) -> Array:
    """Signals at crank angles theta (rad), the crank turning at ``speed`` (rad/s)."""
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "speed": speed, "start": float(theta[0])}}
    t = (theta - theta[0]) / speed
    return Run(compiled_from(data), 0.0, float(t[-1]) or 1.0, 50).evaluate(names, t)


def misfit(found: Array, expected: Array) -> float:
    return float(np.abs(found - expected).max())


def angle_misfit(found: Array, expected: Array) -> float:
    return float(np.abs(np.remainder(found - expected + np.pi, 2 * np.pi) - np.pi).max())


def heavy_bars(data: dict[str, Any], masses: dict[str, float], ends: dict[str, float], inertia: Any = None) -> None:
    """Masses at the middle of bars; statics have no use for inertia."""
    data["gravity"] = [0, -9.81]
    for link, mass in masses.items():
        data["links"][link] |= {"mass": mass, "com": [ends[link] / 2, 0], "inertia": (inertia or {}).get(link, 0)}


SIDES = {"before 180 deg": lambda theta: theta < math.pi, "after 180 deg": lambda theta: theta > math.pi}
LENGTHS = {"crank": 1.0, "coupler": 3.0, "rocker": 2.0}
MASSES = {"crank": 2.0, "coupler": 3.0, "rocker": 2.0}


@pytest.mark.parametrize("side", SIDES)
def test_four_bar_at_the_edge_of_grashof(side: str) -> None:
    """4, 1, 3, 2 m: at 180 deg its links lie in a line, a change point; each side is run apart, away from it."""
    table = columns("fourbar")
    rows = SIDES[side](table["theta"])
    theta = table["theta"][rows]
    data = four_bar(1, 3, 2, 4)
    names = [f"{link}.{a}" for a in ("angle", "omega", "alpha") for link in ("coupler", "rocker")]
    found = evaluated(data, names, theta)
    expected = [table[f"{c}_{link}"][rows] for c in ("theta", "w", "a") for link in ("coupler", "rocker")]
    assert angle_misfit(found[:2], np.array(expected[:2])) < 2e-9
    assert misfit(found[2:], np.array(expected[2:])) < 2e-9
    heavy_bars(data, MASSES, LENGTHS)
    torque = evaluated(data, ["motor.torque"], theta, SLOW)[0]
    assert misfit(torque, table["static_gravity_torque"][rows]) < 1e-9 * np.abs(table["static_gravity_torque"]).max()


@pytest.mark.parametrize(("degrees", "torque"), TABLES["fourbar_inverse_dynamics"]["torque_at_deg"].items())
def test_four_bar_inverse_dynamics(degrees: str, torque: float) -> None:
    """At 1 rad/s with the inertias given; own figures by the full equations (the source's leave out terms)."""
    data = four_bar(1, 3, 2, 4)
    heavy_bars(data, MASSES, LENGTHS, TABLES["fourbar_inverse_dynamics"]["inertias"])
    found = evaluated(data, ["motor.torque"], np.array([math.radians(float(degrees))]))
    assert found[0, 0] == pytest.approx(torque, rel=1e-9)


def test_slider_crank() -> None:
    table = columns("slidercrank")
    data = slider_crank(1, 3)
    names = ["rod.angle", "C.x", "rod.omega", "C.vx", "rod.alpha", "C.ax"]
    found = evaluated(data, names, table["theta"])
    expected = [table[c] for c in ("theta_rod", "x_slider", "w_rod", "v_slider", "a_rod", "a_slider")]
    assert angle_misfit(found[0], expected[0]) < 1e-12
    assert misfit(found[1:], np.array(expected[1:])) < 1e-12
    heavy_bars(data, {"crank": 1.0, "rod": 2.0}, {"crank": 1.0, "rod": 3.0})
    data["links"]["piston"] |= {"mass": 0.5, "shape": "point C"}
    torque = evaluated(data, ["motor.torque"], table["theta"], SLOW)[0]
    assert misfit(torque, table["static_gravity_torque"]) < 1e-9 * np.abs(table["static_gravity_torque"]).max()


def six_bar(output: str) -> dict[str, Any]:
    """Stephenson III: two ternary links that do not touch (the source calls it Watt I)."""
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"O2": [0, 0], "O4": [3, 1], "O6": [6, 0]}},
            "crank": {"points": {"O2": [0, 0], "P1": [1.5, 0]}},
            "ternary": {"points": {"P1": [0, 0], "P2": [3, 0], "P3": [1.5, 1]}},
            "rocker4": {"points": {"O6": [0, 0], "P2": [2.5, 0]}},
            "link5": {"points": {"P3": [0, 0], "Q": [2, 0]}},
            "output6": {"points": {"O4": [0, 0], "Q": [2, 0]}},
        },
        "assembly": {"P2": "left of P1-O6", "Q": f"{output} of P3-O4"},
    }


def test_six_bar() -> None:
    """The source's output dyad changes its assembly mode from row to row; each row is held to the mode it is in."""
    table = columns("sixbar")
    links = ("ternary", "rocker4", "link5", "output6")
    names = [f"{link}.{a}" for a in ("angle", "omega", "alpha") for link in links]
    expected = np.array([table[f"{c}{link}"] for c in ("", "w_", "a_") for link in links])
    errors = []
    for output in ("left", "right"):
        found = evaluated(six_bar(output), names, table["theta"])
        error = np.abs(found - expected)
        error[:4] = np.abs(np.remainder(found[:4] - expected[:4] + np.pi, 2 * np.pi) - np.pi)
        errors.append((error / np.maximum(1.0, np.abs(expected))).max(axis=0))
    best = np.min(errors, axis=0)
    assert best.max() < 1e-11
    assert all((np.array(error) == best).any() for error in errors), "both modes occur in the table"
