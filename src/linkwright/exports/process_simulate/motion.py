"""What the joints do by linkwright's solver, against which functions are held."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field

import numpy as np

from linkwright.data_classes import dataclass
from linkwright.exports.process_simulate.joints import ToolJoint
from linkwright.exports.process_simulate.linkage import MM
from linkwright.exports.process_simulate.reach import DriveReach
from linkwright.exports.process_simulate.trees import Array
from linkwright.kernels import Compiled
from linkwright.results import Run
from linkwright.structure import FRAME, Group, Structure
from linkwright.studies.drive_sweep import sweeping

STEPS = 720


@dataclass
class ToolMotion:
    """A mechanism moved by one drive alone over its reach; ``joint`` is the tool's driving joint, here the one that the
    drive moves. ``sign`` is +1 where that counts as the drive does, ``unit`` what it counts in (rad, or m in mm),
    ``told`` the dependent joints that have functions."""

    compiled: Compiled
    drive: str
    reach: DriveReach
    joint: ToolJoint
    sign: float
    told: list[ToolJoint] = field(default_factory=list)

    def __post_init__(self) -> None:
        start, (low, high) = self.reach.start, self.hull
        self.run = Run(sweeping(self.compiled, self.drive), low - start, high - start, STEPS)
        self.unit = MM if self.joint.kind == "D" else 1.0

    @property
    def hull(self) -> tuple[float, float]:
        """The drive's values (rad or m) between which all is looked at: the reach, with the zero pose."""
        return min(self.reach.low, self.reach.zero), max(self.reach.high, self.reach.zero)

    @property
    def limits(self) -> tuple[float, float]:
        """The driving joint's limits (rad or mm)."""
        ends = sorted(self.of_drive(np.array([self.reach.low, self.reach.high])))
        return float(ends[0]), float(ends[1])

    @property
    def turned_round(self) -> bool:
        """Whether another joint than the one that the drive moves is the driving one."""
        return False

    @property
    def solved(self) -> tuple[Structure, Mapping[Group, float]]:
        """How the mechanism is solved where the driving joint is known: its steps, and the branches of its dyads."""
        return self.compiled.structure, self.compiled.assembly.branches

    @property
    def origin(self) -> float:
        """The driving joint's value at the zero pose as the drive counts it (rad or m)."""
        return self.reach.zero

    def of_drive(self, value: Array) -> Array:
        """The driving joint's values from those of the drive."""
        return np.asarray(self.sign * (value - self.reach.zero) * self.unit)

    def to_drive(self, poses: Array) -> Array:
        """The drive's values (rad or m) from those of the driving joint."""
        return np.asarray(self.sign * poses / self.unit + self.reach.zero)

    def poses(self, steps: int) -> Array:
        """Values of the driving joint (rad or mm), ascending, with both ends of the reach and the zero pose."""
        low, high = self.hull
        every = np.unique([*np.linspace(low, high, steps + 1), self.reach.low, self.reach.high, self.reach.zero])
        return np.sort(self.of_drive(every))

    def values(self, joints: Sequence[ToolJoint], poses: Array) -> Array:
        """The joints' values since the zero pose (rad or mm), as the tool counts them: (joints, poses)."""
        return self.since_zero(joints, self.to_drive(poses))

    def since_zero(self, joints: Sequence[ToolJoint], drive: Array) -> Array:
        """The same at values of the drive."""
        every = self.between(joints, np.append(drive, self.reach.zero))
        signs = np.array([j.sign for j in joints])[:, None]
        return np.asarray(signs * (every[:, :-1] - every[:, -1:]))

    def at_zero(self, joint: ToolJoint) -> float:
        """A joint's value at the zero pose, of the child less the parent (rad or mm)."""
        return float(self.between([joint], np.array([self.reach.zero]))[0, 0])

    def between(self, joints: Sequence[ToolJoint], drive: Array) -> Array:
        """The child's angle (rad) or slide (mm) less the parent's at values of the drive: (joints, values)."""
        names = self._names(joints)
        return self._differences(joints, names, self.run.evaluate(names, drive - self.reach.start))

    def rates(self, joints: Sequence[ToolJoint], drive: Array) -> Array:
        """How fast they change with the drive (rad or mm each rad or m), as the tool counts them: (joints, values)."""
        names = self._names(joints)
        slopes = self.run.rates(names, drive - self.reach.start)[1]
        return np.array([j.sign for j in joints])[:, None] * self._differences(joints, names, slopes)

    def _names(self, joints: Sequence[ToolJoint]) -> list[str]:
        links = [link for link in self.compiled.mechanism.links if link != FRAME]
        return [*(f"{link}.angle" for link in links), *(f"{j.of}.s" for j in joints if j.kind == "D")]

    def _differences(self, joints: Sequence[ToolJoint], names: list[str], rows: Array) -> Array:
        """Those of the links' angles, and the travels of slides (mm)."""
        known = {f"{FRAME}.angle": np.zeros(rows.shape[1:]), **dict(zip(names, rows, strict=True))}

        def joint_values(j: ToolJoint) -> Array:
            if j.kind == "T":
                return np.asarray(known[f"{j.child}.angle"] - known[f"{j.parent}.angle"])
            forward = self.compiled.mechanism.joints[j.of].links[0] == j.parent
            return np.asarray(known[f"{j.of}.s"] * (MM if forward else -MM))

        return np.array([joint_values(j) for j in joints]).reshape(len(joints), *rows.shape[1:])
