"""What the joints do by linkwright's solver, against which functions are held."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from linkwright.exports.process_simulate.joints import ToolJoint
from linkwright.exports.process_simulate.linkage import MM
from linkwright.exports.process_simulate.reach import Reach
from linkwright.exports.process_simulate.trees import Array
from linkwright.kernels import Compiled
from linkwright.results import Run
from linkwright.structure import FRAME
from linkwright.studies.sweep import sweeping

STEPS = 720


@dataclass
class Motion:
    """A mechanism moved by one drive alone over its reach. ``sign`` is +1 where the driving joint counts as the drive
    does, ``unit`` what it counts in (rad, or m in mm), ``told`` the dependent joints that have functions."""

    compiled: Compiled
    drive: str
    reach: Reach
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

    def of_drive(self, value: Array) -> Array:
        """The driving joint's values from those of the drive."""
        return np.asarray(self.sign * (value - self.reach.zero) * self.unit)

    def poses(self, steps: int) -> Array:
        """Values of the driving joint (rad or mm), ascending, with both ends of the reach and the zero pose."""
        low, high = self.hull
        every = np.unique([*np.linspace(low, high, steps + 1), self.reach.low, self.reach.high, self.reach.zero])
        return np.sort(self.of_drive(every))

    def values(self, joints: Sequence[ToolJoint], poses: Array) -> Array:
        """The joints' values since the zero pose (rad or mm), as the tool counts them: (joints, poses)."""
        every = self.between(joints, np.append(self.sign * poses / self.unit + self.reach.zero, self.reach.zero))
        signs = np.array([j.sign for j in joints])[:, None]
        return np.asarray(signs * (every[:, :-1] - every[:, -1:]))

    def at_zero(self, joint: ToolJoint) -> float:
        """A joint's value at the zero pose, of the child less the parent (rad or mm)."""
        return float(self.between([joint], np.array([self.reach.zero]))[0, 0])

    def between(self, joints: Sequence[ToolJoint], drive: Array) -> Array:
        """The child's angle (rad) or slide (mm) less the parent's at values of the drive: (joints, values)."""
        links = [link for link in self.compiled.mechanism.links if link != FRAME]
        slides = [j.of for j in joints if j.kind == "D"]
        names = [*(f"{link}.angle" for link in links), *(f"{slide}.s" for slide in slides)]
        rows = dict(
            zip([*links, *names[len(links) :]], self.run.evaluate(names, drive - self.reach.start), strict=True)
        )
        rows[FRAME] = np.zeros(drive.size)
        found = []
        for j in joints:
            if j.kind == "T":
                found.append(rows[j.child] - rows[j.parent])
            else:
                first = self.compiled.mechanism.joints[j.of].links[0]
                found.append(rows[f"{j.of}.s"] * (MM if first == j.parent else -MM))
        return np.array(found).reshape(len(joints), drive.size)
