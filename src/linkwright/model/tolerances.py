"""The tolerance of a parameter, as a file states it: limits, a class by name, how deviations are distributed."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Annotated, Any

from pydantic import BeforeValidator, Discriminator, Tag, WithJsonSchema

from linkwright.expressions.fields import Expression, Frozen, Two, Written, pair
from linkwright.expressions.schema_texts import Described
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.units import LENGTH, PURE
from linkwright.expressions.written import Fault, fault
from linkwright.findings import Finding, Joined
from linkwright.tolerances import DISTRIBUTIONS, ToleranceClass, examples, tolerance_class


class ClassName(Written):
    """The name of a class of tolerances, such as ``ISO 2768-m``, ``h7``, ``IT8``."""

    __slots__ = ("found",)
    json_type = {"type": "string", "examples": examples()}
    found: ToleranceClass

    def read(self, raw: Any) -> None:
        found = tolerance_class(raw) if isinstance(raw, str) else None
        if found is None:
            known = Joined(examples())
            raise fault("tolerance.unknown-class", given=str(raw)[:40], known=known)
        self.set_attribute("found", found)


_ISO = re.compile(r"\s*ISO\b", re.IGNORECASE)


def _kind(raw: Any) -> str:
    """A branch is chosen by the looks of the value, so that its faults are told once."""
    if isinstance(raw, list | tuple):
        return "a pair"
    if isinstance(raw, Mapping | StatedTolerance):
        return "a mapping"
    named = isinstance(raw, str) and (_ISO.match(raw) or tolerance_class(raw))
    return "a class" if named or isinstance(raw, ClassName) else "a number"


_PAIR = Annotated[Two, BeforeValidator(pair("tolerance")), Tag("a pair")]
# Of the schemas of a union just one may fit: a text is an expression or a class.
_CLASS = Annotated[ClassName, Tag("a class"), Described("Tolerance.class")]
_NUMBER = Annotated[Expression, Tag("a number"), WithJsonSchema({"type": "number"})]
Limits = Annotated[
    _PAIR | _CLASS | _NUMBER,
    Discriminator(lambda raw: "a number" if (kind := _kind(raw)) == "a mapping" else kind),
]


def _distribution(raw: Any) -> str:
    if not isinstance(raw, str) or raw not in DISTRIBUTIONS:
        raise fault("tolerance.distribution", given=str(raw)[:40], known=Joined(DISTRIBUTIONS))
    return str(raw)


DistributionName = Annotated[
    str, BeforeValidator(_distribution), WithJsonSchema({"type": "string", "enum": [*DISTRIBUTIONS]})
]


class Spread(Frozen):
    """How deviations are distributed between their limits."""

    distribution: DistributionName | None = None
    cp: Annotated[Expression | None, Quantity(PURE)] = None
    sigma: Expression | None = None

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        name = given.get("distribution", "")
        if {"cp", "sigma"} <= given.keys():
            yield "tolerance.cp-and-sigma", {}
        elif {"cp", "sigma"} & given.keys() and name in DISTRIBUTIONS and not DISTRIBUTIONS[name].free:
            yield "tolerance.no-sigma", {"name": name}


class StatedTolerance(Spread):
    """A tolerance with all that can be said of it."""

    limits: Limits | None = None
    side: Annotated[Expression | None, Quantity(LENGTH)] = None


Tolerance = Annotated[
    _PAIR | Annotated[StatedTolerance, Tag("a mapping")] | _CLASS | _NUMBER,
    Discriminator(_kind),
]
AnyTolerance = Two | StatedTolerance | ClassName | Expression


def full_tolerance(tolerance: AnyTolerance | None) -> StatedTolerance:
    """A tolerance in its full form."""
    return tolerance if isinstance(tolerance, StatedTolerance) else StatedTolerance.model_construct(limits=tolerance)


def tolerance_faults(parameters: Mapping[str, Any]) -> Iterator[Finding]:
    """Names that are both a class of tolerances and a parameter of the file, where a tolerance is one."""
    for name, parameter in parameters.items():
        limits = full_tolerance(parameter.tolerance).limits
        if isinstance(limits, ClassName) and limits.raw.strip() in parameters:
            yield Finding(
                "tolerance.class-or-parameter", ("parameters", name, "tolerance"), {"name": limits.raw.strip()}
            )
