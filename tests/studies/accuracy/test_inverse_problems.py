"""Allocation and calibration as parts of the study: their examples."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from linkwright.app.job import examine_document
from linkwright.model.document import load, plain

EXAMPLES = Path(__file__).parents[3] / "examples"


def changed(**accuracy: Any) -> lw.Document:
    data = plain(load(EXAMPLES / "four_bar_allocation.yaml"))
    data["studies"]["accuracy"] |= accuracy
    return lw.Document.model_validate(data)


@pytest.mark.parametrize("column", ["half", "rounded"])
def test_the_allotted_tolerances_give_the_accuracy_that_is_told(column: str) -> None:
    """The study of the same file with these tolerances stated: what it finds is what the allocation said."""
    found = lw.accuracy(EXAMPLES / "four_bar_allocation.yaml").allocation
    data = plain(load(EXAMPLES / "four_bar_allocation.yaml"))
    for item in found.items:
        half = item.half if item.fixed else getattr(item, column)
        data["parameters"][item.name]["tolerance"] = half / item.size
    data["studies"]["accuracy"].pop("allocate")
    outcome = lw.accuracy(lw.Document.model_validate(data))
    swing, px, py = (getattr(target, "after" if column == "half" else column) for target in found.targets)
    assert 3 * outcome.figures["swing"].sigma == pytest.approx(swing, rel=1e-9)
    assert 3 * outcome.curves["P.x"].sigma.max() == pytest.approx(px, rel=1e-9)
    assert outcome.curves["P.y"].figure.half == pytest.approx(py, rel=1e-9)


def test_the_example_s_dimensions_lie_in_their_intervals() -> None:
    outcome = lw.accuracy(EXAMPLES / "four_bar_calibration.yaml")
    true = {"a": 40.031, "b": 119.962, "c": 80.018, "d": 100.006, "offset": 0.12}
    for one in outcome.calibration.estimates:
        low, high = one.interval
        assert low < true[one.name] * one.size - one.nominal < high
    assert outcome.calibration.probability > 0.05


def test_faults_are_told_before_anything_is_computed() -> None:
    allocate = {"targets": {"P.x at far": 0.1, "swing at far": 0.1}, "costs": {"q": {"reciprocal": 1}}}
    document = changed(positions={"far": "max P.x"}, allocate=allocate, calibrate={"points": [{"t": 2, "P.x": 1}]})
    codes = [finding.code for finding in examine_document(document, EXAMPLES).findings]
    assert codes == [
        "accuracy.no-target",
        "accuracy.no-contributor",
        "accuracy.no-pose",
        "accuracy.few-measurements",
    ]


def test_a_measure_without_a_value_has_no_target() -> None:
    data = plain(changed(allocate={"targets": {"none": 1}, "costs": {"a": {"reciprocal": 1}}}))
    data["measures"]["none"] = {"max": "1/(rocker.angle - rocker.angle)", "unit": "1/rad"}
    data["studies"]["accuracy"]["outputs"] = ["none"]
    outcome = lw.accuracy(lw.Document.model_validate(data))
    assert outcome.allocation is None
    assert [note.code for note in outcome.warnings] == ["measure.not-finite", "accuracy.no-target"]
