"""What a cutter leaves of a blank after the motions of a file, by Shapely: independent of how the path was made.

GEOS smooths what it offsets by some 1e-5 of the cutter's radius: it says which contours there are. Each of their points
is then moved to where it is as far as the cutter's radius from the nearest place of the cutter's way, which is exact.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from linkwright.cam.nc.reader import Move
from linkwright.cam.nc.track import PieceTrack, TrackPiece, chains, pieces
from linkwright.data_classes import dataclass

Array = NDArray[np.float64]

ROUGH = 1e-4
"""Arcs are within this (mm) of the chords that GEOS offsets."""
APART = 0.01
"""Points of the contour are no farther apart (mm): the sagitta of a roller of 10 mm over them is a micrometre's 1 %."""
LEVEL = 1e-6
"""Depths (mm) that differ by less are one."""
QUARTER = 1000
"""Pieces of a quarter of the cutter's circle where its path has a corner."""
SPECK = 1e-6
"""What has a smaller area (mm2) is a matter of rounding."""


class NothingLeft(ValueError):
    """The motions leave nothing of the cam around its centre, or don't go around it."""


def levels(moves: Sequence[Move], top: float = 0.0) -> list[list[Move]]:
    """The motions at the deepest level alone, and all of those that get below the ``top`` of the blank (mm)."""
    cutting = [move for move in moves if min(move.start[2], move.end[2]) < top - LEVEL]
    deepest = min((min(move.start[2], move.end[2]) for move in cutting), default=top)
    lowest = [move for move in cutting if max(move.start[2], move.end[2]) <= deepest + LEVEL]
    return [lowest, cutting]


@dataclass(frozen=True)
class Swept:
    """What a cutter of radius ``cutter`` (mm) has gone over on its ``way``."""

    way: tuple[TrackPiece, ...]
    cutter: float

    @cached_property
    def _parts(self) -> tuple[list[tuple[Any, Any]], list[Any]]:
        """The regions that go around the origin, each with the hole in which it is, from the inside out; the others."""
        import shapely

        lines = [shapely.LineString(line) for line in chains(self.way, ROUGH)]
        gone = shapely.union_all(shapely.buffer(lines, self.cutter, quad_segs=QUARTER))
        around, others = [], []
        for part in shapely.get_parts(gone):
            holes = [ring for ring in part.interiors if shapely.Polygon(ring).contains(shapely.Point(0.0, 0.0))]
            around += [(part, hole) for hole in holes]
            others += [] if holes else [part]
        if not around:
            raise NothingLeft
        return sorted(around, key=lambda one: one[1].length), others

    @cached_property
    def _track(self) -> PieceTrack:
        return PieceTrack(self.way, self.cutter)

    @cached_property
    def inner(self) -> Array:
        """The contour (2, n), mm, of what is left around the origin. Raises NothingLeft."""
        return self._exact(self._parts[0][0][1])

    @cached_property
    def outer(self) -> Array:
        """The contour (2, n), mm, of what is left around all that is swept. Raises NothingLeft."""
        return self._exact(self._parts[0][-1][0].exterior)

    @property
    def strays(self) -> Iterator[Array]:
        """Contours (2, n), mm, of what has been cut elsewhere."""
        for part in self._parts[1]:
            yield self._exact(part.exterior)

    @property
    def islands(self) -> Iterator[Array]:
        """Places (2,), mm, at which something is left standing between both contours."""
        import shapely

        around = self._parts[0]
        for island in (shapely.Polygon(ring) for part, _ in around for ring in part.interiors):
            if island.area > SPECK and not island.contains(shapely.Point(0.0, 0.0)):
                yield np.array(island.representative_point().coords[0])
        for (within, _), (_, hole) in pairwise(around):
            yield shapely.get_coordinates(shapely.shortest_line(within, hole)).mean(axis=0)

    def _exact(self, ring: Any) -> Array:
        import shapely

        ring = shapely.get_coordinates(shapely.segmentize(ring, APART))[:-1]
        return self._track.move_to_distance(ring, self.cutter).T


def swept(moves: Sequence[Move], cutter: float) -> list[Swept]:
    """What motions of a cutter of radius ``cutter`` (mm) go over at the deepest level, and at all of them: one and the
    same where both go the same way. Raises :class:`linkwright.cam.nc.track.Tight`."""
    lowest, every = (Swept(tuple(pieces(some, cutter)), cutter) for some in levels(moves))
    return [lowest, lowest if set(lowest.way) == set(every.way) else every]
