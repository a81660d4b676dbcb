"""What is written of a file that asks for its limits, alone or beside a cycle."""

from __future__ import annotations

import json
import re
import textwrap
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from app.models import SOUND, STUCK
from helpers.shown import blocks, rows
from linkwright.cli import cli
from linkwright.presentation.blocks import Table, filled
from linkwright.report.build import report_data
from linkwright.studies.limits.report import report

ALONE = SOUND.split("studies:", maxsplit=1)[0] + "studies:\n  limits: {signals: [P.x], samples: 90}\n"
BOTH = SOUND + "  limits: {}\n"


@pytest.fixture
def write(tmp_path: Path) -> Any:
    def at(text: str) -> Path:
        path = tmp_path / "model.yaml"
        path.write_text(text, "utf-8")
        return path

    return at


def test_limits_alone_are_written_with_a_report(write: Any, tmp_path: Path) -> None:
    job = lw.run(write(ALONE), out=tmp_path / "out")
    assert job.exit_code == 0
    assert job.cycle is None
    assert {path.name for path in (tmp_path / "out").iterdir()} == {
        "linkwright-manifest.json",
        "report.html",
        "summary.json",
    }
    data = json.loads((tmp_path / "out" / "summary.json").read_text("utf-8"))
    assert data["done"] is True
    assert not {"run", "measures", "certificate"} & set(data)
    assert data["limits"]["samples"] == 90
    (found,) = data["limits"]["drives"]["motor"]["ranges"]
    assert found["full_turn"] is True
    assert found["low"] == {"at": 40.0, "kind": "window", "group": None, "what": None}
    swing = found["signals"]["rocker.angle"]
    assert swing["unit"] == "deg"
    assert swing["span"] == pytest.approx(73.7818196)
    assert swing["strokes"]["rising"] + swing["strokes"]["falling"] == pytest.approx(360)
    assert [c["kind"] for c in swing["limit_positions"]] == ["max", "min"]
    assert found["signals"]["P.x"]["unit"] == "mm"
    assert found["transmission"]["coupler-rocker"]["at"] == pytest.approx(360.0)
    assert data["limits"]["motion"] is None
    (loop,) = data["limits"]["four_links"]
    assert (loop["kind"], loop["turning"], loop["margin"]) == ("crank-rocker", ["crank"], pytest.approx(-20))


def test_the_report_of_limits_alone_runs_over_the_drives_value(write: Any) -> None:
    job = lw.run(write(ALONE))
    data = report_data(lw.load(write(ALONE)), job.outcomes)
    assert (data["time"]["unit"], data["time"]["label"]) == ("deg", "motor")
    assert data["time"]["values"][0] == pytest.approx(40)
    assert data["time"]["values"][-1] == pytest.approx(400)
    assert data["scene"]["time"] == data["time"]["values"]
    assert {plot["unit"] for plot in data["plots"]} == {"mm", "deg"}  # no rates, no forces
    assert {plot["group"] for plot in data["plots"]} == {"motion"}
    (section,) = data["sections"]
    assert section.name == "limits"
    assert [table.name for table in section.blocks if isinstance(table, Table) and filled(table)] == [
        "ranges", "signals", "limit_positions", "transmission", "four_links",
    ]  # fmt: skip


def test_limits_beside_a_cycle(write: Any, tmp_path: Path) -> None:
    job = lw.run(write(BOTH), out=tmp_path / "out")
    assert (tmp_path / "out" / "cycle.csv").exists()
    data = json.loads((tmp_path / "out" / "summary.json").read_text("utf-8"))
    assert data["measures"]["swing"]["value"] == pytest.approx(
        data["limits"]["motion"]["signals"]["rocker.angle"]["span"]
    )
    assert data["limits"]["motion"]["unit"] == "s"
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    assert '<section id="limits">' in page
    assert '<a href="#limits">' in page
    assert "Full rotation." in page
    assert job.limits is not None
    shown = [table for table in blocks(report(job.limits), Table) if table.rows]
    assert len(shown) > 4
    for table in shown:
        assert str(table.title) in page
        assert all(str(row[0]) in page for row in rows(table))


def test_the_gap_stands_in_the_page(write: Any, tmp_path: Path) -> None:
    lw.run(write(STUCK.split("studies:")[0] + "studies: {limits: {}}"), out=tmp_path / "out")
    page = (tmp_path / "out" / "report.html").read_text("utf-8")
    section = re.search(r'<section id="limits">(.*?)</section>', page, re.S)
    assert section
    assert "can&#x27;t be assembled between motor" in section[1]
    assert "triple-rocker" in section[1]


def test_what_stops_cycle_and_limits_is_told_once(write: Any) -> None:
    job = lw.run(write(STUCK + "  limits: {}\n"))
    assert [(f.code, f.severity) for f in job.found] == [("motion.cannot-assemble", "error")]
    assert job.exit_code == 1
    assert job.summary["limits"]["motion"] is None


def test_nor_is_it_told_twice_where_their_grids_see_it_otherwise(write: Any) -> None:
    """A start in line: the cycle's steps and the finer ones of the limits find the gap's edge with other digits."""
    text = """
        linkwright: 1
        units: {length: mm, angle: deg, time: s}
        sketch: {A: [0, 0], B: [50, 0], C: [150, 0], D: [200, 0]}
        links: {frame: {points: [A, D]}, crank: {points: [A, B]}, coupler: {points: [B, C]}, rocker: {points: [D, C]}}
        assembly: {C: left of B-D}
        drives: {motor: {turns: crank, on: frame, speed: 10, acceleration: 1, start: sketch}}
        studies: {cycle: {duration: 1 s, samples: 100}, limits: {}}
        """
    job = lw.run(write(textwrap.dedent(text)))
    assert [(f.code, f.severity) for f in job.found] == [("motion.cannot-assemble", "error")]


def test_a_fine_grid_is_drawn_on_few_steps(write: Any) -> None:
    job = lw.run(write(ALONE.replace("samples: 90", "samples: 5000")))
    data = report_data(lw.load(write(ALONE)), job.outcomes)
    assert len(data["time"]["values"]) == 721
    assert data["time"]["unit"] == "deg"


# The command.


def run(*words: str) -> tuple[int, str, str]:
    from click.testing import CliRunner

    result = CliRunner().invoke(cli, list(words))
    return result.exit_code, result.stdout, result.stderr


@pytest.mark.parametrize("text", [SOUND, ALONE, BOTH, SOUND.split("studies:", maxsplit=1)[0]])
def test_the_command_needs_no_study_in_the_file(write: Any, text: str) -> None:
    path = write(text)
    code, out, err = run("limits", str(path))
    assert (code, err) == (0, "")
    for word in ("motor", "Full rotation.", "73.78182", "26.38433", "crank-rocker", "1.355573"):
        assert word in out
    assert ("the motion" in out) == ("cycle" in text)
    assert [p.name for p in path.parent.iterdir()] == ["model.yaml"]


def test_the_command_as_json(write: Any) -> None:
    code, out, err = run("limits", str(write(BOTH)), "--json")
    data = json.loads(out)
    assert (code, err) == (0, "")
    assert set(data) == {"schema", "linkwright", "model", "date", "name", "done", "limits", "findings"}


def test_the_command_on_a_wrong_file(write: Any) -> None:
    code, out, err = run("limits", str(write(ALONE.replace("P.x", "Q.x"))))
    assert (code, out) == (2, "")
    assert "model.yaml:20: error studies.limits.signals.0: No element of this mechanism is called 'Q'." in err


def test_a_motion_that_stops_is_told_and_is_no_error_of_the_limits(write: Any) -> None:
    code, out, err = run("limits", str(write(STUCK)))
    assert code == 0
    assert "can't be assembled between motor = 93.8226 and 266.177 deg" in out
    assert "warning" in err
