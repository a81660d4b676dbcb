"""An explicit kind of joint of another package: a barrel cam by a motion law, alone, in a dyad's place, with several
drives, on a pin of three links; no other file changed."""

from __future__ import annotations

import json
from copy import deepcopy
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from elements.kinds_outside import body, drag_link, dyad
from helpers.expected import expected_forces
from helpers.newton_euler import Array, Oracle
from helpers.outside import linkwright, planted, table
from helpers.plain import plain_of

BASE: dict[str, Any] = {
    "linkwright": 1,
    "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
    "gravity": [0, -9810],
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
        "barrel": body({"O": [0, 0]}, 1, [0, 0], 200),
        "table": body({"A": [0, 0], "B": [50, 0]}, 2, [25, 4], 900),
    },
    "joints": {"step": {"indexer": ["table", "frame"], "motor": "motor", "law": "index", "phase": 4}},
    "drives": {"motor": {"turns": "barrel", "on": "frame", "speed": "60 rpm", "start": "6 deg"}},
    "measures": {"peak": {"max": "table.omega"}, "torque": {"max": "motor.torque"}},
    "studies": {"cycle": {"turns": "1 motor", "samples": 90}},
}


def changed(**sections: dict[str, Any]) -> dict[str, Any]:
    model = deepcopy(BASE)
    for section, entries in sections.items():
        model.setdefault(section, {}).update(entries)
    return model


ROCKER = {
    "coupler": body({"B": [0, 0], "C": [80, 0]}, 0.5, [40, -3], 400),
    "rocker": body({"D": [0, 0], "C": [60, 0]}, 0.4, [30, 2], 250),
}
MODELS = {
    "alone": changed(),
    "a dyad hangs on it": changed(
        links={**ROCKER, "frame": {"points": {"O": [0, 0], "A": [100, 0], "D": [180, 40]}}}, assembly={"C": [170, 90]}
    ),
    "a second drive": changed(
        links={"arm": body({"B": [0, 0], "E": [30, 0]}, 0.3, [15, 1], 60)},
        drives={"swing": {"turns": "arm", "on": "table", "speed": "20 rpm", "start": "5 deg"}},
    ),
    "three links on one pin": changed(
        links={
            "frame": {"points": {"O": [0, 0]}},
            "table": body({"O": [0, 0], "B": [50, 0]}, 2, [25, 4], 900),
        }
    ),
    "on a slide": changed(
        parameters={"h": {"value": "40 mm", "tolerance": "0.1 mm"}},
        laws={"index": {**BASE["laws"]["index"], "of": "length"}},
        links={"table": body({"G": [0, 0], "B": [50, 0]}, 2, [25, 4], 900)},
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


def cycloid(angle: Any) -> Any:
    """The lift over the greatest one at an angle of the motor (rad): up over half a turn, down over the other."""
    x = np.mod(angle, 2 * np.pi) / np.pi
    wave = np.sin(2 * np.pi * x) / (2 * np.pi)
    return np.where(x < 1, x - wave, 2 - x + wave)


def oracle(which: str, columns: dict[str, Any]) -> Oracle:
    """The mechanism from raw geometry; where its links lie at the start is read off the run, as a guess."""
    model = MODELS[which]
    joints = {name: joint for name, joint in model["joints"].items() if name != "step"}
    start = {}
    for link, entry in model["links"].items():
        if link != "frame":
            x, y = (columns[f"{next(iter(entry['points']))}.{axis} [mm]"][0] * 1e-3 for axis in "xy")
            start[link] = (x, y, float(np.radians(columns[f"{link}.angle [deg]"][0])))

    def gap(of: Oracle, q: Array) -> float:
        lift, table = float(cycloid(of.pose(q, "barrel")[2] + np.radians(4))), of.pose(q, "table")
        return float(table[1] - 0.04 * lift if "guide" in model["joints"] else table[2] - np.pi / 2 * lift)

    return Oracle(plain_of({**model, "joints": joints, "laws": {}, "parameters": {}}, start), gaps={"step": gap})


@pytest.mark.parametrize("which", MODELS)
def test_it_follows_with_the_forces_of_newton_and_euler(which: str, folder: Path) -> None:
    done = run(folder, MODELS[which])
    assert done.returncode == 0, done.stderr
    columns, t = table(folder / "out" / "cycle.csv")
    lift = cycloid(2 * np.pi * t + np.radians(10))
    name = "step.s [mm]" if which == "on a slide" else "step.angle [deg]"
    assert columns[name] == pytest.approx((40 if which == "on a slide" else 90) * lift, abs=1e-9)
    own, at = {head.split(" [")[0]: values for head, values in columns.items()}, slice(2, -1, 7)  # between the joins
    plain = oracle(which, columns)
    states = plain.follow(np.concatenate([[0.0], t[at]]))[1:]
    rows = expected_forces(plain, states)
    rows |= {key.rsplit(",", 1)[0] + ")" + key[key.rindex(")") + 1 :]: row for key, row in rows.items() if "(" in key}
    compared = {row: values for row, values in rows.items() if row in own and not row.endswith(".power")}
    assert {"motor.torque"} < compared.keys()
    scale = max(float(np.abs(values).max()) for values in compared.values())
    for row, values in compared.items():
        assert own[row][at] == pytest.approx(values, rel=0, abs=1e-7 * scale), row


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
    for study in (["sweep", "--kernel", "numpy"], ["sweep", "--kernel", "llvm"]):
        done = run(folder, model, study[0], "model.yaml", *study[1:], "--out", "".join(study))
        assert done.returncode == 0, (study, done.stderr)


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
    assert "joints.step: The law of step has no formula" in done.stderr
    assert "step," not in (folder / "motors" / "motors.csv").read_text(encoding="utf-8-sig")


@pytest.mark.parametrize("which", ["alone", "a dyad hangs on it", "on a slide"])
def test_its_formula_is_written_as_joint_functions(which: str, folder: Path) -> None:
    """Each is held to the motion, by the reader of the dialect."""
    words = ("--to", "process-simulate", "--out", "ps")
    done = run(folder, MODELS[which], "export", "model.yaml", *words)
    assert done.returncode == 0, done.stderr
    joint = "guide" if which == "on a slide" else "A"
    assert joint in (folder / "ps" / "joint_functions.txt").read_text(encoding="utf-8")
    asked = {**MODELS[which], "exports": {"process-simulate": {"master": joint}}}
    assert "[functions.master-cam]" in run(folder, asked, "export", "model.yaml", *words).stderr
    for tree in (
        "def other(",
        "def tree(self, geometry: Any, motor: Any) -> Any:\n        return motor\n\n    def other(",
    ):
        planted(folder, "indexer", ("    def tree(", f"    {tree}"), ("[self.tree(", "[self.other("))
        refused = run(folder, MODELS[which], "export", "model.yaml", *words)
        assert refused.returncode != 0
        assert "step (barrel cam)" in refused.stderr


def test_its_place_in_the_file_is_told(folder: Path) -> None:
    done = run(folder, MODELS["alone"], "export", "model.yaml", "--to", "mjcf", "--out", "mjcf")
    assert "joints: MuJoCo has no joint in which a link follows a drive: each follower (step)" in done.stderr
    done = run(
        folder,
        changed(drives={"second": {"turns": "table", "on": "frame", "speed": 1, "start": 0}}),
        "check",
        "model.yaml",
    )
    assert "joints.step" in done.stderr
    assert "drives.step" not in done.stderr


TOLD = """@property
    def extra(self) -> Any:
        return {"slope": u.ANGLE, "slip": u.SPEED}

    @property
    def pressures(self) -> Any:
        return ["slope"]

    def acting(self, name: str, poses: Any, ratio: Any) -> Any:
        made = super().acting(name, poses, ratio)
        return type(made)(made.wrenches, signals={"slope": 1.0 * ratio, "slip": 3.0 * ratio})

    def findings(self, run: Any, path: Any) -> Any:
        most = run.geometry.text_of(run.row(f"{path[1]}.slip")[1].max(), u.SPEED)
        yield Finding("indexer.slips", path, {"most": most}, severity="warning")

    def applied"""
"""Signals of a contact, one of them a pressure angle (rad) of at most 1, and what is told of a motion."""
WORDS = (
    '"indexer.joint.mend"',
    '"indexer.slips.what": "Slips by {most}.", "indexer.slips.mend": "-", "indexer.joint.mend"',
)


def test_its_contact_has_charts_and_findings(folder: Path) -> None:
    planted(folder, "indexer", ("def applied", TOLD), WORDS)
    done = run(folder, MODELS["alone"])
    assert done.returncode == 0, done.stderr
    assert "joints.step: Slips by 3000 mm/s." in done.stderr
    page = (folder / "out" / "report.html").read_text(encoding="utf-8")
    assert [f"Followers: {name}" in page for name in ("torque", "slope", "slip")] == [True] * 3
    assert "Cam contact force" not in page
    model = changed(loads={"brake": {"on": "table", "torque": "step.slip/(1 mm/s)*1 N*mm"}})
    assert "[load.signal]" in run(folder, model, "check", "model.yaml").stderr


def test_it_locks_where_its_pressure_angle_is_square(folder: Path) -> None:
    planted(folder, "indexer", ("def applied", TOLD.replace("1.0 * ratio", "2.0 * ratio")), WORDS)
    done = run(folder, MODELS["alone"])
    assert done.returncode == 1, done.stderr
    assert "joints.step: The link moved by step (barrel cam) locks" in done.stderr
    assert "[joint.locks]" in done.stderr


def test_a_contact_that_can_t_pull_lifts_off(folder: Path) -> None:
    entry = """description="where in the law it starts")

    @property
    def one_sided(self) -> Any:
        return {"torque": 1}
"""
    planted(folder, "indexer", ('description="where in the law it starts")\n', entry))
    done = run(folder, MODELS["alone"])
    assert done.returncode == 0, done.stderr
    assert "joints.step: The links of step (barrel cam) lift off each other" in done.stderr
    assert "[joint.lifts-off]" in done.stderr
    assert " N*m at t = " in done.stderr


def test_what_is_wrong_with_it_is_told(folder: Path) -> None:
    model = changed(joints={"step": {"indexer": ["barrel", "table"], "motor": "moter", "law": "indx"}})
    model["measures"]["turned"] = {"max": "step.angle"}
    done = run(folder, model, "check", "model.yaml")
    assert done.returncode == 2
    assert "measures.turned" not in done.stderr  # what is declared is known
    assert "moter" in done.stderr
    assert "indx" in done.stderr
    model["joints"]["step"].update(motor="motor", law="index")
    assert "barrel isn't joined to table by one joint" in run(folder, model, "check", "model.yaml").stderr
    model["joints"]["step"].update(indexer=["table", "frame"], phase="hh + 3 mm")
    assert "'hh'" in run(folder, model, "check", "model.yaml").stderr
    model["joints"]["step"]["phase"] = "3 mm"
    assert "joints.step.phase" in run(folder, model, "check", "model.yaml").stderr
    model["joints"]["step"]["phase"] = 0
    model["laws"]["index"] |= {"of": "length"}
    model["parameters"]["h"] = "3 mm"
    assert "[joint.follower-law]" in run(folder, model, "check", "model.yaml").stderr


def test_it_shares_no_name_with_a_cam(folder: Path) -> None:
    cam = {"cam": "barrel", "follower": "table", "on": "frame", "base": 60, "law": "index", "roller": 5, "at": "B"}
    done = run(folder, {**MODELS["alone"], "cams": {"step": cam}}, "check", "model.yaml")
    (told,) = [line for line in done.stderr.splitlines() if "joints.step" in line]
    assert "a cam" in told


def test_a_motor_whose_law_is_its_outputs_is_refused(folder: Path) -> None:
    model = deepcopy(MODELS["a dyad hangs on it"])
    model["drives"]["motor"]["output"] = "rocker"
    assert "[joint.follower-output]" in run(folder, model, "check", "model.yaml").stderr


# A kind whose parts meet where no motion law has a join.


def running_up(**how: Any) -> dict[str, Any]:
    joint = {"run_up": ["table", "frame"], "motor": "motor", "from": "begin", "over": "200 deg", **how}
    model = changed(joints={"step": joint}, parameters={"begin": {"value": "100 deg", "tolerance": "1 deg"}})
    del model["laws"], model["parameters"]["h"], model["gravity"]
    model["measures"] = {"peak": {"max": "table.alpha"}, "rms": {"rms": "table.alpha"}, "low": {"min": "step.torque"}}
    return model


def measured(folder: Path) -> dict[str, float]:
    summary = json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8"))
    return {name: one["value"] for name, one in summary["measures"].items()}


def test_a_join_of_its_own_is_a_break(folder: Path) -> None:
    """Its acceleration jumps at 94 of 360 degrees."""
    peak, rms = 2 * 360**2 / 200, 2 * 360**2 / 200 * (1 - 94 / 360) ** 0.5
    done = run(folder, running_up())
    assert done.returncode == 0, done.stderr
    assert "runs up from 100 deg on" in " ".join(run(folder, running_up(), "check", "model.yaml").stdout.split())
    found = measured(folder)
    assert (found["peak"], found["rms"], found["low"]) == pytest.approx((peak, rms, 0), rel=1e-12)
    assert '"outlines"' in (folder / "out" / "report.html").read_text(encoding="utf-8")


def test_derivatives_follow_a_join_of_its_own(folder: Path) -> None:
    """The mean square falls by a 360th of that of the peak for each degree by which the join comes later."""
    model = running_up()
    model["studies"]["accuracy"] = {"outputs": ["rms", "peak"]}
    fall = 1296 / 720 / (1 - 94 / 360) ** 0.5
    for known in (True, False):
        if not known:
            planted(folder, "run_up", ("def joins(", "def other("))
        done = run(folder, model, "accuracy", "model.yaml", "--out", f"out{known}", "--json", "--samples", "0")
        assert done.returncode == 0, done.stderr
        found = json.loads(done.stdout)["accuracy"]
        assert (found["rms"]["worst_case"]["deviation"] == pytest.approx([-fall, fall], rel=1e-8)) == known
        assert found["peak"]["worst_case"]["deviation"] == pytest.approx([0, 0], abs=1e-9)


def test_what_its_links_miss_is_part_of_the_closure(folder: Path) -> None:
    planted(folder, "run_up", ("y * np.cos(expected)", "1e-6 + y * np.cos(expected)"))
    done = run(folder, running_up())
    assert done.returncode == 1
    assert "motion.unproven" in done.stderr


def test_conditions_of_its_entry_are_told(folder: Path) -> None:
    done = run(folder, running_up(over="-200 deg"), "check", "model.yaml")
    assert "joints.step.over: The length of the run-up isn't positive." in done.stderr
    done = run(folder, running_up(run_up=["table", "barrel"]), "check", "model.yaml")
    assert "joints.step.run_up: It stands on barrel." in done.stderr


# Gears on a link that follows a drive.

SWING = {"over": "angle", "of": "angle", "segments": [{"rise": 30, "over": 180}, {"fall": 30, "over": 180}]}
ON = {"over": "angle", "of": "angle", "beyond": "advance", "segments": [{"rise": 90, "over": 360}]}
DISC = {"cam": "barrel", "follower": "table", "on": "follower", "base": 30, "roller": 8, "at": "R", "law": "index"}


def on_a_drag_link(law: dict[str, Any], **how: Any) -> dict[str, Any]:
    """A link that follows a motor on a link of a dyad, which turns on and on; gears hold a wheel on it."""
    data = deepcopy(drag_link())
    data["laws"] = {"index": {**law, "segments": [{"law": "cycloidal", **part} for part in law["segments"]]}}
    data["links"]["follower"]["points"] |= {"T": [60, 0]}
    data["links"] |= {
        "barrel": body({"D": [0, 0]}, 1, [0, 0], 200),
        "table": body({"T": [0, 0], "R": [-30, 20]}, 2, [25, 4], 900),
    }
    data["drives"]["spin"] = {"turns": "barrel", "on": "follower", "speed": "40 rpm", "start": 0}
    data["joints"]["mesh"] |= {"gear_on_carrier": ["table", "wheel", "frame"], "points": ["T", "W", "D"]}
    data["joints"] |= how.get("joints", {})
    data["cams"] = how.get("cams", {})
    data["studies"] = {"cycle": {"duration": "4 s", "samples": 300}}
    return data


GEARED = {
    "barrel cam": (ON, {"joints": {"step": {"indexer": ["table", "follower"], "motor": "spin", "law": "index"}}}),
    "plate cam": (SWING, {"cams": {"step": {**DISC, "side": "left of D-T"}}}),
}


@pytest.mark.parametrize("which", GEARED)
def test_gears_on_a_link_that_follows_keep_their_mesh_over_all_turns(which: str, folder: Path) -> None:
    law, how = GEARED[which]
    done = run(folder, on_a_drag_link(law, **how))
    assert done.returncode == 0, done.stderr
    columns, t = table(folder / "out" / "cycle.csv")
    own = {name: np.radians(columns[f"{name}.angle [deg]"]) for name in ("table", "wheel", "step")}
    crank = 2 * np.pi * t
    pins = zip(60 * np.cos(crank), 60 * np.sin(crank), strict=True)
    base = np.unwrap([dyad((20.0, 0.0), pin, 70.0, 65.0)[0] for pin in pins])
    assert base[-1] - base[0] == pytest.approx(8 * np.pi)
    assert own["table"] == pytest.approx(base + own["step"], abs=1e-11)
    assert own["wheel"] == pytest.approx(own["wheel"][0] - (own["table"] - own["table"][0]) / 2, abs=1e-11)
