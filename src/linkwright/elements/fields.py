"""Fields that the entries of several sections share: vectors, intervals, links, places, masses."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, Discriminator, Tag

from linkwright.expressions import units as u
from linkwright.expressions.fields import FrozenDict, LineOn, Name, Position, Two, pair
from linkwright.expressions.typed_fields import Context, Ends, Quantity, Ref, Sign
from linkwright.expressions.written import unexpected

freeze = AfterValidator(FrozenDict)

Vector = Annotated[Two, BeforeValidator(pair("vector"))]
Interval = Annotated[Two, BeforeValidator(pair("interval"))]
LinkName = Annotated[Name, Ref("link")]
PointName = Annotated[Name, Ref("point")]
DriveName = Annotated[Name, Ref("drive")]
ParameterName = Annotated[Name, Ref("parameter")]


def point_of_joint(number: int) -> Ref:
    """A point of the joint's link of this number, at any depth of the joint's entry."""

    def link(c: Context) -> str:
        return str(next(entry for entry in c.entries if hasattr(entry, "joint_points")).links[number])

    return Ref("point", of=link)


TwoLinks = Annotated[tuple[LinkName, LinkName], BeforeValidator(pair("two-links"))]
TwoPoints = Annotated[tuple[Name, Name], BeforeValidator(pair("two-points"))]
TwoLines = Annotated[tuple[LineOn, LineOn], BeforeValidator(pair("two-lines"))]


def _place(raw: Any) -> Any:
    lone = isinstance(raw, str) and " " not in raw.strip()
    polar = isinstance(raw, str) and " at " in raw
    if lone or polar or isinstance(raw, Position) or (isinstance(raw, list | tuple) and len(raw) == 2):
        return raw
    raise unexpected("place", raw)


# A branch of a union is chosen by the looks of the value, so that its faults are told once.
At = Annotated[
    Annotated[Name, Tag("name")] | Annotated[Position, Tag("position")],
    Discriminator(lambda raw: "name" if isinstance(raw, str) and " " not in raw.strip() else "position"),
    BeforeValidator(_place),
]

INERTIA = Quantity(u.INERTIA, Sign.NOT_NEGATIVE, "inertia")
PART_LENGTH = Quantity(u.LENGTH, Sign.NOT_NEGATIVE, "length", ends=Ends.RISING)
"""The lengths that a cylinder, spring or other part allows."""
