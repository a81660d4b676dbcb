"""What is stated of an output by its name: a measure, or an expression of signals."""

from __future__ import annotations

from typing import Annotated

from linkwright.expressions.dimensions import Wanted
from linkwright.expressions.typed_fields import Context, Quantity, Scope
from linkwright.reductions import figure


def _dimension(name: str, c: Context) -> Wanted:
    """That of the measure of this name, else the unknown one of the expression."""
    measures = c.mechanism.measures
    return figure(name, measures[name]) if name in measures else (f"output {name}", 0)


def of_output(place: int) -> Quantity:
    """A quantity of the output whose name is this key of its path."""
    return Quantity(lambda c: _dimension(str(c.path[place]), c))


def _named(c: Context) -> Wanted | None:
    """Of an output that names no measure."""
    name = str(c.path[-1])
    return None if name in c.mechanism.measures else _dimension(name, c)


OutputName = Annotated[str, Quantity(_named, scope=Scope.SIGNALS)]
"""The name of an output as a key; an expression of signals tells its dimension."""
