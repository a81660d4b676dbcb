"""Differentials: motion and torques against the full Newton-Euler system and against a planetary train of gears with a
massless planet; on a moving link; what is refused."""

from __future__ import annotations

import copy
import math
from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from helpers.examples import UNITS
from helpers.newton_euler import Array, Gap, Oracle
from helpers.plain import Law, Plain, PlainDrive, PlainLink
from linkwright.compilation import examine
from linkwright.model.document import Document
from linkwright.results.certificate import certify
from linkwright.results.run import Run

T = np.linspace(0.0, 1.0, 11)
G = (0.0, -9.81)
PIVOTS = {"A": (0.0, 0.0), "B": (1.0, 0.2), "C": (2.0, -0.1), "D": (3.0, 0.4)}
WEIGHTS = {"first": 2.0, "second": -1.0, "third": 0.75, "fourth": -1.5}


def body(point: str, seed: int) -> PlainLink:
    random = np.random.default_rng(seed)
    com = (float(random.normal(scale=0.2)), float(random.normal(scale=0.2)))
    return PlainLink({point: (0.0, 0.0)}, float(random.uniform(0.5, 3)), com, float(random.uniform(0.05, 0.4)))


def shafts(drives: dict[str, PlainDrive]) -> Plain:
    """Four eccentric shafts on the frame; the last follows the three others, which are driven."""
    links = {"frame": PlainLink(dict(PIVOTS))}
    links |= {name: body(point, k) for k, (name, point) in enumerate(zip(WEIGHTS, PIVOTS, strict=True))}
    pins = {point: (("frame", point), (name, point)) for name, point in zip(WEIGHTS, PIVOTS, strict=True)}
    start = {"frame": (0.0, 0.0, 0.0)} | {n: (*PIVOTS[p], 0.0) for n, p in zip(WEIGHTS, PIVOTS, strict=True)}
    return Plain(links, pins, {}, drives, start, gravity=G)


LAWS = {"first": Law(0.3, amp=2.0, w=3.0), "second": Law(-0.2, q1=5.0), "third": Law(0.1, amp=-0.7, w=4.0)}
MOTORS = {f"m{name}": PlainDrive("turns", name, "frame", law) for name, law in LAWS.items()}


def model(on: str = "frame") -> dict[str, Any]:
    plain = shafts(MOTORS)
    links: dict[str, Any] = {
        name: {"points": {p: list(at) for p, at in link.points.items()}}
        | ({"mass": link.mass, "com": list(link.com), "inertia": link.inertia} if link.mass else {})
        for name, link in plain.links.items()
    }
    drives = {
        name: {
            "turns": d.link,
            "on": d.on,
            "position": f"{d.law.q0} + {d.law.q1}*t/(1 s) + {d.law.amp}*sin({d.law.w}*t/(1 s))",
        }
        for name, d in MOTORS.items()
    }
    joints = {"axle": {"differential": list(WEIGHTS), "weights": list(WEIGHTS.values()), "on": on}}
    return {
        "linkwright": 1,
        "units": dict(UNITS),
        "gravity": list(G),
        "links": links,
        "joints": joints,
        "drives": drives,
    }


def relation(oracle: Oracle, q: Array) -> float:
    """The file draws the last shaft at the angle 0."""
    drawn = sum(WEIGHTS[name] * law(0.0) for name, law in LAWS.items())
    return sum(weight * float(oracle.pose(q, name)[2]) for name, weight in WEIGHTS.items()) - drawn


def test_against_newton_and_euler() -> None:
    gaps: dict[str, Gap] = {"axle": relation}
    oracle = Oracle(shafts(MOTORS), gaps=gaps)
    states = oracle.follow(T)
    forces = [oracle.forces(s) for s in states]
    run = Run(compiled_from(model()), 0.0, 1.0, 60)
    found = run.evaluate(["fourth.omega", "fourth.alpha", *(f"{name}.torque" for name in MOTORS)], T)
    assert found[0] == pytest.approx([oracle.pose(s.v, "fourth")[2] for s in states], rel=1e-9, abs=1e-9)
    # The oracle takes differences of a relation: of these the second ones are good to 1e-8 or so.
    assert found[1] == pytest.approx([oracle.pose(s.a, "fourth")[2] for s in states], rel=1e-7, abs=1e-7)
    expected = np.array([[f.efforts[name] for f in forces] for name in MOTORS])
    assert found[2:] == pytest.approx(expected, rel=1e-7, abs=1e-7)
    # A shaft passes on what the relation is reported to do to it, the other way round.
    moments = run.evaluate([f"force({name}, axle).moment" for name in WEIGHTS], T)
    expected = np.array([[-f.reactions["axle", name][2] for f in forces] for name in WEIGHTS])
    assert moments == pytest.approx(expected, rel=1e-7, abs=1e-7)
    assert run.evaluate(["axle.torque"], T)[0] == pytest.approx(moments[0])
    certificate = certify(run)
    assert certificate.sound(), certificate.residuals
    assert certificate.power is not None and certificate.power < 1e-9
    assert (certificate.mobility, certificate.gruebler) == (3, 3)


def test_it_is_a_planetary_train_seen_from_outside() -> None:
    """Sun, ring and arm of a train with a massless planet move and pass torques as a differential of its teeth."""
    turning = {"mass": 1, "com": [0.01, 0.02], "inertia": 0.02}
    data: dict[str, Any] = {
        "linkwright": 1,
        "units": dict(UNITS),
        "gravity": list(G),
        "links": {
            "frame": {"points": {"O": [0, 0]}},
            "sun": {"points": {"O": [0, 0]}, **turning},
            "ring": {"points": {"O": [0, 0]}, **turning, "com": [-0.03, 0.01]},
            "arm": {"points": {"O": [0, 0], "P": [0.06, 0]}, **turning},
            "planet": {"points": {"P": [0, 0]}},
        },
        "joints": {
            "inside": {"gears": ["sun", "planet"], "centres": ["O", "P"], "carrier": "arm", "radii": [0.04, 0.02]},
            "outside": {
                "gears": ["planet", "ring"],
                "internal": "ring",
                "centres": ["P", "O"],
                "carrier": "arm",
                "radii": [0.02, 0.08],
            },
        },
        "drives": {
            "motor": {"turns": "sun", "on": "frame", "position": "0.2 + 3*sin(4*t/(1 s))"},
            "brake": {"turns": "ring", "on": "frame", "position": "-2*t/(1 s)"},
        },
    }
    data["assembly"] = {"P": [0.06, 0]}
    black = copy.deepcopy(data)
    black["links"].pop("planet")
    black.pop("assembly")
    black["joints"] = {"set": {"differential": ["sun", "ring", "arm"], "weights": [24, 48, -72]}}
    names = ["arm.angle", "arm.alpha", "motor.torque", "brake.torque", "shaking.moment"]
    geared = Run(compiled_from(data), 0.0, 1.0, 60).evaluate(names, T)
    found = Run(compiled_from(black), 0.0, 1.0, 60).evaluate(names, T)
    assert found[0] - found[0][0] == pytest.approx(geared[0] - geared[0][0], abs=1e-12)
    assert found[1:] == pytest.approx(geared[1:], rel=1e-9, abs=1e-9)


def test_weights_without_a_sum_load_the_housing() -> None:
    """On a turning carrier angles count from there, and the carrier takes what the shafts' torques leave."""
    data = model()
    data["links"]["housing"] = {"points": {"A": [0, 0]}, "mass": 1, "com": [0, 0], "inertia": 0.3}
    data["joints"]["axle"]["on"] = "housing"
    data["drives"]["turn"] = {"turns": "housing", "on": "frame", "position": "0.5*sin(2*t/(1 s))"}
    run = Run(compiled_from(data), 0.0, 1.0, 60)
    angles = run.evaluate([*(f"{name}.angle" for name in WEIGHTS), "housing.angle"], T)
    weights = np.array([*WEIGHTS.values()])
    passed = weights @ angles[:-1] - weights.sum() * angles[-1]
    assert passed == pytest.approx(passed[0], abs=1e-12)
    names = [*(f"force({name}, axle).moment" for name in WEIGHTS), "force(housing, axle).moment"]
    moments = run.evaluate([*names, "turn.torque", "housing.alpha"], T)
    share = moments[0] / weights[0]
    assert moments[1:4] == pytest.approx(np.outer(weights[1:], share), rel=1e-10, abs=1e-10)
    assert moments[4] == pytest.approx(-weights.sum() * share, rel=1e-10, abs=1e-10)
    assert moments[5] == pytest.approx(0.3 * moments[6] + moments[4], rel=1e-9, abs=1e-9)
    assert certify(run).sound()


def codes(joint: dict[str, Any]) -> list[str]:
    data = model()
    data["joints"] = {"axle": joint}
    try:
        _, findings = examine(Document.model_validate(data))
    except ValueError as error:
        return [str(error)]
    return [f.code for f in findings if f.severity == "error"]


@pytest.mark.parametrize(
    ("joint", "code"),
    [
        ({"differential": ["first", "second"], "weights": [1, 2]}, "file.expected"),
        ({"differential": ["first", "second", "third"], "weights": [1, 2, 3, 4]}, "differential.count"),
        ({"differential": ["first", "second", "third"], "weights": [1, 0, 3]}, "differential.weight"),
        ({"differential": ["first", "second", "second"], "weights": [1, 1, 3]}, "joint.same-link"),
        ({"differential": ["first", "second", "frame"], "weights": [1, 1, 3]}, "joint.same-link"),
        ({"differential": ["first", "second", "fifth"], "weights": [1, 1, 3]}, "name.unknown"),
        ({"differential": ["first", "second", "third"], "weights": ["1 mm", 1, 3]}, "expression.units-conflict"),
        ({"differential": ["first", "second", "third"], "weights": [1, 1, 3], "on": "cage"}, "name.unknown"),
        ({"differential": ["first", "second", "third"], "weights": [1, 1, 3]}, "structure"),
    ],
)
def test_what_is_refused(joint: dict[str, Any], code: str) -> None:
    found = codes(joint)
    assert any(code in one for one in found), found


def test_the_example_shifts_the_phase() -> None:
    """Ten degrees of the cage are twenty of the crank, and the cage takes twice the torque of each side gear."""
    from pathlib import Path

    import linkwright as lw

    compiled, findings = examine(lw.load(Path(__file__).parents[2] / "examples" / "phase_differential.yaml"))
    assert compiled is not None, findings
    run = Run(compiled, 0.0, 1.5, 100)
    t = np.array([0.1, 0.5, 0.75, 1.0, 1.4])
    crank, main, cage, passed, taken = run.evaluate(
        ["crank.angle", "main.angle", "cage.angle", "shift.torque", "force(cage, shift).moment"], t
    )
    assert crank == pytest.approx(2 * cage - main, abs=1e-12)
    assert cage[[0, -1]] == pytest.approx([0.0, math.radians(10)], abs=1e-12)
    assert taken == pytest.approx(-2 * passed, rel=1e-12)
