"""Programs: what a kernel runs, as a list of stages with named inputs and outputs.

Stages are of two kinds: a block of straight-line expressions, and a Newton solve of a higher group's closure. A
mechanism of dyads is a single block. The linear systems of rates and forces stay in the block, as a sparse QR
written out: it keeps its digits, and costs less than a solver called at each pose (docs/performance.md).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from linkwright.data_classes import dataclass
from linkwright.notation.symbols import column


class Instruction(NamedTuple):
    """One step of a block: ``out = op(args)`` over work slots; constants and inputs are sources of slots."""

    op: int
    out: int
    args: tuple[int, ...]
    value: float = 0.0


@dataclass(frozen=True)
class ExpressionStage:
    """A block of straight-line expressions of the per-pose inputs x and the parameters p."""

    function: Any

    @classmethod
    def from_rows(cls, x: Any, p: Any, rows: Sequence[Any]) -> ExpressionStage:
        """The block that computes ``rows``; common parts are computed once."""
        return cls(ca.Function("block", [x, p], [ca.cse(column(rows))]))

    @cached_property
    def inputs(self) -> int:
        """The number of per-pose inputs."""
        return int(self.function.size1_in(0))

    @cached_property
    def rows(self) -> int:
        """The number of output rows."""
        return int(self.function.size1_out(0))

    @cached_property
    def slots(self) -> int:
        """The number of work slots."""
        return int(self.function.sz_w())

    @cached_property
    def used(self) -> tuple[frozenset[int], frozenset[int]]:
        """The per-pose inputs and the parameters on which something depends."""
        read = [i.args for i in self.instructions if i.op == ca.OP_INPUT]
        return frozenset(row for k, row in read if k == 0), frozenset(row for k, row in read if k == 1)

    @cached_property
    def instructions(self) -> tuple[Instruction, ...]:
        """The instruction list, dead code removed, in order."""
        f = self.function
        found = []
        for k in range(f.n_instructions()):
            op = f.instruction_id(k)
            outs, args = f.instruction_output(k), f.instruction_input(k)
            value = f.instruction_constant(k) if op == ca.OP_CONST else 0.0
            if op == ca.OP_OUTPUT:
                outs, args = [outs[1]], args
            found.append(Instruction(op, outs[0], tuple(args), float(value)))
        return tuple(found)


@dataclass(frozen=True)
class NewtonStage:
    """A higher group's closure solved by Newton: the input ``rows`` hold the start and are replaced by the solution.

    ``closure`` computes what each of the n closures misses, then its n slopes, row by row. Steps are measured over
    ``scale`` (1 rad, or the mechanism's size), those of ``sliding`` coordinates over their own magnitude where that is
    more. A pose is solved when a step falls below :data:`SOLVED`; one whose last step of :data:`MOST_STEPS` isn't
    below :data:`ACCEPTED`, or whose slopes are singular, comes out as NaN.
    """

    rows: tuple[int, ...]
    closure: ExpressionStage
    scale: tuple[float, ...]
    sliding: tuple[bool, ...]


SOLVED, ACCEPTED, MOST_STEPS = 1e-14, 1e-10, 30


@dataclass(frozen=True)
class Program:
    """Stages, the names of per-pose inputs, of parameters, and of outputs.

    The Newton stages come first, in the order in which they can be solved; the last stage is the block of the outputs.
    """

    solves: tuple[NewtonStage, ...]
    block: ExpressionStage
    inputs: tuple[str, ...]
    parameters: tuple[str, ...]
    outputs: tuple[str, ...]

    @cached_property
    def used(self) -> tuple[frozenset[int], frozenset[int]]:
        """The per-pose inputs and the parameters on which something depends."""
        stages = [self.block, *(stage.closure for stage in self.solves)]
        starts = frozenset(row for stage in self.solves for row in stage.rows)
        return starts.union(*(s.used[0] for s in stages)), frozenset().union(*(s.used[1] for s in stages))

    @cached_property
    def size(self) -> int:
        """The number of instructions of all stages."""
        return sum(len(s.instructions) for s in (self.block, *(stage.closure for stage in self.solves)))

    def __call__(self, x: np.ndarray, p: np.ndarray) -> np.ndarray:
        """One pose by CasADi's own virtual machine: the reference that emitters are held to."""
        x = np.array(x, dtype=float)
        for stage in self.solves:
            rows, n = list(stage.rows), len(stage.rows)
            for _ in range(MOST_STEPS):
                y = np.asarray(stage.closure.function(x, p)).ravel()
                x[rows] -= np.linalg.solve(y[n:].reshape(n, n), y[:n])
        return np.asarray(self.block.function(x, p)).ravel()
