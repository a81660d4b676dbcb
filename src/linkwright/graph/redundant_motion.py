"""Poses of a redundant mechanism along its motion: those at which all joints hold, and those that the equations give
which are kept."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from linkwright.findings import ModelError
from linkwright.graph.constraints import Constraints
from linkwright.graph.redundant_start import HOLDS
from linkwright.graph.spare_equations import Candidate, kept_rows

Array = NDArray[np.float64]
Values = Callable[[float], Mapping[str, float]]
"""The value of each drive and follower (rad or m) at a time (s)."""

POSES, TURN, SHIFT = 12, 0.6, 0.2
"""The poses looked at along the motion; how far the drives go on it (rad, or lengths over the size)."""
FULL_TURN_POSES, HALVINGS = 25, 3
"""The poses looked at along a full turn of a drive; how often the step between two is halved."""
LONGEST = 1e4
"""The longest time (s) in which drives are waited for to go as far as that."""


def followed(system: Constraints, z: Array, values: Values, reach: float) -> list[tuple[float, Array]]:
    """Poses along the motion at which all joints hold, with their times, by Gauss-Newton on all equations: these have
    full rank where the equations that are kept may not."""
    span = _span(system, values, 2 * math.pi) * reach
    times = np.linspace(0.0, span, FULL_TURN_POSES if reach == 1.0 else POSES)
    found = [(0.0, z)]
    for time in times[1:]:
        begun, (last, z) = len(found), found[-1]
        for halving in range(HALVINGS + 1):
            between = np.linspace(last, float(time), 2**halving + 1)[1:]
            pose: Array | None = z
            for t in between:
                pose = None if pose is None else _held(system, pose, float(t), values)
            if pose is not None:
                found.append((float(time), pose))
                break
        if len(found) == begun:
            break
    return found


def _held(system: Constraints, z: Array, time: float, values: Values) -> Array | None:
    """The pose nearby at which all joints hold at a time; ``None`` where Gauss-Newton doesn't shrink its steps."""
    try:
        system.set_drive_values(values(time))
    except ModelError:  # past the end of a table
        return None
    before = math.inf
    for _ in range(12):
        step = np.linalg.lstsq(system.jacobian(z), system.residual(z), rcond=1e-9)[0]
        size = float(np.abs(step).max(initial=0.0))
        if not size < min(0.6, max(0.4 * before, 1e-9)):
            return None
        z, before = z - step, size
        if size < 1e-13:
            break
    return z if float(np.abs(system.residual(z)).max(initial=0.0)) < HOLDS and not system.opposed(z) else None


# The motion from there.


def traced(system: Constraints, chosen: list[Candidate], z: Array, values: Values) -> list[tuple[float, Array]]:
    """Poses along the motion that the equations leave which are kept, with their times; fewer where it ends."""
    found: list[tuple[float, Array]] = []
    for time in np.linspace(0.0, _span(system, values), POSES):
        try:
            system.set_drive_values(values(float(time)))
        except ModelError:  # past the end of a table
            break
        closed = closed_pose(system, chosen, z)
        if closed is None:
            break
        z = closed
        found.append((float(time), z))
    return found


def closed_pose(system: Constraints, chosen: list[Candidate], z: Array) -> Array | None:
    """The pose nearby at which what is kept holds, by Newton; ``None`` where there is none."""
    for _ in range(25):
        kept = kept_rows(system, z, chosen)
        rest = kept @ system.residual(z)
        step = np.linalg.lstsq(kept @ system.jacobian(z), rest, rcond=1e-12)[0]
        if not np.abs(step).max(initial=0.0) < 0.5:
            return None
        z = z - step
        if np.abs(step).max(initial=0.0) < 1e-14:
            break
    return z if np.abs(kept_rows(system, z, chosen) @ system.residual(z)).max(initial=0.0) < 1e-12 else None


def _span(system: Constraints, values: Values, turn: float = TURN) -> float:
    """The time (s) in which some drive goes as far as is looked at, or as far as it goes at all."""
    start = values(0.0)
    units = {
        name: turn if system.topology.mechanism.prescribed(name).turns is not None else SHIFT * system.size
        for name in start
    }
    farthest, best, time = 0.0, 0.0, 1e-4
    while time < LONGEST:
        try:
            gone = max((abs(value - start[name]) / units[name] for name, value in values(time).items()), default=0.0)
        except ModelError:
            break
        if gone > 1.0:
            return time / max(gone, 1.0)
        if gone > farthest:
            farthest, best = gone, time
        time *= 1.3
    return best
