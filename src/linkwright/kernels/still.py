"""A mechanism without drives compiled at the one pose at which it stands."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.constraints import Constraints
from linkwright.graph.rows import Named
from linkwright.graph.shared_statics import SharedStatics
from linkwright.graph.statics import Statics
from linkwright.graph.still import StillGraph
from linkwright.kernels.compiled import Compiled
from linkwright.kernels.external_inputs import Supply
from linkwright.kernels.registry import KERNELS
from linkwright.structure import FRAME

Array = NDArray[np.float64]


@dataclass
class Still(Compiled):
    """A structure at its pose ``z``, on whose constraints its reactions rest."""

    system: Constraints | None = None
    z: Array = field(default_factory=lambda: np.empty(0))

    def __post_init__(self) -> None:
        assert self.system is not None
        rows = self.z.reshape(-1, 3) * [self.system.size, self.system.size, 1.0]
        pose = dict(zip(self.system.links, rows, strict=True))
        self.graph = self.standing = StillGraph(self.quantities, self.structure, pose=pose)
        self.parameters = np.array([self.quantities.parameters[name] for name in self.graph.parameters])
        self.assembly.start = self.standing.motion()
        self._supplied()

    def _supplied(self) -> None:
        """Nothing moves; only tables and the time are inputs."""
        self.followers = []
        self.supply = Supply(self.graph, self.tables, self.kernel)

    def statics(self, time: float) -> Statics:
        """The equilibrium under what is applied at a time (s)."""
        assert self.system is not None
        program, t = self.standing.applied(), np.array([time])
        rows = KERNELS["numpy"](program).run(self.inputs(t), self.parameters)[:, 0].reshape(-1, 3)
        rigid = Statics(self.system, self.z, dict(zip((FRAME, *self.system.links), rows, strict=True)))
        # Forces that follow from the size of others aren't linear in them: these are left as statics has them.
        linear = rigid.multipliers.size == len(self.system.rows)
        if not (self.mechanism.stiffness and linear and rigid.stresses.shape[1]):
            return rigid
        return SharedStatics(rigid, self.quantities.signals)

    def possible_rows(self, names: Sequence[Named], t: Array, rates: bool = False) -> Array:
        """The named rows at times ``t`` (s); NaN are those that depend on reactions, which :meth:`statics` gives."""
        still = [name for name in names if not self.standing.of_reactions(name)]
        y = np.full((len(names), 2 if rates else 1, t.size), np.nan)
        if still:
            known = super().possible_rows(still, t, rates)
            y[[name in still for name in names]] = known.reshape(len(still), -1, t.size)
        return y if rates else y[:, 0]
