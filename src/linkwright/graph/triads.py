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
from functools import cached_property
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.data_classes import dataclass
from linkwright.graph.geometry import ZERO
from linkwright.graph.legs import EQUATIONS, CircleLeg, Fixed, Linear, Row, Triad
from linkwright.graph.motion import Motion
from linkwright.graph.placing import outer_joint
from linkwright.notation import Body, Pair, Scalar
from linkwright.structure import HigherGroup

Array = NDArray[np.float64]

DEGREE, SAMPLES = 3, 32
"""The degree of the polynomial, and the samples from which its harmonics up to 15 are known."""
ROUND_OFF = 1e-11
"""A harmonic below this share of the largest is round-off."""
LOOSE = 1e-6
"""Equations that differ by less than this at a root, which is known to the square root of round-off, are one."""
NEAR = 1e-2
"""A root this near to the unit circle may be real: round-off scatters a multiple root by a root of itself."""


@dataclass(frozen=True)
class Roots:
    """Candidates for the platform's poses, none left out; ``harmonics`` are the sizes of the polynomial's harmonics
    0, 1, 2, ... over the largest. ``complete`` is false where the platform can move by itself."""

    poses: list[tuple[float, Pair]]  # angle (rad), place of the reference point (m)
    reference: Pair
    harmonics: Array
    complete: bool


class TriadSystem:
    """The three equations of a triad at known links, numbers or symbols."""

    def __init__(self, motion: Motion, triad: Triad) -> None:
        self.triad = triad
        every = self.every = [EQUATIONS[leg.turning](motion, triad, leg) for leg in triad.legs]
        self.fixed = [e for e in every if isinstance(e, Fixed)]
        self.circles = [e for e in every if isinstance(e, CircleLeg)]
        self.linear = [e for e in every if isinstance(e, Linear)]
        # The polynomial has its least degree about one leg's pins: its circle is then centred where x = y = 0.
        first = (self.circles or every)[0]
        self.reference, self.origin = first.on, first.base

    @cached_property
    def size(self) -> float:
        """The largest length, of numbers."""
        return max([e.leg_length for e in self.every] + [e.base.minus(self.origin).length for e in self.every]) or 1.0

    def rows(self, c: Scalar, s: Scalar, size: float = 1.0) -> list[Row]:
        """Linear equations (a, b, c) of the place over a size, from the origin, at a platform's cosine and sine."""
        found = []
        for e in self.linear:
            a, b, rest = e.row(c, s, self.reference)
            found.append((a, b, (rest + a * self.origin.x + b * self.origin.y) / size))
        if self.circles:
            radius = self.circles[0].leg_length / size
            for circle in self.circles[1:]:
                # Subtracting the first circle's equation cancels |p|^2 and leaves an equation that is linear in the
                # place p.
                x, y = circle.centre(c, s, self.reference).minus(self.origin)
                x, y, other = x / size, y / size, circle.leg_length / size
                # |p - m|^2 = l^2 less |p|^2 = r^2
                found.append((-2 * x, -2 * y, x * x + y * y + radius * radius - other * other))
        return found

    def polynomial(self, c: Scalar, s: Scalar, size: float = 1.0) -> Scalar:
        """The trigonometric polynomial whose roots are the platform's angles."""
        rows = self.rows(c, s, size)
        # Three lines meet in one point if their 3 x 3 determinant vanishes (expanded by the third column).
        if not self.circles:
            return sum(row[2] * crossed(*rows[:k], *rows[k + 1 :])[2] * (-1) ** k for k, row in enumerate(rows))
        # Two lines: Cramer's rule gives p = (x, y) / d. Put into the first circle and multiplied by d^2, no division
        # is left, so the expression stays a polynomial in the cosine and sine of phi.
        x, y, d = crossed(*rows)
        reach = self.circles[0].leg_length / size * d
        return x * x + y * y - reach * reach

    def sampled(self, phi: Array) -> Array:
        """The polynomial at some angles, lengths over the largest."""
        return np.asarray(self.polynomial(np.cos(phi), np.sin(phi), self.size))

    def place(self, c: Scalar, s: Scalar) -> Pair:
        """The platform's place at a root of the polynomial where two of its equations differ: by Cramer's rule; of
        three, by all pairs of them, weighted by their determinants."""
        # Weighting by determinants avoids a pair of nearly parallel lines.
        found = [crossed(*pair) for pair in combinations(self.rows(c, s), 2)]
        weights = [d for _, _, d in found] if len(found) > 1 else [1.0]
        x, y, d = (sum(w * one[k] for w, one in zip(weights, found, strict=True)) for k in range(3))
        return Pair(self.origin.x + x / d, self.origin.y + y / d)

    def misses(self, c: Scalar, s: Scalar, place: Pair) -> list[Scalar]:
        """What the three legs miss at a pose of the platform (m2 or m), its place that of the reference point."""
        found = []
        for e in self.circles:
            gap = place.minus(e.centre(c, s, self.reference))
            found.append(gap.dot(gap) - e.leg_length * e.leg_length)
        for line in self.linear:
            a, b, rest = line.row(c, s, self.reference)
            found.append(a * place.x + b * place.y + rest)
        return found

    def rooms(self, c: Scalar, s: Scalar) -> list[Scalar]:
        """Numbers (m4 or m2) of pairs of legs: where one is negative, these two don't meet at an angle."""
        found = []
        for one, other in combinations(self.circles, 2):
            gap = one.centre(c, s, self.reference).minus(other.centre(c, s, self.reference))
            a, b = one.leg_length * one.leg_length, other.leg_length * other.leg_length
            # Two circles meet if the triangle of radii and centre distance exists (16 times its squared area).
            rest = a + b - gap.dot(gap)
            found.append(4 * a * b - rest * rest)
        for circle in self.circles:
            centre = circle.centre(c, s, self.reference)
            for line in self.linear:
                a, b, rest = line.row(c, s, self.reference)
                # A circle meets a line if the centre is no farther away than the radius.
                off = a * centre.x + b * centre.y + rest
                found.append(circle.leg_length * circle.leg_length * (a * a + b * b) - off * off)
        return found

    def _equations_at(self, phi: float) -> Array:
        """The linear equations at one of the platform's angles: (equations, 3)."""
        return np.array(self.rows(math.cos(phi), math.sin(phi), self.size), dtype=float).reshape(-1, 3)

    def places(self, phi: float) -> Iterator[Pair]:
        """All places of the platform at one of its angles, singular rows included."""
        rows = self._equations_at(phi)
        # Scale the lines, so that the singular values below compare directions.
        rows = rows / np.maximum(np.hypot(rows[:, 0], rows[:, 1]), 1e-300)[:, None] if len(rows) else rows
        radius = self.circles[0].leg_length / self.size if self.circles else math.nan
        if len(rows) >= 2:
            # Two lines or more: their common point by least squares, unless they are parallel.
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
            known, harmonics = trigonometric_roots(self.sampled)
            complete = bool(harmonics.size)
        poses = [(phi, place) for phi in known for place in self.places(phi)]
        return Roots(poses, self.reference, harmonics, complete and not any(map(self.loose, known)))

    def loose(self, phi: float) -> bool:
        """Whether the platform can be in places without number at an angle: too few of its equations differ."""
        rows = self._equations_at(phi)
        values = np.linalg.svd(rows, compute_uv=False) if len(rows) else np.zeros(0)
        return int((values > LOOSE).sum()) < (1 if self.circles else 2)


def crossed(one: Row, other: Row) -> Row:
    """Where two lines a x + b y + c = 0 meet, in homogeneous coordinates."""
    (a1, b1, c1), (a2, b2, c2) = one, other
    return b1 * c2 - b2 * c1, c1 * a2 - c2 * a1, a1 * b2 - a2 * b1


def trigonometric_roots(f: Callable[[Array], Array]) -> tuple[list[float], Array]:
    """The real roots of a trigonometric polynomial of degree three at most, with candidates around double ones;
    and its harmonics' sizes over the largest (none where it vanishes altogether)."""
    # Sample the polynomial at equal angles; the FFT gives its Fourier coefficients.
    # Sample the polynomial at equal angles; the FFT gives its Fourier coefficients.
    samples = np.asarray(f(2 * np.pi * np.arange(SAMPLES) / SAMPLES), dtype=float)
    c = np.fft.rfft(samples) / SAMPLES
    sizes = np.abs(c)
    if not sizes.max() > 1e-14:
        return [], np.zeros(0)
    sizes /= sizes.max()
    # The degree is that of the highest harmonic above round-off.
    # The degree is that of the highest harmonic above round-off.
    degree = max((k for k in range(1, DEGREE + 1) if sizes[k] > ROUND_OFF), default=0)
    if degree == 0:
        return [], sizes
    # With z = exp(i phi), multiplied by z^degree, it is an ordinary polynomial in z with twice the degree.
    # With z = exp(i phi), multiplied by z^degree, it is an ordinary polynomial in z with twice the degree.
    coefficients = np.concatenate([c[1 : degree + 1][::-1], c[:1], c[1 : degree + 1].conj()])
    found, every = [], np.roots(coefficients)
    for z in every:
        # Real angles are the roots on the unit circle. Round-off moves double roots off it, so those nearby are
        # candidates; the caller checks each by Newton.
        # Real angles are the roots on the unit circle. Round-off moves double roots off it, so those nearby are
        # candidates too; all are verified later.
        if (off := abs(abs(z) - 1.0)) < NEAR:
            phi = float(np.angle(z))
            found.append(phi)
            if off > 1e-9:  # of a multiple root, scattered by round-off about their exact mean
                found += [phi - off, phi + off, float(np.angle(every[np.abs(every - z) < 5 * off].mean()))]
    return sorted(found), sizes


def coordinates(
    motion: Motion, higher_group: HigherGroup, system: TriadSystem, pose: tuple[float, Pair]
) -> list[float]:
    """The higher group's coordinates at a pose of the platform."""
    phi, at = pose
    kept, bodies = dict(motion.bodies), motion.bodies
    place_links(motion, system, Body.still(at, system.reference, Pair(math.cos(phi), math.sin(phi))))
    found = read_coordinates(motion, higher_group)
    bodies.clear()
    bodies.update(kept)
    return found


def place_links(motion: Motion, system: TriadSystem, platform: Body) -> None:
    """Put all links of a triad where they are at a pose of its platform."""
    heads = [(system.triad.platform, platform), *((e.leg.part, e.place(platform)) for e in system.every)]
    for part, head in heads:
        for link, inside in part.poses.items():
            axis = head.direction(inside.axis.now).now
            motion.bodies[link] = Body.still(head.point(inside.point(ZERO).now).now, ZERO, axis)


def read_coordinates(motion: Motion, higher_group: HigherGroup) -> list[float]:
    """The higher group's coordinates at the poses that its links have in ``motion``."""
    bodies = motion.bodies
    return [outer_joint(motion, edge.joint, edge.link).coordinate(bodies[edge.link]) for edge in higher_group.free]
