"""The curve of a DXF drawing: what is read, and that wrong numbers are findings, never an endless loop."""

from __future__ import annotations

import logging
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.findings import Finding
from linkwright.studies.workspace.dxf_file import MAX_DEGREE, read_curve

ezdxf = pytest.importorskip("ezdxf")
PLACE = ("studies", "workspace", "paths", "edge", "drawing")
KNOTS = [0, 0, 0, 0, 1, 1, 1, 1]
PLACES = [[0, 0], [1, 2], [3, 2], [4, 0]]


def entity(kind: str, *groups: tuple[int, Any]) -> bytes:
    """A drawing that holds one entity and nothing else."""
    every: list[tuple[int, Any]] = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (0, "ENDSEC")]
    every += [
        (0, "SECTION"),
        (2, "ENTITIES"),
        (0, kind),
        (5, "2F"),
        (100, "AcDbEntity"),
        (8, "0"),
        *groups,
        (0, "ENDSEC"),
        (0, "EOF"),
    ]
    return "".join(f"{code}\n{value}\n" for code, value in every).encode()


def spline(
    knots: list[Any] = KNOTS, places: list[list[Any]] = PLACES, weights: tuple[Any, ...] = (), degree: Any = 3
) -> bytes:
    groups: list[tuple[int, Any]] = [
        (100, "AcDbSpline"),
        (70, 8),
        (71, degree),
        (72, len(knots)),
        (73, len(places)),
        (74, 0),
    ]
    groups += [*((40, knot) for knot in knots), *((41, weight) for weight in weights)]
    return entity("SPLINE", *groups, *((code, value) for x, y in places for code, value in ((10, x), (20, y), (30, 0))))


def arc(radius: Any, x: Any = 1, kind: str = "ARC") -> bytes:
    return entity(kind, (100, "AcDbCircle"), (10, x), (20, 2), (40, radius), (100, "AcDbArc"), (50, 0), (51, 90))


def ellipse(x: Any = 2, ratio: Any = 0.5) -> bytes:
    return entity("ELLIPSE", (100, "AcDbEllipse"), (10, 0), (20, 0), (11, x), (21, 0), (40, ratio), (41, 0), (42, 6))


def points(folder: Path, content: bytes, layer: str | None = None) -> Any:
    (folder / "a.dxf").write_bytes(content)
    return read_curve("a.dxf", folder, layer, PLACE)


def finding(folder: Path, content: bytes) -> Finding:
    with pytest.raises(lw.ModelError) as caught:
        points(folder, content)
    found = caught.value.findings[0]
    assert found.path == PLACE and found.what and found.mend
    return found


def test_what_is_read(tmp_path: Path) -> None:
    assert points(tmp_path, arc(3))[[0, -1]] == pytest.approx(np.array([[4, 2], [1, 5]]))
    assert points(tmp_path, ellipse())[0] == pytest.approx([2, 0])
    assert points(tmp_path, spline())[[0, -1]] == pytest.approx(np.array([[0, 0], [4, 0]]))
    line = entity("LINE", (100, "AcDbLine"), (10, 0), (20, -0.0), (11, 1), (21, 1))
    assert points(tmp_path, line).tolist() == [[0, 0], [1, 1]]
    assert points(tmp_path, b"\xef\xbb\xbf" + line.replace(b"\n", b"\r\n")).tolist() == [[0, 0], [1, 1]]


@pytest.mark.parametrize(
    ("version", "encoding", "form"), [("R2010", "utf-8", "asc"), ("R2000", "gbk", "asc"), ("R2010", "utf-8", "bin")]
)
def test_encodings_and_binary_drawings(tmp_path: Path, version: str, encoding: str, form: str) -> None:
    drawing = ezdxf.new(version)
    drawing.encoding = encoding
    drawing.modelspace().add_lwpolyline([(0, 0), (1, 0), (1, 1)], dxfattribs={"layer": "轨迹"})
    drawing.modelspace().add_line((0, 0), (1, 2), dxfattribs={"layer": "轴"})
    drawing.saveas(tmp_path / "made.dxf", fmt=form)
    content = (tmp_path / "made.dxf").read_bytes()
    assert points(tmp_path, content, "轨迹").tolist() == [[0, 0], [1, 0], [1, 1]]
    assert finding(tmp_path, content).code == "workspace.path-drawing"


@pytest.mark.parametrize("number", ["nan", "inf", "-inf", "1e400", "1e300", "x", "1,5", "", "\x1b[31m"])
@pytest.mark.parametrize("at", [0, 3])
def test_numbers_that_are_none_are_told_with_their_line(tmp_path: Path, number: str, at: int) -> None:
    """One that isn't finite among a spline's places kept ezdxf's compiled code busy for ever."""
    places = [list(place) for place in PLACES]
    places[at][1] = number
    content = spline(places=places)
    found = finding(tmp_path, content)
    assert found.code == "drawing.number"
    line = found.data["place"].data["at"]
    assert content.decode().split("\n")[line - 1] == number
    assert content.decode().split("\n")[line - 2] == "20"
    assert "\x1b" not in found.what


@pytest.mark.parametrize("number", ["inf", "1e400", "9" * 30, "many"])
def test_integers_are_bounded(tmp_path: Path, number: str) -> None:
    assert finding(tmp_path, spline(degree=number)).code == "drawing.number"


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (arc(0), "radius"),
        (arc(-1), "radius"),
        (arc("0", kind="CIRCLE"), "radius"),
        (ellipse(0), "axis"),
        (ellipse(ratio=0), "ratio"),
        (ellipse(ratio=1e30), "ratio"),
        (spline(degree=0), "degree"),
        (spline(degree=MAX_DEGREE + 1), "degree"),
        (spline(knots=[0, 0, 0, 0, 1, 0, 1, 1]), "knots"),
        (spline(weights=(1, 0, 0, 1)), "weights"),
        (arc(1e-3, 1e9), "far"),
        (spline(places=[[x, y + 1e10] for x, y in PLACES]), "far"),
    ],
)
def test_entities_that_make_no_path(tmp_path: Path, content: bytes, reason: str) -> None:
    found = finding(tmp_path, content)
    assert (found.code, found.data["handle"]) == ("drawing.entity", "2F")
    assert found.data["reason"].key == f"term.drawn-{reason}"


@pytest.mark.parametrize(
    "content", [spline(knots=[0, 1]), spline(knots=[0] * 8), spline(weights=(1, 2)), spline(places=[])]
)
def test_entities_that_the_library_refuses(tmp_path: Path, content: bytes) -> None:
    assert finding(tmp_path, content).code == "drawing.entity"


def test_the_largest_numbers_make_a_path_of_finite_ones(tmp_path: Path) -> None:
    assert np.isfinite(points(tmp_path, arc(1e39, 1e39))).all()


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"0",
        b"hello\nworld\n",
        b"\0" * 100,
        b"AC1027\0\0" + bytes(range(256)),
        entity("LINE", (100, "AcDbLine"), (10, 0)).decode().encode("utf-16"),
        entity("LINE", (100, "AcDbLine"), (10, 0))[:-20],
        b"AutoCAD Binary DXF\r\n\x1a\0" + b"\xff" * 50,
    ],
)
def test_files_that_are_no_drawings(tmp_path: Path, content: bytes) -> None:
    assert finding(tmp_path, content).code in ("drawing.unreadable", "drawing.code")


def test_the_library_writes_nothing_to_the_terminal(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    points(
        tmp_path,
        entity("LINE", (100, "AcDbLine"), (10, 0), (20, 0), (11, 1), (21, 1)).replace(b"LINE", b"LINE\n5\n0", 1),
    )
    logging.getLogger("ezdxf").warning("an oddity")
    assert capfd.readouterr().err == ""


def test_what_ezdxf_says_names_no_handle_that_there_is_not(tmp_path: Path) -> None:
    content = entity("SPLINE", (100, "AcDbOther"), (70, 8)).replace(b"5\n2F\n", b"")
    told = finding(tmp_path, content).what
    assert "SPLINE" in told and "None" not in told
