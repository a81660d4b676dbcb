"""The working point's errors by the deviations of what has a tolerance, over the drives' values.

At given drive values F(q, p) is the working point, and c_i = dF/dp_i, of contributor i, its error of first order
(superposition: Peng and Zi, Journal of Mechanical Transmission 34(4), 2010, eq. 8, 9).
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.tangent import jacobian
from linkwright.kernels import KERNELS
from linkwright.kernels.choice import choose
from linkwright.kernels.registry import Kernel
from linkwright.model import units as u
from linkwright.structure import Group
from linkwright.studies.accuracy.contributors import Contributors
from linkwright.studies.workspace.maps import Maps, mapped
from linkwright.studies.workspace.mesh import Box
from linkwright.studies.workspace.sheet import Sheet

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
    """The errors of the working point by the contributors' deviations, at given drive values."""

    def __init__(self, sheet: Sheet, contributors: Contributors, count: int) -> None:
        self.sheet, self.contributors = sheet, contributors
        self.graph = sheet.compiled.graph
        groups = sheet.compiled.structure.groups
        closed = [f"reach:{group.label}" for group in groups if group.modes > 1]
        poses = [row for group in groups if group.signature in POSES for row in POSES[group.signature](group)]
        self.reaches, self.poses = slice(2, 2 + len(closed)), slice(2 + len(closed), None)
        self.names = [f"{sheet.point}.x", f"{sheet.point}.y", *closed, *poses]
        moving = np.flatnonzero(contributors.directions.any(axis=1))
        self.directions = contributors.directions[moving]
        self.by = [self.graph.parameters[i] for i in moving]
        program = jacobian(self.graph, self.names[:2], self.by, closed)
        self.engine = KERNELS[choose(program, count, os.cpu_count() or 1).kernel](program)

    @cached_property
    def _whole(self) -> Kernel:
        """What gives all derivatives, by the drives too; used at the few poses of curves."""
        width = self.graph.width
        drives = [self.graph.inputs[self.graph.drives.index(drive) * width] for drive in self.sheet.drives]
        return KERNELS["numpy"](jacobian(self.graph, self.names, [*self.by, *drives]))

    def slopes(self, q: Array) -> tuple[Array, Array]:
        """Values (rows, n) of the point, of the ``reaches`` of groups with two modes, of the ``poses`` of those with
        two outer pins; their derivatives by the contributors, and by the two drives after them: (rows, contributors +
        2, n)."""
        with np.errstate(all="ignore"):
            y = self._whole.run(self.sheet.inputs(q), self.sheet.parameters)
        rows = len(self.names)
        found = y[rows:].reshape(rows, -1, q.shape[1])
        return y[:rows], np.concatenate([self._along(found[:, :-2]), found[:, -2:]], axis=1)

    def _along(self, slopes: Array) -> Array:
        """Derivatives (rows, parameters, n) as those by the contributors: (rows, contributors, n)."""
        if np.array_equal(self.directions, np.eye(len(self.by))):
            return slopes
        with np.errstate(all="ignore"):
            return np.asarray(np.matmul(self.directions.T, slopes))

    def __call__(self, q: Array) -> dict[str, Array]:
        """The figures of the error maps at drive values (2, n): see :func:`errors`."""
        low, high = self.contributors.low[:, None], self.contributors.high[:, None]
        covariance = self.contributors.covariance
        n, last = q.shape[1], 2 + 2 * len(self.by)
        with np.errstate(all="ignore"):
            y = self.engine.run(self.sheet.inputs(q), self.sheet.parameters)
        slopes = self._along(y[2:last].reshape(2, -1, n))
        found = {"x": y[0], "y": y[1]}
        with np.errstate(all="ignore"):
            outside = ~(y[last:] > 0).all(axis=0)
            for name, slope in zip("xy", slopes, strict=True):
                found[f"error {name} least"] = np.minimum(low * slope, high * slope).sum(axis=0)
                found[f"error {name} most"] = np.maximum(low * slope, high * slope).sum(axis=0)
            found["error worst"] = farthest(slopes, low, high)
            diagonal = np.diag(covariance)[:, None]
            apart = np.array_equal(covariance, np.diag(diagonal[:, 0]))
            spread = slopes * diagonal if apart else np.matmul(covariance, slopes)
            xx, xy, yy = ((slopes[a] * spread[b]).sum(axis=0) for a, b in ((0, 0), (0, 1), (1, 1)))
            found["spread x"], found["spread y"] = 3 * np.sqrt(xx), 3 * np.sqrt(yy)
            found["spread worst"] = 3 * np.sqrt((xx + yy) / 2 + np.hypot((xx - yy) / 2, xy))
        return {name: np.where(outside, np.nan, row) for name, row in found.items()}


def errors(sheet: Sheet, box: Box, contributors: Contributors, steps: int = STEPS) -> Maps:
    """Maps of the working point's errors (m), of first order, on ``steps`` equal steps of each drive.

    Worst case: ``error x least`` and ``most`` are its limits along x, y likewise; ``error worst`` is the farthest that
    the point may be off. ``spread x``, ``y``: three standard deviations; ``spread worst`` those along the direction
    in which they are largest.
    """
    return mapped(sheet.compiled.quantities, box, steps, Errors(sheet, contributors, (steps + 1) ** 2), KINDS)


def farthest(slopes: Array, low: Array, high: Array) -> Array:
    """The greatest length of the sum of slopes (2, contributors, n) times deviations within ``low`` .. ``high``
    (contributors, 1): (n,).

    The sums fill a polygon, whose corners follow each other as its sides are ordered by their directions.
    """
    middle, half = (slopes * (low + high) / 2).sum(axis=1), slopes * (high - low) / 2
    half = np.where((half[1] < 0) | ((half[1] == 0) & (half[0] < 0)), -half, half)
    order = np.argsort(np.arctan2(half[1], half[0]), axis=0)
    sides = np.take_along_axis(half, order[None], axis=1)
    corners = sides.sum(axis=1, keepdims=True) - 2 * np.cumsum(sides, axis=1)
    # Of the corners on both sides of the middle, the farther one.
    beyond = (corners * corners).sum(axis=0) + 2 * np.abs((corners * middle[:, None]).sum(axis=0))
    return np.asarray(np.sqrt(beyond.max(axis=0) + (middle * middle).sum(axis=0)))
