"""A sheet: one assembly mode of a mechanism over the plane of its two drives' values.

All determinants are named: ``jacobian`` is d(x, y)/d(drives) of the working point (zero: it can't move in some
direction, a limit position of the output); the closures' determinants are those of the groups (zero: the drives don't
hold the mechanism, an uncertain position; the two modes of a group meet there). Where a closure's vanishes the
jacobian's grows without bound; their product ``numerator`` is finite all over the sheet, and vanishes with the
jacobian's (Gosselin and Angeles, IEEE Trans. Robotics and Automation 6 (1990) 281-290: both kinds of singularity).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.rows import Determinant, Named, reaches, spans
from linkwright.kernels import KERNELS, Compiled
from linkwright.kernels.registry import Kernel

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class SheetPlaces:
    """A sheet at some places (n,): NaN where the mechanism can't be assembled.

    ``at`` (2, n) is the working point (m), ``jacobian`` (2, 2, n) its derivatives by the drives, ``reach`` the least
    of all groups' reaches (negative where one can't close), ``closure`` the product of their determinants.
    """

    at: Array
    jacobian: Array
    reach: Array
    closure: Array

    @property
    def determinant(self) -> Array:
        """Of the jacobian: (n,)."""
        j = self.jacobian
        with np.errstate(invalid="ignore"):
            return np.asarray(j[0, 0] * j[1, 1] - j[0, 1] * j[1, 0])

    @property
    def numerator(self) -> Array:
        """The jacobian's determinant times the closures': (n,)."""
        return self.determinant * self.closure


class ModeSheet:
    """The working point of one mode: ``branches`` gives each group with two modes its sign, ``parameters``
    (parameters,) are those of the mechanism (SI). The third and further drives don't exist: there are two."""

    def __init__(
        self,
        compiled: Compiled,
        point: str,
        drives: tuple[str, str],
        branches: Sequence[float],
        parameters: Array | None = None,
        kernel: str = "numpy",
    ) -> None:
        self.compiled, self.point, self.drives, self.branches = compiled, point, drives, tuple(branches)
        self.parameters = compiled.parameters if parameters is None else parameters
        graph, structure = compiled.graph, compiled.structure
        self._closed, apart = reaches(structure), spans(structure)
        self._rows: list[Named] = [f"{point}.{name}" for name in ("x", "y", "vx", "vy")]
        self._rows += [*self._closed, *(Determinant(group.label) for group in graph.branched), *apart]
        self._scale = graph.size ** len(apart)
        self._inputs = [graph.drives.index(drive) * graph.width for drive in drives]
        self._engines: dict[bool, Kernel] = {}
        self.kernel = kernel

    def _engine(self, whole: bool) -> Kernel:
        if whole not in self._engines:
            program = self.compiled.graph.program(self._rows if whole else [*self._rows[:2], *self._closed])
            self._engines[whole] = KERNELS[self.kernel](program)
        return self._engines[whole]

    def make_programs(self) -> None:
        """Make the programs, which all sheets of a mechanism share."""
        for whole in (False, True):
            self._engine(whole)

    def inputs(self, q: Array) -> Array:
        """The program's inputs at drive values ``q`` (2, n), at rest: (inputs, n)."""
        graph = self.compiled.graph
        x = np.zeros((len(graph.inputs), q.shape[1]))
        x[self._inputs] = q
        first = len(graph.drives) * graph.width
        x[first : graph.first_unknown] = np.array(self.branches)[:, None]
        return x

    def look(self, q: Array) -> SheetPlaces:
        """Everything at drive values ``q`` (2, n) in rad or m."""
        n, count = q.shape[1], len(self._closed)
        x = self.inputs(np.concatenate([q, q], axis=1))  # one call for both columns of the jacobian
        first, second = self._inputs
        x[first + 1, :n] = x[second + 1, n:] = 1.0
        with np.errstate(all="ignore"):
            y = self._engine(True).run(x, self.parameters)
        jacobian = np.stack([y[2:4, :n], y[2:4, n:]], axis=1)
        y = y[:, :n]
        closure = np.nan_to_num(np.prod(y[4 + count :], axis=0) / self._scale)  # 0/0 where the pins of a slide meet
        return SheetPlaces(y[:2], jacobian, _least(y[4 : 4 + count], q), closure)

    def place(self, q: Array) -> tuple[Array, Array]:
        """The working point alone, (2, n), and the least reach, (n,)."""
        with np.errstate(all="ignore"):
            y = self._engine(False).run(self.inputs(q), self.parameters)
        return y[:2], _least(y[2:], q)


def _least(reach: Array, q: Array) -> Array:
    """The least of all reaches; where an earlier group doesn't close, the later ones have none."""
    if not len(reach):
        return np.ones(q.shape[1])
    return np.asarray(np.fmin.reduce(np.where(np.isnan(reach), -1.0, reach)))
