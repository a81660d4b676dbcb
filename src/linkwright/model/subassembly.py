"""What a file says of a sub-assembly: elements that are defined once, and placed as copies."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import BeforeValidator, Field

from linkwright.elements.fields import freeze
from linkwright.expressions.fields import FrozenDict, LongText, Name
from linkwright.expressions.written import fault, unexpected
from linkwright.model.parts import Link
from linkwright.model.sections import MAX_LINKS, Sections, at_most


def _distinct(raw: Any) -> Any:
    if not isinstance(raw, list | tuple):
        raise unexpected("ports", raw)
    for i, name in enumerate(raw):
        if name in raw[:i]:
            raise fault("subassembly.port-twice", name=str(name)[:60])
    return tuple(raw)


class Subassembly(Sections):
    """Elements that are defined once, and placed as copies with values and joints of their own.

    Its names are known in it alone; the ``ports`` are those that each copy is given by what it is joined to.
    """

    note: LongText | None = None
    ports: Annotated[tuple[Name, ...], BeforeValidator(_distinct)] = ()
    links: Annotated[dict[Name, Link], at_most(MAX_LINKS), freeze] = Field(default_factory=FrozenDict)
