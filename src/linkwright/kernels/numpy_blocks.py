"""The NumPy emitter: a program's instructions as ufunc calls over blocks of poses, written into work slots.

Nothing is compiled. What depends on the parameters alone is computed once per call, on plain numbers; the rest
runs over blocks small enough for the work slots to stay in cache.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from linkwright.graph.program import ExpressionStage, Instruction, Program
from linkwright.kernels.registry import register

Array = NDArray[np.float64]

BLOCK = 2048

_UNARY: dict[int, Any] = {
    ca.OP_NEG: np.negative, ca.OP_SQRT: np.sqrt, ca.OP_SIN: np.sin, ca.OP_COS: np.cos, ca.OP_TAN: np.tan,
    ca.OP_ASIN: np.arcsin, ca.OP_ACOS: np.arccos, ca.OP_ATAN: np.arctan, ca.OP_EXP: np.exp, ca.OP_LOG: np.log,
    ca.OP_FABS: np.fabs, ca.OP_SIGN: np.sign, ca.OP_SQ: np.square, ca.OP_INV: np.reciprocal,
    ca.OP_FLOOR: np.floor, ca.OP_ASSIGN: np.positive, ca.OP_NOT: np.logical_not,
}  # fmt: skip
_BINARY: dict[int, Any] = {
    ca.OP_ADD: np.add, ca.OP_SUB: np.subtract, ca.OP_MUL: np.multiply, ca.OP_DIV: np.divide, ca.OP_POW: np.power,
    ca.OP_CONSTPOW: np.power, ca.OP_ATAN2: np.arctan2, ca.OP_FMIN: np.fmin, ca.OP_FMAX: np.fmax,
    ca.OP_HYPOT: np.hypot, ca.OP_COPYSIGN: np.copysign,
    ca.OP_LT: np.less, ca.OP_LE: np.less_equal, ca.OP_EQ: np.equal, ca.OP_NE: np.not_equal,
    ca.OP_AND: np.logical_and, ca.OP_OR: np.logical_or,
}  # fmt: skip
Operand = float | int
"""A uniform number, or the index of a row of the block."""


@register
class NumpyKernel:
    """Runs a program over arrays of poses. ``run`` wants every input row of the program, in its order."""

    name = "numpy"

    def __init__(self, program: Program) -> None:
        self.program = program
        self._plan: tuple[bytes, _Plan] | None = None
        self._block: _Block | None = None

    def run(self, x: Array, p: Array, out: Array | None = None) -> Array:
        """All outputs at all poses.

        Parameters: ``x`` (inputs, poses) the per-pose inputs, ``p`` (parameters,), both in SI. Returns
        (outputs, poses), written into ``out`` when given. At poses where a group can't close its rows come out
        as NaN and its ``reach`` row is negative; the results turn that into a typed failure.
        """
        poses = x.shape[1]
        if out is None:
            out = np.empty((len(self.program.outputs), poses))
        plan = self._planned(np.ascontiguousarray(p))
        size = max(1, min(BLOCK, poses))
        block = self._blocked(plan, size)
        with np.errstate(all="ignore"):
            for start in range(0, poses, size):
                if start + size > poses:
                    block = _Block(plan, poses - start)
                block.run(x[:, start : start + size], out[:, start : start + size])
        return out

    def _planned(self, p: Array) -> _Plan:
        key = p.tobytes()
        if self._plan is None or self._plan[0] != key:
            self._plan = key, _Plan(self.program.stages[0], p)
        return self._plan[1]

    def _blocked(self, plan: _Plan, size: int) -> _Block:
        """A block of the size; the last one is kept, for searches that ask for few poses many times."""
        if self._block is None or self._block.plan is not plan or self._block.size != size:
            self._block = _Block(plan, size)
        return self._block


class _Plan:
    """A stage with its uniform part done: ``work`` is what is left per pose, over rows of a block.

    A block's rows are the work slots, then the inputs. An instruction of ``work`` is (function, operands, row).
    """

    def __init__(self, stage: ExpressionStage, p: Array) -> None:
        self.p, self.slots, self.inputs = p, stage.slots, stage.inputs
        self.work: list[tuple[Callable[..., Any], tuple[Operand, ...], int]] = []
        self.outputs: list[tuple[int, int, Operand]] = []  # (place in work, output, its operand)
        self.holds: dict[int, Operand] = {}  # what each slot stands for while the list is read
        with np.errstate(all="ignore"):
            for instruction in stage.instructions:
                self.read(instruction)

    def read(self, i: Instruction) -> None:
        if i.op == ca.OP_CONST:
            self.holds[i.out] = i.value
        elif i.op == ca.OP_INPUT:
            which, row = i.args
            self.holds[i.out] = float(self.p[row]) if which == 1 else self.slots + row
        elif i.op == ca.OP_OUTPUT:
            self.outputs.append((len(self.work) + len(self.outputs), i.out, self.holds[i.args[0]]))
        else:
            self.compute(i)

    def compute(self, i: Instruction) -> None:
        function, operands = self.lookup(i)
        if all(isinstance(o, float) for o in operands):
            self.holds[i.out] = float(function(*operands))
        else:
            self.work.append((function, tuple(operands), i.out))
            self.holds[i.out] = i.out

    def lookup(self, i: Instruction) -> tuple[Callable[..., Any], list[Operand]]:
        first = self.holds[i.args[0]]
        if i.op in _UNARY:
            return _UNARY[i.op], [first]
        if i.op == ca.OP_TWICE:
            return np.multiply, [first, 2.0]
        second = self.holds[i.args[1]]
        if i.op == ca.OP_IF_ELSE_ZERO:
            return _if_else_zero, [first, second]
        if i.op not in _BINARY:
            raise NotImplementedError(f"the NumPy kernel has no instruction {i.op}")
        return _BINARY[i.op], [first, second]


def _if_else_zero(condition: Any, value: Any, out: Array | None = None) -> Any:
    result = np.where(np.asarray(condition) != 0, value, 0.0)
    if out is None:
        return result
    np.copyto(out, result)
    return out


class _Block:
    """The rows of one block, and the calls bound to them."""

    def __init__(self, plan: _Plan, size: int) -> None:
        self.plan, self.size = plan, size
        rows = np.empty((plan.slots + plan.inputs, size))
        self.x = rows[plan.slots :]
        self.results = [rows[o] if isinstance(o, int) else o for _, _, o in plan.outputs]
        self.calls: list[tuple[Callable[..., Any], tuple[Any, ...]]] = [
            (function, (*(rows[o] if isinstance(o, int) else o for o in operands), rows[to]))
            for function, operands, to in plan.work
        ]
        for place, _, _ in plan.outputs:
            self.calls.insert(place, (np.copyto, ()))

    def run(self, x: Array, out: Array) -> None:
        """Compute the block's poses; results are copied out where the list says, as slots are used again."""
        np.copyto(self.x, x)
        for (place, output, _), result in zip(self.plan.outputs, self.results, strict=True):
            self.calls[place] = np.copyto, (out[output], result)
        for function, args in self.calls:
            function(*args)
