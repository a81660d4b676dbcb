"""A program's instructions run on enclosures: Taylor models over panels of time, or intervals over boxes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.enclosures import intervals
from linkwright.enclosures.forms import FEW, UNIT, AffineForm
from linkwright.enclosures.functions import continuous_angle
from linkwright.enclosures.intervals import Intervals
from linkwright.enclosures.taylor import FUNCTIONS, TaylorModel
from linkwright.symbols import CONSTANT, INPUT, OPERATIONS, OUTPUT, ExpressionStage

Array = NDArray[np.float64]
Function = Callable[..., Any]

ARITHMETIC: dict[str, Function] = {
    "add": lambda a, b: a + b, "subtract": lambda a, b: a - b, "multiply": lambda a, b: a * b,
    "divide": lambda a, b: a / b, "negative": lambda a: -a,
    "twice": lambda a: a + a, "power": lambda a, b: a**b,
}  # fmt: skip
"""What enclosures of every kind do by operators of their own."""
OWN = {*ARITHMETIC, "square", "reciprocal", "arctan2"}
NAMES = [name for name in OPERATIONS if name not in OWN]
"""The operations that are functions registered under their names."""


@dataclass(frozen=True)
class EnclosureKind:
    """A kind of enclosure: what each operation does to it, by name, and a number as one."""

    functions: Mapping[str, Function]
    number: Callable[[float], Any]


def taylor(strict: bool = False, dtype: Any = np.float64) -> EnclosureKind:
    """Taylor models. Angles of vectors run on past pi, from their values in the middle; ``strict`` ones jump there.
    ``dtype`` is what constants are computed with."""
    own: dict[str, Function] = {"reciprocal": lambda a: a.inverse(), "square": lambda a: a * a}
    angle = FUNCTIONS["arctan2"] if strict else continuous_angle
    named = {name: FUNCTIONS[name] for name in NAMES}
    return EnclosureKind({**ARITHMETIC, **named, **own, "arctan2": angle}, lambda v: TaylorModel.number(v, dtype=dtype))


def _constant(function: Function, *args: AffineForm) -> AffineForm:
    """A function of parameters alone."""
    if any(np.any(x.lean) for x in args):
        raise NotImplementedError("no enclosure of such a function over boxes")
    found = function(*(Intervals(*x.bounds) for x in args))
    middle = (found.low + found.high) / 2
    return AffineForm(middle, rest=(found.high - found.low) / 2 + UNIT * abs(middle))


def _power(x: Intervals, y: Intervals) -> Intervals:
    """Whole powers of any number, others of positive ones."""
    middle = float((y.low + y.high) / 2)
    whole = middle == np.floor(middle) and y.high - y.low <= FEW * abs(middle)
    return x ** (int(middle) if whole else y)


BOXES = EnclosureKind(
    {
        **{name: partial(_constant, intervals.FUNCTIONS[name]) for name in NAMES},
        **ARITHMETIC,
        "power": partial(_constant, _power),
        "arctan2": partial(_constant, intervals.arctan2),
        "square": AffineForm.square,
        "sqrt": AffineForm.sqrt,
        "reciprocal": AffineForm.inverse,
        "fabs": AffineForm.magnitude,
    },
    AffineForm,
)
"""Linear forms over boxes of the inputs, of what follows from them by sums, products, quotients and roots, as the
closed forms of dyads do. They hold for the places of a box at which every root is real."""


class Stage:
    """A block of expressions on a kind of enclosures: its ``wanted`` rows, what depends on parameters alone done."""

    def __init__(self, stage: ExpressionStage, p: Array, wanted: Sequence[int], kind: EnclosureKind) -> None:
        self.values: list[Any] = []  # of each number that is made, where it is the same at all times
        self.work: list[tuple[Function, tuple[int, ...], int]] = []
        self.inputs: list[tuple[int, int]] = []  # (number, input row)
        slots: dict[int, int] = {}
        results: dict[int, int] = {}
        lines: list[tuple[Function, tuple[int, ...], int]] = []
        for i in stage.instructions:
            if i.op == OUTPUT:
                results[i.out] = slots[i.args[0]]
                continue
            value = None
            if i.op == CONSTANT:
                value = kind.number(i.value)
            elif i.op == INPUT:
                which, row = i.args
                if which == 1:
                    value = kind.number(float(p[row]))
                else:
                    self.inputs.append((len(self.values), row))
            else:
                args = tuple(slots[a] for a in i.args)
                known = [self.values[a] for a in args]
                function = kind.functions[i.op]
                if all(k is not None for k in known):
                    value = function(*known)
                else:
                    lines.append((function, args, len(self.values)))
            slots[i.out] = len(self.values)
            self.values.append(value)
        self.results = [results[row] for row in wanted]
        needed = set(self.results)
        for line in reversed(lines):
            if line[2] in needed:
                needed.update(line[1])
                self.work.append(line)
        self.work.reverse()
        self.inputs = [(number, row) for number, row in self.inputs if number in needed]

    @property
    def used(self) -> set[int]:
        """The input rows that the wanted rows depend on."""
        return {row for _, row in self.inputs}

    def __call__(self, x: Callable[[int], Any]) -> list[Any]:
        """The wanted rows, from the inputs by their rows."""
        values: list[Any] = [*self.values]
        for number, row in self.inputs:
            values[number] = x(row)
        with np.errstate(all="ignore"):
            for operation, args, to in self.work:
                values[to] = operation(*[values[a] for a in args])
        return [values[number] for number in self.results]
