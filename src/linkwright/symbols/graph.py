"""Walks over the graph of symbols, without recursion: expressions may be ten thousand operations deep."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from linkwright.symbols.symbol import Symbol, applied


def ordered(rows: Iterable[Symbol]) -> list[Symbol]:
    """All symbols of which rows are made, and they themselves, each after its operands."""
    found: dict[Symbol, None] = {}
    for row in rows:
        waiting = [row]
        while waiting:
            symbol = waiting[-1]
            # The first operand that hasn't been found comes first; without one the symbol's own turn has come.
            for arg in symbol.args:
                if arg not in found:
                    waiting.append(arg)
                    break
            else:
                found[symbol] = None
                waiting.pop()
    return list(found)


def depend_on(rows: Iterable[Symbol], symbols: Iterable[Symbol]) -> bool:
    """Whether some row is made of one of some symbols."""
    return not {*symbols}.isdisjoint(ordered(rows))


def substituted(rows: Sequence[Symbol], by: Mapping[Symbol, Symbol]) -> list[Symbol]:
    """Rows with some symbols replaced."""
    made: dict[Symbol, Symbol] = dict(by)
    for symbol in ordered(rows):
        if symbol in made:
            continue
        args = [made[arg] for arg in symbol.args]
        same = all(new is old for new, old in zip(args, symbol.args, strict=True))
        made[symbol] = symbol if same else applied(symbol.op, *args)
    return [made[row] for row in rows]
