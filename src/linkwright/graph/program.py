"""Programs: what a kernel runs, as a list of stages with named inputs and outputs.

Stages are of two kinds: a block of straight-line expressions, and a Newton solve of a higher group's closure. A
mechanism of dyads is a single block. The linear systems of rates and forces stay in the block, as a sparse QR
written out: it keeps its digits, and costs less than a solver called at each pose (docs/performance.md).
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.symbols import ExpressionStage


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
        """One pose, instruction by instruction: the reference that emitters are held to."""
        x = np.array(x, dtype=float)
        for stage in self.solves:
            rows, n = list(stage.rows), len(stage.rows)
            for _ in range(MOST_STEPS):
                y = np.array(stage.closure.numbers(x.tolist(), p.tolist()), dtype=float)
                x[rows] -= np.linalg.solve(y[n:].reshape(n, n), y[:n])
        return np.array(self.block.numbers(x.tolist(), p.tolist()), dtype=float)
