"""Static coefficients: the efforts that start a motion from rest, against closed forms and the same mechanisms in slow
motion whose coefficients are the static ones; where a released mechanism stays; what is refused."""

from __future__ import annotations

import copy
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.examples import UNITS
from helpers.friction import slider_crank
from linkwright.findings import ModelError
from linkwright.model.document import Document, parse_document
from linkwright.results import certificate
from linkwright.results.breakaway import resting_stretches, unstarted
from linkwright.results.certificate import certify
from linkwright.results.run import Run

EXAMPLES = Path(__file__).parents[2] / "examples"
BREAKAWAY = ["motor.breakaway_forward", "motor.breakaway_backward"]


def example(name: str) -> dict[str, Any]:
    data: dict[str, Any] = YAML(typ="safe").load((EXAMPLES / f"{name}.yaml").read_text(encoding="utf-8"))
    return {key: value for key, value in data.items() if key not in ("measures", "require", "studies", "note")}


def with_static(data: dict[str, Any], static: float) -> dict[str, Any]:
    made = copy.deepcopy(data)
    for entry in made["friction"].values():
        entry["static"] = static
    return made


def in_motion(data: dict[str, Any], static: float, speed: str) -> dict[str, Any]:
    made = copy.deepcopy(data)
    for entry in made["friction"].values():
        entry.pop("static", None)
        entry.pop("viscous", None)
        entry["coefficient"] = static
    made["drives"]["motor"] |= {"speed": speed}
    return made


def block(slope: float, mu: float, static: float | None, speed: float = 0.1) -> dict[str, Any]:
    """A block of 10 kg on a slope, pushed along it; its weight goes through the middle of its long seat."""
    friction = {"slide": "slope", "length": 1, "coefficient": mu} | ({"static": static} if static is not None else {})
    return {
        "linkwright": 1,
        "units": dict(UNITS),
        "gravity": [0, -9.81],
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "block": {"points": {"B": [0, 0]}, "mass": 10, "shape": "point B"},
        },
        "joints": {"slope": {"prismatic": ["frame", "block"], "line": [f"O at {slope!r}", "B at 0"]}},
        "drives": {"motor": {"slides": "block", "on": "frame", "speed": speed, "start": 0}},
        "friction": {"seat": friction},
    }


@pytest.mark.parametrize(("slope", "mu", "static"), [(0.3, 0.1, 0.2), (0.1, 0.1, 0.25), (-0.4, 0.0, 0.3)])
def test_a_block_on_a_slope(slope: float, mu: float, static: float) -> None:
    """W (sin a + mu_s cos a) starts it upwards, W (sin a - mu_s cos a) downwards; W (sin a + mu cos a) keeps it
    moving. It stays where it is where tan a < mu_s."""
    run = Run(compiled_from(block(slope, mu, static)), 0.0, 1.0, 20)
    forward, backward, moving = run.evaluate([*BREAKAWAY, "motor.force"], np.array([0.1, 0.7]))
    weight = 98.1
    assert forward == pytest.approx(weight * (math.sin(slope) + static * math.cos(slope)), rel=1e-12)
    assert backward == pytest.approx(weight * (math.sin(slope) - static * math.cos(slope)), rel=1e-12)
    assert moving == pytest.approx(weight * (math.sin(slope) + mu * math.cos(slope)), rel=1e-12)
    stays = resting_stretches(run, "motor")
    assert stays == ([(0.0, 1.0)] if abs(math.tan(slope)) < static else [])
    proof = certify(run)
    assert proof.sound() and proof.starting is not None and proof.starting < 1e-12


@pytest.mark.parametrize("static", [0.1, 0.14])
def test_a_massless_slider_crank_moves_as_it_starts(static: float) -> None:
    """Without masses the torque in motion is that of the same pose at rest, with the static coefficients."""
    t = np.linspace(0.0, 0.2, 37) + 0.0013
    found = Run(compiled_from(with_static(slider_crank(0.1, 0.1), static)), 0.0, 0.25, 100).evaluate(BREAKAWAY, t)
    forward = Run(compiled_from(in_motion(slider_crank(), static, "300 rpm")), 0.0, 0.25, 100)
    assert found[0] == pytest.approx(forward.evaluate(["motor.torque"], t)[0], rel=1e-10)
    backward = Run(compiled_from(in_motion(slider_crank(), static, "-300 rpm")), -0.25, 0.0, 100)
    # The same poses: 300 rpm from 0.3 rad forwards are minus 300 rpm backwards in time.
    assert found[1] == pytest.approx(backward.evaluate(["motor.torque"], -t)[0], rel=1e-10)


@pytest.mark.parametrize(
    ("name", "static"), [("lifting_crank", 0.16), ("coupled_cranks", 0.2), ("scotch_yoke_friction", 0.2)]
)
def test_it_is_the_slowest_motion(name: str, static: float) -> None:
    """Against the mechanism in a motion so slow that no inertia is left; with a follower, with a pin in a slot too."""
    data = example(name)
    data.pop("windows", None)
    if "friction" not in data:
        data["friction"] = {f"at_{pin}": {"pin": pin, "radius": 10, "coefficient": 0.1} for pin in ("B", "C", "E")}
    for load in data.get("loads", {}).values():
        load.pop("window", None)
    start, speed = data["drives"]["motor"]["start"], 1e-7
    angles = np.radians([17.0, 93.0, 201.0, 318.0])
    slow = in_motion(data, static, f"{speed} rad/s"), in_motion(data, static, f"-{speed} rad/s")
    still = with_static(data, static)
    for angle in angles:
        drive = {"motor": {**data["drives"]["motor"], "speed": "1e-3 rad/s", "start": f"{float(angle)!r} rad"}}
        at = np.array([0.0])
        found = Run(compiled_from({**still, "drives": drive}), 0.0, 1.0, 10).evaluate(BREAKAWAY, at)[:, 0]
        for value, moving in zip(found, slow, strict=True):
            moved = {"motor": {**moving["drives"]["motor"], "start": f"{float(angle)!r} rad"}}
            expected = Run(compiled_from({**moving, "drives": moved}), 0.0, 1.0, 10).evaluate(["motor.torque"], at)[
                0, 0
            ]
            assert value == pytest.approx(expected, rel=1e-8)
    assert start is not None


def test_the_proof_finds_a_wrong_effort(monkeypatch: pytest.MonkeyPatch) -> None:
    """Efforts that are off by a millionth don't pass: the creeping mechanism has its own."""
    run = Run(compiled_from(block(0.3, 0.1, 0.2)), 0.0, 1.0, 20)
    right = certificate.efforts
    monkeypatch.setattr(certificate, "efforts", lambda *args: right(*args) * (1 + 1e-6))
    assert not certify(run).sound()


def test_the_example_says_where_it_stays_and_what_it_takes() -> None:
    job = lw.run(lw.load(EXAMPLES / "lifting_crank.yaml"))
    assert job.exit_code == 0
    outcome = job.outcomes["cycle"]
    figures = {measure.name: measure.shown(measure.found[0].label) for measure in outcome.measures}
    assert figures["starting"] > figures["running"] > 0 > figures["lowering"]
    assert "friction.rests" in [finding.code for finding in outcome.warnings]


def drawer(static: float) -> dict[str, Any]:
    """A drawer drawn at one side of its short guide: it jams where mu 2 e/length is 1."""
    data = block(0.0, 0.2, static)
    data["gravity"] = [0, 0]
    data["loads"] = {"pull": {"on": "block", "at": [0, 0], "force": [0, -50]}}
    data["links"]["block"]["points"]["P"] = [0.0, 0.4]
    data["links"]["frame"]["points"]["K"] = [-5.0, 0.4]
    data["links"] |= {"puller": {"points": {"Q": [0, 0], "P": [0.5, 0]}}, "knob": {"points": {"Q": [0, 0]}}}
    data["joints"]["rail"] = {"prismatic": ["frame", "knob"], "line": ["K at 0", "Q at 0"]}
    data["assembly"] = {"P": "ahead of Q along slope"}
    data["friction"]["seat"]["length"] = 0.2
    data["drives"] = {"motor": {"slides": "knob", "on": "frame", "speed": 0.1, "start": 4.5}}
    return data


def test_what_jams_at_rest_alone_is_a_warning() -> None:
    """2 e mu/length is 0.8 in motion and over 1 at rest: no force starts the drawer, though it would keep moving."""
    run = Run(compiled_from(drawer(0.24)), 0.0, 1.0, 20)
    assert not unstarted(run.compiled, "motor", np.array([0.5]))["forward"].size
    data = drawer(0.3)
    data["studies"] = {"cycle": {"duration": 1, "samples": 20}}
    job = lw.run(Document.model_validate(data))
    assert job.exit_code == 0
    found = [f for f in job.outcomes["cycle"].warnings if f.code == "friction.cannot-start"]
    assert found and all(f.severity == "warning" for f in found)


@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"coefficient": None, "viscous": 1.0}, "friction.static"),
        ({"static": 0.05}, "friction.static-less"),
        ({"static": -1}, "value.too-small"),
        ({"static": "motor.v*(1 s/m)"}, "expression"),
    ],
)
def test_refused_by_name(change: dict[str, Any], code: str) -> None:
    data = block(0.3, 0.1, 0.2)
    entry = {**data["friction"]["seat"], **change}
    data["friction"] = {"seat": {key: value for key, value in entry.items() if value is not None}}
    with pytest.raises((ModelError, ValueError)) as caught:
        compiled_from(data)
    assert code in str(caught.value)


def test_without_a_static_coefficient_there_is_no_breakaway() -> None:
    data = block(0.3, 0.1, None)
    data["measures"] = {"first": {"max": "motor.breakaway_forward"}}
    with pytest.raises(ModelError) as caught:
        lw.run(parse_document(data))
    assert "signal.no-attribute" in str(caught.value)
