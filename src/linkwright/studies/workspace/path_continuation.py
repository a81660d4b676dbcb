"""Tracks: the drives' values along a wanted path, followed by continuation over the path's parameter u.

At each step q(u + h) is foretold to second order from exact derivatives and corrected by Newton's method
(E. L. Allgower, K. Georg, Introduction to Numerical Continuation Methods, SIAM 2003, ch. 2). A step counts when little
had to be corrected and the jacobian's determinant keeps its sign, so a track never changes over to another solution;
where the path touches the edge of a sheet, it passes on a bridge (``passing.py``).
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.rows import Determinant
from linkwright.kernels import KERNELS
from linkwright.results.stationary import bracketed
from linkwright.studies.workspace.limit_position_crossing import box_left, bridge, curve
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.regions import Region
from linkwright.studies.workspace.sheet import ModeSheet
from linkwright.studies.workspace.solving import solved
from linkwright.studies.workspace.target_path import TargetPath

Array = NDArray[np.float64]

FIRST, LEAST = 1 / 64, 1e-10
"""The first step of u, and the one below which a track has come to its end."""
FAR, NEAR = 0.1, 0.01
"""The largest step and the largest correction of a drive, in rad where its range is a whole turn."""
NEWTON = 12
SOLVED, SMALL = 1e-13, 1e-7
"""A step of Newton's method below the first is the last; so is one that came no nearer after one below the second: what
is left is round-off."""
SAMPLES, NEAREST = 600, 24
SAME = 1e-6
OFF = 1e-6
UNCERTAIN = 1e-4
"""A closure's determinant below this at the end of a track: two assembly modes meet there."""


@dataclass(frozen=True)
class Rates:
    """A sheet's working point ``at`` (2, n) with its jacobian (2, 2, n); ``closure`` the product of the groups'
    determinants, ``bend`` (2, n) its acceleration at given rates of the drives alone."""

    at: Array
    jacobian: Array
    closure: Array
    bend: Array

    @property
    def determinant(self) -> Array:
        """Of the jacobian: (n,)."""
        return determinant(self.jacobian)


class SheetWithRates:
    """A sheet looked at with rates."""

    def __init__(self, sheet: ModeSheet) -> None:
        self.sheet = sheet
        graph = sheet.compiled.graph
        closures = [Determinant(group.label) for group in graph.branched]
        rows = [f"{sheet.point}.{name}" for name in ("x", "y", "vx", "vy", "ax", "ay")]
        self._engine = KERNELS[sheet.kernel](graph.program([*rows, *closures]))
        self.rows = [graph.drives.index(drive) * graph.width for drive in sheet.drives]

    def look(self, q: Array, rates: Array) -> Rates:
        """At drive values and rates (2, n) both."""
        n = q.shape[1]
        x = np.tile(self.sheet.inputs(q), 3)
        a, b = self.rows
        x[a + 1, :n] = x[b + 1, n : 2 * n] = 1.0
        x[[a + 1, b + 1], 2 * n :] = rates
        with np.errstate(all="ignore"):
            y = self._engine.run(x, self.sheet.parameters)
        jacobian = np.stack([y[2:4, :n], y[2:4, n : 2 * n]], axis=1)
        return Rates(y[:2, :n], jacobian, np.prod(y[6:, :n], axis=0), y[4:6, 2 * n :])

    def along(self, q: Array, path: Array) -> tuple[Array, Rates]:
        """The drives' (value, derivative, second derivative) by u, (3, 2, n), where the path is (3, 2, n)."""
        look = self.look(q, np.zeros_like(q))
        slope = divided(look.jacobian, path[1])
        look = self.look(q, slope)
        return np.stack([q, slope, divided(look.jacobian, path[2] - look.bend)]), look

    def solve_drives(self, q: Array, places: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Drive values at which the working point is at places (2, n), by Newton's method from ``q``; which were
        found."""
        done, last = np.zeros(q.shape[1], dtype=bool), np.full(q.shape[1], np.inf)
        for turn in range(NEWTON):
            look = self.sheet.look(q)
            step = divided(look.jacobian, look.at - places)
            q = q - step
            size = np.abs(step).max(axis=0)
            done = (size <= SOLVED * (1.0 + np.abs(q).max(axis=0))) | ((last < SMALL) & (size > last / 4))
            if done.all() or not np.isfinite(step).any() or (turn > 2 and not (done | (size < last / 2)).any()):
                break
            last = size
        return q, done


def determinant(matrix: Array) -> Array:
    """Of (2, 2, n): (n,)."""
    return np.asarray(matrix[0, 0] * matrix[1, 1] - matrix[0, 1] * matrix[1, 0])


def divided(matrix: Array, right: Array) -> Array:
    """Solutions (2, n) of 2 by 2 systems by Cramer's rule."""
    (a, b), (c, d) = matrix
    with np.errstate(all="ignore"):
        return np.stack([d * right[0] - b * right[1], a * right[1] - c * right[0]]) / determinant(matrix)


@dataclass(frozen=True, eq=False)
class SolutionTrack:
    """One solution along a path from u = 0 to ``u[-1]``: ``nodes`` (3, 2, n) are the drives with two derivatives by u.
    ``end`` says why it is no longer: "" (it is whole), "singular", "modes", or "limit" with the ``drive``. ``bridges``
    are the stretches of u on which it passes a limit position, near to the path only."""

    mover: SheetWithRates
    wanted: TargetPath
    u: Array
    nodes: Array
    end: str
    drive: str = ""
    bridges: tuple[tuple[float, float], ...] = ()

    @cached_property
    def _spline(self) -> Any:
        return curve(self.u, self.nodes)

    def near(self, u: Array) -> Array:
        """The drives' values between the nodes, as starts: (2, n)."""
        return np.asarray(self._spline(u)).T

    def bridged(self, u: Array) -> NDArray[np.bool_]:
        """Which places lie on a bridge."""
        on = np.zeros(u.shape, dtype=bool)
        for start, stop in self.bridges:
            on |= (u > start) & (u < stop)
        return on

    def along(self, u: Array) -> Array:
        """The drives with two derivatives by u as the quintics between the nodes have them: (3, 2, n)."""
        return np.stack([np.asarray(self._spline(u, nu=k)).T for k in range(3)])

    def at(self, u: Array) -> Array:
        """The drives with two derivatives by u, (3, 2, n), to round-off but for bridges."""
        path, given = self.wanted.of(u), self.bridged(u)
        made = self.along(u)
        q, _ = self.mover.solve_drives(made[0][:, ~given], path[0][:, ~given])
        made[:, :, ~given] = self.mover.along(q, path[:, :, ~given])[0]
        return made

    @property
    def least(self) -> float:
        """The least size of the jacobian's determinant on the way: none where a limit position is passed."""
        if self.bridges:
            return 0.0
        return float(np.abs(self.mover.look(self.nodes[0], self.nodes[1]).determinant).min())

    @cached_property
    def limit_positions(self) -> Array:
        """The u of limit positions that are passed."""

        def sign(u: Array, _: Any) -> Array:
            return self.mover.look(self.near(u), np.zeros((2, u.size))).determinant

        ends = np.array(self.bridges).reshape(-1, 2).T
        return bracketed(sign, np.arange(len(self.bridges)), *ends) if self.bridges else np.empty(0)


def tracks(region: Region, wanted: TargetPath, off: float | None = None) -> list[SolutionTrack]:
    """Every solution of a sheet at the path's start, followed as far as it goes; the longest first. Where a limit
    position is passed, the point may be ``off`` the path (m), :data:`OFF` of the largest link if not said."""
    mover = SheetWithRates(region.sheet)
    off = OFF * region.sheet.compiled.graph.size if off is None else off
    found = [
        _follow_path(mover, region.box, wanted, start, off) for start in starts(region, wanted.of(np.zeros(1))[0]).T
    ]
    return sorted(found, key=lambda track: -float(track.u[-1]))


def starts(region: Region, place: Array) -> Array:
    """The drive values at which the working point is at a place (2, 1), whole turns apart: (2, solutions)."""
    sheet, box, corners = region.sheet, region.box, region.mesh.q[:, np.unique(region.mesh.triangles)]
    at = sheet.place(corners)[0]
    known = np.isfinite(at).all(axis=0)
    corners, at = corners[:, known], at[:, known]
    if not corners.size:
        return corners
    spread = np.linspace(0, corners.shape[1] - 1, min(SAMPLES, corners.shape[1])).astype(int)
    nearest = np.argsort(np.hypot(*(at - place)))[:NEAREST]
    tried = corners[:, np.concatenate([nearest, spread])]
    near = 1e-9 * float(np.ptp(at, axis=1).max())
    q, ok = solved(sheet, box, tried, np.broadcast_to(place, tried.shape), near)
    turn = np.where(box.turns, 2 * np.pi, np.inf)[:, None]
    low = np.array(box.low)[:, None]
    q = q[:, ok] - np.where(box.turns, 2 * np.pi * np.floor((q[:, ok].T - low.T) / (2 * np.pi)), 0.0).T
    found: list[Array] = []
    for one in q.T:
        apart = [np.abs(one - other) for other in found]
        if all((np.minimum(d, np.abs(turn[:, 0] - d)) > SAME * box.size).any() for d in apart):
            found.append(one)
    return np.array(found).reshape(-1, 2).T


def _follow_path(mover: SheetWithRates, box: DriveBox, wanted: TargetPath, start: Array, off: float) -> SolutionTrack:
    scale = box.size[:, None] / (2 * np.pi)
    q, _ = mover.solve_drives(start[:, None], wanted.of(np.zeros(1))[0])
    turns = np.floor((q[:, 0] - np.array(box.low)) / (2 * np.pi) + SAME)
    q -= np.where(box.turns, 2 * np.pi * turns, 0.0)[:, None]
    node, look = mover.along(q, wanted.of(np.zeros(1)))
    u, h, eager, end, drive = 0.0, FIRST, True, "", ""
    us, nodes, signs = [u], [node], [float(look.determinant[0])]
    bridges: list[tuple[float, float]] = []
    while u < 1.0:
        step = min(h, 1.0 - u)
        ahead = 1.0 if step == 1.0 - u else u + step
        foretold = node[0] + step * node[1] + step**2 / 2 * node[2]
        path = wanted.of(np.array([ahead]))
        with np.errstate(all="ignore"):
            q, ok = mover.solve_drives(foretold, path[0])
            close = ok & (np.abs(q - foretold) / scale <= NEAR).all() & (np.abs(q - node[0]) / scale <= FAR).all()
        outside = box_left(box, q[:, 0])
        good = False
        if close.all() and not outside.any():
            new, look = mover.along(q, path)
            good = bool(np.isfinite(new).all() and (look.determinant * signs[-1] > 0).all())
        if good:
            u, node = ahead, new
            us.append(u)
            nodes.append(node)
            signs.append(float(look.determinant[0]))
            h, eager = step * (1.5 if eager else 1.0), True
            continue
        if eager and off > 0 and (over := bridge(mover, box, wanted, us, nodes, signs, off)) is not None:
            kept = over.first + 1
            bridges.append((us[over.first], over.u))
            u, node = over.u, over.node
            us, nodes, signs = [*us[:kept], u], [*nodes[:kept], node], [*signs[:kept], over.determinant]
            continue
        h, eager = step / 2, False
        if h < LEAST:
            beyond = close.all() and outside.any()
            closure = np.abs(mover.look(node[0], node[1]).closure)
            end = "limit" if beyond else "modes" if (closure < UNCERTAIN).any() else "singular"
            drive = mover.sheet.drives[int(np.argmax(outside))] if beyond else ""
            break
    return SolutionTrack(mover, wanted, np.array(us), np.concatenate(nodes, axis=2), end, drive, tuple(bridges))
