"""Kinds of force elements of other packages, made known by entry points, with no other file changed: one with a table,
a jump and stored energy, and one in each section of files."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from helpers.newton_euler import Oracle, State
from helpers.outside import linkwright, planted, python, table, without_kinds
from helpers.plain import Law, Plain, PlainDrive, PlainLink, PlainSlide

MODEL: dict[str, Any] = {
    "linkwright": 1,
    "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
    "gravity": "earth",
    "links": {
        "frame": {"points": {"O": [0, 0], "S": [250, 15]}},
        "crank": {"points": {"O": [0, 0], "A": [60, 0]}, "mass": 0.8, "shape": "rod O-A"},
        "rod": {"points": {"A": [0, 0], "B": [160, 0]}, "mass": 1.2, "shape": "rod A-B"},
        "slider": {"points": {"B": [0, 0]}, "mass": 2, "com": [0, 0], "inertia": "0.001 kg*m^2"},
    },
    "parameters": {"gap": {"value": "60 mm", "tolerance": "0.5 mm"}, "preload": {"value": "50 N", "tolerance": "1 N"}},
    "joints": {"guide": {"prismatic": ["frame", "slider"], "line": ["O at 0 deg", "B at 0 deg"]}},
    "assembly": {"B": "ahead of A along guide"},
    "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "20 deg"}},
    "tables": {
        "rubber": {
            "points": [["20 mm", "-300 N"], ["60 mm", "-40 N"], ["100 mm", "-10 N"], ["200 mm", "0 N"]],
            "between": "linear",
        }
    },
    "springs": {"stop": {"bump_stop": ["B", "S"], "table": "rubber", "gap": "gap", "preload": "preload"}},
    "windows": {"near": {"stop.distance": ["40 mm", "62 mm"]}},
    "measures": {
        "mean": {"mean": "stop.push"},
        "most": {"max": "stop.push"},
        "sides": {"extremes": "stop.push + 8 N/mm*stop.distance", "window": "near"},
    },
    "studies": {
        "cycle": {"period": "1 s", "samples": 60},
        "sweep": {"vary": {"gap": [58, 60, 63], "preload": [0, 50]}, "outputs": ["mean", "most", "motor.torque"]},
        "accuracy": {"outputs": ["mean", "most"], "samples": 200, "seed": 1},
    },
}
"""A slider-crank whose slider runs against a stop of rubber before its outer dead centre."""
GAP, PRELOAD = 0.06, 50.0


def push(distance: Any, gap: float = GAP, preload: float = PRELOAD) -> Any:
    """The stop's push (N) at a distance (m)."""
    table = np.interp(distance, [0.02, 0.06, 0.1, 0.2], [300.0, 40.0, 10.0, 0.0])
    return table + np.where(np.asarray(distance) < gap, preload, 0.0)


def distance(t: Any) -> Any:
    """From the slider to the stop (m), by the slider-crank's own closed form."""
    angle = np.radians(20) + 2 * np.pi * np.asarray(t)
    x = 0.06 * np.cos(angle) + np.sqrt(0.16**2 - (0.06 * np.sin(angle)) ** 2)
    return np.hypot(0.25 - x, 0.015)


def mean(gap: float = GAP, preload: float = PRELOAD) -> float:
    """The mean push over a turn, by quadrature between the places at which the law changes."""
    t = np.linspace(0.0, 1.0, 400)
    levels = (0.06, 0.1, gap)
    cuts = [
        brentq(lambda at, d=d: float(distance(at)) - d, a, b)  # type: ignore[misc]
        for d in levels
        for a, b in pairwise(t)
        if (distance(a) - d) * (distance(b) - d) < 0
    ]
    edges = [0.0, *sorted(cuts), 1.0]
    ways = [(a, b) for a, b in pairwise(edges) if b > a]
    return sum(quad(lambda at: float(push(distance(at), gap, preload)), a, b, epsabs=1e-12)[0] for a, b in ways)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write(tmp_path, MODEL)
    return tmp_path


def write(folder: Path, model: dict[str, Any]) -> None:
    (folder / "model.yaml").write_text(json.dumps(model), encoding="utf-8")


def without(*studies: str) -> dict[str, Any]:
    return {**MODEL, "studies": {name: MODEL["studies"][name] for name in MODEL["studies"] if name not in studies}}


def oracle() -> Oracle:
    links = {
        "frame": PlainLink({"O": (0.0, 0.0), "S": (0.25, 0.015)}),
        "crank": PlainLink({"O": (0.0, 0.0), "A": (0.06, 0.0)}, 0.8, shape=("rod", "O", "A")),
        "rod": PlainLink({"A": (0.0, 0.0), "B": (0.16, 0.0)}, 1.2, shape=("rod", "A", "B")),
        "slider": PlainLink({"B": (0.0, 0.0)}, 2.0, (0.0, 0.0), 0.001),
    }
    pins = {
        "O": (("frame", "O"), ("crank", "O")),
        "A": (("crank", "A"), ("rod", "A")),
        "B": (("rod", "B"), ("slider", "B")),
    }
    slides = {"guide": PlainSlide(("frame", "slider"), ("O", "B"), (0.0, 0.0))}
    drives = {"motor": PlainDrive("turns", "crank", "frame", Law(np.radians(20), 2 * np.pi))}
    angle = float(np.radians(20))
    a = 0.06 * np.array([np.cos(angle), np.sin(angle)])
    tilt = -np.arcsin(a[1] / 0.16)
    start = {
        "crank": (0.0, 0.0, angle),
        "rod": (float(a[0]), float(a[1]), float(tilt)),
        "slider": (float(a[0] + 0.16 * np.cos(tilt)), 0.0, 0.0),
    }

    def stop(oracle: Oracle, state: State) -> list[tuple[str, Any, Any, float]]:
        at, end = oracle.point(state.q, "rod", "B"), np.array([0.25, 0.015])
        away = at - end
        force = push(np.hypot(*away)) * away / np.hypot(*away)
        return [("rod", force, at, 0.0), ("frame", -force, end, 0.0)]

    return Oracle(Plain(links, pins, slides, drives, start, gravity=(0.0, -9.80665)), [stop])


def test_it_runs_and_acts_as_the_oracle_has_it(folder: Path) -> None:
    """Efforts, reactions and shaking by the full equations of Newton and Euler with the stop's force from places alone;
    the push and its energy by differences."""
    write(folder, without("sweep", "accuracy"))
    done = linkwright(folder, "run", "model.yaml", "--out", "out", "--json")
    assert done.returncode == 0, done.stderr
    columns, t = table(folder / "out" / "cycle.csv")
    newton_euler = oracle()
    found = [newton_euler.forces(state) for state in newton_euler.follow(t)]
    reactions = {
        "motor.torque [N*m]": [one.efforts["motor"] for one in found],
        "force(rod, slider).x [N]": [one.reactions["B", "slider"][0] for one in found],
        "force(rod, slider).y [N]": [one.reactions["B", "slider"][1] for one in found],
        "force(frame, crank).x [N]": [one.reactions["O", "crank"][0] for one in found],
        "force(frame, slider).y [N]": [one.reactions["guide", "slider"][1] for one in found],
        "shaking.x [N]": [one.shaking[0] for one in found],
        "shaking.moment [N*m]": [one.shaking[2] for one in found],
    }
    for name, values in reactions.items():
        assert columns[name] == pytest.approx(np.array(values), abs=1e-9), name
    assert columns["stop.distance [mm]"] == pytest.approx(1e3 * distance(t), abs=1e-10)
    assert columns["stop.push [N]"] == pytest.approx(push(distance(t)), abs=1e-9)
    from_zero = [quad(push, GAP, d, points=[0.1] if d > 0.1 else None)[0] for d in distance(t)]
    stored = columns["stop.energy [J]"]
    assert stored - stored[0] == pytest.approx(-(np.array(from_zero) - from_zero[0]), abs=1e-8)
    assert columns["energy.elastic [J]"] == pytest.approx(stored, abs=1e-12)
    proven = json.loads(done.stdout)["certificate"]
    assert max(proven[name] for name in ("closure", "equilibrium", "power", "work", "measures")) < 1e-9
    page = (folder / "out" / "report.html").read_text(encoding="utf-8")
    assert '{"name":"stop","links":["rod","frame"],"points":["B","S"],"look":"strut"}' in page
    assert "Forces of the bump stops (push positive)" in page


def test_its_jump_is_exact_on_both_sides(folder: Path) -> None:
    """At the gap the push jumps by the preload: the largest value is that within, the smallest that beyond."""
    write(folder, without("sweep", "accuracy"))
    done = linkwright(folder, "run", "model.yaml", "--out", "out", "--json")
    assert done.returncode == 0, done.stderr
    measures = json.loads(done.stdout)["measures"]
    assert measures["mean"]["value"] == pytest.approx(mean(), rel=1e-12)
    assert measures["most"]["value"] == pytest.approx(float(push(np.hypot(0.03, 0.015))), rel=1e-12)
    assert measures["sides"]["min"] == pytest.approx(520.0, rel=1e-13)
    assert measures["sides"]["max"] == pytest.approx(570.0, rel=1e-13)
    assert measures["sides"]["approached"].keys() == {"min", "max"}


def test_it_is_known_everywhere(folder: Path) -> None:
    write(folder, without("sweep", "accuracy"))
    checked = linkwright(folder, "check", "model.yaml")
    assert checked.returncode == 0, checked.stderr
    assert "a bump stop from B to S, pushes with" in " ".join(checked.stdout.split())
    assert "bump_stop" in linkwright(folder, "schema").stdout
    for command in ("limits", "modes"):
        done = linkwright(folder, command, "model.yaml")
        assert done.returncode == 0, done.stderr
    exported = linkwright(folder, "export", "model.yaml", "--to", "mjcf")
    assert exported.returncode == 0, exported.stderr
    assert "doesn't contain stop" in exported.stderr + exported.stdout  # MuJoCo's file lacks it, and says so
    assert "Traceback" not in checked.stderr + exported.stderr


@pytest.mark.parametrize(
    ("entry", "code"),
    [
        ({"bump_stop": ["B", "T"]}, "name.unknown"),
        ({"table": "rubbr"}, "expression.unknown-function"),
        ({"gap": "-1 mm"}, "value.too-small"),
        ({"gap": "60 N"}, "expression.units-conflict"),
        ({"length": [1, 2]}, "file.unknown-key"),
    ],
)
def test_what_is_wrong_with_it_is_told(folder: Path, entry: dict[str, Any], code: str) -> None:
    write(folder, {**without("sweep", "accuracy"), "springs": {"stop": {**MODEL["springs"]["stop"], **entry}}})
    done = linkwright(folder, "check", "model.yaml")
    assert done.returncode == 2
    assert code in done.stderr, done.stderr


@pytest.mark.parametrize(
    ("section", "entry", "keys"),
    [
        ("springs", {**MODEL["springs"]["stop"], "from": "B", "to": "S"}, "bump_stop, table, gap; from, to"),
        ("springs", {"inerter": "crank", "bump_stop": ["B", "S"]}, "bump_stop; inerter"),
        ("loads", {"on": "rod", "at": "B", "force": [1, 2], "drag": "rod"}, "drag; on, force"),
        ("loads", {"on": "rod", "force": [1, 2], "bump_stop": ["B", "S"]}, "bump_stop; on, force"),
        ("joints", {"pin_in_slot": ["rod", "crank"], "indexer": ["rod", "crank"]}, "pin_in_slot; indexer"),
    ],
)
def test_an_entry_of_several_kinds_is_told_which_keys_are_of_which(
    folder: Path, section: str, entry: dict[str, Any], keys: str
) -> None:
    write(folder, {**MODEL, section: {"both": entry}})
    told = linkwright(folder, "check", "model.yaml").stderr
    assert "[file.kinds]" in told
    assert f"keys of several: {keys}." in told
    assert "file.unknown-key" not in told


def test_its_name_is_taken(folder: Path) -> None:
    springs = {"crank": MODEL["springs"]["stop"]}
    write(folder, {**without("sweep", "accuracy"), "springs": springs, "measures": {}, "windows": {}})
    done = linkwright(folder, "check", "model.yaml")
    assert done.returncode == 2
    assert "name.taken" in done.stderr


SCRIPT = """
import json
import sys
import numpy as np
import linkwright as lw
from linkwright.kernels import KERNELS
from linkwright.kernels.parameter_batch import Varied
from linkwright.measures import measure_all
from linkwright.results import Run
from linkwright.studies.accuracy.derivatives import Derivatives
from linkwright.studies.accuracy.signal_sensitivities import Slopes
from linkwright.studies.batch_plan import Measuring
document = lw.load("model.yaml")
compiled = lw.compile(document)
run, names = Run(compiled, 0.0, 1.0, 60), ["gap", "preload"]
varied = Varied(compiled, names)
values = np.array([[0.058, 0.06, 0.063], [0.0, 50.0, 40.0]])
p, t = varied.parameters(values), np.linspace(0, 1, 41)
found = {}
for name in [name for name, kernel in KERNELS.items() if kernel.available() and name in (sys.argv[1:] or KERNELS)]:
    rows = varied.evaluate(["stop.push", "motor.torque", "stop.energy"], p, t, kernel=name)
    measured = Measuring(varied, run, kernel=name).evaluate(p).figures
    figures = {n: {label: f.values.tolist() for label, f in fs.items()} for n, fs in measured.items()}
    found[name] = {"rows": rows.tolist(), "figures": figures}
start = np.array([0.06, 50.0])
directions = varied.parameters(start[:, None] + np.eye(2)) - compiled.parameters[:, None]
derivatives = Derivatives(run, Slopes(run, directions))
slopes = {name: [d.sides[:, 0].tolist() for d in derivatives.of(name)] for name in ("mean", "most", "sides")}
alone = []
for gap, preload in values.T.tolist():
    one = lw.compile(document.replace(gap=f"{gap} m", preload=f"{preload} N"))
    alone.append({r.name: {f.label: f.value for f in r.found} for r in measure_all(Run(one, 0.0, 1.0, 60))[0]})
print(json.dumps({"kernels": found, "slopes": slopes, "alone": alone, "single": sorted(Measuring(varied, run).single)}))
"""


def test_many_samples_are_those_of_each_alone(folder: Path) -> None:
    """With a spline for a table, so that means are taken of all samples together, over the jump of each."""
    tables = {"rubber": {**MODEL["tables"]["rubber"], "between": "cubic"}}
    write(folder, {**without("cycle", "sweep", "accuracy"), "tables": tables})
    done = python(folder, "-c", SCRIPT, "numpy")
    assert done.returncode == 0, done.stderr
    told = json.loads(done.stdout)
    assert not told["single"]
    for found in told["kernels"].values():
        for i, alone in enumerate(told["alone"]):
            for name, figures in alone.items():
                values = {label: rows[i] for label, rows in found["figures"][name].items()}
                assert values == pytest.approx(figures, rel=1e-9), name


@pytest.mark.parametrize("kernels", [["numpy", "llvm"], pytest.param([], marks=pytest.mark.long)], ids=["two", "every"])
def test_many_samples_and_accuracies(folder: Path, kernels: list[str]) -> None:
    """Sweeps of the gap and the preload on kernels, and slopes, by the closed form and its differences."""
    write(folder, without("cycle", "sweep", "accuracy"))
    done = python(folder, "-c", SCRIPT, *kernels)
    assert done.returncode == 0, done.stderr
    told, t = json.loads(done.stdout), np.linspace(0, 1, 41)
    samples = [(0.058, 0.0), (0.06, 50.0), (0.063, 40.0)]
    assert {"numpy", "llvm"} <= told["kernels"].keys()
    first = np.array(told["kernels"]["numpy"]["rows"])
    assert first[0] == pytest.approx(np.array([push(distance(t), *one) for one in samples]), abs=1e-9)
    for found in told["kernels"].values():
        assert np.array(found["rows"]) == pytest.approx(first, abs=1e-9)
        assert found["figures"]["mean"][""] == pytest.approx([mean(*one) for one in samples], rel=1e-11)
        closest = float(np.hypot(0.03, 0.015))
        assert found["figures"]["most"][""] == pytest.approx([float(push(closest, *one)) for one in samples], rel=1e-11)
    steps = np.array([-2, -1, 1, 2]), np.array([1, -8, 8, -1]) / 12
    by_gap = sum(w * mean(GAP + 1e-4 * s) for s, w in zip(*steps, strict=True)) / 1e-4
    by_preload = sum(w * mean(GAP, PRELOAD + 1e-1 * s) for s, w in zip(*steps, strict=True)) / 1e-1
    assert told["slopes"]["mean"][0] == pytest.approx([by_gap, by_preload], rel=1e-7)
    assert told["slopes"]["most"][0] == pytest.approx([0.0, 1.0], abs=1e-9)
    # Both sides of the jump move with the gap as the expression goes there, and one of them with the preload.
    low, high = told["slopes"]["sides"]
    assert low == pytest.approx([8000 - 750, 0.0], rel=1e-7, abs=1e-9)
    assert high == pytest.approx([8000 - 6500, 1.0], rel=1e-7)


def test_sweeps_and_accuracies_run_from_the_file(folder: Path) -> None:
    done = linkwright(folder, "run", "model.yaml", "--out", "out", "--json")
    assert done.returncode == 0, done.stderr
    studies = json.loads(done.stdout)
    assert {"sweep", "accuracy"} <= studies.keys()
    assert (folder / "out" / "sweep.csv").exists()


WRONG = {
    "the push": ("away, x = end.minus(start).now", "away, x = start.minus(end).now"),
    "its size": ('push = call("where", distance.d[0] < gap', 'push = call("where", distance.d[0] > gap'),
    "the energy": ("integral=True) + pressed", "integral=True) - pressed"),
    "the reaction": (
        "yield a, Wrench(Pair(-force.x, -force.y), 0.0, start.now)",
        "yield a, Wrench(force, 0.0, start.now)",
    ),
    "the proof": ("force = push * (end - start)", "force = push * (start - end)"),
}


@pytest.mark.parametrize("what", WRONG)
def test_a_wrong_sign_fails_the_certificate(folder: Path, what: str) -> None:
    part = {"cycle": {"period": "0.6 s", "samples": 60}}  # over a whole turn no energy is left
    write(folder, {**MODEL, "studies": part})
    planted(folder, "bump_stop", WRONG[what])
    done = linkwright(folder, "run", "model.yaml", "--out", "out")
    assert done.returncode == 1, done.stdout
    assert "motion.unproven" in done.stderr


def test_an_entry_point_that_is_gone_leaves_the_kind_unknown(folder: Path) -> None:
    done = without_kinds(folder, "check", "model.yaml")
    assert done.returncode == 2
    assert "bump_stop" in done.stderr


THREE: dict[str, Any] = {
    "linkwright": 1,
    "units": MODEL["units"],
    "gravity": "earth",
    "links": {
        "frame": {"points": {"O": [0, 0], "D": [60, 0]}},
        "crank": {"points": {"O": [0, 0], "B": [150, 0]}, "mass": 0.8, "shape": "rod O-B"},
        "coupler": {"points": {"B": [0, 0], "C": [180, 0]}},
        "rocker": {"points": {"D": [0, 0], "C": [170, 0]}},
    },
    "assembly": {"C": "left of B-D"},
    "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": "20 deg"}},
    "loads": {
        "air": {
            "drag": "coupler",
            "at": "C",
            "coefficient": "(3 + sin(360 deg*t/(1 s)))*1 N*s/m",
            "turning": "0.02 N*m*s",
        }
    },
    "springs": {"fly": {"inerter": "rocker", "inertia": "0.01 kg*m^2"}},
    "counterweights": {"lead": {"ball": "coupler", "at": "C", "mass": 0.4}},
    "studies": {"cycle": {"period": "1.7 s", "samples": 60}},
}
"""A double crank that is braked, turns a wheel and carries a ball."""


def test_kinds_in_every_section(tmp_path: Path) -> None:
    """What the motor has to do is the power of all: rates of energies, and drag times speed, from reported rates."""
    write(tmp_path, THREE)
    done = linkwright(tmp_path, "run", "model.yaml", "--out", "out")
    assert done.returncode == 0, done.stderr
    of, t = table(tmp_path / "out" / "cycle.csv")
    omega, alpha = np.radians(of["rocker.omega [deg/s]"]), np.radians(of["rocker.alpha [deg/s^2]"])
    assert of["fly.moment [N*m]"] == pytest.approx(-0.01 * alpha, abs=1e-12)
    assert of["fly.wound [deg]"] - of["rocker.angle [deg]"] == pytest.approx(np.full(t.size, 360.0), abs=1e-9)
    assert np.ptp(of["fly.wound [deg]"]) > 500
    vx, vy, ax, ay = (1e-3 * of[f"C.{name}"] for name in ("vx [mm/s]", "vy [mm/s]", "ax [mm/s^2]", "ay [mm/s^2]"))
    braked = (3 + np.sin(2 * np.pi * t)) * (vx**2 + vy**2) + 0.02 * np.radians(of["coupler.omega [deg/s]"]) ** 2
    moved = 0.4 * (ax * vx + (ay + 9.80665) * vy) + 0.01 * alpha * omega
    crank = 0.8 * 9.80665 * 0.075 * np.cos(np.radians(20) + 2 * np.pi * t) * 2 * np.pi  # at constant speed
    assert of["motor.power [W]"] == pytest.approx(braked + moved + crank, abs=1e-9)


def test_a_ball_weighs_as_a_counterweight(tmp_path: Path) -> None:
    files = []
    for name, weight in (("ball", {"ball": "coupler"}), ("usual", {"on": "coupler"})):
        folder = tmp_path / name
        folder.mkdir()
        write(folder, {**THREE, "counterweights": {"lead": {**weight, "at": "C", "mass": 0.4}}})
        done = linkwright(folder, "run", "model.yaml", "--out", "out")
        assert done.returncode == 0, done.stderr
        files.append((folder / "out" / "cycle.csv").read_bytes())
    assert files[0] == files[1]


def test_a_mass_on_the_frame_means_nothing(tmp_path: Path) -> None:
    write(tmp_path, {**THREE, "counterweights": {"lead": {"ball": "frame", "at": "D", "mass": 0.4}}})
    done = linkwright(tmp_path, "check", "model.yaml")
    assert done.returncode == 2
    assert "counterweights.lead: The frame has a mass" in done.stderr


def test_elements_of_one_name_in_two_sections_are_two(tmp_path: Path) -> None:
    """A drag among the springs that has no value at times, beside a load of its name that always has one."""
    planted(tmp_path, "three_forces", ('section = "loads"', 'section = "springs"'))
    drag = {**THREE["loads"]["air"], "coefficient": "sqrt(0.5 - t/(1 s))*1 N*s/m"}
    write(tmp_path, {**THREE, "loads": {"air": {"on": "rocker", "torque": "1 N*m"}}, "springs": {"air": drag}})
    done = linkwright(tmp_path, "run", "model.yaml", "--out", "out")
    assert done.returncode == 1
    assert "springs.air: " in done.stderr
    assert "load.not-finite" in done.stderr


def test_what_has_whole_turns_counted_shares_no_name(tmp_path: Path) -> None:
    silent = [("def signals(", "def no_signals("), ("def effort(", "def no_effort(")]
    planted(tmp_path, "three_forces", *silent)
    write(tmp_path, {**THREE, "springs": {"crank": THREE["springs"]["fly"]}})
    done = linkwright(tmp_path, "check", "model.yaml")
    assert done.returncode == 2
    assert "name.taken" in done.stderr
