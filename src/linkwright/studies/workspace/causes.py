"""What puts the working point off at given drive values: deviations within limits, and clearances of joints."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.elements.clearance import Known, LooseJoint
from linkwright.graph.rows import Named
from linkwright.studies.accuracy.clearance_contacts import columns, named
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.workspace.farthest import farthest

Array = NDArray[np.float64]
Rows = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Causes:
    """The contributors with their deviations, and the joints ``held`` with clearance.

    To first order each has columns, derivatives by what it does: a contributor one, by its deviation within its limits;
    a joint those by its displacements (m) as :class:`LooseJoint` has them. Those of a pin are one vector of any
    direction and of a length up to the clearance; those of a guide, at its two ends, are free of each other, up to the
    clearance to either side, as that of a flank is.
    """

    contributors: Contributors
    held: tuple[LooseJoint, ...] = ()

    @property
    def names(self) -> list[str]:
        """Contributors, then joints, once each."""
        return [*self.contributors.names, *self.clearances]

    @property
    def clearances(self) -> Mapping[str, float]:
        """Of each joint its clearance (m)."""
        return {one.joint: one.clearance for one in self.held}

    @property
    def plays(self) -> list[str]:
        """The offsets of the joints by which the graph differentiates."""
        return [play for one in self.held for play in one.plays]

    @property
    def places(self) -> list[Named]:
        """The rows that :meth:`columns` needs."""
        return [named(place) for place in self._places]

    @property
    def _places(self) -> list[Known]:
        return [*dict.fromkeys(row for one in self.held for row in one.places)]

    def columns(self, by: Array, plays: Array, places: Array) -> Array:
        """Derivatives (rows, columns, n) from those by the contributors (rows, contributors, n) and by the ``plays``
        (rows, plays, n), with what is at the ``places`` (places, n)."""
        if not self.held:
            return by
        rows = dict(zip(self._places, places, strict=True))
        parts = [
            part
            for one, at in zip(self.held, columns(self.held), strict=True)
            for seat in one.gradients([plays[:, k] for k in at], rows)
            for part in seat
        ]
        return np.concatenate([by, np.stack(parts, axis=1)], axis=1)

    def _columns(self, round_: bool) -> list[list[int]]:
        """The columns of the joints of which each has one vector, or of the others."""
        every, first = zip(self.held, columns(self.held), strict=True), len(self.contributors)
        return [[first + k for k in at] for one, at in every if one.round is round_]

    @cached_property
    def _pairs(self) -> Rows:
        """Which two columns are one vector: (joints, 2)."""
        return np.array(self._columns(True), dtype=np.intp).reshape(-1, 2)

    @cached_property
    def _radii(self) -> Array:
        """The clearances of joints whose columns are one vector (m)."""
        return np.array([one.clearance for one in self.held if one.round])

    @cached_property
    def _limits(self) -> tuple[Rows, Array, Array]:
        """The columns that are each on its own, with the limits of what they are derivatives by."""
        ends = np.array([one.clearance for one in self.held if not one.round for _ in one.plays])
        own = [k for some in self._columns(False) for k in some]
        alone = np.array([*range(len(self.contributors)), *own], dtype=np.intp)
        return alone, np.concatenate([self.contributors.low, -ends]), np.concatenate([self.contributors.high, ends])

    def most(self, shifts: Array) -> Array:
        """The greatest that a figure may shift by all together, from its derivatives (columns, ...): what limits allow
        one way, and of each vector its clearance along them."""
        alone, *limits = self._limits
        first, second = self._pairs.T
        low, high, radii = (np.reshape(part, (-1, *[1] * (shifts.ndim - 1))) for part in (*limits, self._radii))
        whole = np.maximum(low * shifts[alone], high * shifts[alone]).sum(axis=0)
        return np.asarray(whole + (radii * np.hypot(shifts[first], shifts[second])).sum(axis=0))

    def farthest(self, slopes: Array) -> Array:
        """The greatest length of a vector's shift, from its derivatives (2, columns, n): (n,). With pins it may be
        overestimated a little (:func:`farthest`)."""
        alone, low, high = self._limits
        rounds = slopes[:, self._pairs] * self._radii[:, None, None]
        return farthest(slopes[:, alone], low[:, None], high[:, None], np.moveaxis(rounds, 1, 2))

    @cached_property
    def covariance(self) -> Array:
        """Of what the columns are derivatives by: (columns, columns). A joint is taken to lie on its clearance's
        border, a pin in all directions alike, an end of a guide on both sides; independent of all else."""
        count = len(self.contributors)
        own = [one.clearance**2 / (2 if one.round else 1) for one in self.held for _ in one.plays]
        made = np.diag(np.concatenate([np.zeros(count), own]))
        made[:count, :count] = self.contributors.covariance
        return made
