"""Numbers among the options of a target."""

from __future__ import annotations

from linkwright.expressions.fields import Expression
from linkwright.expressions.units import Dimension
from linkwright.findings import Finding, Term
from linkwright.kernels import Compiled
from linkwright.studies.numbers import constant


def positive(
    compiled: Compiled, to: str, key: str, given: Expression | None, dimension: Dimension, default: float
) -> tuple[float, list[Finding]]:
    """The value (SI) of an option that must be positive, and what is wrong with it; else the ``default``."""
    if given is None:
        return default, []
    value, found = constant(compiled.quantities, given, dimension, path := ("exports", to, key))
    if value is None:
        return default, found
    if not 0 < value < 1e12:
        return default, [Finding("export.options", path, {"export": to, "key": key, "reason": Term("positive")})]
    return value, []
