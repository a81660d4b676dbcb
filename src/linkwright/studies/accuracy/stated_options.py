"""What an accuracy study's options say of deviations besides the parameters' own tolerances."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Any

from pydantic import BeforeValidator, Discriminator, Field, FiniteFloat, Tag

from linkwright.elements.fields import Interval
from linkwright.expressions.fields import Expression, Frozen, Text
from linkwright.expressions.fields import Name as NameField
from linkwright.expressions.typed_fields import Quantity
from linkwright.expressions.units import PURE
from linkwright.expressions.written import Fault, unexpected
from linkwright.model.tolerances import Spread


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

    of: tuple[Text, ...] = Field(
        min_length=2, max_length=1000, description="parameters or temperatures that are contributors"
    )
    is_: _Is = Field(alias="is", description="their correlation coefficient, or the matrix of them")


class Thermal(Spread):
    """A change of temperature, by which lengths expand together."""

    change: Annotated[Interval, Quantity(PURE)] = Field(
        description="[least, largest] change from the temperature of the nominal lengths, in K"
    )
    material: Text | None = Field(None, description="the material by name, whose expansion is known")
    expansion: Annotated[Expression | None, Quantity(PURE)] = Field(
        None, description="coefficient of linear expansion in 1e-6/K, instead"
    )
    parameters: tuple[NameField, ...] | None = Field(
        None, min_length=1, max_length=1000, description="the lengths that expand; all that aren't derived by default"
    )

    @classmethod
    def faults(cls, given: Mapping[str, Any]) -> Iterator[Fault]:
        yield from super().faults(given)
        if ("material" in given) == ("expansion" in given):
            yield "tolerance.material-or-expansion", {}
