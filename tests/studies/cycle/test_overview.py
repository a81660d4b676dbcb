"""What a cycle without measures shows is what measures of the same expressions say."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from linkwright.findings import Text
from linkwright.presentation.blocks import Table
from linkwright.studies.registry import STUDIES

EXAMPLES = Path(__file__).parents[3] / "examples"
KEPT = ("measures", "require", "windows")


def plain(name: str) -> dict[str, Any]:
    """An example without measures."""
    data = lw.load(EXAMPLES / f"{name}.yaml").model_dump(mode="json", by_alias=True, exclude_unset=True)
    return {key: value for key, value in data.items() if key not in KEPT}


def overview(data: dict[str, Any]) -> dict[str, Any]:
    """The overview in the summary."""
    job = lw.run(lw.Document.model_validate(data), folder=EXAMPLES)
    found: dict[str, Any] = job.summary["overview"]
    return found


def test_it_says_what_measures_say() -> None:
    data = plain("four_bar")
    found = overview(data)
    force = "hypot(force(frame, crank).x, force(frame, crank).y)"
    data["measures"] = {
        "swing": {"span": "rocker.angle"},
        "torque": {"extremes": "motor.torque"},
        "torque_rms": {"rms": "motor.torque"},
        "power": {"extremes": "motor.power"},
        "reaction": {"max": force},
        "reaction_rms": {"rms": force},
    }
    told = lw.run(lw.Document.model_validate(data), folder=EXAMPLES).summary["measures"]
    rocker, motor = found["outputs"]["rocker.angle"], found["drives"]["motor"]
    assert rocker["max"]["value"] - rocker["min"]["value"] == pytest.approx(told["swing"]["value"], rel=1e-12)
    for key, name in (("effort", "torque"), ("power", "power")):
        ends = told[name]["min"], told[name]["max"]
        assert motor[key]["value"] == pytest.approx(max(ends, key=abs), rel=1e-12)
    assert motor["effort"]["rms"] == pytest.approx(told["torque_rms"]["value"], rel=1e-9)
    (reaction,) = [one for one in found["reactions"] if one["joint"] == "O2"]
    assert reaction["links"] == ["frame", "crank"]
    assert reaction["value"] == pytest.approx(told["reaction"]["value"], rel=1e-12)
    assert reaction["rms"] == pytest.approx(told["reaction_rms"]["value"], rel=1e-9)


def test_the_paper_feeder_shows_its_stroke() -> None:
    found = overview(plain("paper_feeder"))
    rail = found["outputs"]["rail.s"]
    # The founding paper's stroke of 680 mm, as the example's own measure has it.
    assert rail["max"]["value"] - rail["min"]["value"] == pytest.approx(680.2778, abs=1e-4)
    assert {one["joint"] for one in found["reactions"]} == {"A", "B", "C", "D", "E", "rail", "slide"}
    assert [one["group"] for one in found["transmission"]] == ["coupler-rocker", "slider-guide"]


def test_without_forces_there_are_motions_only() -> None:
    data = plain("four_bar")
    data.pop("loads", None)
    data.pop("gravity", None)
    for link in data["links"].values():
        for key in ("mass", "com", "inertia", "shape"):
            link.pop(key, None)
    found = overview(data)
    assert found["outputs"] and not found["drives"] and not found["reactions"]


def test_it_is_shown_instead_of_measures() -> None:
    data = plain("four_bar")
    job = lw.run(lw.Document.model_validate(data), folder=EXAMPLES)
    report = STUDIES["cycle"].report(job.cycle)
    (section,) = [one for one in report.sections if one.name == "overview"]
    tables = [block for block in section.blocks if isinstance(block, Table)]
    heads: list[Text] = [head for table in tables for head in table.heads]
    assert "At, s" in map(str, heads)
    assert all(len(row) == len(table.heads) for table in tables for row in table.rows)
    json.dumps(job.summary)
    document = lw.load(EXAMPLES / "four_bar.yaml")
    assert "overview" not in lw.run(document, folder=EXAMPLES).summary
