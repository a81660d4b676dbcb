"""Rows of symbols as a list of instructions over work slots, for machines that run it or emitters that write it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from linkwright.symbols.graph import ordered
from linkwright.symbols.operations import OPERATIONS
from linkwright.symbols.symbol import CONSTANT, FREE, Symbol, applied, symbols_of

INPUT, OUTPUT = "input", "output"
"""What isn't an operation of :data:`OPERATIONS`, besides a constant."""


class Instruction(NamedTuple):
    """One step: ``out = op(args)`` over work slots. A constant has its ``value``; of an input ``args`` are which vector
    (0: x, 1: p) and its row; of an output ``out`` is the row, and its slot the argument."""

    op: str
    out: int
    args: tuple[int, ...]
    value: float = 0.0


class ExpressionStage:
    """The instructions by which ``rows`` follow from the free symbols ``x`` (the pose's inputs) and ``p`` (parameters).

    Only what rows need is done, each part once. A slot is used again as soon as what it holds isn't needed any more.
    """

    def __init__(self, x: Sequence[Symbol], p: Sequence[Symbol], rows: Sequence[Any]) -> None:
        self.inputs, self.parameters, self.rows = len(x), len(p), len(rows)
        self.slots = 0
        sources = {symbol: (k, i) for k, symbols in enumerate((x, p)) for i, symbol in enumerate(symbols)}
        self.instructions = tuple(self._listed(sources, symbols_of(rows)))

    def _listed(self, sources: dict[Symbol, tuple[int, int]], rows: Sequence[Symbol]) -> Iterator[Instruction]:
        needed = ordered(rows)
        uses = Counter([arg for symbol in needed for arg in symbol.args])
        uses.update(rows)
        outputs: dict[Symbol, list[int]] = {}
        for i, row in enumerate(rows):
            outputs.setdefault(row, []).append(i)
        slot_of: dict[Symbol, int] = {}
        free: list[int] = []
        for symbol in needed:
            args = tuple([slot_of[arg] for arg in symbol.args])
            # The slots of operands that aren't needed any more are free for the result.
            for arg in symbol.args:
                uses[arg] -= 1
                if not uses[arg]:
                    free.append(slot_of[arg])
            if free:
                slot = free.pop()
            else:
                slot, self.slots = self.slots, self.slots + 1
            slot_of[symbol] = slot
            if symbol.op is CONSTANT:
                yield Instruction(CONSTANT, slot, (), symbol.value)
            elif symbol.op is FREE:
                yield Instruction(INPUT, slot, sources[symbol])
            else:
                yield Instruction(symbol.op, slot, args)
            if symbol in outputs:
                for place in outputs[symbol]:
                    yield Instruction(OUTPUT, place, (slot,))
                uses[symbol] -= len(outputs[symbol])
                if not uses[symbol]:
                    free.append(slot)

    @cached_property
    def used(self) -> tuple[frozenset[int], frozenset[int]]:
        """The rows of x and of p on which something depends."""
        read = [i.args for i in self.instructions if i.op == INPUT]
        return frozenset(row for k, row in read if k == 0), frozenset(row for k, row in read if k == 1)

    def numbers(self, x: Iterable[float], p: Iterable[float]) -> list[float]:
        """The rows of numbers, by the operations of the table: what every emitter is held to."""
        return self._run([*map(float, x)], [*map(float, p)], lambda op: OPERATIONS[op].number)

    def arrays(self, x: Any, p: Any) -> Any:
        """The rows, each over many poses, of rows of inputs: (rows, poses)."""
        with np.errstate(all="ignore"):
            rows = self._run(x, p, lambda op: OPERATIONS[op].array)
        return np.array(np.broadcast_arrays(*rows), dtype=float)

    def symbols(self, x: Sequence[Symbol], p: Sequence[Symbol]) -> list[Symbol]:
        """The rows of symbols: the expressions at other operands."""
        return symbols_of(self._run(x, p, lambda op: lambda *args: applied(op, *symbols_of(args))))

    def _run(self, x: Sequence[Any], p: Sequence[Any], function_of: Callable[[str], Callable[..., Any]]) -> list[Any]:
        found: list[Any] = [None] * self.rows
        holds: list[Any] = [None] * self.slots
        functions = {op: function_of(op) for op in {i.op for i in self.instructions} & {*OPERATIONS}}
        for op, out, args, value in self.instructions:
            if op == CONSTANT:
                holds[out] = value
            elif op == INPUT:
                holds[out] = (x, p)[args[0]][args[1]]
            elif op == OUTPUT:
                found[out] = holds[args[0]]
            else:
                holds[out] = functions[op](*[holds[slot] for slot in args])
        return found
