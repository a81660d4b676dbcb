"""Requirements on measures: their verdicts, and what they do to the exit code."""

from __future__ import annotations

import math
from typing import Any

import pytest

from studies.models import job_of, refused, slider_crank

STROKE = math.sqrt(210**2 - 20**2) - math.sqrt(110**2 - 20**2)  # mm of the slider-crank 50, 160, 20: 100.879


def job_with(requirement: str, measure: dict[str, Any] | None = None) -> Any:
    measures = {"m": measure or {"span": "guide.s"}, "other": {"max": "B.x"}}
    return job_of(slider_crank(measures=measures, require={"m": requirement}))


@pytest.mark.parametrize(
    ("requirement", "met"),
    [
        (">= 100 mm", True),
        (">=100mm", True),
        (">= 0.1 m", True),
        (">= 102 mm", False),
        ("<= 102 mm", True),
        ("<= 100.5 mm", False),
        ("100 mm .. 102 mm", True),
        ("100.8 mm .. 100.9 mm", True),
        ("102 mm .. 110 mm", False),
        ("10 mm .. 20 mm", False),
        (">= 2*r", True),
        ("<= 2*r", False),
        ("2*r .. 2*r + 2 mm", True),
        (">= 100", True),
        ("100 .. 102", True),
        (">= -1 mm", True),
    ],
)
def test_verdict(requirement: str, met: bool) -> None:
    job = job_with(requirement)
    measure = job.cycle.measures[0]
    assert all(finding.severity == "note" for finding in job.examined.findings)
    assert measure.verdict is met
    assert measure.requirement == requirement
    assert job.cycle.done is met
    assert job.exit_code == (0 if met else 1)
    assert job.cycle.measures[1].verdict is None
    assert job.cycle.measures[1].requirement is None


@pytest.mark.parametrize(
    ("requirement", "met"),
    [("-60 mm .. 60 mm", True), ("-60 mm .. 40 mm", False), (">= -51 mm", True), ("<= 49 mm", False)],
)
def test_of_extremes_both_must_fit(requirement: str, met: bool) -> None:
    assert job_with(requirement, {"extremes": "B.x"}).cycle.measures[0].verdict is met


@pytest.mark.parametrize(("requirement", "met"), [(">= 40 mm", True), ("<= 40 mm", True), ("40 mm .. 40 mm", True)])
def test_limits_are_inclusive(requirement: str, met: bool) -> None:
    assert job_with(requirement, {"max": "40 mm"}).cycle.measures[0].verdict is met


def test_the_limit_has_its_own_unit_not_the_measures() -> None:
    job = job_with(">= 100 mm", {"span": "guide.s", "unit": "m"})
    assert job.cycle.measures[0].verdict is True
    assert job.cycle.measures[0].shown() == pytest.approx(STROKE / 1000)


def test_one_failed_among_many_fails_the_run() -> None:
    measures = {name: {"span": "guide.s"} for name in "abc"}
    require = {"a": ">= 100 mm", "b": ">= 200 mm", "c": "<= 200 mm"}
    job = job_of(slider_crank(measures=measures, require=require))
    assert [m.verdict for m in job.cycle.measures] == [True, False, True]
    assert job.exit_code == 1
    assert not job.cycle.failures
    assert job.summary["done"] is False
    assert [job.summary["measures"][name]["met"] for name in "abc"] == [True, False, True]


@pytest.mark.parametrize(
    "requirement",
    [
        *(">= 100 N", ">= foo", "<= 2 + ", "100 mm .. 5 s", ">= t", ">= B.x", "110 mm .. 100 mm"),
        *("100 mm", "> 100 mm", "== 3", "", ".. 5 mm", "5 mm ..", 100, None, ["1 mm", "2 mm"]),
    ],
)
def test_one_that_makes_no_sense_is_refused(requirement: Any) -> None:
    found = refused(slider_crank(measures={"m": {"span": "guide.s"}}, require={"m": requirement}))
    assert {f.path[:2] for f in found} == {("require", "m")}


def test_a_measure_without_a_dimension_of_its_own_takes_that_of_its_limit() -> None:
    job = job_with("<= 6 mm", {"max": "5"})
    measure = job.cycle.measures[0]
    assert (measure.shown(), measure.unit, measure.verdict) == (5.0, "mm", True)


def test_of_an_unknown_measure() -> None:
    (finding,) = refused(slider_crank(measures={"stroke": {"span": "guide.s"}}, require={"strok": ">= 1 mm"}))
    assert finding.path == ("require", "strok")
    assert "stroke" in finding.mend
