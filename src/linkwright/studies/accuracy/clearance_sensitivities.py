"""Derivatives by clearances, as :class:`Slopes` gives those by dimensions.

So all that follows from slopes (extremes at their places, means, windows that move) holds for clearances as well.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.elements.clearance import Known, LooseJoint, Rows
from linkwright.expressions.language import Node
from linkwright.notation import Jet
from linkwright.reductions import Local
from linkwright.results import Run
from linkwright.studies.accuracy.clearance_contacts import columns, named
from linkwright.studies.accuracy.signal_sensitivities import Slopes

Array = NDArray[np.float64]

UNSETTLED = 1e-9
"""A force below this share of its joint's RMS has no direction, as far as digits tell."""


class Gaps(Slopes):
    """Expressions of positions by displacements in joints, in their order: of a pin along x and y of the frame, of a
    guide across it at its two ends, of a flank along its normal. Displacements are held while a place in time is looked
    for."""

    def __init__(self, run: Run, held: Sequence[LooseJoint]) -> None:
        super().__init__(run, np.empty((run.compiled.parameters.size, 0)), [play for one in held for play in one.plays])
        self.held, self.columns = tuple(held), columns(held)
        self.rows = tuple(dict.fromkeys(row for one in held for row in one.rows))

    def needed_rows(self, t: Array) -> dict[Known, Jet]:
        """What the joints need to know of times, with rates."""
        values, rates = self.run.compiled.rates([named(row) for row in self.rows], t)
        return {name: Jet(pair) for name, *pair in zip(self.rows, values, rates, strict=True)}

    def at(self, trees: Sequence[Node], t: Array, rates: bool = True) -> Local:
        """Expressions bound to SI at times ``t`` (s), as those by deviations."""
        plays, rows = super().at(trees, t, rates), self.needed_rows(t)
        slope, twist = np.empty_like(plays.slope), np.empty_like(plays.twist)
        for one, at in zip(self.held, self.columns, strict=True):
            by = [Jet([plays.slope[:, k], plays.twist[:, k]]) for k in at]
            parts = [part for seat in one.gradients(by, rows) for part in seat]
            for k, part in zip(at, parts, strict=True):
                slope[:, k], twist[:, k] = part.d
        return Local(plays.value, plays.rate, slope, twist)

    def worst(self, slope: Array) -> Array:
        """The largest effect of each joint over all directions, from derivatives (..., displacements, times) by the
        displacements: (..., joints, times)."""
        rows = [
            one.clearance * one.size([slope[..., k, :] for k in at])
            for one, at in zip(self.held, self.columns, strict=True)
        ]
        return np.stack(rows, axis=-2)


class Resting(Slopes):
    """Expressions of positions with all joints resting where their reactions press them: a deviation of its own for
    each, ``loads`` being the RMS of their reactions (N), after that of all of them together."""

    def __init__(self, gaps: Gaps, loads: Sequence[float]) -> None:
        self.run, self.gaps, self.loads, self.tangents = gaps.run, gaps, loads, gaps.tangents
        self.count, self.given, self.joins = 1 + len(gaps.held), gaps.given, gaps.joins

    def at(self, trees: Sequence[Node], t: Array, rates: bool = True) -> Local:
        """Expressions bound to SI at times ``t`` (s), as those by deviations."""
        gaps, rows = self.gaps.at(trees, t, rates), self.gaps.needed_rows(t)
        slope, twist = (np.zeros((len(trees), self.count, t.size)) for _ in range(2))
        for i, (one, load) in enumerate(zip(self.gaps.held, self.loads, strict=True)):
            units = [part for seat in self.directions(one, load, rows) for part in seat]
            for k, unit in zip(self.gaps.columns[i], units, strict=True):
                by = Jet([gaps.slope[:, k], gaps.twist[:, k]]) * unit * one.clearance
                slope[:, i + 1] += by.d[0]
                twist[:, i + 1] += by.d[1] if rates else 0.0
        slope[:, 0], twist[:, 0] = slope[:, 1:].sum(axis=1), twist[:, 1:].sum(axis=1)
        return Local(gaps.value, gaps.rate, slope, twist)

    @staticmethod
    def directions(one: LooseJoint, load: float, rows: Rows) -> list[list[Jet]]:
        """Unit vectors of the forces at a joint's contacts; 0 where there is no force, but on one flank."""
        found = []
        for seat in one.forces(rows):
            if one.flank:
                still = np.zeros_like(seat[0].d[0])
                found.append([Jet([still + one.flank, still]) for _ in seat])
                continue
            square = sum((part * part for part in seat[1:]), seat[0] * seat[0])
            settled = (square.d[0] > (UNSETTLED * load) ** 2) & (load > 0)
            size = square.where(settled, Jet.constant(1.0, 1)).sqrt()
            found.append([(part / size).where(settled, Jet.constant(0.0, 1)) for part in seat])
        return found
