"""Two hinges that mirror each other: names, signs, and that both move in step with one master."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.exports.process_simulate import evaluator
from linkwright.exports.process_simulate.dialects import DIALECTS

from .test_masters import closed, found, four_bar, hinge

EXAMPLES = Path(__file__).parents[3] / "examples"


def moved(done: Any, dialect: str, master: str, at: Any) -> dict[str, Any]:
    """The joints' values by the texts of the file of C#, from those of the master."""
    texts = re.findall(r'joints\["(\w+)"\]\.KinematicsFunction = "(.*)";', done.files["joint_functions.cs"])
    kinds = {master: done.summary["driving"]["kind"]} | {n: j["kind"] for n, j in done.summary["joints"].items()}
    rows = evaluator.evaluate(texts, dialect, kinds, master, at)
    return {master: at, **dict(zip((name for name, _ in texts), rows, strict=True))}


@pytest.mark.parametrize("dialect", [*DIALECTS])
@pytest.mark.parametrize("master", ["O", "B", "C", "D"])
def test_both_hinges_move_as_two_circles_say(dialect: str, master: str) -> None:
    """The mirror image of a four-bar has all angles the other way."""
    shape, theta = (40.0, 120.0, 80.0, 100.0, 1.0), np.linspace(0.9, 2.7, 101)
    document = lw.Document.model_validate(four_bar(*shape, 1.8))
    ends = {"range": [0.9, 2.7]}
    done = lw.export(document, "process-simulate", dialect=dialect, master=master, mirror={}, **ends)
    assert done.done, done.failures
    own = {joint: row - row[50] for joint, row in closed(*shape, theta).items()}
    values = moved(done, dialect, f"{master}_l", own[master])
    assert values.keys() == {f"{joint}{side}" for joint in "OBCD" for side in ("_l", "_r")}
    for joint, row in own.items():
        assert values[f"{joint}_l"] == pytest.approx(row, abs=2e-8)
        assert values[f"{joint}_r"] == pytest.approx(-row, abs=2e-8)
    # The second hinge asks for the first one in one function only.
    texts = done.summary["functions"]
    assert [name for name, text in texts.items() if name.endswith("_r") and "_l)" in text] == [f"{master}_r"]


@pytest.mark.parametrize("signs", ["mirrored", "same"])
def test_slides_count_the_same_on_both_sides(signs: str) -> None:
    done = lw.export(lw.load(EXAMPLES / "slider_crank.yaml"), "process-simulate", mirror={"signs": signs})
    at = np.linspace(0.1, 3.0, 21)
    values = moved(done, "seed", "A_l", at)
    assert values["guide_r"] == pytest.approx(values["guide_l"], abs=1e-7)
    turn = -1 if signs == "mirrored" else 1
    for joint in "ABC":
        assert values[f"{joint}_r"] == pytest.approx(turn * values[f"{joint}_l"], abs=1e-8)


def test_names_and_what_the_files_say() -> None:
    done = lw.export(hinge(mirror={"prefixes": ["L_", "R_"]}), "process-simulate")
    assert done.summary["functions"]["R_j2"] == "-T(L_j2)"
    assert [name for name, joint in done.summary["joints"].items() if joint["mirrored"]] == ["R_j2", "R_j4", "R_j3"]
    assert "L_j2 drives, and R_j2 on the second one follows it." in done.files["joint_functions.txt"]
    assert done.files["joint_functions.html"].partition("<script")[0].count("on the mirrored hinge") == 3
    head, *rows = csv.reader(io.StringIO(done.files["check_table.csv"]))
    assert [name.split(" ")[0] for name in head][3:] == ["T(R_j2)", "T(R_j4)", "T(R_j3)"]
    table = np.array(rows, dtype=float)
    assert table[:, 3:] == pytest.approx(-table[:, :3], abs=1e-8)
    assert "-0.000000000" not in done.files["check_table.csv"]


@pytest.mark.parametrize(
    ("mirror", "code"),
    [
        ({"suffixes": ["_l", "_l"]}, "functions.mirror-names"),
        ({"prefixes": ["L", "L"], "suffixes": ["", ""]}, "functions.mirror-names"),
        ({"signs": "both"}, "export.choice"),
        ({"suffix": ["_l", "_r"]}, "file.unknown-key"),
        ({"prefixes": ["l", "r "]}, "functions.name"),
    ],
)
def test_a_wrong_mirror_is_told(mirror: dict[str, Any], code: str) -> None:
    assert {finding.code for finding in found(mirror=mirror)} == {code}
