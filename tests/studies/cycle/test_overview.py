"""What a cycle without measures shows is what measures of the same expressions say."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from linkwright.app.job import examine_document, perform
from linkwright.findings import Text
from linkwright.kernels.numpy_blocks import NumpyKernel
from linkwright.presentation.blocks import Table
from linkwright.studies import RunContext
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


def chain(dyads: int) -> dict[str, Any]:
    """Four-bars in a row: each rocker moves the coupler of the next."""
    sketch = {"O": [0, 0], "K": [20, 30]}
    links: dict[str, Any] = {"frame": {"points": ["O"]}, "crank": {"points": ["O", "K"], "mass": 1, "shape": "rod O-K"}}
    before = "K"
    for i in range(dyads):
        x = 100 * (i + 1)
        sketch |= {f"C{i}": [x + i % 3, 60 - i % 2], f"D{i}": [x, 0], f"E{i}": [x + 30, 50 - i % 3]}
        links[f"c{i}"] = {"points": [before, f"C{i}"], "mass": 0.5, "shape": f"rod {before}-C{i}"}
        links[f"r{i}"] = {"points": [f"C{i}", f"D{i}", f"E{i}"], "mass": 1 + i, "shape": f"rod C{i}-D{i}"}
        links["frame"]["points"].append(f"D{i}")
        before = f"E{i}"
    position = "1 rad + 0.1 rad*sin(6.28 rad/s*t)"
    return {
        "linkwright": 1,
        "units": {"length": "mm", "angle": "deg", "mass": "kg"},
        "gravity": [0, "-9.81 m/s^2"],
        "sketch": sketch,
        "links": links,
        "drives": {"motor": {"turns": "crank", "on": "frame", "position": position}},
        "studies": {"cycle": {"duration": "1 s", "samples": 40}},
    }


def test_every_reaction_of_a_chain_is_what_a_measure_says() -> None:
    data = chain(4)
    found = overview(data)
    names = {f"{one['joint']}{i}": one for i, one in enumerate(found["reactions"])}
    data["measures"] = {}
    for key, one in names.items():
        force = "force({}, {}, {})".format(*one["links"], one["joint"])
        data["measures"][key] = {"max": f"hypot({force}.x, {force}.y)"}
        data["measures"][f"{key}_rms"] = {"rms": f"hypot({force}.x, {force}.y)"}
    told = lw.run(lw.Document.model_validate(data)).summary["measures"]
    assert len(names) == 13
    for key, one in names.items():
        assert one["value"] == pytest.approx(told[key]["value"], rel=1e-11)
        assert one["at"] == pytest.approx(told[key]["at"], abs=1e-7)
        assert one["rms"] == pytest.approx(told[f"{key}_rms"]["value"], rel=1e-11)


def test_a_longer_chain_needs_no_more_programs(monkeypatch: pytest.MonkeyPatch) -> None:
    """All rows are computed together: neither programs nor evaluations grow with the number of links."""
    counts = []
    for dyads in (3, 12):
        job = lw.run(lw.Document.model_validate(chain(dyads)))
        evaluated: list[int] = []
        run = NumpyKernel.run

        def counted(self: Any, *args: Any, own: Any = run, into: list[int] = evaluated) -> Any:
            into.append(id(self))
            return own(self, *args)

        with monkeypatch.context() as patch:
            patch.setattr(NumpyKernel, "run", counted)
            assert len(job.cycle.overview.reactions) == 3 * dyads + 1
        counts.append((len(evaluated), len({*evaluated})))
    (few, few_programs), (many, many_programs) = counts
    assert many_programs == few_programs
    assert many <= 1.5 * few


def test_progress_is_told_up_to_the_end() -> None:
    told: list[tuple[int, int]] = []
    examined = examine_document(lw.Document.model_validate(chain(2)))
    job = perform(examined, RunContext(progress=lambda done, total: told.append((done, total))))
    assert not told  # what nobody asks for isn't computed
    assert job.cycle.overview is not None
    assert [done for done, _ in told] == sorted(done for done, _ in told)
    assert told[-1][0] == told[-1][1]


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
