"""How well a mechanism with two drives works over its workspace: maps of one sheet, and where it is singular.

J is d(x, y)/d(drives) of the working point. All figures but the transmission angle follow from it; they are static,
of a mechanism without weight and friction, whose drives exert J^T F on what the point presses with the force F (N).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.expressions import units as u
from linkwright.expressions.units import Dimension
from linkwright.graph.rows import Determinant, reaches
from linkwright.kernels import KERNELS, Compiled
from linkwright.kernels.kernel_selection import choose
from linkwright.model.mechanism import Mechanism
from linkwright.studies.workspace.curves import Segments
from linkwright.studies.workspace.maps import Maps, mapped
from linkwright.studies.workspace.mesh import DriveBox
from linkwright.studies.workspace.sheet import ModeSheet

Array = NDArray[np.float64]

STEPS = 200


@dataclass(frozen=True)
class QualityTask:
    """What the drives and the point have to do, SI; what is None has no map.

    ``speeds`` are the drives' speed limits (rad/s or m/s), ``efforts`` those of their torques or forces; ``force`` is
    the force (x, y) of the point on the work, in the fixed frame, or one number: its size, in whatever direction.
    """

    speeds: tuple[float, float] | None = None
    efforts: tuple[float, float] | None = None
    force: tuple[float, float] | float | None = None


@dataclass(frozen=True)
class Locus:
    """Where a sheet is singular: ``kind`` is ``limit-position`` (limit position of the output: the determinant of
    d(x, y)/d(drives) vanishes, in some direction the point can't move) or ``uncertain`` (uncertain position: the
    determinant of a group's closure vanishes, the drives don't hold the mechanism). Pieces from end to end: ``drives``
    (2, 2, n) and ``at`` (2, 2, n): coordinate, end, piece."""

    kind: str
    drives: Array
    at: Array


@dataclass(frozen=True)
class Quality:
    """The maps of one sheet and the loci of its singularities."""

    sheet: ModeSheet
    maps: Maps
    loci: tuple[Locus, ...]


def quality(
    sheet: ModeSheet,
    box: DriveBox,
    task: QualityTask | None = None,
    steps: int = STEPS,
    segments: Sequence[Segments] = (),
) -> Quality:
    """The maps of a sheet on ``steps`` equal steps of each drive; ``segments`` are its curves, as a region has them.

    | map | is |
    |---|---|
    | ``condition`` | the condition number of J, 1 at best; where one drive turns and the other slides, of J with the one that turns counted in lengths of arc at the mechanism's largest link |
    | ``manipulability`` | the size of J's determinant |
    | ``transmission`` | the least transmission angle of all groups: the arc sine of their normalised determinants |
    | ``speed``, ``speed any way`` | the largest speed of the point within the drives' speed limits: in the best direction, and in the worst |
    | ``force``, ``force any way`` | the largest force of the point within the drives' effort limits: likewise |
    | ``effort DRIVE`` | of the task's force: the drive's torque or force, with its sign; of its size alone, the largest of any direction |
    """  # noqa: E501
    measuring = _Measuring(sheet, task or QualityTask(), (steps + 1) ** 2)
    maps = mapped(sheet.compiled.quantities, box, steps, measuring, measuring.kinds)
    return Quality(sheet, maps, loci(sheet, segments))


LOCI = {"singular": "limit-position", "modes": "uncertain", "pins": "uncertain"}
"""The kinds of curves that are singular, by the determinant that vanishes."""


def loci(sheet: ModeSheet, segments: Sequence[Segments]) -> tuple[Locus, ...]:
    """The singular ones of a sheet's curves, by their kind."""
    found = []
    for one in segments:
        if one.kind in LOCI and one.a.size:
            drives = np.stack([one.a, one.b], axis=1)
            at = sheet.place(drives.reshape(2, -1))[0].reshape(2, 2, -1)
            found.append(Locus(LOCI[one.kind], drives, at))
    return tuple(found)


def kinds(compiled: Compiled, task: QualityTask) -> dict[str, Dimension]:
    """The maps that there are for a task, and their dimensions."""
    absent = set() if compiled.structure.groups else {"transmission"}
    absent |= {"speed", "speed any way"} if task.speeds is None else set()
    absent |= {"force", "force any way"} if task.efforts is None else set()
    absent |= {f"effort {name}" for name in compiled.graph.drives} if task.force is None else set()
    return {name: dimension for name, dimension in possible(compiled.mechanism).items() if name not in absent}


def possible(mechanism: Mechanism) -> dict[str, Dimension]:
    """The maps that there may be, whatever the task, and their dimensions."""
    turning = {drive: bool(mechanism.prescribed(drive).turns) for drive in mechanism.drives}
    area = u.LENGTH.times(u.LENGTH)
    for turns in turning.values():
        area = area if turns else area.times(u.LENGTH, -1)
    found = {"condition": u.PURE, "manipulability": area, "transmission": u.ANGLE}
    found |= {"speed": u.SPEED, "speed any way": u.SPEED, "force": u.FORCE, "force any way": u.FORCE}
    return found | {f"effort {name}": u.TORQUE if turns else u.FORCE for name, turns in turning.items()}


def better(name: str, values: Array) -> Array:
    """Of a map's values how good they are: the larger, the better."""
    if name.startswith("effort "):
        return -np.abs(values)
    return -values if name == "condition" else values


def _turns(compiled: Compiled, drive: str) -> bool:
    return bool(compiled.mechanism.prescribed(drive).turns)


class _Measuring:
    """All figures at drive values, from one run of one program."""

    def __init__(self, sheet: ModeSheet, task: QualityTask, poses: int) -> None:
        self.sheet, self.task = sheet, task
        graph, structure, point = sheet.compiled.graph, sheet.compiled.structure, sheet.point
        self.closed = reaches(structure)
        determinants = [Determinant(group.label) for group in structure.groups]
        program = graph.program([*(f"{point}.{row}" for row in ("x", "y", "vx", "vy")), *self.closed, *determinants])
        self.engine = KERNELS[choose(program, 2 * poses).kernel](program)
        self.rows = [graph.drives.index(drive) * graph.width for drive in sheet.drives]
        turns = [_turns(sheet.compiled, drive) for drive in sheet.drives]
        self.arms = np.where(turns, graph.size, 1.0) if any(turns) and not all(turns) else np.ones(2)
        self.kinds = kinds(sheet.compiled, self.task)

    def __call__(self, q: Array) -> dict[str, Array]:
        """All figures at drive values (2, n)."""
        n, count = q.shape[1], len(self.closed)
        x = self.sheet.inputs(np.concatenate([q, q], axis=1))
        x[self.rows[0] + 1, :n] = x[self.rows[1] + 1, n:] = 1.0
        with np.errstate(all="ignore"):
            y = self.engine.run(x, self.sheet.parameters)
            outside = ~(y[4 : 4 + count, :n] > 0).all(axis=0)
            first, second = y[2:4, :n], y[2:4, n:]
            found = {"x": y[0, :n], "y": y[1, :n], **self._jacobian_measures(first, second)}
            if "transmission" in self.kinds:
                found["transmission"] = np.arcsin(np.minimum(np.abs(y[4 + count :, :n]).min(axis=0), 1.0))
        return {name: np.where(outside, np.nan, row) for name, row in found.items()}

    def _jacobian_measures(self, a: Array, b: Array) -> dict[str, Array]:
        """What follows from the two columns of J, (2, n) each."""
        determinant = np.abs(a[0] * b[1] - a[1] * b[0])
        found = {"condition": _condition(a / self.arms[0], b / self.arms[1]), "manipulability": determinant}
        if self.task.speeds is not None:
            found["speed"], found["speed any way"] = _reached(a * self.task.speeds[0], b * self.task.speeds[1])
        if self.task.efforts is not None:
            # Forces are related to efforts by the inverse of J's transpose, whose columns are these.
            one = np.stack([b[1], -b[0]]) * self.task.efforts[0] / determinant
            two = np.stack([-a[1], a[0]]) * self.task.efforts[1] / determinant
            found["force"], found["force any way"] = _reached(one, two)
        force = self.task.force
        if force is not None:
            for drive, column in zip(self.sheet.drives, (a, b), strict=True):
                if isinstance(force, tuple):
                    found[f"effort {drive}"] = column[0] * force[0] + column[1] * force[1]
                else:
                    found[f"effort {drive}"] = np.hypot(*column) * force
        return found


def _condition(a: Array, b: Array) -> Array:
    """The condition number of matrices of two columns: with s = |J|^2 (Frobenius) and d = |det J| the singular values
    have the sum of squares s and the product d."""
    s, d = (a * a + b * b).sum(axis=0), np.abs(a[0] * b[1] - a[1] * b[0])
    apart = np.hypot(((a - b) * (a + b)).sum(axis=0), 2 * (a * b).sum(axis=0))  # the difference of their squares
    return np.asarray((s + apart) / (2 * d))


def _reached(a: Array, b: Array) -> tuple[Array, Array]:
    """Of all c a + d b with c and d within -1 .. 1: the greatest length, and that which is reached in every direction.

    They fill a parallelogram, whose farthest points are its corners, its nearest on its sides.
    """
    area = np.abs(a[0] * b[1] - a[1] * b[0])
    most = np.maximum(np.hypot(*(a + b)), np.hypot(*(a - b)))
    return most, area / np.maximum(np.hypot(*a), np.hypot(*b))
