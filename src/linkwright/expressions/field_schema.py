"""What the JSON Schema says of typed fields: the quantity of a number with an example, of a name what it names."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from linkwright.expressions import units as u
from linkwright.expressions.units import Dimension

Schema = dict[str, Any]

# Editors match patterns as ECMAScript does, where \w knows ASCII only: say what a name doesn't hold.
_NO_WORD = r"\s.,:;+*/^()\[\]{}'\"<>=!?|&%@`#-"
NAME = {"type": "string", "pattern": f"^[^0-9{_NO_WORD}][^{_NO_WORD}]*$"}
"""A name."""

QUANTITIES: dict[Dimension, tuple[str, str]] = {
    u.PURE: ("number", "1.5"),
    u.LENGTH: ("length", "120 mm"),
    u.ANGLE: ("angle", "30 deg"),
    u.MASS: ("mass", "0.6 kg"),
    u.TIME: ("time", "0.2 s"),
    u.SPEED: ("speed", "400 mm/s"),
    u.OMEGA: ("angular speed", "60 rpm"),
    u.ACCELERATION: ("acceleration", "2 m/s^2"),
    u.ALPHA: ("angular acceleration", "100 rad/s^2"),
    u.FORCE: ("force", "50 N"),
    u.TORQUE: ("torque", "2 N*m"),
    u.PRESSURE: ("pressure", "210 GPa"),
    u.INERTIA: ("moment of inertia", "0.002 kg*m^2"),
    u.STIFFNESS: ("stiffness", "2 N/mm"),
    u.TORSIONAL_STIFFNESS: ("torsional stiffness", "0.5 N*m/rad"),
    u.DAMPING: ("damping", "20 N*s/m"),
    u.TORSIONAL_DAMPING: ("torsional damping", "0.1 N*m*s/rad"),
}
"""The quantities by their dimensions, each with an example as a file has it."""

_WITHIN = ("anyOf", "oneOf", "prefixItems")


def with_quantity(schema: Schema, dimensions: Iterable[Dimension]) -> Schema:
    """A field's schema whose numbers say of which quantity they are, or of which of several, each with an example."""
    named = [QUANTITIES[of] for of in dimensions if of in QUANTITIES]
    said = {"x-quantity": " or ".join(name for name, _ in named), "examples": [example for _, example in named]}
    return _noted(schema, lambda leaf: leaf.get("type") == ["number", "string"], said) if named else schema


def with_kind(schema: Schema, kind: str) -> Schema:
    """A field's schema whose names say which kind of element they name."""
    return _noted(schema, lambda leaf: leaf.get("pattern") == NAME["pattern"], {"x-names": kind})


def _noted(schema: Schema, meant: Callable[[Schema], bool], said: Schema) -> Schema:
    """The schema with more said of the values in it that are meant, where these don't say it of themselves."""
    if meant(schema):
        return {**said, **schema}
    noted = dict(schema)
    for key in _WITHIN:
        if key in schema:
            noted[key] = [_noted(part, meant, said) for part in schema[key]]
    if isinstance(schema.get("items"), dict):
        noted["items"] = _noted(schema["items"], meant, said)
    for key in ("additionalProperties", "patternProperties"):
        held = schema.get(key)
        if isinstance(held, dict):
            noted[key] = (
                {name: _noted(part, meant, said) for name, part in held.items()}
                if key == "patternProperties"
                else _noted(held, meant, said)
            )
    return noted
