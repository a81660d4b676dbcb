"""Any joint as the one that all functions ask for: its motion by the model's own drive, turned round.

Where that joint goes one way only over the range, its value says where the drive stands. The functions follow from the
mechanism decomposed anew, with that joint driven; they are held to the motion of the model's own drive.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.exports.process_simulate.joints import ToolJoint
from linkwright.exports.process_simulate.linkage import Refused
from linkwright.exports.process_simulate.motion import ToolMotion
from linkwright.exports.process_simulate.reach import SHORTER, DriveReach, offered
from linkwright.exports.process_simulate.trees import Array
from linkwright.findings import Finding, Joined
from linkwright.graph.geometry import Geometry
from linkwright.graph.motion import Motion as Pose
from linkwright.graph.motion import solve_motion, solve_step
from linkwright.groups import Dyad
from linkwright.kernels import Compiled
from linkwright.notation import Body, Jet, Pair, Scalar
from linkwright.results.stationary import bracketed, crossings
from linkwright.structure import Group, Structure, decompose

PATH = ("exports", "process-simulate", "master")
KNOTS = 2000
"""Equal steps of the drive between which its value is looked for from the master's."""
STILL = 1e-7
"""A joint that moves by less (rad or mm) stands still."""
STEEP = 1e-3
"""A joint is offered as master where its rate stays above this share of the largest."""


@dataclass
class Mastered(ToolMotion):
    """The motion of a mechanism as it follows from a joint that its drive doesn't move directly."""

    @property
    def turned_round(self) -> bool:
        return True

    def of_drive(self, value: Array) -> Array:
        value = np.asarray(value, dtype=float)
        return np.where(value == self.reach.zero, 0.0, self.since_zero([self.joint], value)[0])

    def to_drive(self, poses: Array) -> Array:
        drive, master = self._knots
        at = np.clip(np.searchsorted(master, poses), 1, master.size - 1)

        def off(value: Array, row: NDArray[np.int_]) -> Array:
            return np.asarray(self.of_drive(value) - poses[row])

        found = bracketed(off, np.arange(poses.size), drive[at - 1], drive[at])
        return np.where(poses == 0.0, self.reach.zero, found)

    @cached_property
    def _knots(self) -> tuple[Array, Array]:
        """Values of the drive, and of the master, which ascend."""
        low, high = self.hull
        drive = np.unique([*np.linspace(low, high, KNOTS + 1), self.reach.zero])
        master = self.of_drive(drive)
        return (drive, master) if master[-1] > master[0] else (drive[::-1], master[::-1])

    def poses(self, steps: int) -> Array:
        """Those of equal steps of the drive, and of the master."""
        low, high = self.limits
        equal = np.linspace(min(low, 0.0), max(high, 0.0), steps + 1)
        return np.unique([*super().poses(steps), *equal[1:-1]])

    @property
    def origin(self) -> float:
        return self.at_zero(self.joint) / self.unit

    @cached_property
    def solved(self) -> tuple[Structure, Mapping[Group, float]]:
        return _driven_anew(self)


def mastered(
    compiled: Compiled,
    drive: str,
    joints: list[ToolJoint],
    master: ToolJoint,
    reach: DriveReach,
    asked: bool = False,
    stops: tuple[float, float] | None = None,
) -> tuple[Mastered, list[Finding]]:
    """The motion over a reach of the drive, which is cut where the master would turn back unless it was ``asked`` for,
    with a warning then; or between two ``stops`` of the master (rad or mm since the zero pose).

    Raises :class:`Refused` where the master's value doesn't say where the mechanism is.
    """
    if followers := compiled.mechanism.followers:
        raise Refused(Finding("functions.master-cam", PATH, {"joint": master.name, "drives": Joined(followers)}))
    around = replace(reach, low=reach.zero - 2 * np.pi, high=reach.zero + 2 * np.pi) if reach.full else reach
    motion = Mastered(compiled, drive, around, master, 1.0)
    data = {"joint": master.name, "others": Joined(_steady(compiled, drive, joints, reach, master)) or "-"}
    if np.ptp(motion.since_zero([master], np.linspace(*motion.hull, 181))) < STILL:
        raise Refused(Finding("functions.master-still", PATH, data))
    turns = crossings(lambda value: motion.rates([master], value)[0], *motion.hull, KNOTS)
    branch_range = _branch_range(motion, turns)
    here = data | _limit_position(motion, turns, branch_range)
    if turns.size and not branch_range[0] < reach.zero < branch_range[1]:
        raise Refused(Finding("functions.master-zero", PATH, here))
    if stops is not None:
        return _between(replace(motion, reach=_limited_reach(reach, branch_range)), stops), []
    if not turns.size:
        return replace(motion, reach=reach), []
    if asked:
        raise Refused(Finding("functions.master-turns", PATH, here))
    return replace(motion, reach=_limited_reach(reach, branch_range)), [
        Finding("functions.master-cut", PATH, here, severity="warning")
    ]


def _limit_position(motion: Mastered, turns: Array, branch_range: tuple[float, float]) -> dict[str, str]:
    """The limit position nearest to the zero pose, and the range around that without one, as data of a finding."""
    unit, size = motion.compiled.quantities.drive_unit(motion.drive)
    at = [f"{turns[np.abs(turns - motion.reach.zero).argmin()] / size:.8g}"] if turns.size else ["-"]
    return {"drive": motion.drive, "unit": unit, "at": at[0], **offered(branch_range, size)}


def _limited_reach(reach: DriveReach, ends: tuple[float, float]) -> DriveReach:
    return DriveReach(*ends, reach.zero, reach.start)


def _between(motion: Mastered, stops: tuple[float, float]) -> Mastered:
    low, high = motion.limits
    if not low <= stops[0] < stops[1] <= high:
        unit, size = ("deg", np.pi / 180) if motion.joint.kind == "T" else ("mm", 1.0)
        data = {"joint": motion.joint.name, "unit": unit, **offered((low, high), size)}
        raise Refused(Finding("functions.master-stops", (*PATH[:-1], "stops"), data))
    low, high = sorted(motion.to_drive(np.array(stops)).tolist())
    return replace(motion, reach=_limited_reach(motion.reach, (low, high)))


def _branch_range(motion: Mastered, turns: Array) -> tuple[float, float]:
    """The values of the drive around the zero pose between which the master goes one way, short of its limit
    positions;
    no room where the zero pose is at one."""
    (low, high), zero = motion.hull, motion.reach.zero
    below, above = turns[turns <= zero], turns[turns > zero]
    start, stop = below.max(initial=low), above.min(initial=high)
    off = SHORTER * (stop - start)
    return float(start + off * (below.size > 0)), float(stop - off * (above.size > 0))


def _steady(
    compiled: Compiled, drive: str, joints: list[ToolJoint], reach: DriveReach, master: ToolJoint
) -> Iterator[str]:
    """The names of the other joints that go one way, at no small rate, all over the range."""
    motion = ToolMotion(compiled, drive, reach, master, 1.0)
    others = [joint for joint in joints if joint != master and not joint.left_out]
    rates = motion.rates(others, np.linspace(*motion.hull, 361))
    for joint, row in zip(others, rates, strict=True):
        if max(row.min(), -row.max()) > STEEP * np.abs(row).max():
            yield joint.name


def _driven_anew(motion: ToolMotion) -> tuple[Structure, dict[Group, float]]:
    """The mechanism decomposed with its master driven, and the branches in which its dyads are at the zero pose."""
    compiled, joint, drive, zero = motion.compiled, motion.joint, motion.drive, motion.reach.zero
    way = {"T": "turns", "D": "slides"}[joint.kind]
    moved = {"turns": None, "slides": None, "extends": None, "output": None, way: joint.child, "on_": joint.parent}
    drives = {drive: compiled.mechanism.drives[drive].model_copy(update=moved)}
    structure = decompose(compiled.mechanism.model_copy(update={"drives": drives}))
    if structure.findings:
        raise Refused(Finding("functions.master-structure", PATH, {"joint": joint.name, "drive": drive}))

    geometry, own = Geometry(compiled.quantities, compiled.quantities.parameters), compiled.assembly.branches
    unknowns = motion.run.compiled.unknowns(zero - motion.reach.start)
    there = solve_motion(
        compiled.structure, geometry, {drive: Jet([zero])}, lambda group, _: own.get(group, 1.0), unknowns.__getitem__
    )
    size, found = compiled.assembly.size(), dict[Group, float]()

    def nearest(group: Group, dyad: Dyad) -> Scalar:
        """The branch by which the dyad's links come to lie where they are."""

        def off(branch: float) -> float:
            solved = dyad.solve(branch, 0)
            bodies = zip(group.meeting, (solved.first, solved.second), strict=True)
            return sum(_pose_distance(body, there.bodies[link], size) for link, body in bodies)

        found[group] = min((1.0, -1.0), key=off) if group.modes > 1 else 1.0
        return found[group]

    for group in structure.groups:
        pose = Pose(structure, geometry, 0, dict(there.bodies))
        solve_step(pose, group, {drive: Jet([motion.origin])}, nearest, unknowns.__getitem__)
    return structure, found


def _pose_distance(body: Body, other: Body, size: float) -> float:
    """How far two poses of a link are apart (m)."""
    origin = Pair(0.0, 0.0)
    moved, turned = body.point(origin).minus(other.point(origin)).now, body.axis.minus(other.axis).now
    return float(np.hypot(moved.x, moved.y) + size * np.hypot(turned.x, turned.y))
