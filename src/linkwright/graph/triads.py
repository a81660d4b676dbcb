"""Triads: a platform on three legs, the Assur group of class III. All its real assembly modes, at most six.

At a platform angle phi each leg states one equation in the platform's place p = (x, y). A leg of two pins keeps the
distance of the pins, |p + R(phi) b - a|^2 = l^2; a leg with a pin and a slide keeps a distance from a line, which is
linear in p; a leg of two slides fixes phi. Differences of the first kind are linear too. Two linear equations solved
by Cramer's rule, put into the third and multiplied by the square of their determinant, leave a trigonometric
polynomial of degree three in phi at most, so six roots (K. H. Hunt 1983; C. Innocenti 1995; C. Gosselin and
J.-P. Merlet 1994, for 3-RPR). Its coefficients come from samples at equal steps, exact but for round-off: the
harmonics above the third are found too, and vanish. All roots are eigenvalues of a companion matrix.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.graph.geometry import ZERO
from linkwright.graph.motion import Motion
from linkwright.graph.placing import driven_body, inner_joint, outer_joint
from linkwright.groups import InnerLine, OuterLine, OuterPin
from linkwright.notation import Body, Jet, Pair, Vec
from linkwright.structure import Cluster, Connection

Array = NDArray[np.float64]
Poses = dict[str, Body]

DEGREE, SAMPLES = 3, 32
"""The degree of the polynomial, and the samples from which its harmonics up to 15 are known."""
ROUND_OFF = 1e-11
"""A harmonic below this share of the largest is round-off."""
LOOSE = 1e-6
"""Equations that differ by less than this at a root, which is known to the square root of round-off, are one."""
NEAR = 1e-2
"""A root this near to the unit circle may be real: round-off scatters a multiple root by a root of itself."""


@dataclass(frozen=True)
class Part:
    """Links that drives inside the group hold to each other: one body, in the axes of its first link."""

    links: tuple[str, ...]
    poses: Poses

    def point(self, link: str, local: Pair) -> Pair:
        """A link's point in the body's axes."""
        return self.poses[link].point(local).now

    def heading(self, link: str, local: Pair) -> Pair:
        """A link's direction in the body's axes."""
        return self.poses[link].direction(local).now


@dataclass(frozen=True)
class Leg:
    """A leg: its part, the joint on a known link and the one on the platform, and the links at both."""

    part: Part
    outer: Connection
    inner: Connection
    links: tuple[str, str]  # the leg's link at the outer joint, and at the inner one
    on: str  # the platform's link at the inner joint

    @property
    def kind(self) -> str:
        """The letters of the two joints, from the known link inwards."""
        return self.outer.letter + self.inner.letter


@dataclass(frozen=True)
class Triad:
    """A cluster as a platform and three legs."""

    platform: Part
    legs: tuple[Leg, Leg, Leg]


def parts(motion: Motion, cluster: Cluster, drives: dict[str, Jet]) -> list[Part]:
    """The cluster's rigid bodies: its links, those held to each other by drives as one."""
    groups: list[list[str]] = []
    for edge in cluster.edges:
        home = next((g for g in groups if edge.base in g), None) if edge.drive is not None else None
        groups.append([edge.link]) if home is None else home.append(edge.link)
    kept = dict(motion.bodies)
    found = []
    for group in groups:
        motion.bodies[group[0]] = Body.fixed(0)
        for edge in cluster.edges:
            if edge.drive is not None and edge.link in group[1:]:
                motion.bodies[edge.link] = driven_body(motion, edge, drives[edge.drive])[1]
        found.append(Part(tuple(group), {link: motion.bodies[link] for link in group}))
    motion.bodies.clear()
    motion.bodies.update(kept)
    return found


def triad(motion: Motion, cluster: Cluster, drives: dict[str, Jet]) -> Triad | None:
    """The platform and the legs of a cluster; ``None`` where it has another shape."""
    bodies = parts(motion, cluster, drives)
    owner = {link: i for i, part in enumerate(bodies) for link in part.links}
    joints = [
        c for c in (*(e.joint for e in cluster.free), *cluster.closures) if owner.get(c.a, -1) != owner.get(c.b, -2)
    ]
    if len(bodies) != 4 or len(joints) != 6:
        return None
    ends = [(owner.get(c.a), owner.get(c.b)) for c in joints]
    for middle in range(4):
        legs = []
        for leg in set(range(4)) - {middle}:
            outer = [c for c, e in zip(joints, ends, strict=True) if leg in e and None in e]
            inner = [c for c, e in zip(joints, ends, strict=True) if leg in e and middle in e]
            if len(outer) == len(inner) == 1:
                mine = set(bodies[leg].links)
                at = tuple(c.a if c.a in mine else c.b for c in (outer[0], inner[0]))
                legs.append(Leg(bodies[leg], outer[0], inner[0], (at[0], at[1]), inner[0].other(at[1])))
        if len(legs) == 3:
            return Triad(bodies[middle], (legs[0], legs[1], legs[2]))
    return None


class _Equation:
    """What a leg demands of the platform's place at an angle: rows (x, y, 1) of linear ones, circles by themselves.

    Arrays run over sampled angles. The platform's place is that of its reference point.
    """

    def __init__(self, motion: Motion, triad: Triad, leg: Leg) -> None:
        self.leg, part, platform = leg, leg.part, triad.platform
        outer = outer_joint(motion, leg.outer, leg.links[0])
        assert isinstance(outer, OuterPin | OuterLine)
        self.outer = outer
        inner = inner_joint(motion, leg.inner, (leg.links[1], leg.on))
        self.foot = part.point(leg.links[0], self.outer.foot)
        self.tip, self.on = part.point(leg.links[1], inner.first), platform.point(leg.on, inner.second)
        self.tip_heading = self.on_heading = Pair(1.0, 0.0)
        if isinstance(inner, InnerLine):
            self.tip_heading = part.heading(leg.links[1], inner.first_heading)
            self.on_heading = platform.heading(leg.on, inner.second_heading)
        self.base = self.outer.base.now
        # The leg's angle, where a slide on a known link fixes it.
        self.turned = Pair(1.0, 0.0)
        if isinstance(self.outer, OuterLine):
            heading = part.heading(leg.links[0], self.outer.heading)
            self.turned = _unit(self.outer.direction.now.turned_back(heading))

    @property
    def reach(self) -> float:
        """The leg's length between its joints (m)."""
        arm = self.tip.minus(self.foot)
        return math.hypot(arm.x, arm.y)

    def angle(self) -> float:
        """The platform's angle, fixed by a leg of two slides."""
        axis = self.turned.turned(self.tip_heading).turned_back(self.on_heading)
        return math.atan2(axis.y, axis.x)

    def row(self, c: Array, s: Array, reference: Pair) -> Array:
        """A linear leg as (a, b, c) of a x + b y + c = 0 over the angles: (3, angles)."""
        local = self.on.minus(reference)
        bx, by = c * local.x - s * local.y, s * local.x + c * local.y
        one = np.ones_like(c)
        if self.leg.kind == "PR":
            assert isinstance(self.outer, OuterLine)
            normal = self.outer.direction.now.perp
            arm = self.tip.minus(self.foot).turned(self.turned)
            known = normal.dot(Pair(self.base.x + arm.x, self.base.y + arm.y))
            return np.array([normal.x * one, normal.y * one, normal.x * bx + normal.y * by - known])
        k = self.on_heading.perp
        nx, ny = c * k.x - s * k.y, s * k.x + c * k.y
        offset = self.tip.minus(self.foot).dot(self.tip_heading.perp)
        return np.array([nx, ny, nx * (bx - self.base.x) + ny * (by - self.base.y) - offset])

    def centre(self, c: Array, s: Array, reference: Pair) -> Array:
        """A leg of two pins: the centre of the reference point's circle over the angles (2, angles)."""
        local = self.on.minus(reference)
        return np.array([self.base.x - c * local.x + s * local.y, self.base.y - s * local.x - c * local.y])

    def place(self, platform: Body) -> Body:
        """The leg's first link at a pose of the platform."""
        at = platform.point(self.on).now
        if self.leg.kind == "RR":
            axis = _unit(at.minus(self.base).turned_back(self.tip.minus(self.foot)))
            return _body(self.base, self.foot, axis)
        if self.leg.kind == "RP":
            axis = _unit(platform.direction(self.on_heading).now.turned_back(self.tip_heading))
            return _body(self.base, self.foot, axis)
        if self.leg.kind == "PR":
            return _body(at, self.tip, self.turned)
        assert isinstance(self.outer, OuterLine)
        along, normal = self.outer.direction.now, platform.direction(self.on_heading).now.perp
        start = _body(self.base, self.foot, self.turned)
        gap = at.minus(start.point(self.tip).now).dot(normal) / along.dot(normal)
        return _body(Pair(self.base.x + gap * along.x, self.base.y + gap * along.y), self.foot, self.turned)


def _unit(v: Pair) -> Pair:
    size = math.hypot(v.x, v.y) or 1.0
    return Pair(v.x / size, v.y / size)


def _body(at: Pair, local: Pair, axis: Pair) -> Body:
    return Body(Vec.constant(at, 0), local, Vec.constant(axis, 0), Jet(()))


@dataclass(frozen=True)
class Roots:
    """Candidates for the platform's poses, none left out; ``harmonics`` are the sizes of the polynomial's harmonics
    0, 1, 2, ... over the largest. ``complete`` is false where the platform can move by itself."""

    poses: list[tuple[float, Pair]]  # angle (rad), place of the reference point (m)
    reference: Pair
    harmonics: Array
    complete: bool


class System:
    """The three equations of a triad at known links."""

    def __init__(self, motion: Motion, triad: Triad) -> None:
        self.triad = triad
        every = [_Equation(motion, triad, leg) for leg in triad.legs]
        self.every = every
        self.fixed = [e for e in every if e.leg.kind == "PP"]
        self.circles = [e for e in every if e.leg.kind == "RR"]
        self.linear = [e for e in every if e.leg.kind in ("PR", "RP")]
        # The polynomial has its least degree about one leg's pins: its circle is then centred where x = y = 0.
        self.reference = self.circles[0].on if self.circles else every[0].on
        self.origin = self.circles[0].base if self.circles else every[0].base
        self.size = max([e.reach for e in every] + [_length(e.base.minus(self.origin)) for e in every]) or 1.0

    def rows(self, phi: Array) -> Array:
        """Linear equations (a, b, c) of the place over the size, from the origin: (equations, 3, angles)."""
        c, s = np.cos(phi), np.sin(phi)
        found = []
        for e in self.linear:
            a, b, rest = e.row(c, s, self.reference)
            found.append([a, b, (rest + a * self.origin.x + b * self.origin.y) / self.size])
        if self.circles:
            radius = self.circles[0].reach / self.size
            for e in self.circles[1:]:
                x, y = e.centre(c, s, self.reference)
                x, y, other = (x - self.origin.x) / self.size, (y - self.origin.y) / self.size, e.reach / self.size
                # |p - m|^2 = l^2 less |p|^2 = r^2
                found.append([-2 * x, -2 * y, x * x + y * y + radius**2 - other**2])
        return np.array(found).reshape(-1, 3, phi.size)

    def polynomial(self, phi: Array) -> Array:
        """The trigonometric polynomial whose roots are the platform's angles, at some angles."""
        rows = self.rows(phi)
        if not self.circles:
            return np.asarray(np.linalg.det(rows.transpose(2, 0, 1)))
        (a1, b1, c1), (a2, b2, c2) = rows
        x, y, d = b1 * c2 - b2 * c1, c1 * a2 - c2 * a1, a1 * b2 - a2 * b1
        return np.asarray(x * x + y * y - (self.circles[0].reach / self.size * d) ** 2)

    def places(self, phi: float) -> Iterator[Pair]:
        """All places of the platform at one of its angles, singular rows included."""
        rows = self.rows(np.array([phi]))[:, :, 0]
        rows = rows / np.maximum(np.hypot(rows[:, 0], rows[:, 1]), 1e-300)[:, None] if len(rows) else rows
        radius = self.circles[0].reach / self.size if self.circles else math.nan
        if len(rows) >= 2:
            x, _, _, values = np.linalg.lstsq(rows[:, :2], -rows[:, 2], rcond=1e-12)
            if values[-1] > 1e-12:
                yield self._place(x)
            if values[-1] > 1e-3 or not self.circles:
                return
        if not self.circles:
            return
        # One line, or several that fall together: where the best of them meets the circle.
        for row in rows:
            foot, along = -row[2] * row[:2], np.array([-row[1], row[0]])
            rest = radius**2 - row[2] ** 2
            for sign in (1.0, -1.0):
                yield self._place(foot + sign * math.sqrt(max(rest, 0.0)) * along)

    def _place(self, p: Any) -> Pair:
        return Pair(self.origin.x + self.size * float(p[0]), self.origin.y + self.size * float(p[1]))

    def roots(self) -> Roots:
        """Candidates for all real poses."""
        if self.fixed:
            known, harmonics = [self.fixed[0].angle()], np.zeros(1)
            complete = len(self.fixed) == 1
        else:
            known, harmonics = trigonometric_roots(self.polynomial)
            complete = bool(harmonics.size)
        poses = [(phi, place) for phi in known for place in self.places(phi)]
        return Roots(poses, self.reference, harmonics, complete and not any(map(self.loose, known)))

    def loose(self, phi: float) -> bool:
        """Whether the platform can be in places without number at an angle: too few of its equations differ."""
        rows = self.rows(np.array([phi]))[:, :, 0]
        values = np.linalg.svd(rows, compute_uv=False) if len(rows) else np.zeros(0)
        return int((values > LOOSE).sum()) < (1 if self.circles else 2)


def trigonometric_roots(f: Callable[[Array], Array]) -> tuple[list[float], Array]:
    """The real roots of a trigonometric polynomial of degree three at most, with candidates around double ones;
    and its harmonics' sizes over the largest (none where it vanishes altogether)."""
    samples = np.asarray(f(2 * np.pi * np.arange(SAMPLES) / SAMPLES), dtype=float)
    c = np.fft.rfft(samples) / SAMPLES
    sizes = np.abs(c)
    if not sizes.max() > 1e-14:
        return [], np.zeros(0)
    sizes /= sizes.max()
    degree = max((k for k in range(1, DEGREE + 1) if sizes[k] > ROUND_OFF), default=0)
    if degree == 0:
        return [], sizes
    coefficients = np.concatenate([c[1 : degree + 1][::-1], c[:1], c[1 : degree + 1].conj()])
    found, every = [], np.roots(coefficients)
    for z in every:
        if (off := abs(abs(z) - 1.0)) < NEAR:
            phi = float(np.angle(z))
            found.append(phi)
            if off > 1e-9:  # of a multiple root, scattered by round-off about their exact mean
                found += [phi - off, phi + off, float(np.angle(every[np.abs(every - z) < 5 * off].mean()))]
    return sorted(found), sizes


def _length(v: Pair) -> float:
    return math.hypot(v.x, v.y)


def coordinates(motion: Motion, cluster: Cluster, system: System, pose: tuple[float, Pair]) -> list[float]:
    """The cluster's coordinates at a pose of the platform."""
    phi, at = pose
    platform = _body(at, system.reference, Pair(math.cos(phi), math.sin(phi)))
    kept, bodies = dict(motion.bodies), motion.bodies
    heads = [(system.triad.platform, platform), *((e.leg.part, e.place(platform)) for e in system.every)]
    for part, head in heads:
        for link, inside in part.poses.items():
            axis = head.direction(inside.axis.now).now
            bodies[link] = _body(head.point(inside.point(ZERO).now).now, ZERO, axis)
    found = read_coordinates(motion, cluster)
    bodies.clear()
    bodies.update(kept)
    return found


def read_coordinates(motion: Motion, cluster: Cluster) -> list[float]:
    """The cluster's coordinates at the poses that its links have in ``motion``."""
    found = []
    for edge in cluster.free:
        body, joint = motion.bodies[edge.link], outer_joint(motion, edge.joint, edge.link)
        if isinstance(joint, OuterPin):
            found.append(math.atan2(float(body.axis.y.d[0]), float(body.axis.x.d[0])))
        else:
            assert isinstance(joint, OuterLine)
            away = body.point(joint.foot).now.minus(joint.base.now)
            found.append(float(away.dot(joint.direction.now)))
    return found
