"""The equilibrium of links whose joints share a load by their stiffness, as numbers at one pose.

Of all reactions in equilibrium those are taken that strain what yields least (:mod:`.load_sharing`): with the strains
E, each by the root of its compliance, over the actions, a particular solution r and the states of self-stress S, the
least squares of E (r + S y). States that strain nothing stay open.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.load_sharing import elastic
from linkwright.graph.statics import Statics
from linkwright.model.signals import Signals
from linkwright.notation import Body, Pair, Wrench

Array = NDArray[np.float64]

STRAINED = 1e-8
"""The least strain, over the largest one, of a state that stiffness determines."""


class SharedStatics(Statics):
    """An equilibrium with its load shared."""

    def __init__(self, rigid: Statics, signals: Signals) -> None:
        super().__init__(rigid.system, rigid.z, rigid.wrenches)
        self.rigid, self.signals = rigid, signals

    @cached_property
    def _strains(self) -> Array:
        """What yields, each by the root of its compliance: (components, actions)."""
        contacts = {(c.joint, c.link): c for c in self.signals.contacts}
        count = self.rigid.multipliers.size

        def reaction(joint: str, link: str) -> Wrench:
            parts = self.rigid.reaction(contacts[joint, link])
            return Wrench(Pair(parts["x"], parts["y"]), parts.get("moment", np.zeros(count)), Pair(0.0, 0.0))

        def body(link: str) -> Body:
            return self.system.bodies([link], self.z)[0]

        rows = [
            np.sqrt(float(of.compliance)) * np.asarray(row)
            for of in elastic(self.system.geometry, self.system.topology, body)
            for row in of.force(reaction)
        ]
        return np.array(rows).reshape(-1, count)

    @cached_property
    def _strained(self) -> tuple[Array, int]:
        """V^T of the strains in the states of self-stress, and how many combinations of these strain anything."""
        _, values, v = np.linalg.svd(self._strains @ self.rigid.stresses)
        return v, int(np.count_nonzero(values > STRAINED * values.max(initial=0.0)))

    @cached_property
    def stresses(self) -> Array:
        """Changes of the actions' factors that strain nothing: (actions, states)."""
        v, rank = self._strained
        return np.asarray(self.rigid.stresses @ v[rank:].T)

    @cached_property
    def multipliers(self) -> Array:
        """The factors of all that acts between links, (actions,), with the least strain."""
        v, rank = self._strained
        strained = self.rigid.stresses @ v[:rank].T
        share = np.linalg.lstsq(self._strains @ strained, self._strains @ self.rigid.multipliers, rcond=None)[0]
        return np.asarray(self.rigid.multipliers - strained @ share)

    @property
    def relative_residual(self) -> float:
        """The largest force left on a link (N, moments over the size), over the largest one there is."""
        left = self.rigid.actions.T @ self.multipliers + self.applied
        largest = max(np.abs(self.applied).max(initial=0.0), np.abs(self.multipliers).max(initial=0.0))
        return float(np.abs(left).max(initial=0.0) / largest) if largest else 0.0
