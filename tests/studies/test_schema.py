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
from linkwright.studies.sweep.options import SAMPLES
from linkwright.words import LANGUAGES, catalogue, in_language, say

EXAMPLES = sorted((Path(__file__).parents[2] / "examples").glob("*.yaml"))


@pytest.fixture(scope="module")
def validator() -> Any:
    jsonschema = pytest.importorskip("jsonschema")
    return jsonschema.Draft202012Validator(file_schema())


SHIPPED = {"en": "model.schema.json", "zh": "model.schema.zh.json"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_shipped_schema_is_the_current_one(language: str) -> None:
    """Made by `linkwright schema --lang LANGUAGE > src/linkwright/studies/FILE`."""
    shipped = files("linkwright.studies").joinpath(SHIPPED[language]).read_text("utf-8")
    with in_language(language):
        assert json.loads(shipped) == file_schema()


def _without_texts(schema: Any) -> Any:
    """A schema without what languages differ in."""
    if isinstance(schema, list):
        return [_without_texts(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    texts = {key for key in ("title", "description") if isinstance(schema.get(key), str)}
    return {key: _without_texts(part) for key, part in schema.items() if key not in texts}


def _descriptions(schema: Any) -> Iterator[str]:
    """All descriptions, wherever they stand."""
    if isinstance(schema, list):
        for part in schema:
            yield from _descriptions(part)
    elif isinstance(schema, dict):
        for key, part in schema.items():
            yield from [part] if key == "description" and isinstance(part, str) else _descriptions(part)


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_language_has_the_same_schema_with_all_its_own_texts(language: str) -> None:
    with in_language(language):
        schema = file_schema()
    assert _without_texts(schema) == _without_texts(file_schema())
    with in_language(language):
        known = {say(key) for key in catalogue(language) if key.startswith("schema.")}
    assert {*_descriptions(schema), schema["title"]} == known


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_default_in_a_text_is_the_default(language: str) -> None:
    assert f" {SAMPLES}" in catalogue(language)["schema.SweepOptions.samples"]


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
    """But points of a follower, joints by the names that they have with play or in another tool, tables of springs,
    what ports are and are joined to: these are looked up by what knows them."""
    looked_up = {"at", "knife", "centre", "in", "master", "flipped", "left_out", "force", "torque", "join", "ports"}
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
