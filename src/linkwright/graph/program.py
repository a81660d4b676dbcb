"""Programs: what a kernel runs, as a list of stages with named inputs and outputs.

Stages are of three kinds: a block of straight-line expressions, a Newton solve of a higher group, a pivoted
linear solve. Mechanisms of dyads need the first kind only, which is the one defined here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np


@dataclass(frozen=True)
class Instruction:
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
        return cls(ca.Function("block", [x, p], [ca.cse(ca.vertcat(*rows))]))

    @cached_property
    def inputs(self) -> int:
        """The number of per-pose inputs."""
        return int(self.function.size1_in(0))

    @cached_property
    def slots(self) -> int:
        """The number of work slots."""
        return int(self.function.sz_w())

    @cached_property
    def used(self) -> frozenset[int]:
        """The per-pose inputs on which something depends."""
        return frozenset(i.args[1] for i in self.instructions if i.op == ca.OP_INPUT and i.args[0] == 0)

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
class Program:
    """Stages, the names of per-pose inputs, of parameters, and of outputs."""

    stages: tuple[ExpressionStage, ...]
    inputs: tuple[str, ...]
    parameters: tuple[str, ...]
    outputs: tuple[str, ...]

    def __call__(self, x: np.ndarray, p: np.ndarray) -> np.ndarray:
        """One pose by CasADi's own virtual machine: the reference that emitters are held to."""
        return np.asarray(self.stages[0].function(x, p)).ravel()
