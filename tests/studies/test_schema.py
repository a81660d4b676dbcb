"""The JSON Schema: shipped, current, and true of the examples."""

from __future__ import annotations

import json
from importlib.resources import files
from pathlib import Path
from typing import Any

import pytest

from linkwright.exports.schema import file_schema
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
