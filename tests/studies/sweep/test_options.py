"""The options of a sweep: each fault has its finding, all are told at once, at their places."""

from __future__ import annotations

from typing import Any

import pytest

import linkwright as lw
from linkwright.findings import Finding, Term
from linkwright.studies.plans import PLANS
from studies.models import refused, slider_crank

MEASURES = {"stroke": {"span": "guide.s"}}
CYCLE = {"turns": "1 motor", "samples": 20}


def swept(cycle: dict[str, Any] | None = CYCLE, **sweep: Any) -> dict[str, Any]:
    studies = {"sweep": sweep} if cycle is None else {"cycle": cycle, "sweep": sweep}
    return slider_crank(measures=MEASURES, studies=studies)


def found(**sweep: Any) -> list[tuple[str, str]]:
    return [(f.code, f.element.removeprefix("studies.sweep")) for f in refused(swept(**sweep))]


STEPS = {"from": 45, "to": 55, "count": 3}
FAULTS: dict[str, tuple[dict[str, Any], list[tuple[str, str]]]] = {
    "unknown parameter": ({"vary": {"R": STEPS}}, [("name.unknown-parameter", ".vary.R")]),
    "wrong unit": ({"vary": {"r": [45, "3 kg"]}}, [("expression.units-conflict", ".vary.r.1")]),
    "unit of sigma": (
        {"vary": {"r": {"normal": 50, "sigma": "1 s"}}},
        [("expression.units-conflict", ".vary.r.sigma")],
    ),
    "not constant": ({"vary": {"r": [45, "t"]}}, [("expression.not-constant", ".vary.r.1")]),
    "no number": ({"vary": {"r": [45, "1/0"]}}, [("value.not-finite", ".vary.r.1")]),
    "nothing varied": ({"vary": {}}, [("study.options", ".vary")]),
    "no vary": ({}, [("file.missing", "")]),
    "neither steps nor list": ({"vary": {"r": 50}}, [("file.expected", ".vary.r")]),
    "unknown distribution": ({"vary": {"r": {"gauss": 50, "sigma": 1}}}, [("file.expected", ".vary.r")]),
    "unknown key": ({"vary": {"r": {"normal": 50, "sigma": 1, "mode": 2}}}, [("file.unknown-key", ".vary.r.mode")]),
    "missing key": ({"vary": {"r": {"normal": 50}}}, [("file.missing", ".vary.r")]),
    "one step": ({"vary": {"r": {**STEPS, "count": 1}}}, [("study.one-value", ".vary.r")]),
    "one value": ({"vary": {"r": [50]}}, [("study.one-value", ".vary.r")]),
    "steps of nothing": ({"vary": {"r": {**STEPS, "to": 45}}}, [("value.not-rising", ".vary.r")]),
    "sigma": ({"vary": {"r": {"normal": 50, "sigma": 0}}}, [("study.sigma", ".vary.r")]),
    "cut to nothing": ({"vary": {"r": {"normal": 50, "sigma": 1, "low": 60}}}, [("study.cut-distribution", ".vary.r")]),
    "cut upside down": (
        {"vary": {"r": {"normal": 50, "sigma": 1, "low": 51, "high": 49}}},
        [("value.not-rising", ".vary.r")],
    ),
    "uniform upside down": ({"vary": {"r": {"uniform": [51, 49]}}}, [("value.not-rising", ".vary.r")]),
    "triangle": ({"vary": {"r": {"triangular": [49, 52, 51]}}}, [("study.triangle", ".vary.r")]),
    "two corners": ({"vary": {"r": {"triangular": [49, 52]}}}, [("file.expected", ".vary.r.triangular")]),
    "grid of a distribution": (
        {"plan": "grid", "vary": {"r": {"normal": 50, "sigma": 1}}},
        [("study.plan", ".vary.r")],
    ),
    "samples of a grid": ({"samples": 10, "vary": {"r": STEPS}}, [("study.grid-samples", ".samples")]),
    "unknown plan": ({"plan": "saltelli", "vary": {"r": STEPS}}, [("study.choice", ".plan")]),
    "unknown kernel": ({"kernel": "fortran", "vary": {"r": STEPS}}, [("study.choice", ".kernel")]),
    "large grid": (
        {"vary": {name: {"from": 1, "to": 2, "count": 10_000} for name in ("r", "l", "e")}},
        [("study.too-many-samples", "")],
    ),
    "large hypercube": (
        {"plan": "latin", "samples": 10**8, "vary": {"r": {"uniform": [49, 51]}}},
        [("study.too-many-samples", ".samples")],
    ),
    "no output": ({"vary": {"r": STEPS}, "outputs": ["strok"]}, [("study.no-output", ".outputs.0")]),
    "parameter as output": ({"vary": {"r": STEPS}, "outputs": ["2*r"]}, [("study.no-output", ".outputs.0")]),
    "unknown signal": ({"vary": {"r": STEPS}, "outputs": ["C.z"]}, [("signal.no-attribute", ".outputs.0")]),
    "mixed units": ({"vary": {"r": STEPS}, "outputs": ["C.x + C.vx"]}, [("expression.units-mixed", ".outputs.0")]),
    "bad poses": ({"vary": {"r": STEPS}, "poses": 0}, [("study.options", ".poses")]),
}  # fmt: skip


@pytest.mark.parametrize("name", FAULTS)
def test_each_fault_has_its_finding(name: str) -> None:
    options, expected = FAULTS[name]
    assert found(**options) == expected


def test_all_faults_are_told_at_once() -> None:
    wrong = found(
        vary={"r": {"normal": 50, "sigma": -1}, "R": STEPS, "l": [100]},
        plan="best",
        outputs=["stroke", "nothing"],
    )
    assert [code for code, _ in wrong] == ["study.one-value", "study.choice"]  # its form comes first
    wrong = found(vary={"r": {"normal": 50, "sigma": -1}, "R": STEPS}, outputs=["stroke", "nothing"])
    assert [code for code, _ in wrong] == ["study.sigma", "name.unknown-parameter", "study.no-output"]


def test_a_sweep_needs_a_cycle() -> None:
    assert [f.code for f in refused(swept(None, vary={"r": STEPS}))] == ["study.needs-cycle"]


def test_a_fault_of_the_cycle_is_told_once() -> None:
    codes = [f.code for f in refused(swept({"turns": "1 engine"}, vary={"r": STEPS}))]
    assert codes == ["name.unknown"]


def test_a_file_without_measures_needs_outputs() -> None:
    data = slider_crank(studies={"cycle": CYCLE, "sweep": {"vary": {"r": STEPS}}})
    assert [f.code for f in refused(data)] == ["study.no-outputs"]


def test_the_length_of_the_run_is_the_same_in_all_samples() -> None:
    data = swept(vary={"n": {"from": "50 rpm", "to": "70 rpm", "count": 3}})
    data["parameters"]["n"] = "60 rpm"
    data["drives"] = {"motor": {**data["drives"]["motor"], "speed": "n"}}
    assert [f.code for f in refused(data)] == ["study.varied-span"]
    data["studies"]["cycle"] = {"duration": "1 s", "samples": 20}
    assert lw.check(lw.Document.model_validate(data)) == []


def test_a_derived_parameter_and_what_it_depends_on_may_both_be_varied() -> None:
    data = swept(vary={"r": [40, 50], "l": [150, 170]})
    data["parameters"]["l"] = "3*r + 10"
    outcome = lw.sweep(lw.Document.model_validate(data))
    assert outcome.table is not None
    r, length = outcome.table.parameters
    assert length.tolist() == [0.15, 0.17, 0.15, 0.17]
    stroke = ((length + r) ** 2 - 0.02**2) ** 0.5 - ((length - r) ** 2 - 0.02**2) ** 0.5
    assert outcome.table.figures[0] == pytest.approx(stroke, rel=1e-12)


def test_what_fits_is_the_plan() -> None:
    def plan(**options: Any) -> str:
        return lw.sweep(lw.Document.model_validate(swept(**options))).plan.name

    assert plan(vary={"r": STEPS, "l": [150, 170]}) == "grid"
    assert plan(vary={"r": STEPS, "l": {"uniform": [150, 170]}}, samples=7) == "latin"


@pytest.mark.parametrize("name", [name for name, plan in PLANS.items() if plan.chosen])
def test_lists_can_be_sampled_too(name: str) -> None:
    options = {"vary": {"r": STEPS, "l": [150, 170]}, "plan": name, "samples": 50}
    outcome = lw.sweep(lw.Document.model_validate(swept(**options)))
    assert outcome.table is not None
    assert {*outcome.table.parameters[0].round(9)} == {0.045, 0.05, 0.055}


def test_every_finding_can_be_said() -> None:
    for options, _ in FAULTS.values():
        for finding in refused(swept(**options)):
            assert isinstance(finding, Finding)
            assert finding.what
            assert finding.mend


def test_an_option_without_a_value() -> None:
    """It is named in words, not in Python's."""
    (finding,) = refused(swept(kernel=None, vary={"r": STEPS}))
    assert (finding.code, finding.data["given"]) == ("study.choice", Term("nothing"))
    assert "None" not in finding.what
