"""Which numbers change what is fixed where a mechanism is drawn, such as how two gears mesh.

Where it is drawn depends on sketched places, and for later groups on the pose of those before: no expression of the
numbers. Programs keep it as it is at the nominal ones, so it is asked by assembling anew with a number a little off,
both from the nominal numbers and from a place where all of them are off: at the nominal ones the first derivative to a
number may be zero by symmetry, as that of an offset beside a straight line.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
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

    def joints_that_ask(self, names: Iterable[str]) -> dict[str, str]:
        """Of some numbers those on which constants depend, each with the first joint whose constants do."""
        rest, found = [*names], dict[str, str]()
        for base, constants in self.bases:
            for share in (OFF, -OFF):
                found |= self._asking(rest, base, constants, share)
                rest = [name for name in rest if name not in found]
        return found

    def _asking(
        self, names: list[str], base: Quantities, constants: Constants, share: float, sure: bool = False
    ) -> dict[str, str]:
        """The same of one place: numbers that change nothing together, each by a share of its own, change nothing
        alone; others are halved. ``sure``: it is known that some of them change something."""
        if not names:
            return {}
        if len(names) == 1 or not sure:
            shares = [share] if len(names) == 1 else [share * (0.5 + k * GOLDEN % 1) for k in range(len(names))]
            off = {name: self._off(base, name, own) for name, own in zip(names, shares, strict=True)}
            there = self._assembled(_with(base, off))
            if there is None and len(names) == 1:
                return {}
            changed = [j for j, c in constants.items() if there is None or not self._same(there.get(j, ()), c)]
            if not changed or len(names) == 1:
                return dict.fromkeys(names, changed[0]) if changed else {}
            sure = there is not None
        half = len(names) // 2
        found = self._asking(names[:half], base, constants, share)
        return found | self._asking(names[half:], base, constants, share, sure and not found)

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
