"""What a page needs to compute the motion of a mechanism itself, with parameters that its reader moves.

Parameters that follow from others by expressions are a program of their own. Drives come as values and rates at
sampled times. Both are exact at any values of the free parameters as long as nothing is ``held``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.language import evaluate
from linkwright.graph.program import ExpressionStage, Program
from linkwright.graph.rows import Named
from linkwright.kernels.compiled import Compiled
from linkwright.kernels.javascript_source import javascript, labels
from linkwright.model.quantities import Quantities
from linkwright.model.sampled import names_in
from linkwright.presentation.json_numbers import listed

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Live:
    """A program of signals; the program of all its parameters, whose inputs are the free ones, with their nominal
    ``values`` (SI); the signals' inputs at ``times`` (s): (inputs, times).

    ``held`` names the inputs that stay what they are at the nominal parameters, though they depend on them: laws of
    drives with parameters, answers of tables, whole turns of angles. Unknowns of Newton's stages are starts only.
    """

    program: Program
    derived: Program
    values: tuple[float, ...]
    times: Array
    inputs: Array
    held: tuple[str, ...]

    def code(self) -> dict[str, str]:
        """The JavaScript of both programs: nothing of it comes from a name."""
        return {"signals": javascript(self.program), "derived": javascript(self.derived)}

    def data(self) -> dict[str, Any]:
        """All else, to be written as JSON: names, and numbers; of inputs the rows that are used."""
        used = sorted(self.program.used[0])
        return {
            "signals": labels(self.program),
            "free": list(self.derived.inputs),
            "values": list(self.values),
            "times": self.times.tolist(),
            "rows": used,
            "x": [listed(row) for row in self.inputs[used]],
            "held": list(self.held),
        }


def live(compiled: Compiled, names: Sequence[Named], times: Array, rates: bool = False) -> Live:
    """Signals of a mechanism over times (s) as a page can compute them; with ``rates``, each followed by its rate."""
    program = compiled.graph.program(list(names), rates, solve=True)
    derived, quantities = derived_parameters(compiled.quantities), compiled.quantities
    x = compiled.inputs(times, starts=True)
    held = tuple(_held(compiled, program))
    return Live(program, derived, tuple(quantities.parameters[name] for name in derived.inputs), times, x, held)


def derived_parameters(quantities: Quantities) -> Program:
    """The program of all parameters (SI): its inputs are those that depend on no other."""
    names, parts = tuple(quantities.parameters), quantities.mechanism.parameters
    free = tuple(name for name in names if not names_in(parts[name].value.node) & {*names})
    x = ca.SX.sym("x", len(free))
    known = dict(zip(free, ca.vertsplit(x) if free else (), strict=True))
    for name in quantities.order:
        if name not in known:
            node = quantities.bind(parts[name].value, quantities.dimensions.of(name))
            known[name] = ca.SX(evaluate(node, lambda other: known[other.text]))
    stage = ExpressionStage.from_rows(x, ca.SX(0, 1), [known[name] for name in names])
    return Program((), stage, free, (), names)


def _held(compiled: Compiled, program: Program) -> Iterator[str]:
    """The used inputs that depend on parameters."""
    graph, used = compiled.graph, program.used[0]
    for i, drive in enumerate(graph.drives):
        if compiled.laws[drive].names and not used.isdisjoint(range(i * graph.width, (i + 1) * graph.width)):
            yield drive
    yield from (graph.inputs[row] for row in sorted(used) if row >= compiled.supply.first and graph.inputs[row] != "t")
