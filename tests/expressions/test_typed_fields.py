"""Fields say what their numbers are: in the model, in the options of studies and of exports; one walk finds them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Any

import pytest
from pydantic import BaseModel

from linkwright import compilation
from linkwright.app.job import examine_document
from linkwright.elements import FORCES
from linkwright.elements.entries import ENTRIES
from linkwright.exports import TARGETS
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Frozen, Name
from linkwright.expressions.typed_fields import ELSEWHERE, Context, Quantity, Ref, Sign
from linkwright.model.document import Document
from linkwright.model.known_keys import _inside
from linkwright.model.mechanism import Mechanism
from linkwright.model.walk import ExpressionPlace, Spec, _fields, references, sites
from linkwright.reductions import ENTRIES as MEASURES
from linkwright.studies import STUDIES
from model.given import four_bar

OF_SIGNALS = {"outputs", "signals", "x", "y"}
"""Expressions of any dimension: what is asked for, and formulas of paths."""


def unstated(entry: type[BaseModel], around: bool = False) -> Iterator[str]:
    """The keys whose expressions are of no stated quantity."""
    for key, (_, spec) in _fields(entry).items():
        yield from (f"{entry.__name__}.{key}" for _ in _bare(spec, around) if key not in OF_SIGNALS)
        for part in _parts(spec):
            yield from unstated(part, around or spec.quantity is not None)


def _bare(spec: Spec, around: bool) -> Iterator[type]:
    around = around or spec.quantity is not None
    if spec.form == "value":
        yield from (kind for kind in spec.kinds if issubclass(kind, Expression) and not around)
    for inner in spec.inner:
        yield from _bare(inner, around)


def _parts(spec: Spec) -> Iterator[type[BaseModel]]:
    yield from (kind for kind in spec.kinds if spec.form == "value" and issubclass(kind, BaseModel))
    for inner in spec.inner:
        yield from _parts(inner)


def of_sections() -> list[type[BaseModel]]:
    """The entries of all kinds that the sections of a file may have."""
    sections = [inner for name in Mechanism.model_fields for inner in _inside(Mechanism, name, None)]
    found = dict.fromkeys(kind for section in sections for kind in _inside(section, "NAME", None))
    return [kind for kind in found if isinstance(kind, type) and issubclass(kind, BaseModel)]


def test_all_kinds_of_entries_are_looked_at() -> None:
    kinds = {*of_sections()}
    assert {kind.entry for kind in FORCES.values()} | {*MEASURES.values()} <= kinds
    assert {entry for entries in ENTRIES.values() for entry in entries.values()} <= kinds
    assert BaseModel not in kinds and len(kinds) > 30


@pytest.mark.parametrize(
    "entry",
    [Mechanism, *of_sections(), *(entry.options for entry in (*STUDIES.values(), *TARGETS.values()))],
    ids=lambda entry: str(entry.__name__),
)
def test_every_expression_is_a_stated_quantity(entry: type[BaseModel]) -> None:
    assert [*unstated(entry)] == []


class Part(Frozen):
    """An entry of all kinds of fields."""

    mass: Annotated[Expression | None, Quantity(u.MASS, Sign.POSITIVE, "mass")] = None
    spans: Annotated[dict[Name, tuple[Expression, Expression]], Quantity(u.LENGTH)] = {}
    turned: Annotated[Expression | None, Quantity(lambda c: u.ANGLE if c.entry.link else None)] = None
    numbers: Annotated[tuple[Expression, ...], Quantity(u.PURE)] = ()
    link: Annotated[Name | None, Ref("link")] = None
    other: Annotated[Expression | None, ELSEWHERE] = None


def test_the_walk_goes_in_the_order_of_fields() -> None:
    data: dict[str, Any] = {
        "mass": 1,
        "spans": {"a": [1, 2]},
        "numbers": [3, 4],
        "link": "crank",
        "turned": 5,
        "other": 6,
    }
    part = Part.model_validate(data)
    at = Context(Mechanism.model_validate({"links": {"frame": {"points": {"A": [0, 0]}}}}), ("parts", "p"))
    places = [place for site in sites(part, at) for place in site.places()]
    assert places == [
        ExpressionPlace(("parts", "p", "mass"), Expression(1), u.MASS),
        ExpressionPlace(("parts", "p", "spans", "a"), Expression(1), u.LENGTH),
        ExpressionPlace(("parts", "p", "spans", "a"), Expression(2), u.LENGTH),
        ExpressionPlace(("parts", "p", "turned"), Expression(5), u.ANGLE),
        ExpressionPlace(("parts", "p", "numbers", 0), Expression(3), u.PURE),
        ExpressionPlace(("parts", "p", "numbers", 1), Expression(4), u.PURE),
    ]
    assert [(found.name, found.ref) for found in references(part, at)] == [("crank", Ref("link"))]


def test_a_dimension_that_cannot_be_told_makes_no_place() -> None:
    at = Context(Mechanism.model_validate({"links": {"frame": {"points": {"A": [0, 0]}}}}))
    assert [place for site in sites(Part.model_validate({"turned": 5}), at) for place in site.places()] == []


OPTIONS = [
    ({"cycle": {"duration": "p"}}, u.TIME),
    ({"limits": {"ranges": {"motor": ["0", "p"]}}}, u.ANGLE),
    ({"sweep": {"vary": {"AB": ["40", "p"]}}, "cycle": {"duration": "1 s"}}, u.LENGTH),
    ({"accuracy": {"allocate": {"targets": {"B.x": "p"}, "costs": {"AB": {"reciprocal": 1}}}}}, u.LENGTH),
    ({"accuracy": {"allocate": {"targets": {"swing": "p"}, "costs": {"AB": {"reciprocal": 1}}}}}, u.ANGLE),
    ({"accuracy": {"positions": {"grip": "p"}}}, u.TIME),
    ({"accuracy": {"calibrate": {"points": [{"t": "p", "B.x": 3}]}}}, u.TIME),
    ({"accuracy": {"calibrate": {"points": [{"t": 0, "B.x": "p"}]}}}, u.LENGTH),
]


@pytest.mark.parametrize(("studies", "dimension"), OPTIONS)
def test_a_bare_parameter_takes_its_unit_from_options(
    studies: dict[str, Any], dimension: u.Dimension, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All of them are known before units are inferred: the mechanism is compiled once."""
    made = []
    examine = compilation.examine
    monkeypatch.setattr(compilation, "examine", lambda *given: made.append(1) or examine(*given))
    data = four_bar(
        parameters={"p": 1, "AB": 40},
        measures={"swing": {"span": "rocker.angle"}},
        studies={"cycle": {"turns": "1 motor"}, **studies},
    )
    data["links"]["crank"] = {"points": {"A": [0, 0], "B": ["AB", 0]}}
    compiled = examine_document(Document.model_validate(data)).compiled
    assert compiled is not None
    assert compiled.quantities.dimensions.of("p") == dimension
    assert len(made) == 1
