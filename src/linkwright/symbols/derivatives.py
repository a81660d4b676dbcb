"""Derivatives of symbols, forward along a direction and backward from a row.

Both come from the slopes of operations (Griewank and Walther, *Evaluating Derivatives*, 2nd ed., ch. 3).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from linkwright.symbols.graph import ordered
from linkwright.symbols.operations import OPERATIONS
from linkwright.symbols.symbol import Symbol, constant


def derivatives_along(rows: Sequence[Symbol], direction: Mapping[Symbol, Symbol]) -> list[Symbol]:
    """The derivative of each row along a direction, which says how some free symbols change."""
    rates = {symbol: rate for symbol, rate in direction.items() if not rate.is_zero()}
    for symbol in ordered(rows):
        if not symbol.args:
            continue
        rate: Symbol | None = None
        for arg, slope in zip(symbol.args, OPERATIONS[symbol.op].slopes, strict=True):
            if slope is not None and arg in rates:
                part = slope(*symbol.args, symbol) * rates[arg]
                rate = part if rate is None else rate + part
        if rate is not None and not rate.is_zero():
            rates[symbol] = rate
    zero = constant(0.0)
    return [rates.get(row, zero) for row in rows]


def gradient(row: Symbol, by: Sequence[Symbol]) -> list[Symbol]:
    """The derivatives of one row by each of some free symbols."""
    lambdas: dict[Symbol, Symbol] = {row: constant(1.0)}
    wanted = {*by}
    depending = _depending([row], wanted)
    for symbol in reversed(depending):
        weight = lambdas.get(symbol)
        if weight is None:
            continue
        for arg, slope in zip(symbol.args, OPERATIONS[symbol.op].slopes if symbol.args else (), strict=True):
            if slope is None or (arg not in wanted and not arg.args):
                continue
            part = slope(*symbol.args, symbol) * weight
            lambdas[arg] = lambdas[arg] + part if arg in lambdas else part
    zero = constant(0.0)
    return [lambdas.get(symbol, zero) for symbol in by]


def _depending(rows: Sequence[Symbol], on: set[Symbol]) -> list[Symbol]:
    """Of all of which rows are made what depends on some symbols, in order."""
    found: dict[Symbol, None] = {}
    for symbol in ordered(rows):
        if symbol in on or any(arg in found for arg in symbol.args):
            found[symbol] = None
    return list(found)


def jacobian(rows: Sequence[Symbol], by: Sequence[Symbol]) -> list[list[Symbol]]:
    """The derivatives of rows by free symbols, row by row: backward where there are fewer rows than symbols."""
    if len(rows) < len(by):
        return [gradient(row, by) for row in rows]
    one = constant(1.0)
    columns = [derivatives_along(rows, {symbol: one}) for symbol in by]
    return [[column[i] for column in columns] for i in range(len(rows))]
