"""Tables: what their bare numbers mean, and how they tie the dimensions around them."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.compilation import examine
from linkwright.expressions.dimensions import argument, value
from linkwright.expressions.units import ANGLE, PRESSURE, TIME
from linkwright.findings import Finding
from linkwright.kernels import Compiled
from linkwright.model.document import Document
from model.given import DATA, four_bar, quantities

RISE = [[0, 0], [0.5, 30], [1.0, 60], [1.5, 90]]


def examined(points: Any = RISE, position: str = "rise(t)", **table: Any) -> tuple[Compiled | None, list[Finding]]:
    data = four_bar(
        tables={"rise": {"points": points, **table}},
        drives={"motor": {"turns": "crank", "on": "frame", "position": position}},
    )
    return examine(Document.model_validate(data), DATA)


def at(compiled: Compiled | None, time: float) -> float:
    assert compiled is not None
    return float(compiled.laws["motor"](np.array([time])).d[0][0])


@pytest.mark.parametrize(
    "points",
    [
        RISE,
        [["0 s", "0 deg"], ["0.5 s", "30 deg"], ["1 s", "60 deg"], ["1.5 s", "90 deg"]],
        [[0, 0], ["500 ms", 30], [1, "60 deg"], [1.5, "pi/2"]],
        [[0, 0], [0.5, "w/3"], ["2*T", "2*w/3"], ["3*T", "w"]],
    ],
)
def test_bare_points_take_their_units_from_the_use_of_the_table(points: Any) -> None:
    data = four_bar(
        parameters={"w": 90, "T": 0.5},
        tables={"rise": {"points": points}},
        drives={"motor": {"turns": "crank", "on": "frame", "position": "rise(t)"}},
    )
    compiled, findings = examine(Document.model_validate(data))
    assert not [str(finding) for finding in findings]
    assert at(compiled, 1.25) == pytest.approx(75 * math.pi / 180, rel=1e-12)


def test_a_period_has_the_unit_of_the_argument() -> None:
    compiled, findings = examined([[0, 0], [0.5, 30], [1.0, 60], [1.5, 30]], period=2)
    assert not findings
    assert at(compiled, 2.5) == pytest.approx(30 * math.pi / 180)


def test_a_table_over_an_angle() -> None:
    points = [[0, 0], [90, 10], [180, 20], [270, 10]]
    compiled, findings = examined(points, "rise(360 deg*t/(1 s))", period=360)
    assert not findings
    assert at(compiled, 0.5) == pytest.approx(20 * math.pi / 180)


def test_a_period_that_is_too_small_is_told_in_the_unit_of_the_argument() -> None:
    points = [[0, 0], [90, 10], [180, 20], [270, 10]]
    _, findings = examined(points, "rise(360 deg*t/(1 s))", period=-360)
    assert [finding.data["value"] + finding.data["unit"] for finding in findings if "value" in finding.data] == [
        "-360deg"
    ]


@pytest.mark.parametrize(
    ("table", "position", "code", "element"),
    [
        ({"points": [["0 s", 0], ["1 mm", 1]]}, "rise(t)", "expression.units-conflict", "tables.rise.points.1"),
        ({"points": [["0 mm", 0], ["1 mm", 1]]}, "rise(t)", "expression.units-conflict", "drives.motor.position"),
        ({"points": [[0, "0 kg"], [1, "1 kg"]]}, "rise(t)", "expression.units-conflict", "drives.motor.position"),
        ({"points": RISE, "period": "3 mm"}, "rise(t)", "expression.units-conflict", "tables.rise.period"),
        ({"points": RISE, "period": -1}, "rise(t)", "value.too-small", "tables.rise.period"),
        ({"points": RISE}, "rise(t, 1)", "expression.arguments", "drives.motor.position"),
        ({"points": RISE}, "ries(t)", "expression.unknown-function", "drives.motor.position"),
        ({"points": [[0, "t"], [1, 1]]}, "rise(t)", "expression.not-constant", "tables.rise.points.0"),
        ({"points": [[0, "1/0"], [1, 1]]}, "rise(t)", "value.not-finite", "tables.rise.points.0"),
        ({"points": [[0, 0], [1, 1]], "between": "linear"}, "rise(t)", "drive.linear-table", "drives.motor.position"),
        ({"points": [[0, 0], [1, 1]]}, "rise(t)", "table.short", "tables.rise"),
        ({"points": []}, "rise(t)", "table.short", "tables.rise"),
        ({"points": [[0, 0], [1e-320, 1], [1, 2], [2, 0]]}, "rise(t)", "table.uneven", "tables.rise"),
        ({"points": RISE}, "1e308*rise(t)", "drive.not-finite", "drives.motor.position"),
        ({"points": [[0, 0], [1, 1], [1, 2], [3, 3]]}, "rise(t)", "table.order", "tables.rise"),
        ({"points": RISE, "period": 1}, "rise(t)", "table.period", "tables.rise"),
        ({"points": RISE, "period": "1/0"}, "rise(t)", "value.not-finite", "tables.rise.period"),
        ({"points": RISE, "period": 1.5}, "rise(t)", "table.not-closed", "tables.rise"),
        ({"points": RISE}, "rise(t - 1 s)", "drive.outside-table", "drives.motor.position"),
        ({"file": "none.csv", "x": "a s", "y": "b deg"}, "rise(t)", "table.unreadable", "tables.rise.file"),
        ({"file": "gas.csv", "x": "time s", "y": "pressure deg"}, "rise(t)", "table.no-column", "tables.rise.file"),
        (
            {"file": "gas.csv", "x": "angle mm", "y": "pressure deg"},
            "rise(t)",
            "expression.units-conflict",
            "drives.motor.position",
        ),
    ],
)
def test_faults(table: dict[str, Any], position: str, code: str, element: str) -> None:
    data = four_bar(tables={"rise": table}, drives={"motor": {"turns": "crank", "on": "frame", "position": position}})
    findings = examine(Document.model_validate(data), DATA)[1]
    assert (code, element) in [(finding.code, finding.element) for finding in findings]
    for finding in findings:
        assert finding.what
        assert finding.mend


def test_columns_of_a_file_have_their_units() -> None:
    q = quantities(
        four_bar(
            tables={"gas": {"file": "gas.csv", "x": "angle deg", "y": "pressure bar", "period": 720}},
            parameters={"phi": 30, "p": "gas(0)"},
        )
    )
    assert [finding.code for finding in q.findings] == ["expression.not-constant"]
    assert q.dimensions.of(argument("gas")) == ANGLE
    assert q.dimensions.of(value("gas")) == PRESSURE
    assert q.dimensions.of("p") == PRESSURE


def test_a_table_that_nothing_uses_is_pure_unless_it_says_more() -> None:
    q = quantities(four_bar(tables={"a": {"points": [[0, 0], ["1 s", 2]]}}))
    assert not q.findings
    assert q.dimensions.of(argument("a")) == TIME


def test_a_table_of_a_load_whose_period_has_no_value(tmp_path: Path) -> None:
    """It is read before the values of the file are looked at."""
    examples = Path(__file__).parents[2] / "examples"
    text = (examples / "slider_crank_gas.yaml").read_text("utf-8").replace("period: 720", "period: 1/0")
    (tmp_path / "model.yaml").write_text(text, "utf-8")
    (tmp_path / "gas.csv").write_bytes((examples / "gas.csv").read_bytes())
    found = [(finding.code, finding.element) for finding in lw.check(tmp_path / "model.yaml")]
    assert found == [("value.not-finite", "tables.gas.period")]
