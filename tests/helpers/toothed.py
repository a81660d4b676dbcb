"""The oracle with forces of contact that aren't those of a constraint's slope: the teeth of gears, on either flank."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product

import numpy as np

from helpers.newton_euler import Array, Gap, Oracle, Reactions, State, cross
from helpers.plain import Plain

Contact = Callable[[Oracle, Array, int], tuple[str, str, Array, Array]]
"""Of coordinates and a flank (1, -1): both links, the direction of the force on the first, where it acts."""


class Toothed(Oracle):
    """Motion by ``gaps``, the forces of their joints by ``contacts``: pushes along lines of action, on the flank on
    which they do push."""

    def __init__(self, plain: Plain, gaps: Mapping[str, Gap], contacts: Mapping[str, Contact]) -> None:
        self.contacts, self.flanks = contacts, dict[str, int]()
        super().__init__(plain, gaps=gaps)

    def gap_slope(self, gap: Gap, q: Array) -> Array:
        """While forces are asked, what a push of 1 N does to the coordinates."""
        if not self.flanks:
            return super().gap_slope(gap, q)
        name = next(name for name, other in self.gaps.items() if other is gap)
        first, second, along, place = self.contacts[name](self, q, self.flanks[name])
        column = np.zeros(self.size)
        for link, sign in ((first, 1.0), (second, -1.0)):
            if link in self.index:
                i = self.index[link]
                column[i : i + 2] += sign * along
                column[i + 2] += sign * cross(place - q[i : i + 2], along)
        return column

    def forces(self, state: State) -> Reactions:
        """The forces with those flanks on which all contacts push."""
        found = []
        for flanks in product((1, -1), repeat=len(self.contacts)):
            self.flanks = dict(zip(self.contacts, flanks, strict=True))
            try:
                reactions = super().forces(state)
                pushes = []
                for name in self.contacts:
                    first, second, along, _ = self.contacts[name](self, state.q, self.flanks[name])
                    link, sign = (first, 1.0) if first in self.index else (second, -1.0)
                    pushes.append(sign * float(reactions.reactions[name, link][:2] @ along))
            finally:
                self.flanks = {}
            found.append((min(pushes), reactions))
        return max(found, key=lambda one: one[0])[1]
