"""The NumPy emitter: a program's instructions as ufunc calls over blocks of poses, written into work slots.

Nothing is compiled. What depends on the parameters alone is computed once per call, on plain numbers, or once a
sample where they vary; what depends on the pose's inputs alone once a pose for all samples of a block. Blocks are small
enough for the work slots to stay in cache.
"""

from __future__ import annotations

import threading
from collections import Counter
from collections.abc import Callable
from operator import itemgetter
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.program import Program
from linkwright.kernels.newton import solve
from linkwright.kernels.registry import flattened, register
from linkwright.symbols import CONSTANT, INPUT, OPERATIONS, OUTPUT, ExpressionStage, Instruction

Array = NDArray[np.float64]

BLOCK = 2048
X, P, XP = 1, 2, 3
"""What a value depends on: the pose's inputs, the sample's parameters, both; its row has one axis or both."""
Shapes = dict[int, tuple[int, ...]]

Row = tuple[int, int]
"""A row of a block: what it depends on and its number; inputs are numbered from -1 down, parameters after them."""
Operand = float | Row
"""A uniform number, or a row."""


@register
class NumpyKernel:
    """Runs a program over arrays of poses. ``run`` wants every input row of the program, in its order."""

    name: ClassVar[str] = "numpy"
    packages: ClassVar[tuple[str, ...]] = ()
    scales: ClassVar[bool] = False  # its calls are short, and each waits for the interpreter

    def __init__(self, program: Program) -> None:
        self.program = program
        self.block = _Stage(program.block)
        self.closures = [_Stage(stage.closure) for stage in program.solves]

    @classmethod
    def available(cls) -> bool:
        """NumPy is always there."""
        return True

    def run(self, x: Array, p: Array, out: Array | None = None) -> Array:
        """All outputs at all poses.

        Parameters: ``x`` (inputs, poses) the per-pose inputs, ``p`` (parameters,) or (parameters, poses), both in SI.
        Returns (outputs, poses), written into ``out`` when given. At poses where a group can't close its rows come out
        as NaN and its ``reach`` row is negative; the results turn that into a typed failure.
        """
        if out is None:
            out = np.empty((len(self.program.outputs), x.shape[1]))
        x = solve(self.program.solves, self.closures, x, p)
        self.block.run(x, p, out)
        return out

    def over(self, x: Array, p: Array, out: Array | None = None) -> Array:
        """All outputs of all samples at all poses.

        Parameters: ``x`` (inputs, poses), the same for all samples, or (inputs, samples, poses); ``p`` (parameters,
        samples). Returns (outputs, samples, poses).
        """
        if out is None:
            out = np.empty((len(self.program.outputs), p.shape[1], x.shape[-1]))
        if self.program.solves:
            return flattened(self, x, p, out, BLOCK)
        self.block.over(x, p, out)
        return out


class _Stage:
    """A block of expressions as a plan of calls, kept for the last parameters and shape of blocks of each thread."""

    def __init__(self, stage: ExpressionStage) -> None:
        self.stage, self.kept = stage, threading.local()

    def run(self, x: Array, p: Array, out: Array | None = None) -> Array:
        """The rows over poses."""
        poses = x.shape[1]
        if out is None:
            out = np.empty((self.stage.rows, poses))
        uniform = p if p.ndim == 1 else None
        for start in range(0, poses, BLOCK):
            part = slice(start, start + BLOCK)
            block = self._block(uniform, (X, X), {X: (min(BLOCK, poses - start),)})
            block.run(x[:, part], p if uniform is not None else p[:, part], out[:, part])
        return out

    def over(self, x: Array, p: Array, out: Array) -> None:
        """The rows over samples and poses."""
        samples, poses = out.shape[1:]
        width = max(1, min(BLOCK, poses))
        height = max(1, BLOCK // width)
        for first in range(0, samples, height):
            some = slice(first, first + height)
            tall = min(height, samples - first)
            for start in range(0, poses, width):
                part, wide = slice(start, start + width), min(width, poses - start)
                block = self._block(None, (X if x.ndim == 2 else XP, P), {X: (wide,), P: (tall, 1), XP: (tall, wide)})
                inputs = x[:, part] if x.ndim == 2 else x[:, some, part]
                block.run(inputs, p[:, some, None], out[:, some, part])

    def _block(self, p: Array | None, kinds: tuple[int, int], shapes: Shapes) -> _Block:
        """A block for uniform parameters, or for those of each pose or sample; the last one is kept."""
        kept, about = self.kept.__dict__, (None if p is None else p.tobytes(), kinds)
        if kept.get("about") != about:
            kept.update(about=about, plan=_Plan(self.stage, p, kinds), shapes=None)
        if kept["shapes"] != shapes:
            kept.update(shapes=shapes, block=_Block(kept["plan"], shapes))
        block: _Block = kept["block"]
        return block


class _Plan:
    """A stage with its uniform part done: ``work`` is what is left, over rows of a block.

    An instruction of ``work`` is its function and what takes its operands and its row out of a list of ``values``, in
    which every row has its place: so a block binds thousands of calls in no time.
    """

    def __init__(self, stage: ExpressionStage, p: Array | None, kinds: tuple[int, int]) -> None:
        self.p, self.kinds = p, kinds
        self.values: list[Operand] = []
        self.places: dict[Row, int] = {}  # of rows in it
        self.work: list[tuple[Callable[..., Any], itemgetter[Any]]] = []
        self.outputs: list[tuple[int, int, int]] = []  # (number of the call, output, place of its operand)
        self.inputs: dict[int, tuple[int, int]] = {}  # the places that are copied in, by (0: x, 1: p; its row)
        self.holds: dict[int, Operand] = {}  # what each slot stands for while the list is read
        with np.errstate(all="ignore"):
            for instruction in stage.instructions:
                self.read(instruction)
        self.rows = Counter(kind for kind, _ in self.places)

    def place(self, operand: Operand) -> int:
        """Where it is among the values."""
        if isinstance(operand, float):
            self.values.append(operand)
            return len(self.values) - 1
        if operand not in self.places:
            self.places[operand] = len(self.values)
            self.values.append(operand)
        return self.places[operand]

    def read(self, i: Instruction) -> None:
        if i.op == CONSTANT:
            self.holds[i.out] = i.value
        elif i.op == INPUT:
            which, row = i.args
            if which == 1 and self.p is not None:
                self.holds[i.out] = float(self.p[row])
                return
            to = self.kinds[which], -1 - 2 * row - which
            self.inputs[self.place(to)] = which, row
            self.holds[i.out] = to
        elif i.op == OUTPUT:
            self.outputs.append((len(self.work) + len(self.outputs), i.out, self.place(self.holds[i.args[0]])))
        else:
            self.compute(i)

    def compute(self, i: Instruction) -> None:
        function, operands = self.lookup(i)
        kind = 0
        for operand in operands:
            kind |= 0 if isinstance(operand, float) else operand[0]
        if not kind:
            self.holds[i.out] = float(function(*operands))
        else:
            self.holds[i.out] = kind, i.out
            self.work.append((function, itemgetter(*map(self.place, (*operands, self.holds[i.out])))))

    def lookup(self, i: Instruction) -> tuple[Callable[..., Any], list[Operand]]:
        operands = [self.holds[slot] for slot in i.args]
        return FUNCTIONS[i.op], [*operands, 2.0] if i.op == "twice" else operands


def _if_else_zero(condition: Any, value: Any, out: Array | None = None) -> Any:
    result = np.where(condition, value, 0.0)
    if out is None:
        return result
    out[...] = result
    return out


FUNCTIONS: dict[str, Callable[..., Any]] = {
    **{name: getattr(np, name) for name in OPERATIONS if name not in ("twice", "if_else_zero")},
    "twice": np.multiply,
    "if_else_zero": _if_else_zero,
}
"""The operations by name; one that is done twice is multiplied by a second operand, 2."""


class _Block:
    """The rows of one block, and the calls bound to them."""

    def __init__(self, plan: _Plan, shapes: Shapes) -> None:
        self.plan = plan
        rows = {kind: iter(np.empty((count, *shapes[kind]))) for kind, count in plan.rows.items()}
        values: list[Any] = [o if isinstance(o, float) else next(rows[o[0]]) for o in plan.values]
        self.inputs = [(values[at], *source) for at, source in plan.inputs.items()]
        self.results = [values[at] for _, _, at in plan.outputs]
        self.calls: list[tuple[Callable[..., Any], tuple[Any, ...]]] = [
            (function, operands(values)) for function, operands in plan.work
        ]
        for place, _, _ in plan.outputs:
            self.calls.insert(place, (np.copyto, ()))

    def run(self, x: Array, p: Array, out: Array) -> None:
        """Compute the block's poses; results are copied out where the list says, as slots are used again."""
        for to, which, row in self.inputs:
            np.copyto(to, (x, p)[which][row])
        for (place, output, _), result in zip(self.plan.outputs, self.results, strict=True):
            self.calls[place] = np.copyto, (out[output], result)
        with np.errstate(all="ignore"):
            for function, args in self.calls:
                function(*args)
