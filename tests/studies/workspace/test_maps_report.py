"""Maps as pictures, tables and files: the arm's det J = a b sin(elbow), looked up in the picture itself."""

from __future__ import annotations

import csv
import io
import json
import re
import struct
import zlib
from base64 import b64decode
from xml.etree import ElementTree

import numpy as np
import pytest
from shapely.geometry import shape

from helpers.workspaces import arm, performed
from linkwright.app.job import Job
from linkwright.drawing.levels import levels_of
from linkwright.report.build import report_data
from linkwright.report.page import page
from linkwright.studies.workspace.files import geojson
from linkwright.studies.workspace.maps_report import errors_csv, quality_charts, quality_csv, quality_svg

A, B = 40.0, 30.0


@pytest.fixture(scope="module")
def job() -> Job:
    asked = {"steps": 60, "show": ["manipulability"], "levels": {"manipulability": [1000, 500]}}
    data = arm(A, B, quality=asked, errors={"steps": 40, "limit": "0.17 mm"})
    data["parameters"] = {name: {"value": v, "tolerance": 0.1} for name, v in (("a", A), ("b", B))}
    return performed(data)


def pixels(drawing: str) -> tuple[np.ndarray, np.ndarray]:
    """The numbers of the colours, and the palette, of the picture's image."""
    data = b64decode(re.findall(r"base64,([^\"]+)", drawing)[0])
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    chunks, at = {}, 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + size]
        assert struct.unpack(">I", data[at + 8 + size : at + 12 + size])[0] == zlib.crc32(kind + body)
        chunks[kind], at = body, at + 12 + size
    columns, rows, *form = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    assert form == [8, 3, 0, 0, 0]
    lines = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), dtype=np.uint8).reshape(rows, columns + 1)
    assert not lines[:, 0].any()
    return lines[:, 1:], np.frombuffer(chunks[b"PLTE"], dtype=np.uint8).reshape(-1, 3)


def test_the_picture_shows_the_closed_form(job: Job) -> None:
    assert job.workspace is not None
    (chart,) = quality_charts(job.workspace)
    drawing = chart.drawing
    colours, palette = pixels(drawing)
    assert len(palette) == 3  # below 500, up to 1000, above
    x, y = (np.linspace(-(A + B), A + B, n) for n in colours.shape[::-1])
    far = np.hypot(*np.meshgrid(x, y))
    with np.errstate(invalid="ignore"):
        value = A * B * np.sqrt(1 - ((far**2 - A**2 - B**2) / (2 * A * B)) ** 2)
    bands = np.digitize(value, [500, 1000])
    clear = np.isfinite(value) & (np.abs(value - 500) > 60) & (np.abs(value - 1000) > 30)
    clear &= (far > A - B + 1) & (far < A + B - 1)
    assert clear.sum() > 50_000 and (colours[clear] == bands[clear]).mean() > 0.999
    root = ElementTree.fromstring(quality_svg(job.workspace) or "")
    texts = [text for text in root.itertext() if text.strip()]
    # At the scale, and on both circles; the outer one of 500 runs too near to the edge.
    assert (texts.count("500"), texts.count("1000")) == (2, 3)
    assert any("Magnitude of the determinant of d(E.x, E.y)/d(shoulder, elbow), mm²" in text for text in texts)
    assert drawing.count('class="locus k-singular"') == 1 + 2  # the legend; elbow straight and folded


def test_lines_are_circles(job: Job) -> None:
    """Each level of det J is reached on two circles about the shoulder."""
    assert job.workspace is not None
    (chart,) = quality_charts(job.workspace)
    radii = []
    for text in re.findall(r'class="line" points="([^"]+)"', chart.drawing):
        at = np.array([[float(v) for v in place.split(",")] for place in text.split()])
        middle = (at.max(axis=0) + at.min(axis=0)) / 2
        away = np.hypot(*(at - middle).T)
        assert np.ptp(away) < 1.0
        radii.append(away.mean())
    cosine = np.sqrt(1 - (np.array([500, 500, 1000, 1000]) / (A * B)) ** 2) * [1, -1, 1, -1]
    exact = np.sqrt(A**2 + B**2 + 2 * A * B * cosine)
    scale = max(radii) / exact.max()
    np.testing.assert_allclose(sorted(radii), sorted(exact * scale), rtol=5e-3)


def test_levels_are_round() -> None:
    assert levels_of(np.linspace(-5, 9, 101)) == pytest.approx([-4, -2, 0, 2, 4, 6, 8])
    assert levels_of(10 ** np.linspace(0.05, 2.05, 500)) == [2, 5, 10, 20, 50, 100]
    assert levels_of(np.full(9, 3.0)) == levels_of(np.full(4, np.nan)) == []
    assert len(levels_of(10 ** np.linspace(-30, 30, 500))) <= 10


def test_tables_of_maps(job: Job) -> None:
    assert job.workspace is not None
    rows = [*csv.DictReader(io.StringIO(quality_csv(job.workspace) or ""))]
    elbow, value, far = (
        np.array([float(row[name]) for row in rows]) for name in ("elbow [deg]", "manipulability [mm^2]", "x [mm]")
    )
    np.testing.assert_allclose(value, A * B * np.abs(np.sin(np.radians(elbow))), atol=1e-9)
    assert len(rows) == 61 * 61 and np.abs(far).max() <= A + B
    assert "error worst [mm]" in (errors_csv(job.workspace) or "").splitlines()[0]


def test_geojson_holds_what_is_sure(job: Job) -> None:
    assert job.workspace is not None
    features = json.loads(geojson(job.workspace) or "")["features"]
    kinds = {one["properties"]["kind"]: one for one in features}
    assert list(kinds) == ["region", "union", "guaranteed", "precise"]
    region, sure, precise = (shape(kinds[name]["geometry"]) for name in ("region", "guaranteed", "precise"))
    assert region.buffer(1e-6).contains(sure) and sure.buffer(1e-6).contains(precise)
    assert sure.area == pytest.approx(kinds["guaranteed"]["properties"]["area"])
    assert kinds["precise"]["properties"]["limit"] == pytest.approx(0.17)


def test_the_page(job: Job) -> None:
    document = job.examined.document
    assert document is not None
    text = page(report_data(document, job.outcomes))
    assert "Guaranteed area by region" in text and "limit positions of the output" in text
    assert "the pictures show the better value" in text and "the pictures show the larger error" in text
    assert len(text) < 1_000_000
