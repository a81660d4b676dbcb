"""Allocation for a whole model: units, limits of half-widths, grades, targets of measures and signals, wrong input."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import linkwright as lw
from linkwright.expressions import units as u
from linkwright.studies.accuracy import convex_minimum
from linkwright.studies.accuracy.allocation_options import Output, allocated, problem
from linkwright.studies.accuracy.allocation_problem import Problem
from linkwright.studies.accuracy.options import AccuracyOptions
from linkwright.studies.accuracy.stated_contributors import contributors
from studies.models import four_bar

LENGTHS = {"a": 40, "b": 120, "c": 80, "d": 100}
C = np.array([[1.2, -0.7, 0.5, 0.9, 0.01]])
OUTPUTS = {
    "reach": Output(C, u.LENGTH, "m", 1.0),
    "P.x": Output(np.concatenate([C, 0.5 * C]), u.LENGTH, "mm", 1e-3),
    "swing": Output(30 * C, u.ANGLE, "deg", np.pi / 180),
}


def posed(**options: Any) -> tuple[Problem | None, list[lw.Finding]]:
    data = four_bar()
    data["parameters"] = {name: {"value": value, "tolerance": [-0.02, 0.08]} for name, value in LENGTHS.items()}
    data["parameters"]["s"] = {"value": "0 deg", "tolerance": {"limits": 0.1, "distribution": "uniform"}}
    data["drives"] = {"motor": {**data["drives"]["motor"], "start": "s"}}
    compiled = lw.compile(lw.Document.model_validate(data))
    context = {"cycle": {"turns": "1 motor", "samples": 60}}
    asked = AccuracyOptions.model_validate({"outputs": ["P.x"], "allocate": options}, context=context)
    assert asked.allocate is not None
    return problem(compiled.quantities, asked.allocate, contributors(compiled, asked), OUTPUTS)


def test_numbers_come_in_the_units_of_their_places() -> None:
    found, findings = posed(
        targets={"reach": "100 um", "swing": {"within": 0.5, "method": "worst"}},
        costs={"a": {"reciprocal": 2}, "s": {"exponential": [1, 3, 0.05], "between": [0.02, "6 arcmin"]}},
        sigmas=2,
    )
    assert not findings
    assert found is not None
    a, b, _, _, s = found.items
    assert a.law is not None
    assert a.law.cost(0.02e-3) == pytest.approx(100)
    assert (a.low, a.high) == pytest.approx((0.0055e-3, 0.31e-3))  # half of IT5 and IT14 over 30 to 50 mm: 11, 620 um
    assert a.now == pytest.approx(0.05e-3)
    assert b.law is None
    assert s.law is not None
    assert (s.low, s.high) == pytest.approx((np.radians(0.02), np.radians(0.1)))
    assert s.law.cost(np.radians(0.05)) == pytest.approx(1 + 3 / np.e)
    assert (a.spread, s.spread) == pytest.approx((1 / 3, 1 / np.sqrt(3)))
    assert [demand.wanted for demand in found.demands] == pytest.approx([1e-4, np.radians(0.5)])
    assert [demand.method for demand in found.demands] == ["rss", "worst"]
    assert found.sigmas == 2


def test_rounded_to_grades_that_the_optimum_lies_between() -> None:
    costs = {name: {"reciprocal": [1, value / 50]} for name, value in LENGTHS.items()}
    found, _ = posed(targets={"P.x": 0.05}, costs=costs, grades=True)
    assert found is not None
    made, notes = allocated(found)
    assert not notes
    assert made.reached
    assert made.proven
    assert made.optimality.worst < 1e-8
    assert made.costs[2] is not None
    assert made.costs[1] < made.costs[2] < 1.2 * made.costs[1]
    for item in made.items[:4]:
        assert item.grade is not None
        assert item.rounded is not None
        assert 0.5 < item.rounded / item.half < 2  # a grade is some 1.6 times the next
    (target,) = made.targets
    assert target.rounded is not None
    assert target.rounded <= target.wanted
    assert target.row == 0
    assert made.items[4].fixed


def test_processes_and_grades_together_are_all_rounded() -> None:
    tables = {"a": {"table": {"IT6": 12, "IT8": 5, "IT10": 3}}, "b": {"table": [[0.01, 9], [0.05, 2]]}}
    found, _ = posed(targets={"P.x": 0.06}, costs={**tables, "c": {"reciprocal": 0.5}})
    assert found is not None
    made, notes = allocated(found)
    assert not notes
    a, b, c = made.items[:3]
    assert a.grade in ("IT6", "IT8", "IT10")
    assert b.grade in ("0.01", "0.05")
    assert c.grade is not None
    assert c.grade.startswith("IT")


def test_what_cannot_be_had_is_said() -> None:
    cost = {"a": {"reciprocal": 2}}
    for targets, code in (({"P.x": 0.001}, "accuracy.target-unreachable"), ({"P.x": 5}, "accuracy.targets-loose")):
        found, _ = posed(targets=targets, costs=cost)
        assert found is not None
        _, notes = allocated(found)
        assert [note.code for note in notes] == [code]
        assert notes[0].what
    found, _ = posed(targets={"P.x": 0.1}, costs={"a": {"table": [[0.05, 1], [0.2, 0.5]]}})
    assert found is not None
    tight, notes = allocated(found)
    assert tight.items[0].rounded == pytest.approx(0.05e-3)
    assert not notes


def test_an_optimum_without_its_proof_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(convex_minimum, "MOST_STEPS", 1)
    found, _ = posed(targets={"P.x": 0.05}, costs={name: {"reciprocal": 1} for name in LENGTHS})
    assert found is not None
    assert [note.code for note in allocated(found)[1]][-1] == "accuracy.not-optimal"


FAULTS: dict[str, tuple[dict[str, Any], list[str]]] = {
    "no contributor": ({"costs": {"A": {"reciprocal": 1}}}, ["accuracy.no-contributor"]),
    "no target": ({"targets": {"P.z": 1}}, ["accuracy.no-target"]),
    "target of nothing": ({"targets": {"P.x": 0, "swing": -1}}, ["accuracy.target", "accuracy.target"]),
    "target in another unit": ({"targets": {"P.x": "1 deg"}}, ["expression.units-conflict"]),
    "half-widths": ({"costs": {"a": {"reciprocal": 1, "between": [2, 1]}}}, ["accuracy.half-widths"]),
    "half-widths' unit": ({"costs": {"a": {"reciprocal": 1, "between": [1, "2 s"]}}}, ["expression.units-conflict"]),
    "grade of an angle": ({"costs": {"s": {"table": {"IT7": 1}}}}, ["accuracy.no-grade"]),
    "rounding an angle": ({"costs": {"s": {"reciprocal": 1}}, "grades": True}, ["accuracy.no-grade"]),
    "no grade between": (
        {"costs": {"a": {"reciprocal": 1, "between": [0.0126, 0.0127]}}, "grades": True},
        ["accuracy.no-grade-between"],
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_each_fault_has_its_finding(name: str) -> None:
    options, codes = FAULTS[name]
    found, findings = posed(**{"targets": {"P.x": 0.1}, "costs": {"a": {"reciprocal": 1}}, **options})
    assert found is None
    assert [finding.code for finding in findings] == codes
    assert all(finding.what and finding.mend for finding in findings)
