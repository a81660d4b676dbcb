"""What an accuracy study's options say of deviations besides the parameters' own tolerances."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any

from pydantic import BeforeValidator, Discriminator, Field, FiniteFloat, Tag

from linkwright.elements.fields import Interval, ParameterName, freeze
from linkwright.expressions.fields import Expression, Frozen, FrozenDict, Name, Text
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.units import PURE
from linkwright.expressions.written import Fault, unexpected
from linkwright.model.tolerances import ClassName, DistributionName, Spread
from linkwright.studies.accuracy.clearance_options import Clearance


def _is(raw: Any) -> Any:
    if isinstance(raw, bool) or not isinstance(raw, int | float | list | tuple):
        raise unexpected("correlation", raw)
    return raw


_Rows = Annotated[tuple[tuple[FiniteFloat, ...], ...], Tag("a matrix")]
_Is = Annotated[
    _Rows | Annotated[FiniteFloat, Tag("one number")],
    Discriminator(lambda raw: "a matrix" if isinstance(raw, list | tuple) else "one number"),
    BeforeValidator(_is),
]


class Correlation(Frozen):
    """Deviations that go together: of parts that are made together, or of dimensions made in one setting."""

    of: tuple[Text, ...] = Field(min_length=2, max_length=1000)
    is_: _Is = Field(alias="is")


class Thermal(Spread):
    """A change of temperature, by which lengths expand together."""

    change: Annotated[Interval, Quantity(PURE)]
    material: Text | None = None
    expansion: Annotated[Expression | None, Quantity(PURE)] = None
    parameters: tuple[ParameterName, ...] | None = Field(None, min_length=1, max_length=1000)

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        yield from super().faults(given)
        if ("material" in given) == ("expansion" in given):
            yield "tolerance.material-or-expansion", {}


class DeviationOptions(Frozen):
    """What deviates and how: for the accuracy study, and for others that ask what deviations do."""

    parameters: tuple[ParameterName, ...] | None = Field(None, max_length=1000)
    general: ClassName | None = None
    distribution: DistributionName = "normal"
    cp: FiniteFloat = 1.0
    correlations: tuple[Correlation, ...] = Field((), max_length=1000)
    thermal: Annotated[dict[Text, Thermal], Quantity(PURE), freeze] = Field(default_factory=FrozenDict, max_length=100)
    clearances: Annotated[dict[Name, Clearance], freeze] = Field(default_factory=FrozenDict)

    @property
    def deviating(self) -> bool:
        """Whether some parameter must deviate: clearances alone are enough for errors."""
        return not self.clearances
