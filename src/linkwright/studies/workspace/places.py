"""Which places of the plane a mode reaches: decided by the signs of a few functions of the place.

All poses in which the working point is at a place are known (:mod:`linkwright.graph.inverse`): one for each choice of
the branches of dyads and of the angles of triads' platforms (:mod:`linkwright.studies.workspace.platforms`). Each is
one of a mode's, within the drives' ranges, if every function of it is positive: what stands under the roots (a zero is
a limit position of the output, where two poses meet), the closures' determinants with the mode's sign (a zero is an
uncertain position), and the distances from the ends of the drives' ranges. A place is reached if some pose has all of
them positive; the number of such poses tells how often the mode covers it.
"""

from __future__ import annotations

import math
from copy import copy
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.enclosures.forms import FEW, AffineForm
from linkwright.enclosures.program import BOXES, Stage
from linkwright.graph.inverse import DeterminantRow, DriveValue, Inverse, inverse
from linkwright.graph.rows import Determinant, Radicand
from linkwright.kernels import KERNELS, Compiled
from linkwright.kernels.registry import Kernel
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.platforms import Platforms, Sets
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

LOOKS = 200
"""Values of the drives at which it is seen which sign of a determinant belongs to which branch."""
BLOCK = 4096
"""So many squares are enclosed at a time: their numbers stay in the processor's cache."""
UNKNOWN = np.array([0.0, 0.0, 0.0, np.inf])[:, None, None]
"""The numbers of a form of which nothing is known."""
FOLD, MODES, LIMIT = "singular", "modes", "limit"


@dataclass(frozen=True)
class KnownPoses:
    """The poses of a mechanism turned round, with which sign of a closure's determinant belongs to branch +1."""

    inverse: Inverse
    signs: tuple[float, ...]
    kernel: Kernel

    @classmethod
    def of(cls, compiled: Compiled, point: str) -> KnownPoses | None:
        """``None`` where not all poses are known."""
        return compiled.cached(("poses", point), lambda: _poses(compiled, point))


def _poses(compiled: Compiled, point: str) -> KnownPoses | None:
    found = inverse(compiled.graph, point)
    signs = _signs(compiled)
    if found is None or signs is None:
        return None
    return KnownPoses(found, signs, KERNELS["numpy"](found.program))


def _signs(compiled: Compiled) -> tuple[float, ...] | None:
    """The sign that each group's determinant has in branch +1; ``None`` where some has both or none."""
    graph, rng = compiled.graph, np.random.default_rng(0)
    rows = [Determinant(group.label) for group in graph.branched]
    x = np.zeros((len(graph.inputs), LOOKS))
    for i, drive in enumerate(graph.drives):
        turns = compiled.mechanism.prescribed(drive).turns
        x[i * graph.width] = rng.uniform(-np.pi, np.pi, LOOKS) if turns else rng.normal(0, 2 * graph.size, LOOKS)
    first = len(graph.drives) * graph.width
    branches = rng.choice([-1.0, 1.0], (len(rows), LOOKS))
    x[first : graph.first_unknown] = branches
    with np.errstate(all="ignore"):
        found = np.sign(KERNELS["numpy"](graph.program(rows)).run(x, compiled.parameters)) * branches
    kept = [set(row[np.isfinite(row) & (row != 0)].tolist()) for row in found]
    return tuple(one.pop() for one in kept) if all(len(one) == 1 for one in kept) else None


class ModePlaces:
    """The places that a mode reaches with its drives in their ranges.

    ``branches`` (branches, dyads) are the choices of branches; each has so many ``poses`` next to each other.
    """

    def __init__(self, poses: KnownPoses, sheet: ModeSheet, box: DriveBox) -> None:
        self.poses, self.sheet, self.box = poses, sheet, box
        self.inverse = poses.inverse
        self.branches = np.array(self.inverse.branches())
        self.platforms = Platforms(self.inverse, sheet.parameters)
        self.poses_each = self.platforms.most
        rows, self.kinds = self._combined()
        self.rows = np.array(rows)

    def only(self, branch: int) -> ModePlaces:
        """The places that the poses of one branch reach by themselves."""
        one = copy(self)
        one.branches = self.branches[branch : branch + 1]
        return one

    def poses_of(self, branch: int | None) -> Rows:
        """The numbers of the poses of one branch, or of all."""
        count = self.poses_each
        return np.arange(len(self.branches) * count) if branch is None else branch * count + np.arange(count)

    def partner(self, pose: Rows, function: Rows) -> Rows:
        """The poses (n,) that meet some poses (n,) where a function (n,) of theirs is zero, where they are of another
        branch; else the same."""
        branch, angle = np.divmod(pose, self.poses_each)
        turned = self.branches[branch].copy()
        folds = np.flatnonzero(function < len(self.inverse.groups))
        turned[folds, function[folds]] *= -1
        branch = np.asarray((turned[:, None] == self.branches).all(axis=2).argmax(axis=1))
        return np.asarray(branch * self.poses_each + angle)

    def _combined(self) -> tuple[list[Array], list[str]]:
        """Each function as coefficients of the program's rows, the rooms of platforms, and of 1; and its kind."""
        platforms = [Radicand(triad.label) for triad in self.inverse.triads]
        known = [*self.inverse.rows, *platforms]
        *units, one = np.eye(len(known) + 1)
        unit = dict(zip(known, units, strict=True))
        rows = [unit[room] for room in (*(Radicand(group.label) for group in self.inverse.groups), *platforms)]
        kinds = [FOLD] * len(rows)
        for group, own, sign in zip(self.inverse.modes, self.poses.signs, self.sheet.branches, strict=True):
            rows.append(own * sign * unit[DeterminantRow(group.label)])
            kinds.append(MODES)
        for k, drive in enumerate(self.inverse.drives):
            low, high = self.box.low[k], self.box.high[k]
            if self.inverse.turns(drive):
                middle, half = (low + high) / 2, (high - low) / 2
                cos, sin = (unit[DriveValue(drive, part)] for part in ("cos", "sin"))
                inside = math.cos(middle) * cos + math.sin(middle) * sin - math.cos(half) * one
                found = [] if self.box.turns[k] else [inside]
            else:
                travel = unit[DriveValue(drive, "travel")]
                found = [way * (travel - end * one) for way, end in ((1.0, low), (-1.0, high))]
            rows += found
            kinds += [LIMIT] * len(found)
        return rows, kinds

    def functions(self, at: Array) -> Array:
        """The functions at places (2, n): (poses, functions, n), NaN behind a negative one."""
        return self._functions(self._everywhere(at))

    def _everywhere(self, at: Array) -> Array:
        """The program's rows at places (2, n) and the rooms of platforms, in all poses: (rows, poses, n)."""
        count, n = len(self.branches), at.shape[1]
        x = np.concatenate([np.tile(at, count), np.repeat(self.branches, n, axis=0).T])
        x, rooms = self.platforms.poses_at(x)
        with np.errstate(all="ignore"):
            found = self.poses.kernel.run(x.reshape(len(x), x[0].size), self.sheet.parameters)
        found = np.concatenate([found, rooms.reshape(len(rooms), x[0].size)])
        found = found.reshape(len(found), self.poses_each, count, n).swapaxes(1, 2)
        return found.reshape(len(found), self.poses_each * count, n)

    def _functions(self, found: Array) -> Array:
        functions = np.empty((found.shape[1], len(self.rows), found.shape[2]))
        with np.errstate(all="ignore"):
            for k, coefficients in enumerate(self.rows):
                used = np.flatnonzero(coefficients[:-1])
                functions[:, k] = sum(coefficients[i] * found[i] for i in used) + coefficients[-1]
        return functions

    def depths(self, at: Array) -> Array:
        """The least function of each pose, (poses, n): positive where it is one of the mode's."""
        return self._least(self.functions(at))

    @staticmethod
    def _least(functions: Array) -> Array:
        least = np.fmin.reduce(functions, axis=1)
        vague = np.isnan(functions).any(axis=1) & ~(least < 0)
        return np.where(vague, -np.inf, least)

    def depth(self, at: Array) -> Array:
        """Positive at the places (2, n) that are reached, negative elsewhere: (n,)."""
        return np.asarray(self.depths(at).max(axis=0))

    def count(self, at: Array) -> Rows:
        """How many poses reach each place (2, n): (n,)."""
        return np.asarray((self.depths(at) > 0).sum(axis=0))

    def drives(self, at: Array) -> tuple[Array, Array]:
        """The drives' values (rad or m) at places (2, n) in all poses, (poses, 2, n), and the least function of each,
        (poses, n)."""
        found = self._everywhere(at)
        known = dict(zip(self.inverse.rows, found, strict=False))  # the rooms of platforms stand behind them
        values = []
        for k, drive in enumerate(self.inverse.drives):
            if self.inverse.turns(drive):
                angle = np.arctan2(*(known[DriveValue(drive, part)] for part in ("sin", "cos")))
                values.append(self.box.low[k] + (angle - self.box.low[k]) % (2 * np.pi))
            else:
                values.append(known[DriveValue(drive, "travel")])
        return np.stack(values, axis=1), self._least(self._functions(found))

    @cached_property
    def _stage(self) -> Stage:
        program = self.inverse.program
        return Stage(program.block, self.sheet.parameters, range(len(program.outputs)), BOXES)

    def forms(self, middle: Array, half: Array, branch: Rows) -> tuple[AffineForm, Rows]:
        """The functions over squares about ``middle`` (2, n) of ``half`` their sides (n,), each in one branch (n,) by
        its number, as linear forms of coordinates from -1 to 1: arrays (functions, sets), of sets of poses that hold
        all of the branch; and of which square each set is. They hold for the places of a square at which a pose
        exists."""
        parts, of = [np.empty((4, len(self.rows), 0))], [np.empty(0, dtype=np.intp)]
        for start in range(0, half.size, BLOCK):
            some = slice(start, start + BLOCK)
            rows, square = self._block(middle[:, some], half[some], branch[some])
            parts.append(rows)
            of.append(start + square)
        return AffineForm(*np.concatenate(parts, axis=2)), np.concatenate(of)

    def rooms(self, middle: Array, half: Array, branch: Rows) -> tuple[AffineForm, Rows]:
        """The rooms of platforms alone, over squares: (triads, sets), and of which square each set is."""
        sets = self._sets(middle, half, branch)
        parts = [np.empty((4, 0, sets.of.size)), *(one.parts(sets.of.size)[:, None] for one in sets.rooms)]
        return AffineForm(*np.concatenate(parts, axis=1)), sets.of

    def _sets(self, middle: Array, half: Array, branch: Rows) -> Sets:
        zero = np.zeros_like(half)
        x = [AffineForm(middle[0], half, zero), AffineForm(middle[1], zero, half)]
        with np.errstate(all="ignore"):
            return self.platforms.over([*x, *(AffineForm(row, zero, zero) for row in self.branches[branch].T)])

    def _block(self, middle: Array, half: Array, branch: Rows) -> tuple[Array, Rows]:
        with np.errstate(all="ignore"):
            sets = self._sets(middle, half, branch)
            rows = [*self._stage(sets.x.__getitem__), *sets.rooms]
            forms = [self._mixed(rows, coefficients) for coefficients in self.rows]
        found = np.stack([one.parts(sets.of.size) for one in forms], axis=1)
        return (found, sets.of) if self.poses_each == 1 else self._merge_pieces(found, sets)

    def _merge_pieces(self, parts: Array, sets: Sets) -> tuple[Array, Rows]:
        """Sets of poses from their pieces, (4, functions, pieces): what holds all of these but those with a negative
        function, which the mode doesn't reach; where it has such, no pose of the set is sure."""
        low, high = AffineForm(*parts).bounds
        dead = (high < 0).any(axis=0)
        alive = np.flatnonzero(~dead)
        alive = alive[np.argsort(sets.number[alive], kind="stable")]
        first = np.flatnonzero(np.diff(sets.number[alive], prepend=-1))
        found = parts[:, :, alive[first]]
        several, groups = np.flatnonzero(np.diff(first, append=alive.size) > 1), len(self.inverse.groups)
        rooms = slice(groups, groups + len(sets.rooms))
        if several.size:
            own = found[:, rooms, several]
            low, high = (
                np.minimum.reduceat(low[:, alive], first, axis=1),
                np.maximum.reduceat(high[:, alive], first, axis=1),
            )
            known = np.isfinite(low) & np.isfinite(high)
            low, high = np.where(known, low, 0.0)[:, several], np.where(known, high, 0.0)[:, several]
            rest = (high - low) / 2 * (1 + FEW) + FEW * np.abs(low + high)
            zero = np.zeros_like(rest)
            found[:, :, several] = [(low + high) / 2, zero, zero, np.where(known[:, several], rest, np.inf)]
            found[:, rooms, several] = own
        doubtful = np.isin(sets.number[alive[first]], sets.number[dead])
        found[:, rooms, doubtful] = UNKNOWN
        return found, sets.of[alive[first]]

    def _mixed(self, rows: list[AffineForm], coefficients: Array) -> AffineForm:
        total = AffineForm(float(coefficients[-1]))
        for k in np.flatnonzero(coefficients[:-1]):
            total = total + rows[k] * AffineForm(float(coefficients[k]))
        return total
