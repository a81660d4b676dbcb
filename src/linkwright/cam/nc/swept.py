"""What a cutter leaves of a blank after the motions of a file, by Shapely: independent of how the path was made."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

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


def points(move: Move) -> Array:
    """A motion as points (n, 2) within ``FINE`` of it, its start left out."""
    if move.centre is None:
        return np.array([move.end[:2]])
    step = 2 * math.acos(1 - min(FINE / move.radius, 0.5))
    count = max(2, math.ceil(move.sweep / step))
    first = math.atan2(move.start[1] - move.centre[1], move.start[0] - move.centre[0])
    angles = first + move.turn * move.sweep * np.arange(1, count + 1) / count
    made = np.stack(
        [move.centre[0] + move.radius * np.cos(angles), move.centre[1] + move.radius * np.sin(angles)], axis=1
    )
    made[-1] = move.end[:2]
    return made


def chains(moves: Iterable[Move]) -> Iterator[tuple[int, Array]]:
    """Connected motions as lines of points (n, 2) with the side on which the cutter runs."""
    line: list[Array] = []
    before: Move | None = None
    for move in moves:
        joined = before is not None and before.end == move.start and before.side == move.side
        if not joined:
            if line and before is not None:
                yield before.side, np.concatenate(line)
            line = [np.array([move.start[:2]])]
        line.append(points(move))
        before = move
    if line and before is not None:
        yield before.side, np.concatenate(line)


def levels(moves: Sequence[Move], top: float = 0.0) -> list[list[Move]]:
    """The cutting motions of the deepest level alone, and all of those below the ``top`` of the blank (mm)."""
    cutting = [move for move in moves if max(move.start[2], move.end[2]) < top - LEVEL]
    deepest = min((min(move.start[2], move.end[2]) for move in cutting), default=top)
    lowest = [move for move in cutting if max(move.start[2], move.end[2]) <= deepest + LEVEL]
    return [lowest, cutting]


def left(moves: Iterable[Move], cutter: float) -> Array:
    """The contour (2, n), mm, of what motions of a cutter of radius ``cutter`` (mm) leave around the origin. Raises
    NothingLeft."""
    import shapely

    swept = []
    for side, line in chains(moves):
        drawn: Any = shapely.LineString(line)
        if side:
            drawn = shapely.offset_curve(drawn, side * cutter, quad_segs=QUARTER)
        swept.append(shapely.buffer(drawn, cutter, quad_segs=QUARTER))
    gone = shapely.union_all(swept)
    centre = shapely.Point(0.0, 0.0)
    for part in shapely.get_parts(gone):
        for ring in getattr(part, "interiors", ()):
            if shapely.Polygon(ring).contains(centre):
                return np.asarray(shapely.get_coordinates(shapely.segmentize(ring, APART))[:-1].T)
    raise NothingLeft
