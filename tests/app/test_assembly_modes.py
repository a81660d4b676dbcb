"""The modes of a file: command, study, Python, and what they write."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

import linkwright as lw
from graph.test_redundant import parallelogram
from helpers.examples import four_bar
from linkwright.app import modes_of_file
from linkwright.cli import cli
from linkwright.model.document import Document, save

EXAMPLES = Path(__file__).parents[2] / "examples"
BAR = """linkwright: 1
units: {length: mm, angle: deg, time: s}
links:
  frame: {points: {A: [0, 0], D: [100, 0]}}
  crank: {points: {A: [0, 0], B: [80, 0]}}
  coupler: {points: {B: [0, 0], C: [120, 0]}}
  rocker: {points: {D: [0, 0], C: [40, 0]}}
drives:
  motor: {turns: crank, on: frame, speed: 60 rpm, start: 60 deg}
"""


@pytest.fixture
def bar(tmp_path: Path) -> Path:
    path = tmp_path / "bar.yaml"
    path.write_text(BAR, encoding="utf-8")
    return path


def call(*words: Any) -> Any:
    return CliRunner().invoke(cli, [str(word) for word in words])


def test_the_command_prints_modes_circuits_and_lines(bar: Path) -> None:
    done = call("modes", bar)
    assert done.exit_code == 0
    for words in ("C: left of B-D", "C: right of B-D", "The list is complete", "from 51.3178 to 125.1 deg"):
        assert words in done.output


def test_the_command_as_json(bar: Path) -> None:
    data = json.loads(call("modes", "--json", bar).output)
    assert data["complete"] is True
    assert data["findings"] == []
    assert [mode["assembly"] for mode in data["modes"]] == [["C: left of B-D"], ["C: right of B-D"]]
    assert [(mode["circuit"], mode["branch"]) for mode in data["modes"]] == [(1, 1), (1, 2)]
    (circuit,) = data["circuits"]
    assert circuit["modes"] == [1, 2]
    assert [branch["modes"] for branch in circuit["branches"]] == [[1], [2]]
    # Dead points by the cosine rule: B and D are 120 - 40 and 120 + 40 mm apart.
    assert circuit["branches"][0]["low"] == pytest.approx(51.3178, abs=1e-4)
    assert circuit["branches"][0]["high"] == pytest.approx(125.0996, abs=1e-4)
    assert data["modes"][0]["points"]["B"] == pytest.approx([40.0, 69.282032], abs=1e-6)


def test_the_lines_can_be_pasted(bar: Path) -> None:
    for mode in modes_of_file(bar).summary["modes"]:
        text = BAR + "assembly:\n" + "".join(f"  {line}\n" for line in mode["assembly"])
        bar.write_text(text, encoding="utf-8")
        assert modes_of_file(bar).summary["modes"][mode["number"] - 1]["own"]


@pytest.mark.parametrize(
    ("change", "codes", "exit_code"),
    [
        (("[120, 0]", "[1, 0]"), ["assembly.no-mode"], 1),
        (("D: [0, 0], C", "D: [0, 0], X"), ["structure.loose"] * 2, 1),
        (("length: mm, ", ""), ["expression.undeclared-unit"], 2),
        (("linkwright: 1", "linkwright: 1\nstudies: {modes: {drive: engine}}"), ["name.unknown"], 2),
        (("linkwright: 1", "linkwright: 1\nstudies: {modes: {at: 3 mm}}"), ["expression.units-conflict"], 2),
        (("linkwright: 1", "linkwright: 1\nstudies: {modes: {at: 1 s/0}}"), ["value.not-finite"], 2),
        (("linkwright: 1", "linkwright: 1\nstudies: {modes: {at: later}}"), ["name.unknown-parameter"], 2),
        (("linkwright: 1", "linkwright: 1\nstudies: {modes: {when: 3}}"), ["file.unknown-key"], 2),
        (("linkwright: 1", "linkwright: one"), ["file.version"], 2),
    ],
)
def test_what_is_wrong_is_found_with_its_code(
    bar: Path, change: tuple[str, str], codes: list[str], exit_code: int
) -> None:
    bar.write_text(BAR.replace(*change), encoding="utf-8")
    job = modes_of_file(bar)
    assert [finding.code for finding in job.examined.findings] == codes
    assert all(finding.line for finding in job.examined.findings if finding.path)
    assert job.exit_code == call("modes", bar).exit_code == exit_code
    with pytest.raises(lw.ModelError):
        lw.modes(bar)


def test_a_missing_file(tmp_path: Path) -> None:
    assert call("modes", tmp_path / "nowhere.yaml").exit_code == 2
    with pytest.raises(lw.ModelError):
        lw.modes(tmp_path / "nowhere.yaml")


def test_the_study_stands_in_summary_and_report(tmp_path: Path) -> None:
    job = lw.run(EXAMPLES / "sauer_platform.yaml", out=tmp_path)
    assert job.exit_code == 0
    summary = json.loads((tmp_path / "summary.json").read_text(encoding="utf-8"))
    assert [mode["own"] for mode in summary["modes"]["modes"]] == [True, False]
    assert "drawings" not in summary["modes"]
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert '<section id="modes">' in page
    assert page.count('<svg class="lw mode"') == 2
    assert "B1: [2.00000, 1.00000]" in page
    assert '<a href="#modes">' in page


def test_no_study_no_section(tmp_path: Path) -> None:
    lw.run(Document.model_validate(four_bar(studies={"cycle": {"turns": "1 motor", "samples": 8}})), out=tmp_path)
    assert '<section id="modes">' not in (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "modes" not in json.loads((tmp_path / "summary.json").read_text(encoding="utf-8"))


def test_names_are_escaped_in_drawings(tmp_path: Path) -> None:
    data = four_bar(name="a <b>", studies={"cycle": {"turns": "1 motor", "samples": 8}, "modes": {}})
    lw.run(Document.model_validate(data), out=tmp_path)
    assert "<b>" not in (tmp_path / "report.html").read_text(encoding="utf-8").split("<h1>")[1].split("</h1>")[0]


def test_a_parallelogram_names_its_change_points() -> None:
    outcome = lw.modes(Document.model_validate(parallelogram()))
    from linkwright.studies.modes.report import circuit_text, modes_data

    data = modes_data(outcome)
    assert [sorted(abs(v) for v in c["change_points"])[-1] for c in data["circuits"]] == pytest.approx(
        [180.0] * 2, abs=1e-4
    )
    assert "change points" in str(circuit_text(data["circuits"][0], data))


def test_a_saved_document_gives_the_same(tmp_path: Path) -> None:
    document = Document.model_validate(four_bar())
    save(document, tmp_path / "m.yaml")
    assert [m.lines for m in lw.modes(document).modes] == [m.lines for m in lw.modes(tmp_path / "m.yaml").modes]
