"""Welds: against one link that has the points and masses of both, and Newton's laws for the welded part alone."""

from __future__ import annotations

import io
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.model.builder import Builder
from linkwright.model.document import located, read_document
from linkwright.results import Run, certify
from model.test_fuzz import every_one_survives, mutated
from results.test_certificate import lie

FILE = Path(__file__).parents[2] / "examples" / "welded_bracket.yaml"
TEXT = FILE.read_text(encoding="utf-8")
T = np.linspace(0.0, 0.5, 41)
SHARED = [*(f"E.{rate}" for rate in ("x", "y", "vx", "vy", "ax", "ay", "jx", "jy")), "motor.torque", "motor.power"]
PINS = [f"force({a}).{axis}" for a in ("frame, crank", "crank, coupler", "rocker, coupler") for axis in "xy"]
REACH, LEAN, TOOL, BAR = 0.12, np.pi / 3, 2.0, 0.6


def model(**changes: Any) -> dict[str, Any]:
    data: dict[str, Any] = YAML(typ="safe").load(TEXT)
    for key in ("note", "measures", "require", "studies"):
        data.pop(key)
    return {**data, **changes}


def merged() -> dict[str, Any]:
    """The bracket's points and masses put on the coupler by hand: a file without a weld."""
    data = model()
    del data["links"]["bracket"], data["joints"]
    c, s = np.cos(LEAN), np.sin(LEAN)
    end, middle = ([90 + far * c, far * s] for far in (120, 60))
    data["links"]["coupler"]["points"] |= {"E": end}
    inertia = BAR * 120**2 / 12
    data["counterweights"] = {
        "tool": {"on": "coupler", "at": "E", "mass": TOOL},
        "bar": {"on": "coupler", "at": middle, "mass": BAR, "inertia": inertia},
    }
    data["loads"]["cut"]["on"] = "coupler"
    return data


def rows(data: dict[str, Any], names: list[str]) -> np.ndarray:
    return Run(compiled_from(data), 0.0, 0.5, 200).evaluate(names, T)


def test_it_moves_and_loads_the_others_as_one_link_does() -> None:
    found, expected = rows(model(), [*SHARED, *PINS]), rows(merged(), [*SHARED, *PINS])
    scale = np.abs(expected).max(axis=1)
    assert (np.abs(found - expected).max(axis=1) <= 1e-11 * scale).all()


def test_the_section_carries_what_newtons_laws_want() -> None:
    """The bracket alone, cut at W: its accelerations are those of the file without a weld, by raw geometry."""
    g, load = 9.80665, np.array([[0.0], [-40.0]])
    motion = rows(merged(), ["W.x", "W.y", "W.ax", "W.ay", "coupler.angle", "coupler.omega", "coupler.alpha"])
    w, acc, (angle, omega, alpha) = motion[:2], motion[2:4], motion[4:]
    ray = np.array([np.cos(angle + LEAN), np.sin(angle + LEAN)])
    left = np.array([-ray[1], ray[0]])

    def at(far: float) -> np.ndarray:
        return np.asarray(acc + far * (alpha * left - omega**2 * ray))

    weight = np.array([[0.0], [-g]])
    inertial = [(TOOL, REACH), (BAR, REACH / 2)]
    force = sum(m * (at(far) - weight) for m, far in inertial) - load
    moment = sum(m * far * cross(ray, at(far) - weight) for m, far in inertial)
    moment = moment + BAR * REACH**2 / 12 * alpha - REACH * cross(ray, load)
    found = rows(
        model(), ["force(coupler, bracket).x", "force(coupler, bracket).y", "seam.torque", "seam.angle", "W.x"]
    )
    assert np.abs(found[:2] - force).max() < 1e-10 * np.abs(force).max()
    assert np.abs(found[2] - moment).max() < 1e-10 * np.abs(moment).max()
    assert np.abs(found[3] - LEAN).max() == 0.0
    assert np.abs(found[4] - w[0]).max() < 1e-13


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.asarray(a[0] * b[1] - a[1] * b[0])


def test_its_certificate_holds_and_sees_a_wrong_moment(monkeypatch: pytest.MonkeyPatch) -> None:
    run = Run(compiled_from(model()), 0.0, 0.5, 200)
    honest = certify(run)
    assert honest.sound(1e-12)
    assert honest.power is not None
    told = lie(monkeypatch, "seam.torque", lambda y: y * (1 + 1e-6))
    wrong = certify(run).equilibrium
    assert told
    assert wrong is not None
    assert wrong > 1e-9


@pytest.mark.parametrize(
    ("changes", "code"),
    [
        ({"joints": {"seam": {"weld": ["bracket", "crank"], "angle": 0}}}, "joint.weld-pin"),
        ({"joints": {"seam": {"weld": ["bracket", "couple"], "angle": 0}}}, "name.unknown"),
        ({"joints": {"seam": {"weld": ["bracket", "coupler"]}}}, "file.missing"),
        ({"joints": {"seam": {"weld": ["bracket"], "angle": 0}}}, "file.expected"),
        ({"joints": {"seam": {"weld": ["bracket", "coupler"], "angle": "3 mm"}}}, "expression.units-conflict"),
        ({"joints": {"seam": {"type": "weld", "links": ["bracket", "coupler"]}}}, "element.weld"),
        ({"drives": {}}, "joint.weld-drive"),
    ],
)
def test_what_is_refused(changes: dict[str, Any], code: str) -> None:
    stream = io.StringIO()
    YAML().dump(model(**changes), stream)
    document, source = read_document(stream.getvalue().encode())
    found = source.findings if document is None else located(examine(document, FILE.parent)[1], source)
    assert code in [finding.code for finding in found], [finding.code for finding in found]
    assert all(finding.what and finding.mend for finding in found)


def test_the_builder_writes_the_same() -> None:
    built = Builder("b").frame(A=[0, 0]).link("arm", A=[0, 0], W=[50, 0]).link("plate", W=[0, 0], E=[9, 0])
    built.weld("seam", "plate", "arm", "20 deg").drive("motor", turns="arm", speed="1 rpm", start=0)
    joint = built.build().joints["seam"]
    assert joint.links == ("plate", "arm")
    assert joint.model_dump(by_alias=True)["angle"] == "20 deg"


@pytest.mark.parametrize("seed", range(60))
def test_mutated_examples_end_in_findings(seed: int) -> None:
    every_one_survives([mutated(random.Random(seed), TEXT)])


def test_a_rod_cut_in_its_middle_is_the_rod() -> None:
    """A coupler as two welded halves is still a dyad in closed form; the moment there is that of a beam by statics."""
    whole = model()
    del whole["links"]["bracket"], whole["joints"], whole["counterweights"], whole["loads"]
    del whole["links"]["coupler"]["points"]["W"]
    cut = {**whole, "links": {name: dict(link) for name, link in whole["links"].items()}}
    half = {"mass": 0.75, "com": [45, 0], "inertia": 0.75 * 90**2 / 12}
    cut["links"]["coupler"] = {"points": {"B": [0, 0], "W": [90, 0]}, **half}
    cut["links"]["beyond"] = {"points": {"W": [0, 0], "C": [90, 0]}, **half}
    cut["joints"] = {"seam": {"weld": ["beyond", "coupler"], "angle": 0}}
    compiled = compiled_from(cut)
    assert not [step for step in compiled.structure.steps if type(step).__name__ == "HigherGroup"]
    names = ["C.x", "C.ay", "rocker.omega", "motor.torque"]
    found, expected = rows(cut, names), rows(whole, names)
    assert np.abs(found - expected).max() <= 1e-11 * np.abs(expected).max()
    motion = rows(whole, ["B.ax", "B.ay", "coupler.angle", "coupler.omega", "coupler.alpha"])
    (ax, ay, angle, omega, alpha), pin = motion, rows(whole, [f"force(rocker, coupler).{axis}" for axis in "xy"])
    ray, left = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    centre = np.array([ax, ay + 9.80665]) + 0.135 * (alpha * left - omega**2 * ray)
    moment = 0.75 * (0.045 * cross(ray, centre) + 0.09**2 / 12 * alpha) - 0.09 * cross(ray, pin)
    assert np.abs(rows(cut, ["seam.torque"])[0] - moment).max() < 1e-10 * np.abs(moment).max()
