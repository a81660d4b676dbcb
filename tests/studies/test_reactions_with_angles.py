"""Structures that stand under torques that depend on angles: torsional springs, loads that name a link's angle."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import linkwright as lw

A, C, D = np.array([0.0, 0.0]), np.array([80.0, 120.0]), np.array([200.0, 0.0])
ANGLE = math.atan2(*C[::-1])
RATE = 5.0  # N m/rad
FREE = math.radians(20)


def truss(**acting: Any) -> dict[str, Any]:
    return {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {
            "frame": {"points": {"A": A.tolist(), "D": D.tolist()}},
            "bar": {"points": {"A": [0, 0], "C": [float(np.hypot(*C)), 0]}},
            "strut": {"points": {"D": [0, 0], "C": [float(np.hypot(*(C - D))), 0]}},
        },
        "assembly": {"C": C.tolist()},
        "studies": {"reactions": {}},
        **acting,
    }


SPRING = {"springs": {"hold": {"turns": "bar", "on": "frame", "stiffness": f"{RATE} N*m/rad", "free": "20 deg"}}}
TURNED = {"springs": {"hold": {"turns": "bar", "on": "frame", "stiffness": f"{RATE} N*m/rad", "free": "380 deg"}}}
LOAD = {"loads": {"hold": {"on": "bar", "torque": f"-{RATE} N*m/rad*(bar.angle - 20 deg)"}}}


@pytest.mark.parametrize("acting", [SPRING, TURNED, LOAD], ids=["spring", "a turn further", "load"])
def test_a_torque_by_an_angle(acting: dict[str, Any]) -> None:
    """The strut has two forces only, along its line: its force balances the torque on the bar about A."""
    job = lw.run(lw.Document.model_validate(truss(**acting)))
    assert [finding.code for finding in job.found if finding.severity == "error"] == []
    torque = -RATE * (ANGLE - FREE)
    along = (C - D) / np.hypot(*(C - D))
    arm = (C - A) / 1000
    force = -torque / (arm[0] * along[1] - arm[1] * along[0]) * along  # of the strut on the bar
    found = {entry["name"]: entry["value"] for entry in job.summary["reactions"]["joints"]}
    assert found["force(bar, strut).x"] == pytest.approx(-force[0], rel=1e-9)
    assert found["force(bar, strut).y"] == pytest.approx(-force[1], rel=1e-9)
