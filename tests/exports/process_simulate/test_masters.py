"""Any joint as master: texts against closed forms of four-bars and the solver, and what is said of dead centres."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.plain import document_of
from helpers.random_mechanisms import Seeded, build
from linkwright.exports.process_simulate import evaluator
from linkwright.exports.process_simulate.dialects import DIALECTS
from linkwright.exports.process_simulate.functions import Wish, make
from linkwright.exports.process_simulate.joints import joints_of
from linkwright.exports.process_simulate.linkage import Refused
from linkwright.findings import ModelError
from linkwright.model.document import parse_document

from .test_functions import example, own_error

Array = NDArray[np.float64]
EXAMPLES = Path(__file__).parents[3] / "examples"


def four_bar(a: float, b: float, c: float, d: float, side: float, start: float) -> dict[str, Any]:
    return {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "rad", "time": "s"},
        "links": {
            "frame": {"points": {"O": [0, 0], "D": [d, 0]}},
            "crank": {"points": {"O": [0, 0], "B": [a, 0]}},
            "coupler": {"points": {"B": [0, 0], "C": [b, 0]}},
            "rocker": {"points": {"D": [0, 0], "C": [c, 0]}},
        },
        "assembly": {"C": f"{'left' if side > 0 else 'right'} of B-D"},
        "drives": {"motor": {"turns": "crank", "on": "frame", "speed": 1, "start": start}},
    }


def closed(a: float, b: float, c: float, d: float, side: float, theta: Array) -> dict[str, Array]:
    """The joints' angles by two circles that meet: those of O, B, C, D against the link before."""
    at = a * np.exp(1j * theta)
    base = d - at
    along = (b * b - c * c + abs(base) ** 2) / (2 * abs(base))
    pin = at + base / abs(base) * (along + 1j * side * np.sqrt(b * b - along**2))
    coupler, rocker = (np.unwrap(np.angle(arm)) for arm in (pin - at, pin - d))
    return {"O": theta, "B": coupler - theta, "C": rocker - coupler, "D": rocker}


def drawn(seed: int) -> tuple[float, ...]:
    """Lengths, side and middle of a four-bar that closes over a tenth of a turn."""
    rng = np.random.default_rng(seed)
    while True:
        a, b, c, d = rng.uniform(20, 120, 4)
        middle = rng.uniform(-3, 3)
        reach = abs(d - a * np.exp(1j * np.linspace(middle - 0.35, middle + 0.35, 41)))
        if (reach < 0.95 * (b + c)).all() and (reach > 1.05 * abs(b - c) + 1).all():
            return a, b, c, d, float(rng.choice([-1, 1])), middle


@pytest.mark.parametrize("dialect", [*DIALECTS])
@pytest.mark.parametrize("seed", range(4))
def test_random_four_bars_from_every_joint_agree_with_two_circles(seed: int, dialect: str) -> None:
    *shape, middle = drawn(seed)
    document = parse_document(four_bar(*shape, middle))  # type: ignore[arg-type]
    theta = np.linspace(middle - 0.3, middle + 0.3, 401)
    values = closed(*shape, theta)  # type: ignore[arg-type]
    values = {joint: row - row[200] for joint, row in values.items()}
    count = 0
    for master, row in values.items():
        # Over the part around the start in which the master goes one way.
        steps = np.sign(np.diff(row))
        turned = np.flatnonzero(steps != steps[200])
        first = turned[turned < 200].max(initial=0) + 5 * bool((turned < 200).any())
        last = turned[turned > 200].min(initial=400) - 5 * bool((turned > 200).any())
        if last - first < 60 or not first < 200 < last:
            continue
        count += 1
        ends = [float(theta[first]), float(theta[last])]
        done = lw.export(document, "process-simulate", dialect=dialect, master=master, range=ends)
        assert done.done, done.failures
        assert done.summary["max_error"] < 1e-8
        # The file of C# is read back: what is pasted is what is held against the circles.
        texts = re.findall(r'joints\["(\w+)"\]\.KinematicsFunction = "(.*)";', done.files["joint_functions.cs"])
        assert {name for name, _ in texts} == values.keys() - {master}
        assert texts == [*done.summary["functions"].items()]
        kinds, inside = dict.fromkeys(values, "T"), slice(first, last + 1)
        found = evaluator.evaluate(texts, dialect, kinds, master, row[inside])
        for (name, _), got in zip(texts, found, strict=True):
            off = got - values[name][inside]
            assert np.abs(off - 2 * math.pi * np.round(off / (2 * math.pi))).max() < 2e-8
    assert count >= 2


@pytest.mark.parametrize("name", ["boom_cylinder", "slider_crank", "quick_return"])
def test_examples_from_every_joint_agree_with_the_solver(name: str) -> None:
    compiled = example(name)
    drive, refused = compiled.graph.drives[0], []
    for joint in joints_of(compiled.structure):
        for dialect in DIALECTS:
            try:
                found = make(compiled, Wish(drive, dialect, master=joint.joint))
            except Refused as error:
                refused.append((joint.joint, error.finding.code))
                continue
            assert found.driving.joint == joint.joint
            names = {j.joint for j in joints_of(compiled.structure)}
            assert {f.joint for f in found.functions} == names - {joint.joint}
            assert own_error(compiled, found) < 2e-8
    assert {code for _, code in refused} <= {"functions.master-zero"}


@pytest.mark.parametrize("seed", range(4))
def test_random_six_bars_from_every_joint_agree_with_the_solver(seed: int) -> None:
    compiled = compiled_from(document_of(build("six_bar", Seeded(seed))))
    made = 0
    for joint in joints_of(compiled.structure):
        try:
            found = make(compiled, Wish(compiled.graph.drives[0], "wizard", master=joint.joint))
        except Refused as error:
            codes = ("master-zero", "master-still", "no-closed-form", "sweep", "error", "wedge")
            assert error.finding.code.removeprefix("functions.") in codes
            continue
        assert own_error(compiled, found) < max(2e-8, 2e-8 * compiled.assembly.size())
        made += 1
    assert made > 1


def hinge(**options: Any) -> Any:
    """The paper's hinge with its joints named as there."""
    own = {"names": {"O": "j2", "B": "j3", "C": "j4"}, "left_out": ["F"], "flipped": ["O"], "stops": [0, 35]}
    return parse_document(
        {
            "linkwright": 1,
            "units": {"length": "mm", "angle": "deg"},
            "sketch": {"O": [0, 0], "F": [60, 0], "C": [95, 70], "B": [-20, 110]},
            "links": {
                "frame": {"points": ["O", "F"]},
                "front": {"points": ["F", "C"]},
                "panel": {"points": ["B", "C"]},
                "rear": {"points": ["O", "B"]},
            },
            "drives": {"hinge": {"turns": "rear", "on": "frame", "speed": "-5 deg/s", "start": "sketch"}},
            "exports": {"process-simulate": {k: v for k, v in (own | options).items() if v is not None}},
        }
    )


def test_functions_and_those_of_another_master_are_inverse() -> None:
    """T(j4) of T(j2), and T(j2) of that: the same value again."""
    there = lw.export(hinge(), "process-simulate").summary
    stops = [math.degrees(there["limits"]["j4"]["low"]) + 1e-6, math.degrees(there["limits"]["j4"]["high"])]
    back = lw.export(hinge(master="j4", stops=stops), "process-simulate").summary
    assert back["driving"] == {**back["driving"], "name": "j4", "joint": "C", "drive": "hinge"}
    j2 = np.linspace(0, math.radians(34.9), 50)
    kinds = dict.fromkeys(("j2", "j3", "j4"), "T")
    (j4,) = evaluator.evaluate([("j4", there["functions"]["j4"])], "seed", kinds, "j2", j2)
    rows = evaluator.evaluate([*back["functions"].items()], "seed", kinds, "j4", j4)
    found = dict(zip(back["functions"], rows, strict=True))
    assert found["j2"] == pytest.approx(j2, abs=1e-8)
    assert back["range"]["to"] - back["range"]["from"] == pytest.approx(35, abs=1e-4)


def test_the_master_by_its_name_in_the_model_or_in_the_tool() -> None:
    for name in ("C", "j4"):
        done = lw.export(hinge(master=name, stops=[-20, 0]), "process-simulate")
        assert done.summary["driving"]["joint"] == "C"
        assert "j4 is the master instead of the joint moved by hinge" in done.files["joint_functions.txt"]


def found(**options: Any) -> list[Any]:
    try:
        done = lw.export(hinge(**options), "process-simulate")
    except ModelError as error:
        return [*error.findings]
    return [*done.failures, *done.warnings]


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"master": "j9"}, "name.unknown"),
        ({"master": "F"}, "functions.master-left-out"),
        ({"master": "j4", "stops": [-100, 0]}, "functions.master-stops"),
        ({"master": "j4", "stops": None, "range": [0, 200]}, "functions.master-turns"),
        ({"master": "j4", "stops": None}, "functions.master-cut"),
        ({"master": "j4", "stops": ["-1 mm", "2 mm"]}, "expression.units-conflict"),
    ],
)
def test_a_wrong_master_is_told(options: dict[str, Any], code: str) -> None:
    assert [finding.code for finding in found(**options)] == [code]


def test_a_dead_centre_is_told_with_the_range_and_the_masters_that_do() -> None:
    crank = parse_document(four_bar(40, 120, 80, 100, 1, 0.7))
    (finding,) = lw.export(crank, "process-simulate", master="D", range=[0, 6]).failures
    assert finding.code == "functions.master-turns"
    assert str(finding.data["others"]) == "O, B"
    # The rocker turns back where crank and coupler are in line: by the law of cosines.
    fold = math.acos(((120 - 40) ** 2 + 100**2 - 80**2) / (2 * (120 - 40) * 100)) + math.pi
    stretch = math.acos(((120 + 40) ** 2 + 100**2 - 80**2) / (2 * (120 + 40) * 100))
    assert float(finding.data["at"]) == pytest.approx(stretch, abs=1e-7)
    offered = [float(finding.data[end]) for end in ("low", "high")]
    assert offered == pytest.approx([stretch, fold], abs=0.01)
    # What is offered is taken.
    assert lw.export(crank, "process-simulate", master="D", range=offered, zero=2).done
    done = lw.export(crank, "process-simulate", master="D", zero=stretch)
    assert [finding.code for finding in done.failures] == ["functions.master-zero"]


def test_a_slide_as_master_has_stops_in_mm() -> None:
    document = lw.load(EXAMPLES / "slider_crank.yaml")
    done = lw.export(document, "process-simulate", master="guide", stops=["-20 mm", "0.25 mm"])
    assert done.done
    limits = done.summary["limits"]["guide"]
    assert (limits["low"], limits["high"]) == pytest.approx((-20, 0.25))


def test_the_sheet_shows_the_link_that_the_master_moves() -> None:
    """And where the master stands at the other end of the drive's range."""
    own, other = (
        lw.export(lw.load(EXAMPLES / "bonnet_hinge.yaml"), "process-simulate", **options).files["joint_functions.html"]
        for options in ({}, {"master": "j5", "stops": [-90, 0]})
    )
    assert "Dashed: j2 at −70.000\u00a0deg." in own
    assert "Dashed: j5 at −90.000\u00a0deg." in other
    bodies = [re.findall(r'class="link here( driven)?"', page) for page in (own, other)]
    assert [body.index(" driven") for body in bodies] == [2, 0]  # of front strut, panel, rear strut
