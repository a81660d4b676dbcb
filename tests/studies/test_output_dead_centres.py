"""Laws prescribed on an output: motion and forces as with the drive's own law, and the drive's dead centres."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from studies.models import CRANK, UNITS, Array, codes, cycle_of, four_bar, job_of, refused, slider_crank, speakable

LOADS = {
    "press": {"on": "slider", "at": "C", "along": "guide", "force": -150},
    "wind": {"on": "rod", "at": [30, 10], "force": [3, -7]},
}
GRAVITY = [0, "-9.80665 m/s^2"]


def same(data: dict[str, Any], drives: dict[str, Any], **sections: Any) -> tuple[Any, Any]:
    """Run a model with its own drives and with others; all signals that both have must agree."""
    a, b = cycle_of(data), cycle_of({**data, "drives": drives, **sections})
    assert not a.failures
    assert not b.failures
    one, other = a.result, b.result
    sizes: dict[Any, float] = {}
    for name in one.names:
        if not name.endswith(").arm"):
            known = np.abs(one[name])[np.isfinite(one[name])]
            sizes[one.dimension(name)] = max(sizes.get(one.dimension(name), 1e-3), known.max(initial=0.0))
    for name in one.names:
        if name in other.names and not name.endswith(").arm"):
            x, y = one[name], other[name]
            if name.endswith(".angle"):
                y = y + 2 * math.pi * np.round((x[0] - y[0]) / (2 * math.pi))
            size = sizes[one.dimension(name)]
            assert y == pytest.approx(x, abs=1e-9 * size), name
    assert other.certificate is not None
    assert other.certificate.sound()
    return one, other


def travel(angle: str) -> str:
    """The slider's place at a crank angle, as a formula of the file format (r = 50, l = 160, e = 20 mm)."""
    return f"50 mm*cos{angle} + sqrt((160 mm)^2 - (20 mm - 50 mm*sin{angle})^2)"


def test_the_ram_follows_the_law_that_its_crank_would_give_it() -> None:
    angle = "(60 deg + 40 deg*sin(360 deg*t/(1 s)))"
    data = slider_crank(loads=LOADS, gravity=GRAVITY, studies={"cycle": {"period": "1 s", "samples": 40}})
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "position": angle}}
    output = {"motor": {"turns": "crank", "on": "frame", "output": "guide", "position": travel(angle)}}
    same(data, output, assembly={"B": "left of A-C"})


def test_whole_turns_through_both_dead_centres() -> None:
    """Where the ram turns back the crank goes on, if it is to be kept; its torque has a limit there."""
    angle = "(30 deg + 360 deg*t/(1 s))"
    data = slider_crank(loads=LOADS, gravity=GRAVITY, drives={"motor": {**CRANK, "start": "30 deg"}})
    output = {"motor": {"turns": "crank", "on": "frame", "output": "guide", "position": travel(angle)}}
    studies = {"cycle": {"period": "1 s", "samples": 60, "through": "keep"}}
    one, other = same({**data, "studies": {"cycle": {"period": "1 s", "samples": 60}}}, output,
                      assembly={"B": "left of A-C"}, studies=studies)  # fmt: skip
    assert other["motor.angle"][-1] - other["motor.angle"][0] == pytest.approx(2 * math.pi)
    assert len(other.run.compiled.passages.every) >= 2
    assert one.names == other.names


def test_a_load_over_the_turns_of_a_motor_that_follows_its_output() -> None:
    """motor.angle is read off the crank's axis here; a load that grows with it needs its whole turns."""
    angle = "(30 deg + 360 deg*t/(1 s))"
    load = {"press": {"on": "slider", "at": "C", "along": "guide", "force": "-20 N*motor.angle/(1 rad)"}}
    data = slider_crank(loads=load, drives={"motor": {**CRANK, "start": "30 deg"}})
    data["studies"] = {"cycle": {"duration": "2 s", "samples": 40}}
    output = {"motor": {"turns": "crank", "on": "frame", "output": "guide", "position": travel(angle)}}
    studies = {"cycle": {"duration": "2 s", "samples": 40, "through": "keep"}}
    same(data, output, assembly={"B": "left of A-C"}, studies=studies)


def test_a_cylinder_moves_a_boom_by_the_boom_s_law() -> None:
    """The cosine theorem gives the cylinder's length to the boom's angle."""
    angle = "(70 deg + 25 deg*sin(360 deg*t/(1 s)))"
    length = f"sqrt((300 mm)^2 + (200 mm)^2 - 2*300 mm*200 mm*cos{angle})"
    data = {
        "units": UNITS,
        "gravity": GRAVITY,
        "links": {
            "frame": {"points": {"O": [0, 0], "G": [300, 0]}},
            "boom": {"points": {"O": [0, 0], "K": [200, 0], "E": [500, 0]}, "mass": 8, "shape": "rod O-E"},
            "barrel": {"points": {"G": [0, 0], "M": [100, 0]}, "mass": 2, "shape": "rod G-M"},
            "rod": {"points": {"K": [0, 0], "N": [-90, 0]}, "mass": 1, "shape": "rod K-N"},
        },
        "joints": {"ram": {"prismatic": ["barrel", "rod"], "line": ["G at 0 deg", "K at 0 deg"]}},
        "assembly": {"K": "left of O-G"},
        "loads": {"payload": {"on": "boom", "at": "E", "force": [0, -200]}},
        "drives": {"pump": {"slides": "rod", "on": "barrel", "position": length}},
        "studies": {"cycle": {"period": "1 s", "samples": 40}},
    }
    output = {"pump": {"slides": "rod", "on": "barrel", "output": "boom", "position": angle}}
    _, other = same(data, output, assembly={"K": "ahead of G along ram"})
    assert other["boom.angle"] == pytest.approx(np.radians(70 + 25 * np.sin(2 * np.pi * other.t)), abs=1e-12)
    # Named the other way round the pump's value and effort are the same: both point from one link to the other.
    swapped = {"pump": {**output["pump"], "slides": "barrel", "on": "rod"}}
    again = cycle_of({**data, "drives": swapped, "assembly": {"K": "ahead of G along ram"}}).result
    assert again["pump.s"] == pytest.approx(-other["pump.s"], rel=1e-12)
    assert again["pump.force"] == pytest.approx(-other["pump.force"], rel=1e-9)


def test_two_motors_that_each_follow_the_other_s_crank() -> None:
    """A five-bar: the laws prescribed crosswise, the torques where the motors are."""
    left, right = "100 deg + 15 deg*sin(360 deg*t/(1 s))", "70 deg + 20 deg*cos(360 deg*t/(1 s))"
    data = {
        "units": UNITS,
        "gravity": GRAVITY,
        "links": {
            "frame": {"points": {"A": [0, 0], "E": [100, 0]}},
            "first": {"points": {"A": [0, 0], "B": [80, 0]}, "mass": 1, "shape": "rod A-B"},
            "second": {"points": {"E": [0, 0], "D": [80, 0]}, "mass": 1, "shape": "rod E-D"},
            "arm": {"points": {"B": [0, 0], "C": [110, 0]}, "mass": 1, "shape": "rod B-C"},
            "other": {"points": {"D": [0, 0], "C": [110, 0]}, "mass": 1, "shape": "rod D-C"},
        },
        "assembly": {"C": "left of B-D"},
        "drives": {
            "m1": {"turns": "first", "on": "frame", "position": left},
            "m2": {"turns": "second", "on": "frame", "position": right},
        },
        "studies": {"cycle": {"period": "1 s", "samples": 40}},
    }
    crossed = {
        "m1": {"turns": "first", "on": "frame", "output": "second", "position": right},
        "m2": {"turns": "second", "on": "frame", "output": "first", "position": left},
    }
    same(data, crossed)


def freudenstein(s: Array, r: float, l: float, e: float) -> Array:  # noqa: E741
    """The crank angle (0..pi) to a slider's place: the angle of A-C plus that at A in the triangle A, B, C."""
    d = np.hypot(s, e)
    return np.arctan2(e, s) + np.arccos((d**2 + r**2 - l**2) / (2 * r * d))


def test_massless_slider_crank_in_closed_form() -> None:
    """torque = -F ds/dq, with q by Freudenstein's equation solved for the crank."""
    data = slider_crank(loads={"press": LOADS["press"]})
    for link in data["links"].values():
        link.pop("mass", None)
        link.pop("shape", None)
    law = "150 mm + 30 mm*sin(360 deg*t/(1 s))"
    data |= {"drives": {"motor": {"turns": "crank", "on": "frame", "output": "guide", "position": law}}}
    data |= {"assembly": {"B": "left of A-C"}, "studies": {"cycle": {"period": "1 s", "samples": 40}}}
    outcome = cycle_of(data)
    result = outcome.result
    s = 0.15 + 0.03 * np.sin(2 * np.pi * result.t)
    v = 0.06 * np.pi * np.cos(2 * np.pi * result.t)
    q = freudenstein(s, 0.05, 0.16, 0.02)
    # Differentiating (s - r cos q)^2 + (e - r sin q)^2 = l^2:
    slope = -(0.05 * s * np.sin(q) - 0.05 * 0.02 * np.cos(q)) / (s - 0.05 * np.cos(q))
    assert result["guide.s"] == pytest.approx(s, abs=1e-15)
    assert result["motor.angle"] == pytest.approx(q, abs=1e-12)
    assert result["motor.omega"] == pytest.approx(v / slope, rel=1e-10, abs=1e-10)
    assert result["motor.torque"] == pytest.approx(150 * slope, rel=1e-10)
    assert result["motor.power"] == pytest.approx(150 * v, abs=1e-10)


# Where the drive can't move its output.


def test_a_law_beyond_reach_says_how_far_the_output_goes() -> None:
    """r + l = 210 mm on a line through A; the law asks for 220."""
    data = slider_crank(50, 160, 0)
    law = "180 mm + 40 mm*sin(360 deg*t/(1 s))"
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "output": "guide", "position": law}}
    data |= {"assembly": {"B": "left of A-C"}, "studies": {"cycle": {"period": "1 s"}}}
    (failure,) = cycle_of(data).failures
    assert failure.code == "motion.out-of-reach"
    assert (failure.data["drive"], failure.data["unit"]) == ("guide", "mm")
    assert float(failure.data["from"]) == pytest.approx(210)
    assert float(failure.data["worst"]) == pytest.approx(220, abs=1e-3)
    assert failure.data["start"] == pytest.approx(math.asin(0.75) / 2 / math.pi, abs=1e-9)
    assert speakable(failure)


def test_a_law_that_meets_the_limit_is_refused_or_kept() -> None:
    data = slider_crank(50, 160, 0)
    law = "180 mm + 30 mm*sin(360 deg*t/(1 s))"
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "output": "guide", "position": law}}
    data |= {"assembly": {"B": "left of A-C"}, "studies": {"cycle": {"period": "1 s"}}}
    (failure,) = cycle_of(data).failures
    assert failure.code == "motion.singular"
    assert float(failure.data["value"]) == pytest.approx(210)


def test_dead_centres_of_a_motor_on_the_rocker() -> None:
    """Crank and coupler in line, stretched and folded: the rocker stands still while the crank moves."""
    motor = {"turns": "rocker", "on": "frame", "output": "crank", "speed": "60 rpm", "start": "10 deg"}
    outcome = cycle_of(four_bar(drives={"motor": motor}, studies={"cycle": {"duration": "1 s", "samples": 40}}))
    assert codes(outcome.failures) == ["motion.dead-centre"] * 2
    stretched = math.acos((160**2 + 100**2 - 80**2) / (2 * 160 * 100))
    folded = math.pi + math.acos((80**2 + 100**2 - 80**2) / (2 * 80 * 100))
    assert [float(f.data["value"]) for f in outcome.failures] == pytest.approx(
        np.degrees([stretched, folded]), rel=1e-5
    )
    assert all(speakable(f) for f in outcome.failures)
    motor |= {"start": "30 deg", "speed": "150 deg/s"}
    between = cycle_of(four_bar(drives={"motor": motor}, studies={"cycle": {"duration": "1 s", "samples": 40}}))
    assert not between.failures


@pytest.mark.parametrize(
    ("drive", "code"),
    [
        ({"output": "giude"}, "drive.output"),
        ({"output": "frame"}, "drive.output"),
        ({"output": "crank", "position": "30 deg*sin(90 deg*t/(1 s))"}, "drive.output-own"),
    ],
)
def test_outputs_that_are_none(drive: dict[str, Any], code: str) -> None:
    drives = {"motor": {"turns": "crank", "on": "frame", "position": "180 mm + 10 mm*sin(90 deg*t/(1 s))", **drive}}
    found = refused(slider_crank(drives=drives))
    assert code in codes(found)


def test_an_output_that_isn_t_hinged_on_the_frame() -> None:
    """The rod's angle to the frame follows the law; the slider, which its guide keeps from turning, can't."""
    law = {"turns": "crank", "on": "frame", "position": "-3 deg + 3 deg*sin(90 deg*t/(1 s))"}
    sketch, cycle = {"C": [200, 20], "B": [40, 30]}, {"cycle": {"duration": "1 s", "samples": 40}}
    job = job_of(slider_crank(drives={"motor": {**law, "output": "rod"}}, assembly=sketch, studies=cycle))
    assert not job.examined.findings
    job = job_of(slider_crank(drives={"motor": {**law, "output": "slider"}}))
    assert codes(job.examined.findings) == ["structure.drive-angle-fixed"]


def test_two_laws_for_one_output() -> None:
    law = "180 mm + 10 mm*sin(90 deg*t/(1 s))"
    drives = {
        "motor": {"turns": "crank", "on": "frame", "output": "guide", "position": law},
        "ram": {"slides": "slider", "on": "frame", "position": law},
    }
    assert "drive.twice" in codes(refused(slider_crank(drives=drives)))


def test_a_motor_that_isn_t_joined_to_its_output() -> None:
    """A motor on the rocker of a four-bar that another drive moves, to turn a crank beside it."""
    data = four_bar()
    data["links"]["frame"]["points"]["K"] = [0, 300]
    data["links"]["beside"] = {"points": {"K": [0, 0]}}
    law = "30 deg*sin(90 deg*t/(1 s))"
    data["drives"]["other"] = {"turns": "rocker", "on": "frame", "output": "beside", "position": law}
    job = job_of(data)
    assert codes(job.examined.findings) == ["structure.output-apart"]
    assert all(speakable(f) for f in job.examined.findings)
