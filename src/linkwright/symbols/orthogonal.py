"""A small square matrix of symbols as the product of an orthogonal and a triangular one.

Orthogonal factors keep the digits that elimination without a choice of pivots loses: on symbols, whose size isn't
known, nothing can be chosen by size. What can be chosen is what stays zero: columns and rows with few entries come
first. Two entries are brought together by a rotation, more by a reflection (Golub and Van Loan, *Matrix Computations*,
4th ed., 5.1).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import nan
from typing import Any, NamedTuple

from linkwright.symbols.symbol import Symbol, constant, symbols_of

Row = dict[int, Symbol]
"""The entries of a row that aren't structurally zero, by column."""


class _Rotation(NamedTuple):
    """(a, b) -> (c a + s b, c b - s a) of two rows."""

    rows: tuple[int, int]
    c: Symbol
    s: Symbol

    def apply(self, values: dict[int, Symbol], backward: bool) -> None:
        i, k = self.rows
        s = -self.s if backward else self.s
        values[i], values[k] = self.c * values[i] + s * values[k], self.c * values[k] - s * values[i]


class _Reflection(NamedTuple):
    """a -> a - beta v (v a) of some rows, its own inverse."""

    rows: tuple[int, ...]
    v: tuple[Symbol, ...]
    beta: Symbol

    def apply(self, values: dict[int, Symbol], backward: bool) -> None:
        product = constant(0.0)
        for i, v in zip(self.rows, self.v, strict=True):
            product = product + v * values[i]
        product = self.beta * product
        for i, v in zip(self.rows, self.v, strict=True):
            values[i] = values[i] - product * v


class OrthogonalFactors:
    """The factors of a square matrix of symbols and numbers, given by its rows."""

    def __init__(self, matrix: Sequence[Sequence[Any]]) -> None:
        self.size = len(matrix)
        self._rows: list[Row] = [_entries(row) for row in matrix]
        self._steps: list[_Rotation | _Reflection] = []
        self._pivots: list[tuple[int, int]] = []  # row and column of each, in order
        rows, columns = [*range(self.size)], [*range(self.size)]
        while columns:
            column = min(columns, key=lambda k: self._cost(k, rows))
            row = self._brought_together(column, [i for i in rows if column in self._rows[i]] or rows[:1])
            self._pivots.append((row, column))
            rows.remove(row)
            columns.remove(column)

    def _cost(self, column: int, rows: Sequence[int]) -> tuple[int, int]:
        """How many rows have an entry in a column, and how many columns these have entries in."""
        having = [i for i in rows if column in self._rows[i]]
        return len(having), len({k for i in having for k in self._rows[i]})

    def _brought_together(self, column: int, rows: Sequence[int]) -> int:
        """The row in which all of a column's entries in some rows come together; the others lose theirs."""
        first, *others = sorted(rows, key=lambda i: len(self._rows[i]))
        if not others:
            self._rows[first].setdefault(column, constant(nan))  # singular, whatever the entries' values
            return first
        entries = [self._rows[i][column] for i in (first, *others)]
        size = sum((entry.do("square") for entry in entries[1:]), entries[0].do("square")).do("sqrt")
        step: _Rotation | _Reflection
        if len(others) == 1:
            step, pivot = _Rotation((first, others[0]), entries[0] / size, entries[1] / size), size
        else:
            # v = a + sign(a_0) |a| e_0, which can't cancel, with beta = 2 / v v = 1 / (|a| (|a| + |a_0|)).
            pivot = -size.do("copysign", entries[0])
            v = (entries[0] - pivot, *entries[1:])
            step = _Reflection((first, *others), v, 1.0 / (size * (size + abs(entries[0]))))
        self._steps.append(step)
        for row in others:
            del self._rows[row][column]
        for k in sorted({k for i in rows for k in self._rows[i]} - {column}):
            values = {i: self._rows[i].get(k, constant(0.0)) for i in rows}
            step.apply(values, backward=False)
            for i, value in values.items():
                if value.is_zero():
                    self._rows[i].pop(k, None)
                else:
                    self._rows[i][k] = value
        self._rows[first][column] = pivot
        return first

    def solve(self, right: Sequence[Any], transposed: bool = False) -> list[Symbol]:
        """The solution of A x = right, or of the transposed system."""
        values = dict(enumerate(symbols_of(right)))
        return self._solved_transposed(values) if transposed else self._solved(values)

    def _solved(self, values: dict[int, Symbol]) -> list[Symbol]:
        for step in self._steps:
            step.apply(values, backward=False)
        found: dict[int, Symbol] = {}
        for row, column in reversed(self._pivots):
            rest = values[row]
            for k, entry in self._rows[row].items():
                if k in found:
                    rest = rest - entry * found[k]
            found[column] = rest / self._rows[row][column]
        return [found[k] for k in range(self.size)]

    def _solved_transposed(self, given: dict[int, Symbol]) -> list[Symbol]:
        # The transposed triangle first, column by column, then the orthogonal steps backward.
        values: dict[int, Symbol] = {}
        for row, column in self._pivots:
            rest = given[column]
            for earlier, value in values.items():
                if column in self._rows[earlier]:
                    rest = rest - self._rows[earlier][column] * value
            values[row] = rest / self._rows[row][column]
        for step in reversed(self._steps):
            step.apply(values, backward=True)
        return [values[i] for i in range(self.size)]

    def determinant(self) -> Symbol:
        """The determinant, with its sign: a rotation has 1, a reflection -1, a change of order its parity."""
        reflections = sum(isinstance(step, _Reflection) for step in self._steps)
        exchanges = _inversions([row for row, _ in self._pivots]) + _inversions([column for _, column in self._pivots])
        product = constant(-1.0 if (reflections + exchanges) % 2 else 1.0)
        for row, column in self._pivots:
            product = product * self._rows[row][column]
        return product


def _entries(row: Sequence[Any]) -> Row:
    return {k: entry for k, entry in enumerate(symbols_of(row)) if not entry.is_zero()}


def _inversions(order: Sequence[int]) -> int:
    """In how many pairs the greater comes first."""
    return sum(order[i] > order[k] for i in range(len(order)) for k in range(i + 1, len(order)))
