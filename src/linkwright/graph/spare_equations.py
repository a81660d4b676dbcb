"""Which equations of a redundant mechanism can be left out: those that the states of self-stress reach.

With the Jacobian J of all joints and drives at a pose, J^T r = 0 has as many independent solutions r, the states of
self-stress, as there are equations too many. Equations may be left out where the states are told apart by their forces
there: then those that are left have the full rank (the dual of a basis of a matroid). Joints are preferred whole, the
last in the file first, and of pins that direction in which a link with two joints holds nothing but their distance.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.elements.joint import kind
from linkwright.elements.part_of_joint import PartOfJoint, PinAcross, SlideAcross, SlideParallel
from linkwright.graph.constraints import Constraints
from linkwright.graph.statics import Statics
from linkwright.structure import Release

Array = NDArray[np.float64]

CLEAR = 0.2
"""The least force in the states of self-stress that an equation may have to be left out, over its largest one along the
motion: it stays clear of zero."""
SMALL = 1e-3
"""The least of these forces over the clearest one of all equations: in a lift of many stages those of a guide are small
everywhere."""
NOTHING = 1e-6
"""Forces below this in a state of self-stress of size 1 are none."""
WHOLE_FIRST = 3
"""How many orders of preference are tried."""


@dataclass
class Candidate:
    """A release and the rows of its whole closure in the system."""

    release: Release
    rows: list[int]

    @property
    def count(self) -> int:
        """How many of the system's equations it leaves out."""
        return min(self.release.rows, len(self.rows))

    def weights(self, system: Constraints, z: Array) -> Array:
        """The released equations as combinations of the system's rows: (equations, rows)."""
        found = np.zeros((self.count, len(system.rows)))
        bodies = system.bodies(self.release.links, z)
        multipliers = np.array(self.release.multipliers(system.geometry, bodies), dtype=float)
        # The direction of a slide that closes a loop of slides, its first equation, isn't one of the system's.
        found[:, self.rows] = multipliers[-self.count :, -len(self.rows) :]
        return found

    def kept(self, system: Constraints, z: Array) -> Array:
        """What is kept of these rows: (equations, rows)."""
        own = self.weights(system, z)[:, self.rows]
        left = np.linalg.svd(own)[2][len(own) :]
        found = np.zeros((len(left), len(system.rows)))
        found[:, self.rows] = left
        return found


class SpareEquations:
    """The candidates of a whole mechanism's ``system``, whose drives are held, at some poses; what is left out has
    forces of at least ``least`` in the states of self-stress there."""

    def __init__(self, system: Constraints, poses: Sequence[Array], least: float = NOTHING) -> None:
        self.system, self.poses, self.least = system, list(poses), least
        self.topology, self.geometry = system.topology, system.geometry

    @cached_property
    def stresses(self) -> list[Array]:
        """The states of self-stress at each pose, orthonormal: (rows, states)."""
        return [Statics(self.system, z, {}).self_stresses for z in self.poses]

    @cached_property
    def states(self) -> int:
        """The least number of states at a pose: at special ones there may be more."""
        return min(int(stress.shape[1]) for stress in self.stresses)

    @property
    def on_drives(self) -> float:
        """The largest force of a drive in a state of self-stress; none where the mechanism can move."""
        first = len(self.system.names)
        return max(float(np.abs(stress[first:]).max(initial=0.0)) for _, stress in self.generic)

    @property
    def generic(self) -> list[tuple[Array, Array]]:
        """The poses that have the fewest states, with these."""
        every = zip(self.poses, self.stresses, strict=True)
        return [(z, stress) for z, stress in every if stress.shape[1] == self.states]

    def choose(self, candidates: Sequence[Candidate]) -> list[Candidate] | None:
        """The first candidates that tell all states apart; ``None`` where they don't."""
        places = self.generic
        # Of each candidate and pose the forces in its equations: (equations, states).
        forces = [[one.weights(self.system, z) @ stress for z, stress in places] for one in candidates]
        chosen: list[Candidate] = []
        taken: set[tuple[str, str]] = set()
        while sum(one.count for one in chosen) < self.states:
            along = [[_least(part) for part in of] for of in forces]
            clear = [min(of, default=0.0) for of in along]
            best = max(clear, default=0.0)
            if best < self.least:
                return None
            steady = (i for i, of in enumerate(along) if clear[i] >= max(CLEAR * max(of, default=0.0), SMALL * best))
            i = next(steady, clear.index(best))
            chosen.append(candidates[i])
            taken |= {(candidates[i].release.joint, link) for link in candidates[i].release.links[1:]}
            # What the others tell besides: their forces less those in the states that are told already.
            for k in range(len(places)):
                basis = np.linalg.qr(forces[i][k].T)[0]
                for of in forces:
                    of[k] = of[k] - of[k] @ basis @ basis.T
            for of, one in zip(forces, candidates, strict=True):
                if any((one.release.joint, link) in taken for link in one.release.links[1:]):
                    of[:] = [np.zeros_like(part) for part in of]
        return chosen

    def clear_of_zero(self, chosen: Sequence[Candidate]) -> bool:
        """Whether the forces in the equations left out tell the states apart between the poses too: the determinant of
        the Jacobian beside these equations, which is zero with them, keeps its sign."""
        signs = set()
        for z in self.poses:
            left_out = np.concatenate([one.weights(self.system, z) for one in chosen])
            matrix = np.concatenate([self.system.jacobian(z), left_out.T], axis=1)
            signs.add(float(np.linalg.slogdet(matrix)[0]))
        return len(signs) == 1

    # Candidates.

    def orders(self) -> Iterator[list[Candidate]]:
        """All candidates, in several orders of preference."""
        whole, slides, bars, pins = (list(of) for of in (self.whole(), self.slides(), self.bars(), self.pins()))
        every = [whole, slides, bars, pins]
        yield [one for of in every for one in of]
        yield [one for of in (whole[::-1], slides, bars[::-1], pins) for one in of]
        yield [one for of in (bars, whole, slides, pins) for one in of]

    def whole(self) -> Iterator[Candidate]:
        """Joints but pins, whole, the last in the file first."""
        for c in reversed(self.topology.but_pins):
            if c.joint not in self.driven and (rows := self._rows(c.joint)):
                yield Candidate(Release(c.joint, c.kind, c.links), rows)

    def slides(self) -> Iterator[Candidate]:
        """Slides of which one equation is kept."""
        for c in reversed(self.topology.but_pins):
            rows = self._rows(c.joint)
            if c.kind.parallel and c.joint not in self.driven and len(rows) == c.rows:
                for part in (SlideAcross(), SlideParallel()):
                    yield Candidate(Release(c.joint, c.kind, c.links, part), rows)

    def bars(self) -> Iterator[Candidate]:
        """Pins of links with two joints, which hold their distance no more; those of links that drives move last, as
        these give the motion to the others."""
        moved = {mover.link for mover in self.topology.mechanism.movers.values()}
        found = [
            (own in moved, one)
            for joint, link, first in self._pinned()
            for own in (link, first)
            if len(self._joint_points(own)) == 2
            for one in self._across(joint, (first, link), own, False)
        ]
        for last in (False, True):
            yield from (one for of_drive, one in found if of_drive is last)

    def pins(self) -> Iterator[Candidate]:
        """Pins whole, then without what they hold along some direction or across it."""
        for joint, link, first in self._pinned():
            yield Candidate(Release(joint, kind("revolute"), (first, link)), self._rows(joint, link))
        for joint, link, first in self._pinned():
            for own in (link, first):
                for turned in (False, True):
                    yield from self._across(joint, (first, link), own, turned)

    def _across(self, joint: str, links: tuple[str, str], own: str, turned: bool) -> Iterator[Candidate]:
        points = self._joint_points(own)
        at = self.geometry.pin_point(joint, own)
        far = max(points, key=lambda point: float(self.geometry.point(own, point).minus(at).length), default=None)
        if far is None or float(self.geometry.point(own, far).minus(at).length) < NOTHING * self.system.size:
            return
        part: PartOfJoint = PinAcross(own, far, turned)
        yield Candidate(Release(joint, kind("revolute"), links, part), self._rows(joint, links[1]))

    def _pinned(self) -> Iterator[tuple[str, str, str]]:
        """Pins with a link that may be taken off, the last first, and the first link there."""
        for pin in reversed([*self.topology.pins.values()]):
            for link in reversed(pin.links[1:]):
                if frozenset((pin.links[0], link)) not in self.turned:
                    yield pin.name, link, pin.links[0]

    def _joint_points(self, link: str) -> list[str]:
        """The points of a link at which it has joints."""
        found = {pin.point(link): None for pin in self.topology.pins.values() if link in pin.links}
        points = self.topology.mechanism.links[link].points
        for _, joint in self.topology.mechanism.joints_but_pins():
            if link in joint.links:
                found |= {point: None for point in joint.joint_points if point in points}
        return [*found]

    @cached_property
    def driven(self) -> frozenset[str]:
        """The joints in which drives act, or give the motion."""
        names = self.topology.mechanism.movers
        every = (c for name in names for c in (*self.topology.acting(name), *self.topology.drivable_joints(name)))
        return frozenset(c.joint for c in every)

    @cached_property
    def turned(self) -> frozenset[frozenset[str]]:
        """The pairs of links that drives turn on each other."""
        m = self.topology.mechanism
        entries = (one for name, own in m.movers.items() for one in (own, m.prescribed(name)))
        return frozenset(frozenset((one.link, one.on)) for one in entries if one.turns)

    def _rows(self, joint: str, link: str = "") -> list[int]:
        return self._index.get((joint, link), [])

    @cached_property
    def _index(self) -> dict[tuple[str, str], list[int]]:
        """The system's rows of each joint, of a pin those of each link but its first."""
        found: dict[tuple[str, str], list[int]] = {}
        names, row = self.system.names, 0
        for pin in self.topology.pins.values():
            for link in pin.links[1:]:
                found[pin.name, link] = [row, row + 1]
                row += 2
        while row < len(names):
            found.setdefault((names[row], ""), []).append(row)
            row += 1
        return found


def kept_rows(system: Constraints, z: Array, chosen: Sequence[Candidate]) -> Array:
    """The equations that are left, as combinations of the system's rows: (equations, rows)."""
    touched = {row for one in chosen for row in one.rows}
    others = np.eye(len(system.rows))[[row for row in range(len(system.rows)) if row not in touched]]
    return np.concatenate([others, *(one.kept(system, z) for one in chosen)])


def _least(forces: Array) -> float:
    """The smallest singular value of some rows."""
    return float(np.linalg.svd(forces, compute_uv=False)[-1]) if forces.size and len(forces) <= forces.shape[1] else 0.0
