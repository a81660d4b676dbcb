"""The kinds of value that a model file's entries hold; each parses itself and keeps what was written."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from typing import Annotated, Any

from pydantic import BeforeValidator, WithJsonSchema

from linkwright.expressions.field_schema import NAME
from linkwright.expressions.full_width import TO_ASCII
from linkwright.expressions.language import ExpressionError, Node, Number, parse
from linkwright.expressions.parser import reads
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.expressions.units import ANGLE, LENGTH, Dimension
from linkwright.expressions.written import (
    MAX_NAME,
    Frozen,
    FrozenDict,
    Written,
    check_name,
    describe,
    fault,
    free_text,
    frozen,
    plain_number,
    short_text,
    unexpected,
)
from linkwright.findings import Term
from linkwright.notation import Pair, Scalar
from linkwright.notation.planar import unit_vector

__all__ = [
    "TWO_POINTS",
    "AssemblyRule",
    "Expression",
    "Frozen",
    "FrozenDict",
    "LineOn",
    "LongText",
    "Name",
    "Names",
    "Place",
    "Position",
    "Requirement",
    "Shape",
    "Text",
    "Two",
    "Written",
    "check_name",
    "describe",
    "fault",
    "frozen",
    "pair",
    "parse_text",
]

Name = Annotated[str, BeforeValidator(check_name), WithJsonSchema(NAME)]

_NOT_NUMBERS = frozenset({"nan", "inf", "infinity", ".nan", ".inf"})


Text = Annotated[str, BeforeValidator(short_text), WithJsonSchema({"type": "string"})]
LongText = Annotated[str, BeforeValidator(free_text), WithJsonSchema({"type": "string"})]


TypedParts = Iterable[tuple["Expression", Quantity | None]]
"""Expressions with what they are; ``None`` where the field says that."""

Names = Iterable[tuple[str, Ref | None]]
"""Names with what they are; ``None`` where the field says that."""

_LENGTH, _ANGLE = Quantity(LENGTH), Quantity(ANGLE)


class Expression(Written):
    """A number, or arithmetic on numbers, units and parameters (``155``, ``155 mm``, ``AB + 2*e``)."""

    __slots__ = ("node",)
    json_type = {"type": ["number", "string"]}
    node: Node

    def read(self, raw: Any) -> None:
        if not isinstance(raw, str):
            raw = plain_number(raw, "expression")
            self.set_attribute("raw", raw)
        elif raw.strip().lstrip("+-").lower() in _NOT_NUMBERS:
            raise fault("file.not-finite", given=raw.strip())
        self.set_attribute("node", parse_text(str(raw)))

    def quantities(self) -> TypedParts:
        return ((self, None),)

    @property
    def text(self) -> str:
        """As it is written."""
        return str(self.raw)

    def bare_number(self) -> float | None:
        """The number when it is a lone literal without a unit."""
        return self.node.value if isinstance(self.node, Number) and self.node.unit is None else None


Two = tuple[Expression, Expression]


def parse_text(text: str) -> Node:
    """Parse an expression; a fault says what is wrong with it."""
    try:
        return parse(text)
    except ExpressionError as error:
        from linkwright.expressions.respelled import syntax_fault

        code, data = syntax_fault(text, error.reason)
        raise fault(code, **data) from None


_BOTH = re.compile(r"\s*[\[(]?\s*([^,~…()\[\]]+?)\s*(?:,|~|…|\.\.|\bto\b|至|到)\s*([^,~…()\[\]]+?)\s*[\])]?\s*")
"""Two values that aren't written as a list."""


def pair(wanted: str) -> Callable[[Any], Any]:
    """A validator of lists of two; ``wanted`` is the phrase that says what they hold."""

    def check(raw: Any) -> Any:
        if isinstance(raw, str) and len(raw) <= MAX_NAME and (both := _BOTH.fullmatch(raw.translate(TO_ASCII))):
            raise unexpected(wanted, raw, Term("write-bare", text=f"[{both[1]}, {both[2]}]"))
        if not isinstance(raw, list | tuple) or len(raw) != 2:
            raise unexpected(wanted, raw)
        return tuple(raw)

    return check


class Position(Written):
    """Coordinates in a link's frame: ``[x, y]``, polar ``r at angle``, or those of the ``sketch``."""

    __slots__ = ("first", "polar", "second", "sketched")
    json_type = {
        "anyOf": [
            {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 2},
            {"type": "string", "pattern": " at |^sketch$"},
        ]
    }
    spellings = {r"[\[(]?([^,()\[\]]+),\s*([^,()\[\]]+)[\])]?": r"[\1, \2]", r"(.+?)\s*[@<∠]\s*(.+)": r"\1 at \2"}
    first: Expression
    second: Expression
    polar: bool
    sketched: bool

    def read(self, raw: Any) -> None:
        self.set_attribute("sketched", raw == "sketch")
        if self.sketched:
            self.set_attribute("polar", False)
            parts: list[Any] = [0, 0]
        elif isinstance(raw, str) and len(parts := raw.split(" at ")) == 2:
            self.set_attribute("polar", True)
        elif isinstance(raw, list | tuple) and len(raw) == 2:
            parts = list(raw)
            self.set_attribute("polar", False)
        elif isinstance(raw, Mapping) and raw.keys() == {"x", "y"}:
            raise unexpected("position", raw, Term("write-bare", text=f"[{raw['x']}, {raw['y']}]"))
        else:
            raise self.unexpected("position", raw)
        self.set_attribute("first", Expression(parts[0]))
        self.set_attribute("second", Expression(parts[1]))
        if not self.polar and not self.sketched:
            self.set_attribute("raw", (self.first.raw, self.second.raw))

    def quantities(self) -> TypedParts:
        return (self.first, _LENGTH), (self.second, _ANGLE if self.polar else _LENGTH)

    def part_names(self) -> tuple[str, ...]:
        return ("radius", "angle") if self.polar else ("x", "y")

    def coordinates(self, number: Callable[[Expression, Dimension], Scalar], point: Callable[[str], Pair]) -> Pair:
        """The coordinates (m) that it states; ``number`` gives values in SI, ``point`` other points of the link."""
        first = number(self.first, LENGTH)
        if not self.polar:
            return Pair(first, number(self.second, LENGTH))
        heading = unit_vector(number(self.second, ANGLE))
        return Pair(first * heading.x, first * heading.y)


class Place(Position):
    """The place of a point of a sketch: as a position, or ``[x, y, z]`` in the vehicle's axes."""

    __slots__ = ("third",)
    json_type = {
        "anyOf": [
            {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 3},
            {"type": "string", "pattern": " at |^sketch$"},
        ]
    }
    third: Expression | None

    def read(self, raw: Any) -> None:
        self.set_attribute("third", None)
        if not isinstance(raw, list | tuple) or len(raw) != 3:
            super().read(raw)
            return
        self.set_attribute("polar", False)
        self.set_attribute("sketched", False)
        for name, part in zip(("first", "second", "third"), raw, strict=True):
            self.set_attribute(name, Expression(part))
        self.set_attribute("raw", tuple(part.raw for part in self.parts))

    @property
    def parts(self) -> tuple[Expression, ...]:
        """The coordinates, two or three."""
        return (self.first, self.second) if self.third is None else (self.first, self.second, self.third)

    def quantities(self) -> TypedParts:
        return super().quantities() if self.third is None else [(part, _LENGTH) for part in self.parts]

    def part_names(self) -> tuple[str, ...]:
        return super().part_names() if self.third is None else ("x", "y", "z")


class LineOn(Written):
    """A line fixed in a link: ``G at 90 deg``, through the link's point G in that direction."""

    __slots__ = ("angle", "point")
    json_type = {"type": "string", "pattern": "^\\s*\\S+ at "}
    spellings = {r"([^\W\d]\w*)\s*[,:@ ]\s*([-+\d.].*)": r"\1 at \2", r"([^\W\d]\w*)": r"\1 at 0 deg"}
    point: str
    angle: Expression

    def read(self, raw: Any) -> None:
        parts = raw.split(" at ") if isinstance(raw, str) else []
        if len(parts) != 2:
            raise self.unexpected("line", raw)
        self.set_attribute("point", check_name(parts[0].strip()))
        self.set_attribute("angle", Expression(parts[1]))

    def quantities(self) -> TypedParts:
        return ((self.angle, _ANGLE),)

    def names(self) -> Names:
        return ((self.point, None),)


TWO_POINTS = r"\s+(?!of\b)(\w+)\s*(?:-|–|,|\s|\band\b|\bto\b)\s*(\w+)"
"""Two points in other spellings of A-B."""
_LINE = r"在?\s*(\w+?)\s*-\s*(\w+?)\s*的?"
"""A line in Chinese: B-D的."""


class Shape(Written):
    """Where the mass sits: ``rod A-B`` (slender, uniform), ``disc 40 mm at A`` (radius), ``point E``."""

    __slots__ = ("form", "points", "radius")
    json_type = {"type": "string", "pattern": "^\\s*(rod|disc|point) "}
    spellings = {
        rf"(?i:rod|bar|beam|link|stick|匀质杆|均质杆|细杆|杆){TWO_POINTS}": r"rod \1-\2",
        r"(?i:disc|disk|wheel|cylinder|圆盘|盘)\s+(\S.*?)\s+(?:at|in|on|@)\s+(\w+)": r"disc \1 at \2",
        r"(?i:point|mass|particle|质点|点)(?:\s+mass)?\s+(?:at\s+)?(\w+)": r"point \1",
    }
    form: str
    points: tuple[str, ...]
    radius: Expression | None

    _PATTERN = re.compile(r"\s*(?:rod\s+(\w+)\s*-\s*(\w+)|disc\s+(\S.*?)\s+at\s+(\w+)|point\s+(\w+))\s*", re.S)

    def read(self, raw: Any) -> None:
        match = self._PATTERN.fullmatch(raw) if isinstance(raw, str) else None
        if match is None:
            raise self.unexpected("shape", raw)
        start, end, radius, centre, single = match.groups()
        self.set_attribute("form", raw.split()[0])
        self.set_attribute("points", tuple(p for p in (start, end, centre, single) if p))
        self.set_attribute("radius", Expression(radius) if radius else None)

    def quantities(self) -> TypedParts:
        return ((self.radius, Quantity(LENGTH, Sign.POSITIVE, "radius")),) if self.radius else ()

    def names(self) -> Names:
        return ((point, None) for point in self.points)


class AssemblyRule(Written):
    """Which way a group is put together: ``left of B-D``, ``right of B-D``, ``open``, ``crossed``,
    ``ahead of B along rail``, ``behind B along rail``, or the point's place ``[x, y]`` in a sketch pose."""

    __slots__ = ("along", "reference", "sketch", "word")
    json_type = {
        "anyOf": [
            {"type": "string", "pattern": "^\\s*(left of|right of|ahead of|behind|open|crossed)"},
            {"type": "array", "items": {"type": ["number", "string"]}, "minItems": 2, "maxItems": 2},
        ]
    }
    spellings = {
        rf"(?i:left|左)(?:\s+of)?{TWO_POINTS}": r"left of \1-\2",
        rf"(?i:right|右)(?:\s+of)?{TWO_POINTS}": r"right of \1-\2",
        rf"{_LINE}左[侧边面]?": r"left of \1-\2",
        rf"{_LINE}右[侧边面]?": r"right of \1-\2",
        r"(?i:open|opened)|开式|不交叉": "open",
        r"(?i:cross|crossed|crossing)|交叉[式型]?": "crossed",
    }
    word: str
    reference: tuple[str, ...]
    along: str | None
    sketch: Position | None

    _PATTERN = re.compile(
        r"\s*(?:(left|right) of (\w+)\s*-\s*(\w+)|(ahead) of (\w+) along (\w+)"
        r"|(behind) (?:of )?(\w+) along (\w+)|(open)|(crossed))\s*"
    )

    def read(self, raw: Any) -> None:
        if isinstance(raw, list | tuple):
            sketch = Position(raw)
            self.set_attribute("raw", sketch.raw)
            self._set_fields("sketch", (), None, sketch)
            return
        match = self._PATTERN.fullmatch(raw) if isinstance(raw, str) else None
        if match is None:
            raise self.unexpected("assembly", raw)
        words = [group for group in match.groups() if group]
        sliding = words[0] in ("ahead", "behind")
        along = words[2] if sliding else None
        self._set_fields(words[0], tuple(words[1:2] if sliding else words[1:]), along, None)

    @property
    def text(self) -> str:
        """As a file has it."""
        return str(self.raw) if self.sketch is None else f"[{self.sketch.first.text}, {self.sketch.second.text}]"

    def quantities(self) -> TypedParts:
        return () if self.sketch is None else self.sketch.quantities()

    def part_names(self) -> tuple[str, ...]:
        return () if self.sketch is None else self.sketch.part_names()

    def names(self) -> Names:
        yield from ((point, Ref("pivot")) for point in self.reference)
        if self.along is not None:
            yield self.along, Ref("slide")

    def mirrored(self, name: str, mirror: Any) -> AssemblyRule:
        """The rule for the same group seen in a mirror, in which the x axis of the frame is turned round."""
        if self.sketch is not None:
            x, y = self.sketch.first, self.sketch.second
            return type(self)([f"-({x.text})", y.raw])
        other = {"left": "right", "right": "left"}.get(self.word)
        return self if other is None else type(self)("{} of {}-{}".format(other, *self.reference))

    def _set_fields(self, word: str, reference: tuple[str, ...], along: str | None, sketch: Position | None) -> None:
        self.set_attribute("word", word)
        self.set_attribute("reference", reference)
        self.set_attribute("along", along)
        self.set_attribute("sketch", sketch)


_AT_LEAST = "不小于|不低于|不少于|大于或?等于|大于|高于|超过|至少|最小"
_AT_MOST = "不大于|不高于|不超过|不多于|小于或?等于|小于|低于|至多|最多|最大"


class Requirement(Written):
    """A limit on a measure: ``>= 680 mm``, ``<= 5 N*m``, or a range ``10 mm .. 12 mm``."""

    __slots__ = ("high", "low")
    json_type = {"type": "string", "pattern": "^\\s*(>=|<=)|\\.\\."}
    spellings = {
        rf"(?:≥|⩾|≧|=>|>|at least|min\.?|{_AT_LEAST})\s*([^=].*)": r">= \1",
        rf"(?:≤|⩽|≦|=<|<|at most|max\.?|{_AT_MOST})\s*([^=].*)": r"<= \1",
        r"(\d.*?)\s*(?:以上|及以上)": r">= \1",
        r"(\d.*?)\s*(?:以下|以内|及以下)": r"<= \1",
        r"([\d.]+(?:\s*[^\W\d]+)?)\s*-\s*([\d.]+(?:\s*[^\W\d]+)?)": r"\1 .. \2",
        r"\[?([^,\]]+?)\s*(?:~|…|,|\bto\b|\bbis\b|至|到| - )\s*([^,\]]+?)\]?": r"\1 .. \2",
    }
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
        elif isinstance(raw, list | tuple) and len(raw) == 2:
            raise unexpected("requirement", raw, Term("write", text=f"{raw[0]} .. {raw[1]}"))
        elif reads(text) and not any(re.fullmatch(pattern, text) for pattern in self.spellings):
            raise unexpected("requirement", raw, Term("write-bound", text=text))
        else:
            raise self.unexpected("requirement", raw)
        self.set_attribute("low", low)
        self.set_attribute("high", high)

    def quantities(self) -> TypedParts:
        return [(bound, None) for bound in self.bounds]

    def part_names(self) -> tuple[str, ...]:
        return tuple(name for name, bound in (("low", self.low), ("high", self.high)) if bound is not None)

    @property
    def bounds(self) -> tuple[Expression, ...]:
        """The limits that are given."""
        return tuple(bound for bound in (self.low, self.high) if bound is not None)
