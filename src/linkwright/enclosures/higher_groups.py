"""The coordinates of a group that Newton solves, enclosed by Krawczyk's test around a polynomial.

The polynomial p goes through solutions at places of the panel. With Y the inverse of the closures' slopes in the
middle, F what the closures miss, and S the slopes over all of p + [-d, d]: where |Y F(p)| + |1 - Y S| d < d holds,
just one solution lies in that box at every time of the panel. Moore, Kearfott, Cloud (2009), ch. 8.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.enclosures.bounds import UP
from linkwright.enclosures.panels import Panels
from linkwright.enclosures.program import Stage, taylor
from linkwright.enclosures.taylor import TINY, UNITS, ZERO, TaylorModel
from linkwright.kernels import Compiled
from linkwright.structure import HigherGroup

Array = NDArray[np.float64]
Rows = Callable[[int], TaylorModel]

WIDER = 2.0
"""The box over what the closures miss."""
REFINED = 2
"""Newton steps of the whole polynomial, where it is to have more digits than the solutions."""


class EnclosedGroup:
    """A higher group's coordinates over panels."""

    def __init__(self, compiled: Compiled, higher_group: HigherGroup, dtype: Any = np.float64) -> None:
        self.compiled, self.rows = compiled, compiled.graph.coordinates(higher_group)
        self.n = len(self.rows)
        closure = compiled.graph.newton(higher_group).closure
        self.gaps = Stage(closure, compiled.parameters, range(self.n), taylor(dtype=dtype))
        self.slopes = Stage(closure, compiled.parameters, range(self.n, self.n + self.n**2), taylor(dtype=dtype))

    def __call__(self, x: Rows, on: Panels) -> dict[int, TaylorModel]:
        """The coordinates by their rows, from the inputs that stand already."""
        n, count = self.n, on.count
        nodes = np.cos(np.pi * (np.arange(on.order + 1) + 0.5) / (on.order + 1))
        times = on.mid + on.half * nodes[:, None]
        given = self.compiled.inputs(times.ravel().astype(float), actions=False)[self.rows]
        through = np.linalg.inv(np.vander(nodes, increasing=True))
        none = np.zeros(count)
        paths = [TaylorModel((through @ one).astype(on.dtype), none, on) for one in given.reshape(n, len(nodes), count)]
        slopes = self._matrix(self.slopes(self._with(x, paths)), count)
        middle = np.array([[one.c[0] for one in row] for row in slopes], dtype=float).transpose(2, 0, 1)
        inverse = _inverse(middle).transpose(1, 2, 0)

        def missed() -> list[TaylorModel]:
            gaps = [[gap] for gap in self.gaps(self._with(x, paths))]
            return self._turned(inverse, gaps, on)[0]

        for _ in range(REFINED if on.precise else 0):
            paths = [TaylorModel((path - off).c, none, on) for path, off in zip(paths, missed(), strict=True)]
        off = np.array([one.magnitude_bound for one in missed()])
        unit = UNITS[np.dtype(on.dtype).char]
        box = WIDER * off * UP + 4 * unit * np.array([path.size for path in paths])
        wide = [TaylorModel(path.c, reach, on) for path, reach in zip(paths, box, strict=True)]
        slopes = self._matrix(self.slopes(self._with(x, wide)), count)
        most = np.zeros((n, count), dtype=on.dtype)
        for j, column in enumerate(self._turned(inverse, slopes, on)):
            for i, one in enumerate(column):
                most[i] += (one - 1.0 if i == j else one).magnitude_bound * box[j]
        reach = (off + most) * UP + TINY
        proven = np.all(reach < box, axis=0)
        return {
            row: TaylorModel(path.c, np.where(proven, r, np.nan), on)
            for row, path, r in zip(self.rows, paths, reach, strict=True)
        }

    def _with(self, x: Rows, paths: list[TaylorModel]) -> Rows:
        own = dict(zip(self.rows, paths, strict=True))
        return lambda row: own[row] if row in own else x(row)

    def _matrix(self, flat: list[TaylorModel], count: int) -> list[list[TaylorModel]]:
        n = self.n
        whole = [TaylorModel(np.broadcast_to(m.c, (len(m.c), count)), np.broadcast_to(m.r, count), m.on) for m in flat]
        return [whole[i * n : (i + 1) * n] for i in range(n)]

    def _turned(self, inverse: Array, of: list[list[TaylorModel]], on: Panels) -> list[list[TaylorModel]]:
        """The columns of the inverse times a matrix."""
        found = []
        for j in range(len(of[0])):
            column = []
            for i in range(self.n):
                total: Any = ZERO
                for k in range(self.n):
                    total = total + TaylorModel(inverse[i, k][None], np.zeros(on.count), on) * of[k][j]
                column.append(total)
            found.append(column)
        return found


def _inverse(matrices: Array) -> Array:
    """Inverses, NaN of the singular ones."""
    finite = np.all(np.isfinite(matrices), axis=(1, 2))
    safe = np.where(finite[:, None, None], matrices, np.eye(matrices.shape[1]))
    try:
        found = np.linalg.inv(safe)
    except np.linalg.LinAlgError:
        found = np.full_like(safe, np.nan)
    return np.where(finite[:, None, None], found, np.nan)
