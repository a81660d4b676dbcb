"""What a part of a workspace study draws over the picture of a workspace."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.findings import Text

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Overlay:
    """Lines of one look: its class ``kind``, at least one of ``lines`` (2, n) in m, the ``text`` of the legend."""

    kind: str
    lines: Sequence[Array]
    text: Text

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Least x, least y, largest x, largest y (m)."""
        every = np.concatenate(self.lines, axis=1)
        (x0, y0), (x1, y1) = every.min(axis=1), every.max(axis=1)
        return float(x0), float(y0), float(x1), float(y1)
