"""All assembly modes of a mechanism at a pose of its drives, and the circuits on which they lie."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import field, replace

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.circuits import CircuitCurve, Tracer
from linkwright.graph.constraints import Constraints, FollowerRelation
from linkwright.graph.geometry import ZERO
from linkwright.graph.modes import Explorer, FoundModes, Mode
from linkwright.model.quantities import Quantities
from linkwright.notation import Body, Pair
from linkwright.structure import FRAME, Structure

Array = NDArray[np.float64]

BUDGET = 6000
"""Steps along circuits in all, some seconds: no further one is begun after these."""
SAME = 1e-5
"""Poses nearer than this (rad, or lengths over the size) are one mode."""


@dataclass(frozen=True)
class Circuit:
    """Poses that are reached from each other by moving the mechanism.

    ``ranges`` are the values (rad or m) that the drive can have, branch by branch: from dead point to dead point, or
    all that the circuit has where there is none. ``closed`` where the curve comes back to its beginning, ``turns``
    where the drive goes round on it; ``crossings`` are values at which another curve crosses (change points).
    """

    closed: bool
    turns: bool
    ranges: tuple[tuple[float, float], ...]
    crossings: tuple[float, ...]


@dataclass
class Survey:
    """The modes, and on which circuit and branch (their numbers from 0) each lies.

    ``places[i]`` is ``None`` where there is no circuit to tell: several drives and none named, or a pose in which
    curves cross.
    """

    found: FoundModes
    drive: str | None = None
    circuits: list[Circuit] = field(default_factory=list)
    places: list[tuple[int, int] | None] = field(default_factory=list)
    untold: bool = False  # the circuits of some modes weren't followed: there are too many

    @property
    def modes(self) -> list[Mode]:
        """The assembly modes."""
        return self.found.modes

    @property
    def complete(self) -> bool:
        """Whether no mode can be missing."""
        return self.found.complete

    def on(self, circuit: int, branch: int | None = None) -> list[int]:
        """The modes on a circuit, or on one branch of it."""
        return [i for i, p in enumerate(self.places) if p and p[0] == circuit and branch in (None, p[1])]


def survey(
    quantities: Quantities,
    structure: Structure,
    values: Mapping[str, float],
    drive: str | None = None,
    relations: Mapping[str, FollowerRelation] | None = None,
) -> Survey:
    """All modes at the drives' ``values`` (rad or m), and their circuits as ``drive`` moves and the others are held.

    The followers among the drives move with their motors, by their ``relations``. Where there is one drive only beside
    them, it needn't be named. A mode that a circuit passes and that the search missed is added.
    """
    relations = relations or {}
    explorer = Explorer(quantities, structure, values)
    found = explorer.run()
    motors = [name for name in values if name not in relations]
    drive = drive or (motors[0] if len(motors) == 1 else None)
    result = Survey(found, drive, places=[None] * len(found.modes))
    if drive is None:
        _untold(found)
        return result
    system = Constraints(structure.topology, explorer.geometry, explorer.size)
    followed = {name: relation for name, relation in relations.items() if relation.motor == drive}
    system.set_drive_values(
        {name: value for name, value in values.items() if name != drive and name not in followed}, followed
    )
    tracer = Tracer(system, drive)
    i = 0
    steps = 0
    while i < len(found.modes):
        if steps > min(BUDGET, tracer.patience):
            result.untold = True
            break
        if result.places[i] is None and (curve := tracer.follow(system.pose(dict(found.modes[i].bodies)))) is not None:
            result.places[i] = (len(result.circuits), 0)
            for pose, branch in curve.meets:
                _note(result, explorer, system, pose, branch)
            steps += len(curve.poses)
            result.circuits.append(_circuit(curve, tracer))
        i += 1
    _untold(found)
    return result


def _untold(found: FoundModes) -> None:
    """Take away the lines of modes that the same lines state: their points are in the same places."""
    told = Counter(mode.lines for mode in found.modes)
    found.modes = [mode if told[mode.lines] == 1 else replace(mode, lines=()) for mode in found.modes]


def _note(result: Survey, explorer: Explorer, system: Constraints, pose: Array, branch: int) -> None:
    """Say of the mode with this pose that it lies on the circuit being followed."""
    for j, mode in enumerate(result.modes):
        if np.abs(system.pose_difference(pose, system.pose(dict(mode.bodies)))).max() < SAME:
            result.places[j] = result.places[j] or (len(result.circuits), branch)
            return
    mode_there = None if system.opposed(pose) else explorer.near(_bodies(system, pose))
    if mode_there is not None:
        result.modes.append(mode_there)
        result.places.append((len(result.circuits), branch))


def _circuit(curve: CircuitCurve, tracer: Tracer) -> Circuit:
    turns = tracer.turns and curve.closed and not curve.dead and abs(curve.values[-1] - curve.values[0]) > 1.0
    return Circuit(curve.closed, turns, tuple(curve.ranges), tuple(curve.crossings))


def _bodies(system: Constraints, pose: Array) -> dict[str, Body]:
    bodies = {FRAME: Body.fixed(0)}
    for link, (x, y, angle) in zip(system.links, pose.reshape(-1, 3), strict=True):
        bodies[link] = Body.still(Pair(x * system.size, y * system.size), ZERO, Pair(np.cos(angle), np.sin(angle)))
    return bodies
