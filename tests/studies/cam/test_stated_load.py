"""Loads over the cam's turn as a file states them: closed forms, the mechanism under the same load, bad input."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.cams import pair
from helpers.compiled import compiled_from
from helpers.heat_seal import findings, heat_seal
from linkwright.app.job import examine_document
from linkwright.cam.cams_of_mechanism import disc
from linkwright.cam.loads import CamForces, forces
from linkwright.model.document import parse_document
from linkwright.results import Run
from linkwright.studies.cam.stated_dimensions import DimensionReader

INERTIA = 1.2e-3
SPRING = {"rate": "2 N*m/rad", "preload": "0.6 N*m"}
SWING = math.radians(12)
PRESS = {"points": [["0 deg", "0 N*m"], ["90 deg", "9 N*m"], ["91 deg", "0 N*m"], ["360 deg", "0 N*m"]]}


def loaded(load: Any, spring: dict[str, Any] | None = None, **sections: Any) -> dict[str, Any]:
    section = {"inertia": f"{INERTIA} kg*m^2", "spring": spring or SPRING, "load": load}
    return heat_seal(forces=section) | sections


def pressed(data: dict[str, Any], folder: Path | None = None) -> CamForces:
    """The follower under the load that the study reads."""
    document = parse_document(data)
    assert document is not None
    examined = examine_document(document, folder)
    assert examined.compiled is not None and not examined.findings, examined.findings
    (name,) = examined.compiled.mechanism.cams
    made = disc(examined.compiled, name)
    asked = DimensionReader(examined.compiled, examined.tasks[0].options, name, made).read().forces
    assert asked is not None
    return forces(made, asked.loads, asked.omega)


def values(done: CamForces, *theta: float) -> Any:
    """Of the load."""
    assert callable(done.loads.load)
    return done.loads.load(done.disc.look(np.array(theta))).d[0]


def codes(data: dict[str, Any]) -> list[tuple[str, str]]:
    return [(finding.code, ".".join(map(str, finding.path))) for finding in findings(data)]


def test_a_load_over_the_lift_is_a_spring() -> None:
    """5 N m and 2 N m/rad: what the section's own spring gives."""
    by_load = pressed(
        loaded("5 N*m + 2 N*m/rad*lift + 0*angle/(1 rad)*1 N*m", {"rate": "0 N*m/rad", "preload": "0 N*m"})
    )
    by_spring = pressed(loaded(0, {"rate": "2 N*m/rad", "preload": "5 N*m"}))
    for name in ("contact", "torque", "theta"):
        assert getattr(by_load, name) == pytest.approx(getattr(by_spring, name), rel=1e-13)
    for one, other in zip(by_load.contact_range, by_spring.contact_range, strict=True):
        assert (one.value, one.theta) == pytest.approx((other.value, other.theta))


def test_a_load_on_a_sliding_follower_is_a_force() -> None:
    data = pair("sliding", "roller")
    spring = {"rate": "2 N/mm", "preload": "5 N"}
    found = []
    for section in ({"load": "5 N + 2 N/mm*lift"}, {"spring": spring}):
        data["studies"] = {"cam": {"forces": {"inertia": "1.1 kg", **section}}}
        found.append(pressed(data).contact)
    assert found[0] == pytest.approx(found[1], rel=1e-13)


@pytest.mark.parametrize("between", ["linear", "quintic"])
def test_the_work_of_a_load_over_the_angle(between: str) -> None:
    """Against a load k theta a cycloidal rise h over b does k h b / 2; corners of tables are joins."""
    points = PRESS["points"] if between == "linear" else [[f"{a} deg", f"{a / 10} N*m"] for a in range(0, 361, 40)]
    done = pressed(loaded("press(angle)", tables={"press": {"points": points, "between": between}}))
    if between == "linear":
        assert done.work == pytest.approx(9 * SWING / 2, rel=1e-12)
        assert np.degrees(done.loads.joins) == pytest.approx([91])  # 90 deg is one of the law's own
    else:  # the fall over 75 deg from 270 deg on, symmetrical about 307.5 deg
        assert done.work == pytest.approx((4.5 - 30.75) * SWING, rel=1e-12)
        assert not done.loads.joins


def test_the_mechanism_has_the_same_forces() -> None:
    """The same load as a torque on the arm, which rises clockwise, the cam turning so too."""
    points = [["0 deg", "1 N*m"], ["70 deg", "4 N*m"], ["200 deg", "2 N*m"], ["300 deg", "3 N*m"]]
    table = {"points": points, "period": "360 deg"}
    load = "press({angle}) + max(0 N*m, 3 N*m*sin({angle} - 20 deg)) + (0.5 N*m/rad + gain({lift}))*{lift}"
    gain = {"points": [["0 deg", "0 N*m/rad"], ["5 deg", "8 N*m/rad"], ["12 deg", "0 N*m/rad"]], "between": "linear"}
    tables = {"press": {**table, "between": "cubic"}, "gain": gain}
    done = pressed(loaded(load.format(angle="angle", lift="lift"), tables=tables))
    (start,) = compiled_from(heat_seal()).evaluate(["arm.angle"], np.zeros(1))
    data = heat_seal() | {"tables": tables}
    data["links"]["arm"] |= {"mass": "0.5 kg", "com": [0, 0], "inertia": f"{INERTIA} kg*m^2"}
    free = f"{float(start[0]) + 0.3!r} rad"
    data["springs"] = {"closing": {"turns": "arm", "on": "frame", "stiffness": "2 N*m/rad", "free": free}}
    torque = load.format(angle="(-shaft.angle)", lift=f"({float(start[0])!r} rad - arm.angle)")
    data["loads"] = {"process": {"on": "arm", "torque": torque}}
    compiled = compiled_from(data)
    run = Run(compiled, 0.0, 1.0, 720)
    t = run.t[(run.t > 0.001) & (run.t < 0.999)]
    force, shaft = compiled.evaluate(["heat_seal.force", "shaft.torque"], t)
    told = replace(done, theta=2 * np.pi * t)
    assert np.abs(told.contact - force).max() < 1e-9 * force.max()
    assert np.abs(told.torque + shaft).max() < 1e-9 * np.abs(shaft).max()


def test_laws_parameters_and_bare_numbers() -> None:
    """What a load alone uses takes its units from there: a column and a parameter without units count degrees."""
    bare = [[0, 0], [90, 9], [91, 0], [360, 0]]
    sections = {"parameters": {"late": 10, "again": "late/2 + late/2"}, "tables": {"press": {"points": bare}}}
    sections["tables"]["press"]["between"] = "linear"
    data = loaded("press(angle - 0*late) + 1 N*m*sin(angle - again) + 0.5 N*m/rad*swing(angle)", **sections)
    data["units"] |= {"torque": "N*m"}
    done = pressed(data)
    theta = np.array([0.3, 2.0, 5.0])
    lift = done.disc.look(theta).lift.d[0]
    press = np.interp(np.degrees(theta), *np.array(bare).T)
    assert values(done, *theta) == pytest.approx(press + np.sin(theta - math.radians(10)) + 0.5 * lift, rel=1e-12)


def test_a_table_from_a_file(tmp_path: Path) -> None:
    (tmp_path / "press.csv").write_text("phi,m\n0,1\n180,2\n360,1\n", encoding="utf-8")
    table = {"file": "press.csv", "x": "phi deg", "y": "m N*m", "between": "linear"}
    data = loaded("press(angle)", tables={"press": table})
    assert values(pressed(data, tmp_path), math.pi / 2) == pytest.approx([1.5])
    document = parse_document(data)
    assert document is not None
    assert [finding.code for finding in examine_document(document, tmp_path / "none").findings] == ["table.unreadable"]


AT = "studies.cam.forces.load"


@pytest.mark.parametrize(
    ("load", "found"),
    [
        ("5 N", [("expression.units-conflict", AT)]),
        ("2 N/mm*lift", [("expression.units-conflict", AT)]),
        ("press(lift*1 mm)", [("expression.units-conflict", AT)]),
        ("press(angel) + pres(angle)", [("name.unknown-parameter", AT), ("expression.unknown-function", AT)]),
        ("1 N*m*sin(arm.angle)", [("cam.load-signal", AT)]),
        ("1 N*m*t/(1 s)", [("cam.load-signal", AT)]),
        ("press(angle + 1 deg)", [("cam.load-outside", AT)]),
        ("press(press(angle)*1 rad/(1 N*m))", [("cam.load-outside", AT)]),
        ("1 N*m/(1 - sign)", [("value.not-finite", AT)]),
        ("1 N*m*deg/(angle - 90 deg)", [("cam.load-not-finite", AT)]),
        ("1 N*m*sqrt(cos(angle))", [("cam.load-not-finite", AT)]),
        ("1 N*m*tan(angle)", [("cam.load-not-finite", AT)]),
        ("1 N*m*deg/(angle - 100.1 deg)", [("cam.load-not-finite", AT)]),
        ("1 N*m*sin(5000*angle)", []),
        ("1e60 N*m*angle/(1 deg)", [("cam.load-not-finite", AT)]),
        ("short(angle)", [("table.short", "tables.short")]),
        ("1 N*m*sin(turn*angle)", []),
        ("1 N*m*sin(lift)", []),
        ("press(90 deg)", []),
        ("1 N*m*sqrt(1 + lift/(1 rad))", []),
        ("wide + 1 N*m*angle/(1 rad)", []),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told(load: str, found: list[tuple[str, str]]) -> None:
    tables = {"press": PRESS | {"between": "linear"}, "short": {"points": [["0 deg", "1 N*m"]]}}
    data = loaded(load, tables=tables, parameters={"sign": 1, "turn": 3, "wide": "2 N*m"})
    assert codes(data) == found


def test_a_name_that_means_two_things() -> None:
    data = loaded("1 N*m*sin(lift + angle)", parameters={"lift": "12 deg"})
    assert codes(data) == [("cam.load-name", AT)]
    (finding,) = findings(data)
    assert "'lift'" in finding.what and finding.mend
