"""The working point's errors by the deviations of what has a tolerance and by clearances, over the drives' values.

At given drive values F(q, p) is the working point, and c_i = dF/dp_i, of contributor i, its error of first order
(superposition: Peng and Zi, Journal of Mechanical Transmission 34(4), 2010, eq. 8, 9). So are the derivatives by the
displacements of a joint with clearance.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.expressions import units as u
from linkwright.graph.rows import Named, reaches
from linkwright.graph.tangent import jacobian
from linkwright.kernels import KERNELS
from linkwright.kernels.kernel_selection import choose
from linkwright.kernels.registry import Kernel
from linkwright.structure import Group
from linkwright.studies.workspace.causes import Causes
from linkwright.studies.workspace.maps import Maps, mapped
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]

STEPS = 200
KINDS = {f"error {what}": u.LENGTH for what in ("x least", "x most", "y least", "y most", "worst")} | {
    f"spread {what}": u.LENGTH for what in ("x", "y", "worst")
}


POSES: dict[str, Callable[[Group], tuple[str, str]]] = {
    "RRR": lambda group: (f"{group.ends[0]}.angle", f"{group.ends[1]}.angle"),
    "RPR": lambda group: (f"{group.ends[0]}.angle", f"{group.inner.joint}.s"),
}
"""What tells the pose of a dyad with two outer pins, which may meet."""


class Errors:
    """The errors of the working point by what causes them, at given drive values."""

    def __init__(self, sheet: ModeSheet, causes: Causes, count: int) -> None:
        self.sheet, self.causes = sheet, causes
        self.graph = sheet.compiled.graph
        groups = sheet.compiled.structure.groups
        closed = reaches(sheet.compiled.structure)
        poses = [row for group in groups if group.signature in POSES for row in POSES[group.signature](group)]
        self.reaches, self.poses = slice(2, 2 + len(closed)), slice(2 + len(closed), None)
        self.names: list[Named] = [f"{sheet.point}.x", f"{sheet.point}.y", *closed, *poses]
        directions = causes.contributors.directions
        moving = np.flatnonzero(directions.any(axis=1))
        self.directions = directions[moving]
        self.by = [*(self.graph.parameters[i] for i in moving), *causes.plays]
        self.closed = len(closed)
        program = jacobian(self.graph, self.names[:2], self.by, [*closed, *causes.places], causes.plays)
        self.engine = KERNELS[choose(program, count).kernel](program)

    @cached_property
    def _full_jacobian(self) -> Kernel:
        """What gives all derivatives, by the drives too; used at the few poses of curves."""
        width = self.graph.width
        drives = [self.graph.inputs[self.graph.drives.index(drive) * width] for drive in self.sheet.drives]
        causes = self.causes
        return KERNELS["numpy"](jacobian(self.graph, self.names, [*self.by, *drives], causes.places, causes.plays))

    def slopes(self, q: Array) -> tuple[Array, Array]:
        """Values (rows, n) of the point, of the ``reaches`` of groups with two modes, of the ``poses`` of those with
        two outer pins; their derivatives by the causes, and by the two drives after them: (rows, columns + 2, n)."""
        with np.errstate(all="ignore"):
            y = self._full_jacobian.run(self.sheet.inputs(q), self.sheet.parameters)
        rows, width = len(self.names), len(self.by) + 2
        last = rows * (1 + width)
        found = y[rows:last].reshape(rows, width, -1)
        return y[:rows], np.concatenate([self._along(found[:, :-2], y[last:]), found[:, -2:]], axis=1)

    def _along(self, slopes: Array, places: Array) -> Array:
        """Derivatives (rows, parameters and plays, n) as those by the causes, with what is at their places: (rows,
        columns, n)."""
        count = len(self.directions)
        own, plays = slopes[:, :count], slopes[:, count:]
        with np.errstate(all="ignore"):
            if not np.array_equal(self.directions, np.eye(count)):
                own = np.matmul(self.directions.T, own)
            return self.causes.columns(own, plays, places)

    def __call__(self, q: Array) -> dict[str, Array]:
        """The figures of the error maps at drive values (2, n): see :func:`errors`."""
        causes, last = self.causes, 2 + 2 * len(self.by)
        with np.errstate(all="ignore"):
            y = self.engine.run(self.sheet.inputs(q), self.sheet.parameters)
        covariance, closed = causes.covariance, last + self.closed
        slopes = self._along(y[2:last].reshape(2, len(self.by), -1), y[closed:])
        found = {"x": y[0], "y": y[1]}
        with np.errstate(all="ignore"):
            outside = ~(y[last:closed] > 0).all(axis=0)
            for name, slope in zip("xy", slopes, strict=True):
                found[f"error {name} least"] = -causes.most(-slope)
                found[f"error {name} most"] = causes.most(slope)
            found["error worst"] = causes.farthest(slopes)
            diagonal = np.diag(covariance)[:, None]
            apart = np.array_equal(covariance, np.diag(diagonal[:, 0]))
            spread = slopes * diagonal if apart else np.matmul(covariance, slopes)
            xx, xy, yy = ((slopes[a] * spread[b]).sum(axis=0) for a, b in ((0, 0), (0, 1), (1, 1)))
            found["spread x"], found["spread y"] = 3 * np.sqrt(xx), 3 * np.sqrt(yy)
            found["spread worst"] = 3 * np.sqrt((xx + yy) / 2 + np.hypot((xx - yy) / 2, xy))
        return {name: np.where(outside, np.nan, row) for name, row in found.items()}


def errors(sheet: ModeSheet, box: DriveBox, causes: Causes, steps: int = STEPS) -> Maps:
    """Maps of the working point's errors (m), of first order, on ``steps`` equal steps of each drive.

    Worst case: ``error x least`` and ``most`` are its limits along x, y likewise; ``error worst`` is the farthest that
    the point may be off. ``spread x``, ``y``: three standard deviations; ``spread worst`` those along the direction
    in which they are largest.
    """
    return mapped(sheet.compiled.quantities, box, steps, Errors(sheet, causes, (steps + 1) ** 2), KINDS)
