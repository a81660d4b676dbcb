"""The section ``trajectories``: which drive is held at which values; what is wrong with it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely

from helpers.workspaces import arm, findings, five_bar, four_bar, performed, polar
from linkwright.studies.workspace.trajectories_outcome import TrajectoriesPart


def codes(data: dict[str, Any]) -> list[tuple[str, Any]]:
    return [(one.code, one.path[-1]) for one in findings(data)]


def part(data: dict[str, Any]) -> TrajectoriesPart:
    job = performed(data)
    assert job.workspace is not None
    found = job.workspace.parts["trajectories"]
    assert isinstance(found, TrajectoriesPart)
    return found


def test_a_whole_turn_has_its_first_value_once_and_a_range_both_ends() -> None:
    whole = part(arm(trajectories={}))
    assert whole.drives == ("elbow", "shoulder")  # both have constant speed: the second one
    assert np.degrees(whole.values) == pytest.approx(np.arange(0, 360, 10))
    limited = part(arm(drives={"elbow": [20, 100]}, trajectories={"hold": "elbow", "steps": 4}))
    assert np.degrees(limited.values) == pytest.approx([20, 40, 60, 80, 100])
    stepped = part(arm(drives={"elbow": [20, 100]}, trajectories={"hold": "elbow", "every": "30 deg"}))
    assert np.degrees(stepped.values) == pytest.approx([20, 50, 80])
    turned = part(arm(trajectories={"hold": "shoulder", "every": "45 deg"}))
    assert np.degrees(turned.values) == pytest.approx(np.arange(0, 360, 45))


def test_of_a_motor_and_a_servo_the_servo_is_held() -> None:
    data = polar(drives={"elbow": [50, 80]}, trajectories={"steps": 3})
    found = part(data)
    assert found.drives == ("elbow", "shoulder")
    assert found.values == pytest.approx([0.05, 0.06, 0.07, 0.08])
    data = arm(trajectories={"steps": 3})
    data["drives"]["shoulder"] = {"turns": "upper", "on": "frame", "position": "30 deg + 20 deg*sin(360 deg*t/(1 s))"}
    assert part(data).drives == ("shoulder", "elbow")
    data["studies"]["workspace"]["trajectories"]["hold"] = "elbow"
    assert part(data).drives == ("elbow", "shoulder")


def test_the_summary_counts_and_measures_in_the_files_units() -> None:
    """The guide held at 50, 60, 70 and 80 mm: circles about the pin."""
    job = performed(polar(drives={"elbow": [50, 80]}, trajectories={"steps": 3, "chord": 1e-5}))
    (entry,) = job.summary["workspace"]["trajectories"]
    assert entry["values"] == {"from": pytest.approx(50), "to": pytest.approx(80), "count": 4, "unit": "mm"}
    assert (entry["hold"], entry["moving"], entry["mode"], entry["unit"]) == ("elbow", "shoulder", "", "mm")
    assert (entry["assembled"], entry["whole"], entry["stretches"]) == (4, 4, 4)
    assert entry["length"] == pytest.approx(2 * np.pi * 260, rel=1e-4)


def test_each_region_has_its_own() -> None:
    found = part(five_bar(**{"for": {"l": [11, 12]}}, trajectories={"steps": 6}))
    entries = found.as_dict()
    assert [(entry["l"], entry["mode"]) for entry in entries] == [
        (length, f"C: {side} of B-D") for length in (11, 12) for side in ("right", "left")
    ]
    assert all(0 < entry["assembled"] <= 6 for entry in entries)
    for one, entry in zip(found.regions, entries, strict=True):
        assert entry["length"] == pytest.approx(1e3 * one.found.length)
        assert entry["stretches"] == len(one.found.stretches)
        assert entry["length"] > 0
        grown = one.reached.shape.buffer(2 * found.chord)
        assert all(grown.covers(shapely.LineString(stretch.at.T)) for stretch in one.found.stretches)


def test_mistakes_are_named() -> None:
    assert codes(arm(trajectories={"hold": "elbo"})) == [("name.unknown", "hold")]
    assert codes(arm(trajectories={"every": 10, "steps": 9})) == [("workspace.hold-steps", "trajectories")]
    assert codes(arm(trajectories={"every": "-1 deg"})) == [("workspace.not-positive", "every")]
    assert codes(arm(trajectories={"every": "3 mm"}))[0][1] == "every"
    assert codes(arm(trajectories={"every": "0.1 deg"})) == [("workspace.hold-many", "every")]
    assert codes(arm(trajectories={"steps": 721})) == [("study.options", "steps")]
    assert codes(arm(trajectories={"step": 9}))[0][0] == "file.unknown-key"
    assert codes(four_bar(trajectories={})) == [("workspace.two-drives", "trajectories")]
