"""The platforms of all triads of a mechanism turned round: the poses that they have at places, and over cells."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.enclosures.forms import AffineForm
from linkwright.graph.inverse import Inverse
from linkwright.notation.harmonics import MOST
from linkwright.studies.workspace.platform import OnePlatform

Array = NDArray[np.float64]
Rows = NDArray[np.intp]


class Platforms:
    """The platforms of a mechanism turned round with some parameters; without triads there are none."""

    def __init__(self, inverse: Inverse, parameters: Array) -> None:
        self._each = [OnePlatform(one, parameters) for one in inverse.platforms]
        self.most = MOST ** len(self._each)
        """So many poses there are at most of each choice of branches."""

    def poses_at(self, x: Array) -> tuple[Array, Array]:
        """The program's inputs (inputs, n) with the platforms' poses, (inputs, most, n), NaN where there is none; and
        the rooms of each, (triads, most, n)."""
        n = x.shape[1]
        rooms = np.empty((0, n))
        for one in self._each:
            pose, room = one.poses(x)
            x = np.concatenate([np.repeat(x, MOST, axis=1), pose])
            rooms = np.concatenate([np.repeat(rooms, MOST, axis=1), room])
        shape = n, self.most
        return x.reshape(len(x), *shape).swapaxes(1, 2), rooms.reshape(len(rooms), *shape).swapaxes(1, 2)

    def over(self, x: list[AffineForm]) -> Sets:
        """Sets of poses over cells, from the program's inputs, arrays (n,); they hold all there are."""
        found = Sets(x, [], np.arange(x[0].value.size), np.arange(x[0].value.size))
        for one in self._each:
            which, number, pose, room = one.sets(found.x)
            x, rooms = ([form.select(which) for form in part] for part in (found.x, found.rooms))
            number = np.unique([found.number[which], number], axis=1, return_inverse=True)[1].ravel()
            found = Sets([*x, *pose], [*rooms, room], found.of[which], number)
        return found


@dataclass(frozen=True)
class Sets:
    """Sets of poses in pieces: the program's inputs ``x`` over each, forms (n,), the ``rooms`` of its set, forms (n,)
    by triads, ``of`` which cell it is, and the ``number`` of its set."""

    x: list[AffineForm]
    rooms: list[AffineForm]
    of: Rows
    number: Rows
