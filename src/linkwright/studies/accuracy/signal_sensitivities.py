"""Expressions of signals with their exact derivatives by the deviations, at any time of the run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.fields import Expression
from linkwright.expressions.language import Node, evaluate
from linkwright.expressions.units import Dimension
from linkwright.kernels.combined import expressed
from linkwright.kernels.tangents import Tangents
from linkwright.notation.duals import Dual, slope_of, value_of
from linkwright.reductions import Local
from linkwright.results import Run

Array = NDArray[np.float64]


class Slopes:
    """Expressions over a run by deviations: ``directions`` (parameters, n) and ``plays`` of joints, as
    :class:`Tangents` takes them."""

    def __init__(self, run: Run, directions: Array, plays: Sequence[str] = ()) -> None:
        self.run, self.tangents = run, Tangents(run.compiled, directions, plays)
        self.count = self.tangents.count
        self.given: dict[str, Any] = self.tangents.parameter_values()
        """The parameters, those that deviate as duals, and so the places of joins of motion laws."""
        self.joins: list[str] = []
        for law, motion in run.compiled.motions.items():
            if any(isinstance(self.given[name], Dual) for name in motion.names):
                places = motion.places_at(law, self.given)
                self.joins += places
                self.given |= places

    def at(self, trees: Sequence[Node], t: Array, rates: bool = True) -> Local:
        """Expressions bound to SI at times ``t`` (s); without ``rates`` these and their slopes are 0."""
        names, kinds = self.run.signals_of(trees), 2 if rates else 1
        value, slope = self.tangents.evaluate(names, t, rates)
        value, slope = (part.reshape(len(names), kinds, *part.shape[-k:]) for k, part in ((1, value), (2, slope)))
        if any(self.run.compiled.graph.wrapped(name) for name in names):
            value[:, 0] = self.run.evaluate(names, t)
        rows = {
            name: tuple(Dual(v, s) for v, s in zip(values, slopes, strict=True))
            for name, values, slopes in zip(names, value, slope, strict=True)
        }
        found = Local(*(np.zeros((len(trees), t.size)) for _ in "vr"), *(np.zeros(self._shape(trees, t)) for _ in "st"))
        for i, tree in enumerate(trees):
            jet = expressed(self.run.compiled, tree, t, rows, kinds - 1, self.given)
            for d, values, slopes in zip(jet.d, (found.value, found.rate), (found.slope, found.twist), strict=False):
                values[i], slopes[i] = value_of(d), slope_of(d)
        return found

    def _shape(self, trees: Sequence[Node], t: Array) -> tuple[int, ...]:
        return len(trees), self.count, t.size

    def constant(self, expression: Expression, dimension: Dimension) -> tuple[float, Array]:
        """An expression of parameters alone: its value and its slopes (deviations,)."""
        node = self.run.compiled.quantities.bind(expression, dimension)
        number = evaluate(node, lambda name: self.given[name.text])
        return float(value_of(number)), np.broadcast_to(np.ravel(slope_of(number)), self.count).astype(float)
