"""The way of a cutter's centre, exact: straight lines and arcs, each once however often it is gone; what is nearest."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.nc.reader import Move

Array = NDArray[np.float64]
Index = NDArray[np.intp]
Point = tuple[float, float]

SAG = 0.005
"""What is near is sought among spots on the way, first so many as are no farther away than their piece by this (mm)."""
SPOTS = 8
"""So many of the nearest spots."""
TOGETHER = 8
"""Of so many points of a contour the first is held against the whole way, the others against the pieces nearest to it
and to the next one's."""
LOOSE = 1e-4
"""But those are that lie off by more than this share."""


class Tight(ValueError):
    """A compensated arc is smaller than the cutter, which lies on its inside; ``line`` is where."""

    def __init__(self, line: int) -> None:
        super().__init__(line)
        self.line = line


class TrackPiece(NamedTuple):
    """A straight line, or an arc about its ``centre`` from the angle ``first`` on by ``sweep`` (rad, positive
    counter-clockwise); mm."""

    start: Point
    end: Point
    centre: Point | None = None
    radius: float = 0.0
    first: float = 0.0
    sweep: float = 0.0

    def points(self, fine: float) -> Array:
        """Points (n, 2) on it, both ends among them, whose chords lie within ``fine`` (mm) of it."""
        if self.centre is None:
            return np.array([self.start, self.end])
        step = 2 * math.acos(1 - min(fine / self.radius, 0.5))
        return self._along(np.linspace(0.0, 1.0, max(2, math.ceil(abs(self.sweep) / step)) + 1))

    @property
    def length(self) -> float:
        """Along it (mm)."""
        return math.dist(self.start, self.end) if self.centre is None else self.radius * abs(self.sweep)

    def spots(self, step: float) -> Array:
        """Points (n, 2) in the middles of equal shares of it, no longer than ``step`` (mm)."""
        count = max(1, math.ceil(self.length / step))
        return self._along((np.arange(count) + 0.5) / count)

    def _along(self, share: Array) -> Array:
        if self.centre is None:
            start, end = np.array(self.start), np.array(self.end)
            return np.asarray(start + share[:, None] * (end - start))
        angles = self.first + self.sweep * share
        return np.array(self.centre) + self.radius * np.stack([np.cos(angles), np.sin(angles)], axis=1)


def pieces(moves: Iterable[Move], cutter: float) -> list[TrackPiece]:
    """Where the centre of a cutter of radius ``cutter`` (mm) goes, beside the programmed way where that is compensated,
    with straight lines where it would jump; ways gone again, at whatever depth, are left out. Raises Tight."""
    found: dict[TrackPiece, None] = {}
    before: tuple[Move, TrackPiece] | None = None
    for move in moves:
        piece = _piece(move, cutter)
        if before is not None and before[0].end == move.start and before[1].end != piece.start:
            found[TrackPiece(before[1].end, piece.start)] = None
        found[piece] = None
        before = move, piece
    still = {piece.start for piece in found if piece.centre is None and piece.start == piece.end}
    touched = {end for piece in found if piece.start != piece.end for end in piece[:2]}
    return [piece for piece in found if piece.start != piece.end or piece.centre or piece.start in still - touched]


def _piece(move: Move, cutter: float) -> TrackPiece:
    (sx, sy, _), (ex, ey, _), aside = move.start, move.end, move.side * cutter
    if move.centre is None:
        length = math.hypot(ex - sx, ey - sy)
        nx, ny = (-aside * (ey - sy) / length, aside * (ex - sx) / length) if length and aside else (0.0, 0.0)
        return TrackPiece((sx + nx, sy + ny), (ex + nx, ey + ny))
    radius = move.radius - move.turn * aside
    if radius <= 0:
        raise Tight(move.line)
    cx, cy = move.centre
    first, sweep = math.atan2(sy - cy, sx - cx), move.turn * move.sweep
    start, end = (sx, sy), (ex, ey)
    if aside:
        last = first + sweep
        start = cx + radius * math.cos(first), cy + radius * math.sin(first)
        end = cx + radius * math.cos(last), cy + radius * math.sin(last)
    return TrackPiece(start, end, move.centre, radius, first, sweep)


def chains(some: Iterable[TrackPiece], fine: float) -> Iterator[Array]:
    """Connected pieces as lines of points (n, 2)."""
    line: list[Array] = []
    end: Point | None = None
    for piece in some:
        if line and piece.start != end:
            yield np.concatenate(line)
            line = []
        line.append(piece.points(fine))
        end = piece.end
    if line:
        yield np.concatenate(line)


class PieceTrack:
    """Pieces, of which the nearest are sought."""

    def __init__(self, some: Sequence[TrackPiece], far: float) -> None:
        """``far`` (mm) is about how far from them they are sought."""
        from scipy.spatial import KDTree

        step = min(math.sqrt(8 * SAG * far), 2 * float(np.median([piece.length for piece in some])) or math.inf)
        spots = [piece.spots(step) for piece in some]
        self._owner = np.repeat(np.arange(len(spots)), [len(spot) for spot in spots])
        self._tree = KDTree(np.concatenate(spots))
        self._ends = np.array([piece[:2] for piece in some])
        self._round = np.array([piece.centre is not None for piece in some])
        self._centre = np.array([piece.centre or (0.0, 0.0) for piece in some])
        self._arc = np.array([piece[3:] for piece in some])

    def move_to_distance(self, ring: Array, far: float) -> Array:
        """Points (n, 2) of a closed line about ``far`` (mm) from the way, moved to where they are so far from it."""
        at, group = ring, np.arange(len(ring)) // TOGETHER
        owner = self._nearest(ring[::TOGETHER])
        beside = np.stack([owner[group], np.roll(owner, -1)[group]])
        wrong = np.abs(np.hypot(*(at - self._foot(at, beside)).T) - far) > LOOSE * far
        beside[:, wrong] = self._nearest(at[wrong])
        for _ in range(2):  # what is nearest may change where pieces meet
            out = at - (foot := self._foot(at, beside))
            at = foot + far * out / np.hypot(*out.T)[:, None]
        return at

    def _nearest(self, at: Array) -> Index:
        """The pieces nearest to places (n, 2)."""
        nearest = [*range(1, 1 + min(SPOTS, len(self._owner)))]
        some = self._owner[self._tree.query(at, nearest)[1].T]
        away = [np.hypot(*(at - self._on(at, which)).T) for which in some]
        return np.asarray(np.choose(np.argmin(away, axis=0), some))

    def _foot(self, at: Array, some: Index) -> Array:
        """The nearest places to places (n, 2) on the one or the other of two pieces (2, n)."""
        first, second = (self._on(at, which) for which in some)
        nearer = np.hypot(*(at - first).T) <= np.hypot(*(at - second).T)
        return np.where(nearer[:, None], first, second)

    def _on(self, at: Array, which: Index) -> Array:
        """The nearest places to places (n, 2) on pieces (n,)."""
        start, along = self._ends[which, 0], self._ends[which, 1] - self._ends[which, 0]
        square = (along**2).sum(axis=1)
        share = ((at - start) * along).sum(axis=1) / np.where(square > 0, square, 1.0)
        straight = start + np.clip(share, 0.0, 1.0)[:, None] * along
        radius, first, sweep = self._arc[which].T
        out = at - self._centre[which]
        turned = np.sign(sweep) * (np.arctan2(out[:, 1], out[:, 0]) - first) % (2 * math.pi)
        size = np.abs(sweep)
        back = turned - size > 2 * math.pi - turned  # nearer to the start than to the end
        angle = first + np.sign(sweep) * np.where(turned <= size, turned, np.where(back, 0.0, size))
        bent = self._centre[which] + radius[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        return np.asarray(np.where(self._round[which][:, None], bent, straight))
