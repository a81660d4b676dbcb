"""What is written of a cam: the profile as CSV and DXF, the follower's motion as formulas, the page, the command."""

from __future__ import annotations

import csv
import io
import json
import math
import re
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from click.testing import CliRunner

import linkwright as lw
from helpers.heat_seal import NC, heat_seal, performed
from helpers.shown import blocks
from linkwright.app.job import Job
from linkwright.cli import cli
from linkwright.formulas.evaluate import value
from linkwright.model.document import parse_document
from linkwright.presentation.blocks import Charts
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.studies.cam.files import FILES
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.report import report


@pytest.fixture(scope="module")
def job() -> Job:
    blank = {"thickness": 12, "bore": 10}
    return performed(
        heat_seal(blank=blank, nc=NC, size={"base": [30, 50], "against": {"distance": [80, 90]}, "steps": 2})
    )


@pytest.fixture(scope="module")
def outcome(job: Job) -> CamOutcome:
    assert job.cam is not None
    return job.cam


def test_the_profile_as_a_table(outcome: CamOutcome) -> None:
    """Points a roller's radius apart along the normal, tangent to the normal, on the circles of the two dwells."""
    rows = list(csv.DictReader(io.StringIO(str(FILES["cam_profile.csv"].make(outcome)))))
    table = {key.split(" [")[0]: np.array([float(row[key]) for row in rows]) for key in rows[0]}
    assert table["theta"][[0, -1]].tolist() == [0, 360] and len(rows) == 721
    pitch, profile, normal = (np.stack([table[f"{n} x"], table[f"{n} y"]]) for n in ("pitch", "profile", "normal"))
    assert np.abs(pitch - profile - 20 * normal).max() < 1e-12
    way = np.diff(profile)
    middle = (normal[:, 1:] + normal[:, :-1]) / 2
    assert np.abs((way * middle).sum(axis=0)).max() < 2e-5  # of the steps' 0.4 mm
    dwell = (table["theta"] > 90) & (table["theta"] < 270)
    assert np.hypot(*profile[:, dwell]) == pytest.approx(table["profile radius"][dwell])
    assert np.ptp(table["lift"][dwell]) < 1e-12
    assert table["profile radius"].min() == pytest.approx(22.2145, abs=5e-3)  # between two steps


def test_the_motion_as_formulas(outcome: CamOutcome) -> None:
    """In degrees, as it says, over a turn of 1 s."""
    text = str(FILES["cam_motion.txt"].make(outcome))
    assert "lift in deg over t in s" in text and "sin, cos and tan take degrees" in text
    rows = [re.split(r" <=? t <=? |   +", line.strip()) for line in text.splitlines() if line.startswith("  ")]
    assert [float(row[0]) for row in rows] == pytest.approx([0, 0.25, 0.75, 345 / 360])
    for start, stop, formula in rows:
        t = np.linspace(float(start), float(stop), 7)[:-1]
        lift = np.broadcast_to(outcome.disc.look(2 * np.pi * t).lift.d[0], t.shape)
        assert np.radians(value(formula, t, degrees=True)) == pytest.approx(lift, abs=1e-12)


def test_a_file_in_radians_has_its_motion_in_degrees_too() -> None:
    data = heat_seal({"base": "39 mm"}) | {"units": {"length": "m", "angle": "rad"}}
    data["links"] = {
        "frame": {"points": {"O": [0, 0], "A": ["85 mm", 0]}},
        "cam": {"points": {"O": [0, 0]}},
        "arm": {"points": {"A": [0, 0], "B": ["90 mm", 0]}},
    }
    data["cams"]["heat_seal"]["roller"] = "20 mm"
    data["laws"]["swing"]["segments"] = [{"rise": "12 deg", "over": "90 deg", "law": "cycloidal"}, {"dwell": "180 deg"}]
    data["laws"]["swing"]["segments"] += [{"fall": "12 deg", "over": "75 deg", "law": "cycloidal"}, {"dwell": "15 deg"}]
    found = performed(data).cam
    assert found is not None
    assert "48*t - 1.90985931710274*sin(1440*t)" in str(FILES["cam_motion.txt"].make(found))


def test_the_drawing(outcome: CamOutcome) -> None:
    ezdxf = pytest.importorskip("ezdxf")
    drawing = ezdxf.read(io.StringIO(str(FILES["cam.dxf"].make(outcome))))
    (line,) = drawing.modelspace().query("LWPOLYLINE")
    assert line.closed and len(line) == len(outcome.first.elements)
    (bore,) = drawing.modelspace().query("CIRCLE")
    assert bore.dxf.radius == 10


def test_the_drawing_has_the_keyway(outcome: CamOutcome) -> None:
    """Whether the profile is drawn by arcs or by splines."""
    ezdxf = pytest.importorskip("ezdxf")
    for drawing in ("arcs", "splines"):
        blank = {"thickness": 12, "bore": 10, "key_width": 6, "key_depth": 2.8, "key_angle": "30 deg"}
        found = performed(heat_seal(blank=blank, drawing=drawing, tolerance="1e-3 mm", steps=36)).cam
        assert found is not None
        space = ezdxf.read(io.StringIO(str(FILES["cam.dxf"].make(found)))).modelspace()
        (bore,) = space.query('LWPOLYLINE[layer=="BORE"]')
        assert bore.closed and not space.query("CIRCLE")
        far = max(bore.get_points("xy"), key=lambda place: math.hypot(*place))
        assert math.hypot(*far) == pytest.approx(math.hypot(12.8, 3))
        off = math.atan2(far[1], far[0]) - math.radians(30)
        assert abs(off) == pytest.approx(math.atan2(3, 12.8))


def test_summary_and_page(job: Job, outcome: CamOutcome) -> None:
    entry = json.loads(json.dumps(job.summary["cam"], allow_nan=False))
    assert entry["contour"]["area"] == pytest.approx(outcome.area * 1e6)
    assert entry["volume"]["value"] == pytest.approx((outcome.area * 1e6 - math.pi * 100) * 12)
    assert np.shape(entry["size"]["map"]["margins"]) == (3, 3)
    assert entry["nc"]["grbl"]["written"] and entry["checks"][0]["limit"] is None
    ElementTree.fromstring(str(FILES["cam.svg"].make(outcome)))
    assert job.examined.document is not None
    data = report_data(job.examined.document, job.outcomes)
    (pictures,) = blocks(report(outcome), Charts)
    assert len(pictures.charts) == 11
    text = page(data)
    for chart in pictures.charts:
        assert chart.drawing in text if chart.content is None else f'data-chart="{chart.key}"' in text
    assert sum(chart.content is None for chart in pictures.charts) == 1
    assert '<section id="cam">' in text and "animateTransform" in text


def test_an_undercut_cam_is_reported(tmp_path: Path) -> None:
    job = performed(heat_seal({"base": 20, "roller": 30, "sense": "counter-clockwise"}, blank={"thickness": 12}, nc=NC))
    assert job.cam is not None and job.examined.document is not None
    assert "no profile" in page(report_data(job.examined.document, job.outcomes))
    written = {name for name, file in FILES.items() if file.make(job.cam) is not None}
    assert written == {"cam_profile.csv", "cam.svg", "cam_motion.txt"}


def test_the_command_and_python(tmp_path: Path) -> None:
    document = parse_document(heat_seal(nc=NC, steps=72))
    assert document is not None
    lw.save(document, tmp_path / "cam.yaml")
    result = CliRunner().invoke(
        cli, ["cam", str(tmp_path / "cam.yaml"), "--out", str(tmp_path / "out"), "--post", "siemens"]
    )
    assert result.exit_code == 0, result.output
    assert "siemens" in result.stdout and "22.21454" in result.stdout
    names = {path.name for path in (tmp_path / "out").iterdir()}
    assert names - {"cam.dxf"} == {
        "cam.svg", "cam_motion.txt", "cam_profile.csv", "cam_siemens.mpf", "linkwright-manifest.json", "report.html",
        "summary.json",
    }  # fmt: skip
    found = lw.plate_cam(document, post="fanuc", options={"steps": 36})
    assert found.done and [one.post.name for one in found.milled] == ["fanuc"]
