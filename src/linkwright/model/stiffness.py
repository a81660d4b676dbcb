"""How stiff joints and links are, where redundant ones share a load by that."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any

from pydantic import BeforeValidator

from linkwright.elements.fields import freeze
from linkwright.expressions import units as u
from linkwright.expressions.fields import Expression, Name
from linkwright.expressions.typed_fields import Quantity, Ref, Sign
from linkwright.expressions.written import Fault, Shortened

JOINTS = "joints"
"""The name under which all joints are meant that have none of their own."""
EQUAL = "equal"
"""The stiffness that is only stated to be the same everywhere."""


class Stiffness(Shortened):
    """The stiffness of a joint, or of a link along the line of its two pins. Mostly written as its value alone."""

    main = "value"

    value: Annotated[Expression | None, Quantity(u.STIFFNESS, Sign.POSITIVE)] = None
    tilt: Annotated[Expression | None, Quantity(u.TORSIONAL_STIFFNESS, Sign.POSITIVE)] = None
    equal: bool = False

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        if bool(given.get("equal")) == (given.get("value") is not None):
            yield "stiffness.value", {}


def _equal(raw: Any) -> Any:
    """The word for a stiffness that is the same everywhere."""
    return {EQUAL: True} if raw == EQUAL else raw


def _of_all(raw: Any) -> Any:
    """That word alone, for all joints."""
    return {JOINTS: EQUAL} if raw == EQUAL else raw


Stiffnesses = Annotated[
    dict[Annotated[Name, Ref("elastic")], Annotated[Stiffness, BeforeValidator(_equal)]],
    BeforeValidator(_of_all),
    freeze,
]


def stiffness_faults(given: Any) -> Iterator[tuple[str, dict[str, Any], str]]:
    """What is wrong with all of them together: equal ones beside numbers."""
    if not isinstance(given, Mapping):
        return
    equal = [name for name, entry in given.items() if entry == EQUAL]
    if equal and len(equal) < len(given):
        yield "stiffness.mixed", {"name": str(equal[0])[:60]}, "stiffness"
