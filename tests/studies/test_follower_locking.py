"""A cam whose arm is swung past the line through shaft and pivot: the contact's normal is square to its way there."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.cams import pair
from linkwright.findings import Term

AWAY, ARM, PITCH = 60.0, 50.0, 28.0
START = math.degrees(math.acos((AWAY**2 + ARM**2 - PITCH**2) / (2 * AWAY * ARM)))


def rocker(rise: float, **studies: Any) -> lw.Document:
    """A roller on an arm, that a groove swings by ``rise`` degrees over 60 degrees of the cam."""
    parts = [{way: "rise", "over": 60, "law": "cycloidal"} for way in ("rise", "fall")]
    segments = [parts[0], {"dwell": 60}, parts[1], {"dwell": 180}]
    cam = {"cam": "disc", "follower": "arm", "on": "frame", "base": 20, "roller": 8, "at": "C", "law": "lift"}
    data = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "parameters": {"rise": f"{rise} deg"},
        "links": {
            "frame": {"points": {"O": [0, 0], "A": [AWAY, 0]}},
            "disc": {"points": {"O": [0, 0]}},
            "arm": {"points": {"A": [0, 0], "C": [ARM, 0]}, "mass": 1, "shape": "rod A-C"},
        },
        "laws": {"lift": {"over": "angle", "of": "angle", "segments": segments}},
        "cams": {"guide": cam | {"side": "left of O-A", "closed": "groove"}},
        "drives": {"motor": {"turns": "disc", "on": "frame", "speed": "360 deg/s", "start": 0}},
        "loads": {"held": {"on": "arm", "torque": -2}},
        "measures": {"contact": {"max": "abs(guide.force)"}},
        "studies": {"cycle": {"turns": "1 motor", "samples": 60}} | studies,
    }
    return lw.Document.model_validate(data)


def test_a_follower_locks_where_its_arm_lies_along_the_line_from_pivot_to_shaft() -> None:
    job = lw.run(rocker(160.0))
    (finding,) = [f for f in job.found if f.code == "cam.locks"]
    x = float(finding.data["value"]) / 60
    assert START + 160 * (x - math.sin(2 * math.pi * x) / (2 * math.pi)) == pytest.approx(180, abs=1e-3)
    assert finding.path == ("cams", "guide")
    assert job.cycle is not None
    assert not job.cycle.measures
    assert not lw.run(rocker(152.0)).found  # START + 152 deg < 180 deg


def test_a_face_that_turns_as_fast_as_the_cam_loses_its_contact() -> None:
    data = pair("swinging", "face", -1)
    for segment in data["laws"]["lift"]["segments"]:
        segment |= {key: segment[key] / 0.14 for key in ("rise", "fall") if key in segment}
    data["drives"]["motor"]["start"] = -0.4
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": 60}}
    (finding,) = [f for f in lw.run(lw.Document.model_validate(data)).found if f.code == "cam.locks"]
    x = (float(finding.data["value"]) + 0.4) / 1.7
    assert 1 / 1.7 * 140 * (x * (1 - x)) ** 3 == pytest.approx(1, abs=1e-4)  # the slope of poly_4567
    assert finding.data["why"] == Term("face-fast")


def test_samples_in_which_a_follower_locks_have_no_figures() -> None:
    vary = {"rise": {"from": "150 deg", "to": "160 deg", "count": 6}}
    outcome = lw.run(rocker(40.0, sweep={"vary": vary})).outcomes["sweep"]
    expected = [START + 150 + 2 * i >= 180 for i in range(6)]
    assert np.isnan(outcome.table.figures[0]).tolist() == expected
    assert outcome.warnings[0].code == "study.no-value"
