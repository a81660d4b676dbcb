"""Notes on lengths, masses and speeds that look like a slip."""

from __future__ import annotations

from typing import Any

import pytest

from helpers.examples import four_bar
from linkwright.compilation import examine
from linkwright.findings import Finding
from linkwright.model.document import Document

DEG = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N"}


def notes(data: dict[str, Any]) -> list[Finding]:
    compiled, found = examine(Document.model_validate(data))
    assert compiled is not None
    assert {finding.severity for finding in found} <= {"note"}
    return found


def test_lengths_that_differ_by_much() -> None:
    """A point at 5 mm that was meant as 5 m, between pins 1 .. 4 m apart: both lengths are named."""
    data = four_bar()
    data["links"]["coupler"]["points"]["P"] = ["5 mm", 0]
    (note,) = notes(data)
    assert (note.code, note.element) == ("plausible.lengths", "links.coupler")
    assert {key: str(note.data[key]) for key in ("short", "low", "long", "high", "ratio")} == {
        "short": "B-P (coupler)", "low": "0.005 m", "long": "A-D (frame)", "high": "4 m", "ratio": "800",
    }  # fmt: skip


def test_lengths_within_the_factor_and_points_in_one_place() -> None:
    data = four_bar()
    data["links"]["coupler"]["points"] |= {"P": [4 / 299, 0], "Q": [0, 0], "R": [1e-12, 0]}
    assert notes(data) == []


def test_masses_that_differ_by_much() -> None:
    data = four_bar(counterweights={"cw": {"on": "crank", "mass": "1 g", "at": "B"}})
    data["links"]["rocker"] |= {"mass": 3, "shape": "rod D-C"}
    (note,) = notes(data)
    assert (note.code, note.element) == ("plausible.masses", "counterweights.cw")
    assert "cw has 0.001 kg, rocker 3 kg" in note.what
    data["counterweights"]["cw"]["mass"] = "10.1 g"
    assert notes(data) == []


@pytest.mark.parametrize(
    ("speed", "parameters", "told"),
    [
        (5, {}, True),
        (-5, {}, True),
        ("n", {"n": 5}, True),
        ("n", {"n": "5 deg/s"}, False),
        ("5 deg/s", {}, False),
        (6, {}, False),
        (45, {}, False),
        (0, {}, False),
        ("1.1e5 rpm", {}, True),
        ("9e4 rpm", {}, False),
    ],
)
def test_speeds(speed: Any, parameters: dict[str, Any], told: bool) -> None:
    """Slow ones only where no unit is written: who writes rpm means it."""
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": speed, "start": 0}}
    found = notes(four_bar(units=DEG, drives=drives, parameters=parameters))
    assert [note.code for note in found] == ["plausible.speed"] * told


def test_a_slow_speed_is_shown_in_rpm_with_the_line_to_write() -> None:
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": 3, "start": 0}}
    (note,) = notes(four_bar(units=DEG, drives=drives))
    assert "3 deg/s = 0.5 rpm: one turn takes 120 s" in note.what
    assert "'speed: 3 rpm'" in note.mend
