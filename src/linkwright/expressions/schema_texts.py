"""What the JSON Schema says of entries and their keys: texts of the catalogue, in the present language.

The text of an entry is ``schema.CLASS``, that of a key ``schema.CLASS.KEY`` for the class that declares it. What the
catalogue doesn't describe, of another package, keeps its docstring and the ``description`` of its fields.
"""

from __future__ import annotations

import inspect
from typing import Any

from pydantic import BaseModel, GetJsonSchemaHandler
from pydantic.json_schema import GenerateJsonSchema
from pydantic_core.core_schema import CoreSchema, ModelSchema

from linkwright.findings import Said
from linkwright.words import catalogue


class DescribedSchema(GenerateJsonSchema):
    """Makes the schema of models with the catalogue's texts."""

    def model_schema(self, schema: ModelSchema) -> dict[str, Any]:
        """The schema of a model."""
        cls, made = schema["cls"], super().model_schema(schema)
        made.update(description(cls.__name__))
        for name, field in cls.model_fields.items():
            key = field.alias or name
            if key in made.get("properties", {}):
                made["properties"][key].update(description(f"{_declaring(cls, name).__name__}.{key}"))
        return made


def described(model: type[BaseModel]) -> dict[str, Any]:
    """The schema of a model as files have it, with the catalogue's texts."""
    return model.model_json_schema(by_alias=True, schema_generator=DescribedSchema)


def description(key: str) -> dict[str, str]:
    """The description by ``CLASS`` or ``CLASS.KEY``, as an entry of a schema; nothing where there is none."""
    key = f"schema.{key}"
    return {"description": str(Said(key))} if key in catalogue("en") else {}


class Described:
    """An annotation that describes a value by the catalogue, also where it is one of several that a key may have."""

    def __init__(self, key: str) -> None:
        self.key = key

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return {**handler(schema), **description(self.key)}


def _declaring(cls: type[BaseModel], name: str) -> type:
    """The class, of a model and its bases, that declares a field."""
    return next(base for base in cls.__mro__ if name in inspect.get_annotations(base))
