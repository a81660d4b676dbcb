"""Sketches in the vehicle's coordinates: the plane that is found, what becomes of the points, what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from linkwright.app.job import check
from linkwright.compilation import examine
from linkwright.model.builder import Builder
from linkwright.model.document import Document, dump, load, save
from linkwright.model.plane import in_plane
from linkwright.report.structure_summary import facts

UNITS = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N"}
FLAT = {"A": [0, 0], "B": [20, 35], "C": [110, 75], "D": [130, 0], "P": [70, 90]}
LINKS = {
    "frame": {"points": ["A", "D"]},
    "crank": {"points": ["A", "B"]},
    "coupler": {"points": ["B", "C", "P"]},
    "rocker": {"points": ["D", "C"]},
}
PARAMETERS = {"x1": -260, "x2": -200, "z2": 120, "x3": 90, "z3": 110}
PAPER = {"A": [0, 0, 0], "D": ["x1", 0, 0], "B": ["x3", 0, "z3"], "C": ["x2", 0, "z2"], "P": [-60, 0, 200]}
"""The paper's input, 10.12677/MOS.2018.72005, figure 3: the rear pivot is the origin, x1 is the front one's place."""
T = np.linspace(0.0, 0.2, 9)


def spatial(sketch: dict[str, Any], speed: float = 60, **sections: Any) -> dict[str, Any]:
    drive = {"turns": "crank", "on": "frame", "speed": f"{speed} rpm", "start": "sketch"}
    return {"linkwright": 1, "units": UNITS, "sketch": sketch, "links": LINKS, "drives": {"motor": drive}} | sections


def path(compiled: Any, names: str = "BCP") -> np.ndarray:
    """Places of points over time: (points, 2, times), in m."""
    rows = [f"{name}.{axis}" for name in names for axis in "xy"]
    return compiled.evaluate(rows, T).reshape(len(names), 2, -1)


def turned(seed: int) -> tuple[np.ndarray, np.ndarray]:
    """A random right-handed basis (rows), and an origin (mm)."""
    random = np.random.default_rng(seed)
    basis, _ = np.linalg.qr(random.normal(size=(3, 3)))
    return basis * np.linalg.det(basis), random.uniform(-1000, 1000, 3)


@pytest.mark.parametrize("seed", range(8))
def test_the_motion_is_that_of_the_plane_linkage_wherever_it_lies(seed: int) -> None:
    """A four-bar put anywhere in space moves there as the plane one does; a normal of other sense turns it back."""
    (u, v, w), origin = turned(seed)
    sketch = {name: (origin + x * u + y * v).tolist() for name, (x, y) in FLAT.items()}
    plane = in_plane(Document.model_validate(spatial(sketch))).plane
    assert plane is not None
    sense = float(np.sign(plane.normal @ w))
    there = compiled_from(spatial(sketch, speed=60 * sense))
    flat = path(compiled_from(spatial(FLAT)))
    expected = origin[:, None, None] / 1000 + np.einsum("ak,pat->kpt", np.array([u, v]), flat)
    found = path(there)
    assert np.abs(plane.place(found[:, 0], found[:, 1]) - expected).max() < 1e-12
    assert np.abs([*plane.deviations.values()]).max() < 1e-12
    assert np.abs(np.cross(plane.x, plane.y) - plane.normal).max() < 1e-15


def test_the_plane_is_that_of_least_squares() -> None:
    """The sum of squares is the least eigenvalue of the points' scatter, whatever other plane is tried."""
    random = np.random.default_rng(1)
    (u, v, _), origin = turned(1)
    places = {n: origin + x * u + y * v + random.normal(0, 0.3, 3) for n, (x, y) in FLAT.items()}
    sketch = {name: place.tolist() for name, place in places.items()}
    plane = in_plane(Document.model_validate(spatial(sketch))).plane
    assert plane is not None
    assert plane.fitted == ("A", "B", "C", "D")
    points = np.array([places[name] for name in "ABCD"])
    scatter = np.cov(points.T, bias=True) * len(points)
    squares = sum(plane.deviations[name] ** 2 for name in "ABCD") * 1e6
    assert squares == pytest.approx(np.linalg.eigvalsh(scatter)[0], rel=1e-9)
    mean = points.mean(axis=0)
    assert plane.deviations["P"] * 1000 == pytest.approx((places["P"] - mean) @ plane.normal, rel=1e-9)


@pytest.mark.parametrize(
    ("stated", "order", "x", "y"),
    [
        (None, "xzy", [1, 0, 0], [0, 0, 1]),
        (None, "xyz", [1, 0, 0], [0, 1, 0]),
        (None, "yzx", [0, 1, 0], [0, 0, 1]),
        ("xz", "xzy", [1, 0, 0], [0, 0, 1]),
        ("zx", "xzy", [0, 0, 1], [1, 0, 0]),
        ({"normal": [0, 3, 0]}, "xzy", [1, 0, 0], [0, 0, 1]),
    ],
)
def test_the_axes_are_those_of_the_picture(stated: Any, order: str, x: list[int], y: list[int]) -> None:
    """The flat sketch drawn in two of the vehicle's axes, 7 mm along the third."""
    sketch = {name: [dict(zip(order, [*place, 7], strict=True))[a] for a in "xyz"] for name, place in FLAT.items()}
    data = spatial(sketch) if stated is None else spatial(sketch, plane=stated)
    found = in_plane(Document.model_validate(data))
    assert found.plane is not None
    assert found.plane.x.tolist() == x
    assert found.plane.y.tolist() == y
    assert found.plane.origin.tolist() == (0.007 * np.abs(np.cross(x, y))).tolist()
    assert found.plane.fitted == (("A", "B", "C", "D") if stated is None else ())
    if stated != "zx":
        assert np.abs(path(compiled_from(data)) - path(compiled_from(spatial(FLAT)))).max() < 1e-15


def test_points_behind_each_other_only_need_the_plane_stated() -> None:
    """Pins at different places along their axes: the linkage is the same, and the places are told."""
    sketch = {n: [x, y, z] for (n, (x, z)), y in zip(FLAT.items(), (0, 40, 60, 20, -900), strict=True)}
    compiled = compiled_from(spatial(sketch, plane="xz"))
    assert np.abs(path(compiled) - path(compiled_from(spatial(FLAT)))).max() < 1e-15
    assert compiled.plane is not None
    off = {name: -1000 * value for name, value in compiled.plane.deviations.items()}  # the normal is -y
    assert {name: round(value + 30, 9) for name, value in off.items()} == {"A": 0, "B": 40, "C": 60, "D": 20, "P": -900}
    said = {str(fact["name"]): str(fact["sentence"]) for fact in facts(compiled)}["Plane"]
    assert "normal (joint axis, about which angles are positive) (0, -1, 0)" in said
    assert "A 30" in said


def test_parameters_stay_what_they_are() -> None:
    """Also in a tilted plane: another value moves the point as the same numbers do."""
    compiled = compiled_from(spatial(PAPER, parameters=PARAMETERS))
    flat = {name: [place[0], place[2]] for name, place in PAPER.items()}
    assert np.array_equal(path(compiled), path(compiled_from(spatial(flat, parameters=PARAMETERS))))
    tilted = {name: [x, "h" if name == "B" else 0.2 * 110 * (name != "D" and name != "A"), z]
              for name, (x, _, z) in PAPER.items()}  # fmt: skip
    given = PARAMETERS | {"h": 20}
    plane = {"normal": [0, 1, -0.2], "within": 20}
    document = Document.model_validate(spatial(tilted, parameters=given, plane=plane)).replace(x2=-190, h=30)
    numbers = {n: [(given | {"x2": -190, "h": 30}).get(p, p) for p in place] for n, place in tilted.items()}
    moved = in_plane(Document.model_validate(spatial(numbers, plane=plane)))
    found = examine(document)[0]
    wanted = examine(moved.mechanism)[0]
    assert found is not None
    assert wanted is not None
    assert np.abs(path(found) - path(wanted)).max() < 1e-14


def test_a_file_keeps_its_sketch_and_plane(tmp_path: Any) -> None:
    document = Document.model_validate(spatial(PAPER, parameters=PARAMETERS, plane="xz"))
    save(document, tmp_path / "hinge.yaml")
    assert load(tmp_path / "hinge.yaml") == document
    assert "B: [x3, 0, z3]" in dump(document)
    built = Builder().sketch(PAPER).plane("xz", within=1).frame(["A", "D"]).link("crank", ["A", "B"]).build()
    assert built.sketch == document.sketch
    assert built.plane is not None
    assert built.plane.axes == "xz"


def findings_of(sketch: dict[str, Any], **sections: Any) -> dict[str, str]:
    _, found = examine(Document.model_validate(spatial(sketch, **({"parameters": PARAMETERS} | sections))))
    assert all(finding.what and finding.mend for finding in found)
    # Places that are replaced no longer use all of the parameters.
    return {finding.code: finding.element for finding in found if finding.code != "name.unused-parameter"}


@pytest.mark.parametrize(
    ("changes", "sections", "expected"),
    [
        ({"D": ["x1", 0]}, {}, {"sketch.mixed": "sketch.D"}),
        ({"B": [90, 0, 0], "C": [-200, 0, 0], "P": [1, 0, 0]}, {}, {"sketch.in-line": "sketch"}),
        ({"C": ["x3", 9, "z3"]}, {"plane": "xz"}, {"sketch.coincident": "sketch.C"}),
        ({"D": [0, 5, 0]}, {"plane": "xz"}, {"sketch.coincident": "sketch.D"}),
        ({"B": [90, 60, 110]}, {}, {"sketch.no-plane": "sketch.D"}),
        ({"B": [90, 6, 110]}, {}, {"sketch.off-plane": "sketch.A"}),
        ({"B": [90, 6, 110]}, {"plane": {"within": 1}}, {"sketch.no-plane": "sketch.A"}),
        ({"B": [90, 6, 110]}, {"plane": {"within": "3 mm"}}, {}),
        ({"B": [90, 6, 110]}, {"plane": {"axes": "xz", "within": "3 mm"}}, {"sketch.no-plane": "sketch.B"}),
        ({"B": [90, 0, "3 kg"]}, {}, {"expression.units-conflict": "sketch.B"}),
        ({"B": [90, "q", "q"]}, {}, {"name.unknown-parameter": "sketch.B"}),
        ({"B": [90, "1/0", 110]}, {}, {"value.not-finite": "sketch.B"}),
        ({n: p[::2] for n, p in PAPER.items()}, {"plane": "xz"}, {"sketch.plane-unused": "plane"}),
    ],
)
def test_what_is_no_plane_linkage_is_refused(
    changes: dict[str, Any], sections: dict[str, Any], expected: dict[str, str]
) -> None:
    assert findings_of({**PAPER, **changes}, **sections) == expected


def test_pins_in_a_line_take_the_other_points() -> None:
    """Else the pins alone tell the plane, and a point far off doesn't turn it."""
    sketch = {**PAPER, "B": [90, 0, 0], "C": [-200, 0, 0]}
    assert "sketch.in-line" not in findings_of(sketch)
    flat = in_plane(Document.model_validate(spatial({**PAPER, "P": [-60, 800, 200]}, parameters=PARAMETERS)))
    assert flat.plane is not None
    assert flat.plane.normal.tolist() == [0, -1, 0]
    assert flat.plane.deviations["P"] == -0.8


def test_a_doubtful_plane_is_a_warning_and_runs() -> None:
    sketch = {**PAPER, "B": [90, 6, 110]}
    found = check(
        Document.model_validate(spatial(sketch, parameters=PARAMETERS, studies={"cycle": {"turns": "1 motor"}}))
    )
    told = {(f.code, f.element): f.severity for f in found}
    assert told == {
        ("sketch.off-plane", "sketch.A"): "warning",
        # B's place is replaced, which used these.
        ("name.unused-parameter", "parameters.x3"): "warning",
        ("name.unused-parameter", "parameters.z3"): "warning",
    }


def test_a_wrong_plane_is_told_with_the_rest() -> None:
    for plane in ("xx", {"normal": [0, 0, 0]}, {"normal": [0, 1]}, {"axes": "xz", "normal": [0, 1, 0]}, {"axis": "xz"}):
        with pytest.raises(ValueError, match=r"finding|literal|extra|Input|file|sketch"):
            Document.model_validate(spatial(PAPER, parameters=PARAMETERS, plane=plane))
