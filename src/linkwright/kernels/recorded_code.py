"""Straight-line code as a list of operations, for emitters that print it when it is known what is used how often.

A value that is used once is printed where it is used, so that the text is short; arithmetic stays what it was.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

DEEPEST = 24
"""The most operations within one another in one expression."""


class Node(NamedTuple):
    """A value: a ``number``; an entry of an ``array`` (``row``); an argument of the function (``row``); a primitive
    operation, or a call, by its ``word``."""

    word: str
    operands: tuple[str, ...] = ()
    array: str = ""
    row: int = 0
    number: float = 0.0


class Named(NamedTuple):
    """A value is given a name, as it is used more than once."""

    value: str


class Stored(NamedTuple):
    """A value goes to a row of an array."""

    value: str
    array: str
    row: int


NUMBER, ENTRY, ARGUMENT = "number", "entry", "argument"
CONDITIONS = frozenset(("less", "less_equal", "greater", "greater_equal", "equal", "not_equal", "and", "or"))
"""The primitives that give conditions."""


class RecordedCode:
    """The operations of one function; ``result`` is what it returns. Operands are numbers of nodes."""

    def __init__(self) -> None:
        self.nodes: list[Node] = []
        self.calls: dict[str, int] = {}
        self.result: str | None = None
        self._known: dict[object, str] = {}
        self._held: set[str] = set()
        self._stores: list[tuple[int, Stored]] = []

    def number(self, value: float) -> str:
        return self._node(Node(NUMBER, number=value), repr(value))

    def argument(self, place: int) -> str:
        """One of the function's arguments."""
        return self._node(Node(ARGUMENT, row=place))

    def entry(self, array: str, row: int, held: bool = False) -> str:
        """A row of an array. One that is ``held`` is read at once, as something else will be stored there."""
        found = self._node(Node(ENTRY, array=array, row=row))
        if held:
            self._held.add(found)
        return found

    def do(self, primitive: str, *operands: str) -> str:
        return self._node(Node(primitive, operands))

    def function(self, name: str, operands: Sequence[str]) -> str:
        """Call an elementary function."""
        self.calls.setdefault(name, len(operands))
        return self._node(Node(name, tuple(operands)))

    def store(self, value: str, array: str, row: int) -> None:
        """Store a value, after all operations that were written before."""
        self._stores.append((len(self.nodes), Stored(value, array, row)))

    def _node(self, node: Node, key: object = None) -> str:
        new = str(len(self.nodes))
        known = self._known.setdefault(node if key is None else key, new)
        if known is new:
            self.nodes.append(node)
        return known

    def of(self, value: str) -> Node:
        """What an operand is."""
        return self.nodes[int(value)]

    def statements(self) -> Iterator[Named | Stored]:
        """What is to be printed, in order: values with names, and what is stored. All others are printed where they
        are used, or aren't used."""
        uses = self._uses()
        stores, depth = iter([*self._stores, (len(self.nodes) + 1, None)]), [1] * len(self.nodes)
        before, store = next(stores)
        for i, node in enumerate(self.nodes):
            if not uses[i] or node.word in (NUMBER, ARGUMENT):
                continue
            while before <= i and store is not None:
                yield store
                before, store = next(stores)
            depth[i] = 1 + max([depth[int(operand)] for operand in node.operands], default=0)
            if uses[i] > 1 or depth[i] > DEEPEST or str(i) in self._held:
                depth[i] = 0
                yield Named(str(i))
        while store is not None:
            yield store
            before, store = next(stores)

    def _uses(self) -> list[int]:
        """How often each value is used, by those that are used themselves, are stored, or are the result."""
        uses = [0] * len(self.nodes)
        for _, store in self._stores:
            uses[int(store.value)] += 1
        if self.result is not None:
            uses[int(self.result)] += 1
        for i in reversed(range(len(self.nodes))):
            if uses[i]:
                for operand in self.nodes[i].operands:
                    uses[int(operand)] += 1
        return uses


def decimal(number: float) -> str:
    """A number in the fewest characters that give its bits back, as JavaScript reads them."""
    if math.isnan(number):
        return "NaN"
    if math.isinf(number):
        return "1/0" if number > 0 else "-1/0"
    text = repr(number).replace("e-0", "e-").replace("e+", "e").removesuffix(".0")
    sign, text = ("-", text[1:]) if text.startswith("-") else ("", text)
    return sign + (text[1:] if text.startswith("0.") else text)
