"""The JSON Schema: shipped, current, and true of the examples."""

from __future__ import annotations

import json
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest

from linkwright.exports.schema import file_schema
from linkwright.expressions.dimensions import DimensionError, Dimensions
from linkwright.expressions.field_schema import NAME, QUANTITIES
from linkwright.expressions.language import Node, parse
from linkwright.expressions.units import PURE, Dimension
from linkwright.model.yaml_text import read_text

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.yaml"))


@pytest.fixture(scope="module")
def validator() -> Any:
    jsonschema = pytest.importorskip("jsonschema")
    return jsonschema.Draft202012Validator(file_schema())


def test_the_shipped_schema_is_the_current_one() -> None:
    """Made by `linkwright schema > src/linkwright/studies/model.schema.json`."""
    shipped = files("linkwright.studies").joinpath("model.schema.json").read_text("utf-8")
    assert json.loads(shipped) == file_schema()


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda p: p.stem)
def test_the_examples_are_valid(path: Path, validator: Any) -> None:
    errors = [e.message for e in validator.iter_errors(read_text(path.read_bytes()).data)]
    assert not errors


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("links", {"crank": {"poins": {}}}),
        ("studies", {"cycle": {"samples": 1}}),
        ("studies", {"cycel": {}}),
        ("exports", {"nothing": {}}),
        ("assembly", {"C": "beside B"}),
        ("drives", {"motor": {"turns": 5}}),
    ],
)
def test_mistakes_are_marked(key: str, value: Any, validator: Any) -> None:
    data = read_text(EXAMPLES[0].read_bytes()).data
    assert list(validator.iter_errors({**data, key: value}))


def test_fields_say_their_quantity_with_an_example_and_where_names_stand() -> None:
    schema = file_schema()
    drive = schema["$defs"]["Drive"]["properties"]
    assert (drive["speed"]["x-quantity"], drive["speed"]["examples"]) == (
        "angular speed or speed",
        ["60 rpm", "400 mm/s"],
    )
    assert drive["on"]["x-names"] == "links"
    assert schema["properties"]["require"]["propertyNames"] == {"x-names": "measures"}
    limits = schema["properties"]["studies"]["properties"]["limits"]["properties"]
    assert limits["ranges"]["propertyNames"] == {"x-names": "drives"}


def _names(schema: Any, key: str = "") -> Iterator[str]:
    """The keys whose values are names of which the schema doesn't say what they name."""
    if isinstance(schema, list):
        for part in schema:
            yield from _names(part, key)
    elif isinstance(schema, dict):
        if schema.get("pattern") == NAME["pattern"] and "x-names" not in schema:
            yield key
        for name, part in schema.items():
            if name not in ("patternProperties", "propertyNames"):
                within = name in ("anyOf", "oneOf", "items", "prefixItems", "additionalProperties")
                yield from _names(part, key if within else name)
            elif name == "patternProperties":
                yield from _names([*part.values()], key)


def test_every_name_says_what_it_names() -> None:
    """But points of a follower, joints by the names that they have with play or in another tool, tables of springs:
    these are looked up by what knows them."""
    looked_up = {"at", "knife", "centre", "in", "master", "flipped", "left_out", "force", "torque"}
    assert {*_names(file_schema())} - looked_up == set()


@pytest.mark.parametrize("dimension", QUANTITIES, ids=str)
def test_the_example_of_a_quantity_is_one(dimension: Dimension) -> None:
    dimensions = Dimensions({}, {}, lambda node: PURE)
    node = parse(QUANTITIES[dimension][1])
    assert dimensions.bind(node, dimension) is not None
    assert [other for other in QUANTITIES if other.physical != dimension.physical and _fits(node, other)] == []


def _fits(node: Node, dimension: Dimension) -> bool:
    try:
        Dimensions({}, {}, lambda node: PURE).bind(node, dimension)
    except DimensionError:
        return False
    return True
