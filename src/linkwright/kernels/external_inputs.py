"""What acting elements and followers need as inputs of each pose: the time, whole turns of angles, the answers of
tables, how fast followers move with their motors."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.fields import Expression
from linkwright.expressions.units import Dimension
from linkwright.graph.graph import Graph
from linkwright.graph.rows import RawAngle, TableArgument
from linkwright.kernels.followers import FollowerLaw
from linkwright.kernels.law import DriveLaw, Parameters
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.kernels.tables import StatedTable
from linkwright.notation import Jet, angles
from linkwright.notation.angles import MAX_TURN, whole_turns

Array = NDArray[np.float64]

MAX_STEPS = 1 << 15
MOST = 1 << 22
"""The most places of an angle that are kept; one that turns on and on beyond them is NaN."""


class Supply:
    """Fills the input rows of acting elements and followers, from inputs in which the motion stands already."""

    def __init__(
        self, graph: Graph, tables: Mapping[str, StatedTable], kernel: str, laws: Mapping[str, DriveLaw] | None = None
    ) -> None:
        self.graph, self.tables = graph, tables
        self.followers = {name: law for name, law in (laws or {}).items() if isinstance(law, FollowerLaw)}
        self.first = len(graph.motion_inputs)
        self.rows = {name: row for row, name in enumerate(graph.inputs)}
        actions = graph.actions
        self.turns = {name: Turns(graph, name, self.start_angle(name), kernel) for name in actions.turning}
        numbered = sorted(enumerate(actions.lookups), key=lambda lookup: lookup[1].level)
        self.levels: list[tuple[list[int], Kernel]] = []
        for _, group in groupby(numbered, key=lambda lookup: lookup[1].level):
            which = [i for i, _ in group]
            program = graph.program([TableArgument(i) for i in which], rates=True)
            self.levels.append((which, KERNELS[kernel](program)))

    def start_angle(self, name: str, value: Callable[[Expression, Dimension], Any] | None = None) -> Any:
        """The angle (rad) near which that of an acting element starts, ``None`` of a link or drive; the nominal one, or
        by what gives other values (SI) of expressions."""
        if name not in self.graph.actions.counted_angles:
            return None
        one, value = self.graph.actions.counted_angles[name][0], value or self.graph.quantities.value
        return one.kind.start_angle(one.entry, value, lambda table: float(self.tables[table].x[[0, -1]].mean()))

    def fill(self, x: Array, t: Array, p: Array, at: Callable[[Array], Array]) -> None:
        """Put the rows for times ``t`` into ``x`` (inputs, poses); ``at`` gives the inputs of the motion."""
        x[self.first :] = 0.0
        if "t" in self.rows:
            x[self.rows["t"]] = t
        for name, turns in self.turns.items():
            x[self.rows[f"turns/{name}"]] = turns(x, t, p, at)
        given = dict(zip(self.graph.parameters, p, strict=True))
        self.look_up(x, lambda kernel: kernel.run(x, p), given)
        self.fill_follower_inputs(x, given)

    def look_up(self, x: Array, ask: Callable[[Kernel], Array], parameters: Parameters) -> None:
        """Put the answers of tables into ``x`` (inputs, ...); ``ask`` runs the kernel of the arguments."""
        for which, kernel in self.levels:
            answers = ask(kernel).reshape(len(which), 2, *x.shape[1:])
            for i, argument in zip(which, answers, strict=True):
                lookup = self.graph.actions.lookups[i]
                table = self.tables[lookup.table].at_parameters(parameters)
                value = (table.integral if lookup.integral else table.or_nan)(Jet([*argument]))
                x[self.rows[f"table/{i}/0"]], x[self.rows[f"table/{i}/1"]] = value.d

    def fill_follower_inputs(self, x: Array, parameters: Parameters) -> None:
        """Put the ratios of followers, and what places their second contacts, into ``x`` (inputs, ...)."""
        for name, law in self.followers.items():
            motor = self.motor(law)
            for k, row in enumerate(law.ratio(x[motor], x[motor + 1], parameters)):
                x[self.rows[f"ratio/{name}/{k}"]] = row
            if (place := self.rows.get(f"total/{name}")) is not None:
                x[place] = law.total

    def motor(self, law: FollowerLaw) -> int:
        """The input row of the value of a follower's motor."""
        return self.graph.drives.index(law.motor) * self.graph.width


class Turns:
    """The whole turns of an angle that is known only modulo a turn: it runs on without jumps from t = 0.

    There it lies within half a turn of ``start_angle``, or where it is read off the axis without one.
    """

    def __init__(self, graph: Graph, name: str, start_angle: float | None, kernel: str) -> None:
        self.kernel: Kernel = KERNELS[kernel](graph.program([RawAngle(name)], rates=True))
        self.start_angle = start_angle
        self.t, self.angle = np.empty(0), np.empty(0)

    def __call__(self, x: Array, t: Array, p: Array, at: Callable[[Array], Array]) -> Array:
        self.extend(float(t.max(initial=0.0)), p, at)
        near = np.interp(t, self.t, self.angle)
        return whole_turns(self.kernel.run(x, p)[0], near)

    def extend(self, to: float, p: Array, at: Callable[[Array], Array]) -> None:
        """Follow the angle up to a time, in steps that turn no further than :data:`MAX_TURN`."""
        if not self.t.size:
            self.t = np.zeros(1)
            self.angle = self.kernel.run(at(self.t), p)[0]
            if self.start_angle is not None:
                self.angle = self.angle + 2 * np.pi * whole_turns(self.angle, self.start_angle)
        steps, last, end = 32, float(self.t[-1]), to
        while end > last:
            grid = np.linspace(last, to, steps + 1)
            angle, omega = self.kernel.run(at(grid), p)
            known = np.isfinite(angle) & np.isfinite(omega)
            grid, angle, omega = grid[known], angle[known], omega[known]
            turned, largest = angles.steps(grid, angle, omega)
            if largest > MAX_TURN:
                if steps < MAX_STEPS:
                    steps *= 2
                    continue
                if self.t.size < MOST and to - last > 1e-13 * abs(end):
                    to = (last + to) / 2
                    continue
                path = np.full(grid.size - 1, np.nan)  # it turns too often to be followed
                self.t, self.angle = np.append(self.t, [*grid[1:], end]), np.append(self.angle, [*path, np.nan])
                return
            # What can't be followed leaves the angle where it was.
            self.t = np.concatenate([self.t, grid[1:], [to]])
            path = self.angle[-1] + np.cumsum(turned)
            self.angle = np.concatenate([self.angle, path, (path if path.size else self.angle)[-1:]])
            last, to = to, end
