"""The JSON Schema of model files, from which editors complete and check while one writes."""

from __future__ import annotations

from typing import Any

from linkwright.expressions.schema_texts import described
from linkwright.findings import Said
from linkwright.model.document import VERSION, Document

_NAMED = ("properties", "patternProperties", "$defs")
"""Keywords whose entries are schemas by name."""


def json_schema() -> dict[str, Any]:
    """The schema of a model file (JSON Schema 2020-12), described in the present language. Studies and exports stand in
    it as free mappings."""
    schema = _plain(described(Document))
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": f"urn:linkwright:model:{VERSION}",
        **schema,
        "title": str(Said("schema.title")),
        "required": ["linkwright", "links"],
    }


def _plain(schema: Any) -> Any:
    """Without what pydantic adds and files don't know: titles made from keys, null for what is left out."""
    if isinstance(schema, list):
        return [_plain(entry) for entry in schema]
    if not isinstance(schema, dict):
        return schema
    schema = {key: value for key, value in _without_null(schema).items() if key not in ("title", "default")}
    if "patternProperties" in schema:
        schema["additionalProperties"] = False
    if "description" in schema:
        schema["description"] = schema["description"].replace("``", "'")
    return {
        key: {name: _plain(entry) for name, entry in value.items()} if key in _NAMED else _plain(value)
        for key, value in schema.items()
    }


def _without_null(schema: dict[str, Any]) -> dict[str, Any]:
    """The schema of a key where it is given: without the null that stands for its absence."""
    options = [option for option in schema.get("anyOf", []) if option != {"type": "null"}]
    if len(options) == len(schema.get("anyOf", [])):
        return schema
    rest = {key: value for key, value in schema.items() if key != "anyOf"}
    return {**rest, **options[0]} if len(options) == 1 else {**rest, "anyOf": options}
