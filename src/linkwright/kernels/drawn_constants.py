"""Which numbers change what is fixed where a mechanism is drawn, such as how two gears mesh.

Where it is drawn depends on sketched places, and for later groups on the pose of those before: no expression of the
numbers. Programs keep it as it is at the nominal ones, so it is asked by assembling anew with a number a little off.
"""

from __future__ import annotations

import math
from copy import copy

import numpy as np

from linkwright.graph.assembly import assemble
from linkwright.kernels.compiled import Compiled
from linkwright.model.quantities import Quantities
from linkwright.model.sampled import dependent

OFF = 1e-4
"""The share by which a number is off; of a zero, radians or metres over the mechanism's size."""
SAME = 1e-10
"""Constants over the mechanism's size that differ by no more are the same: far below what the least share gives."""


def drawn_with(compiled: Compiled, name: str) -> str | None:
    """The first joint whose constants depend on a number; ``None`` where none does."""
    nominal, size = compiled.quantities.phases, compiled.assembly.size()
    if not nominal:
        return None
    value = compiled.quantities.parameters[name]
    for sign in (1.0, -1.0):
        moved = _with(compiled.quantities, name, value + sign * OFF * (abs(value) or min(size, 1.0)))
        starts = {}
        for drive, law in compiled.laws.items():
            at = law.at(np.zeros(1), moved.parameters)
            starts[drive] = float(np.asarray(at.d[0]).flat[0])
        if assemble(moved, compiled.structure, starts).findings:
            continue
        for joint, constants in nominal.items():
            there = moved.phases.get(joint, ())
            if len(there) != len(constants) or not np.allclose(there, constants, rtol=0.0, atol=SAME * max(size, 1.0)):
                return joint
    return None


def _with(nominal: Quantities, name: str, value: float) -> Quantities:
    """The numbers with another value of one, and all that follow from it."""
    moved = copy(nominal)
    moved.parameters, moved.phases = {**nominal.parameters, name: value}, {}
    for other in nominal.order:
        if other != name and other in dependent(nominal, frozenset([name])):
            expression = nominal.mechanism.parameters[other].value
            moved.parameters[other] = moved.value(expression, nominal.dimensions.of(other))
            if not math.isfinite(moved.parameters[other]):
                moved.parameters[other] = nominal.parameters[other]
    return moved
