"""What a file says of a copy of a sub-assembly: of which one, what it is joined to, its own parameters, its place."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import AfterValidator, Discriminator, Field, Tag

from linkwright.elements.fields import freeze
from linkwright.expressions.fields import Expression, Frozen, FrozenDict, LongText, Name, Position
from linkwright.expressions.typed_fields import Quantity, Ref
from linkwright.expressions.written import Shortened, unexpected
from linkwright.model.tolerances import Tolerance

NO_TOLERANCE = "none"
"""Of a parameter that has no tolerance, though that of its sub-assembly has one."""

_OF_SUBASSEMBLY = Quantity(lambda context: None)
"""What the sub-assembly's parameter is, which isn't told here."""


_GivenTolerance = Annotated[
    Annotated[Literal["none"], Tag("none")] | Annotated[Tolerance, Tag("stated")],
    Discriminator(lambda raw: NO_TOLERANCE if raw == NO_TOLERANCE else "stated"),
]


class CopyParameter(Shortened):
    """Another value of a sub-assembly's parameter, for one copy. In a file mostly written as the value alone."""

    main = "value"

    value: Annotated[Expression, _OF_SUBASSEMBLY]
    tolerance: Annotated[_GivenTolerance | None, _OF_SUBASSEMBLY] = None
    note: LongText | None = None


def _stated(at: Position | None) -> Any:
    if at is not None and at.sketched:
        raise unexpected("position", at.raw)
    return at


class Copy(Frozen):
    """A copy of a sub-assembly: everything of it under names that begin with the copy's own."""

    of: Annotated[Name, Ref("subassembly")]
    join: Annotated[dict[Name, Name], freeze] = Field(default_factory=FrozenDict)
    parameters: Annotated[dict[Name, CopyParameter], freeze] = Field(default_factory=FrozenDict)
    mirrored: bool = False
    at: Annotated[Position | None, AfterValidator(_stated)] = None
