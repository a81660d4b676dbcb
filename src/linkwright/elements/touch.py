"""Where two links touch at one place and slide past each other: contacts of cams, pins in slots."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwright.notation import Body, Pair, Scalar

Array = NDArray[np.float64]


class Touch(NamedTuple):
    """A contact of a link on another: its ``place`` (m), and the unit ``normal`` from the other link to the first."""

    place: Pair
    normal: Pair

    @property
    def along(self) -> Pair:
        """The direction of sliding: the normal on its left."""
        return Pair(self.normal.y, -self.normal.x)

    def sliding(self, link: Body, other: Body) -> Scalar:
        """The speed (m/s) of the link's material along the other's at the contact."""
        along = self.along
        return link.velocity(self.place).dot(along) - other.velocity(self.place).dot(along)


class Reacting(NamedTuple):
    """Where a reaction acts: that of a link in a joint on another link, or on a pin."""

    joint: str
    link: str
    on: str


class ReportedTouch(NamedTuple):
    """The same from what a run reports: ``place`` and ``normal`` (2, times), and the normal ``force`` (N), of any
    sign."""

    place: Array
    normal: Array
    force: Array

    @property
    def along(self) -> Array:
        """The direction of sliding."""
        return np.array([self.normal[1], -self.normal[0]])
