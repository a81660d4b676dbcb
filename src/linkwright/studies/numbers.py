"""Numbers among the options of a study, in SI."""

from __future__ import annotations

from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.fields import Expression
from linkwright.expressions.typed_fields import Path
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding
from linkwright.model.quantities import LARGEST, Quantities


def constant(
    quantities: Quantities, expression: Expression, dimension: Dimension, path: Path
) -> tuple[float | None, list[Finding]]:
    """The value of an expression (SI), or what is wrong with it at its ``path``."""
    try:
        value = quantities.value(expression, dimension)
    except DimensionError as error:
        return None, [Finding(error.key, path, quantities.spelt(error.data))]
    if not abs(value) < LARGEST:
        return None, [Finding("value.not-finite", path, {"text": expression.text[:60]})]
    return value, []
