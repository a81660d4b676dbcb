"""An explicit kind of joint of another package: a barrel cam by a motion law, alone, in a dyad's place, with several
drives, on a pin of three links; no other file changed."""

from __future__ import annotations

import json
from copy import deepcopy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from helpers.outside import linkwright, planted, table

BASE: dict[str, Any] = {
    "linkwright": 1,
    "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
    "gravity": "earth",
    "parameters": {"h": {"value": "90 deg", "tolerance": "0.5 deg"}},
    "laws": {
        "index": {
            "over": "angle",
            "of": "angle",
            "beyond": "repeat",
            "segments": [
                {"rise": "h", "over": "180 deg", "law": "cycloidal"},
                {"fall": "h", "over": "180 deg", "law": "cycloidal"},
            ],
        }
    },
    "links": {
        "frame": {"points": {"O": [0, 0], "A": [100, 0]}},
        "barrel": {"points": {"O": [0, 0]}, "mass": 1, "shape": "disc 20 mm at O"},
        "table": {"points": {"A": [0, 0], "B": [50, 0]}, "mass": 2, "shape": "rod A-B"},
    },
    "joints": {"step": {"indexer": ["table", "frame"], "motor": "motor", "law": "index"}},
    "drives": {"motor": {"turns": "barrel", "on": "frame", "speed": "60 rpm", "start": "10 deg"}},
    "measures": {"peak": {"max": "table.omega"}, "torque": {"max": "motor.torque"}},
    "studies": {"cycle": {"turns": "1 motor", "samples": 90}},
}


def changed(**sections: dict[str, Any]) -> dict[str, Any]:
    model = deepcopy(BASE)
    for section, entries in sections.items():
        model.setdefault(section, {}).update(entries)
    return model


ROCKER = {
    "coupler": {"points": {"B": [0, 0], "C": [80, 0]}, "mass": 0.5, "shape": "rod B-C"},
    "rocker": {"points": {"D": [0, 0], "C": [60, 0]}, "mass": 0.4, "shape": "rod D-C"},
}
MODELS = {
    "alone": changed(),
    "a dyad hangs on it": changed(
        links={**ROCKER, "frame": {"points": {"O": [0, 0], "A": [100, 0], "D": [180, 40]}}}, assembly={"C": [170, 90]}
    ),
    "a second drive": changed(
        links={"arm": {"points": {"B": [0, 0], "E": [30, 0]}, "mass": 0.3, "shape": "rod B-E"}},
        drives={"swing": {"turns": "arm", "on": "table", "position": "40 deg*sin(360 deg*t/(1 s))"}},
    ),
    "three links on one pin": changed(
        links={
            "frame": {"points": {"O": [0, 0]}},
            "table": {"points": {"O": [0, 0], "B": [50, 0]}, "mass": 2, "shape": "rod O-B"},
        }
    ),
    "on a slide": changed(
        parameters={"h": {"value": "40 mm", "tolerance": "0.1 mm"}},
        laws={"index": {**BASE["laws"]["index"], "of": "length"}},
        links={"table": {"points": {"G": [0, 0], "B": [50, 0]}, "mass": 2, "shape": "rod G-B"}},
        joints={"guide": {"prismatic": ["frame", "table"], "line": ["A at 90 deg", "G at 90 deg"]}},
        measures={"peak": {"max": "step.v"}},
    ),
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path


def run(folder: Path, model: dict[str, Any], *words: str) -> Any:
    (folder / "model.yaml").write_text(json.dumps(model), encoding="utf-8")
    return linkwright(folder, *(words or ("run", "model.yaml", "--out", "out")))


@pytest.mark.parametrize("which", MODELS)
def test_it_follows_and_its_motor_gives_the_power(which: str, folder: Path) -> None:
    """The value is a cycloid's; what the drives give is the rate of the energy, from the reported places alone."""
    done = run(folder, MODELS[which])
    assert done.returncode == 0, done.stderr
    columns, t = table(folder / "out" / "cycle.csv")
    x = np.mod(2 * np.pi * t + np.radians(10), 2 * np.pi) / np.pi
    rise = np.where(x < 1, x - np.sin(2 * np.pi * x) / (2 * np.pi), 2 - x + np.sin(2 * np.pi * x) / (2 * np.pi))
    name = "step.s [mm]" if which == "on a slide" else "step.angle [deg]"
    assert columns[name] == pytest.approx((40 if which == "on a slide" else 90) * rise, abs=1e-9)
    energy = sum(energy_of(columns, link) for link in MODELS[which]["links"] if link != "frame")
    power = columns["motor.torque [N*m]"] * 2 * np.pi
    if "swing" in MODELS[which]["drives"]:
        power = power + columns["swing.torque [N*m]"] * np.radians(columns["swing.omega [deg/s]"])
    # Fourier: the motion is a smooth function of a whole turn.
    half = np.fft.rfft(energy[:-1])
    rate = np.fft.irfft(half * 2j * np.pi * np.arange(half.size), energy.size - 1)
    assert power[:-1] == pytest.approx(rate, abs=2e-2 * np.abs(rate).max())
    assert np.mean(np.abs(power[:-1] - rate)) < 4e-3 * np.abs(rate).max()


def energy_of(columns: dict[str, Any], link: str) -> Any:
    """Kinetic energy and weight of a link (J) by its reported centre and angular velocity."""
    mass, inertia = {
        "barrel": (1.0, 0.02**2 / 2), "table": (2.0, 2 * 0.05**2 / 12), "coupler": (0.5, 0.5 * 0.08**2 / 12),
        "rocker": (0.4, 0.4 * 0.06**2 / 12), "arm": (0.3, 0.3 * 0.03**2 / 12),
    }[link]  # fmt: skip
    y, vx, vy = (columns[f"com({link}).{axis}"] * 1e-3 for axis in ("y [mm]", "vx [mm/s]", "vy [mm/s]"))
    omega = np.radians(columns[f"{link}.omega [deg/s]"])
    return mass * (vx**2 + vy**2) / 2 + inertia * omega**2 / 2 + mass * 9.80665 * y


def test_it_is_known_everywhere(folder: Path) -> None:
    model = deepcopy(MODELS["a dyad hangs on it"])
    vary = {"h": {"uniform": ["80 deg", "90 deg"]}}
    model["studies"]["sweep"] = {"vary": vary, "samples": 40, "outputs": ["peak", "torque"]}
    model["studies"]["accuracy"] = {"outputs": ["peak", "table.angle"]}
    checked = run(folder, model, "check", "model.yaml")
    assert checked.returncode == 0, checked.stderr
    assert "table on frame, a follower of motor (barrel cam)" in " ".join(checked.stdout.split())
    assert "indexer" in run(folder, model, "schema").stdout
    for study in ("limits", "modes"):
        assert run(folder, model, study, "model.yaml").returncode == 0
    done = run(folder, model, "accuracy", "model.yaml", "--out", "accuracy", "--json", "--samples", "0")
    peak = json.loads(done.stdout)["accuracy"]["peak"]  # a cycloid's peak is 4 h a second
    assert (peak["nominal"], *peak["worst_case"]["deviation"]) == pytest.approx((360, -2, 2), abs=1e-9)
    for study in (["sweep", "--kernel", "numpy"], ["sweep", "--kernel", "numba"]):
        done = run(folder, model, study[0], "model.yaml", *study[1:], "--out", "".join(study))
        assert done.returncode == 0, (study, done.stderr)
    refused = run(folder, model, "export", "model.yaml", "--to", "process-simulate", "--out", "ps")
    assert refused.returncode != 0
    assert "step (barrel cam)" in refused.stderr + refused.stdout


def test_a_wrong_sign_in_its_action_fails_the_certificate(folder: Path) -> None:
    wrong = """def acting(self, name: str, poses: Any, ratio: Any) -> Any:
        return super().acting(name, poses, -ratio)

    def applied"""
    planted(folder, "indexer", ("def applied", wrong))
    done = run(folder, MODELS["a dyad hangs on it"])
    assert done.returncode == 1, done.stderr
    assert "motion.unproven" in done.stderr


def test_a_follower_without_a_formula_is_left_out_of_motor_expressions(folder: Path) -> None:
    planted(folder, "indexer", ("    def tree(", "    def other("))
    done = run(folder, MODELS["alone"], "export", "model.yaml", "--to", "motor-expressions", "--out", "motors")
    assert done.returncode == 0, done.stderr
    assert "The law of step has no formula" in done.stderr
    assert "step," not in (folder / "motors" / "motors.csv").read_text(encoding="utf-8-sig")


def test_what_is_wrong_with_it_is_told(folder: Path) -> None:
    model = changed(joints={"step": {"indexer": ["barrel", "table"], "motor": "moter", "law": "indx"}})
    done = run(folder, model, "check", "model.yaml")
    assert done.returncode == 2
    assert "moter" in done.stderr
    assert "indx" in done.stderr
    model["joints"]["step"].update(motor="motor", law="index")
    assert "barrel isn't joined to table by one joint" in run(folder, model, "check", "model.yaml").stderr
