"""Forces in the cam study: against those of the mechanism and the direct calls, lift-off with its mend, bad input."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from helpers.heat_seal import findings, heat_seal, performed
from helpers.shown import told
from linkwright.cam.form_closure import groove
from linkwright.cam.hertz import Material, pressure
from linkwright.cam.loads import FollowerLoads, forces
from linkwright.cam.springs import highest_speed, least_preload
from linkwright.presentation.blocks import Charts
from linkwright.results import Run
from linkwright.studies.cam.outcome import CamOutcome
from linkwright.studies.cam.report import report

INERTIA, RATE, RPM = 1.2e-3, 2.0, math.pi / 30
GIVEN: dict[str, Any] = {"inertia": "0.0012 kg*m^2", "spring": {"rate": "2 N*m/rad", "preload": "0.6 N*m"}}
FAST = GIVEN | {"speed": "300 rpm", "contact": "5 N"}


def study(forces: dict[str, Any], cam: dict[str, Any] | None = None, **options: Any) -> CamOutcome:
    outcome = performed(heat_seal(cam, forces=forces, **options)).cam
    assert outcome is not None
    return outcome


def figures(outcome: CamOutcome) -> dict[str, float]:
    return {figure.name: figure.value for figure in outcome.figures}


def test_the_mechanism_has_the_same_forces() -> None:
    """The solver's multipliers, with the arm's mass and a torsional spring in the model."""
    outcome = study(GIVEN | {"speed": "60 rpm"})
    (start,) = outcome.compiled.evaluate(["arm.angle"], np.zeros(1))
    data = heat_seal()
    data["links"]["arm"] |= {"mass": "0.5 kg", "com": [0, 0], "inertia": f"{INERTIA} kg*m^2"}
    free = f"{float(start[0]) + 0.6 / RATE!r} rad"  # the arm rises clockwise
    data["springs"] = {"closing": {"turns": "arm", "on": "frame", "stiffness": f"{RATE} N*m/rad", "free": free}}
    compiled = performed(data).cam.compiled  # type: ignore[union-attr]
    run = Run(compiled, 0.0, 1.0, 720)
    force, torque = compiled.evaluate(["heat_seal.force", "shaft.torque"], run.t)
    assert outcome.pressed is not None
    told = replace(outcome.pressed.forces, theta=2 * np.pi * run.t[:-1])
    assert np.abs(told.contact - force[:-1]).max() < 1e-9 * force.max()
    assert np.abs(told.torque + torque[:-1]).max() < 1e-9 * torque.max()  # the motor turns clockwise
    found = figures(outcome)
    low, high, most = (found[name] for name in ("contact_force_min", "contact_force_max", "shaft_torque_max"))
    assert -1e-9 < force.min() - low < 1e-4 and -1e-9 < high - force.max() < 1e-4
    assert -1e-9 < most - np.abs(torque).max() < 1e-4


def test_a_spring_is_sized_and_does() -> None:
    sized = study(
        FAST | {"spring": {"rate": "2 N*m/rad"}, "width": 10, "cam_material": {"modulus": "70 GPa", "poisson": 0.33}}
    )
    found, disc, omega = figures(sized), sized.disc, 300 * RPM
    preload = least_preload(disc, FollowerLoads(INERTIA, RATE), (0.0, omega), 5.0).value
    loads = FollowerLoads(INERTIA, RATE, preload)
    wanted = forces(disc, loads, omega)
    highest = highest_speed(disc, loads, 5.0)
    assert highest is not None and sized.done
    assert found["spring_preload_min"] == pytest.approx(preload, rel=1e-12)
    assert found["contact_force_min"] == pytest.approx(5.0, rel=1e-7)
    assert found["contact_force_max"] == pytest.approx(wanted.contact_range[1].value)
    assert found["lift_off_speed"] == pytest.approx(highest.value) == pytest.approx(omega)
    hertz = pressure(wanted, 10e-3, Material(70e9, 0.33)).highest.value
    assert found["hertz_pressure_max"] == pytest.approx(hertz)
    (section,) = report(sized).sections
    (pictures,) = [block for block in section.blocks if isinstance(block, Charts)]
    assert "were sized" in told(section) and len(pictures.charts) == 11
    by_rate = figures(study(FAST | {"spring": {"preload": "1.1 N*m"}}))
    assert by_rate["contact_force_min"] == pytest.approx(5.0, rel=1e-7) and by_rate["spring_rate_min"] > 0


def test_lift_off_is_told_with_what_mends_it() -> None:
    (finding,) = study(FAST).failures
    assert finding.code == "cam.spring"
    preload, rate = finding.data["preload"], finding.mend.split("rate of ")[1].rstrip(".")
    for spring in ({"rate": "2 N*m/rad", "preload": preload}, {"rate": rate, "preload": "0.6 N*m"}):
        assert study(FAST | {"spring": spring}).done
    (finding,) = study(FAST | {"spring": {"preload": "0.1 N*m"}}).failures  # on the base circle a rate does nothing
    assert finding.code == "cam.spring" and "no rate is sufficient" in finding.mend


def test_a_follower_without_mass_stays_on_at_any_speed() -> None:
    found = figures(study({"inertia": 0, "speed": "60 rpm", "spring": {"preload": "0.1 N*m"}}))
    assert math.isinf(found["lift_off_speed"]) and found["contact_force_min"] > 0
    assert math.isinf(figures(study({"inertia": 0, "speed": "60 rpm"}))["lift_off_speed"])


def test_limits_and_requirements() -> None:
    limits = {"hertz": "20 MPa", "torque": "0.1 N*m"}
    asked = GIVEN | {"width": 10, "limits": limits}
    outcome = study(asked, require={"lift_off_speed": ">= 400 rpm", "contact_force_min": ">= 1 N"})
    assert [finding.code for finding in outcome.failures] == ["cam.hertz", "cam.torque", "cam.required"]
    width = str(outcome.failures[0].data["width"])
    left = study(asked | {"width": width})
    assert [finding.code for finding in left.failures] == ["cam.torque"]


def test_a_groove_bears_on_both_flanks() -> None:
    outcome = study({"inertia": "0.0012 kg*m^2", "speed": "300 rpm", "width": 10}, {"closed": "groove"})
    wanted = forces(outcome.disc, FollowerLoads(INERTIA), 300 * RPM, second=groove(outcome.disc).second)
    assert outcome.done and outcome.pressed is not None
    found = figures(outcome)
    assert found["contact_force_min"] == pytest.approx(-wanted.contact_second.max(), rel=1e-3)
    assert np.degrees(outcome.pressed.forces.reversals) == pytest.approx([45, 307.5])
    highest = max(pressure(wanted, 10e-3, second=side).highest.value for side in (False, True))
    assert found["hertz_pressure_max"] == pytest.approx(highest)
    assert not {"lift_off_speed", "spring_preload_min", "spring_rate_min"} & found.keys()
    (section,) = report(outcome).sections
    assert "45 deg, 307.5 deg" in told(section)


def test_what_is_wrong_is_said_at_once() -> None:
    forces = {
        "inertia": "2 kg", "speeds": ["300 rpm", "100 rpm"], "spring": {"rate": "3 N/mm", "preload": "-1 N*m"},
        "contact": "1 MPa", "limits": {"hertz": "800 MPa"}, "cam_material": {"modulus": "0 GPa", "poisson": 0.6},
    }  # fmt: skip
    wrong = findings(heat_seal(forces=forces, require={"hertz_pressure_max": "<= 1 MPa", "lift_off_speed": ">= 1 mm"}))
    assert {".".join(map(str, one.path[2:])): one.code for one in wrong} == {
        "forces.inertia": "expression.units-conflict",
        "forces.speeds": "value.not-rising",
        "forces.spring.rate": "expression.units-conflict",
        "forces.spring.preload": "cam.not-positive",
        "forces.contact": "expression.units-conflict",
        "forces.cam_material.modulus": "cam.not-positive",
        "forces.cam_material.poisson": "cam.poisson",
        "forces": "cam.together",
        "require.hertz_pressure_max": "cam.no-figure",
        "require.lift_off_speed": "expression.units-conflict",
    }


def test_no_speed_no_roller_no_forces() -> None:
    still = heat_seal({"closed": "conjugate"}, forces={"inertia": "1 kg*m^2", "width": 5})
    still["drives"]["shaft"] = {"turns": "cam", "on": "frame", "position": "1 rad/s*t"}
    del still["cams"]["heat_seal"]["roller"], still["cams"]["heat_seal"]["at"]
    still["cams"]["heat_seal"]["knife"] = "B"
    assert [one.code for one in findings(still)] == ["cam.no-speed", "cam.knife"]
