"""The coordinates of a tree's joints over a motion, as MuJoCo's qpos has them, and which drive acts on which."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.exports.mjcf.tree import Hold, JointTree
from linkwright.kernels import Compiled
from linkwright.results import Run
from linkwright.structure import FRAME

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TreeDrive:
    """A drive on a joint of the tree; ``sign`` times its value is the joint's coordinate."""

    drive: str
    hold: Hold
    sign: int


def motors(compiled: Compiled, tree: JointTree) -> list[TreeDrive]:
    """The drives on their joints."""
    topology, found = compiled.structure.topology, []
    for name, drive in compiled.mechanism.movers.items():
        c = topology.acting(name)[0]
        hold = tree.joint_between(c.joint, c.a, c.b)
        assert hold is not None
        # A slide's coordinate is its travel, from the first link's point to the second's.
        ahead = hold.child == drive.link if hold.turns else c.b == drive.link
        found.append(TreeDrive(name, hold, 1 if ahead else -1))
    return found


def coordinates(run: Run, holds: Sequence[Hold], driven: Sequence[TreeDrive], t: Array) -> tuple[Array, Array]:
    """Each joint's coordinate and rate at times ``t``, (joints, times), rad and rad/s or m and m/s.

    Of a pin it is the child's angle less the parent's, of a slide its travel. Angles are continuous; they start in
    -pi..pi, that of a drive at its value.
    """
    parts = [_parts(hold, driven) for hold in holds]
    names = list(dict.fromkeys(name for part in parts for name in part))
    values, rates = run.rates(names, np.append(run.start, t)) if names else (np.empty((0, t.size + 1)),) * 2
    weights = np.array([[part.get(name, 0) for name in names] for part in parts]).reshape(len(holds), len(names))
    q, v = weights @ values, weights @ rates
    for row, part in zip(q, parts, strict=True):
        if any(name.endswith(".angle") and name.partition(".")[0] in run.compiled.mechanism.links for name in part):
            row += math.remainder(row[0], 2 * math.pi) - row[0]
    return q[:, 1:], v[:, 1:]


def _parts(hold: Hold, driven: Sequence[TreeDrive]) -> Mapping[str, int]:
    """The signals whose sum is a joint's coordinate, each with its sign."""
    if not hold.turns:
        return {f"{hold.joint}.s": 1}
    motor = next((m for m in driven if m.hold == hold), None)
    if motor is not None:
        return {f"{motor.drive}.angle": motor.sign}
    return {f"{link}.angle": sign for link, sign in ((hold.child, 1), (hold.parent, -1)) if link != FRAME}
