"""The acceleration of gravity as a file states it: the earth's by name, or a vector."""

from __future__ import annotations

import re
from typing import Any

from linkwright.expressions.fields import Expression, TypedParts
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.units import ACCELERATION
from linkwright.expressions.written import Written, fault, unexpected

EARTH = 9.80665
"""Standard gravity (m/s^2)."""
_EARTH = f"{EARTH} m/s^2"


class Gravity(Written):
    """``earth`` (down is -y), ``earth along [x, y]`` (a direction of any length), or the vector ``[gx, gy]``.

    ``parts`` are the components along x and y of the frame, as expressions of an acceleration.
    """

    __slots__ = ("parts",)
    json_type = {
        "anyOf": [
            {"type": "string", "pattern": r"^\s*earth(\s+along\s+\[.+,.+\])?\s*$"},
            {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 2},
        ]
    }
    spellings = {
        r"(?i:earth|g|1 ?g|true|yes|down)|地球|重力|向下|是|有": "earth",
        r"[-+]?(\d+(?:\.\d*)?)": r"[0, -\1 m/s^2]",
        r"[-+]?(\d+(?:\.\d*)?\s*m+/s.*)": r"[0, -\1]",
    }
    parts: tuple[Expression, Expression]

    _PATTERN = re.compile(r"\s*earth(?:\s+along\s+\[(.+)\])?\s*", re.S)

    def read(self, raw: Any) -> None:
        if isinstance(raw, list | tuple) and len(raw) == 2:
            parts = (Expression(raw[0]), Expression(raw[1]))
            self.set_attribute("raw", tuple(part.raw for part in parts))
            self.set_attribute("parts", parts)
            return
        match = self._PATTERN.fullmatch(raw) if isinstance(raw, str) else None
        if match is None:
            raise self.unexpected("gravity", raw)
        self.set_attribute(
            "parts", (Expression("0 m/s^2"), Expression(f"-{_EARTH}")) if match[1] is None else _along(match[1], raw)
        )

    def quantities(self) -> TypedParts:
        return [(part, Quantity(ACCELERATION)) for part in self.parts]

    def part_names(self) -> tuple[str, ...]:
        return ("x", "y")


def _along(inside: str, raw: str) -> tuple[Expression, Expression]:
    """The earth's gravity along a direction; ``inside`` is what stands in its brackets."""
    commas = [i for i, letter in enumerate(inside) if letter == ","]
    outer = [i for i in commas if inside[:i].count("(") == inside[:i].count(")")]
    if len(outer) != 1:
        raise unexpected("gravity", raw)
    x, y = (Expression(part.strip()) for part in (inside[: outer[0]], inside[outer[0] + 1 :]))
    if x.bare_number() == 0 == y.bare_number():
        raise fault("gravity.no-direction")
    return tuple(Expression(f"{_EARTH}*({one.text})/hypot({x.text}, {y.text})") for one in (x, y))  # type: ignore[return-value]
