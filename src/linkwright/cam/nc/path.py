"""The cutter's path around a plate cam: arcs or chords within a stated error of the follower's lift.

A path that is off by e along the normal makes a profile that is off by e, and a lift that is off by e over the rate by
the lift at which the contact moves along the normal: the cosine of the pressure angle for a slide. Arcs come in
pairs that are tangent to each other and to the path (biarcs: Bolton, Computer-Aided Design 7(2), 1975, 83-88).
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.disc import TURN, Disc, DiscJets
from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

LOOKS = 65
"""Places at which an element is held against the path."""
SHARE = 0.5
"""The share of the tolerance that elements may take; rounding takes of the rest."""
FLAT = 1000.0
"""Arcs with a larger radius (mm) are emitted as chords, as controls lose digits on them."""
LONGER = 1.2
LEAST = 1e-7
"""No element is shorter than this share of a turn."""


@dataclass(frozen=True)
class Element:
    """A straight motion, or an arc with its centre and turn (+1 counter-clockwise); mm. ``ratio`` is the radius of the
    cutter's path over that of the contour it cuts: by it the feed at the contour is kept."""

    start: tuple[float, float]
    end: tuple[float, float]
    centre: tuple[float, float] | None = None
    turn: int = 0
    ratio: float = 1.0

    @property
    def swept(self) -> float:
        """The angle of an arc (rad, positive)."""
        assert self.centre is not None
        (sx, sy), (ex, ey), (cx, cy) = self.start, self.end, self.centre
        return self.turn * (math.atan2(ey - cy, ex - cx) - math.atan2(sy - cy, sx - cx)) % (2 * math.pi)

    @property
    def length(self) -> float:
        """Along it (mm)."""
        if self.centre is None:
            return math.dist(self.start, self.end)
        return math.dist(self.start, self.centre) * self.swept


class Sharp(ValueError):
    """The curve can't be followed within the tolerance; ``theta`` (rad) is where."""

    def __init__(self, theta: float) -> None:
        super().__init__(theta)
        self.theta = theta


@dataclass(frozen=True)
class CutterPath:
    """The curve ``offset`` (m) outward of the pitch curve, from the cam angle ``first`` (rad) on by a turn; ``way`` +1
    with growing cam angle, -1 against it. ``allowed`` is how far the lift may be off (m or rad), or with ``along`` the
    curve itself (m). ``cuts`` (m) is what it cuts, as far outward of the pitch curve; the profile unless given."""

    disc: Disc
    offset: float
    first: float
    way: int
    allowed: float
    decimals: int = 3
    arcs: bool = True
    along: bool = False
    cuts: float | None = None

    def at(self, u: Array) -> tuple[Array, Array, Array, Array]:
        """At shares of the turn: places (2, n) in mm, unit tangents in the sense of ``way`` and outward normals (2, n),
        and how far the path may be off along them (n,) in mm."""
        look = self.look(u)
        normal = np.array([np.broadcast_to(n.d[0], u.shape) for n in look.normal])
        tangent = self.disc.sense * self.way * np.array([normal[1], -normal[0]])
        reach = 1.0 if self.along else sum(a.d[0] * b.d[0] for a, b in zip(look.along, look.arm, strict=True))
        return 1e3 * look.offset(self.offset), tangent, normal, 1e3 * SHARE * self.allowed * np.abs(reach) + 0 * u

    def look(self, u: Array) -> DiscJets:
        """The cam at shares of the turn."""
        return self.disc.look(np.mod(self.first + self.way * TURN * u, TURN))

    @property
    def knots(self) -> list[float]:
        """The shares at which the law changes, 0 and 1 among them."""
        inside = {(self.way * (start - self.first) / TURN) % 1.0 for start, _ in self.disc.pieces}
        return sorted({0.0, 1.0} | {u for u in inside if LEAST < u < 1 - LEAST})

    def elements(self, upto: float = 1.0) -> list[Element]:
        """The path as elements; of the last piece only what lies before the share ``upto``, which may exceed 1."""
        made: list[Element] = []
        for a, b in zip(self.knots, self.knots[1:], strict=False):
            if a < upto:
                made += self._fitted(a, min(b, upto))
        return made

    def _fitted(self, start: float, stop: float) -> Iterator[Element]:
        """Few elements over a piece of one law: each next one is shorter or longer than the last as it must or may."""
        step, u = stop - start, start
        while stop - u > LEAST:
            step = min(step, stop - u)
            found = self._between(u, u + step)
            while found is None:
                step /= LONGER
                if step < LEAST:
                    raise Sharp((self.first + self.way * TURN * u) % TURN)
                found = self._between(u, u + step)
            while u + step < stop:
                longer = min(LONGER * step, stop - u)
                if (tried := self._between(u, u + longer)) is None:
                    break
                found, step = tried, longer
            yield from found
            u += step

    def _between(self, a: float, b: float) -> list[Element] | None:
        """One chord, or two arcs, over shares a .. b; ``None`` where they are off by more than is allowed."""
        at, tangent, _, allowed = self.at(np.linspace(a, np.nextafter(b, a), LOOKS))
        ends = np.round(at[:, [0, -1]], self.decimals)
        if self.arcs:
            joint = _joint(at[:, 0], tangent[:, 0], at[:, -1], tangent[:, -1])
            if joint is None:
                return None
            middle = np.round(joint, self.decimals)
            parts = [
                self._arc(ends[:, 0], middle, at[:, 0], joint, tangent[:, 0]),
                self._arc(middle, ends[:, 1], joint, at[:, -1], _mirrored(tangent[:, -1], at[:, -1] - joint)),
            ]
        else:
            parts = [_line(ends[:, 0], ends[:, 1])]
        parts = [part for part in parts if part.start != part.end]
        if not parts:
            return None
        off = np.min([_off(part, at) for part in parts], axis=0)
        return parts if (off <= allowed).all() else None

    def _arc(self, start: Array, end: Array, true_start: Array, true_end: Array, heading: Array) -> Element:
        """The arc between rounded ends that turns as far as the true one, which leaves its start in a direction."""
        chord = true_end - true_start
        half = np.arctan2(heading[0] * chord[1] - heading[1] * chord[0], heading @ chord)  # of the angle swept
        along = end - start
        if abs(half) < 1e-9 or np.hypot(*along) / (2 * abs(np.sin(half))) > FLAT:
            return _line(start, end)
        centre = (start + end) / 2 + np.array([-along[1], along[0]]) / (2 * np.tan(half))
        centre = start + np.round(centre - start, self.decimals + 1)
        radius = float(np.hypot(*(start - centre)))
        turn = 1 if half > 0 else -1
        inward = -turn * self.disc.sense * self.way  # whether the cam's centre lies within the arc
        contour = -self.disc.follower.radius if self.cuts is None else self.cuts
        cut = radius + inward * 1e3 * (contour - self.offset)
        return Element(tuple(start), tuple(end), tuple(centre), turn, radius / cut if cut > 0 else 1.0)


def _line(start: Array, end: Array) -> Element:
    return Element(tuple(start), tuple(end))


def _joint(p: Array, s: Array, q: Array, t: Array) -> Array | None:
    """Where the two arcs meet that leave p along s and come to q along t."""
    way, both = q - p, s + t
    square, less = float(way @ way), float(1 - s @ t)
    if square == 0:
        return None
    across = float(way @ both)
    if less < 1e-14:
        if across <= 0:
            return None
        reach = square / (2 * across)
    else:
        reach = (np.sqrt(across**2 + 2 * less * square) - across) / (2 * less)
    return np.asarray((p + q + reach * (s - t)) / 2)


def _mirrored(tangent: Array, chord: Array) -> Array:
    """The direction at the start of an arc whose direction at the end is known."""
    unit = chord / np.hypot(*chord)
    return np.asarray(2 * (unit @ tangent) * unit - tangent)


def _off(part: Element, at: Array) -> Array:
    """How far places (2, n) lie from an element's line or circle (mm); from its ends where they lie beyond them."""
    start, end = np.array(part.start)[:, None], np.array(part.end)[:, None]
    along = end - start
    share = ((at - start) * along).sum(axis=0) / (along**2).sum()
    beyond = np.minimum(np.hypot(*(at - start)), np.hypot(*(at - end)))
    if part.centre is None:
        beside = np.abs(along[0] * (at[1] - start[1]) - along[1] * (at[0] - start[0])) / np.hypot(*along[:, 0])
    else:
        centre = np.array(part.centre)[:, None]
        beside = np.abs(np.hypot(*(at - centre)) - np.hypot(*(start - centre)))
    return np.asarray(np.where((share >= 0) & (share <= 1), beside, beyond))
