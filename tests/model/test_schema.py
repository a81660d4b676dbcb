"""The JSON Schema: valid, says something of every key, and takes what the reader takes."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from linkwright.model.document import Document
from linkwright.model.schema import json_schema
from linkwright.model.yaml_text import read_text
from model.given import DATA, four_bar

EXAMPLES = [
    *(DATA / f"{name}.yaml" for name in ("five_bar", "paper_feeder", "slider_crank_gas")),
    *sorted((Path(__file__).parents[2] / "examples").glob("*.yaml")),
]


def schemas(node: Any) -> Iterator[dict[str, Any]]:
    """All schemas with keys inside a schema."""
    if isinstance(node, dict):
        if isinstance(node.get("properties"), dict):
            yield node
        for entry in node.values():
            yield from schemas(entry)
    elif isinstance(node, list):
        for entry in node:
            yield from schemas(entry)


def errors(data: Any) -> list[str]:
    jsonschema = pytest.importorskip("jsonschema")
    validator = jsonschema.Draft202012Validator(json_schema())
    return [error.message for error in validator.iter_errors(data)]


def test_it_is_a_schema() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    jsonschema.Draft202012Validator.check_schema(json_schema())


def test_it_names_itself_and_is_plain_data() -> None:
    schema = json_schema()
    assert schema["$schema"].startswith("https://json-schema.org/")
    assert schema["$id"] == "urn:linkwright:model:1"
    assert schema["title"]
    assert json.loads(json.dumps(schema)) == schema
    assert schema["required"] == ["linkwright", "links"]


def test_every_key_is_described() -> None:
    for schema in schemas(json_schema()):
        for key, entry in schema["properties"].items():
            assert entry.get("description"), key
            assert "``" not in entry["description"]


def test_every_key_of_the_model_is_there() -> None:
    assert set(json_schema()["properties"]) == {field.alias or name for name, field in Document.model_fields.items()}
    assert "in" in json_schema()["$defs"]["Load"]["properties"]


def test_pydantic_s_own_schema_works_too() -> None:
    assert Document.model_json_schema(by_alias=True)["properties"]["links"]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_the_examples_are_valid(path: Path) -> None:
    assert not errors(read_text(path.read_bytes()).data)


@pytest.mark.parametrize(
    "sections",
    [
        {"parameters": {"a": 1, "b": "2 mm", "c": {"value": 3, "tolerance": [0, 1]}}},
        {"loads": {"l": {"on": "crank", "at": [1, 2], "force": ["1 N", 2], "in": "crank"}}},
        {"loads": {"l": {"on": "crank", "at": "B", "force": "3 N", "along": "s"}}},
        {"windows": {"w": [0, 1], "v": {"motor.angle": [0, 90]}}},
        {
            "measures": {"m": {"value": "B.x", "where": "max B.y", "wrap": [0, 1], "unit": "m"}},
            "require": {"m": "1 .. 2"},
        },
        {"tables": {"c": {"points": [[0, 1], ["1 s", 2]], "between": "linear"}}},
        {"assembly": {"C": [1, 2], "K": "ahead of B along rail"}},
        {"studies": {"cycle": {"period": "2 s"}}},
        {"parameters": {"曲柄": 1}},
    ],
)
def test_it_takes_what_the_reader_takes(sections: dict[str, Any]) -> None:
    data = four_bar(**sections)
    Document.model_validate(data)
    assert not errors(data)


@pytest.mark.parametrize(
    "sections",
    [
        {"linkwright": 2},
        {"pistons": {}},
        {"links": {"frame": {"point": {}}}},
        {"links": {"1st": {"points": {}}}},
        {"links": {"a b": {"points": {}}}},
        {"gravity": [1]},
        {"gravity": 9.81},
        {"drives": {"m": {"turns": "crank"}}},
        {"tables": {"c": {"between": "nearest"}}},
        {"joints": {"j": {"line": ["A", "B"]}}},
        {"assembly": {"C": "north of B-D"}},
        {"parameters": {"a": [1]}},
        {"require": {"m": "= 3"}},
    ],
)
def test_it_refuses_what_the_reader_refuses(sections: dict[str, Any]) -> None:
    assert errors(four_bar(**sections))
