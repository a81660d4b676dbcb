"""What files say of gears: refused cases by name, mutated files without a traceback, sweeps and derivatives."""

from __future__ import annotations

import copy
import json
import random
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ruamel.yaml import YAML

import linkwright as lw
from elements.wheels import GEARS, RACKS
from helpers.outside import linkwright, table
from linkwright.compilation import compile_mechanism
from linkwright.elements.belt import InnerBelt
from linkwright.elements.gears import InnerGears
from linkwright.elements.pitch import InnerWheels
from linkwright.elements.rack import InnerRack
from linkwright.elements.rolling import OnLine
from linkwright.findings import ModelError
from linkwright.model.document import parse_document
from linkwright.notation import Wrench

EXAMPLES = {
    name: YAML(typ="safe").load((Path(__file__).parents[2] / "examples" / f"{name}.yaml").read_text("utf-8"))
    for name in ("planetary_train", "geared_five_bar", "cardan_gear", "rack_and_pinion", "rolling_wheel", "belt_drive")
}
PAIR = GEARS["pair"].data
MESH = PAIR["joints"]["mesh"]


def codes(data: Any) -> list[str]:
    """The codes of what is wrong with a file."""
    try:
        compile_mechanism(parse_document(copy.deepcopy(data)))
    except ModelError as error:
        return [finding.code for finding in error.findings]
    return []


def refused(**changes: Any) -> list[str]:
    """The codes of what is wrong with the pair of gears, with other entries; ``None`` removes one."""
    entry = {key: value for key, value in (MESH | changes).items() if value is not None}
    return codes({**PAIR, "joints": {"mesh": entry}})


@pytest.mark.parametrize(
    ("code", "changes"),
    [
        ("gears.size", {"teeth": None}),
        ("gears.size", {"radii": [30, 60]}),
        ("gears.module", {"teeth": None, "radii": [30, 60], "module": 4}),
        ("gears.internal", {"internal": "frame"}),
        ("gears.ring", {"internal": "pinion"}),
        ("gears.ring", {"internal": "wheel", "teeth": [30, 30]}),
        ("gears.whole", {"teeth": [15.5, 30]}),
        ("gears.pressure", {"pressure_angle": 90}),
        ("value.too-small", {"pressure_angle": -5}),
        ("value.too-small", {"teeth": [0, 30]}),
        ("gears.distance", {"teeth": None, "radii": [30, 59]}),
        ("gears.shift", {"module": 3}),
        ("joint.same-link", {"gears": ["pinion", "pinion"], "centres": ["O", "O"]}),
        ("name.unknown-point", {"centres": ["O", "B"]}),
        ("name.unknown", {"carrier": "arm"}),
        ("name.unknown", {"gears": ["pinion", "weel"]}),
        ("joint.same-link", {"carrier": "wheel"}),
    ],
)
def test_wrong_entries_are_told_by_code(code: str, changes: dict[str, Any]) -> None:
    assert code in refused(**changes), refused(**changes)


RACK = EXAMPLES["rack_and_pinion"]["joints"]["mesh"]


@pytest.mark.parametrize(
    ("code", "changes"),
    [
        ("gears.pinion", {"teeth": None}),
        ("gears.pinion", {"radius": 25}),
        ("gears.whole", {"teeth": 20.5}),
        ("gears.pressure", {"pressure_angle": 90}),
        ("gears.rack-distance", {"teeth": 24}),
        ("gears.rack-distance", {"teeth": None, "module": None, "radius": 25.1}),
        ("gears.rack-line", {"pitch_line": "G at 1 deg"}),
        ("gears.guide", {"carrier": "crank"}),
        ("gears.guide", {"rack": ["pinion", "rod"], "pitch_line": "C at 0 deg"}),
        ("name.unknown-point", {"centre": "B"}),
        ("name.unknown", {"carrier": "arm"}),
        ("joint.same-link", {"rack": ["pinion", "pinion"]}),
    ],
)
def test_wrong_racks_are_told_by_code(code: str, changes: dict[str, Any]) -> None:
    data = copy.deepcopy(EXAMPLES["rack_and_pinion"])
    data["joints"]["mesh"] = {key: value for key, value in (RACK | changes).items() if value is not None}
    assert code in codes(data), codes(data)


@pytest.mark.parametrize(
    ("code", "changes"),
    [
        ("gears.path", {"on_line": None}),
        ("gears.path", {"on_circle": {"centre": "A", "radius": 20}}),
        ("gears.same-radius", {"on_line": None, "on_circle": {"centre": "A", "radius": 60, "inside": True}}),
        ("value.too-small", {"radius": 0}),
        ("name.unknown-point", {"on_line": "B at 0 deg"}),
        ("name.unknown-point", {"centre": "G"}),
        ("name.unknown", {"rolling": ["wheel", "ground"]}),
        ("joint.same-link", {"rolling": ["wheel", "wheel"], "on_line": "P at 0 deg"}),
    ],
)
def test_wrong_rolling_is_told_by_code(code: str, changes: dict[str, Any]) -> None:
    data = copy.deepcopy(EXAMPLES["rolling_wheel"])
    entry = data["joints"]["ground"] | {"radius": 60} | changes
    data["joints"]["ground"] = {key: value for key, value in entry.items() if value is not None}
    assert code in codes(data), codes(data)


@pytest.mark.parametrize(
    ("code", "changes"),
    [
        ("belt.size", {"radii": None}),
        ("belt.size", {"teeth": [20, 40]}),
        ("belt.friction", {"pretension": None}),
        ("belt.distance", {"radii": [260, 150]}),
        ("value.too-small", {"pretension": "0 N"}),
        ("joint.carrier", {"carrier": "rod"}),
        ("name.unknown-point", {"centres": ["O", "C"]}),
        ("name.unknown", {"belt": ["pulley", "wheel"]}),
    ],
)
def test_wrong_belts_are_told_by_code(code: str, changes: dict[str, Any]) -> None:
    data = copy.deepcopy(EXAMPLES["belt_drive"])
    entry = data["joints"]["drive"] | changes
    data["joints"]["drive"] = {key: value for key, value in entry.items() if value is not None}
    assert code in codes(data), codes(data)


def test_right_entries_are_taken() -> None:
    assert refused() == []
    assert refused(module=4) == []
    assert refused(teeth=None, radii=[30, 60]) == []


def test_a_carrier_that_is_not_pinned_is_told_with_those_that_are() -> None:
    data = copy.deepcopy(EXAMPLES["planetary_train"])
    del data["joints"]["sun_planet"]["carrier"]
    with pytest.raises(ModelError) as caught:
        compile_mechanism(parse_document(data))
    (finding,) = (one for one in caught.value.findings if one.code == "joint.carrier")
    assert "arm" in str(finding.data["able"])


def test_several_mistakes_are_told_at_once() -> None:
    found = codes({**PAIR, "joints": {"mesh": MESH | {"teeth": [15.5, 30], "pressure_angle": 95, "module": 1}}})
    assert {"gears.whole", "gears.pressure", "gears.shift"} <= {*found}


NASTY: list[Any] = [
    None,
    "",
    "O",
    "arm",
    -3,
    0,
    1e30,
    "1/0",
    [],
    [1],
    [1, 2, 3],
    ["O", "P"],
    {"a": 1},
    True,
    "0 deg",
    "z1",
]
KEYS = ["gears", "centres", "carrier", "teeth", "radii", "module", "internal", "pressure_angle", "pin", "at"]
KEYS += [
    "belt",
    "crossed",
    "pretension",
    "friction",
    "pitch",
    "rack",
    "centre",
    "pitch_line",
    "radius",
    "rolling",
    "on_line",
    "on_circle",
]


@pytest.mark.parametrize("seed", range(60))
def test_mutated_files_are_refused_or_run(seed: int) -> None:
    """A key or a value changed at random: no error but those that have words, no force that isn't a number."""
    pick = random.Random(seed)
    data = copy.deepcopy(EXAMPLES[pick.choice(sorted(EXAMPLES))])
    entry = data["joints"][pick.choice(sorted(data["joints"]))]
    if pick.random() < 0.3:
        entry.pop(pick.choice(sorted(entry)))
    entry[pick.choice(KEYS)] = pick.choice(NASTY)
    try:
        compiled = compile_mechanism(parse_document(data))
    except ModelError as error:
        assert error.findings
        return
    assert np.isfinite(compiled.evaluate(["motor.torque"], np.linspace(0.0, 0.5, 5))).all()


def test_accuracy_has_the_derivatives_of_gears(tmp_path: Path) -> None:
    """By the centre distance, which changes the pressure angle, and by the pressure angle: against differences of a
    sweep."""
    data = copy.deepcopy(EXAMPLES["geared_five_bar"])
    data["parameters"] |= {
        "a": {"value": 135.4, "tolerance": 0.05},
        "alpha": {"value": "20 deg", "tolerance": "0.1 deg"},
    }
    data["links"]["frame"]["points"]["D"] = ["a", 0]
    data["joints"]["mesh"]["pressure_angle"] = "alpha"
    data["measures"] = {"tooth": {"max": "mesh.separating"}, "height": {"max": "C.y"}}
    data["studies"] = {
        "cycle": {"turns": "2 motor", "samples": 120},
        "accuracy": {"outputs": ["tooth", "height"], "samples": 0},
    }
    slopes = summary(data, tmp_path / "accuracy")["accuracy"]
    del data["studies"]["accuracy"]
    for name, (centre, unit) in {"a": (135.4, "mm"), "alpha": (20, "deg")}.items():
        h = 1e-3
        data["studies"]["sweep"] = {"vary": {name: [f"{centre - h} {unit}", f"{centre + h} {unit}"]}}
        summary(data, tmp_path / name)
        swept = np.genfromtxt(tmp_path / name / "out" / "sweep.csv", delimiter=",", names=True, encoding="utf-8-sig")
        for measure in ("tooth", "height"):
            key = next(key for key in swept.dtype.names if key.startswith(measure))
            difference = float(swept[key][1] - swept[key][0]) / (2 * h)
            every = {one["parameter"]: one["coefficient"] for one in slopes[measure]["contributors"]}
            assert every.get(name, 0.0) == pytest.approx(difference, rel=1e-5, abs=1e-6), (measure, name)


@pytest.mark.parametrize("kind", ["gears", "ring", "rack"])
def test_backlash_lets_a_wheel_hang_on_the_flank_that_bears(kind: str, tmp_path: Path) -> None:
    """Half of the backlash over the radius of what follows, by the sign of the tangential force, which changes."""
    case = {"gears": GEARS["pair"], "ring": GEARS["pair"], "rack": RACKS["above"]}[kind]
    data = case.studied(accuracy={"outputs": ["wheel.angle"], "clearances": {"mesh": 0.05}, "samples": 0, "poses": 40})
    radius = 0.06
    if kind == "ring":  # the wheel as a ring about the pinion: 60 mm, its centre 30 mm away
        data["joints"]["mesh"] |= {"internal": "wheel"}
        data["links"]["frame"]["points"]["M"] = [30, 0]
        data["assembly"]["W"] = [70, 0]
        radius = -0.06
    elif kind == "rack":  # the line runs to the left and the pinion lies on its right: x + s r theta, s = -1
        data["studies"]["accuracy"]["outputs"], radius = ["pinion.angle"], -0.025
    data["parameters"] = {"unused": {"value": 1, "tolerance": 0.1}}
    summary(data, tmp_path / kind)
    bands, _ = table(tmp_path / kind / "out" / "accuracy_bands.csv")
    (head,) = (head for head in bands if "play shift" in head)
    run, t = table(tmp_path / kind / "out" / "cycle.csv")
    tangential = next(values for head, values in run.items() if head.startswith("mesh.tangential"))
    assert tangential.min() < 0 < tangential.max()
    clear = np.abs(tangential) > 1e-3 * np.abs(tangential).max()
    expected = np.degrees(5e-5 * np.sign(tangential) / radius)
    at = np.searchsorted(bands["t [s]"], t + 1e-9) - 1
    same = clear & (np.abs(bands["t [s]"][at] - t) < 1e-9)
    assert same.sum() > 10
    assert bands[head][at][same] == pytest.approx(expected[same], rel=1e-9)


WRONG: dict[str, tuple[str, type, str, Any]] = {
    "a separating force too small": ("geared_five_bar", InnerGears, "besides", 0.9),
    "a rack that pulls": ("rack_and_pinion", InnerRack, "besides", -1.0),
    "strands too loose": ("belt_drive", InnerBelt, "besides", 0.5),
    "gears that slip": ("geared_five_bar", InnerWheels, "gap", 1.001),
    "a rack that slips": ("rack_and_pinion", InnerRack, "gap", 1.001),
    "a wheel that slips": ("rolling_wheel", OnLine, "gap", 1.001),
}


@pytest.mark.parametrize("name", WRONG)
def test_the_certificate_fails_what_is_wrong(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """It knows none of the closures and forces: those of another factor don't pass."""
    example, cls, method, factor = WRONG[name]
    right = getattr(cls, method)

    def beside(self: Any, bodies: Any, multipliers: Any) -> list[Wrench]:
        return [wrench.times(factor) for wrench in right(self, bodies, multipliers)]

    def gap(self: Any, *bodies: Any) -> Any:
        first = bodies[0]
        assert first.angle is not None
        return right(self, replace(first, angle=factor * first.angle, turn=first.turn * factor), *bodies[1:])

    monkeypatch.setattr(cls, method, beside if method == "besides" else gap)
    data = copy.deepcopy(EXAMPLES[example])
    data.pop("require", None)
    job = lw.run(lw.Document.model_validate(data))
    assert job.exit_code == 1
    assert "motion.unproven" in [finding["code"] for finding in job.summary["findings"]]


def summary(data: Any, folder: Path) -> Any:
    """What a run of a file found."""
    folder.mkdir()
    (folder / "model.yaml").write_text(json.dumps(data), encoding="utf-8")
    done = linkwright(folder, "run", "model.yaml", "--out", "out")
    assert done.returncode == 0, done.stderr
    return json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8"))
