"""Whether the poses of a run are right, judged from the sketch that the mechanism was made of.

Nothing here is the solver's: the sketch's own coordinates, plain NumPy, and the constraint matrix of all links,
joints and drives at once, where the solver goes group by group. What is judged are the reported poses of all links
and their exact rates.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from sketches import FRAME, Drive, Sketch

from linkwright.graph.rows import BodyPlace
from linkwright.kernels import Compiled

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

CLOSURE = 1e-10
"""The most that a joint may miss, over the mechanism's size; a drive's value, in rad or over the size."""
NEAR = 0.02
"""Neighbours are near where rates tell the next pose this well (rad, or over the size)."""
DEEPEST = 40
"""Halvings of an interval after which poses that don't come near are a jump."""


@dataclass
class Poses:
    """Every link's place and unit vector (4, times) with their rates, at some times."""

    t: Array
    now: dict[str, Array]
    rate: dict[str, Array]


def poses(compiled: Compiled, links: list[str], t: Array) -> Poses:
    """The reported poses at times ``t``."""
    names = [row for link in links for row in BodyPlace.all(link)]
    y = compiled.evaluate(names, t, rates=True)
    still, ones = np.zeros((4, t.size)), np.ones(t.size)
    now, rate = {FRAME: np.array([0 * ones, 0 * ones, ones, 0 * ones])}, {FRAME: still}
    for i, link in enumerate(links):
        now[link], rate[link] = y[4 * i : 4 * i + 4, 0], y[4 * i : 4 * i + 4, 1]
    return Poses(t, now, rate)


class Judge:
    """What must hold of a sketched mechanism's poses; ``size`` is the extent of its joints (m)."""

    def __init__(self, sketch: Sketch, compiled: Compiled | None) -> None:
        self.sketch, self.compiled = sketch, compiled
        self.links = [link for link in sketch.pose if link != FRAME]
        places = np.array([joint.at for joint in sketch.joints.values()])
        self.size = float(np.hypot(*np.ptp(places, axis=0))) or 1.0
        self.rcond = 1.0

    @property
    def needed(self) -> Compiled:
        assert self.compiled is not None
        return self.compiled

    def faults(self, t: Array) -> Iterator[str]:
        """Every rule that the run at times ``t`` breaks."""
        p = poses(self.needed, self.links, t)
        if not all(np.isfinite(p.now[link]).all() and np.isfinite(p.rate[link]).all() for link in self.links):
            yield "not a number"
            return
        self.worst_closure = self.closure(p)
        if not self.worst_closure < CLOSURE:
            yield f"closure {self.worst_closure:.2g}"
        matrices = self.matrices(p)
        conditions = 1 / np.linalg.cond(matrices)
        self.rcond = float(conditions.min())
        start = self.away(p, 0)
        if not start < 1e-12 / conditions[0] + 1e-10:
            yield f"start pose {start:.2g} off the sketch"
        signs = np.linalg.slogdet(matrices)[0]
        if (signs != signs[0]).any():
            yield f"the determinant changes sign at {t[np.argmax(signs != signs[0])]:.6g} s"
        for name, side in self.sides(p):
            if (np.sign(side) != np.sign(side[0])).any():
                yield f"the triangle at {name} turns over at {t[np.argmax(np.sign(side) != np.sign(side[0]))]:.6g} s"
        drives = list(self.sketch.drives.values())
        if len(drives) == 1 and drives[0].law.size and not (back := self.back(p)) < 1e-11 / self.rcond + 1e-9:
            yield f"doesn't come back: {back:.2g}"
        yield from self.jumps(p)

    def regularity(self, time: float | None) -> float:
        """The reciprocal condition number of all constraints at a time, or in the sketch: 0 singular, 0 loose."""
        p = self.sketched() if time is None else poses(self.needed, self.links, np.array([time]))
        matrix = self.matrices(p)[0]
        sound = np.isfinite(matrix).all() and matrix.shape[0] >= matrix.shape[1]
        return float(1 / np.linalg.cond(matrix)) if sound else 0.0

    def sketched(self) -> Poses:
        """The sketch itself as a pose."""
        places = {link: np.array([[x], [y], [np.cos(a)], [np.sin(a)]]) for link, (x, y, a) in self.sketch.pose.items()}
        return Poses(np.zeros(1), places, {})

    # Places.

    def at(self, p: Poses, joint: str, link: str) -> Array:
        """A link's point on a joint, (2, times)."""
        x, y, c, s = p.now[link]
        a, b = self.sketch.local(joint, link)
        return np.array([x + c * a - s * b, y + s * a + c * b])

    def along(self, p: Poses, joint: str, link: str) -> Array:
        """The direction of a slide's line on a link, (2, times)."""
        _, _, c, s = p.now[link]
        angle = self.sketch.joints[joint].angle - self.sketch.pose[link][2]
        a, b = np.cos(angle), np.sin(angle)
        return np.array([c * a - s * b, s * a + c * b])

    def closure(self, p: Poses) -> float:
        """The worst miss of any joint or drive."""
        worst = [0.0]
        for name, joint in self.sketch.joints.items():
            first = joint.links[0]
            for link in joint.links[1:]:
                gap = self.at(p, name, link) - self.at(p, name, first)
                if joint.kind == "P":
                    line = self.along(p, name, first)
                    worst.append(np.abs(self.along(p, name, link) - line).max())
                    gap = cross(line, gap)
                worst.append(np.abs(gap).max() / self.size)
        worst += [np.abs(np.hypot(*p.now[link][2:]) - 1).max() for link in self.links]
        return float(max(*worst, *(self.drive_miss(p, drive) for drive in self.sketch.drives.values())))

    def drive_miss(self, p: Poses, drive: Drive) -> float:
        """How far a drive is off its law."""
        law = drive.law
        goal = law.start + law.speed * p.t + law.size * (np.sin(law.rate * p.t + law.phase) - np.sin(law.phase))
        if drive.kind == "R":
            _, _, c, s = p.now[drive.link]
            _, _, c0, s0 = p.now[drive.on]
            turned = np.arctan2(s, c) - np.arctan2(s0, c0)
            return float(np.abs(2 * np.sin((turned - goal) / 2)).max())
        gap = self.at(p, drive.joint, drive.link) - self.at(p, drive.joint, drive.on)
        # The travel counts along the line of the joint's first link.
        line = self.along(p, drive.joint, self.sketch.joints[drive.joint].links[0])
        return float(np.abs((line * gap).sum(axis=0) - goal).max() / self.size)

    def away(self, p: Poses, k: int) -> float:
        """How far a pose is from the sketch."""
        misses = []
        for link in self.links:
            x, y, angle = self.sketch.pose[link]
            goal = np.array([x / self.size, y / self.size, np.cos(angle), np.sin(angle)])
            misses.append(np.abs(self.scaled(p.now[link][:, k]) - goal).max())
        return float(max(misses))

    def back(self, p: Poses) -> float:
        """How far the last pose is from the first."""
        return float(max(np.abs(self.scaled(p.now[k][:, -1] - p.now[k][:, 0])).max() for k in self.links))

    def scaled(self, pose: Array) -> Array:
        return np.array([pose[0] / self.size, pose[1] / self.size, pose[2], pose[3]])

    # Branches.

    def sides(self, p: Poses) -> Iterator[tuple[str, Array]]:
        """Twice the area of each pinned dyad's triangle, with the sign of its orientation."""
        for group in self.needed.structure.groups:
            if group.signature == "RRR":
                joints = [c.joint for c in (*group.outer, group.inner)]
                a, b, inner = (self.at(p, joint, self.sketch.joints[joint].links[0]) for joint in joints)
                yield joints[2], cross(b - a, inner - a)

    def matrices(self, p: Poses) -> Array:
        """The matrix of all joints and drives over (vx, vy, omega size) of all links: (times, rows, 3 links)."""
        rows: list[Array] = []
        for name, joint in self.sketch.joints.items():
            first = joint.links[0]
            for link in joint.links[1:]:
                if joint.kind == "R":
                    rows += [*(self.velocity(p, link, name) - self.velocity(p, first, name))]
                else:
                    line, slip = self.along(p, name, first), self.slip(p, name, first, link)
                    rows += [cross(line[:, :, None], slip), self.turning(p, link) - self.turning(p, first)]
        for drive in self.sketch.drives.values():
            if drive.kind == "R":
                rows.append(self.turning(p, drive.link) - self.turning(p, drive.on))
            else:
                slip = self.slip(p, drive.joint, drive.on, drive.link)
                rows.append((self.along(p, drive.joint, drive.on)[:, :, None] * slip).sum(axis=0))
        return np.stack(rows, axis=1)

    def turning(self, p: Poses, link: str) -> Array:
        """A link's turning: (times, 3 links)."""
        row = np.zeros((p.t.size, 3 * len(self.links)))
        if link != FRAME:
            row[:, 3 * self.links.index(link) + 2] = 1.0
        return row

    def velocity(self, p: Poses, link: str, joint: str, of: str = "") -> Array:
        """The velocity of a link where it has a joint, or where another link ``of`` has it: (2, times, 3 links)."""
        row = np.zeros((2, p.t.size, 3 * len(self.links)))
        if link != FRAME:
            i, arm = 3 * self.links.index(link), (self.at(p, joint, of or link) - p.now[link][:2]) / self.size
            row[0, :, i], row[1, :, i + 1] = 1.0, 1.0
            row[0, :, i + 2], row[1, :, i + 2] = -arm[1], arm[0]
        return row

    def slip(self, p: Poses, joint: str, base: str, link: str) -> Array:
        """The velocity of a link's point against the base that carries it: (2, times, 3 links)."""
        return np.asarray(self.velocity(p, link, joint) - self.velocity(p, base, joint, of=link))

    def jumps(self, p: Poses) -> Iterator[str]:
        """Places where poses don't go on as their rates say, however near they are looked at."""
        left, right = p, p
        a, b = np.arange(p.t.size - 1), np.arange(1, p.t.size)
        for _ in range(DEEPEST):
            far = self.far(left, right, a, b)
            if not far.any():
                return
            lows, highs = left.t[a[far]], right.t[b[far]]
            if lows.size > 4000:
                yield f"jumps at {lows.size} places"
                return
            middle = (lows + highs) / 2
            every = poses(self.needed, self.links, np.concatenate([lows, middle, highs]))
            left = right = every
            n = lows.size
            a, b = (
                np.concatenate([np.arange(n), n + np.arange(n)]),
                np.concatenate([n + np.arange(n), 2 * n + np.arange(n)]),
            )
        yield f"jump at {left.t[a[0]]:.9g} s"

    def far(self, left: Poses, right: Poses, a: Indices, b: Indices) -> NDArray[np.bool_]:
        """Which intervals' ends the rates don't join."""
        h = right.t[b] - left.t[a]
        worst = np.zeros(a.size)
        for link in self.links:
            step = right.now[link][:, b] - left.now[link][:, a]
            told = h * (left.rate[link][:, a] + right.rate[link][:, b]) / 2
            miss = step - told
            miss[:2] /= self.size
            with np.errstate(invalid="ignore"):
                worst = np.maximum(worst, np.abs(miss).max(axis=0))
        return np.asarray(~(worst < NEAR))


def cross(a: Array, b: Array) -> Array:
    """The cross product of vectors (2, times)."""
    return np.asarray(a[0] * b[1] - a[1] * b[0])
