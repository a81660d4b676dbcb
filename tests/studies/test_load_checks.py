"""What is said of loads and springs that have no value somewhere along a run."""

from __future__ import annotations

from typing import Any

import pytest

import linkwright as lw
from linkwright.app.job import Job
from model.given import four_bar


def cycle(**sections: Any) -> Job:
    data = four_bar(studies={"cycle": {"turns": "1 motor", "samples": 24}}, **sections)
    return lw.run(lw.Document.model_validate(data))


def table(low: str, high: str, **more: Any) -> dict[str, Any]:
    return {"f": {"points": [[low, "0 N"], [high, "9 N"]], "between": "linear", **more}}


def load(law: str, **more: Any) -> dict[str, Any]:
    return {"cut": {"on": "crank", "at": "B", "force": [law, 0], **more}}


def codes(job: Job) -> list[str]:
    return [finding.code for finding in job.found]


def test_an_argument_outside_a_table_is_told_with_place_and_figures() -> None:
    job = cycle(loads=load("f(B.x)"), tables=table("-40 mm", "30 mm"))
    (finding,) = job.found
    assert (finding.code, finding.path, job.exit_code) == ("load.outside-table", ("loads", "cut"), 1)
    assert finding.data["table"] == "f"
    assert (finding.data["at"], finding.data["low"], finding.data["high"]) == ("40", "-40", "30")
    assert (finding.data["drive"], finding.data["value"], finding.data["of"]) == ("motor", "360", "mm")
    assert job.cycle is not None
    assert job.cycle.result.certificate is None


def test_an_argument_just_at_the_ends_is_inside() -> None:
    assert not codes(cycle(loads=load("f(B.x)"), tables=table("-40 mm", "40 mm")))


def test_between_the_samples_too() -> None:
    """B.y is largest between two of the 24 samples."""
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 37.5}}
    job = cycle(loads=load("f(B.y)"), tables=table("-40 mm", "39.99 mm"), drives=drives)
    assert codes(job) == ["load.outside-table"]
    assert job.found[0].data["at"] == "40"


def test_where_the_load_does_not_act_its_table_is_not_asked() -> None:
    windows = {"w": {"B.x": ["-40 mm", "30 mm"]}}
    assert not codes(cycle(loads=load("f(B.x)", window="w"), tables=table("-40 mm", "30 mm"), windows=windows))


def test_a_period_serves_all_arguments() -> None:
    closed = {"f": {"points": [["0 mm", "0 N"], ["3 mm", "9 N"]], "between": "linear", "period": "10 mm"}}
    assert not codes(cycle(loads=load("f(B.x)"), tables=closed))


@pytest.mark.parametrize("law", ["1 N/(1 - 1*(B.x/B.x))", "sqrt(B.y/(1 mm))*1 N", "1 N*log(B.x/(1 mm))"])
def test_a_load_without_a_value(law: str) -> None:
    job = cycle(loads=load(law))
    assert codes(job) == ["load.not-finite"]
    assert job.exit_code == 1


def test_a_spring_whose_ends_meet() -> None:
    """C swings through a circle about D; K lies on it, halfway."""
    points = {"A": [0, 0], "D": [100, 0], "K": "40 at 90"}
    links = four_bar()["links"] | {"frame": {"points": points}}
    job = cycle(links=links, springs={"s": {"from": "K", "to": "B", "stiffness": 2, "free": 10}})
    assert codes(job) == ["spring.no-direction"]
    assert job.found[0].data["value"] == "90"


def test_a_spring_outside_its_lengths_is_a_warning() -> None:
    """B moves from 60 to 140 mm away from D."""
    lift = {"from": "D", "to": "B", "gas": 100, "progression": 1.3, "length": [70, 150]}
    job = cycle(springs={"lift": lift})
    (finding,) = job.found
    assert (finding.code, finding.severity, job.exit_code) == ("spring.outside-length", "warning", 0)
    assert (finding.data["length"], finding.data["low"], finding.data["value"]) == ("60", "70", "360")
    assert not codes(cycle(springs={"lift": lift | {"length": [60, 140]}}))


def test_a_gas_spring_pushed_in_past_its_gas() -> None:
    lift = {"from": "D", "to": "B", "gas": 100, "progression": 20, "length": [128, 150]}
    job = cycle(springs={"lift": lift})
    assert codes(job) == ["load.not-finite"]
    assert job.found[0].path == ("springs", "lift")


def test_a_table_that_cannot_be_read_is_told_once() -> None:
    tables = {"f": {"file": "none.csv", "x": "x mm", "y": "y N"}}
    data = four_bar(loads=load("f(B.x)") | {"b": load("f(B.y)")["cut"]}, tables=tables)
    assert [f.code for f in lw.check(lw.Document.model_validate(data))] == ["table.unreadable"]
