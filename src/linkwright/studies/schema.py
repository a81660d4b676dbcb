"""The JSON Schema of model files: the model's own, with the options of whatever is registered for its sections."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from linkwright.expressions.schema_texts import described
from linkwright.model.schema import json_schema
from linkwright.plugins import load
from linkwright.studies.registry import STUDIES
from linkwright.studies.sections import Optioned


def studies_schema() -> dict[str, Any]:
    """The model's schema with the options of every study."""
    load("studies")
    return with_section(json_schema(), "studies", STUDIES)


def with_section(schema: dict[str, Any], section: str, registered: Mapping[str, Optioned]) -> dict[str, Any]:
    """The schema with the options of each registered entry of a section."""
    known: dict[str, Any] = {}
    for name, entry in registered.items():
        options = described(entry.options)
        schema.setdefault("$defs", {}).update(options.pop("$defs", {}))
        known[name] = options
    schema["properties"][section] = {
        "type": "object",
        "description": schema["properties"][section]["description"],
        "properties": known,
        "additionalProperties": False,
    }
    return schema
