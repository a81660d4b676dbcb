"""Where a link is, at the samples of its motion."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.report.data import LinkData

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Poses:
    """Placements of a link's axes over the samples, as rows: origin (``x``, ``y``), unit vector (``c``, ``s``) of its x
    axis. NaN where it can't be assembled."""

    x: Array
    y: Array
    c: Array
    s: Array

    @classmethod
    def of(cls, link: LinkData, count: int) -> Poses:
        """Those of a link over so many samples; a row of one never changes, an empty one has none."""
        pose = link["pose"]
        rows = (pose["x"], pose["y"], pose["c"], pose["s"])
        return cls(*(np.broadcast_to(np.array(row or [np.nan], float), (count,)) for row in rows))

    @property
    def known(self) -> NDArray[np.bool_]:
        """Where there is one."""
        return np.isfinite(self.x + self.y + self.c + self.s)

    def places(self, local: Sequence[Sequence[float]] | Array) -> Array:
        """The places in the world of some places in the link's axes: samples, places, [x, y]."""
        u, v = np.array(local, float).reshape(-1, 2).T[:, None]
        x, y, c, s = (row[:, None] for row in (self.x, self.y, self.c, self.s))
        return np.stack([x + c * u - s * v, y + s * u + c * v], axis=-1)

    def at(self, k: int, local: Sequence[Sequence[float]] | Array) -> Array:
        """The same at one sample: places, [x, y]."""
        found: Array = Poses(*(row[k : k + 1] for row in (self.x, self.y, self.c, self.s))).places(local)[0]
        return found

    def turn(self, k: int) -> float:
        """The angle of the link's x axis at a sample."""
        return float(np.arctan2(self.s[k], self.c[k]))
