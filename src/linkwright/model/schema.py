"""The JSON Schema of model files, from which editors complete and check while one writes."""

from __future__ import annotations

from typing import Any

from linkwright.model.mechanism import VERSION, Document

ID = f"https://linkwright.org/schema/model-{VERSION}.json"


def json_schema() -> dict[str, Any]:
    """The schema of a model file (JSON Schema 2020-12). Studies stand in it as free mappings."""
    schema = _plain(Document.model_json_schema(by_alias=True))
    schema["required"] = ["linkwright", "links"]
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": ID,
        **schema,
        "title": "linkwright model file",
        "description": "A planar mechanism: links, joints, drives, loads, measures and studies.",
    }


def _plain(node: Any) -> Any:
    """Without what pydantic adds and files don't know: titles made from keys, null for what is left out."""
    if isinstance(node, list):
        return [_plain(entry) for entry in node]
    if not isinstance(node, dict):
        return node
    if "properties" in node:
        node = {**node, "properties": {key: _entry(value) for key, value in node["properties"].items()}}
    if "patternProperties" in node:
        node = {**node, "additionalProperties": False}
    node = {key: value for key, value in node.items() if key not in ("title", "default") or isinstance(value, dict)}
    return {key: _plain(value) for key, value in node.items()}


def _entry(schema: dict[str, Any]) -> dict[str, Any]:
    """The schema of one key that may be left out: what stands there when it isn't."""
    options = [option for option in schema.get("anyOf", []) if option != {"type": "null"}]
    if "anyOf" not in schema or len(options) == len(schema["anyOf"]):
        return schema
    rest = {key: value for key, value in schema.items() if key != "anyOf"}
    return {**rest, **options[0]} if len(options) == 1 else {**rest, "anyOf": options}
