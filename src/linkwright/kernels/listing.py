"""A block's instructions as values, each made once, for emitters that write code."""

from __future__ import annotations

from math import copysign, inf
from typing import NamedTuple

from linkwright.symbols import CONSTANT, INPUT, OUTPUT, ExpressionStage

X, P = 1, 2
"""What a value depends on, as bits: the pose's inputs, the parameters."""


class Value(NamedTuple):
    """A value: a constant's ``number``, an input's ``source`` (0: x, 1: p; its row), or ``op`` of earlier values."""

    op: str
    args: tuple[int, ...] = ()
    number: float = 0.0
    source: tuple[int, int] | None = None

    @property
    def constant(self) -> bool:
        return self.op == CONSTANT


class Listing:
    """The values of a block in order, and which of them are its output rows.

    ``needs[i]`` says on what value i depends; of an input row among ``solved`` on both, as Newton makes it.
    """

    def __init__(self, stage: ExpressionStage, solved: frozenset[int] = frozenset()) -> None:
        self.values: list[Value] = []
        self.needs: list[int] = []
        outputs: dict[int, int] = {}
        holds: dict[int, int] = {}
        for i in stage.instructions:
            if i.op == OUTPUT:
                outputs[i.out] = holds[i.args[0]]
                continue
            if i.op == CONSTANT:
                value, needs = Value(i.op, number=i.value), 0
            elif i.op == INPUT:
                which, row = i.args
                needs = P if which else X | P if row in solved else X
                value = Value(i.op, source=(which, row))
            else:
                args = tuple([holds[slot] for slot in i.args])
                value, needs = Value(i.op, args), 0
                for arg in args:
                    needs |= self.needs[arg]
            holds[i.out] = len(self.values)
            self.values.append(value)
            self.needs.append(needs)
        self.outputs = [outputs[row] for row in range(stage.rows)]
        self._share_reciprocals()

    def _share_reciprocals(self) -> None:
        """Divide by what divides several values, or is the same for more poses than they, by way of its reciprocal:
        dividing takes a processor some ten times as long as multiplying."""
        divided: dict[int, list[int]] = {}
        for i, value in enumerate(self.values):
            if value.op == "divide" and not self.values[value.args[1]].constant:
                divided.setdefault(value.args[1], []).append(i)
        shared = {by for by, of in divided.items() if len(of) > 1 or self.needs[by] != self.needs[of[0]]}
        if not shared:
            return
        values, needs, place, reciprocal = list[Value](), list[int](), list[int](), dict[int, int]()
        for i, value in enumerate(self.values):
            if value.op == "divide" and value.args[1] in shared:
                value = Value("multiply", (place[value.args[0]], reciprocal[value.args[1]]))
            elif value.args:
                value = Value(value.op, tuple([place[arg] for arg in value.args]))
            place.append(len(values))
            values.append(value)
            needs.append(self.needs[i])
            if i in shared:
                reciprocal[i] = len(values)
                values.append(Value("reciprocal", (place[i],)))
                needs.append(self.needs[i])
        self.values, self.needs = values, needs
        self.outputs = [place[i] for i in self.outputs]


def number_text(number: float) -> str:
    """A number as an operand in an emitter's text; the names ``inf`` and ``nan`` have to be there."""
    if number != number:
        return "nan"
    text = "inf" if abs(number) == inf else repr(abs(number))
    return f"(-{text})" if copysign(1.0, number) < 0 else text
