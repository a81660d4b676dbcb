"""The pin in a slot: closed forms, raw geometry, what is refused, what leaves its flank."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from elements.slots import SLOTS, SPEED, START, D, R, lever, oracle
from helpers.compiled import compiled_from
from helpers.kernels import every
from linkwright.elements.pin_in_slot import SplineSlot
from linkwright.kernels import KERNELS
from linkwright.measures import measure_all
from linkwright.model.document import Document, dump, read_document
from linkwright.model.schema import json_schema
from linkwright.notation import Jet
from linkwright.results import Run, certify
from model.given import findings

T = np.linspace(0.0, 1.0, 41)
TURN = SPEED * T


def yoke(slot: dict[str, Any], **more: Any) -> dict[str, Any]:
    """A yoke on a horizontal guide, driven by a crank pin in its slot."""
    return {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
        "links": {
            "frame": {"points": {"O": [0, 0], "G": [0, 0]}},
            "crank": {"points": {"O": [0, 0], "B": [40, 0]}},
            "yoke": {"points": {"H": [0, 0]}, "mass": 2, "shape": "point H"},
        },
        "joints": {
            "guide": {"prismatic": ["frame", "yoke"], "line": ["G at 0 deg", "H at 0 deg"]},
            "slot": {"pin_in_slot": ["crank", "yoke"], "pin": "B", **slot},
        },
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 0}},
        **more,
    }


def test_a_yoke_moves_as_a_pure_cosine() -> None:
    """x = r cos(phi), the slot's force m r omega^2 cos(phi) (Norton, Design of Machinery, 3rd ed., ch. 2.12); a slot
    square to the guide needs no sketch, as it has one assembly mode."""
    compiled = compiled_from(yoke({"straight": "H at 90 deg"}))
    x, v, a, s, force, torque = compiled.evaluate(["H.x", "H.vx", "H.ax", "slot.s", "slot.force", "motor.torque"], T)
    assert np.allclose(x, R * np.cos(TURN), rtol=0, atol=1e-16)
    assert np.allclose(v, -R * SPEED * np.sin(TURN), rtol=0, atol=1e-15)
    assert np.allclose(a, -R * SPEED**2 * np.cos(TURN), rtol=0, atol=1e-14)
    assert np.allclose(s, R * np.sin(TURN), rtol=0, atol=1e-16)
    # On the pin, along the left normal of a slot that points up: towards -x.
    assert np.allclose(force, -2.0 * R * SPEED**2 * np.cos(TURN), rtol=0, atol=1e-13)
    assert np.allclose(torque, 2.0 * R**2 * SPEED**2 * np.sin(TURN) * np.cos(TURN), rtol=0, atol=1e-14)


def test_an_arc_in_a_yoke_is_the_rod_of_a_slider_crank() -> None:
    compiled = compiled_from(yoke({"arc": {"centre": "H", "radius": 90, "start": 180}}, assembly={"H": [130, 0]}))
    x, s, force = compiled.evaluate(["H.x", "slot.s", "slot.force"], T)
    rod = np.sqrt(0.09**2 - (R * np.sin(TURN)) ** 2)
    assert np.allclose(x, R * np.cos(TURN) + rod, rtol=0, atol=1e-15)
    assert np.allclose(s, -0.09 * np.arcsin(R * np.sin(TURN) / 0.09), rtol=0, atol=1e-15)
    slider = yoke({"straight": "H at 90 deg"})
    slider["links"]["rod"] = {"points": {"B": [0, 0], "H": [90, 0]}}
    slider["joints"].pop("slot")
    slider["assembly"] = {"H": "ahead of B along guide"}
    other = compiled_from(slider)
    along = other.evaluate(["force(rod, crank).x", "force(rod, crank).y", "rod.angle"], T)
    assert np.allclose(force, along[0] * np.cos(along[2]) + along[1] * np.sin(along[2]), rtol=0, atol=1e-12)


@pytest.mark.parametrize("slot", SLOTS)
def test_motion_and_forces_agree_with_raw_geometry(slot: str) -> None:
    compiled = compiled_from(lever(slot))
    t = np.linspace(0.03, 0.97, 23)
    rows = compiled.evaluate(["lever.angle", "lever.alpha", "motor.torque", "slot.force"], t)
    near = np.radians(START[slot])
    expected = []
    for time in t:
        found = oracle(slot, float(time), near)
        near = found[0]
        expected.append(found)
    # Differences for rates; over a knot of the spline, where the jerk jumps, they are less exact.
    rate = 2e-6 if slot == "curve" else 2e-7
    for row, wanted, tolerance in zip(rows, np.array(expected).T, (1e-12, rate, rate, rate), strict=True):
        assert np.abs(row - wanted).max() <= tolerance * max(1.0, np.abs(wanted).max())


@pytest.mark.parametrize("slot", SLOTS)
def test_the_certificate_holds_and_sees_a_wrong_sign(slot: str, monkeypatch: pytest.MonkeyPatch) -> None:
    compiled = compiled_from(lever(slot))
    assert certify(Run(compiled, 0.0, 1.0, 60)).sound(1e-12)
    from linkwright.elements.pin_in_slot import InnerSlot

    actions = InnerSlot.actions
    monkeypatch.setattr(InnerSlot, "actions", lambda *given: [w.opposite for w in actions(*given)])
    wrong = certify(Run(compiled_from(lever(slot)), 0.0, 1.0, 60))
    assert {"equilibrium", "power"} & wrong.unproven().keys()


def test_the_certificate_sees_a_slot_that_lies_elsewhere(monkeypatch: pytest.MonkeyPatch) -> None:
    from linkwright.elements.pin_in_slot import StraightSlot

    monkeypatch.setattr(StraightSlot, "gap", lambda self, x, y: y - 1e-6)
    assert certify(Run(compiled_from(lever("straight")), 0.0, 1.0, 20)).closure > 1e-6


@pytest.mark.parametrize("kernel", every())
def test_kernels_agree(kernel: str) -> None:
    """On the curve, whose pieces are chosen by comparisons; the other slots are among the examples that kernels run."""
    compiled = compiled_from(lever("curve"))
    program = compiled.graph.program(["lever.omega", "slot.force"], rates=True, solve=True)
    x, p = compiled.inputs(T), compiled.parameters
    plain = np.array([compiled.graph.program(["lever.omega", "slot.force"], rates=True)(pose, p) for pose in x.T]).T
    out = KERNELS[kernel](program).run(x, p)
    assert np.abs(out - plain).max() <= 1e-11 * np.abs(plain).max()


def test_sensitivities_agree_with_differences() -> None:
    """The accuracy study's derivatives by the crank, the pivots' distance and the places of the slot."""
    data = lever("curve")
    data["parameters"] = {"r": {"value": 40, "tolerance": 0.1}, "d": {"value": 90, "tolerance": 0.1},
                          "h": {"value": 8, "tolerance": 0.1}}  # fmt: skip
    data["joints"]["slot"]["curve"]["through"] = [[40, 0], [65, "h"], [90, 0], [115, "-h"], [140, 0]]
    data["measures"] = {"swing": {"span": "lever.angle"}}
    document = Document.model_validate(data)
    outcome = lw.accuracy(document, ["swing"], 0)
    coefficients = outcome.figures["swing"].coefficients.mean(axis=1)
    slopes = dict(zip(outcome.contributors.names, coefficients, strict=True))

    def swing(**parameters: float) -> float:
        measures = lw.run(document.replace(**parameters)).cycle.measures
        return float(measures[0].found[0].value)

    step = 1e-3
    for name, value in (("r", 40.0), ("d", 90.0), ("h", 8.0)):
        difference = (swing(**{name: value + step}) - swing(**{name: value - step})) / (2e-3 * step)
        assert slopes[name] == pytest.approx(difference, rel=1e-6)


def test_runs_and_measures_know_where_the_jerk_jumps() -> None:
    """At the places of a curve: the run breaks there, means between them are exact."""
    measures = {"round": {"mean": "lever.jerk"}, "most": {"max": "lever.jerk"}}
    compiled = compiled_from(lever("curve") | {"measures": measures})
    run = Run(compiled, 0.0, 1.0, 60)
    (travel,) = compiled.evaluate(["slot.s"], run.breaks)
    assert run.breaks.size == 6  # twice over each of the middle ones
    assert np.abs(travel[:, None] - 1e-3 * np.array([40, 65, 90, 115, 140])).min(axis=1).max() < 1e-12
    before, after = compiled.evaluate(["lever.jerk"], (run.breaks[:, None] + [-1e-9, 1e-9]).ravel())[0].reshape(-1, 2).T
    assert (np.abs(after - before) > 100.0).sum() == 4  # the two pieces at 115 mm are one cubic
    found = {result.name: result.found[0].value for result in measure_all(run)[0]}
    assert abs(found["round"]) < 1e-11  # a whole turn
    assert found["most"] >= compiled.evaluate(["lever.jerk"], np.linspace(0, 1, 20001))[0].max()
    assert not Run(compiled_from(lever("arc")), 0.0, 1.0, 60).breaks.size


def test_a_spline_is_natural_and_goes_on_straight() -> None:
    spline = SplineSlot.through([(0.0, 0.0), (1.0, 1.0), (3.0, 0.0), (4.0, 2.0)])
    x = np.linspace(-1.0, 5.0, 601)
    jet = spline.height(Jet([x, np.ones_like(x), np.zeros_like(x), np.zeros_like(x)]))
    for k in (0, 1):  # continuous up to the second derivative
        assert np.abs(np.diff(jet.d[k]) - 0.01 * (jet.d[k + 1][1:] + jet.d[k + 1][:-1]) / 2).max() < 1e-4
    assert np.abs(np.diff(jet.d[2])).max() < 0.1
    assert jet.d[2][0] == 0
    assert jet.d[2][-1] == 0
    assert [float(spline.height(Jet([float(at)])).d[0]) for at in (0, 1, 3, 4)] == pytest.approx([0, 1, 0, 2])


def test_what_is_wrong_with_a_slot_is_a_finding() -> None:
    def wrong(**slot: Any) -> list[str]:
        data = lever("straight")
        data["joints"]["slot"] = {"pin_in_slot": ["crank", "lever"], "pin": "B", **slot}
        return [finding.code for finding in findings(json.dumps(data))]

    line = "C at 0 deg"
    assert wrong() == ["joint.slot"]
    assert wrong(straight=line, arc={"centre": "C", "radius": 40}) == ["joint.slot"]
    assert wrong(arc={"centre": "Q", "radius": 40}) == ["name.unknown-point"]
    assert wrong(arc={"centre": "C", "radius": 0}) == ["value.too-small"]
    assert wrong(curve={"along": line, "through": [[0, 0]]}) == ["joint.slot-places"]
    assert wrong(curve={"along": line, "through": [[0, 0], [0, 5]]}) == ["joint.slot-order"]
    assert wrong(curve={"along": line, "through": [[0, 0], 7]}) == ["file.expected"]
    assert wrong(straight=line, travel=[90, 10]) == ["value.not-rising"]
    assert wrong(straight=line, flank="top") == ["file.expected"]
    assert wrong(straight=line, friction=0.1) != []
    assert wrong(straight="C at 5 mm") != []


def test_travel_beyond_its_limits_and_a_pin_off_its_flank_are_reported() -> None:
    job = lw.run(Document.model_validate(lever("straight", travel=[60, 120])))
    assert {finding.code for finding in job.cycle.failures} == {"motion.travel"}
    job = lw.run(Document.model_validate(lever("straight", flank="left")))
    assert job.cycle.done
    (finding,) = [finding for finding in job.cycle.warnings if finding.code == "joint.lifts-off"]
    force = job.cycle.result["slot.force"]
    assert finding.data["force"] == f"{float(force.max()):.6g}" or float(finding.data["force"]) >= float(force.max())
    assert "slot (pin in a slot)" in finding.what


def test_the_file_format_keeps_it_and_the_schema_has_it() -> None:
    document = Document.model_validate(lever("curve", flank="right"))
    again, source = read_document(dump(document).encode())
    assert not source.findings
    assert again == document
    assert again.joints["slot"].links == ("crank", "lever")
    assert "pin_in_slot" in str(json_schema())


def test_studies_answer_and_exports_refuse_it_by_name(tmp_path: Any) -> None:
    data = lever("straight")
    data["studies"] |= {"modes": {}, "limits": {"signals": ["lever.angle"]}}
    job = lw.run(Document.model_validate(data))
    assert job.exit_code == 0
    (course,) = job.limits.motion.courses
    assert course.high.value - course.low.value == pytest.approx(2 * np.arcsin(R / D), abs=1e-12)
    with pytest.raises(lw.ModelError) as error:
        lw.export(Document.model_validate(data), "mjcf", out=tmp_path)
    assert [finding.code for finding in error.value.findings] == ["export.joint"]
    assert "slot (pin in a slot)" in str(error.value)
