"""Which numbers change what is fixed where a mechanism is drawn, such as how two gears mesh.

Where it is drawn depends on sketched places, and for later groups on the pose of those before: no expression of the
numbers. Programs keep it as it is at the nominal ones, so it is asked by assembling anew with a number a little off,
both from the nominal numbers and from a place where all of them are off: at the nominal ones the first derivative to a
number may be zero by symmetry, as that of an offset beside a straight line.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from copy import copy

import numpy as np

from linkwright.graph.assembly import assemble
from linkwright.kernels.compiled import Compiled
from linkwright.model.quantities import Quantities
from linkwright.model.sampled import dependent, names_in

Constants = Mapping[str, tuple[float, ...]]

OFF = 1e-4
"""The share by which a number is off; of a zero, radians or metres over the mechanism's size."""
ELSEWHERE = 0.2, 0.02
"""The shares by which all numbers are off, at most, in the place that isn't the nominal one: the first that can be
assembled. A large one shows dependences of higher order, too."""
SAME = 1e-10
"""Constants over the mechanism's size that differ by no more are the same: far below what the least share gives."""
GOLDEN = (math.sqrt(5) - 1) / 2


class DrawnConstants:
    """What is fixed where a mechanism is drawn, at its nominal numbers and at a place with all of them off."""

    def __init__(self, compiled: Compiled) -> None:
        self.compiled, self.size = compiled, compiled.assembly.size()
        self.bases: list[tuple[Quantities, Constants]] = []
        nominal = compiled.quantities
        if nominal.phases:
            self.bases.append((nominal, nominal.phases))
            # Multiples of the golden ratio share no symmetry that the numbers could have.
            places = {name: k * GOLDEN % 1 - 0.5 for k, name in enumerate(self._free(nominal), 1)}
            for most in ELSEWHERE:
                other = _with(nominal, {name: self._off(nominal, name, most * place) for name, place in places.items()})
                if (constants := self._assembled(other)) is not None:
                    self.bases.append((other, constants))
                    break

    def joint_that_asks(self, name: str) -> str | None:
        """The first joint whose constants depend on a number; ``None`` where none does."""
        for base, constants in self.bases:
            for share in (OFF, -OFF):
                there = self._assembled(_with(base, {name: self._off(base, name, share)}))
                for joint, before in constants.items():
                    if there is not None and not self._same(there.get(joint, ()), before):
                        return joint
        return None

    def _same(self, after: tuple[float, ...], before: tuple[float, ...]) -> bool:
        tolerance = SAME * max(self.size, 1.0)
        return len(after) == len(before) and bool(np.allclose(after, before, rtol=0.0, atol=tolerance))

    def _off(self, base: Quantities, name: str, share: float) -> float:
        value = base.parameters[name]
        return value + share * (abs(value) or min(self.size, 1.0))

    def _assembled(self, moved: Quantities) -> Constants | None:
        """The constants of other numbers; ``None`` where they can't be assembled."""
        starts = {}
        for drive, law in self.compiled.laws.items():
            at = law.at(np.zeros(1), moved.parameters)
            starts[drive] = float(np.asarray(at.d[0]).flat[0])
        failed = assemble(moved, self.compiled.structure, starts).findings
        return None if failed else moved.phases

    @staticmethod
    def _free(nominal: Quantities) -> list[str]:
        """The numbers that follow from no others."""
        written = nominal.mechanism.parameters
        return [name for name in nominal.order if not names_in(written[name].value.node) & set(nominal.order)]


def _with(base: Quantities, values: Mapping[str, float]) -> Quantities:
    """The numbers with other values of some, and all that follow from these."""
    moved = copy(base)
    moved.parameters, moved.phases = {**base.parameters, **values}, {}
    following = dependent(base, frozenset(values)) - set(values)
    for name in base.order:
        if name in following:
            expression = base.mechanism.parameters[name].value
            moved.parameters[name] = moved.value(expression, base.dimensions.of(name))
            if not math.isfinite(moved.parameters[name]):
                moved.parameters[name] = base.parameters[name]
    return moved
