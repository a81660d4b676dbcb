"""Reactions and powers that are zero but for round-off are shown as zero, beside change points too."""

from __future__ import annotations

from typing import Any

import linkwright as lw
from linkwright.model.document import parse_document

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}


def overview(data: dict[str, Any], **options: Any) -> Any:
    job = lw.run(parse_document({**data, "studies": {"cycle": {"turns": "1 motor", "samples": 24, **options}}}))
    assert job.exit_code == 0
    return job.outcomes["cycle"].overview


def test_a_coupling_rod_whose_wheel_carries_nothing() -> None:
    """The second wheel of a parallelogram is balanced and not loaded: the rod's force on it is zero, though the motion
    passes two change points, where a system that is nearly singular spreads round-off."""
    disc = {"mass": 2, "com": [0, 0], "inertia": 4900}
    found = overview(
        {
            "linkwright": 1,
            "units": UNITS,
            "gravity": "earth",
            "links": {
                "frame": {"points": {"O1": [0, 0], "O2": [149, 0]}},
                "w1": {"points": {"O1": [0, 0], "K1": [30, 0]}, **disc},
                "w2": {"points": {"O2": [0, 0], "K2": [30, 0]}, **disc},
                "rod": {"points": {"K1": [0, 0], "K2": [149, 0]}, "mass": 1, "com": [149, 0], "inertia": 1000},
            },
            "assembly": {"K1": [0, 30], "K2": [149, 30]},
            "drives": {"motor": {"turns": "w2", "on": "frame", "speed": "60 rpm", "start": "90 deg"}},
        },
        through="keep",
    )
    peaks = {joint: one.peak.value for (joint, _, _), one in found.reactions.items()}
    assert peaks["K1"] == 0.0 and peaks["K2"] > 5 and peaks["O1"] > 19


def test_a_ring_gear_that_turns_without_load() -> None:
    """No torque and no power is needed; all of them are round-off of what inertia forces make over the lengths."""
    found = overview(
        {
            "linkwright": 1,
            "units": UNITS,
            "links": {
                "frame": {"points": {"A": [0, 0], "D": [100, 0]}},
                "crank": {"points": {"A": [0, 0], "B": [40, 0]}, "mass": 1, "shape": "rod A-B"},
                "wheel": {"points": {"D": [0, 0], "X": [9, 0]}, "mass": 1, "shape": "rod D-X"},
            },
            "joints": {
                "x": {"gears": ["crank", "wheel"], "internal": "crank", "centres": ["A", "D"], "radii": [150, 50]}
            },
            "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
        }
    )
    effort, power = found.drives["motor"]
    assert effort.peak.value == power.peak.value == effort.rms == power.rms == 0.0
    teeth = next(one for (joint, _, _), one in found.reactions.items() if joint == "x")
    assert teeth.peak.value == teeth.rms == 0.0
