"""Numbers among the options of a study or an export, in SI, and what is wrong with them."""

from __future__ import annotations

from typing import Any

from linkwright.expressions.dimensions import DimensionError
from linkwright.expressions.fields import Expression
from linkwright.expressions.typed_fields import Path
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding
from linkwright.model.quantities import LARGEST, Quantities


def constant(
    quantities: Quantities, expression: Expression, dimension: Dimension, path: Path, largest: float = LARGEST
) -> tuple[float | None, list[Finding]]:
    """The value of an expression (SI), smaller than ``largest``, or what is wrong with it at its ``path``."""
    try:
        value = quantities.value(expression, dimension)
    except DimensionError as error:
        return None, [Finding(error.key, path, quantities.spelt(error.data))]
    if not abs(value) < largest:
        return None, [Finding("value.not-finite", path, {"text": expression.text[:60]})]
    return value, []


def positive(
    quantities: Quantities, expression: Expression, dimension: Dimension, path: Path, code: str, **data: Any
) -> tuple[float | None, list[Finding]]:
    """The same where it must be above zero; else that is told by the finding ``code`` with its ``data``."""
    value, found = constant(quantities, expression, dimension, path)
    return (None, [Finding(code, path, data)]) if value is not None and value <= 0 else (value, found)


def interval(
    quantities: Quantities, ends: tuple[Expression, Expression], dimension: Dimension, path: Path
) -> tuple[tuple[float, float] | None, list[Finding]]:
    """The two ends of an interval (SI), or what is wrong with them; the first must be the lower one."""
    (low, found), (high, more) = (constant(quantities, end, dimension, path) for end in ends)
    if low is None or high is None:
        told = {one.code for one in found}
        return None, [*found, *(one for one in more if one.code not in told)]
    if low < high:
        return (low, high), []
    return None, [Finding("value.not-rising", path, {"low": ends[0].text[:40], "high": ends[1].text[:40]})]
