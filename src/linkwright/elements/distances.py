"""A point of a link by its distances from two others of the same link: the third corner of a triangle with three sides.

The corner follows from the cosine rule, and its height over the line of the two from Heron's formula as a product of
four sums (W. Kahan, Miscalculating area and angles of a needle-like triangle, 2014, section 2), which loses no digits
where the triangle is flat. All is arithmetic on scalars of any kind, so derivatives by the sides are exact.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from typing import Annotated, Any, ClassVar, Self

from pydantic import Field

from linkwright.elements.fields import freeze
from linkwright.expressions import units as u
from linkwright.expressions.fields import TWO_POINTS, Expression, Frozen, Name, Names
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.expressions.written import Fault, Written
from linkwright.notation import Pair, Scalar
from linkwright.notation.jets import call

FLAT = 1e-9
"""Triangles whose height is below about the root of this share of their size are none: their corner has no side."""

_OWN_POINT = Ref("point", of=lambda context: context.name)


class SideOf(Written):
    """On which side of a line a point lies, seen along it: ``left of A-B``, ``right of A-B``."""

    __slots__ = ("points", "sign")
    json_type = {"type": "string", "pattern": "^\\s*(left|right) of "}
    spellings = {
        rf"(?i:left|左)(?:\s+of)?{TWO_POINTS}": r"left of \1-\2",
        rf"(?i:right|右)(?:\s+of)?{TWO_POINTS}": r"right of \1-\2",
    }
    points: tuple[str, str]
    sign: int
    """1 on the left, -1 on the right."""

    _PATTERN = re.compile(r"\s*(left|right) of (\w+)\s*-\s*(\w+)\s*")

    @classmethod
    def match(cls, raw: Any) -> re.Match[str] | None:
        """The word and the two points in a text of this form."""
        return cls._PATTERN.fullmatch(raw) if isinstance(raw, str) else None

    def read(self, raw: Any) -> None:
        match = self.match(raw)
        if match is None:
            raise self.unexpected("side-of", raw)
        self.set_attribute("sign", 1 if match[1] == "left" else -1)
        self.set_attribute("points", (match[2], match[3]))

    def mirrored(self) -> SideOf:
        """The other side of the same line."""
        word = "right" if self.sign > 0 else "left"
        return SideOf("{} of {}-{}".format(word, *self.points))

    def names(self) -> Names:
        return ((point, _OWN_POINT) for point in self.points)


class ByDistances(Frozen):
    """A point of a link by its distances from two others of it, and the side on which it lies."""

    from_: Annotated[
        dict[Annotated[Name, _OWN_POINT], Annotated[Expression, Quantity(u.LENGTH, Sign.POSITIVE, "length")]], freeze
    ] = Field(alias="from")
    side: SideOf

    sketched: ClassVar[bool] = False

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        sides = given.get("from")
        if not isinstance(sides, Mapping):
            return
        if len(sides) != 2:
            yield "triangle.two", {"count": len(sides)}
            return
        match = SideOf.match(given.get("side"))
        if match is not None and {match[2], match[3]} != {*sides}:
            first, second = sides
            text = f"{match[1]} of {first}-{second}"
            yield "triangle.side", {"given": match[0].strip()[:60], "first": first, "second": second, "text": text}

    @property
    def raw(self) -> dict[str, Any]:
        """As a file has it."""
        return {"from": {point: length.raw for point, length in self.from_.items()}, "side": self.side.raw}

    def mirrored(self) -> Self:
        """The same point seen in a mirror: on the other side."""
        return self.model_copy(update={"side": self.side.mirrored()})

    def sides(self, number: Callable[[Expression, u.Dimension], Scalar]) -> tuple[Scalar, Scalar]:
        """Its distances (m) from the two points of its ``side``, in their order."""
        first, second = (number(self.from_[point], u.LENGTH) for point in self.side.points)
        return first, second

    def coordinates(self, number: Callable[[Expression, u.Dimension], Scalar], point: Callable[[str], Pair]) -> Pair:
        """Its coordinates in the link's frame (m); ``number`` gives values in SI, ``point`` other points of the
        link."""
        start, end = (point(name) for name in self.side.points)
        a, b = self.sides(number)
        base = end.minus(start)
        square = base.dot(base)
        c = call("sqrt", square)
        along = (a * a - b * b + square) / (2 * square)
        aside = self.side.sign * call("sqrt", (a + b + c) * (b + c - a) * (c + a - b) * (a + b - c)) / (2 * square)
        return Pair(start.x + along * base.x - aside * base.y, start.y + along * base.y + aside * base.x)

    def triangle(
        self, number: Callable[[Expression, u.Dimension], Scalar], point: Callable[[str], Pair]
    ) -> tuple[tuple[Scalar, ...], tuple[Scalar, ...]]:
        """The three sides (m), that between the two points last; and by how much (m) each is shorter than the two
        others together, less what round-off may be: all positive in a triangle."""
        start, end = (point(name) for name in self.side.points)
        a, b = self.sides(number)
        base = end.minus(start)
        c = base.length
        least = FLAT * (a + b + c)
        return (a, b, c), (c - least, b + c - a - least, c + a - b - least, a + b - c - least)


def circular(points: Mapping[str, Any]) -> list[str]:
    """The points of a link whose distances lead round to themselves, in the order of the file."""
    return [name for name in points if name in _reached(points, name)]


def placed(points: Mapping[str, Any], name: str) -> bool:
    """Whether the place of a point of a link follows from others that there are, without going round."""
    reached = {name, *_reached(points, name)}
    return reached <= points.keys() and not any(one in _reached(points, one) for one in reached)


def _reached(points: Mapping[str, Any], name: str) -> set[str]:
    """The points that the place of one is stated by, and those by which theirs are."""
    found: set[str] = set()
    open_ = [name]
    while open_:
        at = points.get(open_.pop())
        for other in at.from_ if isinstance(at, ByDistances) else ():
            if other not in found:
                found.add(other)
                open_.append(other)
    return found
