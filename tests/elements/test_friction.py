"""What files say of friction: refused cases by name, mutated files without a traceback, coefficients that vary."""

from __future__ import annotations

import copy
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.friction import slider_crank
from linkwright.compilation import compile_mechanism
from linkwright.findings import ModelError
from linkwright.model.document import parse_document

EXAMPLE = YAML(typ="safe").load(
    (Path(__file__).parents[2] / "examples" / "slider_crank_friction.yaml").read_text("utf-8")
)


def refused(changes: dict[str, Any] | None = None, **entry: Any) -> list[str]:
    """The codes of what is wrong with one entry of friction."""
    data = copy.deepcopy(EXAMPLE) | (changes or {})
    data["friction"] = {"own": entry}
    del data["measures"]
    with pytest.raises(ModelError) as caught:
        compile_mechanism(parse_document(data))
    return [finding.code for finding in caught.value.findings]


@pytest.mark.parametrize(
    ("code", "entry"),
    [
        ("friction.place", {"coefficient": 0.1}),
        ("friction.place", {"pin": "A", "slide": "guide", "coefficient": 0.1}),
        ("friction.stray", {"pin": "A", "length": 3, "radius": 2, "coefficient": 0.1}),
        ("friction.stray", {"slide": "guide", "length": 3, "radius": 2, "coefficient": 0.1}),
        ("friction.law", {"pin": "A", "radius": 2}),
        ("friction.size", {"pin": "A", "coefficient": 0.1}),
        ("friction.size", {"slide": "guide", "coefficient": 0.1}),
        ("friction.not-on-pin", {"pin": "A", "in": ["rod", "crank"], "radius": 2, "coefficient": 0.1}),
        ("friction.same-link", {"pin": "A", "in": ["crank", "crank"], "radius": 2, "coefficient": 0.1}),
        ("name.unknown", {"pin": "Q", "radius": 2, "coefficient": 0.1}),
        ("name.unknown", {"slide": "bearing", "length": 2, "coefficient": 0.1}),
        ("file.unknown-key", {"pin": "A", "radius": 2, "coefficient": 0.1, "stiction": 0.2}),
    ],
)
def test_refused_by_name(code: str, entry: dict[str, Any]) -> None:
    assert code in refused(**entry)


def test_refused_where_statics_says_nothing() -> None:
    """In loops of slides, in a contact on two sides, in structures."""
    examples = Path(__file__).parents[2] / "examples"
    cases = {
        "wedge_press": ("friction.loop", {"slide": "ANY", "length": 2, "coefficient": 0.1}),
        "conjugate_cam": ("friction.second-contact", {"contact": "sley_drive", "radius": 2, "coefficient": 0.1}),
        "bracket": ("friction.still", {"pin": "A", "radius": 2, "coefficient": 0.1}),
    }
    for name, (code, entry) in cases.items():
        data = YAML(typ="safe").load((examples / f"{name}.yaml").read_text("utf-8"))
        if "slide" in entry:
            entry["slide"] = next(key for key, joint in data["joints"].items() if "prismatic" in joint)
        data["friction"] = {"own": entry}
        document = lw.Document.model_validate(data)
        assert code in [finding.code for finding in lw.check(document)]


def test_a_coefficient_is_not_negative() -> None:
    assert refused(pin="A", radius=2, coefficient=-0.1) != []
    data = slider_crank()
    data["friction"] = {"own": {"pin": "A", "radius": "10 mm", "coefficient": "0.1 - 0.01*abs(own.omega)/(1 rad/s)"}}
    data["studies"] = {"cycle": {"turns": "1 motor", "samples": 30}}
    job = lw.run(lw.Document.model_validate(data))
    assert job.cycle is not None
    assert [finding.code for finding in job.cycle.failures] == ["friction.gives"]


def test_more_than_two_links_on_a_pin() -> None:
    """It is said which link rubs on which; then the friction is that of the link's own force on the pin."""
    data = slider_crank(0.0, None)
    data["links"]["flap"] = {"points": {"B": [0, 0], "E": [20, 0]}, "mass": 2, "shape": "point E"}
    data["drives"]["servo"] = {"turns": "flap", "on": "crank", "position": "1 rad*sin(20*t/(1 s))"}
    data["friction"] = {"own": {"pin": "B", "radius": "10 mm", "coefficient": 0.1}}
    with pytest.raises(ModelError) as caught:
        compiled_from(data)
    assert [finding.code for finding in caught.value.findings] == ["friction.pin-links"]
    data["friction"]["own"]["in"] = ["rod", "crank"]
    t = np.linspace(0.01, 0.17, 9)
    names = ["own.moment", "force(rod, B).x", "force(rod, B).y", "rod.omega", "crank.omega"]
    moment, x, y, rod, crank = compiled_from(data).evaluate(names, t)
    assert moment == pytest.approx(-np.sign(rod - crank) * 0.1 * 0.01 * np.hypot(x, y), rel=1e-12)


def test_a_stribeck_curve_as_a_table() -> None:
    data = slider_crank(0.0, None)
    data["tables"] = {
        "stribeck": {"points": [["0 rad/s", 0.15], ["20 rad/s", 0.05], ["90 rad/s", 0.1]], "between": "linear"}
    }
    data["friction"] = {"own": {"pin": "B", "radius": "10 mm", "coefficient": "stribeck(abs(own.omega))"}}
    t = np.linspace(0.01, 0.17, 9)
    moment, omega, x, y = compiled_from(data).evaluate(
        ["own.moment", "own.omega", "force(crank, rod).x", "force(crank, rod).y"], t
    )
    mu = np.interp(np.abs(omega), [0, 20, 90], [0.15, 0.05, 0.1])
    assert moment == pytest.approx(-np.sign(omega) * mu * 0.01 * np.hypot(x, y), rel=1e-12)


NASTY: list[Any] = [
    None, "", "A", "guide", -1, 0, 1e300, "nan", "1/0", [], ["crank"], {}, True, "own.moment", "10 deg", "stribeck(t)",
    "bearing_A.moment", ["frame", "crank"], "power(work).supplied", ["work"], ["rail", "nothing"], "slot", 1e-300, 0.05,
    "0.02 + 0.01*t/(1 s)", "10 mm", 3, "3", "out", "%",
]  # fmt: skip
KEYS = ["pin", "slide", "contact", "in", "radius", "length", "coefficient", "viscous", "kind", "static"]
IN_MEASURES = ["efficiency", "share", "useful", "window", "unit", "mean", "max", "wrap"]


def slotted() -> dict[str, Any]:
    """A lever with a pin in its slot, which rubs."""
    data: dict[str, Any] = YAML(typ="safe").load(
        (Path(__file__).parents[2] / "examples" / "slotted_lever.yaml").read_text("utf-8")
    )
    data["friction"] = {"rub": {"contact": "slot", "coefficient": 0.1}}
    data["loads"] = data.get("loads", {}) | {"work": {"on": "frame", "torque": 1}}
    data["measures"] = {"eta": {"efficiency": ["work"]}, "part": {"share": ["rub"], "useful": ["work"]}}
    data |= {"require": {}, "exports": {}, "studies": {}}
    return data


BASES = [EXAMPLE, slotted()]


@pytest.mark.parametrize("seeds", [range(300), pytest.param(range(300, 2000), marks=pytest.mark.long)], ids=str)
def test_mutated_files_are_refused_or_run(seeds: range) -> None:
    """Keys or values of friction and of measures changed at random: no error but those that have words."""
    outcomes = {"refused": 0, "run": 0}
    for seed in seeds:
        pick = random.Random(seed)
        data = copy.deepcopy(BASES[seed % 2])
        for _ in range(pick.choice([1, 1, 2])):
            section, keys = pick.choice([("friction", KEYS), ("friction", KEYS), ("measures", IN_MEASURES)])
            entry = data[section][pick.choice(sorted(data[section]))]
            if entry and pick.random() < 0.3:
                entry.pop(pick.choice(sorted(entry)))
            entry[pick.choice(keys)] = pick.choice(NASTY)
        try:
            compiled = compile_mechanism(parse_document(data))
        except ModelError as error:
            assert error.findings
            assert all(finding.what and finding.mend for finding in error.findings)
            outcomes["refused"] += 1
            continue
        if seed % 5 == 0:
            compiled.evaluate(["motor.torque"], np.linspace(0.0, 0.5, 5))
        outcomes["run"] += 1
    assert min(outcomes.values()) > 0.02 * len(seeds)  # both happen


YOKE = YAML(typ="safe").load((Path(__file__).parents[2] / "examples" / "scotch_yoke_friction.yaml").read_text("utf-8"))
WEDGE = YAML(typ="safe").load((Path(__file__).parents[2] / "examples" / "wedge_lift.yaml").read_text("utf-8"))


@pytest.mark.parametrize("data", [EXAMPLE, YOKE, WEDGE], ids=["pins and a slide", "a contact", "a loop of slides"])
@pytest.mark.parametrize("static", [False, True])
def test_where_no_force_acts_no_friction_does(data: dict[str, Any], static: bool) -> None:
    """Without masses, loads and springs all forces are zero, exactly: no round-off that a check would call wrong."""
    data = copy.deepcopy(data)
    for section in ("gravity", "loads", "springs", "counterweights", "measures", "require", "windows"):
        data.pop(section, None)
    for link in data["links"].values():
        for key in ("mass", "shape", "com", "inertia"):
            link.pop(key, None)
    for entry in data["friction"].values():
        entry.pop("viscous", None)
        entry.update({"coefficient": 0.1, **({"static": 0.15} if static else {})})
    data["studies"] = {"cycle": {**data["studies"]["cycle"], "samples": 6}}
    job = lw.run(lw.Document.model_validate(data))
    assert [finding for finding in job.found if finding.severity == "error"] == []
    assert job.cycle is not None
    result = job.cycle.result
    efforts = [f"{name}.{'moment' if 'pin' in entry else 'force'}" for name, entry in data["friction"].items()]
    efforts += [f"{name}.{'torque' if 'turns' in drive else 'force'}" for name, drive in data["drives"].items()]
    assert [effort for effort in efforts if np.any(result[effort])] == []
