"""Parts that hold what is held already and move along: named with rank and count; near misses with their size."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.compiled import compiled_from
from linkwright.compilation import examine
from linkwright.findings import Finding
from linkwright.model.document import Document

UNITS = {"length": "mm", "angle": "deg", "time": "s"}


def parallelogram(cranks: int = 2, length: float = 40.0) -> dict[str, Any]:
    """Cranks of 40 mm under one coupler; those after the second have a length of their own."""
    links: dict[str, Any] = {"frame": {"points": {}}}
    for i in range(1, cranks + 1):
        links["frame"]["points"][f"A{i}"] = [60 * i, 15 * (i > 2)]
        links[f"crank{i}"] = {"points": {f"A{i}": [0, 0], f"B{i}": [40.0 if i < 3 else length, 0]}}
    links["coupler"] = {"points": {f"B{i}": [60 * i, 15 * (i > 2)] for i in range(1, cranks + 1)}}
    drives = {"motor": {"turns": "crank1", "on": "frame", "speed": "60 rpm", "start": 30}}
    return {"units": UNITS, "links": links, "assembly": {"B2": "left of B1-A2"}, "drives": drives}


def two_guides(offset: float = -40.0, heading: float = 0.0) -> dict[str, Any]:
    """A slider-crank whose slider has a second guide, on its point H."""
    links = {
        "frame": {"points": {"A": [0, 0], "F": [0, 20], "G": [0, -20]}},
        "crank": {"points": {"A": [0, 0], "B": [50, 0]}},
        "rod": {"points": {"B": [0, 0], "C": [160, 0]}},
        "slider": {"points": {"C": [0, 0], "H": [0, offset]}},
    }
    joints = {
        "guide": {"prismatic": ["frame", "slider"], "line": ["F at 0", "C at 0"]},
        "second": {"prismatic": ["frame", "slider"], "line": [f"G at {heading}", f"H at {heading}"]},
    }
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 30}}
    return {
        "units": UNITS, "links": links, "joints": joints, "drives": drives,
        "assembly": {"C": "ahead of B along guide"},
    }  # fmt: skip


def found(data: dict[str, Any]) -> list[Finding]:
    compiled, findings = examine(Document.model_validate(data))
    assert compiled is None
    return findings


def test_a_third_crank() -> None:
    """Six links with eight pins: 3*4 - 2*6 = 0, but one of the twelve constraints says nothing new."""
    (finding,) = found(parallelogram(3))
    assert finding.code == "structure.redundant-movable"
    assert finding.path == ("links", "crank3")
    assert finding.data == {"part": "crank3", "rank": 11, "constraints": 12, "gruebler": 0, "mobility": 1}


def test_more_cranks_are_named_one_by_one() -> None:
    findings = found(parallelogram(5))
    assert [f.path for f in findings] == [("links", f"crank{i}") for i in (3, 4, 5)]
    assert {f.code for f in findings} == {"structure.redundant-movable"}
    assert {(f.data["rank"], f.data["constraints"], f.data["gruebler"], f.data["mobility"]) for f in findings} == {
        (17, 20, -2, 1)
    }


def test_a_second_coupler() -> None:
    """A double parallelogram: both couplers on both cranks."""
    data = parallelogram()
    for crank in ("crank1", "crank2"):
        data["links"][crank]["points"][f"C{crank[-1]}"] = [20, 5]
    data["links"]["second"] = {"points": {"C1": [0, 0], "C2": [60, 0]}}
    (finding,) = found(data)
    assert (finding.code, finding.path) == ("structure.redundant-movable", ("links", "second"))


def test_a_second_guide() -> None:
    (finding,) = found(two_guides())
    assert (finding.code, finding.path) == ("structure.redundant-movable", ("joints", "second"))
    assert (finding.data["rank"], finding.data["gruebler"], finding.data["mobility"]) == (8, -1, 1)


def test_without_the_named_parts_the_mechanism_runs() -> None:
    """The mend that is proposed is one."""
    for data in (parallelogram(4), two_guides()):
        mended = copy.deepcopy(data)
        for finding in found(data):
            section, name = finding.path
            del mended[section][name]
        t = np.linspace(0.0, 1.0, 9)
        assert np.isfinite(compiled_from(mended).evaluate(["B1.x" if "crank2" in data["links"] else "C.x"], t)).all()


@pytest.mark.parametrize(("data", "miss"), [(parallelogram(3, 40.2), "0.2"), (two_guides(-40.3), "0.3")])
def test_a_near_miss_is_told_beside_the_refusal(data: dict[str, Any], miss: str) -> None:
    refusal, near = found(data)
    assert refusal.code == "structure.overconstrained"
    assert near.code == "structure.nearly-redundant"
    assert (near.data["miss"], near.data["unit"]) == (miss, "mm")


@pytest.mark.parametrize("data", [parallelogram(3, 70.0), two_guides(-40, 20)])
def test_what_is_far_off_is_only_refused(data: dict[str, Any]) -> None:
    assert [f.code for f in found(data)] == ["structure.overconstrained"]


def test_a_third_crank_on_an_antiparallelogram_is_refused() -> None:
    """The same links put together crosswise don't move with it."""
    data = parallelogram(3)
    data["assembly"] = {"B2": "right of B1-A2"}
    assert "structure.redundant-movable" not in [f.code for f in found(data)]


def test_a_crank_too_many_that_fits_at_the_start_only() -> None:
    """A tie rod of the right length at the start, but not on the way."""
    data = parallelogram()
    data["links"]["frame"]["points"]["S"] = [90, -50]
    start = compiled_from(data).evaluate(["B1.x", "B1.y", "B2.x", "B2.y"], np.zeros(1))[:, 0] * 1000
    middle = (start[:2] + start[2:]) / 2
    data["links"]["coupler"]["points"]["M"] = [90, 0]
    data["links"]["rod"] = {"points": {"S": [0, 0], "M": [float(np.hypot(*(middle - [90, -50]))), 0]}}
    assert [f.code for f in found(data)] == ["structure.overconstrained"]


def test_modes_say_the_same() -> None:
    with pytest.raises(lw.ModelError) as error:
        lw.modes(Document.model_validate(parallelogram(3)))
    assert [f.code for f in error.value.findings] == ["structure.redundant-movable"]
