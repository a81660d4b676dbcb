"""Mistakes of beginners, English and Chinese: each answer has the code that fits and says what to write.

Every mistake is one change of a sound file; nothing else may be found in it.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from linkwright.app import check, examine_alone

SOUND = """\
linkwright: 1
name: Crank-rocker
units: {length: mm, angle: deg, mass: kg, time: s, force: N, torque: N*m}
gravity: earth
parameters:
  AB: 60
  BC: 190
  CD: 120
links:
  frame:   {points: {A: [0, 0], D: [200, 0]}}
  crank:   {points: {A: [0, 0], B: [AB, 0]}, mass: 0.4, shape: rod A-B}
  rod:     {points: {B: [0, 0], C: [BC, 0]}, mass: 0.8, shape: rod B-C}
  rocker:  {points: {D: [0, 0], C: [CD, 0]}, mass: 1.5, shape: rod D-C}
assembly: {C: left of B-D}
drives:
  motor: {turns: crank, on: frame, speed: 60 rpm, start: 0 deg}
loads:
  fluid: {on: rocker, torque: -3}
measures:
  swing: {span: rocker.angle}
  torque: {extremes: motor.torque}
require:
  swing: ">= 60 deg"
studies:
  cycle: {turns: 1 motor, samples: 36}
"""

MISTAKES = [
    # Words of other programs, of books, of Chinese.
    ("on: frame", "on: ground", "name.unknown", "'frame'"),
    ("on: frame", "on: base", "name.unknown", "'frame'"),
    ("on: frame", "on: 机架", "name.unknown", "'frame'"),
    ("  frame:", "  ground:", "model.no-frame", "Rename 'ground' to 'frame'"),
    ("  frame:", "  机架:", "model.no-frame", "Rename '机架' to 'frame'"),
    ("turns: crank", "rotates: crank", "file.unknown-key", "'turns'"),
    ("speed: 60 rpm", "omega: 60 rpm", "file.unknown-key", "'speed'"),
    ("speed: 60 rpm", "转速: 60 rpm", "file.unknown-key", "'speed'"),
    ("start: 0 deg", "initial: 0 deg", "file.unknown-key", "'start'"),
    ("links:", "bodies:", "file.unknown-key", "'links'"),
    ("links:", "Links:", "file.unknown-key", "'links'"),
    ("links:", "构件:", "file.unknown-key", "'links'"),
    ("drives:", "drive:", "file.unknown-key", "'drives'"),
    ("drives:", "motors:", "element.motor", "drives"),
    ("require:", "requirements:", "file.unknown-key", "'require'"),
    ("torque: -3", "moment: -3", "file.unknown-key", "'torque'"),
    ("fluid: {on: rocker", "fluid: {link: rocker", "file.unknown-key", "'on'"),
    ("extremes: motor.torque", "maximum: motor.torque", "file.unknown-key", "'max'"),
    ("  cycle:", "  kinematics:", "study.unknown", "'cycle'"),
    ("samples: 36", "points: 36", "file.unknown-key", "'samples'"),
    ("linkwright: 1", "linkwright: 1\njoints: {B: {type: hinge, links: [crank, rod]}}", "element.pin", "same name"),
    ("linkwright: 1", "linkwright: 1\njoints: {g: {slider: [frame, rod]}}", "element.slide", "prismatic"),
    ("linkwright: 1", "linkwright: 1\njoints: {g: {Prismatic: [frame, rod]}}", "file.unknown-key", "'prismatic'"),
    ("linkwright: 1", "linkwright: 1\njoints: {B: {类型: 转动副}}", "file.kind", "'revolute'"),
    ("linkwright: 1", "linkwright: 1\nsprings: {s: {from: A, to: C, k: 3}}", "file.unknown-key", "'stiffness'"),
    # Misspelled names.
    ("turns: crank", "turns: Crank", "name.unknown", "'crank'"),
    ("on: rocker", "on: rokcer", "name.unknown", "'rocker'"),
    ("span: rocker.angle", "span: rocker.theta", "signal.no-attribute", "'angle'"),
    ("span: rocker.angle", "max: C.speed", "signal.no-attribute", "vx, vy"),
    ("span: rocker.angle", "max: C", "signal.element", "C.x, C.y"),
    ("motor.torque", "torque(motor)", "signal.unknown", "'motor.torque'"),
    ("motor.torque", "motor torque", "expression.respelled", "'motor.torque'"),
    ('swing: ">=', 'swings: ">=', "name.unknown", "'swing'"),
    ("length: mm", "lenght: mm", "file.unknown-key", "'length'"),
    ("length: mm", "length: millimeters", "units.wrong", "mm"),
    ("BC: 190", "BC: AB*PI", "name.unknown-parameter", "'pi'"),
    ("BC: 190", "BC: AB*arctan(30)/10", "expression.unknown-function", "atan"),
    ("  rod: ", "  coupler-1: ", "file.bad-name", "coupler_1"),
    # Numbers and expressions.
    ("BC: 190", "BC: 190,5", "expression.respelled", "'190.5'"),
    ("mass: 0.4", "mass: 0,4", "file.decimal-comma", "0.4"),
    ("D: [200, 0]", "D: [200,5, 0]", "file.decimal-comma", "200.5"),
    ("BC: 190", "BC: 2AB", "expression.respelled", "'2*AB'"),
    ("BC: 190", "BC: 3(AB+1)", "expression.respelled", "'3*(AB+1)'"),
    ("BC: 190", "BC: 190 ± 0.1", "expression.respelled", "{value: 190, tolerance: 0.1}"),
    ("BC: 190", "BC: =AB*3", "expression.respelled", "'AB*3'"),
    ("60 rpm", "45 1/min", "expression.respelled", "'45 rpm'"),
    ("60 rpm", "45/min", "expression.respelled", "'45 rpm'"),
    ("60 rpm", "45 U/min", "expression.respelled", "'45 rpm'"),
    ("60 rpm", "45 RPM", "expression.respelled", "'45 rpm'"),
    ("60 rpm", "45转/分", "expression.respelled", "'45 rpm'"),
    ("60 rpm", "60 rpm clockwise", "expression.respelled", "'-60 rpm'"),
    ("60 rpm", "360 deg/sec", "expression.respelled", "'360 deg/s'"),
    ("60 rpm", "1 Hz", "expression.hertz", "rpm"),
    ("AB: 60", "AB: 60毫米", "expression.respelled", "'60 mm'"),
    # The keyboard.
    ("AB: 60", "AB：60", "file.wide", "'AB: 60'"),
    ("[AB, 0]", "[AB，0]", "file.wide", "[AB, 0]"),
    ("[AB, 0]", "【AB, 0】", "file.wide", "[AB, 0]"),
    ("BC: 190", "BC: （AB＋CD）", "file.wide", "(AB+CD)"),
    ("BC: 190", "BC: １９０", "file.wide", "190"),
    ('">= 60 deg"', "“>= 60 deg”", "file.wide", '">= 60 deg"'),
    ("  AB: 60", "  AB:60", "file.colon", "'AB: 60'"),
    ("  AB: 60", "  AB = 60", "file.equals", "'AB: 60'"),
    ("  AB: 60", "\tAB: 60", "file.tab", "spaces"),
    # Forms.
    ("gravity: earth", "gravity: 9.81", "file.expected", "[0, -9.81 m/s^2]"),
    ("shape: rod A-B", "shape: bar A-B", "file.expected", "'rod A-B'"),
    ("left of B-D", "left of B D", "file.expected", "'left of B-D'"),
    ("left of B-D", "upper", "file.expected", "left of B-D"),
    ('">= 60 deg"', "≥ 60 deg", "file.expected", "'>= 60 deg'"),
    ('">= 60 deg"', "60~80 deg", "file.expected", "'60 .. 80 deg'"),
    ('">= 60 deg"', "60 deg", "file.expected", "'>= 60 deg' or '<= 60 deg'"),
    ('">= 60 deg"', ">= 60 deg", "file.quote", "double quotes"),
    ("B: [AB, 0]", "B: {x: AB, y: 0}", "file.expected", "[AB, 0]"),
    ("swing: {span: rocker.angle}", "swing: rocker.angle", "file.expected", "{span: rocker.angle}"),
    ("motor: {turns: crank, on: frame, speed: 60 rpm, start: 0 deg}", "motor: crank", "file.expected", "turns: crank"),
    ("turns: 1 motor", "turns: 1", "file.expected", "1 motor"),
    ("{turns: 1 motor, samples: 36}", "", "file.expected", "turns: 1 motor"),
    ("assembly: {C: left of B-D}\n", "", "assembly.missing", "C: left of B-D"),
]


@pytest.mark.parametrize(
    ("right", "wrong", "code", "says"), MISTAKES, ids=[f"{wrong!r}" for _, wrong, _, _ in MISTAKES]
)
def test_the_answer_says_what_to_write(right: str, wrong: str, code: str, says: str, tmp_path: Path) -> None:
    assert right in SOUND
    (path := tmp_path / "model.yaml").write_text(SOUND.replace(right, wrong, 1), encoding="utf-8")
    found = [finding for finding in check(path) if finding.severity == "error"]
    assert code in [finding.code for finding in found]
    assert says in next(finding.mend for finding in found if finding.code == code)
    assert len(found) == 1 or {finding.line for finding in found} == {found[0].line}, found


def test_the_sound_file_is_sound(tmp_path: Path) -> None:
    (path := tmp_path / "model.yaml").write_text(SOUND)
    assert not [finding for finding in check(path) if finding.severity == "error"]


@pytest.mark.parametrize("study", ["sweep", "cam", "workspace", "accuracy"])
def test_a_command_whose_study_is_missing(study: str, tmp_path: Path) -> None:
    (path := tmp_path / "model.yaml").write_text(SOUND)
    assert examine_alone(path, study).findings[0].code == "study.missing"


def test_a_file_in_gbk(tmp_path: Path) -> None:
    (path := tmp_path / "model.yaml").write_bytes(SOUND.replace("Crank-rocker", "曲柄摇杆机构").encode("gbk"))
    (found,) = check(path)
    assert (found.code, found.severity) == ("file.read-as", "warning")
    assert "GBK" in found.what and "UTF-8" in found.mend
