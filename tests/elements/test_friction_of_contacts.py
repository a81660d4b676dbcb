"""Friction where links slide past each other: cams with flat faces, edges and rollers, pins in slots."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

from helpers.compiled import compiled_from
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.model.document import parse_document
from linkwright.results import Run, certify
from linkwright.results.independent_check import Reports
from studies.models import measured

EXAMPLES = Path(__file__).parents[2] / "examples"
LIFT, BASE, FORCE, OMEGA, MU = 0.010, 0.030, 200.0, 2 * np.pi, 0.15
T = np.linspace(0.013, 0.97, 41)


def lifter(mu: float = MU, **contact: Any) -> dict[str, Any]:
    """A plate cam under a sliding follower, without mass: lift 10 mm (1 - cos)/2, 200 N down, one turn in 1 s."""
    return {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "rad", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {
            "frame": {"points": {"O": [0, 0], "G": [0, 0]}},
            "disc": {"points": {"O": [0, 0]}},
            "tappet": {"points": {"F": [0, 0]}},
        },
        "joints": {"guide": {"prismatic": ["frame", "tappet"], "line": ["G at 90 deg", "F at 90 deg"]}},
        "laws": {
            "lift": {
                "over": "angle",
                "of": "length",
                "segments": [
                    {"rise": 10, "over": "180 deg", "law": "simple_harmonic"},
                    {"fall": 10, "over": "180 deg", "law": "simple_harmonic"},
                ],
            }
        },
        "cams": {"valve": {"cam": "disc", "follower": "tappet", "on": "frame", "base": 30, "law": "lift", **contact}},
        "drives": {"motor": {"turns": "disc", "on": "frame", "speed": "60 rpm", "start": 0}},
        "loads": {"weight": {"on": "tappet", "at": "F", "force": [0, -FORCE]}},
        "friction": {"rub": {"contact": "valve", "coefficient": mu}},
    }


def lift(t: Any) -> tuple[Any, Any]:
    """The lift (m) and its derivative by the angle (m)."""
    return LIFT * (1 - np.cos(OMEGA * t)) / 2, LIFT * np.sin(OMEGA * t) / 2


def test_a_flat_face() -> None:
    """The face passes the load alone, N = F; the torque is F s' + mu F h, h the height of the face over the shaft (the
    cam's material moves along the face at omega h)."""
    compiled = compiled_from(lifter(face="F at 0 deg"))
    height, slope = lift(T)
    force, torque, v, rub = compiled.evaluate(["valve.force", "motor.torque", "rub.v", "rub.force"], T)
    assert force == pytest.approx(FORCE, rel=1e-12)
    assert np.abs(v) == pytest.approx(OMEGA * (BASE + height), rel=1e-12)
    assert torque == pytest.approx(FORCE * slope + MU * FORCE * (BASE + height), rel=1e-10)
    assert np.abs(rub) == pytest.approx(MU * FORCE, rel=1e-12)


def test_an_edge() -> None:
    """At a pressure angle a the normal force N has N cos a = F + mu N sin a (signed): wedge with angle of friction."""
    compiled = compiled_from(lifter(knife="F"))
    height, slope = lift(T)
    angle = np.arctan2(slope, BASE + height)
    force, torque = compiled.evaluate(["valve.force", "motor.torque"], T)
    normal = FORCE / (np.cos(angle) - MU * np.sin(angle))
    assert force == pytest.approx(normal, rel=1e-9)
    # The torque is that of both forces at the distance of the edge from the shaft.
    assert torque == pytest.approx((BASE + height) * normal * (np.sin(angle) + MU * np.cos(angle)), rel=1e-9)


@pytest.mark.parametrize("mu", [0.1, 0.4])
def test_a_roller_rubs_at_its_pin(mu: float) -> None:
    """The power lost is the moment mu r |R| of the pin, with the whole force R, times the roller's speed on it."""
    data = lifter(mu, at="F", roller=12)
    data["friction"]["rub"]["radius"] = 5
    compiled = compiled_from(data)
    names = ["valve.force", "rub.force", "rub.v", "rub.power", "motor.power", "guide.v"]
    normal, along, v, power, given, rising = compiled.evaluate(names, T)
    assert power == pytest.approx(-mu * 0.005 * np.hypot(normal, along) * np.abs(v) / 0.012, rel=1e-11)
    assert given == pytest.approx(FORCE * rising - power, rel=1e-9)
    # The roller's centre and the follower's guide: N and T carry the load together.
    height, slope = lift(T)
    pitch = np.sqrt((BASE + 0.012) ** 2) + height
    angle = np.arctan2(slope, pitch)
    assert normal * np.cos(angle) - np.abs(along) * np.sin(angle) == pytest.approx(FORCE, rel=1e-9)


@pytest.mark.parametrize(
    ("name", "contact", "more"),
    [("slotted_lever", "slot", {}), ("curved_slot", "slot", {}), ("cam_linkage", "pushing", {"radius": 5})],
)
def test_the_certificate_holds_in_examples(name: str, contact: str, more: dict[str, Any]) -> None:
    """Equilibrium, power and the law of friction once more, from reported numbers; a planted fault is seen."""
    data = YAML(typ="safe").load((EXAMPLES / f"{name}.yaml").read_text("utf-8"))
    data["friction"] = {"rub": {"contact": contact, "coefficient": 0.1, "viscous": "3 N*s/m", **more}}
    data |= {"measures": {}, "require": {}, "exports": {}}
    compiled = compile_mechanism(parse_document(data))
    run = Run(compiled, 0.0, 0.5, 60)
    found = certify(run)
    assert found.sound()
    assert max(found.equilibrium or 0.0, found.power or 0.0, found.work or 0.0) < 1e-9
    assert (compiled.evaluate(["rub.power"], run.t) <= 0).all()
    reports = Reports(compiled, run.t)
    one = next(one for one in reports.every if one.name == "rub")
    (misfit,) = one.kind.misfits(reports, "rub", one.entry)
    size = np.abs(reports.rows["rub.force"]).max()
    assert np.abs(misfit.value).max() < 1e-9 * size
    reports.rows["rub.force"] = reports.rows["rub.force"] * 1.001
    (misfit,) = one.kind.misfits(reports, "rub", one.entry)
    assert np.abs(misfit.value).max() > 1e-4 * size


def test_efficiency_of_a_cam() -> None:
    """Over the rise: the useful work is that of the load, what is lost mu F h over the angle."""
    data = lifter(face="F at 0 deg") | {"windows": {"rise": ["0 s", "0.5 s"]}}
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": 60}}
    found = measured(data, eta={"efficiency": ["weight"], "window": "rise"})["eta"].shown()
    lost = MU * np.pi * (BASE + LIFT / 2)
    assert found == pytest.approx(LIFT / (LIFT + lost), rel=1e-9)


@pytest.mark.parametrize(
    ("code", "entry", "contact"),
    [
        ("name.unknown", {"contact": "guide", "coefficient": 0.1}, {"knife": "F"}),
        ("friction.place", {"contact": "valve", "slide": "guide", "coefficient": 0.1}, {"knife": "F"}),
        ("friction.stray", {"contact": "valve", "length": 3, "coefficient": 0.1}, {"knife": "F"}),
        ("friction.no-roller", {"contact": "valve", "radius": 3, "coefficient": 0.1}, {"knife": "F"}),
        ("friction.roller", {"contact": "valve", "coefficient": 0.1}, {"at": "F", "roller": 12}),
    ],
)
def test_refused_by_name(code: str, entry: dict[str, Any], contact: dict[str, Any]) -> None:
    data = lifter(**contact) | {"friction": {"rub": entry}}
    with pytest.raises(ModelError) as caught:
        compile_mechanism(parse_document(data))
    assert code in [finding.code for finding in caught.value.findings]
