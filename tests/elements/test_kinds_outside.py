"""Kinds of joints of other packages in every place: their files run by the command line, and held to raw geometry."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from elements.kinds_outside import CASES, GEARS, WAVES, Case, dyad, structure, studied
from helpers.expected import expected_angles, expected_forces, expected_motion
from helpers.newton_euler import Array, Oracle, State
from helpers.outside import linkwright, planted, table
from helpers.plain import UNITS
from linkwright.exports import TARGETS
from linkwright.kernels import KERNELS

WRONG = {
    "pin_on_wave": {"up = y - (x": "up = y + (x"},
    "gear_on_carrier": {
        "(b.angle - c.angle)": "(c.angle - b.angle)",
        "(b.turn - c.turn)": "(c.turn - b.turn)",
    },
}
"""Signs turned over in the kinds' closures."""
FEW = ("wave alone in a loop", "gears alone in a loop", "gears several drives")
"""Mechanisms that stand for all of them where the answer doesn't depend on the place."""
SWEPT = ("wave in a dyad's place", "gears on a link of a dyad")
"""Those that sweeps compile; the second, whose equations are linear, before a release."""
CLEARANCE = 0.02


@dataclass(frozen=True)
class Done:
    """What command lines give in a folder, each performed once: exit code, standard output, standard error."""

    folder: Path
    given: dict[tuple[str, ...], tuple[int, str, str]] = field(default_factory=dict)

    def __getitem__(self, words: tuple[str, ...]) -> tuple[int, str, str]:
        if words not in self.given:
            done = linkwright(self.folder, *words)
            self.given[words] = done.returncode, done.stdout, done.stderr
        return self.given[words]

    def run(self, name: str) -> tuple[int, str, str]:
        """The run of a mechanism."""
        return self["run", file(name), "--out", file(name) + "_run"]


def file(name: str) -> str:
    return re.sub(r"\W+", "_", name) + ".yaml"


@pytest.fixture(scope="module")
def done(tmp_path_factory: pytest.TempPathFactory) -> Done:
    """The kinds as they are."""
    folder = tmp_path_factory.mktemp("right")
    for name, case in CASES.items():
        accuracy: dict[str, Any] = {"outputs": [case.output], "poses": 20, "samples": 0}
        if case in WAVES.values():
            accuracy["clearances"] = {case.joint: CLEARANCE}
        (folder / file(name)).write_text(json.dumps(studied(case, accuracy=accuracy)), encoding="utf-8")
    for word, drawn in (("drawn", True), ("vague", False)):
        (folder / f"{word}.yaml").write_text(json.dumps(structure(drawn)), encoding="utf-8")
    played = studied(GEARS["alone in a loop"], accuracy={"outputs": ["Q.x"], "clearances": {"mesh": CLEARANCE}})
    (folder / "played.yaml").write_text(json.dumps(played), encoding="utf-8")
    return Done(folder)


@pytest.fixture(scope="module")
def wrong(tmp_path_factory: pytest.TempPathFactory) -> Done:
    """With a sign turned over in each kind."""
    folder = tmp_path_factory.mktemp("wrong")
    for name, swaps in WRONG.items():
        planted(folder, name, *swaps.items())
    for name in FEW:
        (folder / file(name)).write_text(json.dumps(studied(CASES[name])), encoding="utf-8")
    return Done(folder)


@pytest.fixture(scope="module")
def swept(tmp_path_factory: pytest.TempPathFactory) -> Done:
    """In sweeps on every kernel."""
    folder = tmp_path_factory.mktemp("swept")
    for name in SWEPT:
        data = studied(CASES[name])
        ((parameter, entry),) = data["parameters"].items()
        data["measures"] = {"most": {"max": CASES[name].output}}
        values = [0.9 * entry["value"], entry["value"], 1.1 * entry["value"]]
        for kernel in KERNELS:
            data["studies"]["sweep"] = {"vary": {parameter: values}, "kernel": kernel}
            (folder / file(f"{kernel} {name}")).write_text(json.dumps(data), encoding="utf-8")
    return Done(folder)


@pytest.fixture(scope="module")
def followed() -> dict[str, tuple[Oracle, Array, list[State]]]:
    """Each mechanism's oracle, and its states at some times of the cycle."""
    found, t = {}, np.linspace(0.0, 2.5, 21)
    for name, case in CASES.items():
        oracle = case.oracle()
        found[name] = oracle, t, oracle.follow(t)
    return found


Followed = dict[str, tuple[Oracle, Array, list[State]]]


def columns(done: Done, name: str, which: str) -> dict[str, Array]:
    """The columns of a table of a run without their units, in SI."""
    degree = np.pi / 180
    sizes = UNITS | {"mm/s": 1e-3, "mm/s^2": 1e-3, "deg/s": degree, "deg/s^2": degree, "deg/mm": 1e3 * degree}
    found = {}
    done.run(name)
    for head, values in table(done.folder / (file(name) + "_run") / which)[0].items():
        text, unit = re.fullmatch(r"(.*?)(?: \[(.*)\])?", head).groups()  # type: ignore[union-attr]
        if unit is None or unit in sizes or unit in ("W", "J"):
            found[text] = values * sizes.get(unit or "", 1.0)
    return found


@pytest.mark.parametrize("name", CASES)
def test_it_closes_and_is_proven(name: str, done: Done, followed: Followed) -> None:
    """Poses and rates as raw geometry has them, angles over all turns."""
    code, _, err = done.run(name)
    assert code == 0, err
    oracle, t, states = followed[name]
    own = columns(done, name, "cycle.csv")
    at = np.rint(t / own["t"][1]).astype(int)
    orders = {"angle": expected_angles(oracle, states), **expected_motion(oracle, states)}
    for order, rows in orders.items():
        for row, values in rows.items():
            if row in own:
                limit = {"velocity": 1e-8, "acceleration": 1e-7}.get(order, 1e-11)  # of rates there are differences
                assert own[row][at] == pytest.approx(values, rel=0, abs=limit * max(1.0, np.abs(values).max())), row


@pytest.mark.parametrize("name", CASES)
def test_reactions_are_those_of_newton_and_euler(name: str, done: Done, followed: Followed) -> None:
    oracle, t, states = followed[name]
    own = columns(done, name, "cycle.csv")
    at = np.rint(t / own["t"][1]).astype(int)
    rows = expected_forces(oracle, states)
    rows |= {key.rsplit(",", 1)[0] + ")" + key[key.rindex(")") + 1 :]: row for key, row in rows.items() if "(" in key}
    compared = [row for row in rows if row in own]
    assert sum("force(" in row for row in compared) >= 4
    scale = max(float(np.abs(rows[row]).max()) for row in compared)
    for row in compared:
        assert own[row][at] == pytest.approx(rows[row], rel=0, abs=1e-7 * scale), row
    case, results = CASES[name], [oracle.forces(state) for state in states]
    for link in case.data["joints"][case.joint][kind(case)]:
        if link == "frame":
            continue
        force = np.array([result.reactions[case.joint, link] for result in results])  # on the link, about its origin
        for key, sign in own_reactions(own, link, case):
            assert sign * own[key][at] == pytest.approx(force[:, "xy".index(key[-1])], rel=0, abs=1e-7 * scale), key


def kind(case: Case) -> str:
    return next(name for name in WRONG if name in case.data["joints"][case.joint])


def own_reactions(own: Mapping[str, Array], link: str, case: Case) -> list[tuple[str, float]]:
    """The reported components of a link's reaction in the joint; the force on it is the opposite."""
    links = case.data["joints"][case.joint][kind(case)]
    others = [case.joint] if len(links) > 2 else [other for other in links if other != link]
    ways = [(link, other, -1.0) for other in others] + [(other, link, 1.0) for other in others]
    keys = [
        (f"force({first}, {second}{joint}).{axis}", sign)
        for axis in "xy"
        for first, second, sign in ways
        for joint in ("", f", {case.joint}")
    ]
    found = [(key, sign) for key, sign in keys if key in own]
    assert found
    return found[:2]


@pytest.mark.parametrize("name", FEW)
def test_a_wrong_sign_fails_the_certificate(name: str, wrong: Done) -> None:
    code, out, err = wrong.run(name)
    assert code == 1, out
    assert "[motion.unproven]" in err


HEADED = [(f"{link}.angle", f"{link}.heading") for link in ("bodies[link]", "a", "b", "c")]
"""Takes directions in place of angles."""


@pytest.mark.parametrize(
    "changes",
    [(), [("    phased = True\n", "")], HEADED],
    ids=["in what it fixes", "in its closure", "in its signal"],
)
def test_a_kind_that_asks_angles_without_saying_so_is_told_by_name(changes: Any, tmp_path: Path) -> None:
    planted(tmp_path, "gear_on_carrier", ("    winds = True\n", ""), *changes)
    (tmp_path / "model.yaml").write_text(json.dumps(studied(GEARS["on a link of a dyad"])), encoding="utf-8")
    done = linkwright(tmp_path, "run", "model.yaml", "--out", "out")
    assert done.returncode == 2, done.stderr
    assert "joints.mesh: This kind of joint, gears on a carrier, needs the continuous angle" in done.stderr
    assert "winds = True" in done.stderr


@pytest.mark.parametrize("name", CASES)
def test_accuracy_has_the_derivatives_of_raw_geometry(name: str, done: Done, followed: Followed) -> None:
    """By the kind's own dimension, and by play across where it has any."""
    case, (oracle, t, states) = CASES[name], followed[name]
    own = columns(done, name, "accuracy_bands.csv")
    at = np.rint(t / own["t"][1]).astype(int)
    (parameter,) = case.data["parameters"]
    by = own[f"d({case.output})/d({parameter})"]
    link = case.output.split(".")[0]

    def differences(step: float, **by: float) -> Array:
        angles = []
        for sign in (1.0, -1.0):
            moved = case.moved(**{key: sign * value for key, value in by.items()})
            other = Oracle.__new__(Oracle)
            other.__dict__ |= {**oracle.__dict__, "gaps": {case.joint: moved}}
            angles.append([other.pose(other.settle(state.q, state.t).q, link)[2] for state in states])
        return (np.array(angles[0]) - np.array(angles[1])) / (2 * step)

    step = 1e-6 if parameter == "h" else 1e-5
    expected = differences(step, **{parameter: step})
    assert by[at] == pytest.approx(expected, rel=1e-6, abs=1e-7 * np.abs(expected).max())
    if case in WAVES.values():
        expected = -1e-3 * CLEARANCE * differences(1e-6, off=1e-6)  # the wave can only push: the point lies below
        assert own[f"{case.output} play shift"][at] == pytest.approx(expected, rel=1e-6, abs=1e-12)
        assert own[f"{case.output} play bound"] == pytest.approx(np.abs(own[f"{case.output} play shift"]), rel=1e-12)


def test_a_kind_without_play_is_refused_by_name(done: Done) -> None:
    code, _, err = done["check", "played.yaml"]
    assert code == 2
    assert "clearance.no-play" in err
    assert "mesh" in err
    assert "gears on a carrier" in err


@pytest.mark.parametrize("name", CASES)
def test_modes_and_limits_are_answered(name: str, done: Done) -> None:
    for word in ("modes", "limits"):
        code, out, err = done[word, file(name)]
        assert code == 0, err
        assert ("Assembly modes found" if word == "modes" else "Ranges") in out


@pytest.mark.parametrize("name", FEW)
@pytest.mark.parametrize("target", TARGETS)
def test_exports_answer_or_refuse_by_name(name: str, target: str, done: Done) -> None:
    code, _, err = done["export", file(name), "--to", target]
    case = CASES[name]
    if target == "mjcf":
        assert code == 2
        assert "[export.joint]" in err
        assert case.joint in err
    elif target == "process-simulate":
        several = len(case.data["drives"]) > 1
        assert code == (2 if several else 1)
        assert ("[functions.drives]" if several else "[functions.no-closed-form]") in err
    else:
        assert code == 0, err


@pytest.mark.parametrize("name", CASES)
def test_the_report_draws_it(name: str, done: Done) -> None:
    done.run(name)
    text = (done.folder / (file(name) + "_run") / "report.html").read_text(encoding="utf-8")
    recorded, live = r'"outlines":\s*\[\[\[', r'"outlines":\s*\[\{'
    assert len(re.findall(recorded, text)) == CASES[name].symbols
    assert len(re.findall(live, text)) == 1  # the page computes them, too
    assert ("pin on a wave" if "wave" in name else "gears on a carrier") in done["check", file(name)][1]


def test_structures_stand_on_gears_whose_mesh_is_known(done: Done) -> None:
    """The moment of the load at the planet goes over both meshes, of which the arm feels the difference: at the rod 5 N
    less 400 N mm/60 mm."""
    code, out, err = done["run", "drawn.yaml", "--out", "drawn"]
    assert code == 0, err
    bars = dict(re.findall(r"^(arm|rod) +(-?[\d.]+)", out, re.MULTILINE))
    assert "arm" not in bars  # both meshes turn it: it bears more than a force along its pins
    assert re.search(r"^P +force\(arm, P\)\.x +-10 ", out, re.MULTILINE)
    assert float(bars["rod"]) == pytest.approx(5 - 400 / 60, rel=1e-6)
    code, _, err = done["run", "vague.yaml", "--out", "vague"]
    assert code == 2
    assert "[reactions.phased]" in err
    assert "gears on a carrier" in err


def test_the_schema_has_both(done: Done) -> None:
    code, out, _ = done[("schema",)]
    assert code == 0
    assert {*WRONG} <= {*re.findall(r'"(\w+)"', out)}


@pytest.mark.parametrize("name", [SWEPT[0], pytest.param(SWEPT[1], marks=pytest.mark.long)])
def test_all_kernels_sweep_it(name: str, swept: Done) -> None:
    found = {}
    for kernel in KERNELS:
        if KERNELS[kernel].available():
            code, _, err = swept.run(f"{kernel} {name}")
            assert code == 0, err
            folder = swept.folder / (file(f"{kernel} {name}") + "_run")
            found[kernel] = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["sweep"]
    values = {kernel: numbers(entry) for kernel, entry in found.items()}
    for kernel in values:
        assert values[kernel] == pytest.approx(values["numpy"], rel=1e-9, abs=1e-9), kernel


def test_the_mesh_is_that_of_the_drawing_in_all_samples(tmp_path: Path) -> None:
    """Of a coupler of another length the gears have the teeth in which they mesh at the nominal one: the wheel starts
    elsewhere, by half of what the follower does. A file with that length is another drawing."""
    data = studied(GEARS["on a link of a dyad"], accuracy={"outputs": ["wheel.angle"], "poses": 20, "samples": 0})
    data["parameters"] = {"z": 2, "l": {"value": 65, "tolerance": 0.5}}
    data["links"]["coupler"]["points"]["C"] = ["l", 0]
    data["measures"] = {"most": {"max": "wheel.angle"}}  # it turns the other way: where it starts
    lengths = np.array([62.0, 65.0, 68.0])
    data["studies"]["sweep"] = {"vary": {"l": lengths.tolist()}}
    (tmp_path / "model.yaml").write_text(json.dumps(data), encoding="utf-8")
    assert linkwright(tmp_path, "run", "model.yaml", "--out", "out").returncode == 0
    follower = [dyad((0.02, 0.0), (0.06, 0.0), 0.07, 1e-3 * length)[0] for length in (*lengths, 64.999, 65.001)]
    swept = np.genfromtxt(tmp_path / "out" / "sweep.csv", delimiter=",", names=True, encoding="utf-8-sig")
    start = np.radians(swept["most_deg"])
    assert start == pytest.approx(-(np.array(follower[:3]) - follower[1]) / 2, abs=1e-12)
    bands, _ = table(tmp_path / "out" / "accuracy_bands.csv")
    slope = next(values for head, values in bands.items() if head.startswith("d(wheel.angle)/d(l)"))[0]
    assert np.radians(slope) == pytest.approx(-(follower[4] - follower[3]) / 2 / 0.002, rel=1e-6)
    data["links"]["coupler"]["points"]["C"] = [62, 0]
    data["studies"] = {"cycle": data["studies"]["cycle"]}
    (tmp_path / "model.yaml").write_text(json.dumps(data), encoding="utf-8")
    assert linkwright(tmp_path, "run", "model.yaml", "--out", "alone").returncode == 0
    alone = json.loads((tmp_path / "alone" / "summary.json").read_text(encoding="utf-8"))
    assert alone["measures"]["most"]["value"] == pytest.approx(0.0, abs=1e-9)


def numbers(entry: Any) -> list[float]:
    """All numbers of what a summary has of figures."""
    if isinstance(entry, dict):
        return [n for key, part in entry.items() if key not in ("seconds", "kernel") for n in numbers(part)]
    if isinstance(entry, list):
        return [n for part in entry for n in numbers(part)]
    return [float(entry)] if isinstance(entry, int | float) and not isinstance(entry, bool) else []
