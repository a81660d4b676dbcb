"""The JSON Schema of model files, with the options of every study and export."""

from __future__ import annotations

from typing import Any

from linkwright.exports.registry import TARGETS
from linkwright.model.references import KINDS
from linkwright.studies.schema import studies_schema, with_section


def file_schema() -> dict[str, Any]:
    """The schema that editors complete from, described in the present language."""
    schema = with_section(studies_schema(), "exports", TARGETS)
    return dict(_with_sections(schema))


def _with_sections(schema: Any) -> Any:
    """The schema in which names say in which section of the file that stands which they name."""
    if isinstance(schema, list):
        return [_with_sections(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    made = {key: _with_sections(part) for key, part in schema.items()}
    if isinstance(kind := made.get("x-names"), str):
        made["x-names"] = KINDS[kind].section
    return made
