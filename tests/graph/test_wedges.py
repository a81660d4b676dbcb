"""Loops of slides alone: travels and forces by hand, the whole system without groups, and what statics leaves open."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import linkwright as lw
from helpers.compiled import compiled_from
from linkwright.expressions.dimensions import DimensionError
from linkwright.kernels import Compiled
from linkwright.results.certificate import closure, equilibrium, power, rank
from linkwright.results.independent_check import Reports
from linkwright.structure import Wedge
from studies.models import UNITS, job_of, refused

T = np.linspace(0.0, 1.0, 7)
SIXTY = math.radians(60)


def wedge(**sections: Any) -> dict[str, Any]:
    """The driver goes down, the slide to the right by tan(30 deg) of it; 800 N push the slide back."""
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "driver": {"points": {"D": [0, 0]}, "mass": 5, "shape": "point D"},
            "slide": {"points": {"S": [0, 0]}, "mass": 3, "shape": "point S"},
        },
        "joints": {
            "down": {"prismatic": ["frame", "driver"], "line": ["O at -90 deg", "D at -90 deg"]},
            "face": {"prismatic": ["driver", "slide"], "line": ["D at -120 deg", "S at -120 deg"]},
            "across": {"prismatic": ["frame", "slide"], "line": ["O at 0 deg", "S at 0 deg"]},
        },
        "drives": {"press": {"slides": "driver", "on": "frame", "position": "10 + 5*t/(1 s) + 3*(t/(1 s))^2"}},
        "loads": {"work": {"on": "slide", "at": "S", "along": "across", "force": -800}},
        **sections,
    }


def sound(compiled: Compiled) -> None:
    """The proofs hold, and one of six constraints says nothing new."""
    reports = Reports(compiled, T)
    assert max(closure(reports), equilibrium(reports), power(reports)) < 1e-12
    moving = len(compiled.structure.topology.moving)
    assert 3 * moving - rank(reports) == compiled.structure.topology.gruebler


def test_travels_and_forces_by_hand() -> None:
    """With the face at 60 deg to the horizontal: s = h/tan(60 deg), F = (W + m a)/tan(60 deg) + m_driver a_driver."""
    compiled = compiled_from(wedge())
    assert [type(step) for step in compiled.structure.steps][-1] is Wedge
    h, a = 10 + 5 * T + 3 * T**2, 6e-3
    names = ["across.s", "across.a", "press.force", "force(driver, slide).normal", "force(frame, slide).y"]
    s, acceleration, force, normal, floor = compiled.evaluate(names, T)
    assert s == pytest.approx(h / 1000 / math.tan(SIXTY), rel=1e-14)
    assert acceleration == pytest.approx(np.full(T.size, a / math.tan(SIXTY)), rel=1e-14)
    along = 800 + 3 * a / math.tan(SIXTY)
    assert force == pytest.approx(np.full(T.size, along / math.tan(SIXTY) + 5 * a), rel=1e-14)
    assert abs(normal) == pytest.approx(np.full(T.size, along / math.sin(SIXTY)), rel=1e-14)
    assert floor == pytest.approx(np.full(T.size, along / math.tan(SIXTY)), rel=1e-14)
    sound(compiled)


@settings(max_examples=20, deadline=None)
@given(
    st.lists(st.floats(-170, 170), min_size=3, max_size=3),
    st.lists(st.floats(-60, 60), min_size=3, max_size=3),
    st.floats(-180, 180),
    st.floats(-180, 180),
)
def test_general_angles(lines: list[float], places: list[float], first: float, second: float) -> None:
    """Three slides at any angles, links drawn at any direction: travel from the two lines, force by virtual power."""
    a, f, b = np.radians(lines)
    gap = abs(math.sin(f - b)), abs(math.sin(f - a))
    if min(gap) < 0.1:
        return
    links = {
        "frame": {"points": {"O": [places[0], 5], "P": [-7, places[1]]}},
        "driver": {"points": {"D": [4, places[2]]}, "mass": 5, "com": [3, 8], "inertia": 900},
        "slide": {"points": {"S": [-2, 6]}, "mass": 3, "com": [9, -4], "inertia": 700},
    }
    # A line's direction in a link that is turned by `first` (`second`) is that in the frame less the turn.
    joints = {
        "down": {"prismatic": ["frame", "driver"], "line": [f"O at {lines[0]}", f"D at {lines[0] - first}"]},
        "face": {"prismatic": ["driver", "slide"], "line": [f"D at {lines[1] - first}", f"S at {lines[1] - second}"]},
        "across": {"prismatic": ["frame", "slide"], "line": [f"P at {lines[2]}", f"S at {lines[2] - second}"]},
    }
    data = wedge(links=links, joints=joints, gravity=[0, "-9.81 m/s^2"])
    compiled = compiled_from(data)
    ratio = math.sin(a - f) / math.sin(b - f)  # from (u_a v_a - u_b v_b) x u_f = 0
    names = ["down.v", "across.v", "down.a", "across.a", "press.force", "slide.angle", "slide.omega"]
    v, w, av, aw, force, angle, omega = compiled.evaluate(names, T)
    assert w == pytest.approx(ratio * v, rel=1e-11)
    assert aw == pytest.approx(ratio * av, rel=1e-11)
    assert np.abs(np.sin(angle - math.radians(second))).max() < 1e-12
    assert not omega.any()
    # Virtual power: of press, load, weights and inertia at the rates 1 and `ratio`.
    weights = -9.81 * (5 * math.sin(a) + 3 * ratio * math.sin(b))
    expected = 5 * av + 3 * ratio * aw - weights + 800 * ratio
    assert force == pytest.approx(expected, rel=1e-10, abs=1e-9)
    sound(compiled)


@pytest.mark.parametrize(
    "drive",
    [
        {"slides": "slide", "on": "frame", "position": "10 + 5*t/(1 s)"},
        {"slides": "slide", "on": "driver", "position": "10 + 5*t/(1 s)"},
        {"slides": "driver", "on": "slide", "position": "10 + 5*t/(1 s)"},
    ],
)
def test_any_of_the_slides_may_be_driven(drive: Any) -> None:
    compiled = compiled_from(wedge(drives={"press": drive}))
    name = "across" if drive["on"] == "frame" else "face"
    (s,) = compiled.evaluate([f"{name}.s"], T)
    assert abs(s) == pytest.approx((10 + 5 * T) / 1000, rel=1e-12)
    h, x = compiled.evaluate(["down.s", "across.s"], T)
    assert x == pytest.approx(h / math.tan(SIXTY), rel=1e-12)
    sound(compiled)


def test_a_crank_moves_two_wedges_in_a_row() -> None:
    """A slider-crank drives the first link; the third one follows by two loops of slides."""
    data = wedge(drives={"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "20 deg"}})
    data["links"] |= {
        "frame": {"points": {"O": [0, 0], "A": [0, 150], "Q": [60, 0]}},
        "crank": {"points": {"A": [0, 0], "B": [20, 0]}, "mass": 1, "shape": "rod A-B"},
        "rod": {"points": {"B": [0, 0], "D": [90, 0]}, "mass": 0.5, "shape": "rod B-D"},
        "lifter": {"points": {"L": [0, 0]}, "mass": 2, "shape": "point L"},
    }
    data["joints"] |= {
        "ramp": {"prismatic": ["slide", "lifter"], "line": ["S at 20 deg", "L at 20 deg"]},
        "up": {"prismatic": ["frame", "lifter"], "line": ["Q at 90 deg", "L at 90 deg"]},
    }
    data["assembly"] = {"D": "ahead of B along down"}
    compiled = compiled_from(data)
    assert compiled.structure.topology.gruebler == 1
    h, x, y, vx, vy = compiled.evaluate(["down.v", "across.v", "up.v", "across.a", "up.a"], T)
    assert x == pytest.approx(h / math.tan(SIXTY), rel=1e-12)
    assert y == pytest.approx(-x * math.tan(math.radians(20)), rel=1e-12)
    assert vy == pytest.approx(-vx * math.tan(math.radians(20)), rel=1e-12)
    sound(compiled)


def test_a_loop_of_slides_that_turns() -> None:
    """A cylinder's barrel and rod, and a block that slides on both: the whole loop swings about two pins."""
    data = {
        "units": {**UNITS, "length": "m"},
        "gravity": [0, "-9.81 m/s^2"],
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [3, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [1, 0]}, "mass": 2, "shape": "rod A-B"},
            "a": {"points": {"B": [0, 0], "P": [0, 1]}, "mass": 3, "com": [0.2, 0.5], "inertia": 0.3},
            "b": {"points": {"Q": [0, 0]}, "mass": 1, "com": [0.1, -0.2], "inertia": 0.1},
            "c": {"points": {"R": [0, 0], "D": [1, 0]}, "mass": 2, "com": [0.4, 0.3], "inertia": 0.2},
        },
        "joints": {
            "ab": {"prismatic": ["a", "b"], "line": ["P at 10", "Q at 10"]},
            "bc": {"prismatic": ["b", "c"], "line": ["Q at 60", "R at 60"]},
            "ca": {"prismatic": ["c", "a"], "line": ["R at 120", "P at 120"]},
        },
        "assembly": {"D": "ahead of B along ca"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "30 rpm", "start": "20 deg"}},
        "loads": {"push": {"on": "b", "against": "c", "at": [0.3, 0.1], "force": [4, -7], "torque": 2}},
    }
    compiled = compiled_from(data)
    angles = compiled.evaluate(["a.omega", "b.omega", "c.omega"], T)
    assert np.ptp(angles, axis=0).max() < 1e-12
    sound(compiled)
    without = compiled_from({**data, "joints": {"ca": data["joints"]["ca"]}, "links": _only(data, "b"), "loads": {}})
    names = ["motor.angle", "a.alpha", "ca.s", "ca.a"]
    assert compiled.evaluate(names, T) == pytest.approx(without.evaluate(names, T), rel=1e-11)


def _only(data: Any, left_out: str) -> dict[str, Any]:
    return {name: link for name, link in data["links"].items() if name != left_out}


def test_moments_in_the_loop_are_named_as_indeterminate() -> None:
    job = job_of(wedge(studies={"cycle": {"duration": "1 s", "samples": 10}}, measures={"f": {"max": "press.force"}}))
    assert job.exit_code == 0
    (warning,) = (f for f in job.examined.findings if f.code == "structure.moments-indeterminate")
    assert warning.severity == "warning"
    names = [signal.text for signal in job.cycle.result.run.compiled.quantities.signals.all()]  # type: ignore[union-attr]
    assert "force(driver, slide).normal" in names
    assert not [name for name in names if name.startswith("force(") and name.endswith((".moment", ".arm"))]


@pytest.mark.parametrize("attribute", ["moment", "arm"])
def test_an_indeterminate_moment_is_refused_by_name(attribute: str) -> None:
    measures = {"m": {"max": f"force(frame, slide).{attribute}"}}
    findings = refused(wedge(measures=measures, studies={"cycle": {"duration": "1 s", "samples": 10}}))
    assert [f.code for f in findings] == ["signal.indeterminate"]
    with pytest.raises(DimensionError, match="indeterminate"):
        compiled_from(wedge()).evaluate([f"force(frame, slide).{attribute}"], T)


def test_a_slide_beside_the_loop_keeps_its_moment() -> None:
    data = wedge()
    data["links"]["tool"] = {"points": {"X": [0, 0]}, "mass": 1, "com": [10, 4], "inertia": 50}
    data["joints"]["clamp"] = {"prismatic": ["slide", "tool"], "line": ["S at 90 deg", "X at 90 deg"]}
    data["drives"]["feed"] = {"slides": "tool", "on": "slide", "position": "3 + 1 mm*t/(1 s)"}
    data["gravity"] = [0, "-9.81 m/s^2"]
    compiled = compiled_from(data)
    (moment,) = compiled.evaluate(["force(slide, tool).moment"], T)
    assert moment == pytest.approx(np.full(T.size, 0.01 * 9.81 + 0.004 * -6e-3 / math.tan(SIXTY)), rel=1e-10)
    sound(compiled)


def test_slides_that_do_not_close_are_refused() -> None:
    data = wedge()
    data["joints"]["face"]["line"] = ["D at -120 deg", "S at -110 deg"]
    (finding,) = lw.check(lw.Document.model_validate(data))
    assert finding.code == "joint.slides-tilted"
    assert finding.data["angle"] == "10"


def test_parallel_slides_are_refused() -> None:
    data = wedge()
    data["joints"]["face"]["line"] = ["D at 0 deg", "S at 0 deg"]
    assert [f.code for f in lw.check(lw.Document.model_validate(data))] == ["assembly.slides-parallel"]


def test_a_parameter_that_would_tear_the_loop_open_is_not_varied() -> None:
    def swept(other: str) -> dict[str, Any]:
        data = wedge(parameters={"a": {"value": 120, "tolerance": 0.1}}, measures={"f": {"max": "press.force"}})
        data["joints"]["face"]["line"] = ["D at -a", f"S at {other}"]
        return data | {"studies": {"cycle": {"duration": "1 s", "samples": 10}, "accuracy": {"outputs": ["f"]}}}

    assert [f.code for f in refused(swept("-120 deg"))][1:] == ["varied.slides"]
    job = job_of(swept("-a"))
    assert job.accuracy is not None
    figure = job.accuracy.figures["f"]
    # F = W/tan(a) + ... at rest but for 6 mm/s^2, which the sum below takes in.
    slope = -(800 + 2 * 3 * 6e-3 / math.tan(SIXTY)) / math.sin(SIXTY) ** 2 * math.radians(0.1)
    assert max(figure.worst) == pytest.approx(abs(slope), rel=1e-6)


def test_a_second_guide_is_redundant() -> None:
    data = wedge()
    data["joints"]["floor"] = {"prismatic": ["frame", "slide"], "line": ["O at 0 deg", "S at 0 deg"]}
    found = lw.check(lw.Document.model_validate(data))
    assert [f.path for f in found if f.code == "structure.redundant-joints"] == [("joints", "floor")]
    assert job_of(data | {"studies": {"cycle": {"duration": "1 s", "samples": 10}}}).exit_code == 0


def test_two_drives_are_one_too_many() -> None:
    data = wedge()
    data["drives"]["other"] = {"slides": "slide", "on": "frame", "position": "10"}
    assert [f.code for f in lw.check(lw.Document.model_validate(data))] == ["structure.drive-too-many"]


def test_limits_modes_and_a_report(tmp_path: Any) -> None:
    data = wedge(studies={"cycle": {"duration": "1 s", "samples": 10}, "limits": {}, "modes": {}})
    job = lw.run(lw.Document.model_validate(data), tmp_path)
    assert job.exit_code == 0
    assert len(job.summary["modes"]["modes"]) == 1
    page = (tmp_path / "report.html").read_text()
    assert "slide as Assur group PP" in page


@pytest.mark.parametrize(
    ("sections", "code"),
    [
        ({"exports": {"mjcf": {}}}, "export.cannot-close-slides"),
        (
            {
                "parameters": {"h": {"value": 10, "tolerance": 0.1}},
                "measures": {"f": {"max": "press.force"}},
                "studies": {
                    "cycle": {"duration": "1 s", "samples": 10},
                    "accuracy": {"clearances": {"across": {"clearance": 0.05, "length": 40}}},
                },
            },
            "clearance.indeterminate",
        ),
    ],
)
def test_what_needs_a_moment_of_the_loop_is_refused(sections: Any, code: str) -> None:
    findings = job_of(wedge(**sections)).examined.findings
    assert code in [finding.code for finding in findings]
    assert all(finding.what and finding.mend for finding in findings)
