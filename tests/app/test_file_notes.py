"""What a file says for nothing, and keys that stand where they belong but are spelled otherwise."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from helpers.examples import four_bar
from linkwright.findings import Finding
from linkwright.model.document import Document, save


def checked(tmp_path: Path, **sections: Any) -> list[Finding]:
    file = tmp_path / "model.yaml"
    save(Document.model_validate(four_bar(**sections)), file)
    return [finding for finding in lw.check(file) if finding.code == "plausible.unloaded"]


MEASURED = {
    "drive": {"extremes": "motor.torque"},
    "swing": {"span": "rocker.angle"},
    "pin": {"max": "force(frame, crank).x"},
}
MASS = {"mass": 2, "com": [0, 0], "inertia": 1}


def test_forces_of_nothing_are_a_note(tmp_path: Path) -> None:
    """The measures of forces are named, those of motion aren't; without any there is no note."""
    (note,) = checked(tmp_path, measures=MEASURED)
    assert note.severity == "note" and note.element == "measures.drive"
    assert "those measured by drive, pin too" in note.what
    assert checked(tmp_path, measures={"swing": {"span": "rocker.angle"}}) == []


@pytest.mark.parametrize(
    "sections",
    [
        {"links": {**four_bar()["links"], "coupler": {**four_bar()["links"]["coupler"], **MASS}}},
        {"loads": {"work": {"on": "coupler", "at": "C", "force": [0, 5]}}},
        {"springs": {"one": {"from": "A", "to": "C", "in": ["frame", "rocker"], "stiffness": 10, "free": 1}}},
    ],
    ids=["mass", "load", "spring"],
)
def test_whatever_makes_forces_makes_no_note(tmp_path: Path, sections: dict[str, Any]) -> None:
    assert checked(tmp_path, measures=MEASURED, **sections) == []


def test_a_key_of_friction_is_told_under_friction(tmp_path: Path) -> None:
    """Not that friction has to be written where it stands."""
    file = tmp_path / "model.yaml"
    save(Document.model_validate(four_bar()), file)
    text = file.read_text(encoding="utf-8") + "friction:\n  bearing: {pin: A, radius: 4, mu: 0.1}\n"
    file.write_text(text, encoding="utf-8")
    (key,) = [finding for finding in lw.check(file) if finding.element == "friction.bearing.mu"]
    assert key.code == "file.unknown-key" and "'coefficient'" in key.mend


def test_friction_elsewhere_is_sent_to_its_section(tmp_path: Path) -> None:
    file = tmp_path / "model.yaml"
    save(Document.model_validate(four_bar()), file)
    text = file.read_text(encoding="utf-8").replace("linkwright: 1", "linkwright: 1\nmu: 0.1", 1)
    file.write_text(text, encoding="utf-8")
    (key,) = [finding for finding in lw.check(file) if finding.element == "mu"]
    assert key.code == "element.friction"
    for place in ("pin", "slide", "contact"):
        assert f"{place}: " in key.mend
