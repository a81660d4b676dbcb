"""Models don't change: neither their parts nor what is inside them; they copy, pickle and hash as values."""

from __future__ import annotations

import copy
import pickle
from collections.abc import Callable
from typing import Any

import pytest
from pydantic import ValidationError

from linkwright.expressions.fields import AssemblyRule, Expression, Position
from linkwright.expressions.written import FrozenDict
from linkwright.findings import Finding, ModelError, Term, raise_errors
from linkwright.model.document import Document, load
from model.given import DATA, four_bar

NAMES = ["five_bar", "paper_feeder", "slider_crank_gas"]


def document() -> Document:
    return load(DATA / "paper_feeder.yaml")


@pytest.mark.parametrize(
    "change",
    [
        lambda d: setattr(d, "name", "x"),
        lambda d: setattr(d.links["crank"], "mass", None),
        lambda d: d.links.update(x=1),
        lambda d: d.links.pop("crank"),
        lambda d: d.links.popitem(),
        lambda d: d.links.clear(),
        lambda d: d.links.setdefault("x", 1),
        lambda d: d.links.__setitem__("x", 1),
        lambda d: d.links.__delitem__("crank"),
        lambda d: d.links.__ior__({"x": 1}),
        lambda d: d.links["crank"].points.clear(),
        lambda d: d.studies["cycle"].update(samples=3),
        lambda d: setattr(d.parameters["AB"].value, "raw", 1),
        lambda d: setattr(d.parameters["AB"].value, "node", None),
        lambda d: delattr(d.parameters["AB"].value, "raw"),
        lambda d: setattr(d.parameters["AB"].value.node, "value", 1),
    ],
)
def test_nothing_can_be_changed(change: Callable[[Document], Any]) -> None:
    target = document()
    with pytest.raises((TypeError, ValidationError, AttributeError)):
        change(target)
    assert target == document()


def test_options_of_studies_are_frozen_through_and_through() -> None:
    raw = {"workspace": {"for": {"alpha": [0, 60, 90]}, "modes": "all"}}
    options = Document.model_validate(four_bar(studies=raw)).studies["workspace"]
    raw["workspace"]["for"]["alpha"].append(5)  # type: ignore[index]
    assert options == {"for": {"alpha": (0, 60, 90)}, "modes": "all"}
    with pytest.raises(TypeError):
        options["for"]["alpha"] = 1


def test_what_is_put_in_may_change_afterwards() -> None:
    data = four_bar()
    target = Document.model_validate(data)
    data["links"]["crank"]["points"]["B"][0] = 99
    assert target.links["crank"].points["B"].raw == (40, 0)


@pytest.mark.parametrize("name", NAMES)
def test_copies_and_pickles_are_equal(name: str) -> None:
    target = load(DATA / f"{name}.yaml")
    for twin in (copy.copy(target), copy.deepcopy(target), pickle.loads(pickle.dumps(target)), target.model_copy()):
        assert twin == target
        assert hash(twin) == hash(target)
    assert len({load(DATA / f"{name}.yaml"), target}) == 1


def test_equality_is_of_what_is_written() -> None:
    assert Expression(155) == Expression(155.0)
    assert hash(Expression(155)) == hash(Expression(155.0))
    assert Expression("155 mm") != Expression("155mm")
    assert Position([0, "AB"]) == Position((0, "AB"))
    assert AssemblyRule([0, 1]) == AssemblyRule((0, 1))
    assert Expression("open") != AssemblyRule("open")
    assert repr(Expression("AB")) == "Expression('AB')"


def test_frozen_dicts_are_still_dicts() -> None:
    frozen = FrozenDict(a=1)
    assert frozen == {"a": 1}
    assert frozen | {"b": 2} == {"a": 1, "b": 2}
    assert pickle.loads(pickle.dumps(frozen)) == frozen


def test_findings_are_values() -> None:
    finding = Finding(
        "file.expected",
        ("a",),
        {"wanted": Term("vector"), "given": Term("given-list", count=1), "hint": Term("vector-as")},
        3,
    )
    error = ModelError([finding])
    assert pickle.loads(pickle.dumps(error)).findings == (finding,)
    assert copy.deepcopy(finding) == finding
    assert finding.as_dict()["what"] == "Expected [x, y], got a list of length 1."
    assert str(error).startswith("line 3: a: Expected")
    assert len({Term("vector"), Term("vector"), Term("list")}) == 2


def test_warnings_are_not_raised() -> None:
    raise_errors([Finding("file.empty", severity="warning")])
    with pytest.raises(ModelError):
        raise_errors([Finding("file.empty")])
