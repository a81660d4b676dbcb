"""Gravity by name, along a direction, as a vector; and in a wrong unit."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import linkwright as lw
from helpers.compiled import compiled_from
from helpers.examples import feeder, four_bar
from linkwright.compilation import examine
from linkwright.findings import Finding, ModelError
from linkwright.model.document import Document, dump, parse_document

G = 9.80665
MM = {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N"}


def vector(gravity: Any, **sections: Any) -> tuple[float, float]:
    """The acceleration (m/s^2) that a file's gravity means."""
    start = compiled_from(four_bar(gravity=gravity, **sections)).assembly.start
    assert start is not None
    x, y = start.geometry.gravity()
    return float(x), float(y)


def warned(gravity: Any, units: dict[str, str] = MM) -> list[Finding]:
    drives = {"motor": {"turns": "crank", "on": "frame", "speed": "60 rpm", "start": 0.5}}
    return examine(Document.model_validate(four_bar(gravity=gravity, units=units, drives=drives)))[1]


def test_the_earths_gravity_points_down() -> None:
    assert vector("earth") == (0.0, -G)
    assert vector("earth", units={"angle": "rad"} | {"length": "m", "time": "s"}) == (0.0, -G)


@pytest.mark.parametrize("direction", [(0, -1), (1, 0), (3, -4), (-1e-3, 2e-3), (5e6, 12e6)])
def test_the_earths_gravity_along_a_direction_of_any_length(direction: tuple[float, float]) -> None:
    x, y = direction
    size = math.hypot(x, y)
    assert vector(f"earth along [{x}, {y}]") == pytest.approx((G * x / size, G * y / size), rel=1e-14, abs=1e-14)


def test_a_direction_takes_parameters_and_calls() -> None:
    tilt = {"tilt": "30 deg", "a": {"value": 1}}
    found = vector("earth along [sin(tilt), -cos(tilt)]", parameters=tilt)
    assert found == pytest.approx((G / 2, -G * math.sqrt(3) / 2), rel=1e-14)
    assert vector("earth along [hypot(3, 4), -atan2(0, 1)*a]", parameters=tilt) == pytest.approx((G, 0), abs=1e-14)


def test_by_name_and_by_number_are_one() -> None:
    """Every signal of the paper feeder, to the last bit."""
    t, names = np.linspace(0, 1.5, 7), ["motor.torque", "force(frame, crank).y", "shaking.y"]
    known, named = (
        compiled_from(feeder() | {"gravity": gravity}).evaluate(names, t) for gravity in (["0", f"-{G} m/s^2"], "earth")
    )
    assert (known == named).all()


@pytest.mark.parametrize(
    ("gravity", "code"),
    [
        ("down", "file.expected"),
        ("earth along 3", "file.expected"),
        ("earth along [1, 2, 3]", "file.expected"),
        ("earth along [0, 0.0]", "gravity.no-direction"),
        ("earth along [1 +, 2]", "expression.syntax"),
    ],
)
def test_what_is_no_gravity(gravity: str, code: str) -> None:
    with pytest.raises(ModelError) as caught:
        parse_document(four_bar(gravity=gravity))
    assert [(f.code, f.element) for f in caught.value.findings] == [(code, "gravity")]


def test_a_direction_that_vanishes_by_its_parameters_has_no_value() -> None:
    found = examine(Document.model_validate(four_bar(gravity="earth along [a, b]", parameters={"a": 0, "b": 0})))[1]
    assert {f.code for f in found} == {"value.not-finite"}


def test_the_builder_says_the_same() -> None:
    def built(*args: Any, **more: Any) -> str:
        builder = lw.Builder().frame(A=[0, 0]).link("crank", A=[0, 0]).drive("m", turns="crank", position=0)
        return dump(builder.gravity(*args, **more).build())

    assert "gravity: earth\n" in built("earth")
    assert built("earth", along=np.array([3, -4])) == built("earth along [3, -4]")
    assert "gravity: [0, -9.81 m/s^2]" in built(0, "-9.81 m/s^2")


@pytest.mark.parametrize(
    ("gravity", "times", "line"),
    [
        ([0, -9.81], "0.001", "gravity: earth'"),
        ([0, "-9806.65 m/s^2"], "1e+03", "gravity: earth'"),
        ([6, 8], "0.00102", "gravity: earth along [0.6, 0.8]'"),
    ],
)
def test_gravity_in_a_wrong_unit_is_a_warning(gravity: Any, times: str, line: str) -> None:
    (finding,) = warned(gravity)
    assert (finding.code, finding.severity, finding.element) == ("gravity.size", "warning", "gravity")
    assert finding.data["times"] == times
    assert line in finding.mend
    assert finding.data["given"].endswith(" mm/s²")


@pytest.mark.parametrize("gravity", [[0, "-1.62 m/s^2"], [0, -9810], [0, 0], "earth", "earth along [1, 1]"])
def test_other_gravity_is_none(gravity: Any) -> None:
    assert warned(gravity) == []
