"""Files that need a package which isn't installed: a run writes the others, and says what is missing."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

import linkwright as lw
from linkwright.app import job as jobs
from linkwright.cli import cli
from linkwright.studies import STUDIES

ARM = """linkwright: 1
units: {length: mm, angle: deg, time: s}
links:
  frame: {points: {A: [0, 0]}}
  upper: {points: {A: [0, 0], B: [60, 0]}}
  fore:  {points: {B: [0, 0], E: [25, 0]}}
drives:
  shoulder: {turns: upper, on: frame, speed: 10 rpm, start: 0 deg}
  elbow:    {turns: fore, on: upper, speed: 20 rpm, start: 90 deg}
studies:
  workspace: {point: E, chord: 0.001}
"""
CAM = """linkwright: 1
units: {length: mm, angle: deg, time: s}
links:
  frame: {points: {O: [0, 0], A: [85, 0]}}
  cam:   {points: {O: [0, 0]}}
  arm:   {points: {A: [0, 0], B: [90, 0]}}
drives: {shaft: {turns: cam, on: frame, speed: -15 deg/s, start: 0}}
laws: {lift: {over: angle, of: angle, segments: [{rise: 12, over: 90, law: cycloidal}, {dwell: 180},
  {fall: 12, over: 75, law: cycloidal}, {dwell: 15}]}}
cams: {seal: {cam: cam, follower: arm, on: frame, base: 39, roller: 20, at: B, law: lift, side: left of O-A}}
studies:
  cam: {blank: {thickness: 12}}
"""


def written(out: Path) -> set[str]:
    return {path.name for path in out.iterdir()}


@pytest.mark.parametrize(
    ("text", "missing"),
    [(ARM, {"ezdxf": "workspace.dxf"}), (CAM, {"ezdxf": "cam.dxf", "build123d": "cam.step"})],
)
def test_what_isnt_written_is_named_with_its_package(
    text: str, missing: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(jobs, "installed", lambda package: package not in missing)
    path = tmp_path / "model.yaml"
    path.write_text(text, encoding="utf-8")
    job = lw.run(path, tmp_path / "out")
    notes = [finding for finding in job.found if finding.code == "file.unwritten"]
    assert {(str(note.data["package"]), str(note.data["files"])) for note in notes} == {*missing.items()}
    assert all(note.severity == "note" and "linkwright[cad]" in note.mend for note in notes)
    assert job.exit_code == 0 and not written(tmp_path / "out") & {*missing.values()}
    assert [one["code"] for one in job.summary["findings"]] == ["file.unwritten"] * len(missing)
    assert all(name in (tmp_path / "out" / "report.html").read_text(encoding="utf-8") for name in missing.values())


def test_the_command_says_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jobs, "installed", lambda package: False)
    path = tmp_path / "model.yaml"
    path.write_text(CAM, encoding="utf-8")
    done = CliRunner().invoke(cli, ["cam", str(path), "--out", str(tmp_path / "out")])
    assert done.exit_code == 0 and "cam.step" in done.stderr + done.stdout
    assert "file.unwritten" in done.stderr + done.stdout


def test_with_the_packages_nothing_is_said(tmp_path: Path) -> None:
    for package in ("ezdxf", "build123d"):
        pytest.importorskip(package)
    path = tmp_path / "model.yaml"
    path.write_text(CAM, encoding="utf-8")
    job = lw.run(path, tmp_path / "out")
    assert job.found == [] and {"cam.dxf", "cam.step"} <= written(tmp_path / "out")


def test_what_has_nothing_to_hold_isnt_missed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a blank there is no solid."""
    monkeypatch.setattr(jobs, "installed", lambda package: False)
    path = tmp_path / "model.yaml"
    path.write_text(CAM.replace("cam: {blank: {thickness: 12}}", "cam: {}"), encoding="utf-8")
    (note,) = lw.run(path, tmp_path / "out").found
    assert str(note.data["files"]) == "cam.dxf"


def test_a_file_that_may_be_missing_says_when_it_is_due() -> None:
    """Of every study: a file with a package has an option that insists on it."""
    files = [file for study in STUDIES.values() for file in study.files.values() if file.needs]
    assert len(files) >= 5 and all(file.option for file in files)
