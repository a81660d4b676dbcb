"""The JSON Schema of model files, with the options of every study and export."""

from __future__ import annotations

from typing import Any

from linkwright.exports.registry import TARGETS
from linkwright.studies.schema import studies_schema, with_section


def file_schema() -> dict[str, Any]:
    """The schema that editors complete from."""
    return with_section(studies_schema(), "exports", "what to write for other tools, by target", TARGETS)
