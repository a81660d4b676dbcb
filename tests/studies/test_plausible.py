"""Notes on points that coincide over a run, and on parallelograms that run crossed."""

from __future__ import annotations

from typing import Any

import pytest

from helpers.examples import four_bar
from linkwright.findings import Finding
from studies.models import job_of

SWING = {"motor": {"turns": "crank", "on": "frame", "position": "1.5 + 0.5*sin(6.283185307179586*t/(1 s))"}}


def notes(a: float, b: float, c: float, d: float, rule: str, **sections: Any) -> list[Finding]:
    data = four_bar(a, b, c, d, assembly={"C": rule}, drives=SWING, **sections)
    job = job_of(data | {"studies": {"cycle": {"period": "1 s", "samples": 40}}})
    assert job.exit_code == 0
    found = job.found
    assert {finding.severity for finding in found} <= {"note"}
    return found


def test_a_parallelogram_and_its_crossed_form() -> None:
    assert notes(1, 3, 1, 3, "left of B-D") == []
    (note,) = notes(1, 3, 1, 3, "right of B-D")
    assert (note.code, note.element) == ("plausible.antiparallelogram", "links.crank")
    assert "(3 m, 1 m)" in note.what or "(1 m, 3 m)" in note.what
    assert "write 'C: left of B-D'" in note.mend


@pytest.mark.parametrize("rule", ["left of B-D", "right of B-D"])
def test_other_four_bars_are_none(rule: str) -> None:
    assert notes(1, 3, 3, 3, rule) == []


def test_a_kite_that_folds_onto_itself() -> None:
    """Of AB = BC and CD = DA, C lies on A in one of the modes, whatever the crank does."""
    assert notes(3, 3, 1, 1, "left of B-D") == []
    (note,) = notes(3, 3, 1, 1, "right of B-D")
    assert (note.code, note.data) == ("plausible.coincident", {"first": "A", "second": "C"})


def test_points_of_one_link_or_of_one_pin_may_coincide() -> None:
    data = four_bar()
    data["links"]["frame"]["points"]["A2"] = [0, 0]
    data["links"]["coupler"]["points"]["B2"] = [0, 0]
    assert notes(1, 3, 3, 4, "left of B-D", links=data["links"]) == []
    data["links"]["coupler"]["points"] = {"B1": [0, 0], "C": [3, 0]}
    joints = {"pin": {"revolute": ["crank", "coupler"], "at": ["B", "B1"]}}
    assert notes(1, 3, 3, 4, "left of pin-D", links=data["links"], joints=joints) == []
