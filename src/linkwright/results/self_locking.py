"""Where a mechanism locks itself: loads would drive it, but friction holds it, so that the drive has to push.

A drive holds back where its power without any friction is negative. If loads, springs and gravity supply power there,
and the drive's power with friction is positive, its effort has changed its sign by friction: released, it would
stop (a block on a slope whose tangent is below the coefficient: Beer, Johnston, Vector Mechanics for Engineers:
Statics, ch. 8).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.force_rows import FrictionlessEffort
from linkwright.graph.power_rows import ElementPower
from linkwright.graph.rows import Named
from linkwright.results.run import Run
from linkwright.results.sign_intervals import CLEAR, between_changes, stretches

Array = NDArray[np.float64]

LITTLE = 0.01
"""Loads that never supply more than this share of the largest power that they exchange drive nothing."""
LOOKS = 16
"""At so many places within a stretch the power of the loads is looked at."""


def locked_stretches(run: Run, drive: str) -> list[tuple[float, float]]:
    """The stretches of time (s) in which a drive pushes though without friction it would hold back the loads."""
    prescribed = run.compiled.mechanism.drives[drive]
    acting = [one for one in run.compiled.graph.actions.every if one.kind.acts and not one.kind.resists]
    named: list[Named] = [f"{drive}.{prescribed.effort}", FrictionlessEffort(drive), f"{drive}.{prescribed.rate}"]
    named += [ElementPower(*one.path) for one in acting]

    def powers(t: Array) -> Array:
        """Of the drive with and without friction, and of the loads, springs and gravity (W): (3, times)."""
        effort, alone, rate, *loads = run.compiled.evaluate(named, t)
        falling = -run.compiled.rates(["energy.potential"], t)[1][0]
        return np.stack([effort * rate, alone * rate, sum(loads, falling)])

    edges = between_changes(run, powers, 3)
    clear = CLEAR * np.nanmax(np.abs(powers(np.linspace(run.start, run.stop, run.grid + 1))), axis=1, initial=0.0)
    given, alone, loads = powers((edges[:-1] + edges[1:]) / 2)
    found = stretches(edges, (given > clear[0]) & (alone < -clear[1]) & (loads > clear[2]))
    most = LITTLE / CLEAR * clear[2]
    return [(a, b) for a, b in found if powers(np.linspace(a, b, LOOKS + 1)[1:-1])[2].max() > most]
