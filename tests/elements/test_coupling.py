"""Couplings: against the same mechanism with two drives, whose torques add up by virtual work; samples against files of
their own; what is refused."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

import linkwright as lw
from helpers.compiled import compiled_from
from linkwright.findings import Finding, ModelError
from linkwright.results.run import Run

FILE = Path(__file__).parents[2] / "examples" / "coupled_cranks.yaml"
T = np.linspace(0.0, 1.0, 61)
LINKS = ["C.x", "C.vx", "C.ay", "left.angle", "right.omega", "force(frame, crank).x", "force(right, left).y"]


def model(follows: str = "ratio*motor.angle + phase", **changes: Any) -> dict[str, Any]:
    data: dict[str, Any] = YAML(typ="safe").load(FILE.read_text(encoding="utf-8"))
    for key in ("note", "measures", "studies"):
        data.pop(key)
    data["joints"]["belt"]["follows"] = follows
    return {**data, **changes}


def evaluated(data: dict[str, Any], names: list[str]) -> np.ndarray:
    return Run(compiled_from(data), 0.0, 1.0, 200).evaluate(names, T)


def close(found: np.ndarray, expected: np.ndarray) -> None:
    """To 1e-12 of each row's largest magnitude."""
    scale = np.abs(expected).max(axis=-1, keepdims=True)
    assert np.abs(found - expected).max() <= 1e-12 * scale.max()


@pytest.mark.parametrize(
    ("follows", "position", "slope"),
    [
        ("ratio*motor.angle + phase", "2*(360 deg*t/(1 s)) + 30 deg", lambda a: 2.0 + 0 * a),
        ("-motor.angle", "-360 deg*t/(1 s)", lambda a: -1.0 + 0 * a),
        (
            "40 deg + 25 deg*sin(motor.angle)",
            "40 deg + 25 deg*sin(360 deg*t/(1 s))",
            lambda a: np.radians(25) * np.cos(a),
        ),
    ],
)
def test_it_is_a_second_drive_whose_torque_the_motor_gives(follows: str, position: str, slope: Any) -> None:
    """Motion and reactions of links off the belt are the same; the motor gives its own torque and, times the slope,
    that of the second drive."""
    coupled, apart = model(follows), model()
    del apart["joints"]
    apart["drives"]["servo"] = {"turns": "second", "on": "frame", "position": position}
    found = evaluated(coupled, [*LINKS, "belt.angle", "belt.torque", "motor.torque", "motor.angle"])
    expected = evaluated(apart, [*LINKS, "servo.angle", "servo.torque", "motor.torque"])
    for row, other in zip(found[:-2], expected[:-1], strict=True):
        close(row, other)
    close(found[-2], expected[-1] + slope(found[-1]) * expected[-2])


def test_along_a_slide_and_behind_a_sliding_drive() -> None:
    """A ram that follows another one, upwards over a lever of 2:1: its weight is carried by the drive, doubled."""
    data = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "gravity": [0, -10_000],
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [100, 0]}},
            "first": {"points": {"B": [0, 0]}, "mass": 1, "shape": "point B"},
            "second": {"points": {"C": [0, 0]}, "mass": 3, "shape": "point C"},
        },
        "joints": {
            "left": {"prismatic": ["frame", "first"], "line": ["A at 90 deg", "B at 90 deg"]},
            "right": {"prismatic": ["frame", "second"], "line": ["D at 90 deg", "C at 90 deg"]},
            "lever": {"coupling": ["second", "frame"], "follows": "2*lift.s - 5 mm"},
        },
        "drives": {"lift": {"extends": "left", "speed": "10 mm/s", "start": "0 mm"}},
    }
    found = evaluated(data, ["lever.s", "C.y", "lever.force", "lift.force"])
    close(found[0], 0.02 * T - 0.005)
    close(found[1], found[0])
    close(found[2], np.full(T.size, 30.0))
    close(found[3], np.full(T.size, 10.0 + 2 * 30.0))


def test_samples_are_files_of_their_own() -> None:
    """A swept ratio against single runs."""
    data = model(measures={"width": {"span": "C.x"}, "torque": {"max": "motor.torque"}})
    document = lw.Document.model_validate({**data, "studies": {"cycle": {"turns": "1 motor"}}})
    outcome = lw.sweep(document, {"ratio": [1, 2, 3]})
    assert outcome.table is not None
    for k, ratio in enumerate((1, 2, 3)):
        job = lw.run(document.replace(ratio=ratio))
        assert job.cycle is not None
        alone = [found.value for measure in job.cycle.measures for found in measure.found]
        np.testing.assert_allclose(outcome.table.figures[:, k], alone, rtol=1e-9)


def findings_of(data: dict[str, Any]) -> list[Finding]:
    """What is wrong with a model that isn't run."""
    with pytest.raises(ModelError) as refused:
        lw.run(lw.Document.model_validate({**data, "studies": {"cycle": {"turns": "1 motor"}}}))
    return list(refused.value.findings)


@pytest.mark.parametrize(
    ("follows", "code", "hint"),
    [
        ("2*motor.angel", "joint.coupling-motor", "motor.angle"),
        ("2*motor.omega", "joint.coupling-motor", "motor.angle"),
        ("motor.angle + second.angle", "joint.coupling-motor", "motor.angle"),
        ("90 deg", "joint.coupling-motor", "motor.angle"),
        ("motor.angle + t*1 deg/s", "joint.coupling-name", "parameters"),
        ("ratoi*motor.angle", "name.unknown-parameter", "ratio"),
        ("sn(motor.angle)*1 deg", "expression.unknown-function", "sin"),
        ("motor.angle + 3 mm", "expression.units-mixed", "mm"),
        ("motor.angle/0", "joint.not-finite", "zero"),
    ],
)
def test_what_it_can_t_follow_is_told(follows: str, code: str, hint: str) -> None:
    (finding,) = findings_of(model(follows))
    assert finding.code == code
    assert finding.path[:2] == ("joints", "belt")
    assert hint in str(finding)


def test_where_it_has_no_value_later_is_told() -> None:
    """The run doesn't begin, as with a drive's position."""
    (finding,) = findings_of(model("acos(2*cos(motor.angle + 80 deg))"))
    assert finding.code == "joint.not-finite"
    assert 0 < finding.data["time"] < 0.2


def test_links_without_one_joint_are_told() -> None:
    data = model()
    data["joints"]["belt"]["coupling"] = ["second", "crank"]
    assert [finding.code for finding in findings_of(data)] == ["joint.coupling-joint"]


def test_a_drive_that_names_another_is_sent_here() -> None:
    data = model()
    del data["joints"]
    data["drives"]["servo"] = {"turns": "second", "on": "frame", "position": "2*motor.angle"}
    (finding,) = findings_of(data)
    assert finding.code == "drive.signal"
    assert "coupling: [drum, frame]" in str(finding)
