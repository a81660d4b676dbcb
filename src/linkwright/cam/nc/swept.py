"""What a cutter leaves of a blank after the motions of a file, by Shapely: independent of how the path was made.

GEOS smooths what it offsets: the contour is good to some 1e-5 of the cutter's radius.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.nc.reader import Move

Array = NDArray[np.float64]

FINE = 1e-6
"""Arcs become chords within this (mm) of them."""
APART = 0.01
"""Points of the contour are no farther apart (mm): the sagitta of a roller of 10 mm over them is a micrometre's 1 %."""
LEVEL = 1e-6
"""Depths (mm) that differ by less are one."""
QUARTER = 4000
"""Pieces of a quarter of the cutter's circle where its path has a corner."""


class NothingLeft(ValueError):
    """The motions leave nothing of the cam around its centre, or don't go around it."""


class Tight(ValueError):
    """A compensated arc is smaller than the cutter, which lies on its inside; ``line`` is where."""

    def __init__(self, line: int) -> None:
        super().__init__(line)
        self.line = line


def points(move: Move, cutter: float) -> Array:
    """Where the cutter's centre goes, as points (n, 2) within ``FINE`` of it: beside the programmed motion by its
    radius where that is compensated. Raises Tight."""
    start, end = np.array(move.start[:2]), np.array(move.end[:2])
    if move.centre is None:
        along = end - start
        length = float(np.hypot(*along))
        beside = move.side * cutter * np.array([-along[1], along[0]]) / length if length and move.side else np.zeros(2)
        return np.array([start + beside, end + beside])
    radius = move.radius - move.turn * move.side * cutter
    if radius <= 0:
        raise Tight(move.line)
    step = 2 * math.acos(1 - min(FINE / radius, 0.5))
    count = max(2, math.ceil(move.sweep / step))
    first = math.atan2(start[1] - move.centre[1], start[0] - move.centre[0])
    angles = first + move.turn * move.sweep * np.arange(count + 1) / count
    return np.stack([move.centre[0] + radius * np.cos(angles), move.centre[1] + radius * np.sin(angles)], axis=1)


def chains(moves: Iterable[Move], cutter: float) -> Iterator[Array]:
    """Connected motions as lines of points (n, 2) of the cutter's centre; gaps between them become straight."""
    line: list[Array] = []
    before: Move | None = None
    for move in moves:
        if before is not None and before.end != move.start:
            yield np.concatenate(line)
            line = []
        line.append(points(move, cutter))
        before = move
    if line:
        yield np.concatenate(line)


def levels(moves: Sequence[Move], top: float = 0.0) -> list[list[Move]]:
    """The cutting motions of the deepest level alone, and all of those below the ``top`` of the blank (mm)."""
    cutting = [move for move in moves if max(move.start[2], move.end[2]) < top - LEVEL]
    deepest = min((min(move.start[2], move.end[2]) for move in cutting), default=top)
    lowest = [move for move in cutting if max(move.start[2], move.end[2]) <= deepest + LEVEL]
    return [lowest, cutting]


def left(moves: Iterable[Move], cutter: float) -> Array:
    """The contour (2, n), mm, of what motions of a cutter of radius ``cutter`` (mm) leave around the origin. Raises
    NothingLeft, Tight."""
    import shapely

    lines = [shapely.LineString(line) for line in chains(moves, cutter)]
    gone = shapely.union_all(shapely.buffer(lines, cutter, quad_segs=QUARTER))
    centre = shapely.Point(0.0, 0.0)
    for part in shapely.get_parts(gone):
        for ring in getattr(part, "interiors", ()):
            if shapely.Polygon(ring).contains(centre):
                return np.asarray(shapely.get_coordinates(shapely.segmentize(ring, APART))[:-1].T)
    raise NothingLeft
