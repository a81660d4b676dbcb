"""Parameters that nothing uses are told, with the one that may be meant; a name that anything in a
file mentions isn't one of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import linkwright as lw
from helpers.examples import four_bar
from linkwright.model.document import save
from linkwright.words import in_language

EXAMPLES = Path(__file__).parents[2] / "examples"
SKETCHED = {
    "sketch": {"A": [0, 0], "B": [0, 40], "C": [305, 55], "D": [305, 0]},
    "units": {"length": "mm", "angle": "deg", "mass": "kg", "time": "s", "force": "N", "torque": "N*m"},
    "links": {
        "frame": {"points": ["A", "D"]},
        "crank": {"points": ["A", "B"]},
        "rod": {"points": ["B", "C"]},
        "arm": {"points": ["D", "C"]},
    },
    "assembly": {},
    "drives": {"motor": {"turns": "crank", "on": "frame", "speed": "45 rpm"}},
}


def told(data: dict[str, Any], file: Path | None = None) -> dict[str, str]:
    """What mends each unused parameter, of a document or of a file with it."""
    document = lw.Document.model_validate(data)
    if file is not None:
        save(document, file)
    findings = lw.check(file or document)
    assert not [str(finding) for finding in findings if finding.severity == "error"]
    unused = [finding for finding in findings if finding.code == "name.unused-parameter"]
    assert {finding.severity for finding in unused} <= {"warning"}
    return {str(finding.data["name"]): finding.mend for finding in unused}


@pytest.mark.parametrize(
    ("name", "meant"), [("BA", "AB"), ("CB", "BC"), ("CD", "DC"), ("ab", "AB"), ("AB", None), ("DC", None)]
)
def test_a_length_of_a_sketch_by_another_name(name: str, meant: str | None) -> None:
    """The wiper's lengths are AB, BC and DC; the other way round they are no lengths."""
    value = {"A": 38, "a": 38, "B": 38, "C": 305, "D": 60}[name[0]]
    found = told(four_bar(**SKETCHED, parameters={name: value}))
    assert found == ({} if meant is None else {name: f"Rename it to {meant} if that is meant; or remove it."})


def test_one_that_no_length_is_like() -> None:
    data = four_bar(**SKETCHED, parameters={"foo": 3})
    assert told(data) == {"foo": "Use it in an expression; or remove it."}
    with in_language("zh"):
        assert told(data) == {"foo": "在表达式中使用该参数；或将其删除。"}


@pytest.mark.parametrize(
    "more",
    [
        {"parameters": {"DC": "60*p"}},
        {"parameters": {"DC": {"value": 60, "tolerance": "p/100"}}},
        {"measures": {"swing": {"span": "p*C.x"}}},
        {"measures": {"swing": {"span": "C.x"}}, "require": {"swing": ">= p"}},
        {"windows": {"early": ["0 s", "p*1 s"]}},
        {"springs": {"one": {"from": "A", "to": "C", "in": ["frame", "arm"], "stiffness": "p*1 N/m", "free": 10}}},
        {"studies": {"cycle": {"duration": "p*1 s"}}},
        {"studies": {"cycle": {"turns": "1 motor"}, "sweep": {"vary": {"p": {"uniform": [1, 2]}}, "outputs": ["C.x"]}}},
    ],
    ids=["parameter", "tolerance", "measure", "requirement", "window", "spring", "study", "key of a study"],
)
def test_what_is_used_anywhere(more: dict[str, Any]) -> None:
    data = four_bar(**SKETCHED | {key: value for key, value in more.items() if key != "parameters"})
    data["parameters"] = {"DC": 60, **more.get("parameters", {}), "p": 1}
    assert told(data) == {}


def test_a_file_without_a_sketch(tmp_path: Path) -> None:
    """Its parameters are told as well, with a used one of nearly the same name; those of a document made in Python may
    be there for its program."""
    data = four_bar()
    crank = {"points": {"A": [0, 0], "B": ["length_AB", 0]}}
    parameters = {"length_AB": 2, "foo": 3, "lenght_AB": 3}
    data = four_bar(links={**data["links"], "crank": crank}, parameters=parameters)
    assert told(data) == {}
    assert told(data, tmp_path / "model.yaml") == {
        "foo": "Use it in an expression; or remove it.",
        "lenght_AB": "Use it in an expression, or remove it. length_AB is used: check whether that is meant.",
    }


def test_a_sub_assembly_has_its_own(tmp_path: Path) -> None:
    text = (EXAMPLES / "walker_legs.yaml").read_text(encoding="utf-8")
    file = tmp_path / "walker.yaml"
    file.write_text(text.replace("      b: 41.5\n", "      b: 41.5\n      heigth: 7\n", 1), encoding="utf-8")
    (found,) = [f for f in lw.check(file) if f.code == "name.unused-parameter"]
    assert found.element == "subassemblies.leg.parameters.heigth"
    assert found.line == 1 + text[: text.index("      c: 39.3")].count("\n")


def test_the_note_of_a_file_uses_nothing(tmp_path: Path) -> None:
    data = four_bar(parameters={"foo": 3}, note="foo stands here alone")
    assert [*told(data, tmp_path / "model.yaml")] == ["foo"]


@pytest.mark.parametrize("file", sorted(EXAMPLES.glob("*.yaml")), ids=lambda path: path.stem)
def test_no_example_has_one(file: Path) -> None:
    assert not [f for f in lw.check(file) if f.code == "name.unused-parameter"]
