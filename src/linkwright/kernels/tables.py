"""Tables whose values hold parameters: a spline is linear in its values, so others add their share of a spline each."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field
from itertools import chain
from typing import Any

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.expressions.language import Node, evaluate
from linkwright.findings import Finding
from linkwright.kernels.law import Parameters
from linkwright.laws import TableLaw
from linkwright.laws.numbers import largest_of, plain
from linkwright.model.mechanism import Table
from linkwright.model.quantities import Quantities
from linkwright.model.sampled import Sampled, names_in
from linkwright.notation import Jet, Scalar
from linkwright.notation.jets import call

CLOSE = 1e-9
"""How closely first and last value of a table over a whole period must agree."""


@dataclass(frozen=True)
class StatedTable(TableLaw):
    """A table at the ``nominal`` parameters; ``values`` are the expressions of its points' values that hold some, by
    the points' numbers. At others :meth:`at_parameters` gives it."""

    values: Mapping[int, Node] = field(default_factory=dict)
    nominal: Mapping[str, float] = field(default_factory=dict)
    _shares: dict[int, TableLaw] = field(default_factory=dict, repr=False, compare=False)

    @property
    def names(self) -> frozenset[str]:
        """The parameters on which it depends."""
        return frozenset(name for node in self.values.values() for name in names_in(node)) & self.nominal.keys()

    def at_parameters(self, parameters: Parameters) -> TableLaw | Given:
        """At other parameters: floats, arrays that broadcast with the arguments, or duals."""
        if not self.values or parameters is self.nominal:
            return self
        more = {i: evaluate(node, lambda name: parameters[name.text]) - self.y[i] for i, node in self.values.items()}
        more = {i: off for i, off in more.items() if not (plain(off) and off == 0.0)}
        return Given(self, more) if more else self

    def share(self, point: int) -> TableLaw:
        """The spline that is 1 at a point and 0 at the others."""
        if point not in self._shares:
            y = np.zeros_like(self.y)
            y[[point, -1] if point == 0 and self.covers_period else point] = 1.0
            self._shares[point] = TableLaw(self.x, y, self.degree, self.period)
        return self._shares[point]

    @property
    def covers_period(self) -> bool:
        """Whether its points go over a whole period, so that the last value is the first."""
        return self.period is not None and bool(np.isclose(self.x[-1] - self.x[0], self.period, rtol=1e-12))


@dataclass(frozen=True)
class Given:
    """A table and by how much the values of some points are more."""

    table: StatedTable
    more: Mapping[int, Scalar]

    def __call__(self, x: Jet) -> Jet:
        """As the table."""
        return self._summed("__call__", x)

    def or_nan(self, x: Jet) -> Jet:
        """As the table."""
        return self._summed("or_nan", x)

    def integral(self, x: Jet) -> Jet:
        """As the table."""
        return self._summed("integral", x)

    def _summed(self, what: str, x: Jet) -> Jet:
        found: Jet = getattr(self.table, what)(x)
        last = len(self.table.y) - 1
        for point, more in self.more.items():
            if point != last or not self.table.covers_period:
                found = found + getattr(self.table.share(point), what)(x) * more
        return found


def stated_values(quantities: Quantities, table: Table) -> dict[int, Node]:
    """The values of a table's points that hold parameters."""
    bound = ((i, quantities.bind(point[1], None)) for i, point in enumerate(table.points or ()))
    return {i: node for i, node in bound if names_in(node) & quantities.parameters.keys()}


def fixed_parts(table: Table) -> Iterator[Node]:
    """The expressions of a table that can't vary: arguments and the period."""
    cells = chain((point[0] for point in table.points or ()), [table.period] if table.period else [])
    return (cell.node for cell in cells)


def open_ends(quantities: Quantities, table: Table, parameters: Parameters) -> Any:
    """By how much a table over a whole period doesn't close, at some parameters; 0 of another."""
    if table.points is None or table.period is None:
        return 0.0
    first, last = table.points[0], table.points[-1]
    nominal = quantities.parameters if quantities.samples is None else parameters
    start, end, period = (
        evaluate(quantities.bind(cell, None), lambda name: nominal[name.text])
        for cell in (first[0], last[0], table.period)
    )
    if not np.all(np.isclose(end - start, period, rtol=1e-12)):
        return 0.0
    ends = (evaluate(quantities.bind(cell[1], None), lambda name: parameters[name.text]) for cell in (last, first))
    return next(ends) - next(ends)


def closing_margin(quantities: Quantities, table: Table, parameters: Parameters) -> Any:
    """How much less than the tolerance the ends of a table over a whole period differ, at some parameters; these may be
    arrays of samples or symbols. None where that doesn't depend on them."""
    away = open_ends(quantities, table, parameters)
    if isinstance(away, int | float):
        return None
    nodes = (quantities.bind(point[1], None) for point in table.points or ())
    sizes = (call("abs", evaluate(node, lambda name: parameters[name.text])) for node in nodes)
    return CLOSE * largest_of(sizes) - call("abs", away)


def table_faults(sampled: Sampled) -> list[Finding]:
    """Tables that don't close in some samples; these are noted."""
    findings = []
    for name, table in sampled.mechanism.tables.items():
        margin = closing_margin(sampled, table, sampled.parameters)
        if margin is not None and sampled.bad(np.less(margin, 0.0)):
            findings.append(Finding("table.not-closed", ("tables", name), {}))
    return findings
