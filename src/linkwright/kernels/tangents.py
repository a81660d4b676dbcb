"""Signals of a compiled mechanism with their exact derivatives by deviations of its parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.rows import Named, TableArgument
from linkwright.graph.tangent import tangent
from linkwright.kernels.compiled import Compiled
from linkwright.kernels.parameter_batch import Varied
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.notation import Jet
from linkwright.notation.duals import Dual, slope_of

Array = NDArray[np.float64]

MOST = 1 << 18
"""Poses x directions that are computed together."""


class Tangents:
    """Derivatives along ``directions`` (parameters, n) in parameter space, SI, and by the ``plays`` of joints (see
    :class:`linkwright.graph.geometry.Geometry`), which count as further directions; at the nominal parameters, or by
    :meth:`at_parameters` at others."""

    def __init__(self, compiled: Compiled, directions: Array, plays: Sequence[str] = (), kernel: str = "numpy") -> None:
        self.compiled, self.graph, self.plays, self.kernel = compiled, compiled.graph, tuple(plays), kernel
        parameters, many = directions.shape
        self.count = many + len(plays)
        self.parameters = compiled.parameters
        self._varied: Varied | None = None
        along = np.zeros((parameters + len(plays), self.count))
        along[:parameters, :many], along[parameters:, many:] = directions, np.eye(len(plays))
        self.along = along[:parameters]
        self.p = self._with(along)
        self._kernels: dict[tuple[tuple[Named, ...], bool], Kernel] = {}

    def _with(self, along: Array) -> Array:
        """The parameters with each direction: (2 parameters + plays, directions)."""
        return np.concatenate([np.repeat(self.parameters[:, None], self.count, axis=1), along])

    def at_parameters(self, parameters: Array, directions: Array | None = None) -> Tangents:
        """The same at other parameters (parameters,), as :meth:`Varied.parameters` gives them, and along other
        ``directions`` where parameters follow the deviations by expressions that aren't linear; branches stay."""
        other = copy(self)
        names = [
            n for n, a, b in zip(self.graph.parameters, parameters, self.compiled.parameters, strict=True) if a != b
        ]
        other.parameters, other._varied = parameters, Varied(self.compiled, names)
        along = self.p[len(parameters) :].copy()
        if directions is not None:
            along[: len(parameters), : directions.shape[1]] = directions
        other.along, other.p = along[: len(parameters)], other._with(along)
        return other

    def parameter_values(self) -> dict[str, float | Dual]:
        """All parameters by name, those that some direction changes with their slopes: (directions, 1). Plays too."""
        rows = zip(self.graph.parameters, self.parameters.tolist(), self.along, strict=True)
        own: dict[str, float | Dual]
        own = {name: Dual(value, slopes[:, None]) if slopes.any() else value for name, value, slopes in rows}
        units = np.eye(self.count)[self.count - len(self.plays) :]
        return own | {play: Dual(0.0, unit[:, None]) for play, unit in zip(self.plays, units, strict=True)}

    def evaluate(self, names: Sequence[Named], t: Array, rates: bool = False) -> tuple[Array, Array]:
        """Signals at times ``t`` (s) and their derivatives: (names, times) and (names, directions, times) in SI; with
        ``rates`` each with its time derivative, (names, 2, times) and (names, 2, directions, times)."""
        kinds = 2 if rates else 1
        values, slopes = np.empty((len(names), kinds, t.size)), np.empty((len(names), kinds, self.count, t.size))
        if names and not self.count:
            values[:] = self.compiled.evaluate(names, t, rates).reshape(values.shape)
        step = max(1, MOST // max(1, self.count))
        for first in range(0, t.size, step) if slopes.size else ():
            some = slice(first, first + step)
            y = (
                self._engine(tuple(names), rates)
                .over(self.inputs(t[some]), self.p)
                .reshape(len(names), 2, kinds, self.count, -1)
            )
            values[..., some], slopes[..., some] = y[:, 0, :, 0], y[:, 1]
        return (values, slopes) if rates else (values[:, 0], slopes[:, 0])

    def _engine(self, names: tuple[Named, ...], rates: bool) -> Kernel:
        if (names, rates) not in self._kernels:
            program = tangent(self.graph, names, rates, self.plays)
            self._kernels[names, rates] = KERNELS[self.kernel](program)
        return self._kernels[names, rates]

    def inputs(self, t: Array) -> Array:
        """The inputs at times ``t`` and their tangents: (2 inputs, directions, times)."""
        graph, size = self.graph, len(self.graph.inputs)
        x = np.zeros((2 * size, self.count, t.size))
        x[:size] = self._own_inputs(t)[:, None, :]
        given = self.parameter_values()
        for i, drive in enumerate(graph.drives):
            law = self.compiled.laws[drive]
            asked = law.names | (law.plays & {*self.plays})
            if any(isinstance(given[name], Dual) for name in asked):
                own: Mapping[str, float | Dual] = {name: given[name] for name in asked}
                for k, row in enumerate(law.at(t, own).d, start=size + i * graph.width):
                    x[k] = slope_of(row)
        self._look_up(x, given)
        supply = self.compiled.supply
        for name, law in supply.followers.items():
            motor = supply.motor(law)
            angle, speed = (Dual(x[row], x[size + row]) for row in (motor, motor + 1))
            for k, row in enumerate(law.ratio(angle, speed, given)):
                x[size + supply.rows[f"ratio/{name}/{k}"]] = slope_of(row)
        return x

    def _own_inputs(self, t: Array) -> Array:
        if self._varied is None:
            return self.compiled.inputs(t)
        every = frozenset(range(len(self.graph.inputs)))
        return self._varied.inputs(self.parameters[:, None], t, every, self.kernel)[:, 0]

    def _look_up(self, x: Array, given: Mapping[str, float | Dual]) -> None:
        """Put the tangents of what tables answer into the inputs."""
        graph, supply, size = self.graph, self.compiled.supply, len(self.graph.inputs)
        for which, _ in supply.levels:
            y = self._engine(tuple(map(TableArgument, which)), True).over(x, self.p)
            for i, (value, rate, slope, twist) in zip(which, y.reshape(len(which), 4, *x.shape[1:]), strict=True):
                lookup = graph.actions.lookups[i]
                table = supply.tables[lookup.table].at_parameters(given)
                ask = table.integral if lookup.integral else table.or_nan
                answers = ask(Jet([Dual(value, slope), Dual(rate, twist)])).d
                for k, answer in enumerate(answers):
                    x[size + supply.rows[f"table/{i}/{k}"]] = slope_of(answer)
