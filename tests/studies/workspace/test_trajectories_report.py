"""Trajectories of a workspace, written: what stands in the table, the CSV and the pictures."""

from __future__ import annotations

import csv
import io
import re
from xml.etree import ElementTree

import numpy as np
import pytest
from numpy.typing import NDArray

from helpers.shown import blocks, heads, rows
from helpers.workspaces import arm, five_bar, performed
from linkwright.app.job import Job
from linkwright.drawing.plane import PicturePlane
from linkwright.presentation.blocks import Charts
from linkwright.studies.workspace.outcome import WorkspaceOutcome
from linkwright.studies.workspace.report import report
from linkwright.studies.workspace.trajectories_report import (
    trajectories_charts,
    trajectories_csv,
    trajectories_sentences,
    trajectories_svg,
    trajectories_tables,
)
from linkwright.studies.workspace.trajectory_picture import LARGEST, ColouredLine, Scale, trajectory_picture


@pytest.fixture(scope="module")
def job() -> Job:
    return performed(five_bar(**{"for": {"l": [11, 12]}}, trajectories={"hold": "servo", "every": "30 deg"}))


@pytest.fixture(scope="module")
def outcome(job: Job) -> WorkspaceOutcome:
    assert job.workspace is not None
    return job.workspace


def placed(text: str) -> list[NDArray[np.float64]]:
    """The lines of a path of the picture, in its pixels: (2, n) each."""
    lines = []
    for part in text.split("M")[1:]:
        start, _, ways = part.partition("l")
        numbers = [int(n) for n in re.findall(r"-?\d+", ways)]
        steps = np.array([[int(n) for n in start.split()], *np.array(numbers).reshape(-1, 2).tolist()])
        lines.append(np.cumsum(steps, axis=0).T / 10)
    return lines


def test_the_csv_holds_places_on_both_couplers(outcome: WorkspaceOutcome) -> None:
    lines = [*csv.DictReader(io.StringIO(trajectories_csv(outcome) or ""))]
    assert [*lines[0]] == ["l [mm]", "mode", "servo [deg]", "stretch", "motor [deg]", "x [mm]", "y [mm]"]
    names = ("l [mm]", "servo [deg]", "motor [deg]", "x [mm]", "y [mm]")
    length, servo, motor, x, y = (np.array([float(row[name]) for row in lines]) for name in names)
    for pin in (10 * np.exp(1j * np.radians(motor)), 10 + 10 * np.exp(1j * np.radians(servo))):
        assert np.abs(np.abs(x + 1j * y - pin) - length).max() < 1e-9
    assert {row["mode"] for row in lines} == {"C: left of B-D", "C: right of B-D"}
    assert {*np.round(servo, 9).tolist()} <= {*np.arange(0.0, 360, 30).tolist()}
    assert {*length.tolist()} == {11, 12}


def test_the_table_and_the_sentence(outcome: WorkspaceOutcome, job: Job) -> None:
    (table,) = trajectories_tables(outcome)
    entries = job.summary["workspace"]["trajectories"]
    assert len(table.rows) == len(entries) == 4
    assert heads(table)[:2] == ["l", "Mode"] and "Full range of motor at" in heads(table)
    assert rows(table)[0][3:6] == ["0 .. 330", "deg", f"{entries[0]['assembled']}/12"]
    assert "12 constant values of servo" in str(trajectories_sentences(outcome)[0])


def test_pictures_of_a_mode_have_the_same_axes_and_all_lie_in_their_region(outcome: WorkspaceOutcome) -> None:
    charts = trajectories_charts(outcome)
    assert [chart.step for chart in charts] == [(0,), (0,), (1,), (1,)]
    stacks: dict[str, list[str]] = {}
    for chart in charts:
        stacks.setdefault(str(chart.stack), []).append(chart.drawing)
    for drawings in stacks.values():
        axes = {re.search(r'<path class="grid" d="([^"]+)"', drawing).group(1) for drawing in drawings}  # type: ignore[union-attr]
        assert len(drawings) == 2 and len(axes) == 1


def test_lines_lie_where_the_point_goes(outcome: WorkspaceOutcome) -> None:
    """Each place of the picture, back in mm by the numbers at its axes, lies 12 mm from the held crank's end."""
    chart = trajectories_charts(outcome)[2]
    root = ElementTree.fromstring(chart.drawing)
    space = "{http://www.w3.org/2000/svg}"
    texts = [(t.text.replace("−", "-"), t) for t in root.iter(f"{space}text") if t.text and t.text[-1].isdigit()]
    along = [(float(text), float(t.get("x", ""))) for text, t in texts if t.get("text-anchor") == "middle"]
    up = [(float(text), float(t.get("y", "")) - 4) for text, t in texts if t.get("text-anchor") == "end"]
    along = [one for one in along if one[0] <= 30][: len(along) - 9]
    (x1, a1), (x2, a2), (y1, b1), (y2, b2) = along[0], along[-1], up[0], up[-1]
    ways = root.find(f"{space}g[@class='trajectories']")
    assert ways is not None and ways.get("transform") == "scale(0.1)"
    seen = set()
    for path in ways:
        held = float(re.fullmatch(r"servo = (\S+) deg", path[0].text or "").group(1))  # type: ignore[union-attr]
        pin = 10 + 10 * np.exp(1j * np.radians(held))
        for line in placed(path.get("d", "")):
            x = x1 + (line[0] - a1) * (x2 - x1) / (a2 - a1)
            y = y1 + (line[1] - b1) * (y2 - y1) / (b2 - b1)
            assert np.abs(np.abs(x + 1j * y - pin) - 12).max() < 0.02
        seen.add(path.get("stroke"))
    assert len(seen) == len(ways) > 6


def test_the_file_is_sound_and_small(outcome: WorkspaceOutcome) -> None:
    text = trajectories_svg(outcome) or ""
    root = ElementTree.fromstring(text)
    words = " ".join(root.itertext())
    assert "Trajectories of C at constant servo" in words and "l = 11 mm" in words and "l = 12 mm" in words
    assert len(text) / 4 < 400_000
    idents = re.findall(r'id="([^"]+)"', text)
    assert len(idents) == len({*idents}) == 4
    assert [f"url(#{one})" in text for one in idents] == [True] * 4


def test_many_trajectories_are_thinned() -> None:
    angle = np.linspace(0, 2 * np.pi, 3000)
    ways = [
        ColouredLine(k, [np.stack([np.cos(3 * angle) * (1 + k / 720), np.sin(2 * angle)])], f"{k}") for k in range(720)
    ]
    plane = PicturePlane((-2, -1, 2, 1), "mm")
    drawing = trajectory_picture(plane, ways, Scale(0, 720, "mm", False, "held"), "M0 0Z", [], [], "title")
    assert LARGEST / 4 < len(drawing) < 400_000
    assert drawing.count("<title>") == 180  # every fourth
    few = trajectory_picture(plane, ways[:20], Scale(0, 720, "mm", False, "held"), "M0 0Z", [], [], "title")
    assert few.count("<title>") == 20


def test_a_mechanism_without_other_values_has_no_slider() -> None:
    job = performed(arm(trajectories={"steps": 4}))
    assert job.workspace is not None
    (pictures,) = blocks(report(job.workspace), Charts)
    assert pictures.sliders == [] and len(pictures.charts) == 2
    assert trajectories_charts(job.workspace)[0].step == ()


def test_marks_are_round() -> None:
    assert Scale(0, 360, "deg", True, "").marks() == [0, 45, 90, 135, 180, 225, 270, 315, 360]
    assert Scale(20, 100, "deg", False, "").marks() == [*range(20, 101, 10)]
    assert Scale(50, 80, "mm", False, "").marks() == pytest.approx([50, 55, 60, 65, 70, 75, 80])
    assert Scale(5, 5, "mm", False, "").marks() == [5]
