"""Wanted paths and required figures asked of the study: the paper's five-bar to the end, closed forms, bad input."""

from __future__ import annotations

import csv
import io
import json
from copy import deepcopy
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from ruamel.yaml import YAML

import linkwright as lw
from helpers.shown import blocks, tables
from helpers.workspaces import arm, findings, four_bar, performed
from linkwright.app.job import Job
from linkwright.cli import cli
from linkwright.model.document import parse_document, plain
from linkwright.presentation.blocks import Table
from linkwright.studies.workspace.files import svg
from linkwright.studies.workspace.path_files import drives_yaml, laws_csv
from linkwright.studies.workspace.paths_report import path_charts
from linkwright.studies.workspace.report import report

EXAMPLE = Path(__file__).parents[3] / "examples" / "five_bar_path.yaml"
REACH = {"motor": "shoulder", "duration": "2 s"}


def moved(data: dict[str, Any], pasted: str, signals: list[str], t: Any) -> Any:
    """Signals of a model file with the pasted entries in the place of its own."""
    data = deepcopy(data)
    for section, entries in YAML(typ="safe", pure=True).load(pasted).items():
        data[section] = {**data.get(section, {}), **entries}
    document = parse_document({key: value for key, value in data.items() if key != "studies"})
    assert document is not None
    return lw.compile(document).evaluate(signals, t)


def columns(text: str | None) -> tuple[list[str], list[list[str]]]:
    assert text is not None
    head, *rows = csv.reader(io.StringIO(text))
    return head, rows


def test_the_papers_five_bar_to_the_end() -> None:
    """The points of examples/five_bar_path.csv come from the law 90° + 180° t/s - 40° cos(180° t/s) of the servo, to
    1e-5 mm. The law that is found is that one, to what 1e-3 mm of leave in dead positions makes of it; pasted into the
    file it moves P as the table of laws says, and through the points."""
    job = lw.run(EXAMPLE)
    assert job.exit_code == 0
    assert [finding.code for finding in job.found] == ["workspace.path-dead"]
    (entry,) = job.summary["workspace"]["paths"]
    assert entry["followed"] and entry["kept"] and entry["best"] and not entry["stretches"]
    assert (entry["reversals"], len(entry["limit_positions"]), entry["determinant"]) == ([], 4, 0.0)
    assert entry["determinant_of"] == "d(P.x, P.y)/d(motor, servo)"
    assert entry["period"] == pytest.approx(2.0) and entry["residual"] < 1e-3
    assert entry["drives"]["servo"]["value"] == pytest.approx({"from": 50, "to": 410, "unit": "deg"}, abs=2e-3)
    assert entry["drives"]["servo"]["speed"]["largest"] == pytest.approx(180 + 40 * np.pi, abs=0.1)
    assert entry["drives"]["motor"]["speed"]["largest"] == 180
    head, rows = columns(laws_csv(job.outcomes["workspace"]))
    table = np.array([row[2:] for row in rows], dtype=float).T
    t, servo = table[head.index("t [s]") - 2], table[head.index("servo.angle [deg]") - 2]
    assert servo == pytest.approx(90 + 180 * t - 40 * np.cos(np.pi * t), abs=0.015)
    assert job.examined.document is not None
    signals = ["P.x", "P.y", "motor.power", "servo.power"]
    pasted = drives_yaml(job.outcomes["workspace"])
    assert pasted is not None
    ran = moved(plain(job.examined.document), pasted, signals, t)
    assert ran[:2] * 1e3 == pytest.approx(table[2:4], abs=1e-6)
    assert ran[2:] == pytest.approx(table[[8, 13]], abs=1e-6)
    required, largest = job.summary["workspace"]["fits"]
    assert required["fits"] and required["scale"] == pytest.approx(largest["radius"] / 6, abs=1e-3)
    assert required["margin"] == pytest.approx(largest["radius"] - 6, abs=5e-3)


@pytest.fixture(scope="module")
def ring() -> Job:
    """A circle in the region of one of both modes, at another angle of P than the file has."""
    data = plain(lw.load(EXAMPLE))
    data["parameters"]["alpha"] = 0
    path = {"x": "28 + 3*cos(2*pi*u)", "y": "l5 - 6.2 + 3*sin(2*pi*u)", "motor": "motor", "duration": "1 s"}
    asked = {"point": "P", "chord": 1e-4, "for": {"alpha": [60]}, "paths": {"ring": {**path, "samples": 41}}}
    return performed(data | {"studies": {"workspace": asked}})


def test_modes_and_values_are_told_apart_and_the_best_is_pasted(ring: Job) -> None:
    assert ring.exit_code == 0 and not ring.found  # one mode alone can't: no failure
    left, right = ring.summary["workspace"]["paths"]
    assert (left["mode"], left["followed"], left["alpha"]) == ("C: left of B-D", True, 60)
    assert left["best"] and left["determinant"] > 0 and left["residual"] < 1e-12 and left["period"] == 1.0
    assert (right["mode"], right["followed"], right["best"]) == ("C: right of B-D", False, False)
    assert [stretch["why"] for stretch in right["stretches"]] == ["outside"]
    pasted, document = drives_yaml(ring.outcomes["workspace"]), ring.examined.document
    assert pasted is not None and document is not None
    t = np.linspace(0.0, 2.5, 101)  # beyond the period
    place = moved(plain(document), pasted, ["P.x", "P.y"], t) * 1e3
    exact = np.stack([28 + 3 * np.cos(2 * np.pi * t), 23.8 + 3 * np.sin(2 * np.pi * t)])
    assert place == pytest.approx(exact, abs=1e-6)


def test_how_they_are_written(ring: Job) -> None:
    outcome = ring.outcomes["workspace"]
    shown = tables(blocks(report(outcome), Table))
    assert [row[3] for row in shown["paths"]] == ["yes (best)", "not at u = 0 .. 1: outside by 14.57 mm"]
    assert [row[1] for row in shown["drives"]] == ["motor", "servo"]
    head, rows = columns(laws_csv(outcome))
    assert head[:7] == ["path", "alpha [deg]", "mode", "t [s]", "u", "P.x [mm]", "P.y [mm]"]
    assert len(rows) == 41 and all(len(row) == len(head) for row in rows)
    drawn = svg(outcome)
    assert drawn is not None and drawn.count('class="over wanted" points') == 1
    assert 'class="over blocked" points' not in drawn
    assert len(path_charts(outcome)) == 5


def test_outside_a_path_and_figures_are_told_by_how_much(tmp_path: Path) -> None:
    """The arm reaches from 10 to 70 mm. A line along y = 60 leaves that at x = sqrt(70² - 60²), up to hypot(60, 60) -
    70; a circle of 31 about (40, 0) lies 1 over each rim; the largest has half of the ring's width."""
    paths = {"line": {"points": [[0, 60], [30, 60], [60, 60]], "between": "linear", **REACH}}
    fits = {
        "round": {"circle": "31 mm", "centre": [40, 0]},
        "slab": {"rectangle": [20, 10], "angle": "90 deg", "centre": [60, 0]},
        "most": {"largest": "circle"},
        "square": {"largest": "rectangle", "aspect": 1, "angle": 45},
    }
    document = parse_document(arm(paths=paths, fits=fits))
    assert document is not None
    lw.save(document, tmp_path / "arm.yaml")
    result = CliRunner().invoke(cli, ["workspace", str(tmp_path / "arm.yaml"), "--out", str(tmp_path / "out")])
    assert result.exit_code == 1
    assert "workspace.path-outside" in result.stderr and "workspace.fit-none" in result.stderr
    assert "path-none" not in result.stderr  # there is one region only
    entry = json.loads((tmp_path / "out" / "summary.json").read_text("utf-8"))["workspace"]
    (line,) = entry["paths"]
    (stretch,) = line["stretches"]
    assert not line["followed"] and stretch["why"] == "outside"
    assert stretch["from"] == pytest.approx(np.sqrt(1300) / 60, abs=1e-4)
    assert (stretch["to"], stretch["by"]) == pytest.approx((1.0, np.hypot(60, 60) - 70), abs=1e-2)
    assert "outside by 14.8" in " ".join(result.stdout.split())
    told = {one["figure"]: one for one in entry["fits"]}
    assert not told["round"]["fits"] and told["slab"]["fits"]
    assert (told["round"]["margin"], told["round"]["scale"]) == pytest.approx((-1, 30 / 31), abs=1e-2)
    assert told["slab"]["margin"] == pytest.approx(70 - np.hypot(65, 10), abs=1e-2)
    assert told["most"]["radius"] == pytest.approx(30, abs=2e-2) and told["most"]["at_most"] >= 30 - 1e-2
    assert told["square"]["width"] == told["square"]["height"] > 30
    drawn = (tmp_path / "out" / "workspace.svg").read_text("utf-8")
    assert drawn.count('class="over misses" points') == 1 and drawn.count('class="over fits" points') == 3
    assert drawn.count('class="over blocked" points') == 1
    assert not (tmp_path / "out" / "workspace_laws.csv").exists()


def test_a_servo_that_reverses_against_leave_is_a_failure_with_its_law_told() -> None:
    """The elbow bends more and less while the tip passes by: least far from the shoulder in the middle, at rest at
    both ends."""
    path = {"x": "40 - 80*u", "y": "30", **REACH, "timing": "rest", "never_reverse": True}
    job = performed(arm(chord=1e-3, paths={"pass": path}))
    assert job.exit_code == 1
    assert [finding.code for finding in job.found] == ["workspace.servo-reverses"]
    (entry,) = job.summary["workspace"]["paths"]
    assert entry["followed"] and not entry["kept"]
    assert entry["reversals"] == pytest.approx([1.0])
    law = job.outcomes["workspace"].parts["paths"].best["pass"].law
    assert np.abs(law.motor[1:, [0, -1]]).max() < 1e-12
    reach = np.hypot(*law.point)
    assert np.cos(law.servo[0]) == pytest.approx((reach**2 - 0.04**2 - 0.03**2) / (2 * 0.04 * 0.03), abs=1e-12)


def codes(data: dict[str, Any]) -> list[str]:
    return sorted(finding.code for finding in findings(data))


def test_what_is_wrong_is_told_at_once() -> None:
    paths = {
        "none": {"motor": "shoulder"},
        "both": {"points": [[1, 2]], "x": "u", "speed": 1, "duration": 1, "motor": "shoulder", "layer": "0"},
    }
    fits = {"none": {}, "both": {"circle": 1, "rectangle": [1, 2]}, "odd": {"circle": 1, "angle": 3}}
    expected = [
        "workspace.fit-kind",
        "workspace.fit-kind",
        "workspace.path-key",
        "workspace.path-key",
        "workspace.path-pace",
        "workspace.path-pace",
        "workspace.path-source",
        "workspace.path-source",
    ]
    assert codes(arm(paths=paths, fits=fits)) == expected
    paths = {
        "a": {"points": [[0, 40], [10, 40]], "motor": "sholder", "speed": "0 rpm"},
        "b": {"x": "40 kg", "y": "v", "motor": "elbow", "speed": "0 rpm"},
        "c": {"x": "40 + u", "y": "0", "motor": "elbow", "duration": "-1 s", "tolerance": "1 kg"},
        "d": {"points": [["1/0", 40], [10, 40]], "between": "linear", "motor": "elbow", "speed": "3 mm/s"},
    }
    fits = {"a": {"circle": "-3 mm"}, "b": {"rectangle": [10, 0], "angle": "1 mm"}}
    assert codes(arm(paths=paths, fits=fits)) == [
        *["expression.units-conflict"] * 5,
        "name.unknown",
        "value.not-finite",
        "workspace.not-positive",
        "workspace.not-positive",
        "workspace.not-positive",
        "workspace.path-name",
        "workspace.path-short",
        "workspace.path-still",
    ]


def test_files_that_cant_be_read_are_all_told(tmp_path: Path) -> None:
    (tmp_path / "bad.csv").write_text("x [mm],y [mm]\n1,a\n", encoding="utf-8")
    paths = {name: {"file": f"{name}.csv", **REACH} for name in ("gone", "bad")}
    document = parse_document(arm(chord=1e-2, paths=paths))
    assert document is not None
    with pytest.raises(lw.ModelError) as error:
        lw.run(document, folder=tmp_path)
    told = {("table.unreadable", "gone"), ("table.not-number", "bad")}
    assert {(finding.code, finding.path[3]) for finding in error.value.findings} == told
    assert {(finding.code, finding.path[3]) for finding in lw.check(document, tmp_path)} == told


def test_one_drive_follows_no_path() -> None:
    path = {"x": "u", "y": "1", "motor": "motor", "duration": 1}
    assert codes(four_bar(paths={"a": path}, fits={"b": {"circle": 1}})) == ["workspace.section-drives"] * 2
