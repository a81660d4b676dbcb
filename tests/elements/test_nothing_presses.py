"""Friction where nothing presses, and where rates decide: no force makes no friction, at standstill tables answer for
speeds of zero, and no coefficient is too large for a belt."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.examples import UNITS, four_bar, slider_crank
from linkwright.model.document import Document
from linkwright.results.run import Run

BREAKAWAY = ["motor.breakaway_forward", "motor.breakaway_backward"]


def rubbing(data: dict[str, Any], **more: Any) -> dict[str, Any]:
    """A mechanism with friction in a pin and, where it has one, in a slide."""
    friction = {"at_b": {"pin": "B", "radius": 0.01, "coefficient": 0.1, **more}}
    for name, joint in data.get("joints", {}).items():
        if "prismatic" in joint:
            friction["seat"] = {"slide": name, "length": 0.3, "coefficient": 0.1, **more}
    return {**data, "friction": friction}


def heavy(data: dict[str, Any]) -> dict[str, Any]:
    """The same with masses, without gravity."""
    links = {
        name: {**link, **({"mass": 2, "com": [0.2, 0.1], "inertia": 0.3} if name != "frame" else {})}
        for name, link in data["links"].items()
    }
    return {**data, "links": links}


@pytest.mark.parametrize("make", [four_bar, slider_crank])
@pytest.mark.parametrize("static", [{}, {"static": 0.2}])
def test_where_no_force_acts_there_is_no_friction(make: Any, static: dict[str, float]) -> None:
    data = rubbing(make(), **static)
    data["measures"] = {"torque": {"max": "motor.torque"}}
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": 12}}
    job = lw.run(Document.model_validate(data))
    assert job.exit_code == 0 and not job.found
    run: Run = job.outcomes["cycle"].result.run
    names = ["motor.torque", *(f"{name}.power" for name in data["friction"]), *(BREAKAWAY if static else [])]
    assert not run.evaluate(names, run.t).any()


@pytest.mark.parametrize("make", [four_bar, slider_crank])
def test_nothing_but_inertia_does_not_jam_at_standstill(make: Any) -> None:
    """Without gravity and loads nothing presses at rest: any effort starts the motion."""
    data = rubbing(heavy(make()), static=0.3)
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": 12}}
    job = lw.run(Document.model_validate(data))
    assert job.exit_code == 0
    assert not {"friction.cannot-start", "friction.rests"} & {finding.code for finding in job.found}
    run: Run = job.outcomes["cycle"].result.run
    assert not run.evaluate(BREAKAWAY, run.t).any()
    assert run.evaluate(["at_b.moment"], run.t).any()


def stribeck(coefficient: Any) -> dict[str, Any]:
    """A four-bar whose pin B has static friction, and pin D a coefficient that may follow the speed."""
    data = heavy(four_bar(gravity=[0, -9.81]))
    data["friction"] = {
        "b": {"pin": "B", "radius": 0.02, "coefficient": 0.1, "static": 0.15},
        "d": {"pin": "D", "radius": 0.03, "coefficient": coefficient},
    }
    data["loads"] = {"fan": {"on": "rocker", "torque": -3 if coefficient == 0.15 else "-drag(d.omega)"}}
    if coefficient != 0.15:
        points = [["0 rad/s", 0.15], ["0.2 rad/s", 0.08], ["9 rad/s", 0.1]]
        drag = [["-9 rad/s", "20 N*m"], ["0 rad/s", "3 N*m"], ["9 rad/s", "20 N*m"]]
        data["tables"] = {
            "stribeck": {"points": points, "between": "linear"},
            "drag": {"points": drag, "between": "linear"},
        }
    return data


def test_at_standstill_tables_answer_for_speeds_of_zero() -> None:
    """The efforts that start the motion are those with the coefficient and the load of the tables at rest."""
    t = np.linspace(0.1, 6.0, 9)
    following, constant = (Run(compiled_from(stribeck(c)), 0.0, 6.2, 40) for c in ("stribeck(abs(d.omega))", 0.15))
    assert following.evaluate(BREAKAWAY, t) == pytest.approx(constant.evaluate(BREAKAWAY, t), rel=1e-12)
    moving = following.evaluate(["motor.torque"], t), constant.evaluate(["motor.torque"], t)
    assert np.abs(np.subtract(*moving)).max() > 0.1
    data = stribeck("stribeck(abs(d.omega))")
    job = lw.run(Document.model_validate({**data, "studies": {"cycle": {"turns": "1 motor", "samples": 24}}}))
    certificate = job.outcomes["cycle"].result.certificate
    assert certificate is not None and certificate.starting is not None and certificate.starting < 1e-9


def test_a_table_that_does_not_reach_to_standstill_is_named() -> None:
    """In motion the pin B never rests, so that only the start from standstill asks the table beyond its end; the pin D
    rests where the rocker turns back, where friction has no value."""
    beyond = stribeck("stribeck(abs(d.omega))")
    beyond["tables"]["stribeck"]["points"][0][0] = "0.01 rad/s"
    studies = {"studies": {"cycle": {"turns": "1 motor", "samples": 24}}}
    job = lw.run(Document.model_validate({**beyond, **studies}))
    assert [finding.code for finding in job.found if finding.severity == "error"] == ["load.outside-table"]
    at_rest = stribeck("stribeck(abs(d.omega))")
    at_rest["friction"]["d"]["pin"] = "A"
    at_rest["loads"] = {}
    at_rest["tables"] = {"stribeck": beyond["tables"]["stribeck"]}
    job = lw.run(Document.model_validate({**at_rest, **studies}))
    assert job.exit_code == 0
    assert [f.code for f in job.found if f.severity == "warning"] == ["load.table-at-rest"]


@pytest.mark.parametrize("coefficient", [1e-9, 0.3, 40.0, 1e6, 1e12])
@pytest.mark.parametrize("crossed", [False, True])
def test_no_coefficient_is_too_large_for_a_belt(coefficient: float, crossed: bool) -> None:
    """The reserve against slip is 2 F0 tanh(mu phi/2) - |T|, at most what the strands carry together."""
    data = {
        "linkwright": 1,
        "units": dict(UNITS),
        "links": {
            "frame": {"points": {"A": [0, 0], "D": [1, 0]}},
            "crank": {"points": {"A": [0, 0], "B": [0.4, 0]}, "mass": 1, "shape": "rod A-B"},
            "wheel": {"points": {"D": [0, 0], "X": [0.1, 0]}, "mass": 1, "shape": "rod D-X"},
        },
        "joints": {
            "x": {"belt": ["crank", "wheel"], "centres": ["A", "D"], "radii": [0.2, 0.1], "crossed": crossed,
                  "pretension": 5, "friction": coefficient}
        },
        "drives": {"motor": {"turns": "crank", "on": "frame", "position": "sin(t*(1 rad/s))"}},
    }  # fmt: skip
    run = Run(compiled_from(data), 0.0, 1.0, 12)
    reserve, tangential = run.evaluate(["x.reserve", "x.tangential"], run.t)
    lean = np.arcsin(0.3 if crossed else 0.1)
    wrap = np.pi + 2 * lean if crossed else np.pi - 2 * lean
    with np.errstate(over="ignore"):
        expected = 10 * np.tanh(coefficient * wrap / 2) - np.abs(tangential)
    assert reserve == pytest.approx(expected, rel=1e-9, abs=1e-12)


def test_tolerances_of_a_drive_that_dwells_warn_of_nothing() -> None:
    """The limits of the torque from both sides of a rest, where friction changes its sense, in every sample; pytest
    makes errors of NumPy's warnings."""
    data = {
        "linkwright": 1,
        "units": dict(UNITS),
        "gravity": [0, -9.81],
        "parameters": {"l": {"value": 0.1, "tolerance": 0.00005}},
        "links": {
            "frame": {"points": {"A": [0, 0]}},
            "arm": {"points": {"A": [0, 0], "B": ["l", 0]}, "mass": 2, "shape": "point B"},
        },
        "friction": {"bearing": {"pin": "A", "radius": 0.005, "coefficient": 0.1}},
        "laws": {
            "swing": {
                "over": "time",
                "of": "angle",
                "segments": [
                    {"rise": 0.5, "over": 0.3, "law": "cycloidal"},
                    {"dwell": 0.2},
                    {"fall": 0.5, "over": 0.4, "law": "poly_345"},
                    {"dwell": 0.1},
                ],
            }
        },
        "drives": {"motor": {"turns": "arm", "on": "frame", "position": "0.17 + swing(t)"}},
        "measures": {"torque": {"max": "motor.torque"}, "least": {"min": "abs(motor.torque)"}},
        "studies": {"cycle": {"duration": 1, "samples": 20}, "accuracy": {"samples": 16}},
    }
    job = lw.run(Document.model_validate(data))
    assert job.exit_code == 0
