"""Forms in other spellings: the finding gives the one that a file has, which can be read."""

from __future__ import annotations

from typing import Any

import pytest

from linkwright.expressions.fields import AssemblyRule, LineOn, Position, Requirement, Shape, Written
from linkwright.model.document import read_document
from linkwright.model.gravity import Gravity
from model.given import changed, codes, findings

SPELLINGS = [
    (Shape, "bar A-B", "'rod A-B'"),
    (Shape, "Rod A B", "'rod A-B'"),
    (Shape, "rod A to B", "'rod A-B'"),
    (Shape, "wheel 40 mm at A", "'disc 40 mm at A'"),
    (Shape, "point mass at E", "'point E'"),
    (AssemblyRule, "left B-D", "'left of B-D'"),
    (AssemblyRule, "Right of B D", "'right of B-D'"),
    (AssemblyRule, "cross", "'crossed'"),
    (Requirement, "≥ 60 deg", "'>= 60 deg'"),
    (Requirement, "> 60 deg", "'>= 60 deg'"),
    (Requirement, "max 5 N*m", "'<= 5 N*m'"),
    (Requirement, "60~80 deg", "'60 .. 80 deg'"),
    (Requirement, "60 to 80 deg", "'60 .. 80 deg'"),
    (LineOn, "G 90 deg", "'G at 90 deg'"),
    (LineOn, "G", "'G at 0 deg'"),
    (Position, "(60, 0)", "[60, 0]"),
    (Position, "60, 0", "[60, 0]"),
    (Position, {"x": 60, "y": 0}, "[60, 0]"),
    (Gravity, 9.81, "[0, -9.81 m/s^2]"),
    (Gravity, "-9.81 m/s^2", "[0, -9.81 m/s^2]"),
    (Gravity, "Earth", "'earth'"),
]


@pytest.mark.parametrize(("kind", "given", "meant"), SPELLINGS, ids=str)
def test_the_form_that_is_meant(kind: type[Written], given: Any, meant: str) -> None:
    with pytest.raises(ValueError) as caught:
        kind(given)
    data = caught.value.context  # type: ignore[attr-defined]
    assert data["code"] == "file.expected" and str(data["hint"]) == f"Write {meant}."
    source = read_document(f"a: {meant}\n".encode())[1]
    kind(source.data["a"])


@pytest.mark.parametrize("given", ["upper", "rod AB", "left of", True, None, [1, 2, 3]])
def test_what_means_nothing_gets_an_example(given: Any) -> None:
    for kind in (Shape, AssemblyRule):
        with pytest.raises(ValueError) as caught:
            kind(given)
        assert str(caught.value.context["hint"]).startswith(("Example: ", "Examples: "))  # type: ignore[attr-defined]


def test_choices_are_compared_too() -> None:
    table = "tables: {c: {points: [[0, 0], [1, 1], [2, 0]], between: %s}}\nlinks:"
    (found,) = findings(changed(("links:", table % "qubic")))
    assert found.code == "file.expected" and found.mend.startswith("Did you mean 'cubic'?")
    assert codes(changed(("links:", table % "3"))) == ["file.expected"]
