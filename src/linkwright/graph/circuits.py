"""Circuits: which poses a mechanism of one freedom reaches without being taken apart, and its branches there.

The poses that the joints allow form curves in the space of the links' poses. A curve is followed by its arclength
(predictor along the tangent, Newton across it: E. L. Allgower, K. Georg 1990), through the dead points of the drive,
where its value turns back while the curve goes on. A closed curve is a circuit; the parts of it between dead points
are its branches (T. R. Chase, J. A. Mirth 1993). The sign of det [J; tangent] stays along a regular curve: a step
after which it has changed has jumped to another one, and is halved; where halving doesn't help, two curves cross
(a change point), and the way goes straight on.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.constraints import Constraints

Array = NDArray[np.float64]

LONGEST, SHORTEST = 0.1, 1e-5
"""Steps along the curve (rad, or lengths over the size); curves nearer than the shortest count as crossing."""
FINE = 0.01
"""The finest steps that a follower's law asks for (rad), however short its pieces are."""
BEND = 0.995
"""The least cosine between the tangents at both ends of a step."""
STEPS, WORK = 6000, 8e6
"""The most steps of a curve, tries that are halved among them; and these times the square of the unknowns."""
FAR = 50.0
"""A pose farther away than this many sizes is out of reach: the curve is open."""
FOUND = 1e-6
"""Poses nearer than this are the same."""


@dataclass
class CircuitCurve:
    """A followed curve: poses (steps, 3 links) with the drive's values (rad or m) there, in order.

    ``dead`` are the drive's values at dead points, ``crossings`` those where two curves cross; ``meets`` the poses at
    which the drive comes back to its first value (modulo a turn), each with the number of the branch that it is on.
    Branch 0 is the one that the curve begins on, and in a closed curve ends on.
    """

    closed: bool = False
    poses: list[Array] = field(default_factory=list)
    values: list[float] = field(default_factory=list)
    dead: list[float] = field(default_factory=list)
    crossings: list[float] = field(default_factory=list)
    meets: list[tuple[Array, int]] = field(default_factory=list)
    ranges: list[tuple[float, float]] = field(default_factory=list)  # of the drive, branch by branch
    cut: bool = False  # given up on its way


class _Lost(Exception):
    """The corrector doesn't settle."""


class Tracer:
    """Follows curves of a system with one freedom; ``drive`` is the one whose value is watched."""

    def __init__(self, system: Constraints, drive: str) -> None:
        self.system, self.drive = system, drive
        self.turns = system.topology.mechanism.prescribed(drive).turns is not None
        self.patience = int(min(STEPS, WORK / system.width**2))
        finest = min((relation.finest for relation in system.relations.values()), default=LONGEST)
        self.longest = min(LONGEST, max(finest, FINE))

    @property
    def too_large(self) -> bool:
        """Whether the steps that are allowed don't even take one link round."""
        return self.patience * self.longest < 2 * math.pi

    def follow(self, start: Array) -> CircuitCurve | None:
        """The whole curve through a pose; ``None`` where two curves cross there, so that it has no direction, or where
        it takes too long."""
        try:
            z = self.nearest_pose(start)
            tangent = self.first_tangent(z)
        except _Lost:
            return None
        if tangent is None:
            return None
        if self.system.gradient(self.drive, z) @ tangent < 0:
            tangent = -tangent
        forward = self.one_way(z, tangent)
        if forward.cut:
            return None
        if forward.closed:
            return _with_ranges(forward)
        back = self.one_way(z, -tangent)
        return None if back.cut else _joined_halves(back, forward)

    def nearest_pose(self, z: Array) -> Array:
        """The nearest pose that the joints allow."""
        for _ in range(20):
            rest = self.system.residual(z)
            z = z - np.linalg.lstsq(self.system.jacobian(z), rest, rcond=1e-10)[0]
            if np.abs(rest).max(initial=0.0) < 1e-12:
                return z
        raise _Lost

    def first_tangent(self, z: Array) -> Array | None:
        """The direction of the curve; ``None`` where there is more than one."""
        q, r = np.linalg.qr(self.system.jacobian(z).T, mode="complete")
        return None if np.abs(np.diagonal(r)).min(initial=1.0) < 1e-7 else np.asarray(q[:, -1])

    def tangent(self, z: Array, last: Array) -> tuple[Array, float]:
        """The direction of the curve, the way of the last one, and det [J; last]."""
        matrix = np.vstack([self.system.jacobian(z), last])
        right = np.zeros(self.system.width)
        right[-1] = 1.0
        try:
            found = np.linalg.solve(matrix, right)
        except np.linalg.LinAlgError:
            raise _Lost from None
        return found / np.linalg.norm(found), float(np.linalg.det(matrix))

    def corrected(self, guess: Array, row: Array, rest: Callable[[Array], float]) -> Array:
        """Newton from a guess on the joints' equations and one more: its slope, and what it misses at a pose."""
        z = guess
        for _ in range(6):
            gap = np.append(self.system.residual(z), rest(z))
            try:
                step = np.linalg.solve(np.vstack([self.system.jacobian(z), row]), gap)
            except np.linalg.LinAlgError:
                raise _Lost from None
            z = z - step
            if np.abs(step).max() < 1e-11:
                return z
        raise _Lost

    def advance(self, z: Array, tangent: Array, h: float) -> tuple[Array, Array, float]:
        """A step of length h: the pose, its direction, the determinant there."""
        guess = z + h * tangent
        there = self.corrected(guess, tangent, lambda at: float(tangent @ (at - guess)))
        if np.linalg.norm(there - guess) > 0.3 * h:
            raise _Lost
        onward, determinant = self.tangent(there, tangent)
        if onward @ tangent < BEND:
            raise _Lost
        return there, onward, determinant

    def one_way(self, start: Array, first: Array) -> CircuitCurve:
        """The curve from a pose in a direction until it closes, or ends."""
        curve = CircuitCurve(poses=[start], values=[self.system.value(self.drive, start)])
        z, tangent, h = start, first, self.longest / 4
        _, last = self.tangent(start, first)
        branch = 0
        for _ in range(self.patience):
            crossed = False
            try:
                there, onward, new = self.advance(z, tangent, h)
                if new * last <= 0:
                    raise _Lost
            except _Lost:
                h /= 2
                if h >= SHORTEST:
                    continue
                jump = self.across(z, tangent)
                if jump is None:
                    return curve
                (there, onward, new), h, crossed = jump, SHORTEST * 8, True
            if crossed and new * last < 0:
                share = last / (last - new)
                values = [self.system.value(self.drive, p) for p in (z, there)]
                curve.crossings.append(values[0] + share * (values[1] - values[0]))
            elif (turning := self.dead_point(z, tangent, there, onward)) is not None:
                curve.dead.append(turning)
                branch += 1
            back = self.closes(start, first, z, there)
            for pose in self.passes(curve.values[0], z, there if back is None else back):
                if np.abs(self.system.pose_difference(pose, start)).max() > FOUND:
                    curve.meets.append((pose, branch))
            curve.poses.append(there if back is None else back)
            curve.values.append(self.system.value(self.drive, curve.poses[-1]))
            if back is not None:
                curve.closed = True
                return curve
            if np.abs(np.delete(there.reshape(-1, 3), 2, axis=1)).max() > FAR:
                return curve
            z, tangent, last = there, onward, new
            h = min(h * 1.5, self.longest)
        curve.cut = True
        return curve

    def across(self, z: Array, tangent: Array) -> tuple[Array, Array, float] | None:
        """A step straight over a crossing of two curves; ``None`` where the curve ends."""
        for h in (1e-3, 3e-3, 1e-2):
            try:
                return self.advance(z, tangent, h)
            except _Lost:
                continue
        return None

    def dead_point(self, z: Array, tangent: Array, there: Array, onward: Array) -> float | None:
        """The drive's value where it turns back within a step; ``None`` where it goes on."""
        low, high = (float(self.system.gradient(self.drive, p) @ t) for p, t in ((z, tangent), (there, onward)))
        if low * high > 0 or high == 0:
            return None
        a, b, whole = 0.0, 1.0, float(tangent @ (there - z))
        at = there
        for _ in range(40):
            part = (a * high - b * low) / (high - low) if high != low else 0.5 * (a + b)
            part = min(max(part, a + 0.05 * (b - a)), b - 0.05 * (b - a))
            try:
                at, way, _ = self.advance(z, tangent, part * whole)
            except _Lost:
                break
            slope = float(self.system.gradient(self.drive, at) @ way)
            if slope * low > 0:
                a, low = part, slope
            else:
                b, high = part, slope
            if b - a < 1e-9 or slope == 0:
                break
        return self.system.value(self.drive, at)

    def closes(self, start: Array, first: Array, z: Array, there: Array) -> Array | None:
        """The start again, whole turns added, where a step comes back to it in the first direction."""
        before, after = (self.system.pose_difference(p, start) for p in (z, there))
        if np.abs(after).max() > 3 * LONGEST or not first @ before < 0 <= first @ after:
            return None
        try:
            back = self.corrected(there, first, lambda at: float(first @ self.system.pose_difference(at, start)))
        except _Lost:
            return None
        return back if np.abs(self.system.pose_difference(back, start)).max() < FOUND else None

    def passes(self, first: float, z: Array, there: Array) -> list[Array]:
        """The poses within a step at which the drive has its first value, modulo a turn."""
        turn = 2 * math.pi if self.turns else math.inf
        a, b = (self.system.value(self.drive, p) - first for p in (z, there))
        if self.turns:
            around = math.ceil(min(a, b) / turn) * turn
            goal = around if min(a, b) < around <= max(a, b) else None
        else:
            goal = 0.0 if min(a, b) < 0.0 <= max(a, b) else None
        if goal is None:
            return []
        unit = 1.0 if self.turns else self.system.size
        guess = z + (there - z) * ((goal - a) / (b - a))

        def residual(at: Array) -> float:
            return (self.system.value(self.drive, at) - first - goal) / unit

        try:
            return [self.corrected(guess, self.system.gradient(self.drive, guess), residual)]
        except _Lost:
            return []


def _with_ranges(curve: CircuitCurve) -> CircuitCurve:
    """Branch by branch the drive's range; in a closed curve the last branch goes on as the first."""
    values, dead = [*curve.values], curve.dead
    if not dead:
        curve.ranges = [(min(values), max(values))]
        return curve
    ends = [values[0], *dead, values[-1]]
    curve.ranges = [(min(a, b), max(a, b)) for a, b in pairwise(ends)]
    if curve.closed:
        # The first and the last stretch are one branch, but for whole turns.
        shift = values[-1] - values[0]
        last, first = curve.ranges.pop(), curve.ranges[0]
        both = [*first, *(v - shift for v in last)]
        curve.ranges[0] = (min(both), max(both))
        count = len(curve.ranges)
        curve.meets = [(pose, branch % count) for pose, branch in curve.meets]
    return curve


def _joined_halves(back: CircuitCurve, forward: CircuitCurve) -> CircuitCurve:
    """The two halves of an open curve as one; branch 0 stays the one of the start."""
    curve = CircuitCurve(False, back.poses[::-1] + forward.poses[1:], back.values[::-1] + forward.values[1:])
    curve.dead, curve.crossings = back.dead[::-1] + forward.dead, back.crossings[::-1] + forward.crossings
    n = len(back.dead)
    curve.meets = [(p, n - b) for p, b in back.meets] + [(p, n + b) for p, b in forward.meets]
    curve = _with_ranges(curve)
    curve.ranges = curve.ranges[n:] + curve.ranges[:n]
    count = len(curve.ranges)
    curve.meets = [(p, (b - n) % count) for p, b in curve.meets]
    return curve
