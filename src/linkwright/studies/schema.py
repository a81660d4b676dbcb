"""The JSON Schema of model files: the model's own, with the options of every registered study."""

from __future__ import annotations

from typing import Any

from linkwright.model.schema import json_schema
from linkwright.studies.registry import STUDIES


def file_schema() -> dict[str, Any]:
    """The schema that editors complete from."""
    schema: dict[str, Any] = json_schema()
    known: dict[str, Any] = {}
    for name, study in STUDIES.items():
        options = study.options.model_json_schema(by_alias=True)
        schema.setdefault("$defs", {}).update(options.pop("$defs", {}))
        known[name] = options
    properties: dict[str, Any] = schema["properties"]
    properties["studies"] = {
        "type": "object",
        "description": "what to do with the mechanism, by study",
        "properties": known,
        "additionalProperties": False,
    }
    return schema
