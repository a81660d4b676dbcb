"""What is said of a workspace: figures in the file's units, files that other programs read, pictures with a legend."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from helpers.shown import blocks, heads, rows
from helpers.workspaces import arm, five_bar, four_bar, performed
from linkwright.app.job import Job
from linkwright.presentation.blocks import Charts, Table
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.studies.workspace.certificate import Contradiction, RegionCertificate
from linkwright.studies.workspace.dxf_file import read_curve
from linkwright.studies.workspace.files import boundary_csv, dxf, geojson, svg
from linkwright.studies.workspace.report import report, without_traces


@pytest.fixture(scope="module")
def job() -> Job:
    return performed(arm(**{"for": {"b": [30]}}))


@pytest.fixture(scope="module")
def two() -> Job:
    return performed(five_bar(drives={"motor": [80, 120], "servo": [40, 100]}))


def test_the_summary_is_in_the_files_units(job: Job) -> None:
    entry: dict[str, Any] = json.loads(json.dumps(job.summary["workspace"]))
    (region,) = entry["regions"]
    assert region["b"] == 30 and region["unit"] == "mm" and region["mode"] == ""
    assert region["area"] == pytest.approx(np.pi * (70**2 - 10**2), rel=3e-4)
    assert region["perimeter"] == pytest.approx(2 * np.pi * 80, rel=3e-4)
    assert (region["holes"], region["parts"]) == (1, 1)
    assert region["bounds"] == pytest.approx([-70, -70, 70, 70], abs=0.01)
    assert region["rough"] < entry["chord"] == pytest.approx(4e-3)
    assert entry["union"][0]["area"] == pytest.approx(region["area"])
    assert entry["drives"]["elbow"]["unit"] == "deg"
    assert [(one["drive"], one["whole"]) for one in entry["turning"]] == [("shoulder", True), ("elbow", True)]
    assert entry["drives"]["elbow"]["to"] - entry["drives"]["elbow"]["from"] == pytest.approx(360)


def test_what_is_proven_of_a_region_is_in_the_summary_and_the_table(job: Job) -> None:
    """The annulus lies between the bounds, in mm2; the table has the same, with units."""
    entry = job.summary["workspace"]
    (region,) = entry["regions"]
    proven, area = region["certificate"], np.pi * (70**2 - 10**2)
    assert entry["area_unit"] == "mm^2" and "change" not in region
    assert (proven["grade"], proven["certified"], proven["faults"]) == ("enclosed", True, [])
    assert proven["parts"] is True and proven["holes"] is True and 0 < proven["finest"] < 1e-3
    low, high = proven["area"]
    assert low < area < high and high - low < 2e-3 * area
    assert job.workspace is not None
    table = blocks(report(job.workspace), Table)[0]
    row = dict(zip(heads(table), rows(table)[0], strict=True))
    assert "Unit" not in row
    assert row["Area"] == f"{region['area']:.7g} mm²"
    assert row["Bounds"] == f"{low:.7g} .. {high:.7g} mm²"
    assert row["Perimeter"] == f"{region['perimeter']:.7g} mm"
    assert (row["Holes"], row["Parts"], row["Grade"]) == ("1", "1", "certified")


@pytest.mark.parametrize(
    ("certificate", "within", "parts", "holes", "grade"),
    [
        (
            RegionCertificate("enclosed", (14e-3, 16e-3), True, False),
            "14000 .. 16000 mm²",
            "1",
            "1, not certified",
            "certified",
        ),
        (
            RegionCertificate(
                "enclosed", (16e-3, 17e-3), True, True, faults=(Contradiction("area", 1e-3, (0.0, 0.0)),)
            ),
            "16000 .. 17000 mm²",
            "1",
            "1",
            "not certified",
        ),
        (RegionCertificate("searched"), "–", "1", "1", "searched"),
        (
            RegionCertificate("searched", faults=(Contradiction("cut", 1.0, (0.0, 0.0)),)),
            "–",
            "1",
            "1",
            "not certified",
        ),
    ],
)
def test_what_is_not_proven_is_said_in_the_table(
    job: Job, certificate: RegionCertificate, within: str, parts: str, holes: str, grade: str
) -> None:
    assert job.workspace is not None
    (one,) = job.workspace.workspaces
    reached = replace(one.regions[0], region=replace(one.regions[0].region, certificate=certificate))
    changed = replace(job.workspace, workspaces=[replace(one, regions=(reached,))])
    table = blocks(report(changed), Table)[0]
    row = dict(zip(heads(table), rows(table)[0], strict=True))
    found = [row[head] for head in ("Bounds", "Parts", "Holes", "Grade")]
    assert found == [within, parts, holes, grade]


def test_modes_overlaps_and_union_add_up(two: Job) -> None:
    entry = two.summary["workspace"]
    first, second = (region["area"] for region in entry["regions"])
    assert entry["overlap"][0]["modes"] == [region["mode"] for region in entry["regions"]]
    assert entry["union"][0]["area"] == pytest.approx(first + second - entry["overlap"][0]["area"], rel=1e-6)
    assert entry["union"][0]["several"] == pytest.approx(entry["overlap"][0]["area"], abs=1e-9)


def test_geojson_holds_the_polygons_with_their_holes(job: Job) -> None:
    from shapely.geometry import shape

    assert job.workspace is not None
    text = geojson(job.workspace)
    assert text is not None
    data = json.loads(text)
    region, union = data["features"]
    assert "mm" in data["note"] and region["properties"]["values"] == {"b": 30}
    made = shape(region["geometry"])
    assert made.is_valid and made.area == pytest.approx(region["properties"]["area"])
    (polygon,) = made.geoms
    assert polygon.exterior.is_ccw and not polygon.interiors[0].is_ccw
    assert union["properties"]["kind"] == "union"


def test_the_boundary_holds_drive_values_that_reach_it(two: Job) -> None:
    """The five-bar's own closure, written out: each row's pin lies 12 mm from both cranks' ends."""
    assert two.workspace is not None
    rows = [*csv.DictReader(io.StringIO(boundary_csv(two.workspace) or ""))]
    assert {row["mode"] for row in rows} == {"C: left of B-D", "C: right of B-D"}
    assert {row["kind"] for row in rows} == {"limit"}
    x, y, motor, servo = (
        np.array([float(row[name]) for row in rows]) for name in ("x [mm]", "y [mm]", "motor [deg]", "servo [deg]")
    )
    a, b = np.exp(1j * np.radians(motor)) * 10, 10 + np.exp(1j * np.radians(servo)) * 10
    for pin in (a, b):
        assert np.abs(np.abs(x + 1j * y - pin) - 12).max() < 2e-4 * 12
    assert ((motor > 79.99) & (motor < 120.01) & (servo > 39.99) & (servo < 100.01)).all()


def test_drive_values_stay_within_a_whole_turn(job: Job) -> None:
    """On the outer circle the arm is straight, on the inner one folded."""
    assert job.workspace is not None
    rows = [*csv.DictReader(io.StringIO(boundary_csv(job.workspace) or ""))]
    shoulder, elbow = (np.array([float(row[f"{name} [deg]"]) for row in rows]) for name in ("shoulder", "elbow"))
    assert ((shoulder >= 0) & (shoulder < 360) & (elbow >= 0) & (elbow < 360)).all()
    folded = np.where(np.array([row["ring"] for row in rows]) == "0", 0.0, 180.0)
    assert np.abs((elbow - folded + 180) % 360 - 180).max() < 1e-6
    assert {row["kind"] for row in rows} == {"singular"}


def test_dxf_holds_a_closed_polyline_for_each_ring(job: Job) -> None:
    ezdxf = pytest.importorskip("ezdxf")
    assert job.workspace is not None
    drawing = ezdxf.read(io.StringIO(dxf(job.workspace)))
    outer, inner = drawing.modelspace().query("LWPOLYLINE")
    assert outer.closed and drawing.units == ezdxf.units.MM and outer.dxf.layer == "1 b - 30 mm"
    radius = [max(np.hypot(x, y) for x, y, *_ in line) for line in (outer, inner)]
    assert radius == pytest.approx([70, 10], abs=0.01)


def test_hanzi_arrive_in_a_drawing(job: Job, tmp_path: Path) -> None:
    """As UTF-8, which CAD systems read in this version of the format whatever the code page, and in ours too."""
    ezdxf = pytest.importorskip("ezdxf")
    assert job.workspace is not None
    (one,) = job.workspace.workspaces
    (region,) = one.regions
    named = replace(
        job.workspace, workspaces=[replace(one, regions=[replace(region, mode="铰点: 轴心左侧")], curves=[])]
    )
    file = tmp_path / "edge.dxf"
    file.write_text(dxf(named) or "", encoding="utf-8")
    drawing = ezdxf.readfile(file)
    layer = "1 铰点- 轴心左侧 b - 30 mm"
    assert drawing.dxfversion >= "AC1021" and layer in drawing.layers
    assert {line.dxf.layer for line in drawing.modelspace()} == {layer}
    drawing.modelspace().delete_entity(drawing.modelspace()[1])  # the ring of the hole
    for version, encoding in (("AC1024", "utf-8"), ("AC1015", "gbk")):
        drawing.dxfversion, drawing.encoding = version, "gbk"
        drawing.saveas(file)
        assert layer.encode(encoding) in file.read_bytes()
        assert len(read_curve(file.name, tmp_path, layer, ())) > 10


def test_the_picture_names_the_determinants_and_is_sound(job: Job, two: Job) -> None:
    assert job.workspace is not None and two.workspace is not None
    text = svg(job.workspace)
    assert text is not None and "d(E.x, E.y)/d(shoulder, elbow) is" in " ".join(ElementTree.fromstring(text).itertext())
    assert text.count('class="region') == 2  # the region and its place in the legend
    assert "limit of a drive" in " ".join(ElementTree.fromstring(svg(two.workspace) or "").itertext())


def test_the_page_has_its_section_and_escapes_names(job: Job) -> None:
    document = job.examined.document
    assert document is not None
    text = page(report_data(document, job.outcomes))
    assert '<section id="workspace">' in text and "Workspace of E for b = 30 mm" in text
    assert "<2R>" not in text


def test_a_curve_is_written_too() -> None:
    job = performed(four_bar())
    assert job.workspace is not None
    own = job.summary["workspace"]["curves"][0]
    assert own["mode"] == "C: left of B-D" and own["closed"] and own["length"] > 0
    assert geojson(job.workspace) is None
    rows = [*csv.DictReader(io.StringIO(boundary_csv(job.workspace) or ""))]
    assert {row["kind"] for row in rows} == {"path"}
    assert 'class="path' in (svg(job.workspace) or "")


def test_where_nothing_is_reached_there_is_no_picture() -> None:
    job = performed(five_bar(**{"for": {"base": [100, 200]}}, trajectories={}, quality={"steps": 10}))
    assert job.workspace is not None
    assert job.workspace.workspaces == [] and svg(job.workspace) is None
    (pictures,) = blocks(report(job.workspace), Charts)
    assert (pictures.charts, pictures.sliders) == ([], [])


def test_one_value_of_several_at_which_the_links_close_has_no_slider() -> None:
    some = performed(five_bar(drives={"motor": [80, 120], "servo": [40, 100]}, **{"for": {"base": [10, 100]}}))
    assert some.workspace is not None and len(some.workspace.workspaces) == 1
    document = some.examined.document
    assert document is not None
    assert 'type="range" id="step-' not in page(report_data(document, some.outcomes))


def test_pictures_of_several_values_have_the_same_axes() -> None:
    made = performed(arm(**{"for": {"b": [30, 20]}}))
    assert made.workspace is not None
    root = ElementTree.fromstring(svg(made.workspace) or "")
    space = "{http://www.w3.org/2000/svg}"
    drawings = root.findall(f"{space}svg")
    grids = [one.find(f"{space}path[@class='grid']") for one in drawings]
    assert len(drawings) == 2 and len({grid.get("d") for grid in grids if grid is not None}) == 1
    titles = [one.text or "" for one in root.findall(f"{space}text")]
    assert [title.split(" = ")[1] for title in titles] == ["30 mm", "20 mm"]


@pytest.mark.parametrize(
    ("ends", "shown"),
    [
        ((3.78413e-06, 30.5), (0.0, 30.5)),
        ((-30.5, -1e-9), (-30.5, 0.0)),
        ((3.7e-5, 30.5), (3.7e-5, 30.5)),
        ((-2e-9, 1e-9), (-2e-9, 1e-9)),
        ((0.0, 0.0), (0.0, 0.0)),
    ],
)
def test_a_range_has_no_trace_of_its_larger_end(ends: tuple[float, float], shown: tuple[float, float]) -> None:
    """Round-off beside the digits that are shown is no number; small ranges keep theirs."""
    assert without_traces(ends) == shown
