"""Starts as drawn, and starts elsewhere than drawn."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.findings import Finding
from linkwright.model.document import Document
from model.test_sketch import T, sketched

DRAWN = float(np.degrees(np.arctan2(35, 20)))


def drives(**law: Any) -> dict[str, Any]:
    return {"motor": {"turns": "crank", "on": "frame", **law}}


def found(data: dict[str, Any]) -> list[Finding]:
    return examine(Document.model_validate(data))[1]


def test_a_speed_alone_starts_as_drawn_to_the_last_bit() -> None:
    names = ["C.x", "C.y", "rocker.omega", "motor.angle"]
    left_out, said = (
        compiled_from(sketched(drives=drives(speed="60 rpm", **more))) for more in ({}, {"start": "sketch"})
    )
    assert (left_out.evaluate(names, T) == said.evaluate(names, T)).all()
    assert np.degrees(left_out.evaluate(["motor.angle"], np.zeros(1))[0, 0]) == pytest.approx(DRAWN, rel=1e-14)


def test_a_speed_alone_where_no_sketch_tells_the_start() -> None:
    data = sketched(drives=drives(speed="60 rpm"))
    data["links"]["crank"] = {"points": {"A": [0, 0], "B": [40.3, 0]}}
    assert [(f.code, f.element) for f in found(data)] == [("drive.start", "drives.motor")]
    data["drives"]["motor"]["turns"] = "cranc"
    assert [f.code for f in found(data)] == ["name.unknown"]


@pytest.mark.parametrize(
    ("law", "code", "off"),
    [
        ({"speed": "60 rpm", "start": 120}, "sketch.other-start", 120 - DRAWN),
        ({"speed": "60 rpm", "start": -120}, "sketch.other-start", 120 + DRAWN),
        ({"speed": "60 rpm", "start": DRAWN + 0.2}, "sketch.other-start", 0.2),
        ({"position": "20 + 10*sin(360*t/(1 s))"}, "sketch.other-position", DRAWN - 20),
    ],
)
def test_another_start_is_a_warning_with_the_difference(law: dict[str, Any], code: str, off: float) -> None:
    (finding,) = found(sketched(drives=drives(**law)))
    assert (finding.code, finding.severity) == (code, "warning")
    value, unit = finding.data["off"].split()
    assert (float(value), unit) == (pytest.approx(min(off, 360 - off), rel=1e-5), "deg")


def test_the_line_that_is_proposed_gives_the_same_start_without_a_warning() -> None:
    data = sketched(drives=drives(speed="60 rpm", start=10))
    (finding,) = found(data)
    (line,) = (part for part in finding.mend.split("'") if part.startswith("start: "))
    data["drives"]["motor"]["start"] = line.removeprefix("start: ")
    assert found(data) == []
    assert np.degrees(compiled_from(data).evaluate(["motor.angle"], np.zeros(1))[0, 0]) == pytest.approx(10, abs=1e-3)


@pytest.mark.parametrize("start", [DRAWN, round(DRAWN, 1), DRAWN - 720, "sketch + 90"])
def test_starts_that_are_drawn_or_meant(start: Any) -> None:
    assert found(sketched(drives=drives(speed="60 rpm", start=start))) == []


def test_a_cylinder() -> None:
    data = sketched(cylinders={"ram": {"from": "A", "to": "P"}}, drives={"pump": {"extends": "ram", "speed": 10}})
    length = float(np.hypot(70, 90))
    assert compiled_from(data).evaluate(["ram.s"], np.zeros(1))[0, 0] == pytest.approx(length / 1000, rel=1e-14)
    data["drives"]["pump"]["start"] = 112
    (finding,) = found(data)
    assert float(finding.data["off"].split()[0]) == pytest.approx(length - 112, rel=1e-4)


def test_a_rule_that_mirrors_the_sketch_is_a_note() -> None:
    """C is drawn left of B-D; the rule that is proposed is the drawn mode."""
    (note,) = found(sketched(assembly={"C": "right of B-D"}))
    assert (note.code, note.severity, note.element) == ("plausible.mirrored", "note", "assembly.C")
    assert "'C: left of B-D'" in note.mend
    assert found(sketched(assembly={"C": "left of B-D"})) == []


def test_of_a_start_elsewhere_no_rule_is_said_to_mirror() -> None:
    data = sketched(assembly={"C": "right of B-D"}, drives=drives(speed="60 rpm", start=200))
    assert [f.code for f in found(data)] == ["sketch.other-start"]
