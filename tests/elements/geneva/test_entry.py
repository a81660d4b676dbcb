"""What a file says of Geneva drives: what is refused, and with which numbers; mutated files; what exports and other
studies make of one."""

from __future__ import annotations

import io
import random
from pathlib import Path
from typing import Any

import pytest
from ruamel.yaml import YAML

import linkwright as lw
from elements.geneva.drives import model
from linkwright.compilation import examine
from linkwright.findings import Finding
from linkwright.model.document import Document, located, parse_document, read_document
from model.test_fuzz import every_one_survives, mutated

FILE = Path(__file__).parents[3] / "examples" / "geneva_drive.yaml"
TEXT = FILE.read_text(encoding="utf-8")
JOINT = "indexing: {geneva: [driver, table], centres: [O, Q], pins: [P], slots: n, arc: r - 15}"
assert JOINT in TEXT


def findings(text: str) -> list[Finding]:
    document, source = read_document(text.encode())
    return list(source.findings if document is None else located(examine(document, FILE.parent)[1], source))


REFUSED = {
    "a shock at entry": ("r: c*sin(180 deg/n) + off", "r: 60", "geneva.entry", "60 mm from O"),
    "a disc that is too large": ("arc: r - 15", "arc: 71", "geneva.arc", "29.2893 mm"),
    "a disc that is too small": ("arc: r - 15", "arc: 29", "geneva.arc", "70.7107 mm"),
    "a disc below nothing": ("arc: r - 15", "arc: -10", "geneva.arc", "-10 mm"),
    "an arc in degrees": ("arc: r - 15", "arc: 55 deg", "expression.units-conflict", "mm"),
    "half a slot": ("slots: n", "slots: 4.5", "geneva.slots", "from 3 to 100"),
    "two slots": ("slots: n", "slots: 2", "geneva.slots", "from 3 to 100"),
    "no slots": ("slots: n", "slots: 0", "geneva.slots", "from 3 to 100"),
    "slots below nothing": ("slots: n", "slots: -4", "geneva.slots", "from 3 to 100"),
    "a pin that isn't there": ("pins: [P]", "pins: [R]", "name.unknown-point", "O, P"),
    "no pins": ("pins: [P]", "pins: []", "file.expected", "[P1, P2]"),
    "a pin without a list": ("pins: [P]", "pins: P", "file.expected", "[P1, P2]"),
    "a pin twice": ("pins: [P]", "pins: [P, P]", "geneva.pins", "same time"),
    "a pin in the middle": ("pins: [P]", "pins: [O]", "geneva.entry", "0 mm from O"),
    "centres elsewhere": ("centres: [O, Q]", "centres: [P, Q]", "joint.carrier", "driver at P"),
    "a carrier that isn't there": ("arc: r - 15}", "arc: r - 15, carrier: arm}", "name.unknown", "driver"),
    "a carrier that is the wheel": ("arc: r - 15}", "arc: r - 15, carrier: table}", "joint.same-link", "table"),
    "the frame as wheel": ("[driver, table]", "[driver, frame]", "geneva.frame", "carrier: arm"),
    "a link that isn't there": ("[driver, table]", "[drive, table]", "name.unknown", "driver"),
    "one link": ("[driver, table]", "[driver]", "file.expected", "LINK"),
    "a driver without a drive": ("turns: driver", "turns: table", "geneva.motor", "turns: driver"),
    "a drive by its output": ("start: 180 deg}", "start: 180 deg, output: table}", "geneva.motor", "output"),
    "no distance": ("Q: [c, 0]", "Q: [0, 0]", "geneva.concentric", "frame"),
    "a missing key": (", arc: r - 15", "", "file.missing", "slots"),
    "a key that isn't known": ("slots: n", "slots: n, slto: 0", "file.unknown-key", "slot"),
    "a wheel with a drive": (
        "loads:", "  other: {turns: table, on: frame, speed: 1 rpm, start: 0}\nloads:", "drive.twice", "other",
    ),
    "friction in the slot": (
        "loads:", "friction: {b: {contact: indexing, coefficient: 0.1}}\nloads:", "name.unknown", "indexing",
    ),
    "an escapement": (JOINT, "indexing: {type: escapement, links: [driver, table]}", "element.intermittent", "geneva"),
    "a ratchet": ("loads:", "ratchet: {}\nloads:", "element.intermittent", "star wheels"),
    "an internal drive": (JOINT, "indexing: {internal_geneva: [driver, table]}", "element.intermittent", "internal"),
    "a section": ("loads:", "geneva: {}\nloads:", "element.geneva", "pins: [P]"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused(case: str) -> None:
    old, new, code, hint = REFUSED[case]
    assert old in TEXT
    found = findings(TEXT.replace(old, new))
    named = [finding for finding in found if finding.code == code]
    assert named, [finding.code for finding in found]
    assert all(finding.what and finding.mend for finding in found)
    assert any(hint in str(finding) for finding in named), [str(finding) for finding in named]
    assert all(finding.line for finding in named)


def test_everything_wrong_is_told_at_once() -> None:
    text = TEXT.replace("arc: r - 15", "arc: 80").replace("r: c*sin(180 deg/n) + off", "r: 60")
    text = text.replace("slots: n", "slots: 4.5").replace("mass: 6", "mass: -6")
    codes = [finding.code for finding in findings(text)]
    assert {"geneva.arc", "geneva.entry", "geneva.slots", "value.too-small"} <= {*codes}
    assert len(codes) == len({*codes})


def test_four_pins_in_four_slots_just_fit() -> None:
    """One leaves where the next one enters; five don't fit."""
    assert not examine(Document.model_validate(model(4, pins=4)), None)[1]
    codes = [finding.code for finding in examine(Document.model_validate(model(4, pins=5)), None)[1]]
    assert codes == ["geneva.pins"]


def test_the_file_is_kept() -> None:
    document = parse_document(model(5, pins=2))
    stream = io.StringIO()
    YAML().dump(document.model_dump(by_alias=True, exclude_unset=True, mode="json"), stream)
    joint = document.joints["indexing"]
    assert joint.links == ("driver", "wheel")
    assert joint.model_dump(by_alias=True, exclude_defaults=True)["pins"] == ("P1", "P2")


@pytest.mark.parametrize("seed", range(80))
def test_mutated_examples_end_in_findings(seed: int) -> None:
    every_one_survives([mutated(random.Random(seed), TEXT)])


@pytest.mark.parametrize(
    ("target", "code"),
    [("mjcf", "export.followers"), ("motor-expressions", "export.no-formula"), ("process-simulate", "export.joint")],
)
def test_exports_say_what_they_can_t_hold(target: str, code: str, tmp_path: Path) -> None:
    """MuJoCo gets the wheel's motion as values of an actuator; formulas have no dwells of a Geneva drive."""
    try:
        found = lw.export(FILE, target, out=tmp_path).warnings
    except lw.ModelError as error:
        found = list(error.findings)
    assert code in [finding.code for finding in found]


def test_it_has_modes_and_limits_but_no_workspace(tmp_path: Path) -> None:
    """A turn of the driver brings the wheel to the next slot, so that its places are modes on one circuit."""
    assert lw.modes(FILE).done
    data = model(4, arm=True, studies={"workspace": {"point": "T"}})
    codes = [finding.code for finding in lw.check(lw.Document.model_validate(data))]
    assert "study.cams" in codes


def shaken(**changes: Any) -> list[Finding]:
    data = model(4, psi=0.0, studies={"cycle": {"turns": "2 motor", "samples": 200}}, **changes)
    del data["gravity"]
    return [f for f in lw.run(lw.Document.model_validate(data)).found if f.code == "geneva.horn"]


@pytest.mark.parametrize(
    ("window", "torque", "told"),
    [
        (["90 deg", "270 deg"], 2.0, False),
        (["90 deg", "270 deg"], -2.0, False),
        (["50 deg", "80 deg"], 2.0, True),
        (["50 deg", "80 deg"], -2.0, False),
        (["280 deg", "310 deg"], 2.0, False),
        (["280 deg", "310 deg"], -2.0, True),
        (["-40 deg", "40 deg"], 2.0, False),
    ],
)
def test_a_horn_that_the_disc_doesn_t_reach_is_told(window: list[str], torque: float, told: bool) -> None:
    """Right after a pin has left and right before the next one enters, the disc holds by the horn away from the pin
    alone; a counter-clockwise moment on the wheel is held by the horn on the side on which pins leave."""
    angles = {"motor.angle": [f"{float(end.removesuffix(' deg')) + 25 - 40} deg" for end in window]}
    loads = {"drill": {"on": "wheel", "torque": torque, "window": "drilling"}}
    found = shaken(windows={"drilling": angles}, loads=loads)
    assert bool(found) == told
    if told:
        (finding,) = found
        assert finding.severity == "warning"
        assert "N" in str(finding.data["force"])
