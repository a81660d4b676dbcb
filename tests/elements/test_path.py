"""Points that two drives move along a path: against inverse kinematics in closed form, and the full Newton-Euler system
with the motors' torques as its unknowns; shapes against each other; what is refused."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from ruamel.yaml import YAML

import linkwright as lw
from elements.test_prescribed import along, document, five_bar
from helpers.compiled import compiled_from
from helpers.newton_euler import Oracle
from helpers.plain import Law, PlainDrive
from linkwright.compilation import examine
from linkwright.model.document import Document
from linkwright.results.certificate import certify
from linkwright.results.run import Run

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[2] / "examples"
T = np.linspace(0.0, 1.0, 11)
MOTORS = {
    "left": {"turns": "AB", "on": "frame", "output": "way"},
    "right": {"turns": "ED", "on": "frame", "output": "way"},
}
X, Y = ("P", "O", 0.0), ("P", "O", np.pi / 2)
FREE = five_bar({})
START = along(FREE, "BC", X) + 0.2, along(FREE, "BC", Y) - 0.1
"""The point's place in the frame; O lies at (0.2, -0.1)."""


def model(path: dict[str, Any], motors: dict[str, Any] = MOTORS) -> dict[str, Any]:
    data = document(five_bar({}))
    return {**data, "paths": {"way": {"moves": "BC", "at": "P", **path}}, "drives": motors}


def text(law: Law) -> str:
    return f"{law.q0!r} + {law.q1!r}*t/(1 s) + {law.amp!r}*sin({law.w!r}*t/(1 s))"


def test_against_newton_and_euler() -> None:
    """The point's coordinates are held in the oracle; then the same poses, rates and masses with torques on the cranks
    as unknowns in place of the forces on the point."""
    x, y = Law(START[0], amp=0.15, w=2.0), Law(START[1], q1=0.05, amp=0.1, w=3.0)
    drives = {
        "x": PlainDrive("slides", "BC", "frame", x.plus(-0.2), X),
        "y": PlainDrive("slides", "BC", "frame", y.plus(0.1), Y),
    }
    guided = Oracle(five_bar(drives))
    states = guided.follow(T)
    motors = {"left": "AB", "right": "ED"}
    turned = {
        name: PlainDrive("turns", link, "frame", Law(float(guided.pose(states[0].q, link)[2])))
        for name, link in motors.items()
    }
    forces = [Oracle(replace(five_bar(turned), start=guided.plain.start)).forces(state) for state in states]
    run = Run(compiled_from(model({"x": text(x), "y": text(y)})), 0.0, 1.0, 60)
    for name, link in motors.items():
        found = run.evaluate([f"{name}.omega", f"{name}.alpha", f"{name}.torque"], T)
        assert found[0] == pytest.approx([guided.pose(s.v, link)[2] for s in states], rel=1e-8, abs=1e-9)
        assert found[1] == pytest.approx([guided.pose(s.a, link)[2] for s in states], rel=1e-8, abs=1e-8)
        assert found[2] == pytest.approx([f.efforts[name] for f in forces], rel=1e-8, abs=1e-8)
    reactions = run.evaluate(["force(frame, AB).x", "force(DC, ED).y"], T)
    assert reactions[0] == pytest.approx([f.reactions["A", "AB"][0] for f in forces], rel=1e-7, abs=1e-7)
    assert reactions[1] == pytest.approx([f.reactions["D", "ED"][1] for f in forces], rel=1e-7, abs=1e-7)
    certificate = certify(run)
    assert certificate.sound(), certificate.residuals
    assert certificate.power is not None and certificate.power < 1e-9


def test_the_example_against_circles() -> None:
    """Both cranks by the intersection of two circles about their pivots and the tool, in closed form."""
    compiled, findings = examine(lw.load(EXAMPLES / "pick_and_place.yaml"))
    assert compiled is not None, findings
    t = np.linspace(0.0, 1.0, 33)
    run = Run(compiled, 0.0, 1.0, 60)
    px, py, left, right = run.evaluate(["P.x", "P.y", "left_motor.angle", "right_motor.angle"], t)
    p = px + 1j * py

    def crank(pivot: complex, side: float) -> Array:
        away = p - pivot
        size = np.abs(away)
        return np.angle(away) + side * np.arccos((size**2 + 0.25**2 - 0.3**2) / (2 * size * 0.25))

    assert left == pytest.approx(crank(0.0, 1.0), abs=1e-12)
    assert right == pytest.approx(crank(0.3, -1.0), abs=1e-12)
    # Powers: what the motors give is what lifts and moves the masses, pose by pose.
    assert certify(run).sound()


def test_tolerances_of_links_move_the_cranks() -> None:
    """d(crank)/d(upper link) at a given place of the tool, by the law of cosines."""
    data = YAML(typ="safe").load((EXAMPLES / "pick_and_place.yaml").read_text(encoding="utf-8"))
    data |= {
        "measures": {"left_at": {"value": "left_motor.angle", "where": "max P.x"}},
        "require": {},
        "studies": {"cycle": {"duration": "1 s", "samples": 60}, "accuracy": {"samples": 100}},
    }
    outcome = lw.run(Document.model_validate(data)).outcomes["accuracy"]
    d, upper, fore = np.hypot(250.0, 380.0), 250.0, 300.0
    cosine = (d**2 + upper**2 - fore**2) / (2 * d * upper)
    slope = -(1 / d - cosine / upper) / np.sqrt(1 - cosine**2)  # rad/mm
    (figure,) = outcome.figures.values()
    assert figure.coefficients[0] == pytest.approx(slope * 1e3, rel=1e-9)  # rad/m


SIGNALS = ["P.x", "P.y", "P.vx", "P.ay", "left.angle", "left.alpha", "right.torque"]


@pytest.mark.parametrize(
    ("shape", "x", "y"),
    [
        (
            {"line": [[START[0], START[1]], [START[0] + 0.3, START[1] - 0.4]], "position": "0.1*sin(3*t/(1 s))"},
            "{0} + 0.06*sin(3*t/(1 s))",
            "{1} - 0.08*sin(3*t/(1 s))",
        ),
        (
            {
                "line": [[START[0], START[1]], [START[0] - 2, START[1]]],
                "speed": 0.1,
                "acceleration": -0.3,
                "start": 0.01,
            },
            "{0} - 0.01 - 0.1*t/(1 s) + 0.15*t^2/(1 s^2)",
            "{1}",
        ),
        (
            {"arc": {"centre": [START[0] - 0.2, START[1]], "radius": 0.2}, "speed": -0.1},
            "{0} - 0.2 + 0.2*cos(0.5*t/(1 s))",
            "{1} - 0.2*sin(0.5*t/(1 s))",
        ),
        (
            {
                "arc": {"centre": [START[0], START[1] + 0.2], "radius": 0.2, "from": "-90 deg"},
                "position": "0.1*t/(1 s)",
            },
            "{0} + 0.2*sin(0.5*t/(1 s))",
            "{1} + 0.2 - 0.2*cos(0.5*t/(1 s))",
        ),
    ],
)
def test_shapes_are_their_coordinates_over_the_time(shape: dict[str, Any], x: str, y: str) -> None:
    """The law of lines and arcs is the distance along them: the speed of the point is its rate."""
    found = Run(compiled_from(model(shape)), 0.0, 1.0, 40).evaluate(SIGNALS, T)
    coordinates = {"x": x.format(*START), "y": y.format(*START)}
    expected = Run(compiled_from(model(coordinates)), 0.0, 1.0, 40).evaluate(SIGNALS, T)
    assert found == pytest.approx(expected, rel=1e-10, abs=1e-11)


def test_a_path_on_a_moving_link() -> None:
    """A tool on two slides of a turning table, along a line of the table: seen from there it moves straight on."""
    data = model({"line": [[0.0, 0.0], [1.0, 0.5]], "position": "0.9 + 0.1*sin(2*t/(1 s))", "on": "ED"})
    data = {
        **data,
        "assembly": {"Q": [0.8, 0.0], "P": [0.8, 0.4]},
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "ED": {"points": {"O": [0, 0]}, "mass": 1, "com": [0, 0], "inertia": 0.1},
            "AB": {"points": {"Q": [0, 0]}, "mass": 1, "com": [0.1, 0], "inertia": 0.1},
            "BC": {"points": {"P": [0, 0]}, "mass": 1, "com": [0, 0], "inertia": 0.1},
        },
        "joints": {
            "x": {"prismatic": ["ED", "AB"], "line": ["O at 0", "Q at 0"]},
            "y": {"prismatic": ["AB", "BC"], "line": ["Q at 90 deg", "P at 90 deg"]},
        },
        "drives": {
            "table": {"turns": "ED", "on": "frame", "speed": 2, "start": 0},
            "left": {"slides": "AB", "on": "ED", "output": "way"},
            "right": {"slides": "BC", "on": "AB", "output": "way"},
        },
    }
    s = 0.9 + 0.1 * np.sin(2 * T)
    found = Run(compiled_from(data), 0.0, 1.0, 40).evaluate(["left.s", "right.s", "P.x"], T)
    cosine, sine = 1 / np.hypot(1, 0.5), 0.5 / np.hypot(1, 0.5)
    expected = np.array([s * cosine, s * sine, s * np.cos(2 * T + np.arctan(0.5))])
    assert found == pytest.approx(expected, abs=1e-12)


def codes(data: dict[str, Any]) -> list[str]:
    try:
        _, findings = examine(Document.model_validate(data))
    except ValueError as error:
        return [str(error)]
    return [f.code for f in findings if f.severity == "error"]


LINE = {"line": [[0, 0], [1, 0]], "speed": 1}


@pytest.mark.parametrize(
    ("path", "motors", "code"),
    [
        ({}, MOTORS, "path.shape"),
        ({**LINE, "arc": {"centre": [0, 0], "radius": 1}}, MOTORS, "path.shape"),
        ({"x": "1 + t/(1 s)"}, MOTORS, "path.shape"),
        ({"x": 1, "y": 2, "speed": 1}, MOTORS, "path.law"),
        ({"line": [[0, 0], [1, 0]]}, MOTORS, "drive.law"),
        ({"line": [[1, 2], [1, 2]], "speed": 1}, MOTORS, "path.no-length"),
        ({"arc": {"centre": [0, 0], "radius": 0}, "speed": 1}, MOTORS, "value.too-small"),
        (LINE, {"left": MOTORS["left"]}, "path.drives"),
        (LINE, {**MOTORS, "more": {"turns": "DC", "on": "BC", "output": "way"}}, "path.drives"),
        (LINE, {**MOTORS, "left": {**MOTORS["left"], "speed": 1, "start": 0}}, "path.two-laws"),
        (LINE, {**MOTORS, "left": {"turns": "AB", "on": "frame", "output": "BC"}}, "drive.law"),
        ({**LINE, "at": "Q"}, MOTORS, "name.unknown-point"),
        ({**LINE, "speed": "1 rad/s"}, MOTORS, "expression.units-conflict"),
        ({"x": "BC.angle", "y": 0}, MOTORS, "expression"),
    ],
)
def test_what_is_refused(path: dict[str, Any], motors: dict[str, Any], code: str) -> None:
    found = codes(model(path, motors))
    assert any(code in one for one in found), found


def test_limits_move_no_drive_of_a_path_alone() -> None:
    data = model({"line": [[*START], [START[0] + 1, START[1]]], "speed": 0.1})
    data["studies"] = {"limits": {}}
    with pytest.raises(lw.ModelError) as caught:
        lw.run(Document.model_validate(data))
    assert [f.code for f in caught.value.findings] == ["study.paths"]


def test_a_point_out_of_reach_is_named() -> None:
    data = model({"line": [[*START], [START[0] + 1, START[1] + 1]], "speed": 1})
    data["studies"] = {"cycle": {"duration": "3 s", "samples": 60}}
    job = lw.run(Document.model_validate(data))
    assert job.exit_code == 1
    failures = [f.code for f in job.outcomes["cycle"].failures]
    assert failures and all(code.startswith("motion.") for code in failures), failures


@pytest.mark.parametrize("seed", range(12))
def test_a_start_out_of_reach_is_told_with_its_distances(seed: int) -> None:
    """Random two-link arms of a five-bar to a place: told just where the distance to a pivot is more than both links,
    or less than their difference, with these numbers."""
    rng = np.random.default_rng(seed)
    a, b, c, d = rng.uniform(60, 200, 4).round(2)
    pivots = {"A": np.array([-80.0, 0.0]), "E": np.array([80.0, 0.0])}
    place = rng.uniform(-300, 300, 2).round(2)
    away = {name: float(np.hypot(*(place - at))) for name, at in pivots.items()}
    spans = {"A": (abs(a - b), a + b), "E": (abs(c - d), c + d)}
    data = {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "time": "s"},
        "links": {
            "frame": {"points": {"A": [-80, 0], "E": [80, 0]}},
            "left": {"points": {"A": [0, 0], "B": [a, 0]}},
            "right": {"points": {"E": [0, 0], "D": [c, 0]}},
            "rodl": {"points": {"B": [0, 0], "C": [b, 0]}},
            "rodr": {"points": {"D": [0, 0], "C": [d, 0]}},
        },
        "assembly": {"B": [-200, -50], "C": place.tolist(), "D": [200, -50]},
        "paths": {"way": {"moves": "rodl", "at": "C", "x": f"{place[0]} mm", "y": f"{place[1]} mm"}},
        "drives": {
            "m1": {"turns": "left", "on": "frame", "output": "way"},
            "m2": {"turns": "right", "on": "frame", "output": "way"},
        },
    }
    _, findings = examine(Document.model_validate(data))
    told = [finding for finding in findings if finding.code == "assembly.out-of-reach"]
    beyond = [name for name, (low, high) in spans.items() if not low <= away[name] <= high]
    errors = {finding.code for finding in findings if finding.severity == "error"}
    if beyond == ["E"]:  # the right arm is a dyad once the left one has the point
        assert errors == {"assembly.cannot-close"}
    else:
        assert errors == ({"assembly.out-of-reach"} if beyond else set())
    for finding in told:
        pin = str(finding.data["pin"])
        low, high = spans[pin]
        limit = high if away[pin] > high else low
        assert pin in beyond and finding.data["distance"] == f"{away[pin]:.6g} mm"
        assert f"{limit:.6g} mm" in finding.what and f"{abs(away[pin] - limit):.4g} mm" in finding.what
