"""What a page gets of each number: its value, how far it may be moved, where it stands."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from helpers.examples import heavy_four_bar
from helpers.models import EXAMPLES, GALLERY, identity
from linkwright.expressions.units import unit
from linkwright.model.document import Document, dump, load
from linkwright.model.live_numbers import LiveNumber, live_numbers
from linkwright.model.named_numbers import named_numbers


def rows_of(data: dict[str, Any]) -> dict[str, LiveNumber]:
    document = Document.model_validate(data)
    return {row["label"]: row for row in live_numbers(named_numbers(document), dump(document))}


@pytest.mark.parametrize("path", [*EXAMPLES, *GALLERY], ids=identity)
def test_of_every_model(path: Path) -> None:
    document, text = load(path), path.read_text("utf-8")
    rows = live_numbers(named_numbers(document), text)
    assert json.loads(json.dumps(rows, allow_nan=False)) == rows
    assert [(row["line"], row["start"]) for row in rows] == sorted((row["line"], row["start"]) for row in rows)
    assert len({row["name"] for row in rows}) == len({row["label"] for row in rows}) == len(rows)
    lines = text.split("\n")
    for row in rows:
        assert row["low"] <= row["value"] <= row["high"]
        assert row["low"] < row["high"]
        assert lines[row["line"] - 1][row["start"] : row["end"]] == row["digits"]
        assert row["value"] == float(row["digits"]) * row["size"]
        assert row["size"] == pytest.approx(unit(row["unit"])[0], rel=1e-15)


def test_ranges() -> None:
    data = heavy_four_bar(parameters={"m": 2, "free": 0.5})
    data["links"]["coupler"]["mass"] = "m"
    data["links"]["rocker"]["com"] = [1, 0]
    data["links"]["crank"]["inertia"] = 0
    data["springs"] = {"s": {"from": "A", "to": "C", "stiffness": 100, "free": "free"}}
    rows = rows_of(data)

    def limits(label: str) -> tuple[float, float]:
        return rows[label]["low"], rows[label]["high"]

    assert limits("crank.mass") == (0.75, 2.25)
    assert limits("crank.com.x") == (pytest.approx(-0.6), pytest.approx(1.4))  # a quarter of the largest length
    assert limits("frame.points.A.x") == (-4.0, 4.0)  # the largest length
    assert limits("rocker.com.y") == (-4.0, 4.0)
    assert limits("crank.inertia") == (0.0, pytest.approx(0.55))  # not negative; half of the largest
    assert limits("gravity.x") == (pytest.approx(-4.905), pytest.approx(4.905))
    assert limits("gravity.y") == (pytest.approx(-14.715), pytest.approx(-4.905))
    assert limits("m") == (1.0, 3.0)
    assert rows["m"]["path"] == ["parameters", "m"]


def test_an_angle_of_zero() -> None:
    data = heavy_four_bar()
    data["drives"]["motor"]["start"] = 0
    row = rows_of(data)["motor.start"]
    assert (row["low"], row["high"], row["unit"]) == (-1.0, 1.0, "rad")


def test_tolerances_are_limits() -> None:
    parameters = {
        "a": {"value": 1, "tolerance": 0.25},
        "b": {"value": 3, "tolerance": [-0.5, 0.75]},
        "c": {"value": 3, "tolerance": "ISO 2768-m"},
        "d": {"value": 4, "tolerance": {"limits": 0.5, "distribution": "normal"}},
        "m": {"value": 2, "tolerance": 3},
    }
    data = heavy_four_bar(parameters=parameters)
    data["links"]["crank"]["points"]["B"] = ["a", 0]
    data["links"]["coupler"]["points"]["C"] = ["b", 0]
    data["links"]["rocker"]["points"]["C"] = ["c", 0]
    data["links"]["frame"]["points"]["D"] = ["d", 0]
    data["links"]["coupler"]["mass"] = "m"
    rows = rows_of(data)
    found = {name: rows[name]["tolerance"] for name in parameters}
    assert found["a"] == [0.75, 1.25]
    assert found["b"] == [2.5, 3.75]
    assert found["c"] == [pytest.approx(2.998), pytest.approx(3.002)]
    assert found["d"] == [3.5, 4.5]
    assert found["m"] == [-1.0, 5.0]
    assert (rows["a"]["low"], rows["a"]["high"]) == (0.5, 1.5)
