"""The tolerance of a parameter in a file: numbers, classes, mappings; what comes back, and what is wrong."""

from __future__ import annotations

import json
from typing import Any

import pytest

from linkwright.model.document import Document, dump, read_document
from linkwright.model.tolerances import ClassName, full_tolerance
from model.given import findings, four_bar
from model.test_schema import errors

GOOD = [
    0.05,
    "0.05 mm",
    "gap",
    "0.5*gap",
    [-0.02, 0.08],
    ["-gap", "2*gap"],
    "ISO 2768-m",
    "h7",
    "js9",
    "IT8",
    {"limits": 0.1, "distribution": "uniform"},
    {"limits": [0, "gap"], "distribution": "truncated", "sigma": "gap/4"},
    {"limits": "ISO 2768-m", "cp": 1.33},
    {"distribution": "triangular"},
    {"limits": "IT8", "side": "60 mm"},
]


def given(tolerance: Any, **more: Any) -> dict[str, Any]:
    return four_bar(parameters={"gap": 0.1, "L": {"value": "40 mm", "tolerance": tolerance}, "use": "L + gap", **more})


def found(tolerance: Any, **more: Any) -> list[tuple[str, str]]:
    text = json.dumps(given(tolerance, **more), indent=1)  # JSON is YAML too
    return [(f.code, f.element.removeprefix("parameters.L.tolerance")) for f in findings(text)]


@pytest.mark.parametrize("tolerance", GOOD, ids=str)
def test_what_is_written_comes_back(tolerance: Any) -> None:
    document = Document.model_validate(given(tolerance))
    again, source = read_document(dump(document).encode())
    assert not source.findings
    assert again == document
    assert again is not None
    assert again.model_dump(exclude_defaults=True, mode="json")["parameters"]["L"] == {
        "value": "40 mm",
        "tolerance": tolerance,
    }
    assert not errors(given(tolerance))
    assert found(tolerance) == []


def test_all_spellings_have_one_full_form() -> None:
    whole = [
        full_tolerance(Document.model_validate(given(t)).parameters["L"].tolerance) for t in (0.1, {"limits": 0.1})
    ]
    assert whole[0].limits == whole[1].limits
    assert whole[0].sigma is whole[1].sigma is None


def test_a_name_of_a_class_knows_its_limits() -> None:
    (limits,) = [full_tolerance(Document.model_validate(given("h7")).parameters["L"].tolerance).limits]
    assert isinstance(limits, ClassName)
    assert limits.found.limits(0.025) == pytest.approx((-21e-6, 0))


WRONG: dict[str, tuple[Any, list[tuple[str, str]]]] = {
    "unknown class of ISO 2768": ("ISO 2768-x", [("tolerance.unknown-class", "")]),
    "unknown class of ISO 286": ("q9", [("tolerance.unknown-class", "")]),
    "unknown class in a mapping": ({"limits": "w7"}, [("tolerance.unknown-class", ".limits")]),
    "unknown parameter": ("2*gab", [("name.unknown-parameter", "")]),
    "another unit": ("1 kg", [("expression.units-conflict", "")]),
    "sigma in another unit": ({"limits": 0.1, "sigma": "1 s"}, [("expression.units-conflict", ".sigma")]),
    "cp with a unit": ({"limits": 0.1, "cp": "1 mm"}, [("expression.units-conflict", ".cp")]),
    "side that is an angle": ({"limits": "ISO 2768-m", "side": "60 deg"}, [("expression.units-conflict", ".side")]),
    "one limit": ([1], [("file.expected", "")]),
    "no value": ({"limits": None, "sigma": "1/0"}, [("value.not-finite", ".sigma")]),
    "unknown key": ({"limit": 0.1}, [("file.unknown-key", ".limit")]),
    "cp and sigma": ({"limits": 0.1, "cp": 1, "sigma": 0.1}, [("tolerance.cp-and-sigma", "")]),
    "sigma of a uniform one": (
        {"limits": 0.1, "distribution": "uniform", "sigma": 0.1},
        [("tolerance.no-sigma", "")],
    ),
    "unknown distribution and class": (
        {"limits": "ISO 1", "distribution": "gauss"},
        [("tolerance.unknown-class", ".limits"), ("tolerance.distribution", ".distribution")],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_each_fault_has_its_finding(name: str) -> None:
    tolerance, expected = WRONG[name]
    assert sorted(found(tolerance)) == sorted(expected)


def test_a_name_that_could_be_both_is_asked_about() -> None:
    assert found("h7", h7=0.2) == [("tolerance.class-or-parameter", "")]
    assert found({"limits": "h7"}, h7=0.2) == [("tolerance.class-or-parameter", "")]
    assert found("(h7)", h7=0.2) == []
    assert found("t1", t1=0.2) == []  # not a class: the grades of letters start at 3


def test_a_misspelled_key_is_told_the_known_ones() -> None:
    (finding,) = findings(json.dumps(given({"limits": 0.1, "distributon": "uniform"}), indent=1))
    assert finding.data["near"].likely == ("distribution",)
