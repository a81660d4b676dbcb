"""Starts from rest: where a released mechanism stays, where no effort starts it, and the proof of the efforts that do.

At rest friction may have any value up to the static coefficient times the pressing forces. What is known are the two
efforts of a drive between which the mechanism doesn't move: those at which it starts to creep one way or the other, all
joints that move then rubbing with their static coefficients (impending motion: Beer, Johnston, Vector Mechanics for
Engineers: Statics, ch. 8). Where zero lies between them, the released mechanism stays where it is.
"""

from __future__ import annotations

from copy import copy

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions.fields import FrozenDict
from linkwright.graph.creeping import creeping_rates
from linkwright.graph.force_rows import HoldingEffort
from linkwright.graph.rows import Named
from linkwright.kernels import Compiled
from linkwright.model.signals import BREAKAWAY, Signals
from linkwright.results.run import Run
from linkwright.results.sign_intervals import CLEAR, between_changes, stretches
from linkwright.structure import Structure, Topology

Array = NDArray[np.float64]


def starting(compiled: Compiled) -> list[str]:
    """The drives whose starts from rest are known."""
    return [name for name in compiled.graph.motors if compiled.quantities.signals.breaks_away(name)]


def efforts(compiled: Compiled, drive: str, t: Array) -> Array:
    """The efforts that start the motion forward and backward, and the one that holds it without friction: (3, times);
    NaN where no effort starts it."""
    names: list[Named] = [f"{drive}.{attribute}" for attribute in BREAKAWAY]
    return np.asarray(compiled.evaluate([*names, HoldingEffort(drive)], t))


def resting_stretches(run: Run, drive: str) -> list[tuple[float, float]]:
    """The stretches of time (s) at whose poses the mechanism stays at rest with a drive released, though loads would
    move it without friction."""

    def every(t: Array) -> Array:
        return efforts(run.compiled, drive, t)

    edges = between_changes(run, lambda t: np.nan_to_num(every(t)), 3)
    forward, backward, holding = every((edges[:-1] + edges[1:]) / 2)
    largest = np.nanmax(np.abs(every(np.linspace(run.start, run.stop, run.grid + 1))), initial=0.0)
    return stretches(edges, (forward >= 0) & (backward <= 0) & (np.abs(holding) > CLEAR * largest))


def unstarted(compiled: Compiled, drive: str, t: Array) -> dict[str, Array]:
    """Of the times those at whose poses no effort starts the motion, by sense."""
    every = efforts(compiled, drive, t)
    return {sense: t[np.isnan(row)] for sense, row in zip(("forward", "backward"), every, strict=False)}


def creeping(compiled: Compiled, drive: str, sense: int) -> Compiled:
    """The mechanism with its static coefficients as those of motion, at the poses of its run, where a drive creeps."""
    m = compiled.mechanism
    sections = {one.section for one in m.acting() if one.at_start.entry is not one.entry}
    changed = {
        section: FrozenDict(
            {
                name: next((o.at_start.entry for o in m.acting() if o.path == (section, name)), entry)
                for name, entry in getattr(m, section).items()
            }
        )
        for section in sections
    }
    other, quantities = copy(compiled), copy(compiled.quantities)
    quantities.mechanism = m.model_copy(update=changed)
    quantities.signals = Signals(quantities.mechanism)
    structure = Structure(Topology(quantities.mechanism), compiled.structure.steps)
    other.mechanism, other.quantities, other.structure = quantities.mechanism, quantities, structure
    other._kernels, other._nodes, other._kept = {}, {}, {}
    other.__post_init__()

    parameters = dict(zip(other.graph.parameters, other.parameters, strict=True))

    def crept(x: Array) -> Array:
        x = x.copy()
        for row, value in creeping_rates(other.graph, drive, sense, lambda i: x[i]).items():
            x[row] = value
        # Tables whose arguments follow the motion answer for these rates.
        other.supply.look_up(x, lambda kernel: kernel.run(x, other.parameters), parameters)
        return x

    other.adjusted = crept
    return other
