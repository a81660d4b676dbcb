"""Forces that come with a joint's multipliers and do no work (``Inner.besides``): gears, by sums of forces."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.outside import linkwright, table

UNITS = {"length": "mm", "angle": "deg", "time": "s", "force": "N", "torque": "N*m"}
TAN = np.tan(np.radians(20))


def rows(folder: Path, **data: Any) -> dict[str, Any]:
    """The columns of a run by their names without units; the run is proven by its own certificate."""
    model = {
        "linkwright": 1,
        "units": UNITS,
        "studies": {"cycle": {"duration": "1 s", "samples": 21}},
        **data,
    }
    (folder / "model.yaml").write_text(json.dumps(model), encoding="utf-8")
    done = linkwright(folder, "run", "model.yaml", "--out", "out")
    assert done.returncode == 0, done.stderr
    return {head.split(" [")[0]: values for head, values in table(folder / "out" / "cycle.csv")[0].items()}


def mesh(links: list[str], points: str, a: float, b: float) -> dict[str, Any]:
    return {"gear_mesh": links, "points": [*points], "radius_a": a, "radius_b": b}


@pytest.mark.parametrize("torque", [12.0, -12.0])
def test_gears_on_the_frame_are_pushed_apart_by_either_flank(torque: float, tmp_path: Path) -> None:
    """The wheel's torque over its radius at the pitch point, and |T| tan 20 deg between the pins."""
    own = rows(
        tmp_path,
        links={
            "frame": {"points": {"O": [0, 0], "M": [90, 0]}},
            "pinion": {"points": {"O": [0, 0]}},
            "wheel": {"points": {"M": [0, 0], "W": [20, 0]}},
        },
        joints={"mesh": mesh(["pinion", "wheel", "frame"], "OMO", 30, 60)},
        assembly={"W": [110, 0]},
        drives={"motor": {"turns": "pinion", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
        loads={"brake": {"on": "wheel", "torque": torque}},
    )
    tangential = torque / 0.06
    assert own["wheel.omega"] == pytest.approx(-180.0)
    assert own["motor.torque"] == pytest.approx(0.03 * tangential)
    assert own["force(frame, wheel).y"] == pytest.approx(-tangential)
    assert own["force(frame, wheel).x"] == pytest.approx(-abs(tangential) * TAN)
    assert own["force(frame, pinion).x"] == pytest.approx(abs(tangential) * TAN)


def test_a_planet_is_pushed_to_both_sides_alike(tmp_path: Path) -> None:
    """Sun 40, planet 20, fixed ring 80 mm: Willis' speeds, 100 N on each tooth for 200 N on the planet's pin, where
    what separates the gears cancels; the sun's pin carries it."""
    own = rows(
        tmp_path,
        links={
            "frame": {"points": {"O": [0, 0]}},
            "sun": {"points": {"O": [0, 0]}},
            "arm": {"points": {"O": [0, 0], "P": [60, 0]}},
            "planet": {"points": {"P": [0, 0], "Q": [10, 0]}},
        },
        joints={
            "inner": mesh(["sun", "planet", "arm"], "OPO", 40, 20),
            "outer": mesh(["planet", "frame", "arm"], "POO", 20, -80),
        },
        assembly={"P": [60, 0], "Q": [70, 0]},
        drives={"motor": {"turns": "sun", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
        loads={"brake": {"on": "arm", "torque": 12}},
    )
    assert own["arm.omega"] == pytest.approx(360 / (1 + 80 / 40))
    assert own["planet.omega"] == pytest.approx(120 - (360 - 120) * 40 / 20)
    assert own["motor.torque"] == pytest.approx(-12 / (1 + 80 / 40))
    assert np.hypot(own["force(arm, planet).x"], own["force(arm, planet).y"]) == pytest.approx(12 / 0.06)
    tooth = 100 / np.cos(np.radians(20))
    for pair in ("sun, inner", "planet, inner", "planet, outer", "sun, O"):
        assert np.hypot(own[f"force({pair}).x"], own[f"force({pair}).y"]) == pytest.approx(tooth), pair
