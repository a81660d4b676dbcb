"""What the export writes, and what it says of bad input."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from linkwright.findings import ModelError

FOUR_BAR: dict[str, Any] = {
    "linkwright": 1,
    "name": "Hinge",
    "units": {"length": "mm", "angle": "deg"},
    "parameters": {"a": 40},
    "links": {
        "frame": {"points": {"O": [0, 0], "D": [100, 0]}},
        "crank": {"points": {"O": [0, 0], "B": ["a", 0]}},
        "coupler": {"points": {"B": [0, 0], "C": [120, 0]}},
        "rocker": {"points": {"D": [0, 0], "C": [80, 0]}},
    },
    "assembly": {"C": "left of B-D"},
    "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 40}},
}


def document(**changes: Any) -> lw.Document:
    return lw.Document.model_validate({**FOUR_BAR, **changes})


def exported(model: lw.Document | None = None, **options: Any) -> Any:
    return lw.export(model or document(), "process-simulate", **options)


def codes(model: lw.Document | None = None, **options: Any) -> list[str]:
    """The codes of all that is wrong."""
    try:
        return [finding.code for finding in exported(model, **options).failures]
    except ModelError as error:
        return [finding.code for finding in error.findings]


def test_the_files_and_the_summary() -> None:
    done = exported(names={"O": "j2", "B": "j3", "C": "j4"}, left_out=["D"], range=[0, 90], zero=10)
    assert done.done
    assert [*done.files] == ["joint_functions.txt", "joint_functions.cs", "check_table.csv", "joint_functions.html"]
    functions = done.summary["functions"]
    assert [*functions] == ["j4", "j3"]
    assert done.summary["limits"]["j2"] == {
        "low": pytest.approx(math.radians(-10)), "high": pytest.approx(math.radians(80)), "unit": "rad",
    }  # fmt: skip
    assert done.summary["max_error"] < 1e-8
    lines = done.files["joint_functions.txt"].splitlines()
    assert {text for text in lines if text and not text.startswith("#")} == {*functions.values()}
    for name, text in functions.items():
        assert f'joints["{name}"].KinematicsFunction = "{text}";' in done.files["joint_functions.cs"]
    assert done.sentences


def test_stops_count_as_the_joint_does() -> None:
    done = exported(stops=[-10, 30], flipped=["O"])
    assert [done.summary["range"][key] for key in ("from", "to", "zero")] == pytest.approx([10, 50, 40])
    assert done.summary["limits"]["O"]["high"] == pytest.approx(math.radians(30))


def test_the_check_table_is_the_solvers_motion() -> None:
    """Against the law of cosines: the angle at C between coupler and rocker."""
    done = exported(range=[0, 90])
    rows = list(csv.DictReader(io.StringIO(done.files["check_table.csv"])))
    assert [*rows[0]] == ["T(O) [deg]", "T(C) [deg]", "T(B) [deg]", "T(D) [deg]"]
    assert sum(float(row["T(O) [deg]"]) == 0 for row in rows) == 1

    def inner(theta: float) -> float:
        square = 40**2 + 100**2 - 2 * 40 * 100 * math.cos(math.radians(theta))
        return math.degrees(math.acos((120**2 + 80**2 - square) / (2 * 120 * 80)))

    for row in rows:
        expected = inner(40 + float(row["T(O) [deg]"])) - inner(40)
        assert abs(float(row["T(C) [deg]"])) == pytest.approx(abs(expected), abs=1e-8)


def test_options_stand_in_the_file_and_are_overruled(tmp_path: Path) -> None:
    model = document(exports={"process-simulate": {"dialect": "wizard", "range": [0, 90]}})
    assert "atan2" in "".join(exported(model).summary["functions"].values())
    assert "sqrt" in "".join(exported(model, dialect="seed").summary["functions"].values())


def test_everything_wrong_with_the_options_is_told_at_once() -> None:
    found = codes(names={"X": "j1", "B": "2nd", "C": "j", "D": "j"}, flipped=["Y"], left_out=["O"], range=[90, 0])
    assert sorted(found) == [
        "functions.left-out", "functions.name", "functions.same-name",
        "name.unknown", "name.unknown", "value.not-rising",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"dialect": "latin"}, "export.choice"),
        ({"decimals": 3}, "export.options"),
        ({"range": ["0 mm", "20 mm"]}, "expression.units-conflict"),
        ({"range": [0, 1e9]}, "study.wide-range"),
        ({"stops": [0, 1e9]}, "study.wide-range"),
        ({"zero": "20 mm"}, "expression.units-conflict"),
        ({"range": [30, 90], "stops": [0, 20]}, "functions.two-ranges"),
        ({"longest": 25}, "functions.length"),
    ],
)
def test_a_wrong_option_is_told(options: dict[str, Any], code: str) -> None:
    assert codes(**options) == [code]


def test_names_that_the_tool_may_not_take() -> None:
    data = {key: value for key, value in FOUR_BAR.items() if key != "assembly"}
    links = {link: {"points": {{"C": "销"}.get(p, p): at for p, at in entry["points"].items()}}
             for link, entry in FOUR_BAR["links"].items()}  # fmt: skip
    model = lw.Document.model_validate({**data, "links": links, "assembly": {"销": "left of B-D"}})
    assert codes(model) == ["functions.name"]
    assert codes(model, names={"销": "pin"}) == []


def test_two_drives_and_none_that_depend() -> None:
    links = {**FOUR_BAR["links"], "rocker": {"points": {"E": [0, 0], "C": [80, 0]}},
             "slide": {"points": {"D": [0, 0], "E": [10, 0]}}}  # fmt: skip
    second = {"turns": "slide", "on": "frame", "speed": "5 rpm", "start": 0}
    drives = {**FOUR_BAR["drives"], "second": second}
    assert codes(document(links=links, drives=drives, assembly={"C": "left of B-E"})) == ["functions.drives"]
    alone = {name: FOUR_BAR["links"][name] for name in ("frame", "crank")}
    assert codes(document(links=alone, assembly={})) == ["functions.no-dependent"]
    assert codes(left_out=["B", "C", "D"]) == ["functions.no-dependent"]


def test_more_joints_than_the_tool_takes() -> None:
    """Rows of links, each pair on the one before: 2 + 3 n joints."""
    links = {name: {"points": dict(entry["points"])} for name, entry in FOUR_BAR["links"].items()}
    assembly = dict(FOUR_BAR["assembly"])
    links["rocker"]["points"]["E0"] = [60, 30]
    for n in range(21):
        links["frame"]["points"][f"G{n}"] = [120 * (n + 2), 0]
        links[f"rod{n}"] = {"points": {f"E{n}": [0, 0], f"F{n}": [115, 0]}}
        links[f"arm{n}"] = {"points": {f"G{n}": [0, 0], f"F{n}": [70, 0], f"E{n + 1}": [60, 10]}}
        assembly[f"F{n}"] = f"left of E{n}-G{n}"
    model = document(links=links, assembly=assembly)
    assert "functions.too-many" in codes(model)


@pytest.mark.parametrize(
    ("key", "asked", "flipped", "ends"),
    [
        ("range", [0, 170], [], (-1, 1)),
        ("stops", [-30, 170], [], (-1, 1)),
        ("stops", [-30, 170], ["O"], (1, -1)),
    ],
)
def test_what_crosses_a_toggle_is_told_the_largest(key: str, asked: Any, flipped: Any, ends: tuple[int, int]) -> None:
    """Coupler and rocker in line at +-end, cos = (a2 + d2 - (b + c)2)/(2 a d); short of it by 0.1 % of the range."""
    end = 0.998 * math.degrees(math.acos((160**2 + 100**2 - 200**2) / (2 * 160 * 100)))
    model = document(parameters={"a": 160})
    (failure,) = exported(model, **{key: asked}, flipped=flipped).failures
    assert (failure.code, failure.path[-1]) == ("functions.toggle", key)
    offered = [float(failure.data["low"]), float(failure.data["high"])]
    start = 0 if key == "range" else 40
    sign = -1 if flipped else 1
    assert offered == pytest.approx([sign * (side * end - start) for side in ends], abs=0.02)
    assert exported(model, **{key: offered}, flipped=flipped).done


@pytest.mark.parametrize("options", [{}, {"range": [20, 60]}])
def test_a_zero_pose_beyond_a_toggle_is_told_where_it_may_be(options: dict[str, Any]) -> None:
    model = document(parameters={"a": 160})
    (failure,) = exported(model, zero=150, **options).failures
    assert (failure.code, failure.path[-1]) == ("functions.zero", "zero")
    assert exported(model, zero=failure.data["high"], **options).done


def test_pivots_in_one_place_are_pointed_out() -> None:
    """A four-bar without a base turns as one piece."""
    links = {**FOUR_BAR["links"], "frame": {"points": {"O": [0, 0], "D": [0, 0]}}}
    done = exported(document(links=links, parameters={"a": 60}))
    assert done.done
    (warning,) = done.warnings
    assert warning.code == "functions.still"
    assert str(warning.data["joints"]) == "C, B"
    assert not exported().warnings


def test_a_mechanism_that_starts_at_a_toggle_is_refused() -> None:
    """Coupler and rocker in line at the start: cos = (a2 + d2 - (b + c)2)/(2 a d)."""
    end = math.degrees(math.acos((160**2 + 100**2 - 200**2) / (2 * 160 * 100)))
    drives = {"motor": {**FOUR_BAR["drives"]["motor"], "start": end}}
    assert codes(document(parameters={"a": 160}, drives=drives)) == ["functions.error"]
