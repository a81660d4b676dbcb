"""A compiled mechanism: graph, branches, drive laws and kernels, ready to run over times.

How it is made from a mechanism: :mod:`linkwright.compilation`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from copy import copy
from dataclasses import field, replace
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.assembly import Assembly
from linkwright.graph.graph import Graph
from linkwright.graph.rows import Named
from linkwright.kernels.change_points import Passage, Passages, unwrapped
from linkwright.kernels.continuation import Continuation
from linkwright.kernels.external_inputs import Supply
from linkwright.kernels.law import DriveLaw
from linkwright.kernels.motions import StatedMotion
from linkwright.kernels.registry import KERNELS, Kernel
from linkwright.kernels.tables import StatedTable
from linkwright.model.mechanism import Mechanism
from linkwright.model.placed_copies import PlacedCopy
from linkwright.model.plane import LinkagePlane
from linkwright.model.quantities import Quantities
from linkwright.model.signals import Signal
from linkwright.structure import Group, HigherGroup, Structure

Array = NDArray[np.float64]
Made = TypeVar("Made")


@dataclass(repr=False)
class Compiled:
    """A mechanism ready to run. ``laws`` gives each drive's value and rates (SI) at an array of times (s)."""

    mechanism: Mechanism
    quantities: Quantities
    structure: Structure
    assembly: Assembly
    laws: dict[str, DriveLaw]
    tables: dict[str, StatedTable] = field(default_factory=dict)  # those that acting elements ask
    motions: dict[str, StatedMotion] = field(default_factory=dict)  # the motion laws, that drives ask
    kernel: str = "numpy"
    passages: Passages = field(default_factory=Passages)
    plane: LinkagePlane | None = None  # where a sketch of three coordinates lies in the vehicle
    folder: Path | None = None  # where the files of its tables lie
    adjusted: Callable[[Array], Array] | None = None  # what is changed of all inputs before the program runs
    copies: tuple[PlacedCopy, ...] = ()  # those of sub-assemblies that it has
    _kernels: dict[tuple[tuple[Named, ...], bool], Kernel] = field(default_factory=dict)
    _nodes: dict[tuple[Passage, tuple[Named, ...], bool], Array] = field(default_factory=dict, init=False)
    _kept: dict[object, Any] = field(default_factory=dict, init=False)

    def __post_init__(self) -> None:
        self.graph = Graph(self.quantities, self.structure)
        self.parameters = np.array([self.quantities.parameters[name] for name in self.graph.parameters])
        self._supplied()

    def __repr__(self) -> str:
        links, joints = len(self.mechanism.links), self.structure.topology.joint_count
        return f"<{type(self).__name__} {self.mechanism.title!r}: links {links}, joints {joints}>"

    def cached(self, key: object, make: Callable[[], Made]) -> Made:
        """What others derive of it, made once for a key."""
        if key not in self._kept:
            self._kept[key] = make()
        made: Made = self._kept[key]
        return made

    def _supplied(self) -> None:
        """What follows the motion to give inputs of the program, at the start of it."""
        starts, size = self.assembly.starts, self.assembly.size()
        bands = [passage.band for passage in self.passages.every]
        self.followers = [
            Continuation(self.graph, c, starts[c], size, self.kernel, bands) for c in self.structure.higher_groups
        ]
        self.supply = Supply(self.graph, self.tables, self.kernel, self.laws)

    def inputs(self, t: Array, higher_groups: int | None = None, actions: bool = True, starts: bool = False) -> Array:
        """The per-pose inputs at times ``t`` (s): (inputs, poses), in SI; only the first ``higher_groups`` in place,
        those of acting elements only where ``actions``. With ``starts``, the higher groups' coordinates are only near
        their solutions, for a program that solves them."""
        width = self.graph.width
        x = np.empty((len(self.graph.inputs), t.size))
        for i, drive in enumerate(self.graph.drives):
            for row, d in zip(x[i * width : (i + 1) * width], self.laws[drive](t).d, strict=True):
                row[:] = d
        for i, group in enumerate(self.graph.branched, start=width * len(self.graph.drives)):
            x[i] = self.assembly.branches[group] * self.passages.sign(group.label, t)
        x[self.graph.first_unknown :] = np.nan
        for i, follower in enumerate(self.followers[:higher_groups]):
            follow = follower.foretell if starts else follower.solve
            x[follower.rows] = follow(x, t, self.parameters, partial(self.inputs, higher_groups=i))
        if higher_groups is None and actions:
            self.supply.fill(x, t, self.parameters, partial(self.inputs, actions=False))
        return x

    def branches(self, time: float) -> dict[Group, float]:
        """Each group's branch at a time."""
        t = np.array([time])
        return {g: b * float(self.passages.sign(g.label, t)[0]) for g, b in self.assembly.branches.items()}

    def unknowns(self, time: float) -> dict[HigherGroup, list[float]]:
        """The coordinates of every higher group at a time."""
        x = self.inputs(np.array([time]))[:, 0]
        return {follower.higher_group: x[follower.rows].tolist() for follower in self.followers}

    def evaluate(self, names: Sequence[Named], t: Array, rates: bool = False) -> Array:
        """Signals by name, or other rows, at times ``t``: (rows, poses) in SI, or (rows, 2, poses) with their rates.

        Angles of links come out in -pi..pi where the graph doesn't know them exactly; see
        :class:`linkwright.results.Run` for continuous ones. NaN are reactions that a redundant mechanism leaves
        undetermined.
        """
        y = self.possible_rows(names, t, rates)
        y[self.undetermined(names)] = np.nan
        return y

    def undetermined(self, names: Sequence[Named]) -> list[int]:
        """Which of some rows are reactions that a redundant mechanism leaves undetermined."""
        signals = self.quantities.signals
        if not signals.undetermined:
            return []
        named = ((i, name) for i, name in enumerate(names) if isinstance(name, str))
        return [i for i, name in named if signals.is_undetermined(self.graph.signal(name))]

    def possible_rows(self, names: Sequence[Named], t: Array, rates: bool = False) -> Array:
        """Such rows; undetermined reactions with the values of one of the states that statics allows."""
        y = self.closed_form_rows(names, t, rates)
        for passage in self.passages.every:
            inside = passage.inside(t)
            if inside.any():
                y[:, inside] = self._limits(passage, tuple(names), t[inside], rates)
        return y.reshape(len(names), 2, t.size) if rates else y

    def rates(self, names: Sequence[Named], t: Array) -> tuple[Array, Array]:
        """Such rows and their rates at times ``t``, as they come out of :meth:`evaluate`."""
        y = self.evaluate(names, t, rates=True)
        return y[:, 0], y[:, 1]

    def closed_form_rows(self, names: Sequence[Named], t: Array, rates: bool = False) -> Array:
        """The program's rows at times ``t`` by their closed forms alone, each followed by its rate if asked for."""
        key = (tuple(names), rates)
        if key not in self._kernels:
            self._kernels[key] = KERNELS[self.kernel](self.graph.program(*key))
        program = self.graph.program(*key)
        actions = any(row >= self.supply.first for row in program.used[0])
        x = self.inputs(t, actions=actions or self.adjusted is not None)
        return self._kernels[key].run(x if self.adjusted is None else self.adjusted(x), self.parameters)

    def _limits(self, passage: Passage, names: tuple[Named, ...], t: Array, rates: bool) -> Array:
        """The program's rows in a passage's band."""
        step = 2 if rates else 1
        key = (passage, names, rates)
        if key not in self._nodes:
            turning = [step * i for i, name in enumerate(names) if self.graph.wrapped(name)]
            self._nodes[key] = unwrapped(self.closed_form_rows(names, passage.nodes, rates), turning)
        values = self._nodes[key]
        signals = self.graph.signals(names)
        poles = [self._pole(passage, signal) for signal in signals]
        powers = [power + (k if power else 0) for power in poles for k in range(step)]
        y = passage.between(t, values, np.array(powers, dtype=int))
        centres = [signal is not None and signal.kind == "pole" for signal in signals]
        if any(centres):  # these may be at infinity anywhere
            off = passage.between(passage.proof, values) - self.closed_form_rows(names, passage.proof, rates)
            far = ~(np.abs(off) <= 1e-7 * np.abs(values).max(axis=1, keepdims=True)).all(axis=1)
            y[far & np.repeat(centres, step)] = np.nan
        for i, signal in enumerate(signals):
            if signal is not None and signal.attribute == "arm":
                parts = tuple(replace(signal, attribute=part).text for part in ("moment", "normal"))
                (m, n) = self._limits(passage, parts, t, rates).reshape(2, step, t.size)
                with np.errstate(all="ignore"):
                    y[step * i] = m[0] / n[0]
                    if rates:
                        y[step * i + 1] = (m[1] - y[step * i] * n[1]) / n[0]
        return y

    def _pole(self, passage: Passage, signal: Signal | None) -> int:
        """The power by which a signal grows without bound; a reaction by that of its opposite."""
        if not passage.poles or signal is None:
            return 0
        opposite = replace(signal, owners=(*signal.owners[1::-1], *signal.owners[2:]))
        return max(passage.poles.get(s.text, 0) for s in (signal, opposite))

    def with_passages(self, passages: Passages) -> Compiled:
        """The same mechanism with its branches carried through change points."""
        other = copy(self)
        other.passages, other._nodes = passages, {}
        other._supplied()
        return other
