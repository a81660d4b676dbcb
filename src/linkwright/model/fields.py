"""The kinds of value that a model file's entries hold; each parses itself and keeps what was written."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any, NoReturn, TypeVar

from pydantic import BaseModel, ConfigDict, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from linkwright.model.expressions import ExpressionError, Node, Number, parse

NAME = re.compile(r"^[^\W\d]\w*$")
RESERVED = frozenset({"t", "pi", "start", "end"})


def fault(code: str, **data: Any) -> PydanticCustomError:
    """A validation error that becomes the finding ``code``."""
    return PydanticCustomError("finding", "{code}", {"code": code, **data})  # type: ignore[arg-type]


def check_name(name: str) -> str:
    """A plain identifier (any script), not one of the reserved words."""
    if not NAME.match(name) or name in RESERVED:
        raise fault("file.bad-name", name=name)
    return name


class Frozen(BaseModel):
    """Base of the model's parts: immutable, and an unknown key is a fault."""

    model_config = ConfigDict(frozen=True, extra="forbid", populate_by_name=True, arbitrary_types_allowed=True)


class FrozenDict(dict[str, Any]):
    """A mapping that can't be changed."""

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise TypeError("a mechanism is immutable; build a new one")

    __setitem__ = __delitem__ = clear = pop = popitem = setdefault = update = _refuse  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return (FrozenDict, (dict(self),))


T = TypeVar("T", bound="Written")


class Written:
    """A value that parses from what is written in the file and gives it back unchanged."""

    __slots__ = ("raw",)
    json_type: Any = {"type": "string"}

    def __init__(self, raw: Any) -> None:
        object.__setattr__(self, "raw", raw)
        self.read(raw)

    def read(self, raw: Any) -> None:
        """Parse and store; raises :func:`fault`."""

    def put(self, name: str, value: Any) -> None:
        object.__setattr__(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        raise TypeError("a mechanism is immutable; build a new one")

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self.raw == other.raw  # type: ignore[attr-defined]

    def __hash__(self) -> int:
        return hash((type(self), str(self.raw)))

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.raw!r})"

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (self.raw,))

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(
            lambda raw: raw if isinstance(raw, cls) else cls(raw),
            serialization=core_schema.plain_serializer_function_ser_schema(lambda value: value.raw),
        )

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return dict(cls.json_type)


class Expression(Written):
    """A number, or arithmetic on numbers, units and parameters (``155``, ``155 mm``, ``AB + 2*e``)."""

    __slots__ = ("node",)
    json_type = {"type": ["number", "string"]}
    node: Node

    def read(self, raw: Any) -> None:
        if isinstance(raw, bool) or not isinstance(raw, int | float | str):
            raise fault("file.expected", wanted="a number or an expression", given=describe(raw))
        if isinstance(raw, int | float):
            if not math.isfinite(raw):
                raise fault("file.not-finite", given=raw)
            self.put("node", parse_text(repr(raw)))
        else:
            self.put("node", parse_text(raw))

    @property
    def text(self) -> str:
        return str(self.raw)

    def bare_number(self) -> float | None:
        """The number when it is a lone literal without a unit."""
        return self.node.value if isinstance(self.node, Number) and self.node.unit is None else None


def parse_text(text: str) -> Node:
    """Parse an expression; a fault says what is wrong with it."""
    try:
        return parse(text)
    except ExpressionError as error:
        raise fault("expression.syntax", text=text[:80], reason=str(error)) from None


def describe(raw: Any) -> str:
    """What kind of value was given, in plain words."""
    if raw is None:
        return "nothing"
    if isinstance(raw, bool):
        return "true" if raw else "false"
    if isinstance(raw, Mapping):
        return "a mapping"
    if isinstance(raw, list | tuple):
        return f"a list of {len(raw)}"
    return repr(raw)[:60]


class Position(Written):
    """Coordinates in a link's frame: ``[x, y]``, or polar ``r at angle``."""

    __slots__ = ("first", "polar", "second")
    json_type = {
        "anyOf": [
            {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 2},
            {"type": "string", "pattern": " at "},
        ]
    }
    first: Expression
    second: Expression
    polar: bool

    def read(self, raw: Any) -> None:
        if isinstance(raw, str) and (parts := raw.split(" at ")) and len(parts) == 2:
            self.put("polar", True)
        elif isinstance(raw, list | tuple) and len(raw) == 2:
            parts = list(raw)
            self.put("polar", False)
        else:
            raise fault("file.expected", wanted="[x, y] or 'r at angle'", given=describe(raw))
        self.put("first", Expression(parts[0]))
        self.put("second", Expression(parts[1]))
        if isinstance(raw, tuple):
            self.put("raw", list(raw))


class LineOn(Written):
    """A line fixed in a link: ``G at 90 deg``, through the link's point G in that direction."""

    __slots__ = ("angle", "point")
    json_type = {"type": "string", "pattern": "^\\s*\\S+ at "}
    point: str
    angle: Expression

    def read(self, raw: Any) -> None:
        parts = raw.split(" at ") if isinstance(raw, str) else []
        if len(parts) != 2:
            raise fault("file.expected", wanted="a line such as 'G at 90 deg'", given=describe(raw))
        self.put("point", parts[0].strip())
        self.put("angle", Expression(parts[1]))


class Shape(Written):
    """Where the mass sits: ``rod A-B`` (slender, uniform), ``disc 40 mm at A`` (radius), ``point E``."""

    __slots__ = ("form", "points", "radius")
    json_type = {"type": "string", "pattern": "^(rod|disc|point) "}
    form: str
    points: tuple[str, ...]
    radius: Expression | None

    _PATTERN = re.compile(r"^\s*(?:rod\s+(\w+)\s*-\s*(\w+)|disc\s+(.+?)\s+at\s+(\w+)|point\s+(\w+))\s*$")

    def read(self, raw: Any) -> None:
        match = self._PATTERN.match(raw) if isinstance(raw, str) else None
        if match is None:
            raise fault("file.expected", wanted="'rod A-B', 'disc RADIUS at A' or 'point A'", given=describe(raw))
        start, end, radius, centre, single = match.groups()
        self.put("form", raw.split()[0])
        self.put("points", tuple(p for p in (start, end, centre, single) if p))
        self.put("radius", Expression(radius) if radius else None)


class AssemblyRule(Written):
    """Which way a group is put together: ``left of B-D``, ``right of B-D``, ``open``, ``crossed``,
    ``ahead of B along rail``, ``behind B along rail``, or the point's position in a sketch pose ``[x, y]``."""

    __slots__ = ("along", "reference", "sketch", "word")
    json_type = {
        "anyOf": [
            {"type": "string", "pattern": "^(left of|right of|ahead of|behind|open|crossed)"},
            {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 2},
        ]
    }
    word: str
    reference: tuple[str, ...]
    along: str | None
    sketch: Position | None

    _PATTERN = re.compile(
        r"^\s*(?:(left|right) of (\w+)\s*-\s*(\w+)|(ahead) of (\w+) along (\w+)|(behind) (?:of )?(\w+) along (\w+)"
        r"|(open)|(crossed))\s*$"
    )

    def read(self, raw: Any) -> None:
        if isinstance(raw, list | tuple):
            self._put("sketch", (), None, Position(raw))
            return
        match = self._PATTERN.match(raw) if isinstance(raw, str) else None
        if match is None:
            wanted = "'left of B-D', 'right of B-D', 'open', 'crossed', 'ahead of B along JOINT', 'behind B along JOINT' or [x, y]"
            raise fault("file.expected", wanted=wanted, given=describe(raw))
        words = [group for group in match.groups() if group]
        sliding = words[0] in ("ahead", "behind")
        self._put(words[0], tuple(words[1:2] if sliding else words[1:]), words[2] if sliding else None, None)

    def _put(self, word: str, reference: tuple[str, ...], along: str | None, sketch: Position | None) -> None:
        for name, value in zip(("word", "reference", "along", "sketch"), (word, reference, along, sketch), strict=True):
            self.put(name, value)


class Requirement(Written):
    """A limit on a measure: ``>= 680 mm``, ``<= 5 N*m``, or a range ``10 mm .. 12 mm``."""

    __slots__ = ("high", "low")
    json_type = {"type": "string"}
    low: Expression | None
    high: Expression | None

    def read(self, raw: Any) -> None:
        text = raw.strip() if isinstance(raw, str) else ""
        low = high = None
        if text.startswith(">="):
            low = Expression(text[2:])
        elif text.startswith("<="):
            high = Expression(text[2:])
        elif ".." in text:
            low, high = (Expression(part) for part in text.split("..", 1))
        else:
            raise fault("file.expected", wanted="'>= VALUE', '<= VALUE' or 'LOW .. HIGH'", given=describe(raw))
        self.put("low", low)
        self.put("high", high)
