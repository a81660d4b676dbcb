"""Zhang Jun, Fu Zhengfei, Gao Chenghui, "A quickly entity modeling method for planar cam based on
Pro/Mechanism" (2012): Table 1, the expressions that are typed into the servo motor of the swinging arm of an
MH-101B strapping machine.

Printed, for a cam that turns at 15 deg/s (24 s a turn) and the largest swing m = 12 deg, with sines as the method takes
them, of 2 pi times the share of the segment:

    0 .. 6 s     m (t/6 - sin(2 pi t/6)/(2 pi))
    6 .. 18 s    m
    18 .. 23 s   m - m ((t - 18)/5 - sin(2 pi (t - 18)/5)/(2 pi))
    23 .. 24 s   0

The texts are to be these with their numbers multiplied out, in the order printed, sines in degrees as Creo takes them.
15 digits of each coefficient are written; values agree within 1e-13 deg, some units in the last place of 12 deg.
"""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

import linkwright as lw
from helpers.heat_seal import heat_seal, performed
from linkwright.formulas.evaluate import value
from linkwright.model.document import parse_document
from linkwright.studies.cam.files import FILES

M = 12.0
WAVE = f"{M / (2 * math.pi):.15g}"  # 1.90985931710274
PRINTED = {
    "0 <= t < 6": (f"2*t - {WAVE}*sin(60*t)", lambda t: M * (t / 6 - np.sin(2 * np.pi * t / 6) / (2 * np.pi))),
    "6 <= t < 18": ("12", lambda t: M + 0 * t),
    "18 <= t < 23": (
        f"12 - 2.4*(t - 18) + {WAVE}*sin(72*(t - 18))",
        lambda t: M - M * ((t - 18) / 5 - np.sin(2 * np.pi * (t - 18) / 5) / (2 * np.pi)),
    ),
    "23 <= t <= 24": ("0", lambda t: 0 * t),
}


def test_the_cam_study_writes_the_printed_expressions() -> None:
    outcome = performed(heat_seal(period="24 s", steps=36)).cam
    assert outcome is not None
    lines = [line for line in str(FILES["cam_motion.txt"].make(outcome)).splitlines() if line.startswith("  ")]
    found = dict(re.split(r" {3,}", line.strip()) for line in lines)
    assert found == {domain: text for domain, (text, _) in PRINTED.items()}
    for domain, (text, printed) in PRINTED.items():
        start, stop = (float(end) for end in re.findall(r"\d+", domain))
        t = np.linspace(start, stop, 50)
        assert value(text, t, degrees=True) == pytest.approx(printed(t), abs=1e-13)


@pytest.mark.parametrize("start", [0, 60])
def test_a_motor_that_swings_by_the_law_is_written_as_printed(start: int) -> None:
    """From zero, and from 60 deg on: numbers before the same terms."""
    arm = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg"},
        "links": {"frame": {"points": {"O": [0, 0]}}, "arm": {"points": {"O": [0, 0], "B": [90, 0]}}},
        "laws": {"swing": heat_seal()["laws"]["swing"]},
        "drives": {"servo": {"turns": "arm", "on": "frame", "position": f"{start} deg + swing(15 deg*t/(1 s))"}},
    }
    document = parse_document(arm)
    assert document is not None
    pieces = lw.export(document, "motor-expressions", duration="24 s").summary["motors"]["servo"]["pieces"]
    rise, _, fall, _ = (text for text, _ in PRINTED.values())
    shifted = [
        f"{start} + {rise}" if start else rise,
        f"{start + 12}",
        fall.replace("12", f"{start + 12}", 1),
        f"{start}",
    ]
    assert {piece["domain"]: piece["text"] for piece in pieces} == dict(zip(PRINTED, shifted, strict=True))


def test_the_follower_itself() -> None:
    """The arm of the model stands at 140.7 deg on the base circle and rises clockwise: the same terms, less."""
    data = heat_seal()
    data["drives"]["shaft"]["speed"] = "-15 deg/s"
    document = parse_document(data)
    assert document is not None
    motors = lw.export(document, "motor-expressions", duration="24 s").summary["motors"]
    texts = [piece["text"] for piece in motors["heat_seal"]["pieces"]]
    low, high = "140.725103764843", "128.725103764843"
    assert texts == [
        f"{low} - 2*t + {WAVE}*sin(60*t)",
        high,
        f"{high} + 2.4*(t - 18) - {WAVE}*sin(72*(t - 18))",
        low,
    ]
    assert motors["heat_seal"]["max_error"] < 1e-12
