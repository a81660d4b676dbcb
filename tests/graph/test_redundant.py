"""Redundant mechanisms: the spare joint is named, motion and efforts are computed, reactions as far as statics goes;
dimensions that contradict each other with the size of the contradiction."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

import linkwright as lw
from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.findings import Finding
from linkwright.model.document import Document
from linkwright.results.certificate import certify
from linkwright.results.run import Run

EXAMPLES = Path(__file__).parents[2] / "examples"
UNITS = {"length": "mm", "angle": "deg", "time": "s"}


def parallelogram(cranks: int = 2, length: float = 40.0) -> dict[str, Any]:
    """Cranks of 40 mm under one coupler; those after the second have a length of their own."""
    links: dict[str, Any] = {"frame": {"points": {}}}
    for i in range(1, cranks + 1):
        links["frame"]["points"][f"A{i}"] = [60 * i, 15 * (i > 2)]
        links[f"crank{i}"] = {"points": {f"A{i}": [0, 0], f"B{i}": [40.0 if i < 3 else length, 0]}}
    links["coupler"] = {"points": {f"B{i}": [60 * i, 15 * (i > 2)] for i in range(1, cranks + 1)}}
    drives = {"motor": {"turns": "crank1", "on": "frame", "speed": "60 rpm", "start": 30}}
    return {"units": UNITS, "links": links, "assembly": {"B2": "left of B1-A2"}, "drives": drives}


def two_guides(offset: float = -40.0, heading: float = 0.0) -> dict[str, Any]:
    """A slider-crank whose slider has a second guide, on its point H."""
    links = {
        "frame": {"points": {"A": [0, 0], "F": [0, 20], "G": [0, -20]}},
        "crank": {"points": {"A": [0, 0], "B": [50, 0]}},
        "rod": {"points": {"B": [0, 0], "C": [160, 0]}},
        "slider": {"points": {"C": [0, 0], "H": [0, offset]}},
    }
    joints = {
        "guide": {"prismatic": ["frame", "slider"], "line": ["F at 0", "C at 0"]},
        "second": {"prismatic": ["frame", "slider"], "line": [f"G at {heading}", f"H at {heading}"]},
    }
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 30}}
    return {
        "units": UNITS, "links": links, "joints": joints, "drives": drives,
        "assembly": {"C": "ahead of B along guide"},
    }  # fmt: skip


def examined(data: dict[str, Any]) -> tuple[Any, list[Finding]]:
    return examine(Document.model_validate(data))


def spared(data: dict[str, Any]) -> tuple[Any, Finding]:
    """A redundant mechanism with the warning on it."""
    compiled, findings = examined(data)
    assert compiled is not None, [f.code for f in findings]
    (finding,) = findings
    assert (finding.code, finding.severity) == ("structure.redundant-joints", "warning")
    return compiled, finding


def refused(data: dict[str, Any]) -> list[Finding]:
    compiled, findings = examined(data)
    assert compiled is None
    return findings


def numbers(finding: Finding) -> tuple[int, ...]:
    return tuple(finding.data[key] for key in ("states", "rank", "constraints", "gruebler", "mobility"))


T = np.linspace(0.0, 0.4, 9)
"""Until the cranks lie along the frame: a change point of the groups that are solved."""


def test_a_third_crank() -> None:
    """Six links with eight pins: 3*4 - 2*6 = 0, but one of the twelve constraints says nothing new."""
    compiled, finding = spared(parallelogram(3))
    assert finding.path == ("joints", "B3")
    assert numbers(finding) == (1, 11, 12, 0, 1)
    for point in ("B1", "B2", "B3"):
        x, y = compiled.evaluate([f"{point}.x", f"{point}.y"], T) * 1000
        angle = np.radians(30) + 2 * np.pi * T
        i = int(point[1])
        np.testing.assert_allclose(x, 60 * i + 40 * np.cos(angle), atol=1e-9)
        np.testing.assert_allclose(y, 15 * (i > 2) + 40 * np.sin(angle), atol=1e-9)
    assert certify(Run(compiled, 0.0, 0.2, 40)).sound()


def test_more_cranks_are_named_pin_by_pin() -> None:
    _, finding = spared(parallelogram(5))
    assert str(finding.data["joints"]) == "B5, B4, B3"
    assert numbers(finding) == (3, 17, 20, -2, 1)


def test_a_second_coupler() -> None:
    """A double parallelogram: both couplers on both cranks."""
    data = parallelogram()
    for crank in ("crank1", "crank2"):
        data["links"][crank]["points"][f"C{crank[-1]}"] = [20, 5]
    data["links"]["second"] = {"points": {"C1": [0, 0], "C2": [60, 0]}}
    compiled, finding = spared(data)
    assert finding.path == ("joints", "C2")
    (angle,) = compiled.evaluate(["second.angle"], T)
    np.testing.assert_allclose(np.sin(angle), 0.0, atol=1e-12)


def test_a_second_guide() -> None:
    compiled, finding = spared(two_guides())
    assert finding.path == ("joints", "second")
    assert numbers(finding) == (2, 8, 10, -1, 1)
    assert certify(Run(compiled, 0.0, 1.0, 40)).sound()


@pytest.mark.parametrize(
    ("data", "joint", "miss"), [(parallelogram(3, 40.2), "B3", "0.2"), (two_guides(-40.3), "second", "0.3")]
)
def test_dimensions_that_contradict_are_refused_with_the_size_of_that(
    data: dict[str, Any], joint: str, miss: str
) -> None:
    refusal, near = refused(data)
    assert refusal.code == "structure.overconstrained"
    assert (near.code, near.path) == ("structure.nearly-redundant", ("joints", joint))
    assert (near.data["miss"], near.data["unit"]) == (miss, "mm")


@pytest.mark.parametrize("data", [parallelogram(3, 70.0), two_guides(-40, 20)])
def test_what_is_far_off_is_only_refused(data: dict[str, Any]) -> None:
    assert [f.code for f in refused(data)] == ["structure.overconstrained"]


def test_a_third_crank_on_an_antiparallelogram_is_refused() -> None:
    """The same links put together crosswise don't move with it."""
    data = parallelogram(3)
    data["assembly"] = {"B2": "right of B1-A2"}
    assert [f.code for f in refused(data)] == ["structure.overconstrained"]


def test_a_crank_too_many_that_fits_at_the_start_only() -> None:
    """A tie rod of the right length at the start, but not on the way."""
    data = parallelogram()
    data["links"]["frame"]["points"]["S"] = [90, -50]
    start = compiled_from(data).evaluate(["B1.x", "B1.y", "B2.x", "B2.y"], np.zeros(1))[:, 0] * 1000
    middle = (start[:2] + start[2:]) / 2
    data["links"]["coupler"]["points"]["M"] = [90, 0]
    data["links"]["rod"] = {"points": {"S": [0, 0], "M": [float(np.hypot(*(middle - [90, -50]))), 0]}}
    assert [f.code for f in refused(data)] == ["structure.overconstrained"]


# Inputs of other people: a tandem lift table, a trammel turned by a crank, a guided scissor lift.

SCISSOR = """
linkwright: 1
units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
gravity: [0, -9.81 m/s^2]
parameters: {L: 1000}
links:
  frame: {points: {A0: [0, 0], R: [0, 0], H: [0, 0]}}
  up: {points: {A0: [0, 0], B1: [L, 0], M: [L/2, 0]}, mass: 10, shape: rod A0-B1}
  dn: {points: {B0: [0, 0], A1: [L, 0], M: [L/2, 0]}, mass: 10, shape: rod B0-A1}
  platform: {points: {A1: [0, 0], S: [0, 0], C: [500, 0]}, mass: 50, com: [500, 0], inertia: 4e6}
joints:
  rail: {pin_in_slot: [dn, frame], pin: B0, straight: R at 0 deg}
  top: {pin_in_slot: [up, platform], pin: B1, straight: S at 0 deg}
  guide: {pin_in_slot: [platform, frame], pin: S, straight: H at 90 deg}
assembly: {B0: [966, 0], A1: [0, 259], M: [483, 129]}
drives:
  ram: {moves: dn, at: B0, on: frame, along: R at 0 deg, position: "966 mm - 20 mm*t/(1 s)"}
loads: {w: {on: platform, at: C, force: [0, -1000]}}
studies: {cycle: {duration: 5 s, samples: 50}}
"""
TANDEM = """
linkwright: 1
units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
gravity: earth
parameters: {L: 1000, w: 1200}
links:
  frame: {points: {A0: [0, 0], E0: [w, 0], R: [0, 0]}}
  up1: {points: {A0: [0, 0], B1: [L, 0], M: [L/2, 0]}, mass: 10, shape: rod A0-B1}
  dn1: {points: {B0: [0, 0], A1: [L, 0], M: [L/2, 0]}, mass: 10, shape: rod B0-A1}
  up2: {points: {E0: [0, 0], F1: [L, 0], N: [L/2, 0]}, mass: 10, shape: rod E0-F1}
  dn2: {points: {F0: [0, 0], E1: [L, 0], N: [L/2, 0]}, mass: 10, shape: rod F0-E1}
  platform: {points: {A1: [0, 0], E1: [w, 0], S: [0, 0]}, mass: 100, com: [1100, 0], inertia: 1e7}
joints:
  r1: {pin_in_slot: [dn1, frame], pin: B0, straight: R at 0 deg}
  r2: {pin_in_slot: [dn2, frame], pin: F0, straight: R at 0 deg}
  t1: {pin_in_slot: [up1, platform], pin: B1, straight: S at 0 deg}
  t2: {pin_in_slot: [up2, platform], pin: F1, straight: S at 0 deg}
assembly: {B0: [900, 0], A1: [0, 436], B1: [900, 436], F0: [2100, 0], E1: [1200, 436], F1: [2100, 436]}
drives: {ram: {moves: dn1, at: B0, on: frame, along: R at 0 deg, position: "900 mm - 20 mm*t/(1 s)"}}
"""
TRAMMEL = """
linkwright: 1
units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
parameters: {l: 100}
links:
  frame: {points: {O: [0, 0], Q: [0, 0]}}
  crank: {points: {O: [0, 0], M: [l/2, 0]}, mass: 1, shape: rod O-M}
  bar:   {points: {A: [0, 0], M: [l/2, 0], B: [l, 0], P: [1.5*l, 0]}, mass: 1, shape: rod A-B}
joints:
  sx: {pin_in_slot: [bar, frame], pin: A, straight: Q at 0 deg}
  sy: {pin_in_slot: [bar, frame], pin: B, straight: Q at 90 deg}
assembly: {A: [70, 0], B: [0, 70]}
drives: {motor: {turns: crank, on: frame, speed: 60 rpm, start: 45 deg}}
"""


def data_of(text: str) -> dict[str, Any]:
    data: dict[str, Any] = YAML(typ="safe").load(text)
    return data


def test_a_tandem_lift_table() -> None:
    """Two scissors under one platform: two rollers are spare. The ram's force at the start from virtual work."""
    compiled, finding = spared(data_of(TANDEM))
    assert str(finding.data["joints"]) == "t2, r2"
    assert numbers(finding) == (2, 14, 16, -1, 1)
    (force,) = compiled.evaluate(["ram.force"], T)
    assert force[0] == pytest.approx(-2428.654, abs=5e-4)
    assert certify(Run(compiled, 0.0, 5.0, 40)).sound()


def test_a_trammel_with_a_crank_has_one_slot_too_many() -> None:
    compiled, finding = spared(data_of(TRAMMEL))
    assert finding.path == ("joints", "sy")
    x, y = compiled.evaluate(["P.x", "P.y"], T) * 1000
    angle = np.radians(45) + 2 * np.pi * T
    np.testing.assert_allclose([x, y], [-50 * np.cos(angle), 150 * np.sin(angle)], atol=1e-9)


def test_a_guided_scissor_lift_names_the_guide() -> None:
    """The ram's force against that without the guide, which holds nothing that isn't held already."""
    compiled, finding = spared(data_of(SCISSOR))
    assert finding.path == ("joints", "guide")
    free = data_of(SCISSOR)
    del free["joints"]["guide"]
    (force,), (without,) = (one.evaluate(["ram.force"], T) for one in (compiled, compiled_from(free)))
    np.testing.assert_allclose(force, without, rtol=1e-12)
    assert "platform" not in str(finding.data["joints"])


# What is known of reactions.


def with_measure(text: str, **data: Any) -> dict[str, Any]:
    return {**data_of(SCISSOR), "measures": {"m": {"extremes": text}}, **data}


@pytest.mark.parametrize(
    "text",
    ["guide.force", "force(dn, platform).x", "hypot(force(dn, platform).x, force(dn, platform).y)", "-rail.force"],
)
def test_reactions_that_statics_leaves_open_are_refused_by_name(text: str) -> None:
    (finding,) = refused(with_measure(text))
    assert (finding.code, finding.path) == ("stiffness.undetermined", ("measures", "m", "extremes"))


@pytest.mark.parametrize(
    "text", ["force(dn, platform).x + force(frame, platform).x", "force(up, platform).y", "top.force", "ram.force"]
)
def test_what_is_determined_of_them_can_be_measured(text: str) -> None:
    compiled, _ = examined(with_measure(text))
    assert compiled is not None


def test_undetermined_reactions_are_in_no_list() -> None:
    job = lw.run(Document.model_validate(data_of(SCISSOR)))
    assert "guide.force" not in job.cycle.result.names
    forces = {name for name in job.cycle.result.names if name.startswith("force(")}
    upright = {f"force({on}).y" for on in ("up, platform", "dn, platform", "platform, frame")}
    assert forces == {*upright, "force(up, platform).x", "force(dn, frame).x"}
    with pytest.raises(lw.ModelError) as error:
        job.cycle.result["guide.force"]
    assert [f.code for f in error.value.findings] == ["stiffness.undetermined"]
    total = job.cycle.result["force(dn, platform).x + force(frame, platform).x"]
    np.testing.assert_allclose(total, 0.0, atol=1e-6)  # nothing else pushes the platform sideways


def test_friction_that_depends_on_them_is_refused() -> None:
    friction = {"f": {"pin": "A1", "radius": "10 mm", "coefficient": 0.1}}
    (finding,) = refused({**data_of(SCISSOR), "friction": friction})
    assert (finding.code, finding.path, finding.data["joint"]) == ("stiffness.friction", ("friction", "f"), "A1")
    compiled, _ = examined({**data_of(SCISSOR), "friction": {"f": {"pin": "A1", "viscous": "0.1 N*m*s/rad"}}})
    assert compiled is not None


def test_studies_that_dont_take_them_are_refused_by_name() -> None:
    for study, options in {"limits": {}, "sweep": {"vary": {"L": {"uniform": [990, 1010]}}}}.items():
        studies = {"cycle": {"duration": "1 s"}, study: options}
        findings = lw.check(Document.model_validate({**data_of(SCISSOR), "studies": studies}))
        assert "structure.redundant-study" in [f.code for f in findings], study
    with pytest.raises(lw.ModelError) as error:
        lw.modes(Document.model_validate(parallelogram(3)))
    assert [f.code for f in error.value.findings] == ["structure.redundant-study"]


def test_undetermined_reactions_have_no_values_in_python() -> None:
    """Neither of a run nor of a compiled mechanism, with or without rates; others beside them do."""
    compiled, _ = examined(data_of(SCISSOR))
    run, names = Run(compiled, 0.0, 1.0, 10), ["guide.force", "force(dn, platform).x", "top.force", "ram.force"]
    for rows in (compiled.evaluate(names, T), run.evaluate(names, T), *compiled.rates(names, T), *run.rates(names, T)):
        assert np.isnan(rows[:2]).all()
        assert np.isfinite(rows[2:]).all()


# What a stiffness can be stated of.


@pytest.mark.parametrize(
    ("stiffness", "code", "path"),
    [
        ({"joints": "1 kN/mm", "up": "1 kN/mm"}, "stiffness.link", ("stiffness", "up")),  # a roller besides two pins
        ({"joints": "1 kN/mm", "guide": {"value": 1, "tilt": 1}}, "stiffness.tilt", ("stiffness", "guide", "tilt")),
        ({"guides": "1 kN/mm"}, "name.unknown", ("stiffness", "guides")),
        ({"guide": "1 kN"}, "expression.units-conflict", ("stiffness", "guide")),
        ({"guide": "-1 kN/mm"}, "value.too-small", ("stiffness", "guide")),
    ],
)
def test_stiffness_that_cannot_be(stiffness: Any, code: str, path: tuple[str, ...]) -> None:
    findings = refused({**data_of(SCISSOR), "stiffness": stiffness})
    assert (code, path) in [(f.code, f.path[: len(path)]) for f in findings]


@pytest.mark.parametrize(
    ("stiffness", "code"),
    [
        ({"joints": "1 kN/mm", "guide": "equal"}, "stiffness.mixed"),
        ({"guide": {"tilt": 1}}, "stiffness.value"),
        ({"guide": {"value": 1, "equal": True}}, "stiffness.value"),
    ],
)
def test_stiffness_that_is_not_clear(stiffness: Any, code: str) -> None:
    with pytest.raises(ValueError, match=code):
        Document.model_validate({**data_of(SCISSOR), "stiffness": stiffness})


def test_a_link_that_is_loaded_has_no_stiffness() -> None:
    loads = {"p": {"on": "crank3", "at": "B3", "force": [0, -10]}}
    stiffness = {"joints": "1 kN/mm", "crank3": "1 kN/mm"}
    refusal = refused({**parallelogram(3), "loads": loads, "stiffness": stiffness})[0]
    assert (refusal.code, refusal.path) == ("stiffness.loaded", ("stiffness", "crank3"))
    assert (refusal.data["link"], refusal.data["name"]) == ("crank3", "p")


def test_stiffness_of_what_is_not_redundant_is_remarked_on() -> None:
    _, findings = examined({**parallelogram(2), "stiffness": "equal"})
    assert [(f.code, f.severity) for f in findings] == [("stiffness.no-effect", "note")]


# Gears.


def planets(count: int, **more: Any) -> dict[str, Any]:
    """A planetary gear train with some equal planets: sun and planets of 24 teeth, a fixed ring of 72."""
    links: dict[str, Any] = {
        "frame": {"points": {"O": [0, 0]}},
        "sun": {"points": {"O": [0, 0]}, "mass": 0.8, "shape": "disc 24 at O"},
        "arm": {"points": {"O": [0, 0]}, "mass": 0.5, "com": [0, 0], "inertia": 1000},
    }
    joints, sketch = {}, {}
    for i in range(count):
        x, y = 48 * np.cos(2 * np.pi * i / count), 48 * np.sin(2 * np.pi * i / count)
        links["arm"]["points"][f"P{i}"] = [float(x), float(y)]
        points = {f"P{i}": [0, 0], f"Q{i}": [24, 0]}
        links[f"planet{i}"] = {"points": points, "mass": 0.8, "shape": f"disc 24 at P{i}"}
        inner = {"gears": ["sun", f"planet{i}"], "centres": ["O", f"P{i}"], "teeth": [24, 24]}
        outer = {"gears": [f"planet{i}", "frame"], "internal": "frame", "centres": [f"P{i}", "O"], "teeth": [24, 72]}
        joints |= {f"sun_{i}": {**inner, "carrier": "arm", "module": 2}}
        joints |= {f"ring_{i}": {**outer, "carrier": "arm", "module": 2}}
        sketch |= {f"P{i}": [float(x), float(y)], f"Q{i}": [float(x) + 24, float(y)]}
    return {
        "units": {**UNITS, "mass": "kg", "force": "N", "torque": "N*m"}, "links": links, "joints": joints,
        "assembly": sketch, "loads": {"brake": {"on": "arm", "torque": -60}},
        "drives": {"motor": {"turns": "sun", "on": "frame", "speed": "240 rpm", "start": "0 deg"}}, **more,
    }  # fmt: skip


def test_three_planets_between_sun_and_ring() -> None:
    """Willis: four turns of the sun make one of the arm, so 15 N m hold 60; how the planets share them isn't known."""
    compiled, finding = spared(planets(3))
    assert str(finding.data["joints"]) == "ring_2, ring_1"
    speed, torque = compiled.evaluate(["arm.omega", "motor.torque"], T)
    np.testing.assert_allclose(speed, 2 * np.pi * 240 / 60 / 4, rtol=1e-12)
    np.testing.assert_allclose(torque, 15.0, rtol=1e-9)
    assert {"sun_0", "ring_2"} <= {joint for joint, _, _ in compiled.structure.self_stress.components}
    assert certify(Run(compiled, 0.0, 0.5, 10)).sound()


def test_teeth_that_push_apart_arent_shared_by_stiffness() -> None:
    refusal = refused(planets(2, stiffness="equal"))[0]
    assert (refusal.code, refusal.path) == ("stiffness.separating", ("stiffness",))


# Carriages on one rail.


def carriage(places: list[float], **more: Any) -> dict[str, Any]:
    links = {
        "frame": {"points": {"F": [0, 0]}},
        "beam": {
            "points": {f"C{i}": [x, 0] for i, x in enumerate(places)},
            "mass": 20,
            "com": [400, 0],
            "inertia": 1e6,
        },
    }
    joints = {
        f"r{i}": {"pin_in_slot": ["beam", "frame"], "pin": f"C{i}", "straight": "F at 0"} for i in range(len(places))
    }
    ram = {"moves": "beam", "at": "C0", "on": "frame", "along": "F at 0", "position": "100 mm + 10 mm*t/(1 s)"}
    return {
        "units": {**UNITS, "mass": "kg", "force": "N", "torque": "N*m"}, "gravity": [0, "-9.81 m/s^2"], "links": links,
        "joints": joints, "assembly": {f"C{i}": [x + 100, 0] for i, x in enumerate(places)}, "drives": {"ram": ram},
        **more,
    }  # fmt: skip


@pytest.mark.parametrize("k", [[1, 1, 1], [1, 2, 0.5, 3]])
def test_a_beam_on_rollers_shares_its_weight_by_their_stiffness(k: list[float]) -> None:
    """A rigid beam on springs, which sinks and tilts."""
    x = np.array([0, 500, 900, 1400][: len(k)])
    stiffness: Any = "equal" if len(set(k)) == 1 else {f"r{i}": f"{one} kN/mm" for i, one in enumerate(k)}
    compiled, finding = spared(carriage(x.tolist(), stiffness=stiffness))
    assert finding.data["states"] == len(k) - 2
    springs = np.array(k, dtype=float)
    sunk, tilted = np.linalg.solve(
        [[springs.sum(), springs @ x], [springs @ x, springs @ x**2]], 196.2 * np.array([1, 400])
    )
    upward = -compiled.evaluate([f"force(beam, frame, r{i}).y" for i in range(len(k))], T)
    np.testing.assert_allclose(upward, np.outer(springs * (sunk + tilted * x), np.ones(T.size)), rtol=1e-9)
    assert certify(Run(compiled, 0.0, 1.0, 10)).sound()


# What dimensions miss by a little.


@pytest.mark.parametrize("error", [1e-8, 3e-8, 1e-7, 3e-7, 1e-6, 1e-3])
@pytest.mark.parametrize("kind", ["crank", "guide"])
def test_a_small_error_is_either_proven_or_refused_with_its_size(error: float, kind: str) -> None:
    """Between what the certificate proves and what contradicts there is no gap."""
    data = parallelogram(3, 40 + error) if kind == "crank" else two_guides(-40 - error)
    compiled, findings = examined(data)
    if compiled is not None:
        assert certify(Run(compiled, 0.0, 0.1, 10)).sound()
        return
    near = findings[-1]
    assert near.code == "structure.nearly-redundant"
    assert float(near.data["miss"]) == pytest.approx(error, rel=0.02)


@pytest.mark.parametrize("duration", ["0.6 s", "1 s"])
def test_a_singular_pose_of_what_remains_is_told_as_that(duration: str) -> None:
    """A third crank carries a parallelogram through its change point, where the other two alone may go either way; so
    it is told where that is, not where the third crank can't follow the other way any further."""
    job = lw.run(
        Document.model_validate({**parallelogram(3), "studies": {"cycle": {"duration": duration, "samples": 40}}})
    )
    assert [f.code for f in job.found] == ["motion.singular", "motion.redundant-joints"]
    assert job.exit_code == 1


@pytest.mark.parametrize("start", [20, 30, 60])
def test_a_third_crank_over_a_full_turn(start: int) -> None:
    """Through both change points of the other two: all cranks have one angle."""
    data = {**parallelogram(3), "studies": {"cycle": {"duration": "1.3 s", "samples": 40, "through": "keep"}}}
    data["drives"]["motor"]["start"] = start
    job = lw.run(Document.model_validate(data))
    assert job.exit_code == 0
    assert job.cycle is not None
    result = job.cycle.result
    x, y = (result[f"B3.{axis}"] for axis in "xy")
    angle = np.radians(start) + 2 * np.pi * result.t
    np.testing.assert_allclose(x, 0.18 + 0.04 * np.cos(angle), atol=1e-10)
    np.testing.assert_allclose(y, 0.015 + 0.04 * np.sin(angle), atol=1e-10)


OTHER_ERRORS = {
    "measure": ("{min: ram.force}", "{min: rom.force}"),
    "load": ("on: platform, at: C, force: [0, -1000]", "on: platfrom, at: C, force: [0, -1000]"),
    "unit": ("force: [300, 0]", "force: [300 mm, 0]"),
    "parameter": ("force: [300, 0]", "force: [force, 0]"),
    "point": ("at: C, force: [300, 0]", "at: Z, force: [300, 0]"),
}
"""A slip in the file of a redundant mechanism, by what it is in."""


@pytest.mark.parametrize("slip", OTHER_ERRORS)
def test_a_slip_in_a_redundant_mechanism_is_told_alone(slip: str, tmp_path: Path) -> None:
    """Whether constraints in excess follow from the others, only sound numbers tell: nothing is said of them before."""
    text = (EXAMPLES / "guided_scissor_lift.yaml").read_text(encoding="utf-8")
    assert text.count(OTHER_ERRORS[slip][0]) == 1
    file = tmp_path / "lift.yaml"
    file.write_text(text.replace(*OTHER_ERRORS[slip]), encoding="utf-8")
    found = [finding for finding in lw.check(file) if finding.severity == "error"]
    assert found and not [f.code for f in found if f.code.startswith("structure.")]
