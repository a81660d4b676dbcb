"""Elements whose numbers or names lie at the edge of sense: refused by name, without a failure on the way."""

from __future__ import annotations

import math
from typing import Any

import pytest

import linkwright as lw
from linkwright.findings import Finding
from linkwright.measures import together
from linkwright.report import understood
from studies.models import UNITS, codes, four_bar, job_of, refused, speakable


def wheel_on(joint: dict[str, Any], **sections: Any) -> dict[str, Any]:
    """A crank and a wheel on the frame, with a joint of both; the crank turns at 60 rpm."""
    return {
        "units": UNITS,
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [100, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [40, 0]}},
            "wheel": {"points": {"D": [0, 0], "X": [9, 0]}},
        },
        "joints": {"x": joint},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "0 deg"}},
        "studies": {"cycle": {"turns": "1 motor", "samples": 8}},
        **sections,
    }


def found(data: dict[str, Any]) -> list[Finding]:
    job = job_of(data)
    assert job.exit_code
    assert all(speakable(finding) for finding in [*job.examined.findings, *job.found])
    return [*job.examined.findings, *job.found]


def test_a_rack_whose_guide_names_no_point_is_told_the_name() -> None:
    """The guide is another joint, whose line names a point that the frame hasn't."""
    rack = {"rack": ["wheel", "bar"], "centre": "D", "pitch_line": "R at 0 deg", "radius": 10}
    data = wheel_on(rack)
    data["links"]["bar"] = {"points": {"R": [0, 0]}}
    data["joints"]["guide"] = {"prismatic": ["frame", "bar"], "line": ["DD at 0 deg", "R at 0 deg"]}
    (finding,) = refused(data)
    assert finding.code == "name.unknown-point"
    assert "D" in finding.mend


def test_a_disc_on_a_circle_of_a_fixed_distance_is_redundant() -> None:
    """Both centres are pinned to the frame: the distance is held twice. It runs, and the wheel turns by the radii."""
    circle = {"centre": "A", "radius": 95}
    job = job_of(wheel_on({"rolling": ["wheel", "crank"], "centre": "D", "radius": 5, "on_circle": circle}))
    assert codes(job.examined.findings) == ["structure.redundant-joints"]
    assert job.cycle is not None
    assert job.cycle.result.certificate is not None
    assert job.cycle.result.certificate.sound()
    run = job.cycle.result.run
    assert run.evaluate(["wheel.omega"], run.t)[0] == pytest.approx(-2 * math.pi * 95 / 5, rel=1e-12)


@pytest.mark.parametrize("factor", [1e12, 1e30, -1e30])
def test_an_angle_that_double_precision_cannot_resolve_is_refused(factor: float) -> None:
    data = wheel_on({"coupling": ["wheel", "frame"], "follows": f"{factor}*motor.angle"})
    assert codes(found(data)) == ["motion.angle-too-large"]


def test_a_motor_of_such_a_speed_is_refused() -> None:
    data = four_bar(studies={"cycle": {"duration": "1 s", "samples": 8}})
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "speed": "1e30 rpm", "start": "0 deg"}}
    assert "motion.angle-too-large" in codes(found(data))


def test_a_fast_follower_takes_bounded_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    """Means over ten thousand revolutions are computed on panels in bounded numbers."""
    sizes: list[int] = []
    panel_points = together.panel_points

    def noted(lows: Any, highs: Any, points: int) -> Any:
        sizes.append(lows.size)
        return panel_points(lows, highs, points)

    monkeypatch.setattr(together, "panel_points", noted)
    data = wheel_on({"coupling": ["wheel", "frame"], "follows": "10000*motor.angle"})
    job = job_of(data)
    assert job.cycle is not None
    assert job.cycle.overview
    assert sum(sizes) < 1_000_000


@pytest.mark.parametrize(("slots", "code"), [("3000", "geneva.slots"), ("101", "geneva.slots"), ("2", "geneva.slots")])
def test_slots_of_a_geneva_wheel_are_limited(slots: str, code: str) -> None:
    radius = f"sin(180 deg/{slots})*100"
    geneva = {"geneva": ["crank", "wheel"], "centres": ["A", "D"], "pins": ["B"], "arc": f"{radius}*0.9"}
    data = wheel_on({**geneva, "slots": int(slots)})
    data["links"]["crank"]["points"]["B"] = [radius, 0]
    assert code in codes(refused(data))


def test_two_frictions_of_one_pin_are_refused() -> None:
    own = {"pin": "A", "radius": "3 mm", "coefficient": 0.1}
    data = four_bar(friction={"first": own, "second": {**own, "coefficient": 0.2}})
    (finding,) = refused(data)
    assert (finding.code, finding.path) == ("friction.twice", ("friction", "second"))
    assert "first" in finding.what


def test_frictions_between_other_links_of_one_pin_are_two() -> None:
    own = {"pin": "A", "radius": "3 mm", "coefficient": 0.1}
    data = four_bar()
    data["links"]["arm"] = {"points": {"A": [0, 0], "Q": [50, 0]}}
    data["drives"]["second"] = {"turns": "arm", "on": "coupler", "speed": "10 rpm", "start": "0 deg"}
    data["friction"] = {"first": {**own, "in": ["coupler", "crank"]}, "second": {**own, "in": ["arm", "coupler"]}}
    assert "friction.twice" not in {finding.code for finding in lw.check(lw.Document.model_validate(data))}


@pytest.mark.parametrize("law", ["cycloidal", "poly_345", "poly_4567"])
def test_a_weld_whose_motor_starts_from_rest_is_described(law: str) -> None:
    """A speed of round-off at the start isn't a speed whose revolution ends somewhere."""
    segments = [{kind: "6.7 deg", "over": "0.3 s", "law": law} for kind in ("rise", "fall")]
    data = four_bar(laws={"lift": {"over": "time", "of": "angle", "segments": segments}})
    data["links"]["coupler"]["points"]["W"] = [60, 0]
    data["links"]["bracket"] = {"points": {"W": [0, 0], "E": [20, 0]}}
    data["joints"] = {"seam": {"weld": ["bracket", "coupler"], "angle": "30 deg"}}
    data["drives"] = {"motor": {"turns": "crank", "on": "frame", "position": "30 deg + lift(t)"}}
    data["studies"] = {"cycle": {"duration": "0.6 s", "samples": 12}}
    job = job_of(data)
    assert job.exit_code == 0, codes([*job.examined.findings, *job.found])
    assert job.cycle is not None
    told = [str(line) for line in understood.drives(job.cycle.result.run.compiled)]
    assert all("starts at 30 deg with 0 deg/s" in line for line in told if line.startswith("motor")), told
