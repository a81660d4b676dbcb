"""The joints' equations of a whole mechanism over the poses of its links, on plain numbers: no groups, no branches.

A pose is a row (x/size, y/size, angle in rad) of each moving link's origin, so lengths and angles weigh alike.
A pin states that its links' points coincide, a slide that its lines do (Nikravesh 1988, ch. 4).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.elements import STILL, Twist
from linkwright.elements.joint import Inner
from linkwright.graph.geometry import ZERO, Geometry
from linkwright.notation import Body, Jet, Pair, Vec
from linkwright.notation.angles import wrapped
from linkwright.notation.planar import unit_vector
from linkwright.structure import FRAME, Topology

Array = NDArray[np.float64]
T = TypeVar("T")

APART = 1e-6
"""By how much of the size links are put apart where an equation has no slope."""


@dataclass(frozen=True)
class FollowerRelation:
    """How a follower moves with its ``motor``: ``at`` gives its value (rad or m) and its derivative
    from the motor's value (rad); in steps of ``finest`` (rad) of this no piece of its law is passed over."""

    motor: str
    at: Callable[[float], tuple[float, float]]
    finest: float


def _gap(inner: Inner, bodies: Sequence[Body]) -> Sequence[Jet]:
    return inner.gap(*bodies)


class Constraints:
    """Residuals and slopes of all joints, of drives that are held and of followers that move with their motors;
    ``size`` is the unit of length (m).

    ``rows[k]`` names the joint or drive of residual k. Lengths come out over the size, directions as sines. The
    direction of a slide that closes a loop of slides follows from the others' and is left out, unless ``whole``.
    """

    def __init__(self, topology: Topology, geometry: Geometry, size: float, whole: bool = False) -> None:
        self.topology, self.geometry, self.size = topology, geometry, size
        self.links = topology.moving
        self.index = {link: i for i, link in enumerate((*topology.moving, FRAME))}  # the frame last
        self.width = 3 * len(self.links)
        self.held: Mapping[str, float] = {}
        self.relations: Mapping[str, FollowerRelation] = {}
        pins: list[tuple[str, str, str, Any, Any]] = []
        for pin in topology.pins.values():
            first = pin.links[0]
            at = {link: geometry.point(link, pin.point(link)) for link in pin.links}
            pins += [(pin.name, first, link, at[first], at[link]) for link in pin.links[1:]]
        lines = [self._line(name, *joint.links) for name, joint in topology.mechanism.prismatic_joints()]
        self.pins, self.lines = _Ends(self, pins), _Ends(self, [line[:5] for line in lines])
        self.headings = np.array([line[5] for line in lines], dtype=float).reshape(-1, 2).T
        others = (c for c in topology.but_pins if not c.kind.places)
        self.others = [(c, c.kind.inner(geometry, c.joint, c.links)) for c in others]
        names = [name for name in (*self.pins.names, *self.lines.names) for _ in range(2)]
        spare = () if whole else topology.closing_slides
        rows = [k for k, name in enumerate(names) if k % 2 or name not in spare]
        self.kept: Any = rows if spare else slice(None)
        self.names = [names[k] for k in rows] + [c.joint for c, _ in self.others for _ in range(c.rows)]

    def _line(self, joint: str, a: str, b: str) -> tuple[str, str, str, Any, Any, tuple[float, float]]:
        (first, _), (second, _) = (self.geometry.line(joint, link) for link in (a, b))
        angles = (float(self.geometry.heading_angle(joint, a)), float(self.geometry.heading_angle(joint, b)))
        return joint, a, b, first, second, angles

    @property
    def rows(self) -> tuple[str, ...]:
        """Whose each residual is."""
        return (*self.names, *self.held, *self.relations)

    def set_drive_values(
        self, drives: Mapping[str, float], relations: Mapping[str, FollowerRelation] | None = None
    ) -> None:
        """Add the equations of drives at these values (rad or m), and of followers that move with their motors."""
        self.held, self.relations = drives, relations or {}

    def pose(self, bodies: dict[str, Body]) -> Array:
        """The pose that some bodies have: (3 links,)."""
        rows = []
        for link in self.links:
            at, axis = bodies[link].point(ZERO).now, bodies[link].axis.now
            angle = bodies[link].angle if link in self.topology.wound else None  # which joints ask over whole turns
            turned = np.arctan2(float(axis.y), float(axis.x)) if angle is None else float(angle)
            rows.append([float(at.x) / self.size, float(at.y) / self.size, turned])
        return np.array(rows).ravel()

    def residual(self, z: Array) -> Array:
        """What each equation misses at a pose: (equations,)."""
        at = self._poses(z)
        gaps = self.pins.place(at, 0) - self.pins.place(at, 1)
        between, across = self._slides(at)
        followed = {n: relation.at(self.value(relation.motor, z))[0] for n, relation in self.relations.items()}
        driven = [self._missed(name, self.value(name, z) - value) for name, value in {**self.held, **followed}.items()]
        joints = np.concatenate([gaps.T.ravel(), np.stack([between, across], axis=1).ravel()])
        return np.concatenate([joints[self.kept], self._other_gaps(at), driven])

    def _other_gaps(self, at: Array) -> Array:
        """What the joints that are neither pins nor slides miss, lengths over the size."""
        found = []
        for c, inner in self.others:
            gaps = self._defined(partial(_gap, inner), self._bodies(c.links, at))
            found += [float(g.d[0]) / self._unit(unit) for g, unit in zip(gaps, c.kind.row_units, strict=True)]
        return np.array(found)

    def _other_slopes(self, at: Array) -> Array:
        """The slopes of these: (equations, 3 links)."""
        found = np.zeros((sum(c.rows for c, _ in self.others), self.width + 3))
        row = 0
        for c, inner in self.others:
            bodies = self._bodies(c.links, at)
            units = np.array([self._unit(unit) for unit in c.kind.row_units])
            for i, link in enumerate(c.links):
                about = bodies[i].anchor.now
                freedoms = Twist(0.0, about, Pair(self.size, 0.0)), Twist(0.0, about, Pair(0.0, self.size))
                for k, twist in enumerate((*freedoms, Twist(1.0, about, Pair(0.0, 0.0)))):
                    twists = [twist if j == i else STILL for j in range(len(bodies))]
                    rates = self._defined(partial(inner.rates, twists=twists), bodies)
                    found[row : row + c.rows, 3 * self.index[link] + k] = np.array(rates, dtype=float) / units
            row += c.rows
        return found

    def besides(self, z: Array, multipliers: Array) -> list[tuple[str, Array]]:
        """What comes with the multipliers of all equations (:meth:`linkwright.elements.joint.Inner.besides`), by joint:
        what it does to each link, forces (N) and moments over the size, (3 links,)."""
        at, found = self._poses(z), []
        row = len(self.names) - sum(c.rows for c, _ in self.others)
        for c, inner in self.others:
            bodies, last = self._bodies(c.links, at), row + c.rows
            # Equations over the size have forces as multipliers; others moments over the size.
            units = [self.size / self._unit(unit) for unit in c.kind.row_units]
            wrenches = inner.besides(bodies, (multipliers[row:last] * units).tolist())
            acting = np.zeros(self.width + 3)
            for link, body, wrench in zip(c.links, bodies, wrenches, strict=False):
                own = wrench.at(body.anchor.now)
                first = 3 * self.index[link]
                acting[first : first + 3] += np.array([*own.force, own.moment / self.size], dtype=float)
            if acting.any():
                found.append((c.joint, acting[: self.width]))
            row = last
        return found

    def _defined(self, ask: Callable[[list[Body]], Sequence[T]], bodies: list[Body]) -> Sequence[T]:
        """An answer of some links; where it isn't defined, as of the direction between centres that coincide, that of
        links a little apart. Only poses from which a solution is sought are such: no joint closes there."""
        try:
            return ask(bodies)
        except ZeroDivisionError:
            away = Vec.constant(Pair(APART * self.size, 0.0), 0)
            first = bodies[0]
            beside = Body(first.anchor.plus(away), first.local, first.axis, first.turn, first.angle)
            return ask([beside, *bodies[1:]])

    def _unit(self, unit: str) -> float:
        return self.size if unit == "length" else 1.0

    def bodies(self, links: Sequence[str], z: Array) -> list[Body]:
        """Some links at a pose, about their origins (m)."""
        return self._bodies(links, self._poses(z))

    def _bodies(self, links: Sequence[str], at: Array) -> list[Body]:
        """Some links in a pose, about their origins (m)."""
        poses = (at[:, self.index[link]].tolist() for link in links)
        return [
            Body(
                Vec.constant(Pair(x * self.size, y * self.size), 0),
                ZERO,
                Vec.constant(unit_vector(turn), 0),
                Jet(()),
                turn,
            )
            for x, y, turn in poses
        ]

    def _missed(self, drive: str, rest: float) -> float:
        """What a drive's value is off as a residual: angles without whole turns, lengths over the size."""
        return float(wrapped(np.asarray(rest))) if self._turns(drive) else rest / self.size

    def jacobian(self, z: Array) -> Array:
        """The slopes of the residuals: (equations, 3 links)."""
        at = self._poses(z)
        pins, lines = len(self.pins.names), len(self.lines.names)
        j = np.zeros((2 * (pins + lines), self.width + 3))
        for end, sign in ((0, 1.0), (1, -1.0)):
            row, column, arm = 2 * np.arange(pins), 3 * self.pins.index[end], self.pins.arm(at, end)
            j[row, column] = j[row + 1, column + 1] = sign
            j[row, column + 2], j[row + 1, column + 2] = -sign * arm[1], sign * arm[0]
        if lines:
            self._line_slopes(j[2 * pins :], at)
        driven = [self.gradient(name, z) for name in self.held]
        for name, relation in self.relations.items():
            slope = relation.at(self.value(relation.motor, z))[1] / (1.0 if self._turns(name) else self.size)
            driven.append(self.gradient(name, z) - slope * self.gradient(relation.motor, z))
        others = self._other_slopes(at)[:, : self.width]
        return np.concatenate([j[self.kept, : self.width], others, np.array(driven).reshape(-1, self.width)])

    def _line_slopes(self, j: Array, at: Array) -> None:
        a, b = self.lines.index
        turn_a, turn_b = at[2, a] + self.headings[0], at[2, b] + self.headings[1]
        u, row, cosine = np.array([np.cos(turn_a), np.sin(turn_a)]), 2 * np.arange(a.size), np.cos(turn_b - turn_a)
        j[row, 3 * a + 2], j[row, 3 * b + 2] = -cosine, cosine
        # across = (place b - place a) x' u, its normal turning with link a
        reach, arm = self.lines.place(at, 1) - at[:2, a], self.lines.arm(at, 1)
        for index, sign in ((a, -1.0), (b, 1.0)):
            j[row + 1, 3 * index], j[row + 1, 3 * index + 1] = -sign * u[1], sign * u[0]
        j[row + 1, 3 * a + 2] = -(reach[0] * u[0] + reach[1] * u[1])
        j[row + 1, 3 * b + 2] = arm[0] * u[0] + arm[1] * u[1]

    def _slides(self, at: Array) -> tuple[Array, Array]:
        a, b = self.lines.index
        turn = at[2, a] + self.headings[0]
        apart = self.lines.place(at, 1) - self.lines.place(at, 0)
        between = np.sin(at[2, b] + self.headings[1] - turn)
        return between, apart[1] * np.cos(turn) - apart[0] * np.sin(turn)

    def opposed(self, z: Array) -> bool:
        """Whether a slide's two lines point against each other, which its sine alone doesn't tell."""
        at = self._poses(z)
        a, b = self.lines.index
        return bool((np.cos(at[2, b] + self.headings[1] - at[2, a] - self.headings[0]) < 0).any())

    def _turns(self, drive: str) -> bool:
        return self.topology.mechanism.prescribed(drive).turns is not None

    def value(self, drive: str, z: Array) -> float:
        """A drive's value at a pose (rad, whole turns kept, or m)."""
        entry, at = self.topology.mechanism.prescribed(drive), self._poses(z)
        link, on = self.index[entry.link], self.index[entry.on]
        if self._turns(drive):
            return float(at[2, link] - at[2, on])
        ends, u = self._sliding(drive, at)
        return float((ends[0] - ends[1]) @ u) * self.size

    def gradient(self, drive: str, z: Array) -> Array:
        """The slope of a drive's value (rad, or lengths over the size): (3 links,)."""
        entry, at = self.topology.mechanism.prescribed(drive), self._poses(z)
        link, on = 3 * self.index[entry.link], 3 * self.index[entry.on]
        row = np.zeros(self.width + 3)
        if self._turns(drive):
            row[link + 2], row[on + 2] = 1.0, -1.0
            return row[: self.width]
        (tip, foot), u = self._sliding(drive, at)
        row[link : link + 2], row[on : on + 2] = u, -u
        # The direction is that of `on`'s line, which turns with it about its origin.
        arm_tip, arm_foot = tip - at[:2, link // 3], foot - at[:2, on // 3]
        row[link + 2] = u[1] * arm_tip[0] - u[0] * arm_tip[1]
        row[on + 2] = -(u[1] * arm_foot[0] - u[0] * arm_foot[1]) + (tip - foot) @ np.array([-u[1], u[0]])
        return row[: self.width]

    def _sliding(self, drive: str, at: Array) -> tuple[tuple[Array, Array], Array]:
        """The two points of a sliding drive's line (of its link, of ``on``), and the direction."""
        entry = self.topology.mechanism.prescribed(drive)
        if entry.moves:
            point, base, turned = entry.track(self.geometry)
            ends = [
                _point_position(at[:, self.index[name]], np.array(place, dtype=float) / self.size)
                for name, place in ((entry.link, point), (entry.on, base))
            ]
            angle = at[2, self.index[entry.on]] + float(turned)
            return (ends[0], ends[1]), np.array([np.cos(angle), np.sin(angle)])
        joint = self.topology.drivable_joints(drive)[0].joint
        places = [
            _point_position(
                at[:, self.index[name]], np.array(self.geometry.line(joint, name)[0], dtype=float) / self.size
            )
            for name in (entry.link, entry.on)
        ]
        angle = at[2, self.index[entry.on]] + float(self.geometry.heading_angle(joint, entry.on))
        return (places[0], places[1]), np.array([np.cos(angle), np.sin(angle)])

    def _poses(self, z: Array) -> Array:
        """Rows x, y, angle over links, the frame's zeros last: (3, links + 1)."""
        return np.concatenate([z, np.zeros(3)]).reshape(-1, 3).T

    def pose_difference(self, a: Array, b: Array) -> Array:
        """The difference of two poses, whole turns left out."""
        between = np.array(a - b)
        between[2::3] = wrapped(between[2::3])
        return between

    def columns_of(self, links: Iterable[str]) -> list[int]:
        """The columns of some links."""
        return [3 * self.index[link] + k for link in links for k in range(3)]


class _Ends:
    """Points of pairs of links, as arrays over the pairs."""

    def __init__(self, system: Constraints, pairs: Sequence[tuple[str, str, str, Any, Any]]) -> None:
        self.names = [pair[0] for pair in pairs]
        self.index = [np.array([system.index[pair[1 + end]] for pair in pairs], dtype=int) for end in (0, 1)]
        points = [[[float(v) for v in pair[3 + end]] for pair in pairs] for end in (0, 1)]
        self.local = [np.array(of, dtype=float).reshape(-1, 2).T / system.size for of in points]

    def arm(self, at: Array, end: int) -> Array:
        """From the links' origins to their points: (2, pairs)."""
        angle, (x, y) = at[2, self.index[end]], self.local[end]
        c, s = np.cos(angle), np.sin(angle)
        return np.array([c * x - s * y, s * x + c * y])

    def place(self, at: Array, end: int) -> Array:
        """The points' places: (2, pairs)."""
        return np.asarray(at[:2, self.index[end]] + self.arm(at, end))


def _point_position(pose: Array, local: Array) -> Array:
    c, s = np.cos(pose[2]), np.sin(pose[2])
    return np.array([pose[0] + c * local[0] - s * local[1], pose[1] + s * local[0] + c * local[1]])
