"""Drives that move a point along a line so that something else follows their law: closed forms of a four-bar."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.model.document import Document
from linkwright.results import Run
from linkwright.results.certificate import certify

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"}
DEG = np.pi / 180
A, B, C, D = 40.0, 110.0, 70.0, 100.0
TORQUE = 3.0


def four_bar(output: str, position: str, **drive: Any) -> dict[str, Any]:
    """A ram that moves C along the line of the frame; 3 N m on the crank, no mass."""
    ram = {"moves": "rocker", "at": "C", "on": "frame", "along": "R at 0 deg", "output": output, "position": position}
    return {
        "linkwright": 1,
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [D, 0], "R": [0, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [A, 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [B, 0]}},
            "rocker": {"points": {"D": [0, 0], "C": [C, 0]}},
        },
        "assembly": {"C": [115, 68]},
        "loads": {"brake": {"on": "crank", "torque": TORQUE}},
        "drives": {"ram": {**ram, **drive}},
    }


def place(crank: Any) -> tuple[Any, Any]:
    """C (mm) at a crank angle (rad): where the circles about B and D meet, on the left of B-D."""
    bx, by = A * np.cos(crank), A * np.sin(crank)
    dx, dy = D - bx, -by
    far2 = dx * dx + dy * dy
    along = (far2 + B * B - C * C) / (2 * far2)
    high = np.sqrt(B * B / far2 - along * along)
    return bx + along * dx - high * dy, by + along * dy + high * dx


def test_the_output_follows_the_law_and_the_drive_its_own_line() -> None:
    run = Run(compiled_from(four_bar("crank", "60 deg + 5 deg*t/(1 s)")), 0.0, 2.0, 40)
    crank = (60 + 5 * run.t) * DEG
    x = place(crank)[0] / 1000
    # A step along the imaginary axis gives the derivative to round-off.
    slope = place(crank + 1e-30j)[0].imag / 1e-30 / 1000
    speed = slope * 5 * DEG
    values, speeds, forces = run.evaluate(["ram.s", "ram.v", "ram.force"], run.t)
    np.testing.assert_allclose(run.evaluate(["crank.angle"], run.t)[0], crank, rtol=1e-13)
    np.testing.assert_allclose(values, x, rtol=1e-12)
    np.testing.assert_allclose(speeds, speed, rtol=1e-12)
    # Virtual work: the force along its line and the torque on the crank.
    np.testing.assert_allclose(forces, -TORQUE / slope, rtol=1e-11)
    assert not certify(run).unproven()


@pytest.mark.parametrize(
    ("law", "code"),
    [
        ({"output": "coupler"}, None),
        ({"output": "rocker"}, None),
        ({"output": "rockr"}, "drive.output"),
        ({"along": "Q at 0 deg"}, "name.unknown-point"),
    ],
)
def test_other_outputs_move_or_are_refused_by_name(law: dict[str, Any], code: str | None) -> None:
    data = four_bar(**{"output": "crank", "position": "sketch", **law})
    start = {"coupler": "20 deg", "rocker": "77 deg"}.get(data["drives"]["ram"]["output"], "60 deg")
    data["drives"]["ram"]["position"] = f"{start} + 1 deg*t/(1 s)"
    if data["drives"]["ram"]["output"] == "rocker":  # which is then placed first
        data["assembly"] = {"B": [20, 35]}
    compiled, findings = examine(Document.model_validate({k: v for k, v in data.items() if k != "linkwright"}))
    assert [finding.code for finding in findings if finding.severity == "error"] == ([code] if code else [])
    if code is None:
        assert compiled is not None
        assert not certify(Run(compiled, 0.0, 1.0, 8)).unproven()
